"""What an island has too much is paid by what got it: nobody else is slowed down (IM11, DD88)."""

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
    """It lost up to 2 m/s when all bodies of the island paid alike; 0.05 m/s is left at worst."""
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
        assert abs(sim.velocity[slider, 0] - 3.0) < 0.06


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
