"""Crowds of fast bodies: they go where their velocities say, and nothing passes anything."""

from pathlib import Path

import numpy as np
import pytest

from tests.crowd_laws import crowd
from tests.engine.conserved import totals
from tests.engine.crowds import centre_of_mass, imploding, rain, standing_share
from tests.engine.saving import goes_on_alike


@pytest.mark.parametrize("seed", range(12))
def test_what_nothing_pushes_keeps_its_way_and_its_momentum(seed: int) -> None:
    sim, rows = imploding(seed)
    momentum, _, energy = totals(sim)
    at, mass = centre_of_mass(sim, rows), sim.mass[rows].sum()
    speed = (sim.mass[rows] * np.hypot(*sim.velocity[rows].T)).sum() / mass
    for _ in range(60):
        sim.step()
        after, _, left = totals(sim)
        assert left <= energy * (1 + 1e-12)  # rounding
        energy = left
        assert after == pytest.approx(momentum, abs=1e-12 * speed * mass)
    assert centre_of_mass(sim, rows) - at == pytest.approx(momentum / mass, abs=1e-9 * speed)


@pytest.mark.parametrize(
    ("radius", "fall"), [(0.005, 2.0), (0.02, 0.2), (0.02, 2.0), (0.02, 20.0), (0.1, 20.0)]
)
def test_nobody_stands_still_with_a_velocity(radius: float, fall: float) -> None:
    """In a heap that settles a few are pushed to and fro within a step: of several rains."""
    shares = []
    for part in (0.8, 0.9, 1.0, 1.1, 1.2):
        sim, rows = rain(radius, part * fall)
        shares.append(standing_share(sim, rows, 40))
        x, y = sim.position[rows].T
        assert (y[np.abs(x) < 400 * radius] > 0.0).all()
    assert np.mean(shares) <= 1e-3


@pytest.mark.parametrize("share", [0.003, 0.03])
@pytest.mark.parametrize("seed", [18, 1052])  # many bodies go on together
def test_forces_give_a_crowd_what_they_push(seed: int, share: float) -> None:
    """Whatever meets, gravity and forces on single bodies change the momentum of all alike."""
    sim, _ = crowd(seed)
    chance, mass = np.random.default_rng(seed), sim.mass[:, None]
    pull = share * np.hypot(*sim.velocity.T).max() / sim.time_step
    sim.gravity = pull * chance.normal(size=2)
    sim.force[:] = pull * mass * chance.normal(size=(len(mass), 2))
    push = (mass * np.array(sim.gravity) + sim.force) * sim.time_step
    for _ in range(12):
        before = mass * sim.velocity
        sim.step()
        off = (mass * sim.velocity - before - push).sum(axis=0)
        assert off == pytest.approx(0.0, abs=1e-12 * (np.abs(before) + np.abs(push)).sum())


def test_a_step_says_in_how_many_parts_it_was_taken() -> None:
    sim, _ = rain(0.02, 2.0)
    assert sim.parts == 1
    most = 1
    for _ in range(10):
        sim.step()
        most = max(most, sim.parts)
    assert most >= 8  # 0.1 m in a step, half-widths of 12 to 20 mm
    calm, _ = rain(0.5, 0.0)
    calm.step(30)
    assert calm.parts == 1


def test_a_crowd_goes_on_the_same_from_a_saved_step(tmp_path: Path) -> None:
    sim, _ = rain(0.02, 2.0, count=30)
    sim.step(3)
    assert goes_on_alike(sim, tmp_path, 5)


def test_plain_python_has_the_bits_of_compiled_code() -> None:
    ends = []
    for compiled in (True, False):
        sim, _ = rain(0.02, 0.5, count=12, compiled=compiled)
        parts = []
        for _ in range(6):
            sim.step()
            parts.append(sim.parts)
        assert max(parts) > 1
        ends.append(sim.digest())
    assert ends[0] == ends[1]
