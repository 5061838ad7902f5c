"""Scenes of random bodies of all shapes, for the tests of this folder."""

import numpy as np

import tamias2d as t2

BOX = t2.Box(width=0.8, height=0.5)
SHAPES = (
    t2.Disc(radius=0.4),
    BOX,
    t2.Polygon(vertices=[(0, 0), (0.9, 0.1), (0.7, 0.8), (0.2, 0.9)]),
    t2.Capsule(length=0.8, radius=0.2),
    t2.Compound(
        parts=[
            t2.Part(shape=BOX),
            t2.Part(shape=t2.Disc(radius=0.3), position=(0.6, 0.1)),
        ]
    ),
)


def crowd(count: int, *, seed: int, size: float = 10.0, overlap: bool = True) -> t2.Scene:
    """Bodies of all shapes in a container, with velocities; overlapping if they may."""
    chance = np.random.default_rng(seed)
    scene = t2.Scene(gravity=(0.0, -9.81))
    for normal in ((0.0, 1.0), (1.0, 0.0), (-1.0, 0.0)):
        scene.add_static(t2.HalfPlane(normal=normal, offset=-size), restitution=0.2, friction=0.4)
    side = int(np.ceil(np.sqrt(count)))
    for k in range(count):
        grid = np.array((k % side, k // side)) * 2.0 - side + 1.0
        place = chance.uniform(-size + 1, size - 1, 2) if overlap else grid
        scene.add_body(
            SHAPES[k % len(SHAPES)],
            mass=chance.uniform(0.5, 2.0),
            position=place,
            orientation=chance.uniform(-3, 3),
            velocity=chance.uniform(-2, 2, 2),
            angular_velocity=chance.uniform(-2, 2),
            friction=0.5,
            restitution=0.1,
        )
    return scene
