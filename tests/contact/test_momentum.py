"""What nothing outside pushes keeps its momentum and its angular momentum."""

import math
import random

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.contact import Refusal
from tamias2d.motion import ClosedForm
from tools.fuzz.momentum import located

ROUNDING = 1e-12  # of the sum of magnitudes; impacts round some hundred times


def shape(rng: random.Random):
    length, thickness = 10 ** rng.uniform(-1, 0.3), 10 ** rng.uniform(-3, 0)
    return rng.choice(
        [
            t2.Disc(radius=length),
            t2.Box(width=length, height=thickness),
            t2.Segment(length=length),
            t2.Capsule(length=length, radius=thickness),
            t2.Polygon(
                vertices=[(length * math.cos(a), length * math.sin(a)) for a in (0.3, 2.0, 4.5)]
            ),
        ]
    )


def meeting(seed: int) -> t2.Scene:
    """Return some bodies on a ring that are thrown at its middle."""
    rng = random.Random(seed)
    scene = t2.Scene(gravity=(0, 0))
    restitution, friction = rng.choice([0.0, 1.0, rng.random()]), rng.choice([0.0, rng.random()])
    count, far = rng.randint(2, 6), rng.choice([0.0, 100.0])
    for k in range(count):
        angle, out, speed = k * math.tau / count, rng.uniform(5, 8), 10 ** rng.uniform(-1, 1.5)
        aim = angle + rng.uniform(-0.1, 0.1)
        scene.add_body(
            shape(rng),
            mass=10 ** rng.uniform(-3, 3),
            position=(out * math.cos(angle) + far, out * math.sin(angle)),
            velocity=(-speed * math.cos(aim), -speed * math.sin(aim)),
            orientation=rng.uniform(-4, 4),
            angular_velocity=rng.uniform(-9, 9),
            restitution=restitution,
            friction=friction,
        )
    return scene


@pytest.mark.parametrize("seed", range(40))
def test_momentum_and_angular_momentum_are_kept(seed):
    try:
        run = t2.simulate(meeting(seed), duration=8.0, method=ClosedForm())
    except Refusal as refusal:
        run = refusal.run
    mass = np.array([body.mass for body in run.scene.bodies])
    inertia = np.array([body.inertia for body in run.scene.bodies])
    (x, y), (u, v) = run.position.transpose(2, 0, 1), run.velocity.transpose(2, 0, 1)
    spins = inertia * run.angular_velocity
    for parts in (mass * u, mass * v, mass * (x * v - y * u) + spins):
        whole, size = parts.sum(axis=1), np.abs(parts).sum(axis=1).max()
        assert np.ptp(whole) <= ROUNDING * max(size, float(np.abs(mass * np.hypot(u, v)).max()))


def test_what_slips_off_one_of_several_bodies_in_contact_lets_all_of_them_go():
    """It was the last contact of its own, so that the others went on as if it still pressed."""
    assert located(15_000_011) == "done"
