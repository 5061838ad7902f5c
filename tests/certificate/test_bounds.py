"""Bounds hold against answers that are known otherwise, and would not if they were much smaller."""

import math
from dataclasses import replace
from fractions import Fraction
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from hypothesis import example, given, settings, strategies as st
from scipy.integrate import solve_ivp

import tamias2d as t2
from tamias2d.state import Array
from tamias2d.study.error import history_error
from tools.measurements import held_out
from tools.measurements.exact import exact_history
from tools.measurements.kinds import energy_error, lost

G = 9.81


def exact(run: t2.Run) -> t2.Run:
    """The run with the places that 40 digits give."""
    position, orientation = exact_history(run.scene, run.times)
    return replace(run, position=position, orientation=orientation)


def error_and_bound(run: t2.Run, true: t2.Run) -> tuple[float, float]:
    certified = t2.certify(run).certificate
    assert certified is not None
    assert certified.bound is not None
    return history_error(run, true), certified.bound


def thrown(drag: float, speed: float, angle: float) -> t2.Scene:
    scene = t2.Scene(gravity=(0.0, -G))
    velocity = (speed * math.cos(angle), speed * math.sin(angle))
    scene.add_body(None, mass=1.0, position=(0.0, 1.0), velocity=velocity, linear_drag=drag)
    return scene


FINITE = {"allow_nan": False, "allow_infinity": False}
speeds = st.floats(1.0, 50.0, **FINITE)
angles = st.floats(0.1, 3.0, **FINITE)


@settings(max_examples=12, deadline=None)
@given(speeds, angles, st.floats(0.05, 3.0, **FINITE))
def test_step_doubling_bounds_a_throw_with_drag(speed: float, angle: float, drag: float) -> None:
    scene = thrown(drag, speed, angle)
    times = np.linspace(0.0, 2.0, 33)
    for method in (t2.RungeKutta4(), t2.VelocityVerlet()):
        run = t2.simulate(scene, duration=2.0, method=method, time_step=2 / 64, times=times)
        error, bound = error_and_bound(run, exact(run))
        assert error <= bound <= max(10 * error, 1e-13)
        assert error > bound / 100  # a hundredth of it would claim too much


@example(speed=34.0, angle=0.5, drag=0.0625, rtol=1e-3)  # few steps: a tighter rtol has the same
@settings(max_examples=12, deadline=None)
@given(speeds, angles, st.floats(0.05, 3.0, **FINITE), st.sampled_from([1e-3, 1e-6, 1e-9]))
def test_embedded_bounds_a_throw_with_drag(
    speed: float, angle: float, drag: float, rtol: float
) -> None:
    times = np.linspace(0.0, 2.0, 33)
    scene = thrown(drag, speed, angle)
    run = t2.simulate(scene, duration=2.0, method=t2.DormandPrince5(rtol=rtol), times=times)
    error, bound = error_and_bound(run, exact(run))
    assert error <= bound


@settings(max_examples=25, deadline=None)
@given(st.floats(0.5, 3.0, **FINITE), st.floats(-2.0, 2.0, **FINITE), st.floats(0.5, 1.0, **FINITE))
def test_exact_bounds_bounces(height: float, along: float, restitution: float) -> None:
    scene = t2.Scene(gravity=(0.0, -G))
    disc = t2.Disc(radius=0.1)
    scene.add_body(
        disc, mass=1.0, position=(0.0, height), velocity=(along, 0.0), restitution=restitution
    )
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0))
    run = t2.simulate(scene, duration=2.0)
    error, bound = error_and_bound(run, exact(run))
    assert error <= bound < 1e-10


@pytest.mark.parametrize("name", ["billiard", "galperin-100", "bouncing-elastic", "oblique-discs"])
def test_exact_bounds_scenes_of_the_catalogue(name: str) -> None:
    scene = t2.catalogue.load(name)
    run = t2.simulate(scene, duration=scene.duration or 1.0)
    error, bound = error_and_bound(run, exact(run))
    assert error <= bound
    if error > 1e-14:
        assert error > bound / 100


def test_a_run_that_does_not_converge_has_no_bound() -> None:
    scene = t2.catalogue.load("tc1")
    run = t2.simulate(scene, duration=1.0, method=t2.Legacy2018(), time_step=0.1)
    certificate = t2.certify(run).certificate
    assert certificate is not None
    assert not certificate.meets(1.0)
    assert "inconsistent" in str(certificate)


@pytest.mark.parametrize("name", ["tc2", "tc4", "tc6", "tc9", "projectiles"])
def test_steps_that_are_exact_are_bounded_by_their_rounding(name: str) -> None:
    scene = t2.catalogue.load(name)
    for method in (t2.RungeKutta4(), t2.VelocityVerlet()):
        run = t2.simulate(
            scene,
            duration=10.0,
            method=method,
            time_step=10 / 64,
            times=np.linspace(0.0, 10.0, 65),
        )
        error, bound = error_and_bound(run, exact(run))
        assert error <= bound < 3e-12


