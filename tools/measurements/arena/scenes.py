"""The scenes that engines are measured on, and for how long.

Serves: the measurement of contacts. Hides: which are the catalogue's, and which are made here.
"""

import random
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from tamias2d.scene import Box, Disc, HalfPlane, Scene, catalogue

_GRAVITY = (0.0, -9.81)
_FRICTION = 0.6


@dataclass(frozen=True)
class Entry:
    """A scene, and how much of it is run."""

    make: Callable[[], Scene]
    timed: int
    """Steps of which the time is taken."""
    steps: int
    """Steps to the end at which it is judged."""
    stands: bool = False
    """Whether its highest body belongs where it is at the start."""
    call: int = 1
    """Steps that are asked for at once, as where nobody looks at each frame."""


def _listed(name: str, *, timed: int, steps: int, stands: bool = False) -> Entry:
    return Entry(partial(catalogue.load, name), timed, steps, stands)


def column(boxes: int) -> Scene:
    """Return a stack of unit boxes on a floor."""
    return heavy_column(boxes, 1.0)


def heavy_column(boxes: int, ratio: float) -> Scene:
    """Return a stack of unit boxes, of which the highest has `ratio` times the mass of others."""
    scene = _floor(f"stack-{boxes}")
    for k in range(boxes):
        mass = ratio if k == boxes - 1 else 1.0
        _add(scene, Box(width=1.0, height=1.0), mass, 0.0, k + 0.5)
    return scene


def two_discs() -> Scene:
    """Return two discs that lie apart on a floor."""
    scene = _floor("two-discs")
    for x in (0.0, 3.0):
        _add(scene, Disc(radius=0.5), 1.0, x, 0.5)
    return scene


def falling_discs(rows: int, columns: int) -> Scene:
    """Return discs of radius 0.25 m that fall on a floor, slightly out of line (X16).

    Between walls, for without them the fewer columns there are the more of all discs roll away.
    """
    scene, chance = _floor("falling-discs"), random.Random(16)
    for normal, offset in ((1.0, -0.3), (-1.0, -0.55 * (columns - 1) - 0.3)):
        wall = HalfPlane(normal=(normal, 0.0), offset=offset)
        scene.add_static(wall, friction=_FRICTION, restitution=0.0)
    for k in range(rows * columns):
        x, y = k % columns * 0.55, k // columns * 0.55 + 0.3
        _add(scene, Disc(radius=0.25), 1.0, x + chance.uniform(-0.02, 0.02), y)
    return scene


def _floor(name: str) -> Scene:
    scene = Scene(gravity=_GRAVITY, name=name)
    floor = HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, friction=_FRICTION, restitution=0.0)
    return scene


def _add(scene: Scene, shape: Box | Disc, mass: float, x: float, y: float) -> None:
    scene.add_body(shape, mass=mass, position=(x, y), friction=_FRICTION, restitution=0.0)


SCENES = {
    "pyramid-30": _listed("pyramid-30", timed=300, steps=300, stands=True),
    "pyramid-100": _listed("pyramid-100", timed=200, steps=600, stands=True),
    "disc-pile": _listed("disc-pile", timed=600, steps=1200),
    "tumbler": _listed("tumbler", timed=600, steps=600),
    "free-discs": _listed("free-discs", timed=300, steps=300),
    "free-discs-ahead": Entry(partial(catalogue.load, "free-discs"), 600, 300, call=60),
    "stack-100": Entry(partial(column, 100), timed=300, steps=600, stands=True),
    "stack-10-heavy": _listed("stack-10-heavy", timed=600, steps=600, stands=True),
    "arch": _listed("arch", timed=600, steps=600, stands=True),
    "card-house": _listed("card-house", timed=600, steps=600, stands=True),
    "dominoes": _listed("dominoes", timed=600, steps=600),
    "two-discs": Entry(two_discs, timed=6000, steps=600, stands=True),
}
