"""Attraction, fields, laws and quadratic drag in the frame loop: kicks at both ends of a step."""

import math
import warnings

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import tamias2d as t2
from tamias2d.scene import catalogue
from tamias2d.simulator import Simulator

SURFACE = {"friction": 0.0, "restitution": 0.0}
QUIET = {"radius": 0.01}


def one(**given: object) -> t2.Scene:
    scene = t2.Scene(gravity=(0.0, 0.0))
    body: dict[str, object] = {"mass": 1.0, "position": (0.0, 0.0), **SURFACE, **given}
    scene.add_body(t2.Disc(**QUIET), name="bob", **body)  # type: ignore[arg-type]
    return scene


def test_an_orbit_in_a_field_keeps_its_energy() -> None:
    """Kepler's ellipse of eccentricity 0.6, 1e5 steps: the energy swings and does not drift."""
    sim = Simulator(catalogue.load("kepler"))

    def energy() -> float:
        velocity, place = sim.velocity[0], sim.position[0]
        return float(0.5 * velocity @ velocity - 1.0 / math.hypot(*place))

    start = energy()
    off = np.zeros(100_000)
    for k in range(len(off)):
        sim.step()
        off[k] = energy() - start
    early, late = np.abs(off[:10_000]).max(), np.abs(off[-10_000:]).max()
    assert early < 0.005 * abs(start)
    assert late < 1.1 * early


def test_attraction_keeps_energy_and_momenta() -> None:
    sim = Simulator(catalogue.load("two-body"))
    mass = np.array([3.0, 1.0])

    def totals() -> tuple[float, float, float]:
        x, v = sim.position, sim.velocity
        energy = 0.5 * float(mass @ (v**2).sum(axis=1)) - 3.0 / math.dist(*x)
        turning = float(mass @ (x[:, 0] * v[:, 1] - x[:, 1] * v[:, 0]))
        return energy, turning, float(np.abs(mass @ v).max())

    energy, turning, _ = totals()
    for _ in range(20):
        sim.step(500)
        now = totals()
        assert now[0] == pytest.approx(energy, rel=1e-6)
        assert now[1] == pytest.approx(turning, rel=1e-11)
        assert now[2] < 1e-11


def test_a_law_of_the_velocity_turns_it_and_gains_nothing() -> None:
    """A charge in a magnetic field runs on a circle; the speed stays, to the last rounds."""
    force = ("5[kg/s]*y(velocity)", "-5[kg/s]*x(velocity)")
    sim = Simulator(one(velocity=(1.0, 0.0), force=force))
    sim.step(5000)
    assert math.hypot(*sim.velocity[0]) == pytest.approx(1.0, rel=1e-9)


def test_a_spring_that_is_a_law_of_the_angle_keeps_its_energy() -> None:
    """A torque of -k phi: an oscillator of the angle (OA9)."""
    scene = one(torque="-1e-4[N*m/rad]*orientation", orientation=1.0, inertia=1e-4)
    sim = Simulator(scene)
    for _ in range(10):
        sim.step(1000)
        energy = sim.angular_velocity[0] ** 2 + sim.orientation[0] ** 2
        assert energy == pytest.approx(1.0, rel=1e-3)


def test_the_order_is_two() -> None:
    force = ("-4[N/m]*x(position)*cos(1[rad/s]*time)", "-1[kg/s]*y(velocity)+1[N]")
    scene = one(position=(1.0, 0.0), velocity=(0.0, 1.0), force=force, quadratic_drag=0.5)
    exact = t2.simulate(scene, duration=1.0, method=t2.Reference(), times=[1.0])
    errors = []
    for steps in (60, 120, 240):
        sim = Simulator(scene, time_step=1 / steps)
        sim.step(steps)
        errors.append(float(np.abs(sim.position - exact.position[-1]).max()))
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.15)
    assert errors[1] / errors[2] == pytest.approx(4.0, rel=0.1)


# -- quadratic drag


