"""Planks that lie on each other do not sink into each other, however thin (DD77)."""

from typing import Any

import numpy as np
import pytest

import tamias2d as t2

SURFACE: Any = {"friction": 0.5, "restitution": 0.0}
LENGTH = 10.0
HIGH = 10
MOST = 0.1  # of a thickness: what ten planks on each other may lack of their height


def over_a_floor() -> t2.Simulator:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)))
    sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    return sim


@pytest.mark.parametrize("gap", [0.0, 0.005])
@pytest.mark.parametrize("thickness", [0.1, 0.03, 0.01])
def test_a_stack_of_planks_keeps_its_height(thickness: float, gap: float) -> None:
    """Laid on each other, or dropped from a gap, m."""
    sim = over_a_floor()
    places = [(0.0, thickness / 2 + (thickness + gap) * k) for k in range(HIGH)]
    planks = sim.add(t2.Box(width=LENGTH, height=thickness), mass=1.0, position=places, **SURFACE)
    sim.step(300)
    top = sim.position[planks][-1, 1]
    assert top == pytest.approx((HIGH - 0.5) * thickness, abs=MOST * thickness)
    assert np.abs(sim.velocity[planks]).max() < 1e-3


@pytest.mark.parametrize("thickness", [0.1, 0.01])
def test_a_wall_of_planks_keeps_its_height(thickness: float) -> None:
    """In each layer three, half a length beside those below: no chain that is solved at once."""
    sim = over_a_floor()
    places = [
        ((k % 3 + 0.5 * (k // 3 % 2)) * 1.01 * LENGTH, (0.5 + 1.2 * (k // 3)) * thickness)
        for k in range(3 * HIGH)
    ]
    planks = sim.add(t2.Box(width=LENGTH, height=thickness), mass=1.0, position=places, **SURFACE)
    sim.step(600)
    top = sim.position[planks][-2, 1]
    assert top == pytest.approx((HIGH - 0.5) * thickness, abs=MOST * thickness)
