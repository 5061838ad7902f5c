"""The scenes without joints of Box2D's own benchmark, in its parameters.

Serves: the measurement of crowds. Each is made with about a number of bodies; `FULL` has Box2D's.
Its tumbler is turned by a motor, and here at that rate; its pusher of junk swings, and here keeps
the speed with which it begins. Source: Catto, Box2D v3, shared/benchmarks.c (2026).
"""

import math
from collections.abc import Callable
from typing import Any

from tamias2d.scene import Box, Compound, Part, Polygon, Scene, Segment

_GRAVITY = (0.0, -10.0)
_SURFACE: dict[str, Any] = {"friction": 0.6, "restitution": 0.0}
_TURNS = math.radians(25.0)  # rad/s


def _boxes(scene: Scene, size: float, places: list[tuple[float, float]]) -> Scene:
    box = Box(width=size, height=size)
    for place in places:
        scene.add_body(box, mass=size * size, position=place, **_SURFACE)
    return scene


def _pyramid(rows: int, middle: float, floor: float) -> list[tuple[float, float]]:
    """Return places of unit boxes."""
    return [
        (middle + k - 0.5 * (rows - 1 - i), floor + i + 0.5)
        for i in range(rows)
        for k in range(rows - i)
    ]


def _rows_of(bodies: int) -> int:
    return max(1, round(math.sqrt(2 * bodies + 0.25) - 0.5))


def large_pyramid(bodies: int) -> Scene:
    """Return a pyramid of unit boxes on a wide box."""
    scene = Scene(gravity=_GRAVITY)
    scene.add_static(Box(width=200.0, height=2.0), position=(0.0, -1.0), **_SURFACE)
    return _boxes(scene, 1.0, _pyramid(_rows_of(bodies), 0.0, 0.0))


def many_pyramids(bodies: int) -> Scene:
    """Return pyramids of 55 unit boxes, side by side on lines one above the other."""
    scene, side, rows = Scene(gravity=_GRAVITY), max(1, round(math.sqrt(bodies / 55))), 10
    line = Segment(length=(rows + 1.0) * side)
    for i in range(side):
        floor = i * (rows + 1.0)
        scene.add_static(line, position=(0.0, floor), **_SURFACE)
        for k in range(side):
            _boxes(scene, 1.0, _pyramid(rows, (k - 0.5 * (side - 1)) * (rows + 1.0), floor))
    return scene


def smash(bodies: int) -> Scene:
    """Return a wall of light boxes that a heavy one of 20 times their size hits at 40 m/s."""
    scene, rows = Scene(gravity=(0.0, 0.0)), max(1, round(math.sqrt(bodies / 1.5)))
    scene.add_body(
        Box(width=8.0, height=8.0),
        mass=512.0,
        position=(-20.0, 0.0),
        velocity=(40.0, 0.0),
        **_SURFACE,
    )
    columns = max(1, round(1.5 * rows))
    places = [(30.0 + 0.4 * i, 0.4 * (k - rows / 2)) for i in range(columns) for k in range(rows)]
    return _boxes(scene, 0.4, places)


def tumbler(bodies: int) -> Scene:
    """Return boxes of 0.25 m in a square drum."""
    scene = Scene(gravity=_GRAVITY)
    sides = [
        Part(shape=Box(width=w, height=h), position=(x, y))
        for w, h, x, y in (
            (1.0, 20.0, 10.0, 0.0), (1.0, 20.0, -10.0, 0.0),
            (20.0, 1.0, 0.0, 10.0), (20.0, 1.0, 0.0, -10.0),
        )
    ]  # fmt: skip
    scene.add_kinematic(
        Compound(parts=sides), position=(0.0, 10.0), angular_velocity=_TURNS, **_SURFACE
    )
    return _boxes(scene, 0.25, _grid(bodies, 0.4, 10.0))