def test_a_bound_beyond_the_motion_itself_is_none() -> None:
    """An ellipse of eccentricity 0.74 in 64 steps: the planet is flung off, and steps agree."""
    scene = next(one for one in held_out.scenes() if one.name == "orbit 3")
    run = t2.simulate(scene, duration=scene.duration, method=t2.VelocityVerlet(), time_step=0.3)
    certificate = t2.certify(run).certificate
    assert certificate is not None
    assert certificate.kind in ("invariants", "none")
    assert not certificate.meets(10.0)


def test_past_the_horizon_only_invariants_are_claimed() -> None:
    """Discs between round posts: each hit makes a small change some ten times larger."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(
        t2.Disc(radius=0.1), mass=1.0, position=(0.0, 0.1), velocity=(3.0, 0.4), restitution=1.0
    )
    posts = [(x, y) for x in (-1.0, 0.0, 1.0) for y in (-1.0, 0.0, 1.0) if (x, y) != (0.0, 0.0)]
    for post in [*posts, (0.0, -0.6)]:
        scene.add_static(t2.Disc(radius=0.25), position=post)
    for normal in ((1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)):
        scene.add_static(t2.HalfPlane(normal=normal, offset=-1.5))
    certificate = t2.certify(t2.simulate(scene, duration=20.0)).certificate
    assert certificate is not None
    assert certificate.kind == "invariants"
    assert certificate.bound is not None
    assert certificate.bound < 1e-12
    assert certificate.predictability_horizon is not None
    assert 1.0 < certificate.predictability_horizon < 15.0
    assert not certificate.meets(1e-2)
    with pytest.raises(t2.ToleranceError, match="no method meets it"):
        t2.simulate(scene, duration=20.0, tolerance=1e-2)


@pytest.mark.parametrize("which", [0, 4])
def test_energy_bounds_hold_to_the_last_digit(which: int) -> None:
    """The energy of the states, in 40 digits, strays no farther than the certificate says."""
    scene = list(lost())[which]
    times = np.linspace(0.0, 20.0, 61)
    certificate = t2.certify(t2.simulate(scene, duration=20.0, times=times)).certificate
    assert certificate is not None
    assert certificate.kind == "invariants"
    assert certificate.bound is not None
    run = t2.simulate(scene, duration=20.0, times=times)
    assert energy_error(run) <= certificate.bound < 1e-13


@pytest.mark.parametrize("seed", range(20))
def test_a_box_that_slides_on_a_box_is_within_rounding(seed: int) -> None:
    """Contacts that couple bodies round in every step; the closed form is in whole fractions."""
    chance = np.random.default_rng(seed)
    long, high, friction, speed = chance.uniform((4.0, 0.3, 0.05, 0.5), (8.0, 1.0, 0.4, 3.0))
    surface = {"restitution": 0.0, "friction": float(friction)}
    scene = t2.Scene(gravity=(0.0, -G))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), restitution=0.0, friction=0.9)
    scene.add_body(t2.Box(width=long, height=high), mass=10.0, position=(0, high / 2), **surface)
    start = float(-long / 2 + 0.4), float(high + 0.1)
    box = scene.add_body(
        t2.Box(width=0.4, height=0.2), mass=1.0, position=start, velocity=(speed, 0), **surface
    )
    run = t2.certify(t2.simulate(scene, duration=3.0, method=t2.ClosedForm()))
    assert run.certificate is not None
    assert run.certificate.bound is not None
    slowing = Fraction(float(friction)) * Fraction(G)
    stop = Fraction(float(speed)) / slowing
    moving = [min(Fraction(float(time)), stop) for time in run.times]
    exact_places = [Fraction(start[0]) + (stop - t / 2) * slowing * t for t in moving]
    places = run.position[:, box, 0].tolist()
    error = max(abs(Fraction(x) - y) for x, y in zip(places, exact_places, strict=True))
    assert float(error) / np.ptp(places) <= run.certificate.bound < 5e-13


@pytest.mark.parametrize("tolerance", [1e-3, 1e-6, 1e-9])
@pytest.mark.parametrize("stiffness", [5.0, 30.0, 100.0])
def test_few_steps_that_a_tighter_tolerance_repeats_are_not_believed(
    tolerance: float, stiffness: float
) -> None:
    """A cosine on a spring down to a limit, which cuts the steps of both runs, and rest on it."""
    scene = t2.Scene(gravity=(0.0, -G))
    scene.add_body(None, mass=1.0, inertia=1.0, position=(0.0, 0.5))
    spring = t2.JointSpring(stiffness=stiffness, rest=-0.1)
    limits = t2.Limits(lower=0.0, restitution=0.0)
    scene.add_joint(t2.Prismatic(axis=(0.0, 1.0), limits=limits, spring=spring), (0.0, 0.0), 0)
    times = np.linspace(0.0, 1.0, 61)
    run = t2.simulate(scene, duration=1.0, tolerance=tolerance, times=times)
    w, middle = math.sqrt(stiffness), -0.1 - G / stiffness
    down = math.acos(-middle / (0.5 - middle)) / w
    true = np.where(times < down, middle + (0.5 - middle) * np.cos(w * times), 0.0)
    assert run.certificate is not None
    assert run.certificate.bound is not None
    error = float(np.abs(run.position[:, 0, 1] - true).max()) / 0.5
    assert error <= run.certificate.bound <= tolerance


@pytest.mark.parametrize("rtol", [1e-12, 4e-13, 2e-13, 1e-13, 2e-14])
@pytest.mark.parametrize("eccentricity", [0.998, 0.99995])
def test_the_order_of_halved_steps_is_not_believed_below_rounding(
    rtol: float, eccentricity: float
) -> None:
    """Both ways round each step, most where the planet is fastest."""
    error, bound = of_orbit(eccentricity, 6.0, rtol)
    assert error <= bound < 1e-8


def of_orbit(eccentricity: float, duration: float, rtol: float) -> tuple[float, float]:
    """Error and bound of an orbit from its apoapsis on, by halved steps."""
    far, speed = 1 + eccentricity, -math.sqrt((1 - eccentricity) / (1 + eccentricity))
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(-far, 0.0), velocity=(0.0, speed))
    pull = [f"-1[m^3/s^2]*mass*{axis}(position)/norm(position)**3" for axis in "xy"]
    scene.add_field(force=pull)
    times = np.linspace(0.0, duration, 41)
    method = t2.Dop853(rtol=rtol, halved=True)
    run = t2.simulate(scene, duration=duration, method=method, times=times)
    true = replace(run, position=orbit_from_apoapsis(far, speed, times)[:, None])
    return error_and_bound(run, true)


def orbit_from_apoapsis(far: float, speed: float, times: Array) -> Array:
    """Return places (k, 2), m, at times, s, by Kepler's equation in 40 digits.

    The planet starts at (-far, 0), m, along y, and what pulls it in the origin has mu = 1 m^3/s^2.
    """
    with mp.workdps(40):
        axis = 1 / (2 / mp.mpf(far) - mp.mpf(speed) ** 2)
        e = mp.mpf(far) / axis - 1
        found = []
        for t in times:
            mean = mp.pi + mp.mpf(float(t)) / mp.sqrt(axis**3)

            def late(anomaly: mp.mpf, mean: mp.mpf = mean) -> mp.mpf:
                return anomaly - e * mp.sin(anomaly) - mean

            u = mp.findroot(late, (mean - 1, mean + 1), solver="anderson", tol=1e-70)
            across = mp.sqrt(1 - e**2) * mp.sin(u)
            found.append((float(axis * (mp.cos(u) - e)), float(axis * across)))
        return np.array(found)


@pytest.mark.parametrize("tolerance", [1e-1, 1e-3, 1e-6, 1e-9])
def test_the_turning_of_a_body_without_a_shape_counts_at_its_radius_of_gyration(
    tolerance: float,
) -> None:
    """Its centre does not move; 2 kg and 0.5 kg m^2 have a radius of gyration of 0.5 m."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    turns: Any = {"angular_velocity": 1.0, "torque": "-1[N*m]*sin(orientation)"}
    scene.add_body(None, mass=2.0, inertia=0.5, position=(0.0, 0.0), **turns)
    run = t2.simulate(scene, duration=1.0, tolerance=tolerance)
    swing = solve_ivp(
        lambda _, y: [y[1], -2.0 * math.sin(y[0])], (0.0, 1.0), [0.0, 1.0], method="DOP853",
        rtol=1e-13, atol=1e-13, t_eval=run.times,
    )  # fmt: skip
    certificate, arc = run.certificate, float(np.ptp(run.orientation))
    assert certificate is not None
    assert certificate.bound is not None
    assert f"relative to the {0.5 * arc:.6g} m that the farthest" in certificate.measure
    error = np.abs(run.orientation[:, 0] - swing.y[0]).max() / arc
    assert error <= certificate.bound + 1e-12
    assert certificate.bound <= tolerance


@pytest.mark.parametrize(("eccentricity", "duration"), [(0.9464, 13.15), (0.9999, 5.48)])
def test_an_orbit_that_equal_steps_lose_keeps_its_bound(
    eccentricity: float, duration: float
) -> None:
    """Small changes grow by the steps of a scheme that loses the planet, not by the equations."""
    error, bound = of_orbit(eccentricity, duration, 6e-14)
    assert error <= bound < 1e-8
