"""Bounds where a law does something for a moment, which long steps would miss."""

import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import tamias2d as t2
from tamias2d.motion import Method
from tamias2d.motion.law_resolution import LOOKS
from tamias2d.state import Array
from tamias2d.study.error import history_error

AT, PUSH, DURATION = 1.234, 100.0, 4.0


def pushed(width: float) -> t2.Scene:
    """Return a body at rest of 1 kg that is pushed for some time, s."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    law = f"{PUSH}[N]*exp(-((time-{AT}[s])/{width!r}[s])**2)"
    scene.add_body(None, name="ball", mass=1.0, position=(0.0, 0.0), force=(law, 0.0))
    return scene


def way(times: Array, width: float) -> Array:
    """Return where it is at some times, s: the push integrated twice."""
    start, at = -AT / width, (times - AT) / width
    rising = width * (erf_integral(at) - erf_integral(np.array([start]))) - times * math.erf(start)
    return np.asarray(PUSH * width * math.sqrt(math.pi) / 2 * rising)


def erf_integral(at: Array) -> Array:
    """Return z erf z + exp(-z^2)/sqrt(pi)."""
    return np.array([z * math.erf(z) + math.exp(-z * z) / math.sqrt(math.pi) for z in at])


@pytest.mark.parametrize("width", [1.0, 0.1, 0.02, 0.007, 0.003])
@pytest.mark.parametrize("tolerance", [1e-3, 1e-6, 1e-9])
def test_a_short_push_within_a_bound(width: float, tolerance: float) -> None:
    """Against the closed form, by whatever the tolerance chooses."""
    run = t2.simulate(pushed(width), duration=DURATION, tolerance=tolerance)
    assert run.certificate is not None
    assert run.certificate.bound is not None
    exact = way(run.times, width)
    error = np.abs(run.position[:, 0, 0] - exact).max() / np.ptp(exact)
    assert error <= run.certificate.bound + 1e-13 <= tolerance + 1e-13


@pytest.mark.parametrize("method", [t2.DormandPrince5(1e-6), t2.Dop853(1e-9), t2.Reference()])
def test_methods_that_choose_their_steps_see_it(method: Method) -> None:
    """Also without a tolerance of the run."""
    run = t2.simulate(pushed(0.005), duration=DURATION, method=method)
    exact = way(run.times, 0.005)
    assert np.abs(run.position[:, 0, 0] - exact).max() <= 1e-4 * np.ptp(exact)


def test_a_narrow_bump_of_a_field_is_seen() -> None:
    """A body that flies through it at 10 m/s, against scipy with short steps."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_field(force=("200[N]*exp(-((x(position)-20[m])/0.05[m])**2)", 0.0))
    scene.add_body(None, mass=1.0, position=(0.0, 0.0), velocity=(10.0, 0.0))
    run = t2.simulate(scene, duration=4.0, tolerance=1e-8)

    def rate(_time: float, y: Array) -> list[float]:
        return [y[1], 200 * math.exp(-(((y[0] - 20) / 0.05) ** 2))]

    found = solve_ivp(
        rate, (0, 4), [0, 10], t_eval=run.times, max_step=2e-3, rtol=1e-12, atol=1e-12
    )
    assert np.abs(run.position[:, 0, 0] - found.y[0]).max() <= 1e-8 * found.y[0].max()


def test_given_steps_that_miss_it_have_no_bound() -> None:
    """They say what they miss; short ones have a bound, and hold it."""
    long = t2.certify(
        t2.simulate(pushed(0.005), duration=DURATION, method=t2.RungeKutta4(), time_step=0.1)
    )
    assert long.certificate is not None
    assert long.certificate.kind != "step doubling"
    assert long.unresolved is not None
    assert long.certificate.how == long.unresolved
    assert long.unresolved in long.notes
    assert "force[0] of body 'ball', near 1.2" in long.certificate.how
    short = t2.certify(
        t2.simulate(pushed(0.005), duration=DURATION, method=t2.RungeKutta4(), time_step=1e-3)
    )
    exact = way(short.times, 0.005)
    assert short.certificate is not None
    assert short.certificate.bound is not None
    error = np.abs(short.position[:, 0, 0] - exact).max() / np.ptp(exact)
    assert error <= short.certificate.bound <= 1e-4


def test_what_is_too_brief_to_be_seen_is_not_claimed() -> None:
    """The certificate says how long something must be; of what goes on evenly it says nothing."""
    run = t2.simulate(pushed(0.1), duration=DURATION, tolerance=1e-6)
    assert run.certificate is not None
    told = f"what a law does for less than {DURATION / LOOKS:.3g} s"
    assert any(told in text for text in run.certificate.does_not_claim)
    scene = t2.Scene(gravity=(0.0, 0.0))
    law = "3[N/s]*time+2[N]*sin(5[rad/s]*time)**2"
    scene.add_body(None, mass=1.0, position=(0.0, 0.0), force=(law, 0.0))
    run = t2.simulate(scene, duration=DURATION, tolerance=1e-6)
    assert run.certificate is not None
    assert not any("what a law does" in text for text in run.certificate.does_not_claim)


def test_ordinary_oscillations_take_no_further_steps() -> None:
    """A law that steps resolve sets them no limit."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    law = "-4[N/m]*x(position)+3[N]*sin(3[rad/s]*time)"
    scene.add_body(None, mass=1.0, position=(1.0, 0.0), force=(law, 0.0))
    run = t2.simulate(scene, duration=10.0, method=t2.Dop853(1e-6))
    assert run.cost is not None
    assert run.cost.steps <= 30


def test_pushes_one_after_the_other_are_all_seen() -> None:
    """Each adds the same impulse to a free body."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    ends = np.array([0.7, 3.1, 3.3, 7.9])
    law = "+".join(f"50[N]*exp(-((time-{float(at)}[s])/0.02[s])**2)" for at in ends)
    scene.add_body(None, mass=2.0, position=(0.0, 0.0), force=(0.0, law))
    times = np.array([0.0, *(ends + 0.1), 10.0])
    run = t2.simulate(scene, duration=10.0, times=times, tolerance=1e-8)
    gained = [after - before for before, after in pairwise(run.velocity[:-1, 0, 1])]
    assert gained == pytest.approx([50 * 0.02 * math.sqrt(math.pi) / 2] * 4, rel=1e-8)


def test_steps_that_a_push_shortens_are_not_believed_by_their_order() -> None:
    """Halves of such steps err by some ten times what the order says: against scipy at 1e-13."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_body(None, mass=1.7151510618945593, position=(0.7473891123120944, 0.0))
    scene.add_spring(
        0,
        (0.0, 0.0),
        stiffness=24.6877306312823,
        rest_length=0.22229129001814674,
        damping=0.44179487523851413,
    )
    push = "17.28[N]*exp(-((time-2.8894[s])/0.01359[s])**2)"
    scene.add_field(force=[push, "0[N]"])
    asked: dict[str, Any] = {"duration": 5.18329, "times": np.linspace(0.0, 5.18329, 101)}
    exact = t2.simulate(scene, method=t2.Reference(1e-13), **asked)
    run = t2.certify(t2.simulate(scene, method=t2.Dop853(6e-7, halved=True), **asked))
    assert run.certificate is not None
    assert run.certificate.bound is not None
    assert history_error(run, exact) <= run.certificate.bound
