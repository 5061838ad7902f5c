"""Every block of the tutorial is executed, and prints what the page says; so is the README's.

The blocks of a page share one Python session and one directory. `...` stands for any text.
"""

import doctest
import os
import re
import shlex
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

import tamias2d as t2

ROOT = Path(__file__).parents[2]
_BLOCK = re.compile(
    r"^```(?:\{code-block\} )?(?P<kind>\w+)\n(?::caption: (?P<file>\S+)\n)?(?P<text>.*?)^```$",
    re.M | re.S,
)
_FLAGS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE


@dataclass(frozen=True)
class Block:
    """A block of code and its place."""

    text: str
    file: str
    page: str
    line: int


PAGES = (
    "docs/tutorial.md",
    "docs/scenes.md",
    "docs/own_force.md",
    "docs/joints.md",
    "docs/frame_loop.md",
    "docs/ensembles.md",
    "docs/choosing.md",
    "docs/certificates.md",
    "docs/index.md",
    "README.md",
)


@pytest.mark.parametrize("page", PAGES)
def test_every_block_does_what_it_says(
    page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("TAMIAS2D_HOME", str(tmp_path / "home"))
    session: dict[str, Any] = {}
    content = (ROOT / page).read_text(encoding="utf-8")
    found = list(_BLOCK.finditer(content))
    assert found
    for match in found:
        line = content.count("\n", 0, match.start("text"))
        block = Block(match["text"], match["file"], page, line)
        if match["kind"] in _RUN:
            _RUN[match["kind"]](block, session)


def _python(block: Block, session: dict[str, Any]) -> None:
    exec(compile(block.text, block.page, "exec"), session)


def _session(block: Block, session: dict[str, Any]) -> None:
    parser = doctest.DocTestParser()
    test = parser.get_doctest(block.text, session, block.page, block.page, block.line)
    report: list[str] = []
    doctest.DocTestRunner(optionflags=_FLAGS).run(test, out=report.append, clear_globs=False)
    session.update(test.globs)
    assert not report, "".join(report)


def _file(block: Block, _session: dict[str, Any]) -> None:
    """Write a scene file, which can be read unless its name says that it is wrong."""
    Path(block.file).write_text(block.text, encoding="utf-8")
    if "wrong" in block.file:
        with pytest.raises(t2.SceneError):
            t2.load(block.file)
    else:
        t2.load(block.file)


def _console(block: Block, _session: dict[str, Any]) -> None:
    for command, wanted in re.findall(r"^\$ (.*)\n((?:(?!\$ ).*\n)*)", block.text, re.M):
        program, *arguments = shlex.split(command)
        assert program == "tamias2d"
        run = subprocess.run(
            [sys.executable, "-m", "tamias2d", *arguments],
            env={**os.environ, "COLUMNS": "100"},
            capture_output=True, text=True, check=False,
        )  # fmt: skip
        printed = run.stdout + run.stderr
        fits = doctest.OutputChecker().check_output(wanted, printed, _FLAGS)
        assert fits, f"{block.page}:{block.line}: {command}\n{printed}"


_RUN = {"python": _python, "pycon": _session, "yaml": _file, "console": _console}
