"""The impulses that are told are those that change the momenta of bodies (P12)."""

from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.engine.direct.solve import ACCEPTED
from tamias2d.engine.tables import FLOWN

SOLVED = ACCEPTED**0.5
"""Of impulses: what the equations of an island that is solved at once may leave."""


@pytest.mark.parametrize("restitution", [0.0, 0.5])
@pytest.mark.parametrize("aside", [0.0, 0.3, 0.7])
def test_momenta_change_by_the_impulses_that_are_told(aside: float, restitution: float) -> None:
    """A disc falls onto a box on a floor: few bodies, whose impacts take more sweeps."""
    surface: Any = {"friction": 0.0, "restitution": restitution}
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)))
    sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    box, disc = (
        sim.add(t2.Box(width=1.0, height=0.5), mass=2.0, position=(0.0, 0.25), **surface),
        sim.add(t2.Disc(radius=0.2), mass=1.0, position=(aside, 0.8), **surface),
    )
    mass, hits = sim.mass[[box, disc]][:, None], 0
    for _ in range(60):
        before = sim.velocity[[box, disc]].copy()
        sim.step()
        if sim.parts > 1 or sim._engine.world.control.progress[FLOWN] > 0.0:
            continue  # a pair may be pushed along several normals then, of which one is told
        contacts = sim.contacts
        given = np.zeros((3, 2))
        np.add.at(given, contacts.bodies[:, 1], contacts.impulse[:, None] * contacts.normal)
        np.add.at(given, contacts.bodies[:, 0], -contacts.impulse[:, None] * contacts.normal)
        weight = mass * sim.gravity * sim.time_step
        change = mass * (sim.velocity[[box, disc]] - before)
        size = np.abs(given).max()
        assert change == pytest.approx(weight + given[[box, disc]], abs=SOLVED * size + 1e-15)
        hits += int(np.abs(change - weight)[1].max() > 0.5)
    assert hits > 0
