"""Bounds where a force has a kink: halved steps do not err less there by the order of a scheme."""

import math

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.state import Array


def ramp_response(time: Array, w: float) -> Array:
    """Return the way of x'' = -w^2 x + t from rest: t/w^2 - sin(wt)/w^3, 0 before."""
    later = np.maximum(time, 0.0)
    return later / w**2 - np.sin(w * later) / w**3


@pytest.mark.parametrize("seed", range(12))
def test_a_force_that_switches_on_within_a_bound(seed: int) -> None:
    """Against the closed form of a spring on which a push grows evenly, and then stays."""
    chance = np.random.default_rng(seed)
    push, at, w = chance.uniform((0.5, 0.3, 0.5), (3.0, 1.5, 4.0)).tolist()
    rise, tolerance = chance.choice((1e-3, 1e-2, 1e-1)), chance.choice((1e-4, 1e-6, 1e-8))
    scene = t2.Scene(gravity=(0.0, 0.0))
    law = f"{push!r}[N]*min(max((time-{at!r}[s])/{float(rise)!r}[s],0),1)"
    body = scene.add_body(
        None, mass=1.0, position=(1.0, 0.0), force=(f"{law}-{w * w!r}[N/m]*x(position)", 0.0)
    )
    run = t2.simulate(scene, duration=3.0, tolerance=float(tolerance))
    since = run.times - at
    exact = np.cos(w * run.times) + push / rise * (
        ramp_response(since, w) - ramp_response(since - rise, w)
    )
    place = run.position[:, body, 0]
    assert run.certificate is not None
    assert run.certificate.bound is not None
    error = np.abs(place - exact).max() / np.ptp(place)
    assert error <= min(run.certificate.bound, float(tolerance)) + 1e-13
    assert math.isfinite(run.certificate.bound)


@pytest.mark.parametrize("tolerance", [1e-3, 1e-4, 1e-5, 1e-6, 1e-8])
def test_a_root_that_changes_its_sign_is_a_kink(tolerance: float) -> None:
    """Constant forces to and fro: parabolas, whose quarter takes sqrt(2) s from rest at 1 m."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    law = "-1[N]*x(position)/sqrt(x(position)**2)"
    body = scene.add_body(None, mass=1.0, position=(1.0, 0.0), force=(law, 0.0))
    run = t2.simulate(scene, duration=10.0, tolerance=tolerance)
    quarter = math.sqrt(2.0)
    half = np.floor(run.times / (2 * quarter) + 0.5)
    late = run.times - 2 * quarter * half  # since the top nearest in time
    exact = (1 - late**2 / 2) * np.where(half % 2 == 0, 1.0, -1.0)
    error = np.abs(run.position[:, body, 0] - exact).max() / np.ptp(run.position[:, body, 0])
    assert run.certificate is not None
    assert run.certificate.bound is not None
    assert error <= min(run.certificate.bound, tolerance) + 1e-13
