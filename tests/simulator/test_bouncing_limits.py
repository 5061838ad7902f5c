"""Limits that bounce, and limits that are far away, in the frame loop (IM15, GD21)."""

import math
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tests.engine.scenes import plain
from tools.measurements.mechanisms.faults import Energy
from tools.measurements.mechanisms.programs import rates_of
from tools.measurements.mechanisms.random_mechanism import LIMITS, random_mechanism

G = 9.81


def swing(limits: Any) -> t2.Scene:
    """A bob on an arm that starts level, and may turn so far."""
    scene = t2.Scene(gravity=(0.0, -G))
    scene.add_body(None, mass=1.0, inertia=0.1, position=(1.0, 0.0))
    scene.add_joint(t2.Revolute(limits=limits), (0.0, 0.0), 0, other_anchor=(-1.0, 0.0))
    return scene


def drop(restitution: float) -> t2.Scene:
    """A body on an upright guide with an end 1 m below."""
    scene = t2.Scene(gravity=(0.0, -G))
    scene.add_body(None, mass=1.0, inertia=0.1, position=(0.0, 0.0))
    limits = t2.Limits(lower=-1.0, restitution=restitution)
    scene.add_joint(t2.Prismatic(axis=(0.0, 1.0), limits=limits), (0.0, 0.0), 0)
    return scene


def rope(restitution: float) -> t2.Scene:
    """A bob that falls into a slack rope, aside."""
    scene = t2.Scene(gravity=(0.0, -G))
    scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=(0.3, -0.5), restitution=0.0)
    scene.add_joint(
        t2.Distance(limits=t2.Limits(upper=1.0, restitution=restitution)), (0.0, 0.0), 0
    )
    return scene


def elbow(restitution: float) -> t2.Scene:
    """An arm of two parts, whose elbow may turn by a little to both sides."""
    scene = t2.Scene(gravity=(0.0, -G))
    for x in (1.0, 2.0):
        scene.add_body(None, mass=1.0, inertia=0.1, position=(x, 0.0))
    scene.add_joint(t2.Revolute(), (0.0, 0.0), 0, other_anchor=(-1.0, 0.0))
    limits = t2.Limits(lower=-0.4, upper=0.4, restitution=restitution)
    arms: Any = {"anchor": (0.5, 0.0), "other_anchor": (-0.5, 0.0)}
    scene.add_joint(t2.Revolute(limits=limits), 0, 1, **arms)
    return scene


def energy(sim: t2.Simulator) -> float:
    """Return the energy of bodies of 1 kg and 0.1 kg m^2 in the pull of the earth, J."""
    moving = float((sim.velocity**2).sum() + 0.1 * (sim.angular_velocity**2).sum()) / 2
    return moving + G * float(sim.position[:, 1].sum())


@pytest.mark.parametrize("make", [lambda e: swing(t2.Limits(lower=-1.2, restitution=e)), drop])
@pytest.mark.parametrize("restitution", [0.3, 0.8, 1.0])
def test_the_first_bounce_is_that_of_theory(make: Any, restitution: float) -> None:
    """At the limit it has the speed of its fall, and leaves it with that times the restitution."""
    sim = plain(make(restitution), time_step=1 / 120)
    away = 0.0
    while away <= 0.0:
        sim.step()
        away = sim.angular_velocity[0] if make is not drop else sim.velocity[0, 1]
    before = math.sqrt(2 * G * -sim.position[0, 1] / (1.0 if make is drop else 1.1))
    assert away == pytest.approx(restitution * before, rel=2e-3)  # order one, in steps


@pytest.mark.parametrize("make", [drop, rope, elbow])
@pytest.mark.parametrize("restitution", [0.0, 0.5, 1.0])
def test_bounces_gain_no_energy_and_stop_at_the_limit(make: Any, restitution: float) -> None:
    sim = plain(make(restitution))
    start, bent = energy(sim), 0.0
    for _ in range(240):
        sim.step()
        assert energy(sim) <= start + 1e-8
        bent = max(bent, float(np.ptp(sim.orientation)))
    if make is drop and restitution < 1.0:
        assert sim.position[0, 1] == pytest.approx(-1.0, abs=1e-6)
        assert abs(sim.velocity[0, 1]) < 1e-6
    if make is rope:
        assert np.hypot(*sim.position[0]) < 1.0 + 1e-6
    if make is elbow:
        assert bent < 0.4 + 1e-6


