"""The engine as plain Python and compiled: whole runs with the same bits."""

import math
import random

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.simulator import Simulator
from tamias2d.stepped.menu import CONTACT

STATE = ("pose", "motion", "touches", "traces", "pairs", "counts")


def mixed_scene(seed: int, bodies: int) -> t2.Scene:
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


@pytest.mark.parametrize("seed", range(3))
def test_plain_and_compiled_runs_have_the_same_bits(seed: int) -> None:
    scene = mixed_scene(seed, bodies=8)
    compiled, plain = Simulator(scene), Simulator(scene)
    plain._world._engine = CONTACT.plain()
    met = 0
    with np.errstate(all="ignore"):  # plain arithmetic warns of what compiled code passes over
        for step in range(50):
            compiled.step()
            plain.step()
            for name in STATE:
                first, second = (getattr(sim._world, name) for sim in (compiled, plain))
                assert first.tobytes() == second.tobytes(), (step, name)
            met = max(met, len(compiled.contacts))
    assert met >= 5  # the run was about contacts
