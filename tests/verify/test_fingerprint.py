"""A fingerprint changes with what a verdict rests on, and with nothing else."""

from copy import deepcopy
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from tamias2d.verify.items import fingerprint, items

MODULE = import_module("tamias2d.verify.items")


@pytest.fixture
def known(monkeypatch: pytest.MonkeyPatch) -> dict[str, Any]:
    """A copy of the specification that a test may change."""
    copy = deepcopy({id: dict(item) for id, item in items().items()})
    monkeypatch.setattr(MODULE, "items", lambda: copy)
    return copy


@pytest.mark.parametrize(
    ("id", "key", "value"),
    [
        ("IM2", "hash", "changed"),  # a model that the case uses, or what that rests on
        ("R6", "data", {"says": "something else"}),  # a requirement that it verifies
        ("TC8", "data", {"verifies": ["R6"], "scene": "tc8"}),  # the case
        ("TC8", "data", {"verifies": ["R6"], "scene": "tc9"}),
    ],
)
def test_it_changes(known: dict[str, Any], id: str, key: str, value: Any) -> None:
    before = fingerprint(known["TC8"])
    known[id][key] = value
    assert fingerprint(known["TC8"]) != before


def test_it_changes_with_the_scene(known: dict[str, Any], monkeypatch: pytest.MonkeyPatch) -> None:
    before = fingerprint(known["TC8"])
    monkeypatch.setattr(MODULE, "_scene", lambda _case: "another")
    assert fingerprint(known["TC8"]) != before


def test_it_changes_with_the_code(known: dict[str, Any], monkeypatch: pytest.MonkeyPatch) -> None:
    before = fingerprint(known["TC8"])
    monkeypatch.setattr(MODULE, "_code", lambda: "another")
    assert fingerprint(known["TC8"]) != before


def test_a_changed_module_is_other_code(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    module = tmp_path / "generated" / "translation.py"
    module.parent.mkdir()
    module.write_text("a = 1")
    monkeypatch.setattr(MODULE, "_PACKAGE", tmp_path)
    before = MODULE._code.__wrapped__()
    module.write_text("a = 2")
    assert MODULE._code.__wrapped__() != before


@pytest.mark.parametrize(
    ("id", "key", "value"),
    [("IM1", "hash", "changed"), ("R6", "line", 1), ("TC9", "data", {}), ("TC8", "line", 1)],
)
def test_it_stays(known: dict[str, Any], id: str, key: str, value: Any) -> None:
    before = fingerprint(known["TC8"])
    known[id][key] = value
    assert fingerprint(known["TC8"]) == before
