"""Crowds: rains, needles, a gas, an implosion, a box that a paddle stirs, and a shaken one.

Serves: the measurement of crowds. Each is made with a number of bodies.
"""

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from tamias2d.scene import Box, Capsule, Compound, Disc, Part, Scene, Shape

_GRAVITY = (0.0, -9.81)
_ROUGH: Any = {"friction": 0.5, "restitution": 0.2}


def _rain(bodies: int, size: float, speed: float, shapes: Callable[[float], list[Shape]]) -> Scene:
    """Return bodies in a lattice that reach a floor at a speed, m/s."""
    chance = np.random.default_rng(7)
    scene = Scene(gravity=_GRAVITY)
    surface: Any = {"friction": 0.5, "restitution": 0.0}
    scene.add_static(
        Box(width=1000 * size, height=50 * size), position=(0.0, -25 * size), **surface
    )
    columns = max(1, round((bodies / 1.6) ** 0.5))
    for k in range(bodies):
        own = size * chance.uniform(0.5, 1.0)
        every = shapes(own)
        scene.add_body(
            every[k % len(every)],
            mass=1000 * own**2,
            position=(2.5 * size * (k % columns), 2 * size + 2.5 * size * (k // columns)),
            orientation=chance.uniform(0.0, 3.0),
            velocity=(0.0, -speed),
            **surface,
        )
    return scene


def _round_and_square(size: float) -> list[Shape]:
    return [Disc(radius=size), Box(width=1.6 * size, height=1.2 * size)]


def _needles(size: float) -> list[Shape]:
    return [Capsule(length=1.8 * size, radius=0.05 * size)]


def _gas(bodies: int) -> Scene:
    """Return elastic discs of 2 cm that fly into each other at half a radius to five a step."""
    return _flying(bodies, 0.01, 3.0, 1.0, inwards=False)


def _implosion(bodies: int) -> Scene:
    """Return discs of 2 cm that fly to their middle, most at ten radii a step, and stay there."""
    return _flying(bodies, 0.01, 6.0, 0.0, inwards=True)


def _flying(bodies: int, radius: float, speed: float, restitution: float, inwards: bool) -> Scene:
    chance = np.random.default_rng(11)
    scene = Scene(gravity=(0.0, 0.0))
    side = math.ceil(bodies**0.5)
    for k in range(bodies):
        place = np.array([k % side, k // side]) - (side - 1) / 2
        way = -2 * place / side if inwards else chance.normal(size=2)
        scene.add_body(
            Disc(radius=radius),
            mass=10 ** chance.uniform(-2, 0),
            position=tuple(3 * radius * place),
            velocity=tuple(speed * way),
            friction=0.0,
            restitution=restitution,
        )
    return scene


def _closed(half: float) -> Compound:
    """Return the walls around a square, of which half a side is given, m."""
    sides = [
        Part(shape=Box(width=w, height=h), position=(x, y))
        for w, h, x, y in (
            (2 * half + 0.2, 0.1, 0.0, half + 0.05), (2 * half + 0.2, 0.1, 0.0, -half - 0.05),
            (0.1, 2 * half, half + 0.05, 0.0), (0.1, 2 * half, -half - 0.05, 0.0),
        )
    ]  # fmt: skip
    return Compound(parts=sides)


def _paddle(bodies: int) -> Scene:
    """Return discs and boxes in a closed box, stirred by a bar whose ends go at 7 m/s."""
    scene, half = Scene(gravity=_GRAVITY), _half(bodies)
    scene.add_static(_closed(half), **_ROUGH)
    scene.add_kinematic(
        Box(width=1.6 * half, height=0.02 * half),
        position=(0.0, 0.0),
        angular_velocity=7.0 / (0.8 * half),
        **_ROUGH,
    )
    return _filled(scene, bodies, half, free=0.01 * half)


def _shaken(bodies: int) -> Scene:
    """Return discs and boxes in a closed box, which `DRIVES` shakes."""
    scene, half = Scene(gravity=_GRAVITY), _half(bodies)
    scene.add_kinematic(_closed(half), position=(0.0, 0.0), velocity=_shaking(0.0), **_ROUGH)
    return _filled(scene, bodies, half, free=-1.0)


def _shaking(time: float) -> tuple[float, float]:
    """Return the velocity of a box that is shaken by 5 cm, 4 times a second aslant, m/s."""
    speed = 0.05 * 8.0 * math.pi * math.cos(8.0 * math.pi * time)
    return 0.6 * speed, 0.8 * speed


def _half(bodies: int) -> float:
    return float(0.05 * max(4, math.ceil((2 * bodies) ** 0.5)))


def _filled(scene: Scene, bodies: int, half: float, *, free: float) -> Scene:
    """Put bodies into a box, but not where they would reach into its free middle, m."""
    chance, columns = np.random.default_rng(5), round(half / 0.05)
    for k in range(bodies):
        own = chance.uniform(0.015, 0.03)
        place = (0.1 * (k % columns + 0.5) - half, 0.1 * (k // columns + 0.5) - half)
        shape = _round_and_square(own)[k % 2]
        if abs(place[1]) > free + 2 * own or free < 0.0:
            scene.add_body(shape, mass=1000 * own**2, position=place, **_ROUGH)
    return scene


SCENES: dict[str, Callable[[int], Scene]] = {
    "rain of 2 cm": lambda bodies: _rain(bodies, 0.01, 6.0, _round_and_square),
    "hail of 1 m": lambda bodies: _rain(bodies, 0.5, 40.0, _round_and_square),
    "needles 1:20": lambda bodies: _rain(bodies, 0.1, 6.0, _needles),
    "gas": _gas,
    "implosion": _implosion,
    "paddle": _paddle,
    "shaken box": _shaken,
}
"""Makers of the crowds by name."""

DRIVES: dict[str, Callable[[float], tuple[float, float]]] = {"shaken box": _shaking}
"""Velocities of the first body of some crowds, m/s, by time, s."""
