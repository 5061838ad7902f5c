"""Prints srs/ into code, data and tests: `python -m tools.generate [--check]`.

Without arguments it writes what has changed and removes what no chapter asks for any more.
With --check it writes nothing and exits with 1 where a file differs from a fresh generation,
is missing, or is an orphan. A faulty chapter exits with 2.
"""

import argparse
import difflib
import importlib.util
import re
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

from tamias2d.cli import INTERRUPTED
from tamias2d.errors import SpecError
from tamias2d.spec.reader import read
from tamias2d.spec.specification import Specification
from tools import (
    case_scenes,
    emit_constraints,
    emit_data,
    emit_functions,
    emit_joint_rows,
    emit_schemes,
    emit_tests,
)

ROOT = Path(__file__).resolve().parent.parent
CODE = "src/tamias2d/generated"
TESTS = "tests/generated"
PACKAGE = '"""Where equations become code: printed from srs/ by `python -m tools.generate`."""\n'


def checked(folder: Path) -> Specification:
    """The specification, whose cases name scenes and bodies that exist. Raises: SpecError."""
    specification = read(folder)
    if faults := case_scenes.faults(specification.of_kind("case")):
        raise SpecError("\n".join(str(fault) for fault in sorted(faults)))
    return specification


def outputs(specification: Specification) -> dict[str, str]:
    """All generated files: path from the root, and text."""
    by_module = emit_functions.functions_by_module(specification)
    files = {
        f"{CODE}/{module}.py": emit_functions.emit(module, made, specification)
        for module, made in by_module.items()
    }
    files[f"{CODE}/__init__.py"] = PACKAGE
    files[f"{CODE}/schemes.py"] = emit_schemes.emit(specification)
    files[f"{CODE}/constraints.py"] = emit_constraints.emit(specification)
    files[f"{CODE}/joint_rows.py"] = emit_joint_rows.emit(specification)
    files[f"{CODE}/symbols.py"] = emit_data.emit_symbols(specification)
    files |= {f"{TESTS}/{name}": text for name, text in emit_tests.emit(specification).items()}
    files = formatted(files)
    owners = {
        f"{CODE}/{module}.py": [(f.item.id, f.name) for f in made]
        for module, made in by_module.items()
    }
    owners[f"{CODE}/schemes.py"] = [(item.id, item.id) for item in specification.of_kind("scheme")]
    owners[f"{CODE}/constraints.py"] = emit_constraints.owners(specification)
    owners[f"{CODE}/joint_rows.py"] = emit_joint_rows.owners(specification)
    files[f"{CODE}/srs.json"] = emit_data.emit_json(specification, _places(owners, files))
    return files


def formatted(files: dict[str, str]) -> dict[str, str]:
    """The texts as the project's formatter lays them out, imports sorted."""
    with tempfile.TemporaryDirectory() as folder:
        for path, text in files.items():
            _write(Path(folder) / path, text)
        for command in (["check", "--select=I", "--fix"], ["format"]):
            call = [sys.executable, "-m", "ruff", *command, "--no-cache", "--quiet"]
            subprocess.run([*call, "--config", str(ROOT / "pyproject.toml"), folder], check=True)
        return {path: (Path(folder) / path).read_text(encoding="utf-8") for path in files}


def _places(owners: dict[str, list[tuple[str, str]]], files: dict[str, str]) -> emit_data.Code:
    """Where the functions of each item stand, after formatting."""
    found: dict[str, list[dict[str, Any]]] = {}
    for path, made in owners.items():
        starts = {
            m.group(1): n
            for n, line in enumerate(files[path].splitlines(), 1)
            if (m := re.match(r"def (\w+)\(", line))
        }
        module = f"tamias2d.generated.{Path(path).stem}"
        for id, name in made:
            place = {"module": module, "function": name, "file": path, "line": starts[name]}
            found.setdefault(id, []).append(place)
    return found


def differences(files: dict[str, str]) -> dict[str, str]:
    """What differs on disk, by path: 'missing', 'orphan' or the first changed lines."""
    found: dict[str, str] = {}
    for path, text in files.items():
        target = ROOT / path
        if not target.exists():
            found[path] = "missing"
        elif (old := target.read_text(encoding="utf-8")) != text:
            lines = difflib.unified_diff(
                old.splitlines(), text.splitlines(), "on disk", "fresh", n=0, lineterm=""
            )
            found[path] = "\n    ".join(["differs", *list(lines)[2:8]])
    for folder in (CODE, TESTS):
        for file in sorted((ROOT / folder).rglob("*")):
            name = file.relative_to(ROOT).as_posix()
            if file.is_file() and "__pycache__" not in name and name not in files:
                found[name] = "orphan"
    return found


def main(arguments: list[str] | None = None) -> int:
    """Run the generator; returns the exit code."""
    parser = argparse.ArgumentParser(prog="python -m tools.generate", description=__doc__)
    parser.add_argument("--check", action="store_true", help="write nothing, report differences")
    options = parser.parse_args(arguments)
    if importlib.util.find_spec("ruff") is None:
        print(
            "tools.generate: ruff is not installed, which lays the code out. Install it "
            "by `pip install -e '.[dev]'`, or call `tools/dev python -m tools.generate`.",
            file=sys.stderr,
        )
        return 2
    try:
        return _generate(check=options.check)
    except SpecError as error:
        print(error, file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("Interrupted.", file=sys.stderr)
        return INTERRUPTED


def _generate(*, check: bool) -> int:
    files = outputs(checked(ROOT / "srs"))
    found = differences(files)
    for path, what in found.items():
        if check:
            print(f"{path}: {what}. Run: python -m tools.generate", file=sys.stderr)
        else:
            _settle(path, files.get(path))
            print(f"{'removed' if path not in files else 'wrote'} {path}")
    return 1 if check and found else 0


def _settle(path: str, text: str | None) -> None:
    if text is None:
        (ROOT / path).unlink()
    else:
        _write(ROOT / path, text)


def _write(target: Path, text: str) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main())
