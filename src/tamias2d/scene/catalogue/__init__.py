"""The catalogue: scenes that tests, measurements, docs and the command line share.

Serves: tests, docs, the command line. Hides: where the files are.

One YAML file a scene; a file is found by its name. Scenes of many bodies that stay in contact are
made by functions: a file of five thousand boxes is not for reading.
"""

from collections.abc import Callable
from functools import partial
from importlib.resources import files
from typing import Literal

from tamias2d.errors import SceneError
from tamias2d.scene.catalogue import crowds, stacks
from tamias2d.scene.reading import read_scene
from tamias2d.scene.rules import shown
from tamias2d.scene.scene import Scene
from tamias2d.scene.writing import scene_text
from tamias2d.suggestions import nearest, suggests

_SUFFIX = ".yaml"
_MADE: dict[str, Callable[[str], Scene]] = {
    "pyramid-30": partial(stacks.pyramid, rows=30),
    "pyramid-100": partial(stacks.pyramid, rows=100),
    "stack-10-heavy": stacks.heavy_column,
    "dominoes": stacks.dominoes,
    "card-house": stacks.card_house,
    "arch": stacks.arch,
    "bullet-wall": stacks.bullet_wall,
    "incline": stacks.incline,
    "disc-pile": crowds.disc_pile,
    "tumbler": crowds.tumbler,
    "free-discs": crowds.free_discs,
}


def names(contacts: Literal["located", "stepped"] | None = None) -> list[str]:
    """Return the names of all scenes, or of those with such contacts, in alphabetical order.

    Stepped are those that have too many contacts, or too lasting ones, to be located.
    """
    entries = [entry.name for entry in files(__name__).iterdir()]
    located = [name.removesuffix(_SUFFIX) for name in entries if name.endswith(_SUFFIX)]
    found = {None: [*located, *_MADE], "located": located, "stepped": list(_MADE)}
    return sorted(found[contacts])


@suggests
def load(name: str) -> Scene:
    """Return a scene of the catalogue.

    Raises:
        SceneError: the catalogue has no such scene.
    """
    _refuse_unknown(name)
    if name not in _MADE:
        return read_scene(text(name), file=f"{name}{_SUFFIX}", name=name)
    return _MADE[name](name)


def text(name: str) -> str:
    """Return a scene of the catalogue as YAML.

    Raises:
        SceneError: the catalogue has no such scene.
    """
    _refuse_unknown(name)
    if name in _MADE:
        return scene_text(load(name))
    return (files(__name__) / f"{name}{_SUFFIX}").read_text(encoding="utf-8")


def _refuse_unknown(name: str) -> None:
    known = names()
    if name not in known:
        near = nearest(str(name), known)
        hint = f"Did you mean '{near}'?" if near else f"Take one of {', '.join(known)}."
        raise SceneError(f"scene {shown(name)}: not in the catalogue (R2). {hint}")
