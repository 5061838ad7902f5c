"""Every block of the pages that teach is executed, and prints what the page says.

Blocks share one Python session and one directory. `...` stands for any text.
"""

import doctest
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

DOCS = Path(__file__).parents[2] / "docs"
PAGES = ("tutorial.md", "own_force.md")
_BLOCK = re.compile(
    r"^```(?:\{code-block\} )?(?P<kind>\w+)\n(?::caption: (?P<file>\S+)\n)?(?P<text>.*?)^```$",
    re.M | re.S,
)
_FLAGS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE


@pytest.mark.parametrize("page", PAGES)
def test_every_block_does_what_it_says(
    page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("TAMIAS2D_HOME", str(tmp_path / "home"))
    session: dict[str, Any] = {}
    content = (DOCS / page).read_text(encoding="utf-8")
    blocks = list(_BLOCK.finditer(content))
    assert {block["kind"] for block in blocks} == set(_RUN)
    for block in blocks:
        place = f"{page}:{content.count(chr(10), 0, block.start('text')) + 1}"
        _RUN[block["kind"]](block["text"], block["file"], place, session)


def _python(text: str, _file: str, place: str, session: dict[str, Any]) -> None:
    exec(compile(text, place, "exec"), session)


def _session(text: str, _file: str, place: str, session: dict[str, Any]) -> None:
    test = doctest.DocTestParser().get_doctest(text, session, place, place, 0)
    report: list[str] = []
    doctest.DocTestRunner(optionflags=_FLAGS).run(test, out=report.append, clear_globs=False)
    session.update(test.globs)
    assert not report, "".join(report)


def _file(text: str, file: str, _place: str, _session: dict[str, Any]) -> None:
    Path(file).write_text(text, encoding="utf-8")


def _console(text: str, _file: str, place: str, _session: dict[str, Any]) -> None:
    for command, wanted in re.findall(r"^\$ (.*)\n((?:(?!\$ ).*\n)*)", text, re.M):
        program, *arguments = shlex.split(command)
        assert program == "tamias2d"
        run = subprocess.run(
            [sys.executable, "-m", "tamias2d", *arguments],
            env={**os.environ, "COLUMNS": "100"},
            capture_output=True, text=True, check=False,
        )  # fmt: skip
        printed = run.stdout + run.stderr
        fits = doctest.OutputChecker().check_output(wanted, printed, _FLAGS)
        assert fits, f"{place}: {command}\n{printed}"


_RUN = {"python": _python, "pycon": _session, "yaml": _file, "console": _console}
