"""A body with joints near a wall is struck towards it within a step: the wall holds it."""

from collections.abc import Callable
from math import pi

import numpy as np
import pytest

import tamias2d as t2

R = 0.03  # m, of all discs
WALLS = {
    "half-plane": (t2.HalfPlane(normal=(-1, 0), offset=0.0), 0.0),
    "segment": (t2.Segment(length=2.0), pi / 2),
    "chain": (t2.Chain(vertices=[(0.0, -1.0), (0.0, 1.0)]), 0.0),
}


def rubbed(sim: t2.Simulator, ball: int) -> list[int]:
    """A table rubs the ball, as docs/joints.md has it."""
    rubs = t2.JointSpring(stiffness=0.0, damping=50.0, maximum=0.02)
    sim.add_joint(t2.Target(spring=rubs), tuple(sim.position[ball]), ball)
    return []


def on_a_rod(sim: t2.Simulator, ball: int) -> list[int]:
    """A rod holds the ball from above."""
    x, y = sim.position[ball]
    sim.add_joint(t2.Distance(), ball, (x, y + 0.5))
    return []


def in_a_chain(sim: t2.Simulator, ball: int) -> list[int]:
    """Four more balls hang on hinges above."""
    x, y = sim.position[ball]
    links, above = [], ball
    for k in range(4):
        links.append(disc(sim, (x, y + 2.2 * R * (k + 1))))
        sim.add_joint(t2.Revolute(), above, links[-1], at=(x, y + 2.2 * R * (k + 0.5)))
        above = links[-1]
    return links


def disc(sim: t2.Simulator, at: tuple[float, float], speed: float = 0.0) -> int:
    velocity = (speed, 0.0)
    return sim.add(t2.Disc(radius=R), mass=0.2, position=at, velocity=velocity, restitution=0.6)


@pytest.mark.parametrize("wall", WALLS)
@pytest.mark.parametrize("joined", [rubbed, on_a_rod, in_a_chain])
def test_a_struck_body_stays_before_the_wall(
    joined: Callable[[t2.Simulator, int], list[int]], wall: str
) -> None:
    """It goes in by less than a quarter of its radius, at five radii a step, and gains nothing."""
    random = np.random.default_rng(7)
    for _ in range(12):
        gap, speed = random.uniform(1e-3, 0.05), random.uniform(1.0, 10.0)
        sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)), time_step=1 / 60, compiled=False)
        shape, turn = WALLS[wall]
        sim.add_static(shape, orientation=turn, restitution=0.6)
        ball = disc(sim, (-R - gap, 0.0))
        bodies = [ball, *joined(sim, ball), disc(sim, (-3 * R - gap - 0.03, 0.0), speed)]
        for _ in range(8):
            sim.step()
            assert sim.position[bodies, 0].max() < -0.75 * R
            motion = (sim.velocity[bodies] ** 2).sum()
            motion += 0.5 * R**2 * (sim.angular_velocity[bodies] ** 2).sum()
            assert motion <= speed**2 * (1 + 1e-9)
