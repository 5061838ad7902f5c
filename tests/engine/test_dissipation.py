"""What an island has too much is taken from what got it, and nothing else (IM11, DD88)."""

from itertools import pairwise
from typing import Any

import numpy as np
import pytest

import tamias2d as t2

PULL = 9.81


def lands(sim: t2.Simulator, seed: int, x: float, surface: Any) -> int:
    """Add a chain of three hinged boxes that falls on what is below; return its last one."""
    random = np.random.default_rng(seed)
    tilt = random.uniform(-1.5, 1.5)
    along = 0.8 * np.array([np.cos(tilt), np.sin(tilt)])
    links = [
        sim.add(t2.Box(width=0.8, height=0.2), mass=float(10 ** random.uniform(-0.5, 0.7)),
                position=tuple((x, 2.5) + k * along), orientation=tilt, velocity=(0.0, -3.0),
                **surface)
        for k in range(3)
    ]  # fmt: skip
    for one, other in pairwise(links):
        sim.add_joint(t2.Revolute(), one, other, anchor=(0.4, 0.0), other_anchor=(-0.4, 0.0))
    return links[-1]


@pytest.mark.parametrize("tie", ["rope", "rotary"])
def test_a_flier_that_is_tied_slackly_to_what_lands_falls_freely(tie: str) -> None:
    """What is left is of the bound on mechanisms that touch nothing."""
    surface: Any = {"friction": 0.5, "restitution": 0.0}
    for seed in range(25):
        sim = t2.Simulator(t2.Scene(gravity=(0.0, -PULL)))
        sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
        last = lands(sim, seed, 0.0, surface)
        flier = sim.add(
            t2.Disc(radius=0.2), mass=1.0, position=(6.0, 8.0), velocity=(3.0, 8.0), **surface
        )
        slack = t2.Limits(upper=40.0, restitution=0.0)
        turns = t2.Limits(lower=-300.0, upper=300.0, restitution=0.0)
        joint = t2.Distance(limits=slack) if tie == "rope" else t2.Rotary(limits=turns)
        sim.add_joint(joint, last, flier)
        for _ in range(80):
            before = sim.velocity[flier].copy()
            sim.step()
            free = before + np.array([0.0, -PULL * sim.time_step])
            assert np.abs(sim.velocity[flier] - free).max() < 1e-3


def test_a_smooth_slider_goes_on_while_a_chain_lands_on_the_same_plank() -> None:
    """It lost up to 2 m/s when all of the island was damped alike, and 0.05 when it was last."""
    surface: Any = {"friction": 0.0, "restitution": 0.0}
    for seed in range(25):
        sim = t2.Simulator(t2.Scene(gravity=(0.0, -PULL)))
        sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
        sim.add(t2.Box(width=60.0, height=0.5), mass=200.0, position=(0.0, 0.25), **surface)
        slider = sim.add(
            t2.Disc(radius=0.2), mass=1.0, position=(-20.0, 0.7), velocity=(3.0, 0.0), **surface
        )
        lands(sim, seed, 8.0, surface)
        sim.step(120)
        assert abs(sim.velocity[slider, 0] - 3.0) < 1e-4  # the plank tilts under the chain


@pytest.mark.parametrize("speed", [0.05, 0.3])
def test_a_slow_slider_is_not_stopped_by_what_overlaps_lift(speed: float) -> None:
    """A heavy plank rises out of its overlap, and a chain on it: who slides has given nothing."""
    surface: Any = {"friction": 0.6, "restitution": 0.0}
    for seed in range(12):
        random = np.random.default_rng(seed)
        sim = t2.Simulator(t2.Scene(gravity=(0.0, -PULL)))
        sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=-0.1), **surface)
        sim.add(t2.Box(width=40.0, height=0.2), mass=100.0, position=(0.0, 0.0), **surface)
        slider = sim.add(
            t2.Box(width=0.4, height=0.2), mass=1.0, position=(8.0, 0.2), velocity=(speed, 0.0),
            friction=0.0, restitution=0.0,
        )  # fmt: skip
        links = [
            sim.add(t2.Box(width=0.4, height=0.1), mass=float(random.uniform(1, 5)),
                    position=(-6 + 0.4 * k, 1.0), velocity=(0.0, -float(random.uniform(0, 8))),
                    **surface)
            for k in range(3)
        ]  # fmt: skip
        for one, other in pairwise(links):
            sim.add_joint(t2.Revolute(), one, other, anchor=(0.2, 0.0), other_anchor=(-0.2, 0.0))
        sim.step(120)
        assert sim.velocity[slider, 0] == pytest.approx(speed, rel=5e-3)  # measured: 1e-3


