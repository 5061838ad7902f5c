"""Energy over many steps: symplectic schemes and located impacts have no trend, others do."""

import pytest

from tamias2d.motion import (
    ClosedForm,
    ExplicitEuler,
    Method,
    RungeKutta4,
    SemiImplicitEuler,
    VelocityVerlet,
    Yoshida4,
)
from tamias2d.study.drift import bounce_drift, orbit_drift

STEPS = 200_000


@pytest.mark.parametrize("method", [SemiImplicitEuler(), VelocityVerlet(), Yoshida4()])
def test_an_orbit_by_a_symplectic_scheme_has_no_trend(method: Method) -> None:
    found = orbit_drift(method, STEPS)
    assert found.trendless
    assert abs(found.trend) < 1e-2 * found.swing
    assert found.swing <= found.largest < 1.1 * found.swing


@pytest.mark.parametrize("method", [RungeKutta4(), ExplicitEuler()])
def test_an_orbit_by_another_scheme_has_one(method: Method) -> None:
    assert not orbit_drift(method, STEPS).trendless


def test_a_bounce_loses_nothing_at_located_impacts() -> None:
    found = bounce_drift(ClosedForm(), 100_000)
    assert found.impacts == 1107  # one in every 0.903 s
    assert found.trendless
    assert found.largest < 1e-12


def test_a_bounce_by_a_poor_scheme_is_caught() -> None:
    assert not bounce_drift(SemiImplicitEuler(), 20_000).trendless