def washer(bodies: int) -> Scene:
    """Return boxes of 0.2 m in a round drum with four ribs."""
    scene = Scene(gravity=_GRAVITY)
    sides = [_panel(k, 16.0, 18.0, math.pi / 180) for k in range(36)]
    sides += [_panel(k, 14.0, 16.0, 0.0) for k in range(0, 36, 9)]
    drum = Compound(parts=sides)
    scene.add_kinematic(
        drum,
        position=(drum.centroid[0], 10.0 + drum.centroid[1]),
        velocity=(0.001, -0.002),
        angular_velocity=_TURNS,
        **_SURFACE,
    )
    return _boxes(scene, 0.2, _grid(bodies, 0.21, 10.0))


def _panel(k: int, inner: float, outer: float, more: float) -> Part:
    low, high = k * math.pi / 18 - more, (k + 1) * math.pi / 18 + more
    corners = [
        (r * math.cos(angle), r * math.sin(angle))
        for r, angle in ((inner, low), (outer, low), (outer, high), (inner, high))
    ]
    return _part(corners)


def _part(corners: list[tuple[float, float]]) -> Part:
    shape = Polygon(vertices=corners)
    return Part(shape=shape, position=shape.centroid)


def _grid(bodies: int, spacing: float, middle: float) -> list[tuple[float, float]]:
    side = max(1, round(math.sqrt(bodies)))
    start = -0.5 * spacing * side
    return [
        (start + spacing * k, middle + start + spacing * i)
        for i in range(side)
        for k in range(side)
    ]


def junkyard(bodies: int) -> Scene:
    """Return pentagons that fall into a yard of single boxes, in which a block sweeps them up."""
    scene, radius = Scene(gravity=_GRAVITY), 0.25
    _yard(scene, 80, 50)
    turn = math.pi * (math.sqrt(5.0) - 1.0)
    corners = sorted(turn * k % math.tau for k in range(5))
    junk = Polygon(vertices=[(radius * math.cos(a), radius * math.sin(a)) for a in corners])
    rows = max(1, round(math.sqrt(bodies / 5)))
    side = 0.1
    for i in range(5 * rows):
        for k in range(rows):
            side = -side
            place = (1.5 * (2.0 * i - 5 * rows) * radius + side, 4.0 * k * radius + 15.0)
            scene.add_body(junk, mass=junk.area, position=place, **_SURFACE)
    scene.add_kinematic(
        Box(width=4.0, height=8.0), position=(0.0, 4.5), velocity=(12.0, 0.0), **_SURFACE
    )
    return scene


def _yard(scene: Scene, half: int, high: int) -> None:
    """Add a floor and two walls of single boxes that overlap a little."""
    floor, wall = Box(width=1.1, height=1.0), Box(width=1.0, height=1.1)
    for k in range(-half, half + 1):
        scene.add_static(floor, position=(float(k), 0.0), **_SURFACE)
    for x in (-float(half), float(half)):
        for k in range(1, high + 1):
            scene.add_static(wall, position=(x, float(k)), **_SURFACE)


def compounds(bodies: int) -> Scene:
    """Return bodies of two triangles that fall into a barrel of single boxes."""
    scene = Scene(gravity=_GRAVITY)
    _yard(scene, 40, 100)
    scene.add_static(Segment(length=1600.0), position=(0.0, -80.0), **_SURFACE)
    left = _part([(-1.0, 0.0), (0.5, 1.0), (0.0, 2.0)])
    right = _part([(1.0, 0.0), (0.0, 2.0), (-0.5, 1.0)])
    kite = Compound(parts=(left, right))
    columns = max(1, round(math.sqrt(bodies / 7.5)))
    side = 0.25
    for i in range(columns):
        for k in range(max(1, round(7.5 * columns))):
            place = (2.0 * i - columns + 1.0 + side, 2.25 * k + 5.575 + kite.centroid[1])
            side = -side
            scene.add_body(kite, mass=1.25, position=place, friction=0.5, restitution=0.0)
    return scene


FULL: dict[str, tuple[Callable[[int], Scene], int]] = {
    "large pyramid": (large_pyramid, 5050),
    "many pyramids": (many_pyramids, 22000),
    "smash": (smash, 9600),
    "tumbler of boxes": (tumbler, 2025),
    "washer": (washer, 8100),
    "junkyard": (junkyard, 8000),
    "compounds": (compounds, 3000),
}
"""Makers of the scenes by name, and how many bodies Box2D takes."""
