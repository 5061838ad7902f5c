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
from tamias2d.scene.catalogue import crowds, mechanisms, stacks, terrain
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
    "hill": terrain.hill,
}
_LOCATED: dict[str, Callable[[str], Scene]] = {
    "bridge": mechanisms.bridge,
    "ball-and-chain": mechanisms.ball_and_chain,
    "walker": mechanisms.walker,
}
"""Those that are made, and in which nothing meets."""
_JOINTED: dict[str, Callable[[str], Scene]] = {
    "car": mechanisms.car,
    "ragdolls": mechanisms.ragdolls,
    "joint-grid": mechanisms.joint_grid,
}
"""Those whose joints and contacts, or joints alone, are too many to be solved exactly."""


def names(contacts: Literal["located", "stepped", "jointed"] | None = None) -> list[str]:
    """Return the names of all scenes, or of those with such contacts, in alphabetical order.

    Stepped are those that have too many contacts, or too lasting ones, to be located; jointed those
    of them that have joints.
    """
    entries = [entry.name for entry in files(__name__).iterdir()]
    located = [name.removesuffix(_SUFFIX) for name in entries if name.endswith(_SUFFIX)]
    located += _LOCATED
    found = {
        None: [*located, *_MADE, *_JOINTED],
        "located": located,
        "stepped": list(_MADE),
        "jointed": list(_JOINTED),
    }
    return sorted(found[contacts])


@suggests
def load(name: str) -> Scene:
    """Return a scene of the catalogue.

    Raises:
        SceneError: the catalogue has no such scene.
    """
    _refuse_unknown(name)
    make = (_MADE | _LOCATED | _JOINTED).get(name)
    if make is None:
        return read_scene(text(name), file=f"{name}{_SUFFIX}", name=name)
    return make(name)


def text(name: str) -> str:
    """Return a scene of the catalogue as YAML.

    Raises:
        SceneError: the catalogue has no such scene.
    """
    _refuse_unknown(name)
    if name in _MADE | _LOCATED | _JOINTED:
        return scene_text(load(name))
    return (files(__name__) / f"{name}{_SUFFIX}").read_text(encoding="utf-8")


def _refuse_unknown(name: str) -> None:
    known = names()
    if name not in known:
        near = nearest(str(name), known)
        hint = f"Did you mean '{near}'?" if near else f"Take one of {', '.join(known)}."
        raise SceneError(f"scene {shown(name)}: not in the catalogue (R2). {hint}")
