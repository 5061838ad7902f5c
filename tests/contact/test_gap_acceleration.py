"""The second derivative of a gap (GD15), against differences of gaps of bodies on their way."""

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from tamias2d.generated import friction, rest

REACH = st.floats(-2, 2)
PLACE = st.tuples(REACH, REACH).map(np.array)
RATE = st.floats(-3, 3)
STEP = 1e-3  # s: differences of fourth order leave some 1e-10 of what is left out and of rounding
WEIGHTS = {-2: -1 / 12, -1: 4 / 3, 0: -5 / 2, 1: 4 / 3, 2: -1 / 12}


class Body(NamedTuple):
    """A body under constant accelerations, with one corner."""

    place: np.ndarray
    velocity: np.ndarray
    acceleration: np.ndarray
    spin: float
    turning: float
    arm: np.ndarray

    def corner(self, time: float) -> np.ndarray:
        """Return where the corner is."""
        return self.centre(time) + self.turned(time) @ self.arm

    def centre(self, time: float) -> np.ndarray:
        """Return where the centre is."""
        return self.place + self.velocity * time + self.acceleration * time**2 / 2

    def turned(self, time: float) -> np.ndarray:
        """Return the matrix by which the body has turned since time 0."""
        angle = self.spin * time + self.turning * time**2 / 2
        c, s = math.cos(angle), math.sin(angle)
        return np.array(((c, -s), (s, c)))


BODIES = st.builds(Body, PLACE, PLACE, PLACE, RATE, RATE, PLACE)


def second(of: Callable[[float], float]) -> float:
    return sum(weight * of(k * STEP) for k, weight in WEIGHTS.items()) / STEP**2


def of_points(a: Body, b: Body, arm_a: np.ndarray, normal: np.ndarray) -> float:
    """Return the normal acceleration of the points at two arms."""
    return float(
        rest.normal_acceleration(
            tuple(a.acceleration), a.turning, tuple(arm_a), tuple(b.acceleration), b.turning,
            tuple(b.arm), tuple(normal),
        )
    )  # fmt: skip


def slip(a: Body, b: Body, arm_a: tuple[float, float], normal: np.ndarray) -> float:
    return float(
        friction.tangential_velocity(
            tuple(a.velocity), a.spin, arm_a, tuple(b.velocity), b.spin, tuple(b.arm),
            tuple(normal),
        )
    )  # fmt: skip


@settings(max_examples=200, deadline=None)
@given(BODIES, BODIES, st.floats(0, 2 * math.pi))
def test_a_corner_before_a_side(a: Body, b: Body, angle: float) -> None:
    normal = np.array((math.cos(angle), math.sin(angle)))

    def gap(time: float) -> float:
        return float((a.turned(time) @ normal) @ (b.corner(time) - a.centre(time)))

    span = b.corner(0.0) - a.place
    points = of_points(a, b, span, normal)
    along = slip(a, b, (0.0, 0.0), normal)
    found = rest.gap_acceleration_side(
        points, a.spin, b.spin, tuple(b.arm), tuple(normal), along, float(normal @ span)
    )
    assert found == pytest.approx(second(gap), rel=1e-6, abs=1e-6)


@settings(max_examples=200, deadline=None)
@given(BODIES, BODIES)
def test_a_corner_before_a_corner(a: Body, b: Body) -> None:
    span = b.corner(0.0) - a.corner(0.0)
    distance = float(np.hypot(*span))
    if distance < 0.5:  # the nearer they are, the faster the normal turns
        return
    normal = span / distance
    points = of_points(a, b, a.arm, normal)
    along = slip(a, b, tuple(a.arm), normal)
    found = rest.gap_acceleration_corner(
        points, a.spin, tuple(a.arm), b.spin, tuple(b.arm), tuple(normal), along, distance
    )
    wanted = second(lambda time: float(np.hypot(*(b.corner(time) - a.corner(time)))))
    assert found == pytest.approx(wanted, rel=1e-6, abs=1e-6)


@settings(max_examples=200, deadline=None)
@given(BODIES, BODIES, st.floats(0, 2 * math.pi))
def test_corners_along_a_fixed_tangent(a: Body, b: Body, angle: float) -> None:
    """GD16."""
    normal = (math.cos(angle), math.sin(angle))
    tangent = np.array((-normal[1], normal[0]))
    points = friction.tangential_acceleration(
        tuple(a.acceleration), a.turning, tuple(a.arm), tuple(b.acceleration), b.turning,
        tuple(b.arm), normal,
    )  # fmt: skip
    found = friction.tangential_acceleration_turning(
        points, a.spin, tuple(a.arm), b.spin, tuple(b.arm), tuple(tangent)
    )
    wanted = second(lambda time: float(tangent @ (b.corner(time) - a.corner(time))))
    assert found == pytest.approx(wanted, rel=1e-6, abs=1e-6)
