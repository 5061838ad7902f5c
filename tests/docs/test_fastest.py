"""The tables of the fastest settings have a row for each scene that their fence names."""

import re
from pathlib import Path
from types import SimpleNamespace

import pytest

fronts = pytest.importorskip("weave.fronts", reason="needs Sphinx")
directives = pytest.importorskip("myst_parser.parsers.directives")

DOCS = Path(__file__).parents[2] / "docs"
PAGE = (DOCS / "choosing.md").read_text(encoding="utf-8")
FENCES = re.findall(r"^```\{fastest\} (.+)$", PAGE, re.M)


@pytest.mark.parametrize("scenes", FENCES)
def test_a_table_has_a_row_for_each_scene(scenes: str, monkeypatch: pytest.MonkeyPatch) -> None:
    written: list[str] = []
    monkeypatch.setattr(fronts.FastestDirective, "parse", lambda _s, text, _i: written.append(text))
    found = directives.parse_directive_text(fronts.FastestDirective, scenes, "")
    directive = object.__new__(fronts.FastestDirective)
    directive.arguments = found.arguments
    settings = SimpleNamespace(env=SimpleNamespace(srcdir=DOCS))
    directive.state = SimpleNamespace(document=SimpleNamespace(settings=settings))
    directive.run()
    (text,) = written
    assert re.findall(r"^\* - `([\w-]+)`", text, re.M) == scenes.split()


def test_the_page_has_both_tables() -> None:
    assert len(FENCES) == 2
