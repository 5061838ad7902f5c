"""Steps in halves: their error is what the whole ones beside them say, by the scheme's order."""

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.solve import solve_halved
from tamias2d.study.certify import certify_halved
from tests.certificate.test_tolerance import oscillator

_METHODS = ((t2.Dop853(1e-7), 8), (t2.DormandPrince5(1e-6), 5))


@pytest.mark.parametrize(("method", "order"), _METHODS)
def test_halves_err_less_by_the_order_of_the_scheme(
    method: t2.Dop853 | t2.DormandPrince5, order: int
) -> None:
    scene = t2.catalogue.load("kepler")
    times = np.linspace(0.0, 10.0, 61)
    halves, halving = solve_halved(scene, duration=10.0, method=method, times=times)
    exact = t2.simulate(scene, duration=10.0, method=t2.Reference(1e-13), times=times)
    error = np.linalg.norm(halves.position - exact.position, axis=-1).max()
    assert halving is not None
    said = np.linalg.norm(halving.apart[:, :2], axis=-1).max() / (2**order - 1)
    assert 0.3 * said < error < 3 * said  # both err alike: from 1/2 to 2 on orbits and springs


def test_halves_take_twice_the_steps_and_are_what_the_method_says() -> None:
    whole = t2.simulate(oscillator(), duration=1.0, method=t2.Dop853(1e-6))
    method = t2.Dop853(1e-6, halved=True)
    halves = t2.simulate(oscillator(), duration=1.0, method=method)
    found, _ = solve_halved(oscillator(), duration=1.0, method=t2.Dop853(1e-6))
    assert halves.cost is not None
    assert whole.cost is not None
    assert halves.cost.steps == 2 * whole.cost.steps
    assert found.method == method
    assert found.digest() == halves.digest()
    assert str(method) == "Dop853(rtol=1e-06, halved=True)"


def test_what_impacts_change_says_nothing_of_the_error() -> None:
    scene = t2.catalogue.load("bouncing-disc")
    run, halving = solve_halved(scene, duration=1.0, method=t2.Dop853(1e-8))
    exact = t2.simulate(scene, duration=1.0)
    assert len(run.impacts)
    assert halving is None
    assert np.abs(run.position - exact.position).max() < 1e-9


def test_general_code_has_the_same_bits(monkeypatch: pytest.MonkeyPatch) -> None:
    def run() -> t2.Run:
        return t2.simulate(oscillator(), duration=1.0, method=t2.Dop853(1e-9, halved=True))

    quick = run()
    monkeypatch.setattr("tamias2d.solve.located.march_by_kernels", lambda *_: None)
    general = run()
    assert quick.digest() == general.digest()
    assert quick.cost == general.cost


def test_a_certificate_is_that_of_the_run_made_again() -> None:
    method = t2.Dop853(6e-6, halved=True)
    kepler = t2.catalogue.load("kepler")
    run = certify_halved(*solve_halved(kepler, duration=10.0, method=method))[0]
    again = t2.certify(run)
    assert run.certificate is not None
    assert "whole steps" in run.certificate.how
    assert again.certificate == run.certificate