@pytest.mark.parametrize("time_step", [1 / 30, 1 / 60])
def test_a_slack_rope_ties_nothing(time_step: float) -> None:
    """A smooth disc that falls beside a stack on its plank lost all of its speed to it."""
    surface: Any = {"friction": 0.6, "restitution": 0.0}
    for seed in range(12):
        random = np.random.default_rng(seed)
        sim = t2.Simulator(t2.Scene(gravity=(0.0, -PULL)), time_step=time_step)
        sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
        sim.add(t2.Box(width=20.0, height=0.2), mass=200.0, position=(0.0, 0.1), **surface)
        stack = [
            sim.add(t2.Box(width=0.4, height=0.4), mass=float(10 ** random.uniform(-1, 1)),
                    position=(-3.0, 0.4 + 0.4 * k), **surface)
            for k in range(4)
        ]  # fmt: skip
        disc = sim.add(
            t2.Disc(radius=0.2), mass=float(10 ** random.uniform(-1, 1)),
            position=(3.0, float(random.uniform(1.2, 5.2))), velocity=(1.5, 0.0),
            angular_velocity=5.0, friction=0.0, restitution=0.0,
        )  # fmt: skip
        rope = t2.Distance(limits=t2.Limits(upper=100.0, restitution=0.0))
        sim.add_joint(rope, stack[seed % 4], disc)
        sim.step(int(1.3 / time_step))
        assert sim.velocity[disc, 0] == pytest.approx(1.5, rel=1e-5)  # the plank tilts under it
        assert sim.angular_velocity[disc] == pytest.approx(5.0, rel=1e-6)


def test_supports_that_creep_give_no_more_than_their_work() -> None:
    """A heap of mechanisms made 13 times its energy on belts of a millimetre a second."""
    for seed in range(12):
        random = np.random.default_rng(seed)
        surface: Any = {"friction": float(random.uniform(0, 1)), "restitution": 0.0}
        sim = t2.Simulator(t2.Scene(gravity=(0.0, -PULL)))
        for side in (-1.0, 1.0):
            sim.add_kinematic(
                t2.Box(width=6.0, height=1.0), position=(3.0 * side, -0.5),
                velocity=(1e-3 * side, 0.0), **surface,
            )  # fmt: skip
        links = [
            sim.add(t2.Box(width=0.6, height=0.2), mass=float(10 ** random.uniform(-1, 1)),
                    position=(0.6 * k - 1.2, 2.0), angular_velocity=float(random.normal()),
                    velocity=tuple(random.normal(size=2)), **surface)
            for k in range(5)
        ]  # fmt: skip
        bends = t2.Limits(lower=-0.5, upper=0.5, restitution=0.0)
        for one, other in pairwise(links):
            hinge = t2.Revolute(limits=bends)
            sim.add_joint(hinge, one, other, anchor=(0.3, 0.0), other_anchor=(-0.3, 0.0))
        mass = sim.mass[links]
        inertia = mass * (0.6**2 + 0.2**2) / 12
        highest = np.inf
        for _ in range(180):
            motion = mass @ (sim.velocity[links] ** 2).sum(axis=1)
            turning = inertia @ sim.angular_velocity[links] ** 2
            energy = (motion + turning) / 2 + PULL * mass @ sim.position[links, 1]
            assert energy < highest + 5e-3 * mass.sum()  # J; what overlaps give back
            highest = min(highest, energy)
            sim.step()


def test_smooth_discs_that_meet_keep_their_spins() -> None:
    """No contact has a lever to turn them; rounding turns them, and counts for nothing."""
    for seed in range(12):
        random = np.random.default_rng(seed)
        sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
        surface: Any = {"friction": 0.0, "restitution": 0.5 * (seed % 2)}
        sim.add_static(t2.Box(width=1.0, height=1.0), position=(50.0, 0.0), **surface)
        discs = []
        for k in range(6):
            place = np.array([(k % 3 - 1) * 1.2, (k // 3 - 0.5) * 1.2])
            discs.append(
                sim.add(t2.Disc(radius=float(random.uniform(0.2, 0.4))), mass=1.0 + k,
                        position=tuple(place), angular_velocity=float(random.normal() * 4),
                        velocity=tuple(-3 * place + random.normal(size=2)), **surface)
            )  # fmt: skip
        spins = sim.angular_velocity[discs].copy()
        sim.step(120)
        np.testing.assert_allclose(sim.angular_velocity[discs], spins, rtol=1e-6)
