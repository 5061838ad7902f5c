"""The scenes that engines are measured on, and for how long.

Serves: the measurement of contacts. Hides: which are the catalogue's, and which are made here.
"""

import math
import random
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from tamias2d.scene import Box, Compound, Disc, HalfPlane, Part, Polygon, Scene

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


def pyramid(rows: int) -> Scene:
    """Return a pyramid of unit boxes, 0.05 m apart in a row."""
    scene = _floor(f"pyramid-{rows}")
    for row in range(rows):
        for k in range(rows - row):
            x = 1.05 * (k - (rows - row - 1) / 2)
            _add(scene, Box(width=1.0, height=1.0), 1.0, x, row + 0.5)
    return scene


def disc_pile(discs: int) -> Scene:
    """Return discs that fall into a container of 10 m."""
    scene, chance = _floor("disc-pile"), random.Random(1)
    for side in (-1.0, 1.0):
        wall = HalfPlane(normal=(-side, 0.0), offset=-5.0)
        scene.add_static(wall, friction=_FRICTION, restitution=0.0)
    for k in range(discs):
        radius = chance.uniform(0.2, 0.25)
        x, y = -4.6 + 0.51 * (k % 19), 0.3 + 0.51 * (k // 19)
        x += chance.uniform(-0.02, 0.02)
        _add(scene, Disc(radius=radius), math.pi * radius**2, x, y)
    return scene


def tumbler(polygons: int) -> Scene:
    """Return polygons of 3 to 8 sides in a square drum that turns."""
    scene, chance = Scene(gravity=_GRAVITY, name="tumbler"), random.Random(1)
    long, wide = Box(width=22.0, height=1.0), Box(width=1.0, height=22.0)
    walls = [Part(shape=long, position=(0.0, y)) for y in (-10.5, 10.5)]
    walls += [Part(shape=wide, position=(x, 0.0)) for x in (-10.5, 10.5)]
    scene.add_kinematic(
        Compound(parts=walls), position=(0.0, 0.0), angular_velocity=0.5,
        friction=_FRICTION, restitution=0.0,
    )  # fmt: skip
    for k in range(polygons):
        sides, start = chance.randint(3, 8), chance.uniform(0.0, 6.3)
        angles = [start + math.tau * j / sides for j in range(sides)]
        outline = [(0.3 * math.cos(angle), 0.3 * math.sin(angle)) for angle in angles]
        _add(scene, Polygon(vertices=outline), 1.0, 0.6 * (k % 32) - 9.3, 0.6 * (k // 32) - 9.3)
    return scene


def free_discs(discs: int) -> Scene:
    """Return discs in flight that never meet."""
    scene = Scene(gravity=_GRAVITY, name="free-discs")
    for k in range(discs):
        _add(scene, Disc(radius=0.25), 1.0, float(k % 32), float(k // 32))
    return scene


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
    """Return discs of radius 0.25 m that fall on a floor, slightly out of line (X16)."""
    scene, chance = _floor("falling-discs"), random.Random(16)
    for k in range(rows * columns):
        x, y = k % columns * 0.55, k // columns * 0.55 + 0.3
        _add(scene, Disc(radius=0.25), 1.0, x + chance.uniform(-0.02, 0.02), y)
    return scene


def _floor(name: str) -> Scene:
    scene = Scene(gravity=_GRAVITY, name=name)
    floor = HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, friction=_FRICTION, restitution=0.0)
    return scene


def _add(scene: Scene, shape: Box | Disc | Polygon, mass: float, x: float, y: float) -> None:
    scene.add_body(shape, mass=mass, position=(x, y), friction=_FRICTION, restitution=0.0)


SCENES = {
    "pyramid-30": Entry(partial(pyramid, 30), 300, 300, stands=True),
    "pyramid-100": Entry(partial(pyramid, 100), 200, 600, stands=True),
    "disc-pile": Entry(partial(disc_pile, 1000), 600, 1200),
    "tumbler": Entry(partial(tumbler, 1000), 600, 600),
    "free-discs": Entry(partial(free_discs, 1000), 300, 300),
    "stack-100": Entry(partial(column, 100), 300, 600, stands=True),
    "stack-10-heavy": Entry(partial(heavy_column, 10, 100.0), 600, 600, stands=True),
    "two-discs": Entry(two_discs, 6000, 600, stands=True),
}
