"""Drag on bodies that something holds: towed, carried, pushed, and hung (IM6, DD41, DD109).

All answers are those of the equations of motion: steady states, and the exponentials that lead to
them.
"""

from math import exp, inf

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.simulator import Simulator

G = 9.81
HELD = {"friction": 0.5, "restitution": 0.0}


def air(substeps: int = 4, gravity: float = G) -> Simulator:
    return Simulator(t2.Scene(gravity=(0.0, -gravity)), substeps=substeps)


JOINTS = {
    "rod": t2.Distance(),
    "rope": t2.Distance(limits=t2.Limits(upper=1.0, restitution=0.0)),
    "hinge": t2.Revolute(),
}


@pytest.mark.parametrize("joint", JOINTS)
@pytest.mark.parametrize("drag", [5.0, 20.0])
def test_a_load_lags_behind_its_trolley(joint: str, drag: float) -> None:
    """In the steady state weight and drag act along what holds it: tan(angle) = c v / (m g)."""
    sim = air()
    load = sim.add(t2.Disc(radius=0.1), mass=5.0, position=(0.0, -1.0), linear_drag=drag, **HELD)
    trolley = sim.add_kinematic(
        t2.Disc(radius=0.1), position=(0.0, 0.0), velocity=(1.5, 0.3), **HELD
    )
    at = (0.0, 0.0) if joint == "hinge" else None
    sim.add_joint(JOINTS[joint], trolley, load, at=at)
    sim.step(60 * 20)
    x, y = sim.position[load] - sim.position[trolley]
    across, down = drag * 1.5, 5.0 * G + drag * 0.3
    assert x / y == pytest.approx(across / down, rel=1e-3)
    np.testing.assert_allclose(np.abs(sim.reactions.force[0, 1]), (across, down), rtol=1e-3)


@pytest.mark.parametrize("kind", ["kinematic", "running"])
def test_a_crate_slides_on_a_tram(kind: str) -> None:
    """Friction bears less than its drag at the speed of the tram: it tends to mu m g / c."""
    sim, mass, drag = air(), 20.0, 80.0
    tram = t2.Box(width=200.0, height=0.2)
    if kind == "kinematic":
        sim.add_kinematic(tram, position=(0.0, -0.1), velocity=(2.0, 0.0), **HELD)
    else:
        sim.add_static(tram, position=(0.0, -0.1), surface_speed=-2.0, **HELD)
    crate = sim.add(
        t2.Box(width=1.0, height=0.5), mass=mass, position=(0.0, 0.25), velocity=(2.0, 0.0),
        linear_drag=drag, **HELD,
    )  # fmt: skip
    sim.step(180)
    last, left = 0.5 * mass * G / drag, exp(-drag / mass * 3.0)
    assert sim.velocity[crate, 0] == pytest.approx(last + (2.0 - last) * left, abs=1e-5)
    way = last * 3.0 + (2.0 - last) * (1.0 - left) * mass / drag
    assert sim.position[crate, 0] == pytest.approx(way, abs=5e-3)


def test_angular_drag_turns_what_rides_on_a_turntable() -> None:
    """A loose wheel on a turning arm is held back by angular drag alone: it comes to rest."""
    sim, inertia, drag = air(gravity=0.0), 0.5, 0.25
    arm = sim.add_kinematic(t2.Disc(radius=0.1), position=(0.0, 0.0), angular_velocity=1.0, **HELD)
    wheel = sim.add(
        t2.Disc(radius=0.2), mass=1.0, inertia=inertia, position=(1.0, 0.0),
        velocity=(0.0, 1.0), angular_velocity=1.0, angular_drag=drag, **HELD,
    )  # fmt: skip
    sim.add_joint(t2.Revolute(), arm, wheel, at=(1.0, 0.0))
    sim.step(120)
    assert sim.angular_velocity[wheel] == pytest.approx(exp(-drag / inertia * 2.0), rel=1e-4)


@pytest.mark.parametrize("substeps", [1, 4])
@pytest.mark.parametrize("mass", [5.0, 0.5, 0.1])
def test_a_load_sinks_under_its_parachute(mass: float, substeps: int) -> None:
    """However light the parachute, both fall at (M + m) g / c in the end."""
    sim, drag = air(substeps), 200.0
    load = sim.add(t2.Disc(radius=0.3), mass=80.0, position=(0.0, 0.0), **HELD)
    chute = sim.add(t2.Disc(radius=0.5), mass=mass, position=(0.0, 3.0), linear_drag=drag, **HELD)
    sim.add_joint(t2.Distance(), load, chute)
    sim.step(600)
    assert sim.velocity[load, 1] == pytest.approx(-(80.0 + mass) * G / drag, rel=3e-4)


@pytest.mark.parametrize("substeps", [1, 4])
@pytest.mark.parametrize("mass", [20.0, 0.5])
def test_a_crate_pushes_a_sledge_through_the_mud(mass: float, substeps: int) -> None:
    """The sledge alone has drag: F / c in the end."""
    sim, drag = air(substeps, gravity=0.0), 200.0
    size = t2.Box(width=1.0, height=1.0)
    crate = sim.add(size, mass=80.0, position=(0.0, 0.0), force=(100.0, 0.0), **HELD)
    sim.add(size, mass=mass, position=(1.0, 0.0), linear_drag=drag, **HELD)
    sim.step(600)
    assert sim.velocity[crate, 0] == pytest.approx(0.5, rel=3e-4)


@pytest.mark.parametrize("mass", [5.0, 0.5])
def test_drag_eats_no_weight(mass: float) -> None:
    """What rests or hangs is told to weigh m g, and slips where that says."""
    sim = air()
    drag = {"linear_drag": 200.0, "angular_drag": 1.0}
    sim.add_static(t2.Box(width=100.0, height=1.0), position=(0.0, -0.5), **HELD)
    hung = sim.add(t2.Disc(radius=0.1), mass=mass, position=(3.0, 2.0), **drag, **HELD)
    sim.add_joint(t2.Distance(), (3.0, 3.0), hung)
    body = sim.add(
        t2.Box(width=1.0, height=0.5), mass=mass, position=(0.0, 0.25),
        force=(mass * G, 0.0), linear_drag=200.0, inertia=inf, **HELD,
    )  # fmt: skip
    sim.step(300)
    weight = sim.contacts.impulse.sum() / sim.time_step
    assert weight == pytest.approx(mass * G, rel=1e-4)
    assert abs(sim.reactions.force[0, 1, 1]) == pytest.approx(mass * G, rel=1e-4)
    assert sim.velocity[body, 0] == pytest.approx(0.5 * mass * G / 200.0, rel=1e-4)
