"""The scenes of cases: each is in the catalogue or can be read, and has the bodies that are asked.

Serves: the generator. Hides: where in a case scenes and bodies are named. The reader of srs/
stands below scenes and cannot know them.
"""

from collections.abc import Iterable, Iterator
from typing import Any

from tamias2d.errors import TamiasError
from tamias2d.scene import Scene, catalogue
from tamias2d.spec.chapter import Item
from tamias2d.spec.messages import Code, Diagnostic
from tamias2d.verify.case import scene_of

Path = tuple[str | int, ...]


def faults(cases: Iterable[Item]) -> list[Diagnostic]:
    """What is wrong with the scenes and bodies that checked cases name."""
    return [fault for case in cases for fault in _faults(case)]


def _faults(case: Item) -> Iterator[Diagnostic]:
    for path, name in _named(case):
        if name not in catalogue.names():
            text = f"'{name}' is no scene of the catalogue (R2). Correct the name"
            yield case.diagnostic(Code.UNKNOWN_NAME, text, *path)
            return
    for path, content in _read(case):
        try:
            scene = scene_of(content)
        except TamiasError as error:
            yield case.diagnostic(Code.BAD_VALUE, f"the scene cannot be read: {error}", *path)
        else:
            yield from _unknown_bodies(case, scene) if path == ("scene",) else ()


def _read(case: Item) -> Iterator[tuple[Path, Any]]:
    """The scenes that have to be good ones, and where they stand."""
    if "scene" in case.data:
        yield ("scene",), case.data["scene"]
    for label, run in case.data.get("notes", {}).get("scenes", {}).items():
        yield ("notes", "scenes", label, "scene"), run["scene"]


def _named(case: Item) -> Iterator[tuple[Path, str]]:
    """Where a case names scenes of the catalogue."""
    if isinstance(case.data.get("scene"), str):
        yield ("scene",), case.data["scene"]
    for name in case.data.get("reference", {}).get("scenes", ()):
        yield ("reference", "scenes", name, "key"), name
    for key in ("refuses", "notes"):
        for label, run in case.data.get(key, {}).get("scenes", {}).items():
            if isinstance(run["scene"], str):
                yield (key, "scenes", label, "scene"), run["scene"]


def _unknown_bodies(case: Item, scene: Scene) -> Iterator[Diagnostic]:
    known = [body.name for body in scene.bodies]
    for path, name in _bodies(case):
        if name not in known:
            some = ", ".join(known[:10])
            text = f"'{name}' is no body of the scene, which has {some}. Correct the name"
            yield case.diagnostic(Code.UNKNOWN_NAME, text, *path)


def _bodies(case: Item) -> Iterator[tuple[Path, str]]:
    """Where a case names bodies of its scene."""
    data = case.data
    paths: list[Path] = [(key, "bodies") for key in ("exact", "final", "stepped", "worlds")]
    paths += [("published", "tables"), ("schemes", "of")]
    paths += [("schemes", "constants", each) for each in _part(data, ("schemes", "constants"))]
    states = _part(data, ("moments", "states"))
    paths += [("moments", "states", number, "bodies") for number in range(len(states))]
    for path in paths:
        yield from (((*path, name, "key"), name) for name in _part(data, path))
    for number, misprint in enumerate(_part(data, ("published", "misprints"))):
        yield ("published", "misprints", number, "body"), misprint["body"]


def _part(data: Any, path: Path) -> Any:
    """What stands under a path; nothing where a key is missing."""
    for key in path:
        data = data[key] if isinstance(key, int) else data.get(key, {})
    return data
