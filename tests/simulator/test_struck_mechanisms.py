"""Mechanisms that are struck: contacts and joints answer an impact at once (DD107)."""

import math

import numpy as np
import pytest

from tamias2d import Box, Disc, HalfPlane, Motor, Revolute, Scene, Simulator

G = 9.81
FALL = 3.0  # m/s, with which things land
SOLVED = 1e-2  # share of the rates at first that impacts may leave


def column(masses: list[float], friction: float, *, across: float = 0.0) -> Scene:
    """Boxes hinged one above the other, about to land on the lowest, a narrow one."""
    scene, surface = Scene(gravity=(0.0, -G)), {"friction": friction, "restitution": 0.0}
    scene.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    shape = Box(width=0.4, height=0.5)
    for k, mass in enumerate(masses):
        at = (0.0, 0.251 + 0.5 * k)
        scene.add_body(shape, mass=mass, position=at, velocity=(across, -FALL), group=-1, **surface)
    for k in range(len(masses) - 1):
        scene.add_joint(Revolute(), k + 1, k + 2, at=(0.0, 0.501 + 0.5 * k))
    return scene


@pytest.mark.parametrize("masses", [[1.0] * 3, [0.5, 2.0, 10.0, 30.0], [1.0, 100.0]])
def test_a_column_that_lands_stops_in_the_step_in_which_it_lands(masses: list[float]) -> None:
    """The floor tells the momentum of all of it; the lowest box alone has a small part of that."""
    sim = Simulator(column(masses, 0.6), time_step=1 / 60)
    sim.step()
    assert np.abs(sim.velocity[1:]).max() < 0.03 * FALL  # what loads give it while it lands
    total = sum(masses) * (FALL + G / 60)
    assert sim.contacts.impulse.sum() == pytest.approx(total, rel=0.03)
    sim.step(2)
    assert sim.position[1, 1] > 0.25 - 1e-2


@pytest.mark.parametrize("friction", [0.1, 0.3])
def test_friction_acts_by_the_impulse_of_the_impact(friction: float) -> None:
    """A column that lands sliding loses as much speed as friction takes of its fall (IM9)."""
    masses = [20.0, 1.0, 1.0]
    sim = Simulator(column(masses, friction, across=4.0), time_step=1 / 240)
    sim.step()
    mass = np.array(masses)
    lost = mass.sum() * 4.0 - float(mass @ sim.velocity[1:, 0])
    given = float(sim.contacts.impulse.sum())
    assert lost == pytest.approx(friction * given, rel=0.02)


def test_a_mechanism_that_strikes_another_stops_with_it() -> None:
    """Two columns of equal masses, one of which stands: both go on with half of the momentum."""
    scene, surface = Scene(gravity=(0.0, 0.0)), {"friction": 0.0, "restitution": 0.0}
    bar = Box(width=1.0, height=0.2)
    for k in range(6):
        velocity = (2.0, 0.0) if k < 3 else (0.0, 0.0)
        place = (1.0 * k + (1e-6 if k > 2 else 0.0), 0.0)
        group = -1 if k < 3 else -2
        scene.add_body(bar, mass=1.0, position=place, velocity=velocity, group=group, **surface)
    for k in (0, 1, 3, 4):
        at = (k + 0.5 + (1e-6 if k > 2 else 0.0), 0.0)
        scene.add_joint(Revolute(), k, k + 1, at=at)
    sim = Simulator(scene, time_step=1 / 60)
    sim.step()
    np.testing.assert_allclose(sim.velocity, np.full((6, 2), (1.0, 0.0)), atol=SOLVED)
    assert sim.contacts.impulse.sum() == pytest.approx(3.0, rel=SOLVED)


def test_a_rod_on_a_hinge_rebounds_by_the_restitution() -> None:
    """Its tip leaves with half of the speed with which it came, whatever else hangs on it."""
    scene, surface = Scene(gravity=(0.0, 0.0)), {"friction": 0.0, "restitution": 0.5}
    scene.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    rod = scene.add_body(
        Box(width=1.0, height=0.1), mass=1.0, position=(0.5, 0.3), angular_velocity=-2.0,
        velocity=(0.0, -1.0), orientation=0.0, **surface,
    )  # fmt: skip
    load = scene.add_body(
        Disc(radius=0.1), mass=30.0, position=(0.5, 0.3), velocity=(0.0, -1.0), group=-1, **surface
    )
    scene.add_joint(Revolute(), rod, (0.0, 0.3), at=(0.0, 0.3))
    scene.add_joint(Revolute(), rod, load, at=(0.5, 0.3))
    sim = Simulator(scene, time_step=1 / 240)
    met = False
    for _ in range(60):
        before = float(sim.angular_velocity[rod])
        sim.step()
        if len(sim.contacts):
            met = True
            assert float(sim.angular_velocity[rod]) == pytest.approx(-0.5 * before, rel=0.03)
            break
    assert met


def test_a_motor_with_a_maximum_gives_nothing_in_an_impact() -> None:
    """A wheel that is driven lands: what its motor gives in the step is no more than it can."""
    scene, surface = Scene(gravity=(0.0, -G)), {"friction": 1.0, "restitution": 0.0}
    scene.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    wheel = scene.add_body(
        Disc(radius=0.3), mass=2.0, position=(0.0, 0.301), velocity=(0.0, -FALL), group=-1,
        **surface,
    )  # fmt: skip
    cart = scene.add_body(
        Box(width=0.4, height=0.4), mass=20.0, position=(0.0, 0.301), velocity=(0.0, -FALL),
        group=-1, **surface,
    )  # fmt: skip
    motor = Motor(speed=50.0, maximum=3.0)
    scene.add_joint(Revolute(motor=motor), cart, wheel, at=(0.0, 0.301))
    sim = Simulator(scene, time_step=1 / 60)
    for _ in range(5):
        sim.step()
        assert abs(sim.reactions.torque[0, 1]) <= 3.0 * (1.0 + 1e-9)
        assert math.isfinite(sim.velocity[wheel, 0])
