"""Cosine and sine against 200 bits, wherever an angle may be."""

import math

from hypothesis import example, given, strategies as st
from mpmath import mp, mpf

from tamias2d.engine.rotation import cosine_sine

ROUNDING = 2.0**-52


@given(st.floats(-1e6, 1e6))
@example(0.0)
@example(math.pi / 4)
@example(-math.pi)
@example(355.0)  # nearly a multiple of pi
@example(1e6)
def test_cosine_and_sine_are_right_to_the_last_bit_but_one(angle: float) -> None:
    with mp.workprec(200):
        exact = float(mp.cos(mpf(angle))), float(mp.sin(mpf(angle)))
    cosine, sine = cosine_sine(angle)
    assert abs(cosine - exact[0]) <= ROUNDING
    assert abs(sine - exact[1]) <= ROUNDING


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_cosine_and_sine_are_near_the_circle_at_any_angle(angle: float) -> None:
    cosine, sine = cosine_sine(angle)
    assert abs(cosine * cosine + sine * sine - 1.0) < 1e-3
    if abs(angle) <= 1e9:  # beyond, a turn is known to less than that
        assert abs(cosine - math.cos(angle)) <= 2e-7
