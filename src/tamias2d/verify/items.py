"""The items of the specification, as the generator wrote them down."""

import difflib
import hashlib
import json
import re
from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any

from tamias2d.scene import catalogue

Item = Mapping[str, Any]
_PACKAGE = Path(__file__).parents[1]
_LABEL = re.compile(r"([A-Z]+)(\d+)([a-z]?)")


@cache
def items() -> dict[str, Item]:
    """Return all items of srs/ by id, in reading order."""
    text = (files("tamias2d.generated") / "srs.json").read_text(encoding="utf-8")
    return {item["id"]: item for item in json.loads(text)["items"]}


def meant(id: str) -> str | None:
    """Return the id that was probably meant by one that does not exist; None if none is near."""
    known = {each.casefold(): each for each in items()}
    close = difflib.get_close_matches(id.casefold(), known, n=1)
    return known[close[0]] if close else None


def links(item: Item) -> tuple[str, ...]:
    """Return the ids that an item names, each once."""
    return tuple(dict.fromkeys(id for ids in item["links"].values() for id in ids if id != "none"))


def label_order(case: str) -> tuple[bool, str, int, str]:
    """Return what sorts labels of cases: the plan's first, then the oracles; numbers by size."""
    letters, number, part = _LABEL.fullmatch(case).groups()  # type: ignore[union-attr]
    return letters != "TC", letters, int(number), part


def fingerprint(case: Item) -> str:
    """Return twelve hex digits that change with whatever a verdict on a case rests on.

    That is what the case says, its scene, the requirements as they are worded, all that the items
    rest on which it uses, and the code of the package: a case that passed may fail after any
    change of it.
    """
    known, named = items(), case["links"]
    wording = [known[id]["data"] for id in named.get("verifies", ())]
    used = [known[id]["hash"] for id in named.get("uses", ())]
    text = json.dumps([case["data"], _scene(case), wording, used, _code()], sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()[:12]


@cache
def _code() -> str:
    """Return the SHA-256 of all modules of the package, printed or written by hand."""
    total = hashlib.sha256()
    for path in sorted(_PACKAGE.rglob("*.py")):
        total.update(f"{path.relative_to(_PACKAGE).as_posix()}\n".encode() + path.read_bytes())
    return total.hexdigest()


def _scene(case: Item) -> str:
    """Return the text of the catalogue's scene that a case names; nothing without one."""
    scene = case["data"].get("scene")
    return catalogue.text(scene) if scene in catalogue.names() else ""
