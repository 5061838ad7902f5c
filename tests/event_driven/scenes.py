"""Scenes of discs between walls."""

import math

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