@pytest.mark.parametrize("restitution", [0.5, 1.0])
def test_bounces_converge_to_the_exact_way(restitution: float) -> None:
    exact = t2.simulate(elbow(restitution), duration=0.5, tolerance=1e-9).position[-1]
    errors = []
    for steps in (60, 240, 960):
        sim = plain(elbow(restitution), time_step=1 / steps)
        sim.step(steps // 2)
        errors.append(float(np.abs(sim.position - exact).max()))
    assert errors[0] < 0.01
    assert errors[2] < errors[0] / 4  # order one, whatever the phase of the step


def test_a_limit_that_is_leaned_on_does_not_bounce() -> None:
    sim = plain(swing(t2.Limits(lower=0.0, restitution=1.0)))
    for _ in range(120):
        sim.step()
        assert abs(sim.orientation[0]) < 1e-9
        assert abs(sim.angular_velocity[0]) < 1e-8  # half a kick, by how firm a row is


def test_a_limit_that_is_far_away_changes_nothing() -> None:
    """A swing lost a tenth of its energy in ten seconds to a limit that it never reached."""
    sim = plain(swing(t2.Limits(lower=-9.0, restitution=0.5)))
    start = energy(sim)
    sim.step(600)
    assert start - 0.01 < energy(sim) <= start + 1e-8


def test_a_ratchet_that_bounces_clicks() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    wheel: Any = {"position": (0.0, 0.0), "inertia": 1.0, "angular_velocity": 1.0}
    scene.add_body(None, mass=1.0, **wheel)
    scene.add_joint(t2.Revolute(), (0.0, 0.0), 0)
    scene.add_joint(t2.Ratchet(pitch=0.5, restitution=0.5), (0.0, 0.0), 0)
    sim = plain(scene)
    sim.step(72)
    sim.angular_velocity[0] = -1.0
    sim.step(60)
    assert sim.angular_velocity[0] == pytest.approx(0.5, abs=1e-8)  # as firm as a row is
    assert sim.orientation[0] > 1.0


def test_compiled_bounces_have_the_bits_of_plain_ones() -> None:
    compiled, simple = t2.Simulator(elbow(0.7)), plain(elbow(0.7))
    compiled.step(90)
    simple.step(90)
    assert compiled.position.tobytes() == simple.position.tobytes()


@pytest.mark.parametrize(("stiffness", "restitution", "speed"), [(1e4, 0.5, 0.5), (1e5, 0.1, 0.27)])
def test_a_spring_that_pushes_off_a_limit_adds_to_the_bounce(
    stiffness: float, restitution: float, speed: float
) -> None:
    """A body strikes at 1 m/s; the spring lets go of the limit before the step ends."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    bob: Any = {"position": (0.0, 0.003), "velocity": (0.0, -1.0), "inertia": 0.1}
    scene.add_body(None, mass=1.0, **bob)
    limits = t2.Limits(lower=-0.005, restitution=restitution)
    spring = t2.JointSpring(stiffness=stiffness, damping=0.0, rest=-0.003)
    guide = t2.Prismatic(axis=(0.0, 1.0), limits=limits, spring=spring)
    scene.add_joint(guide, (0.0, 0.003), 0)
    sim = plain(scene)
    sim.step()
    assert sim.velocity[0, 1] == pytest.approx(speed, rel=0.05)


@pytest.mark.parametrize("seed", [7100198, 7100392])
@pytest.mark.filterwarnings("ignore::tamias2d.errors.StepWarning")
def test_limits_that_pinch_a_loop_give_it_no_energy(seed: int) -> None:
    """Its rows yield (DD86), and were pulled together by energy that nothing drives it with."""
    scene = random_mechanism(seed, LIMITS)
    seen, sim = Energy(scene), t2.Simulator(scene)
    for _ in range(300):
        sim.step()
        seen.look(np.column_stack((sim.position, sim.orientation)), rates_of(sim))
    assert seen.above < 1e-9
