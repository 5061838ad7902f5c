"""Mechanisms that nothing holds keep their momenta where bodies meet them, and gain no energy."""

import warnings
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.state import Array
from tools.fuzz import momentum


@pytest.mark.parametrize("seed", range(12))
def test_what_is_thrown_at_a_mechanism_keeps_momenta_and_makes_no_energy(seed: int) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", t2.StepWarning)
        assert momentum.jointed(seed) == "done"


@pytest.mark.parametrize(("heavy", "seed"), [(100.0, 32), (1000.0, 77)])
def test_a_light_link_that_is_pinched_takes_no_angular_momentum(heavy: float, seed: int) -> None:
    sim, mass, inertia = pinched_link(heavy, seed)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", t2.StepWarning)
        sim.step()
        turning, energy = turning_and_energy(sim, mass, inertia)
        for _ in range(130):
            sim.step()
            now, left = turning_and_energy(sim, mass, inertia)
            assert abs(now - turning) <= 1e-12 * heavy  # beside heavy * m^2/s
            told = any("got energy" in text for text in sim.warnings)
            assert told or left <= energy * (1.0 + 1e-3)
            energy = left


def pinched_link(heavy: float, seed: int) -> tuple[t2.Simulator, Array, Array]:
    """Return three hinged boxes, the middle one of 1 kg, and a heavy one that falls on them."""
    chance = np.random.default_rng(seed)
    mass = np.array([heavy, 1.0, heavy, heavy])
    places = [(0.0, 0.0), (0.8, 0.0), (1.6, 0.0), (0.8 + chance.uniform(-0.6, 0.6), 1.2)]
    velocity = chance.normal(0, 0.5, (4, 2))
    velocity[3, 1] -= 3.0
    box = t2.Box(width=0.5, height=0.4)
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    surface: dict[str, Any] = {"friction": 0.6, "restitution": 0.5}
    spins = chance.normal(0, 2, 4)
    sim.add(box, mass=mass, position=places, velocity=velocity, angular_velocity=spins, **surface)
    for k in (0, 1):
        sim.add_joint(t2.Revolute(), k, k + 1, anchor=(0.4, 0.0), other_anchor=(-0.4, 0.0))
    return sim, mass, np.array([box.inertia(m) for m in mass])


def turning_and_energy(sim: t2.Simulator, mass: Array, inertia: Array) -> tuple[float, float]:
    """Return the angular momentum about the origin, kg m^2/s, and the energy, J."""
    (x, y), (u, v), spin = sim.position.T, sim.velocity.T, sim.angular_velocity
    turning = float(mass @ (x * v - y * u) + inertia @ spin)
    return turning, float(0.5 * (mass @ (u**2 + v**2) + inertia @ spin**2))
