"""Whatever is done to it in whatever order: no crash, no number lost, momentum as it must be."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import tamias2d as t2
from tests.simulator.crowd import SHAPES, crowd

ACTIONS = ("step", "add", "wall", "remove", "push", "kick", "move", "ask", "copy")


def act(sim: t2.Simulator, action: str, chance: np.random.Generator) -> t2.Simulator:
    """Do something at random; return the simulator to go on with."""
    there = np.flatnonzero(sim.present)
    some = chance.choice(there, min(len(there), 3), replace=False) if len(there) else there
    match action:
        case "step":
            sim.step(int(chance.integers(1, 5)))
        case "add":
            count = int(chance.integers(1, 4))
            sim.add(
                SHAPES[chance.integers(len(SHAPES))],
                mass=chance.uniform(0.1, 10, count),
                position=chance.uniform(-9, 9, (count, 2)),
                velocity=chance.uniform(-30, 30, (count, 2)),
                angular_velocity=chance.uniform(-30, 30),
                friction=chance.uniform(0, 1),
                restitution=chance.uniform(0, 1),
                sensor=bool(chance.integers(4) == 0),
            )
        case "wall":
            sim.add_static(SHAPES[1], position=chance.uniform(-9, 9, 2), friction=0.5)
            sim.add_kinematic(SHAPES[0], position=(20.0, 20.0), velocity=(-1.0, -1.0))
        case "remove":
            sim.remove(some)
        case "push":
            sim.apply_force(some, chance.uniform(-100, 100, 2), at=sim.position[some] + 0.1)
        case "kick":
            sim.apply_impulse(some, chance.uniform(-5, 5, 2))
        case "move":
            sim.position[some] = chance.uniform(-9, 9, (len(some), 2))
        case "ask":
            start, end = chance.uniform(-12, 12, (2, 2, 2))
            sim.ray_cast(start, end)
            sim.in_box(*np.sort([start[0], end[0]], axis=0))
        case "copy":
            import pickle

            sim = pickle.loads(pickle.dumps(sim))
    return sim


@settings(max_examples=30)
@given(st.lists(st.sampled_from(ACTIONS), max_size=25), st.integers(0, 2**32 - 1))
def test_nothing_breaks_it_and_it_is_the_same_twice(actions: list[str], seed: int) -> None:
    ends = []
    for _ in range(2):
        chance, sim = np.random.default_rng(seed), t2.Simulator(crowd(8, seed=seed % 100))
        for action in actions:
            sim = act(sim, action, chance)
            for values in (sim.position, sim.velocity, sim.orientation, sim.angular_velocity):
                assert np.isfinite(values).all()
            for pair in (*sim.contacts.bodies, *sim.began.bodies, *sim.ended):
                assert 0 <= min(pair) <= max(pair) < len(sim.present)
        sim.step()
        ends.append((sim.digest(), repr(sim.contacts)))
    assert ends[0] == ends[1]


@settings(max_examples=15)
@given(st.integers(0, 2**32 - 1), st.integers(2, 40))
def test_momentum_stays_whatever_overlaps(seed: int, count: int) -> None:
    """No walls, no gravity: bodies that start in each other push each other only."""
    chance = np.random.default_rng(seed)
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    mass = chance.uniform(0.1, 10, count)
    given: dict[str, Any] = {"friction": 0.5, "restitution": chance.uniform(0, 1)}
    sim.add(
        [SHAPES[k % len(SHAPES)] for k in range(count)],
        mass=mass,
        position=chance.uniform(-2, 2, (count, 2)),
        velocity=chance.uniform(-5, 5, (count, 2)),
        **given,
    )
    start = mass @ sim.velocity
    scale = float(mass @ np.abs(sim.velocity).sum(axis=1)) + 1.0
    for _ in range(60):
        sim.step()
        moved = mass @ sim.velocity
        # each impulse is given to both with opposite signs: a rounding for each
        assert np.abs(moved - start).max() < 1e-11 * scale * max(1, np.abs(sim.velocity).max())


def test_it_has_been_seen_to_push() -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    sim.add(t2.Disc(radius=1.0), mass=[1.0, 3.0], position=[(0, 0), (1, 0)], restitution=0.0)
    sim.step(60)
    assert np.ptp(sim.position[:, 0]) == pytest.approx(2.0, abs=0.1)
