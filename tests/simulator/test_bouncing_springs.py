"""Springs whose bodies bounce make no energy, and lose none by a bounce that keeps it (DD91)."""

import math

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.simulator import Simulator
from tamias2d.state import Array

STEPS = [1 / 60, 1 / 120, 1 / 240]
ROUNDED = 1e-9  # of the energy: what some thousand steps may add


def pair(stiffness: float, restitution: float, beside: float = 0.0) -> t2.Scene:
    """Two discs of 1 kg on a spring at rest, thrown at each other without gravity."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    surface = {"restitution": restitution, "friction": 0.4 if beside else 0.0}
    for x, y, vx in ((0.0, 0.0, 2.0), (0.45, beside, -2.0)):
        scene.add_body(
            t2.Disc(radius=0.2), mass=1.0, position=(x, y), velocity=(vx, 0.0), **surface
        )
    rest = math.hypot(0.45, beside)
    scene.add_spring(0, 1, stiffness=stiffness, rest_length=rest)
    return scene


def energy_of_pair(sim: Simulator, stiffness: float, rest: float) -> float:
    """J; the inertia of both is that of a disc of 1 kg and 0.2 m."""
    moving = 0.5 * (sim.velocity**2).sum() + 0.5 * 0.02 * (sim.angular_velocity**2).sum()
    apart = float(np.hypot(*(sim.position[1] - sim.position[0])))
    return float(moving + 0.5 * stiffness * (apart - rest) ** 2)


@pytest.mark.parametrize("time_step", STEPS)
@pytest.mark.parametrize("stiffness", [50.0, 300.0, 1000.0])
@pytest.mark.parametrize("restitution", [0.0, 0.5, 1.0])
def test_discs_on_a_spring_gain_nothing_as_they_strike(
    stiffness: float, restitution: float, time_step: float
) -> None:
    sim = t2.Simulator(pair(stiffness, restitution), time_step=time_step)
    first = energy_of_pair(sim, stiffness, 0.45)
    for _ in range(round(2.0 / time_step)):
        sim.step()
        assert energy_of_pair(sim, stiffness, 0.45) <= first * (1.0 + ROUNDED)
        assert np.abs(sim.velocity.sum(axis=0)).max() < 1e-12


def angular_error_of_pair(time_step: float) -> float:
    """Of discs that strike beside their centres for 4 s; their energy and momentum stay."""
    scene = pair(1000.0, 1.0, beside=0.1)
    sim = t2.Simulator(scene, time_step=time_step)
    rest = math.hypot(0.45, 0.1)
    first, turning, most = energy_of_pair(sim, 1000.0, rest), angular_momentum(sim), 0.0
    for _ in range(round(4.0 / time_step)):
        sim.step()
        assert energy_of_pair(sim, 1000.0, rest) <= first * (1.0 + ROUNDED)
        assert np.abs(sim.velocity.sum(axis=0)).max() < 1e-12
        most = max(most, abs(angular_momentum(sim) / turning - 1.0))
    return most


def test_discs_that_strike_beside_their_centres_turn_on_to_second_order() -> None:
    """The held force lies along the line of the way that would have been gone without the impact.

    So angular momentum errs with the square of the step at each, and more impacts are solved
    in shorter steps; a fourth of the step has a fourteenth of the error at least.
    """
    coarse, fine = angular_error_of_pair(1 / 60), angular_error_of_pair(1 / 240)
    assert coarse < 0.05
    assert fine < coarse / 14.0


def angular_momentum(sim: Simulator) -> float:
    """kg m^2/s, about the origin."""
    (x, y), (vx, vy) = sim.position.T, sim.velocity.T
    about = (x * vy - y * vx).sum()
    return float(about + 0.02 * sim.angular_velocity.sum())


def energies_of_ball(stiffness: float, time_step: float, jointed: bool, duration: float) -> Array:
    """The energies, J, of a ball of 1 kg that bounces under a spring, over that at first."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    surface = {"restitution": 1.0, "friction": 0.0}
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    ball = scene.add_body(
        t2.Disc(radius=0.2), mass=1.0, position=(0.0, 0.8), velocity=(0.0, -3.0), **surface
    )
    if not jointed:
        scene.add_spring(ball, (0.0, 1.5), stiffness=stiffness, rest_length=1.0)
    sim = t2.Simulator(scene, time_step=time_step)
    if jointed:
        spring = t2.JointSpring(stiffness=stiffness, damping=0.0, rest=1.0)
        sim.add_joint(t2.Distance(spring=spring), (0.0, 1.5), ball)
    found = []
    for _ in range(round(duration / time_step)):
        y, speed = sim.position[ball, 1], sim.velocity[ball, 1]
        found.append(speed**2 / 2 + 9.81 * (y - 0.2) + stiffness * (0.5 - y) ** 2 / 2)
        sim.step()
    return np.array(found) / found[0]


@pytest.mark.parametrize("time_step", STEPS)
@pytest.mark.parametrize("stiffness", [50.0, 200.0, 1000.0])
@pytest.mark.parametrize("jointed", [False, True])
def test_a_ball_under_a_spring_gains_nothing_as_it_bounces(
    stiffness: float, time_step: float, jointed: bool
) -> None:
    assert energies_of_ball(stiffness, time_step, jointed, 10.0).max() <= 1.0 + ROUNDED


@pytest.mark.parametrize("time_step", STEPS)
def test_a_ball_under_a_soft_spring_keeps_its_energy_as_it_bounces(time_step: float) -> None:
    """By 19 bounces; a phase of 0.1 in a step of 1/60 s."""
    assert energies_of_ball(36.0, time_step, False, 10.0)[-1] > 0.99


@pytest.mark.parametrize("pulse", [4.0, 8.0])
def test_what_swings_on_a_box_that_rests_swings_on(pulse: float) -> None:
    """For 10 s; a box of 5 kg on a board, and 1 kg on a spring below both."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    surface = {"restitution": 0.0, "friction": 0.5}
    scene.add_static(t2.Box(width=2.0, height=0.2), position=(0.0, -0.1), **surface)
    box = t2.Box(width=0.4, height=0.4)
    scene.add_body(box, mass=5.0, position=(0.0, 0.2), **surface)
    middle, reach = -1.5 - 9.81 / pulse**2, 0.5 * 9.81 / pulse**2
    low = (0.0, middle + reach)
    scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=low, **surface)
    scene.add_spring(1, 2, stiffness=pulse**2, rest_length=1.7)
    sim = t2.Simulator(scene)
    sim.step(540)
    swung = []
    for _ in range(120):
        sim.step()
        swung.append(abs(sim.position[2, 1] - middle))
    assert max(swung) == pytest.approx(reach, rel=0.05)


def test_a_network_that_a_joint_holds_is_not_flown() -> None:
    """A rod on a hinge, from which a disc hangs on a spring: no contact acts as it flies up."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    surface = {"restitution": 1.0, "friction": 0.3}
    rod = t2.Box(width=0.8, height=0.2)
    scene.add_body(rod, mass=1.0, position=(0.4, 0.0), **surface)
    scene.add_body(t2.Disc(radius=0.2), mass=1.0, position=(1.0, -1.0), **surface)
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=-1.3), **surface)
    scene.add_spring(0, 1, stiffness=40.0, rest_length=0.6, anchor=(0.3, 0.0))
    sim = t2.Simulator(scene)
    sim.add_joint(t2.Revolute(), 0, (0.0, 0.0), anchor=(-0.4, 0.0))
    sim.step(45)
    assert not sim.warnings  # the joint is nowhere apart by what is told
