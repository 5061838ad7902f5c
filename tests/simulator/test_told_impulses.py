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


@pytest.mark.parametrize("friction", [0.0, 0.6])
@pytest.mark.parametrize("restitution", [0.0, 0.5])
@pytest.mark.parametrize("aside", [0.0, 0.3, 0.7])
def test_momenta_change_by_the_impulses_that_are_told(
    aside: float, restitution: float, friction: float
) -> None:
    """A disc falls onto a box on a floor: few bodies, whose impacts take more sweeps."""
    surface: Any = {"friction": friction, "restitution": restitution}
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)))
    sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    box, disc = (
        sim.add(t2.Box(width=1.0, height=0.5), mass=2.0, position=(0.0, 0.25), **surface),
        sim.add(t2.Disc(radius=0.2), mass=1.0, position=(aside, 0.8), **surface),
    )
    sim.angular_velocity[disc] = 5.0
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


@pytest.mark.parametrize(("restitution", "friction"), [(0.5, 0.0), (1.0, 0.0), (1.0, 0.6)])
@pytest.mark.parametrize("seed", range(3))
def test_momenta_change_by_what_is_told_of_a_step_in_parts(
    seed: int, restitution: float, friction: float
) -> None:
    """Boxes thrown about in cages of discs, whose normals turn from part to part.

    With friction and a loss at once the bound on energy (IM17) would take from some of them.
    """
    sim, boxes = cages(seed, restitution, friction)
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


def test_discs_that_roll_are_told_their_friction() -> None:
    """Hard discs on a half-plane that slopes: they meet it, slide, and roll at last."""
    surface: Any = {"friction": 0.5, "restitution": 0.4}
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)))
    sim.add_static(t2.HalfPlane(normal=(0.6, 0.8), offset=0.0), **surface)
    disc = sim.add(
        t2.Disc(radius=0.2), mass=2.0, position=(0.4, 0.5), velocity=(5.0, 0.0), **surface
    )
    rolled = 0
    for _ in range(120):
        before = sim.velocity[disc].copy()
        sim.step()
        change = 2.0 * (sim.velocity[disc] - before - sim.gravity * sim.time_step)
        assert change == pytest.approx(told(sim)[disc], abs=1e-12)
        rolled += int(abs(0.2 * sim.angular_velocity[disc] + np.hypot(*sim.velocity[disc])) < 1e-9)
    assert rolled > 10
    assert np.abs(sim.touching(disc).friction_impulse).max() > 0.01


def test_friction_of_a_body_on_a_slope_carries_its_share_of_the_weight() -> None:
    """What is told of a box that stands on a slope is m g h along it and across it."""
    surface: Any = {"friction": 1.0, "restitution": 0.0}
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -10.0)), time_step=0.01)
    slope = sim.add_static(t2.HalfPlane(normal=(0.6, 0.8), offset=0.0), **surface)
    turned = np.arctan2(-0.6, 0.8)
    box = sim.add(
        t2.Box(width=1.0, height=0.5),
        mass=3.0,
        position=(0.15, 0.2),
        orientation=turned,
        **surface,
    )
    sim.step(200)
    seen = sim.touching(box)
    assert seen.impulse.sum() == pytest.approx(3.0 * 10.0 * 0.8 * 0.01, rel=1e-6)
    along = -3.0 * 10.0 * 0.6 * 0.01 * np.array([-0.8, 0.6])  # on the slope, as by its body B
    assert seen.friction_impulse.sum(axis=0) == pytest.approx(along, rel=1e-6)
    on_box = sim.touching(slope).friction_impulse.sum(axis=0)
    assert on_box == pytest.approx(-along, rel=1e-6)


def told(sim: t2.Simulator) -> Any:
    """Return the sum of what contacts tell of each body, N s."""
    contacts, given = sim.contacts, np.zeros_like(sim.velocity)
    on_b = contacts.impulse[:, None] * contacts.normal + contacts.friction_impulse
    np.add.at(given, contacts.bodies[:, 1], on_b)
    np.add.at(given, contacts.bodies[:, 0], -on_b)
    return given


def cages(seed: int, restitution: float, friction: float) -> tuple[t2.Simulator, NDArray[np.int64]]:
    """Nine boxes at three sizes a step, each in a ring of five discs that stand."""
    chance = np.random.default_rng(seed)
    surface: Any = {"friction": friction, "restitution": restitution}
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


def pendulums(count: int) -> t2.Simulator:
    """Of two links each, which fall on a floor and rebound."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -10.0)))
    surface: Any = {"friction": 0.3, "restitution": 0.8, "group": -1}
    sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=-1.0), friction=0.3, restitution=0.8)
    for k in range(count):
        x, plank = 20.0 * k, t2.Box(width=0.8, height=0.2)
        place = [(x + 0.5, 0.0), (x + 1.5, 0.0)]
        upper, lower = sim.add(plank, mass=[1.0, 2.0], position=place, **surface).tolist()
        sim.add_joint(t2.Revolute(), (x, 0.0), upper, at=(x, 0.0))
        sim.add_joint(t2.Revolute(), upper, lower, at=(x + 1.0, 0.0))
    return sim


@pytest.mark.parametrize("count", [1, 8])
def test_hinges_tell_what_they_give_as_contacts_rebound_in_that_step(count: int) -> None:
    """It was told a step late, or not at all of many alike, which are solved side by side."""
    sim, hits = pendulums(count), 0
    mass = sim.mass[1:, None]
    for _ in range(80):
        before = sim.velocity.copy()
        sim.step()
        contacts, given = sim.contacts, np.zeros_like(before)
        push = contacts.impulse[:, None] * contacts.normal + contacts.friction_impulse
        np.add.at(given, contacts.bodies[:, 0], -push)
        np.add.at(given, contacts.bodies[:, 1], push)
        for joint, impulse in zip(sim._joints, sim.reactions.impulse, strict=True):
            for body, part in zip(joint.ends, impulse, strict=True):
                if body is not None:
                    given[body] += part
        change = mass * (sim.velocity - before)[1:] - mass * sim.gravity * sim.time_step
        largest = np.abs(push).max(initial=0.0)
        if largest > 2.0:
            hits += 1
            assert given[1:] == pytest.approx(change, abs=0.01 * largest)
    assert hits > 0
