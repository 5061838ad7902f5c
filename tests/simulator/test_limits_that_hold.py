"""A limit that holds acts as a rod does: half of the loads at both ends of a step (IM15)."""

import math
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tests.engine.scenes import plain

G = 9.81
LENGTH, MASS, ANGLE = 1.5, 4.0, 1.2


def swing(kind: Any, **settings: Any) -> t2.Scene:
    """A bob that swings from rest on a rope or a rod, taut all the time."""
    scene = t2.Scene(gravity=(0.0, -G))
    at = (LENGTH * math.sin(ANGLE), -LENGTH * math.cos(ANGLE))
    scene.add_body(t2.Disc(radius=0.3), mass=MASS, position=at, restitution=0.0)
    scene.add_joint(kind, (0.0, 0.0), 0, name="line", **settings)
    return scene


def rope() -> t2.Distance:
    return t2.Distance(limits=t2.Limits(upper=LENGTH, restitution=0.0))


@pytest.mark.parametrize("substeps", [1, 4])
def test_a_rope_is_told_the_tension_that_its_load_gets(substeps: int) -> None:
    """It was told 9 % more than the load got, and 39 % with one substep."""
    sim = plain(swing(rope()), substeps=substeps)
    largest = 0.0
    for _ in range(60):
        before = sim.velocity[0].copy()
        sim.step()
        got = MASS * (sim.velocity[0] - before) * 60 + (0.0, MASS * G)
        told = sim.reactions.force[0, 1]
        assert told == pytest.approx(got, abs=1e-9)
        largest = max(largest, float(np.hypot(*told)))
    assert largest == pytest.approx(MASS * G * (3 - 2 * math.cos(ANGLE)), rel=1e-3)


def test_a_swing_on_a_rope_goes_the_way_of_one_on_a_rod() -> None:
    """It lost a third of its energy in a minute."""
    on_rope, on_rod = plain(swing(rope())), plain(swing(t2.Distance()))
    on_rope.step(120)
    on_rod.step(120)
    assert on_rope.position == pytest.approx(on_rod.position, abs=1e-4)
    assert on_rope.velocity == pytest.approx(on_rod.velocity, abs=1e-4)


def test_a_rope_breaks_at_the_tension_of_theory() -> None:
    most = MASS * G * (3 - 2 * math.cos(ANGLE))
    for share, breaks in ((1.01, False), (0.97, True)):
        sim = plain(swing(rope(), break_force=share * most))
        sim.step(60)
        assert (not sim.joints) == breaks


LIMITS = t2.Limits(lower=-0.01, upper=0.01, restitution=0.0)
MOTOR = t2.Motor(speed=3.0, maximum=2.0)
KINDS: dict[str, Any] = {
    "a limit of a slide": t2.Prismatic(axis=(1.0, 0.0), limits=LIMITS),
    "a motor of a slide": t2.Prismatic(axis=(1.0, 0.0), motor=MOTOR),
    "a limit of a hinge": t2.Revolute(limits=LIMITS),
    "a motor of a wheel": t2.Wheel(
        axis=(0.0, 1.0), spring=t2.JointSpring(stiffness=300.0, damping=5.0), motor=MOTOR
    ),
    "a motor between angles": t2.Rotary(motor=MOTOR),
    "a rope": t2.Distance(limits=t2.Limits(upper=0.7, restitution=0.0)),
}


@pytest.mark.parametrize("kind", KINDS)
def test_a_mechanism_in_free_flight_follows_its_parabola(kind: str) -> None:
    """Its centre of mass fell too far by half a substep of gravity for each second."""
    scene = t2.Scene(gravity=(0.0, -G))
    flight: Any = {"velocity": (1.0, 2.0), "angular_velocity": 1.0, "group": -1}
    scene.add_body(t2.Box(width=1.0, height=0.4), mass=2.0, position=(0.0, 0.0), **flight)
    flight["velocity"] = (1.0, 2.7)
    scene.add_body(t2.Disc(radius=0.2), mass=1.0, position=(0.7, 0.0), **flight)
    place: Any = {} if KINDS[kind].no_place else {"at": (0.7, 0.0)}
    scene.add_joint(KINDS[kind], 0, 1, **place)
    sim = plain(scene)
    sim.step(15)
    centre = (2 * sim.position[0] + sim.position[1]) / 3
    rise = (2.0 + 0.7 / 3) / 4 - G / 32
    assert centre == pytest.approx((0.7 / 3 + 0.25, rise), abs=1e-9)
