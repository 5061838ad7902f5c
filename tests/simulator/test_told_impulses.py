"""The impulses that are told are those that change the momenta of bodies (P12)."""

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

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
            continue  # a pair with points may be pushed along other normals, too, in flight
        given = told(sim)
        weight = mass * sim.gravity * sim.time_step
        change = mass * (sim.velocity[[box, disc]] - before)
        size = np.abs(given).max()
        assert change == pytest.approx(weight + given[[box, disc]], abs=SOLVED * size + 1e-15)
        hits += int(np.abs(change - weight)[1].max() > 0.5)
    assert hits > 0


@pytest.mark.parametrize("restitution", [0.5, 1.0])
@pytest.mark.parametrize("seed", range(3))
def test_momenta_change_by_what_is_told_of_a_step_in_parts(seed: int, restitution: float) -> None:
    """Boxes thrown about in cages of discs, whose normals turn from part to part."""
    sim, boxes = cages(seed, restitution)
    hits = parts = 0
    for _ in range(8):
        before = sim.velocity[boxes].copy()
        sim.step()
        change = sim.mass[boxes][:, None] * (sim.velocity[boxes] - before)
        given = told(sim)[boxes]
        rounding = np.spacing(np.abs(before).max())  # of a velocity; a box has 1 kg
        assert change == pytest.approx(given, abs=1e-12 * np.abs(given).max() + rounding)
        pairs = np.sort(sim.contacts.bodies, axis=1)
        assert sim.parts == 1 or len(np.unique(pairs, axis=0)) == len(pairs)
        hits, parts = hits + len(pairs), max(parts, sim.parts)
    assert hits > 20
    assert parts > 8


def told(sim: t2.Simulator) -> Any:
    """Return the sum of what contacts tell of each body, N s."""
    contacts, given = sim.contacts, np.zeros_like(sim.velocity)
    np.add.at(given, contacts.bodies[:, 1], contacts.impulse[:, None] * contacts.normal)
    np.add.at(given, contacts.bodies[:, 0], -contacts.impulse[:, None] * contacts.normal)
    return given


def cages(seed: int, restitution: float) -> tuple[t2.Simulator, NDArray[np.int64]]:
    """Nine boxes at three sizes a step, each in a ring of five discs that stand."""
    chance = np.random.default_rng(seed)
    surface: Any = {"friction": 0.0, "restitution": restitution}
    sim, rows = t2.Simulator(t2.Scene(gravity=(0.0, 0.0))), []
    around = 2 * np.pi / 5 * np.arange(5)
    for k in range(9):
        at = 20.0 * np.array([k % 3, k // 3])
        for angle in around:
            place = at + 2.4 * np.array([np.cos(angle), np.sin(angle)])
            sim.add_static(t2.Disc(radius=1.2), position=tuple(place), **surface)
        way = chance.uniform(0, 6)
        rows.append(
            sim.add(
                t2.Box(width=0.9, height=0.6),
                mass=1.0,
                position=tuple(at),
                orientation=chance.uniform(0, 6),
                velocity=(180.0 * np.cos(way), 180.0 * np.sin(way)),
                angular_velocity=chance.uniform(-20, 20),
                **surface,
            )
        )
    return sim, np.array(rows)
