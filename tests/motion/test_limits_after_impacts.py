"""Joints that expect something, and an impact that comes before it, against closed forms."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import tamias2d as t2
from tamias2d.run import Run
from tamias2d.state import Array

RADIUS, LIGHT, HEAVY, MET, STOP = 0.1, 0.5, 4.0, 0.499, 0.5
INERTIA = 1.0 + RADIUS**2 / 2
WAYS: list[dict[str, Any]] = [
    {"method": t2.Reference()},
    {"method": t2.Dop853(rtol=1e-9)},
    {"method": t2.RungeKutta4(), "time_step": 0.05},
]


def bob(joint: t2.Revolute | t2.Rotary | t2.Ratchet, free: float = LIGHT) -> t2.Scene:
    """A disc at 1 m from its hinge, which turns at 1 rad/s and meets a free one at 0.499 rad."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    disc = t2.Disc(radius=RADIUS)
    scene.add_body(
        disc, mass=1.0, position=(1, 0), velocity=(0, 1), angular_velocity=1.0, restitution=1.0
    )
    outwards = np.array([math.cos(MET), math.sin(MET)])
    ahead = np.array([-outwards[1], outwards[0]])
    scene.add_body(disc, mass=free, position=outwards + 2 * RADIUS * ahead, restitution=1.0)
    scene.add_joint(t2.Revolute(), (0.0, 0.0), 0, other_anchor=(-1.0, 0.0))
    scene.add_joint(joint, (0.0, 0.0), 0)
    return scene


def turned_on(free: float = LIGHT) -> float:
    """The angular velocity after the impact: of an elastic one with an inertia about the hinge."""
    return 1 - 2 / (1 / INERTIA + 1 / free) / INERTIA


def near(way: dict[str, Any]) -> float:
    """Of an angle or a time: steps of 0.05 s err by the fourth power of them."""
    return 1e-8 if "time_step" in way else 1e-10


@pytest.mark.parametrize("way", [*WAYS, {"tolerance": 1e-6}])
def test_a_stop_is_met_as_late_as_the_impact_before_it_says(way: dict[str, Any]) -> None:
    scene = bob(t2.Rotary(limits=t2.Limits(upper=STOP, restitution=1.0)))
    run = t2.simulate(scene, duration=0.52, times=[0.0, 0.52], **way)
    met = MET + (STOP - MET) / turned_on()
    assert run.joint_events.time == pytest.approx([met], abs=near(way))
    angle = STOP - (0.52 - met) * turned_on()
    assert run.orientation[-1, 0] == pytest.approx(angle, abs=near(way))


@pytest.mark.parametrize("way", WAYS)
def test_a_ratchet_clicks_as_late_as_the_impact_before_says(way: dict[str, Any]) -> None:
    run = t2.simulate(bob(t2.Ratchet(pitch=STOP, restitution=0.0)), duration=0.52, **way)
    late = MET + (STOP - MET) / turned_on()
    assert run.joint_events.time == pytest.approx([0.0, late], abs=near(way))


@pytest.mark.parametrize("way", WAYS[:2])
def test_a_brake_that_slips_turns_round_at_an_impact_that_throws_back(way: dict[str, Any]) -> None:
    """It takes M/I from the rate of either sense, and gives no impulse."""
    slowing = 0.5 / INERTIA
    brake = t2.Rotary(motor=t2.Motor(speed=0.0, maximum=0.5))
    run = t2.simulate(bob(brake, HEAVY), duration=2.0, times=[0.0, 2.0], **way)
    before = math.sqrt(1 - 2 * slowing * MET)
    back = turned_on(HEAVY) * before
    met = (1 - before) / slowing
    assert back < 0
    assert run.joint_events.time == pytest.approx([0.0, met, met - back / slowing], abs=near(way))
    assert run.joint_events.words[1:] == (
        "pushes with the maximum of its motor",
        "keeps the speed of its motor",
    )
    assert run.orientation[-1, 0] == pytest.approx(MET - back**2 / slowing / 2, abs=near(way))


def swung(joint: t2.Distance, *, spring: float = 0.0, **breaks: float) -> t2.Scene:
    """A disc that a joint holds 1 m from the origin, at 1 rad/s; one hits it at 0.5 s from behind.

    They are equal and elastic: it goes on at 3 rad/s. There may be a spring to the origin.
    """
    scene = t2.Scene(gravity=(0.0, 0.0))
    disc = t2.Disc(radius=RADIUS)
    scene.add_body(disc, mass=1.0, position=(1, 0), velocity=(0, 1), restitution=1.0)
    ahead = np.array([-math.sin(0.5), math.cos(0.5)])
    scene.add_body(
        disc,
        mass=1.0,
        position=np.array([math.cos(0.5), math.sin(0.5)]) - (2 * RADIUS + 3 * 0.5) * ahead,
        velocity=3 * ahead,
        restitution=1.0,
    )
    scene.add_joint(joint, 0, (0.0, 0.0), **breaks)
    if spring:
        scene.add_spring(0, (0.0, 0.0), stiffness=spring, rest_length=0.5)
    return scene


def swung_on(run: Run, pull: Callable[[float], float]) -> float:
    """How far, m, it is from where scipy takes it under a pull to the origin."""

    def rates(_: float, y: Array) -> Array:
        r = math.hypot(y[0], y[1])
        return np.array([y[2], y[3], -pull(r) * y[0] / r, -pull(r) * y[1] / r])

    c, s = math.cos(0.5), math.sin(0.5)
    start, end = [c, s, -3 * s, 3 * c], run.times[-1]
    path = solve_ivp(rates, (0.5, end), start, method="DOP853", rtol=1e-12, atol=1e-13)
    return float(np.abs(path.y[:2, -1] - run.position[-1, 0]).max())


@pytest.mark.parametrize("way", WAYS[:2])
def test_a_limit_that_would_have_to_pull_after_an_impact_is_left_at_it(
    way: dict[str, Any],
) -> None:
    """The spring pulls with 2 N; to keep 1 m takes 1 N before, 9 N after."""
    strut = t2.Distance(limits=t2.Limits(lower=1.0, restitution=0.0))
    run = t2.simulate(swung(strut, spring=4.0), duration=0.8, times=[0.0, 0.8], **way)
    assert run.joint_events.time == pytest.approx([0.0, 0.5], abs=near(way))
    assert run.joint_events.words[1] == "leaves its lower limit"
    assert swung_on(run, lambda r: 4 * (r - 0.5)) < 1e-9


@pytest.mark.parametrize("way", WAYS[:2])
def test_a_motor_that_an_impact_overburdens_gives_way_at_it(way: dict[str, Any]) -> None:
    hold = t2.Distance(motor=t2.Motor(speed=0.0, maximum=4.0))
    run = t2.simulate(swung(hold), duration=0.8, times=[0.0, 0.8], **way)
    assert run.joint_events.time == pytest.approx([0.0, 0.5], abs=near(way))
    assert run.joint_events.words[1] == "pushes back with the maximum of its motor"
    assert swung_on(run, lambda _: 4.0) < 1e-9


@pytest.mark.parametrize("way", WAYS[:2])
def test_a_joint_that_an_impact_overburdens_breaks_at_it(way: dict[str, Any]) -> None:
    scene = swung(t2.Distance(length=1.0), break_force=4.0)
    run = t2.simulate(scene, duration=0.8, times=[0.0, 0.8], **way)
    assert run.joint_events.time == pytest.approx([0.5], abs=near(way))
    assert run.joint_events.words == ("breaks",)
    assert swung_on(run, lambda _: 0.0) < 1e-9