@settings(max_examples=50, deadline=None)
@given(st.floats(1e-3, 1e12), st.floats(1e-3, 1e3), st.floats(0.0, 100.0), st.floats(1e-4, 1.0))
def test_quadratic_drag_never_turns_a_velocity_round(
    quadratic: float, speed: float, linear: float, time_step: float
) -> None:
    scene = one(velocity=(speed, 0.5 * speed), quadratic_drag=quadratic, linear_drag=linear)
    sim = Simulator(scene, time_step=time_step)
    before = sim.velocity[0].copy()
    for _ in range(5):
        sim.step()
        assert (sim.velocity[0] >= 0.0).all()
        assert (sim.velocity[0] <= before).all()
        before = sim.velocity[0].copy()


def test_quadratic_drag_alone_is_exact() -> None:
    """v = v0/(1 + c v0 t/m) (taylor2005), at any step."""
    for time_step in (0.01, 1.0):
        sim = Simulator(one(velocity=(10.0, 0.0), quadratic_drag=3.0), time_step=time_step)
        sim.step(round(5.0 / time_step))
        assert sim.velocity[0, 0] == pytest.approx(10.0 / (1.0 + 3.0 * 10.0 * 5.0), rel=1e-12)


def test_a_step_that_is_refused_leaves_velocities_under_drag_as_they_were() -> None:
    sim = Simulator(one(velocity=(10.0, 0.0), quadratic_drag=3.0))
    sim.step()
    velocity = sim.velocity.copy()
    sim.force[0] = (math.nan, 0.0)
    with pytest.raises(t2.InputError):
        sim.step()
    np.testing.assert_array_equal(sim.velocity, velocity)


# -- steps that are too long


@pytest.mark.parametrize(("stiffness", "warns"), [(14_000, False), (15_000, True)])
def test_a_step_beyond_the_critical_one_is_told(stiffness: int, warns: bool) -> None:
    """2/sqrt(k/m) is 1/60 s at k/m = 14 400 1/s^2; the energy grows there, and not below."""
    law = (f"-{stiffness}[N/m]*x(position)", "0[N]")
    sim = Simulator(one(position=(0.1, 0.0), force=law))
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        sim.step(40)
    assert (np.abs(sim.position[0, 0]) > 1.0) == warns
    texts = [str(one.message) for one in told]
    assert len(texts) == warns
    if warns:
        assert told[0].category is t2.StepWarning
        assert told[0].filename == __file__
        assert "force[0] of body 'bob'" in texts[0]
        assert "0.0166667 s" in texts[0]
        assert f"{2 / math.sqrt(stiffness):.3g} s" in texts[0]
    assert list(sim.warnings) == texts


def test_a_run_by_steps_notes_what_it_was_warned_of() -> None:
    scene = one(position=(0.1, 0.0), force=("-20000[N/m]*x(position)", "0[N]"))
    with pytest.warns(t2.StepWarning):
        run = t2.simulate(scene, duration=0.1, method=t2.Stepped(), time_step=1 / 60)
    assert any("force[0] of body 'bob'" in note for note in run.notes)


def test_a_torque_beyond_its_critical_step_is_told() -> None:
    law = "-2[N*m/rad]*orientation"
    sim = Simulator(one(orientation=0.1, torque=law, inertia=1e-4))
    with pytest.warns(t2.StepWarning, match="torque of body 'bob'"):
        sim.step()


def test_what_varies_with_time_alone_is_not_told() -> None:
    sim = Simulator(one(force=("1e6[N]*sin(1000[rad/s]*time)", "-1[kg/s]*y(velocity)")))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        sim.step(100)


def test_compiled_and_plain_have_the_same_bits() -> None:
    for name in ("kepler", "two-body", "quadratic-drag", "own-law"):
        scene = catalogue.load(name)
        one, other = Simulator(scene), Simulator(scene, compiled=False)
        for _ in range(20):
            one.step()
            other.step()
        assert one.digest() == other.digest()


def test_what_rests_in_a_field_falls_asleep() -> None:
    """A magnet under the floor: the force does not change, and nothing is put right."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), friction=0.5, restitution=0.0)
    box = t2.Box(width=1.0, height=1.0)
    scene.add_body(box, mass=1.0, position=(0.0, 0.5), friction=0.5, restitution=0.0)
    scene.add_field(force=("0[N]", "-5[N*m^2]/(1[m]+y(position))**2"))
    sim = Simulator(scene, sleeping=True)
    sim.step(600)
    assert sim.asleep[1]
