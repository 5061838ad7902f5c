"""Scenes that tests of the engine share, and simulators whose engine is plain Python."""

import math
import random
from typing import Any

import numpy as np

import tamias2d as t2
from tamias2d.simulator import Simulator
from tamias2d.state import Array


def plain(scene: t2.Scene, **settings: Any) -> Simulator:
    """A simulator whose engine runs as plain Python."""
    return Simulator(scene, compiled=False, **settings)


def ground(scene: t2.Scene, friction: float) -> None:
    scene.add_static(
        t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), friction=friction, restitution=0.0
    )


def tower(
    masses: Any,
    *,
    aside: float = 0.0,
    above: float = 0.0,
    friction: float = 0.5,
    reverse: bool = False,
    size: float = 1.0,
) -> t2.Scene:
    """Boxes on each other, the lowest one first: moved aside by turns, with gaps between, m."""
    scene = t2.Scene(gravity=(0.0, -9.81 * size))
    levels = range(len(masses))
    for k in reversed(levels) if reverse else levels:
        scene.add_body(
            t2.Box(width=size, height=size),
            mass=float(masses[k]),
            position=(aside * math.sin(7 * k) * size, (0.5 + (1 + above) * k) * size),
            friction=friction,
            restitution=0.0,
        )
    ground(scene, friction)
    return scene


def heap(*, upright: bool, bounces: bool = False) -> t2.Scene:
    """Discs in rows that press on each other, and apart from them towers of boxes.

    One disc may bounce: it is far from the first slab.
    """
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), friction=0.5)
    at_rest: Any = {"friction": 0.5, "restitution": 0.0}
    columns, rows = (3, 14) if upright else (24, 3)
    for k in range(columns * rows):
        place = (0.97 * (k % columns), 0.49 + 0.97 * (k // columns))
        scene.add_body(t2.Disc(radius=0.5), mass=1.0 + k % 3, position=place, **at_rest)
    for k in range(9):
        place = (-3.0 - 2.0 * (k % 3), 0.5 + 0.999 * (k // 3))
        scene.add_body(t2.Box(width=1.0, height=1.0), mass=2.0, position=place, **at_rest)
    if bounces:
        scene.add_body(
            t2.Disc(radius=0.5), mass=1.0, position=(0.97 * columns + 0.5, 0.5),
            velocity=(0.0, -3.0), friction=0.5, restitution=0.8,
        )  # fmt: skip
    return scene


def poured(count: int, *, seed: int) -> tuple[t2.Scene, Array]:
    """Discs poured onto each other, and their radii: some leave their bounds long before others."""
    chance = np.random.default_rng(seed)
    radii = chance.uniform(0.1, 0.5, count)
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), restitution=0.3, friction=0.4)
    for k, radius in enumerate(radii):
        scene.add_body(
            t2.Disc(radius=radius),
            mass=radius,
            position=(1.1 * (k % 12), 0.6 + 1.1 * (k // 12)),
            velocity=chance.normal(0.0, 3.0, 2),
            restitution=0.3,
            friction=0.4,
        )
    return scene, radii


def mixed(seed: int, bodies: int) -> t2.Scene:
    """Shapes of every kind on a slope and in the air, some overlapping at the start."""
    chance = random.Random(seed)
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_static(t2.HalfPlane(normal=(0.1, 1.0), offset=0.0), friction=0.6)
    scene.add_static(t2.Segment(length=3.0), position=(-1.5, 1.0), orientation=-0.7)
    scene.add_kinematic(
        t2.Box(width=2.0, height=0.2), position=(2.0, 0.6), velocity=(-0.5, 0.0),
        angular_velocity=0.3,
    )  # fmt: skip
    shapes = (
        t2.Disc(radius=0.3),
        t2.Box(width=0.6, height=0.4),
        t2.Capsule(length=0.5, radius=0.15),
        t2.Polygon(vertices=[(0.0, 0.0), (0.6, 0.1), (0.3, 0.5)]),
    )
    for k in range(bodies):
        scene.add_body(
            shapes[k % len(shapes)],
            mass=chance.choice((0.5, 1.0, 3.0)),
            position=(chance.uniform(-1.5, 1.5), 0.5 + 0.35 * k),
            orientation=chance.uniform(-math.pi, math.pi),
            velocity=(chance.uniform(-3, 3), chance.uniform(-3, 0)),
            angular_velocity=chance.uniform(-5, 5),
            friction=chance.choice((0.0, 0.4, 0.9)),
            restitution=chance.choice((0.0, 0.5, 1.0)),
        )
    return scene
