"""The order of a scheme that remembers an acceleration is that of the steps that run."""

from fractions import Fraction

from tamias2d.spec.order import order
from tamias2d.spec.scheme import Scheme

HALF, ALL = Fraction(1, 2), Fraction(1)


def two_level(position: tuple[Fraction, ...], velocity: tuple[Fraction, ...]) -> Scheme:
    return Scheme("trial", "two_level", 0, position=position, velocity=velocity)


def test_extrapolation_from_the_step_before_has_order_two() -> None:
    """Adams and Bashforth's: three halves of the acceleration of now, less half of the last."""
    assert order(two_level((ALL, HALF, Fraction(0)), (-HALF, 3 * HALF)), 3) == 2


def test_the_mean_of_both_is_half_a_step_late() -> None:
    assert order(two_level((ALL, HALF, Fraction(0)), (HALF, HALF)), 3) == 1
