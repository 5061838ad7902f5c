"""The items of the specification, as the generator wrote them down.

Service: items by id. Secret: the file they are in.
"""

import hashlib
import json
import re
from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from typing import Any

Item = Mapping[str, Any]
_LABEL = re.compile(r"([A-Z]+)(\d+)([a-z]?)")


@cache
def items() -> dict[str, Item]:
    """Return all items of srs/ by id, in reading order."""
    text = (files("tamias2d.generated") / "srs.json").read_text(encoding="utf-8")
    return {item["id"]: item for item in json.loads(text)["items"]}


def links(item: Item) -> tuple[str, ...]:
    """Return the ids that an item names, each once."""
    return tuple(dict.fromkeys(id for ids in item["links"].values() for id in ids if id != "none"))


def label_order(case: str) -> tuple[bool, str, int, str]:
    """Return what sorts labels of cases: the plan's first, then the oracles; numbers by size."""
    letters, number, part = _LABEL.fullmatch(case).groups()  # type: ignore[union-attr]
    return letters != "TC", letters, int(number), part


def scene_hash(item: Item) -> str:
    """Return eight hex digits of the catalogue's scene that a case names; nothing without one."""
    scene = item["data"].get("scene")
    file = files("tamias2d.scene.catalogue") / f"{scene}.yaml"
    if not isinstance(scene, str) or not file.is_file():
        return ""
    return hashlib.sha256(file.read_bytes()).hexdigest()[:8]
