"""Scenes of bodies between walls."""

import math
from typing import TypeAlias

import numpy as np

import tamias2d as t2


def crowd(seed: int) -> t2.Scene:
    """Discs that fly, fall, spin and rub between walls and fixed discs."""
    chance = np.random.default_rng(seed)
    gravity = [(0.0, 0.0), (0.0, -9.81), tuple(chance.normal(0, 5, 2))][chance.integers(3)]
    scene = t2.Scene(gravity=gravity)
    friction = float(chance.choice([0.0, 0.3]))
    for k in range(chance.integers(1, 5)):
        angle = k * math.pi / 2 + chance.choice([0.0, 0.2])
        scene.add_static(
            t2.HalfPlane(normal=(math.cos(angle), math.sin(angle)), offset=-chance.uniform(1.7, 3)),
            restitution=float(chance.choice([0.0, 0.5, 1.0])),
            friction=friction,
            name=f"wall{k}",
        )
    if chance.random() < 0.3:
        post = t2.Disc(radius=0.3)
        scene.add_static(post, position=(0.0, -1.1), restitution=1.0, name="post")
    places = [(0.5 * x - 1.0, 0.5 * y - 0.4) for x in range(5) for y in range(4)]
    for k, place in enumerate(chance.permutation(len(places))[: chance.integers(1, 12)]):
        scene.add_body(
            t2.Disc(radius=chance.uniform(0.05, 0.24)),
            mass=chance.uniform(0.1, 10.0),
            position=places[place],
            velocity=tuple(chance.normal(0, 2, 2)),
            angular_velocity=chance.choice([0.0, 20.0]),
            torque=chance.choice([0.0, 0.3]),
            force=(chance.choice([0.0, 1.0]), 0.0),
            restitution=float(chance.choice([chance.uniform(0, 1), 1.0, 0.0])),
            friction=float(chance.choice([friction, 0.0])),
            name=f"disc{k}",
        )
    if chance.random() < 0.3:
        scene.add_body(None, mass=1.0, position=(0.0, 0.0), velocity=(1.0, 0.0), name="dust")
    return scene


def mixed_crowd(seed: int) -> t2.Scene:
    """Bodies of all convex shapes, of sizes 1 to 20, between walls that are half-planes or boxes.

    They fly or fall, spin, rub, and lose energy or do not.
    """
    chance = np.random.default_rng(seed)
    gravity = [(0.0, 0.0), (0.0, -9.81), tuple(chance.normal(0, 5, 2))][chance.integers(3)]
    scene = t2.Scene(gravity=gravity)
    friction, bounce = float(chance.choice([0.0, 0.3, 1.0])), float(chance.choice([0.0, 0.6, 1.0]))
    for k in range(4):
        angle = k * math.pi / 2 + chance.choice([0.0, 0.2])
        away = chance.uniform(2.2, 3)
        shape, at = t2.HalfPlane(normal=(math.cos(angle), math.sin(angle)), offset=-away), 0.0
        if chance.random() < 0.5:
            at = away + 0.25
            shape = t2.Segment(length=8.0) if k == 3 else t2.Box(width=8.0, height=0.5)
        scene.add_static(
            shape,
            position=(-at * math.cos(angle), -at * math.sin(angle)),
            orientation=angle + math.pi / 2 if at else 0.0,
            restitution=bounce, friction=friction, name=f"wall{k}",
        )  # fmt: skip
    places = [(0.8 * x - 1.6, 0.8 * y - 1.6) for x in range(5) for y in range(5)]
    for k, place in enumerate(chance.permutation(len(places))[: chance.integers(2, 13)]):
        scene.add_body(
            shape_of(chance, 0.35 * 20 ** -chance.uniform(0, 1)),
            mass=chance.uniform(0.1, 10.0),
            position=places[place],
            orientation=float(chance.choice([0.0, chance.uniform(-4, 4)])),
            velocity=tuple(chance.normal(0, 2, 2)),
            angular_velocity=float(chance.choice([0.0, chance.normal(0, 3), chance.normal(0, 30)])),
            torque=float(chance.choice([0.0, 0.3])),
            force=(float(chance.choice([0.0, 1.0])), 0.0),
            restitution=float(chance.choice([chance.uniform(0, 1), bounce, bounce])),
            friction=float(chance.choice([friction, 0.0])),
            name=f"body{k}",
        )
    return scene


Convex: TypeAlias = t2.Disc | t2.Segment | t2.Capsule | t2.Box | t2.Polygon


def shape_of(chance: np.random.Generator, reach: float) -> Convex:
    """Return a shape by chance, of which no point is farther than `reach` from its middle, m."""
    kind, share = chance.integers(6), chance.uniform(0.2, 0.9)
    if kind == 0:
        return t2.Disc(radius=reach)
    if kind == 1:
        return t2.Segment(length=2 * reach)
    if kind == 2:
        return t2.Capsule(length=2 * reach * share, radius=reach * (1 - share))
    if kind == 3:
        return t2.Box(width=2 * reach * share, height=2 * reach * math.sqrt(1 - share**2))
    turns = np.sort(chance.uniform(0, 0.7, chance.integers(3, 9))) + np.linspace(0, 5, 3)[:, None]
    outline = [(reach / 2 * math.cos(at), reach / 2 * math.sin(at)) for at in turns.ravel()]
    return t2.Polygon(vertices=outline)
