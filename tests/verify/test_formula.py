"""Exact answers are read with their units, and errors are measured as the cases say."""

import numpy as np
import pytest
from hypothesis import given, strategies as st

from tamias2d.errors import SpecError
from tamias2d.verify.formula import distance, history, instant, measure

TIMES = np.linspace(0.0, 2.0, 5)
NUMBER = st.floats(-1e6, 1e6)


def test_a_constant_fills_the_history() -> None:
    assert history("vector(1[m], -2[m])", "position", TIMES).tolist() == [[1.0, -2.0]] * 5


def test_a_scalar_follows_time() -> None:
    assert history("6[rad/s^2]*time**2", "orientation", TIMES) == pytest.approx(6 * TIMES**2)


@pytest.mark.parametrize(
    "text",
    ["1[m]", "vector(1[s], 1[m])", "vector(1[m], mass)", "vector(1[m], 1[m]", "__import__('os')"],
)
def test_what_is_no_position_is_refused(text: str) -> None:
    with pytest.raises(SpecError, match="position"):
        history(text, "position", TIMES)


def test_an_instant_is_a_time() -> None:
    assert instant("sqrt(4[s^2])") == 2.0
    with pytest.raises(SpecError, match="time"):
        instant("4[m]")
    with pytest.raises(SpecError, match="time"):
        instant("time")


def test_a_measure_needs_the_unit_of_its_symbol() -> None:
    assert measure(["1 km", "2 m"], "position") == (1000.0, 2.0)
    with pytest.raises(SpecError, match="mass"):
        measure("1 m", "mass")


@given(NUMBER, NUMBER, st.floats(1e-3, 1e3))
def test_distance_is_relative(x: float, y: float, size: float) -> None:
    exact = np.array([x, y])
    wrong = exact + size
    if np.abs(exact).max() > 1e-100:  # squares of less are 0
        assert distance(wrong, exact) == pytest.approx(distance(3 * wrong, 3 * exact))
    assert distance(exact, exact) == 0.0


def test_distance_is_absolute_where_the_answer_is_zero() -> None:
    assert distance(np.array([3.0, 4.0]), np.zeros(2)) == 5.0


@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_what_is_not_finite_is_infinitely_wrong(value: float) -> None:
    assert distance(np.array([value]), np.array([1.0])) == np.inf
