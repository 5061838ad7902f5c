"""The items of the specification, as the generator wrote them down.

Service: items by id. Secret: the file they are in, and that a scene is part of its case.
"""

import hashlib
import json
from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from typing import Any

Item = Mapping[str, Any]


@cache
def items() -> dict[str, Item]:
    """Return all items of srs/ by id, in reading order."""
    text = (files("tamias2d.generated") / "srs.json").read_text(encoding="utf-8")
    return {item["id"]: item for item in json.loads(text)["items"]}


def links(item: Item) -> tuple[str, ...]:
    """Return the ids that an item names, each once."""
    return tuple(dict.fromkeys(id for ids in item["links"].values() for id in ids if id != "none"))


def fingerprint(item: Item) -> str:
    """Return what changes when an item, what it uses, or its scene in the catalogue changes."""
    scene = item["data"].get("scene")
    if not isinstance(scene, str):
        return str(item["hash"])
    file = files("tamias2d.scene.catalogue") / f"{scene}.yaml"
    content = file.read_bytes() if file.is_file() else b""
    return f"{item['hash']}-{hashlib.sha256(content).hexdigest()[:8]}"
