"""What contacts lift out of overlaps is taken from the energy of bodies that rise (DD87)."""

from typing import Any

import numpy as np
import pytest

from tamias2d.simulator import Simulator
from tamias2d.state import Array
from tests.engine.crowds import rain


@pytest.mark.filterwarnings("ignore::tamias2d.errors.StepWarning")  # a heap is pressed together
@pytest.mark.parametrize(("radius", "fall"), [(0.01, 2.0), (0.02, 0.5), (0.05, 1.0)])
def test_only_bodies_that_do_not_rise_get_energy_from_overlaps(radius: float, fall: float) -> None:
    """Otherwise a heap that was pressed together would swing.

    Of what an island lifts, bodies lose their parts, and one that has not enough loses what it has.
    """
    sim, rows = rain(radius, fall, count=200)
    excesses = []
    for _ in range(150):
        before = energies(sim, rows)
        sim.step()
        got = energies(sim, rows) - before
        if sim.parts == 1 and got.sum() > 0.0:
            stays = sim.velocity[rows, 1] <= 1e-12  # m/s, of rounding
            excesses.append((got.sum() - got[stays & (got > 0.0)].sum()) / before.sum())
    assert len(excesses) >= 5
    beyond = np.array(excesses) > 1e-12  # likewise
    assert beyond.mean() <= 0.05  # 8 of 475 steps of nine rains, by 3e-5 at most
    assert max(excesses) <= 1e-4


def energies(sim: Simulator, rows: Any) -> Array:
    """Return the energies of motion and of gravity of some bodies, J."""
    mass, inertia = sim.mass[rows], 1.0 / sim._engine.inverse_inertia[rows]
    speed, spin = (sim.velocity[rows] ** 2).sum(axis=1), sim.angular_velocity[rows]
    found: Array = 0.5 * (mass * speed + inertia * spin**2) + 9.81 * mass * sim.position[rows, 1]
    return found
