"""Scenes and bodies that a case names: what does not exist is one message at its place."""

from pathlib import Path

import pytest

from tamias2d.errors import SpecError
from tamias2d.spec.chapter import Item, read_chapter
from tamias2d.spec.specification import Specification
from tamias2d.spec.symbols import SymbolTable
from tools import generate
from tools.case_scenes import faults

CASE = """# A case
```{case} TC1 Free fall
verifies: [R5]
uses: [IM1]
scene: SCENE
duration: 1 s
final:
  bodies:
    BODY: {velocity: "vector(0[m/s], -9.81[m/s^2]*time)"}
  tolerance: 1e-12
  because: rounding
  source: by hand
refuses:
  scenes:
    label: {scene: OTHER, says: word}
  tolerance: 0
  because: it is refused or not
  source: the rules
```
"""
GOOD = {"SCENE": "bouncing-disc", "BODY": "disc", "OTHER": "{bodies: {}}"}


def cases(folder: Path, **changes: str) -> list[Item]:
    text = CASE
    for word, put in (GOOD | changes).items():
        text = text.replace(word, put)
    (folder / "case.md").write_text(text)
    return read_chapter(folder / "case.md", "case.md").items


def test_what_exists_is_accepted(tmp_path: Path) -> None:
    assert faults(cases(tmp_path)) == []


@pytest.mark.parametrize(
    ("word", "put", "place"),
    [
        ("SCENE", "bouncing-disk", "5:8: unknown-name"),
        ("SCENE", "{bodies: {ball: {shape: disc}}}", "5:8: bad-value"),
        ("SCENE", "{gravity: [0 m/s^2, 0 m/s^2], bodies: {}}", "9:5: unknown-name"),
        ("BODY", "disk", "9:5: unknown-name"),
        ("OTHER", "bouncing-disk", "15:20: unknown-name"),
    ],
)
def test_what_does_not_is_told(word: str, put: str, place: str, tmp_path: Path) -> None:
    (fault,) = faults(cases(tmp_path, **{word: put}))
    assert str(fault).startswith(f"case.md:{place}: TC1: ")


def test_the_generator_tells_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    bad = {item.id: item for item in cases(tmp_path, SCENE="nowhere")}
    monkeypatch.setattr(generate, "read", lambda _: Specification(bad, SymbolTable([])))
    with pytest.raises(SpecError, match="'nowhere' is no scene of the catalogue"):
        generate.checked(tmp_path)
