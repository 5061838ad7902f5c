"""The least second derivative that a gap can have within a window of time (DD47)."""

import math

from tamias2d.contact.core import Placed
from tamias2d.contact.gap import Axis, Gap
from tamias2d.generated.continuous_collision import (
    centre_acceleration_least,
    centre_acceleration_turning,
    circling,
    gap_acceleration_least,
)
from tamias2d.path import Bounds
from tamias2d.state import Vector


class LeastGapAcceleration:
    """The least second derivative that the gap to a corner can have within a window, m/s^2."""

    def __init__(
        self,
        axis: Axis,
        a: Placed,
        b: Placed,
        bounds_a: Bounds,
        bounds_b: Bounds,
        window: float,
        *,
        relative: bool,
    ) -> None:
        p, q = (b, a) if axis.swapped else (a, b)
        on_p, on_q = (bounds_b, bounds_a) if axis.swapped else (bounds_a, bounds_b)
        turning = axis.side is not None and (on_p.angular_speed or on_p.angular_acceleration)
        if relative:
            self._centres = 0.0
        elif turning:
            self._centres = _least_of_turning_centres(axis.direction, p, q, on_p, on_q, window)
        else:
            self._centres = least_of_centres(axis.direction, on_p, on_q)
        self._p = circling(on_p.angular_speed, on_p.angular_acceleration)
        self._q = circling(on_q.angular_speed, on_q.angular_acceleration)
        if turning:
            spin = abs(q.state.angular_velocity - p.state.angular_velocity)
            change = on_p.angular_acceleration + on_q.angular_acceleration
            self._q = circling(spin + change * window, change)

    def __call__(self, gap: Gap) -> float:
        """Return it for the gap to one corner, m/s^2."""
        reach_p, reach_q = gap.reach
        return float(gap_acceleration_least(self._centres, reach_p, self._p, reach_q, self._q))


def least_of_centres(direction: Vector, on_p: Bounds, on_q: Bounds) -> float:
    """Return the least acceleration of Q's centre from P's along a fixed direction, m/s^2."""
    deviation = on_p.deviation + on_q.deviation
    return float(
        centre_acceleration_least(on_p.acceleration, on_q.acceleration, direction, deviation)
    )


def _least_of_turning_centres(
    direction: Vector, p: Placed, q: Placed, on_p: Bounds, on_q: Bounds, window: float
) -> float:
    """Return the least acceleration of Q's centre from P's along an axis of P, m/s^2."""
    (px, py), (qx, qy) = p.state.position, q.state.position
    (pu, pv), (qu, qv) = p.state.velocity, q.state.velocity
    (pa, pb), (qa, qb) = on_p.acceleration, on_q.acceleration
    acceleration = math.hypot(qa - pa, qb - pb) + (on_p.deviation + on_q.deviation)
    speed = math.hypot(qu - pu, qv - pv) + acceleration * window
    distance = math.hypot(qx - px, qy - py) + speed * window
    spins = circling(on_p.angular_speed, on_p.angular_acceleration)
    return float(
        centre_acceleration_turning(
            spins,
            distance,
            on_p.angular_speed,
            speed,
            least_of_centres(direction, on_p, on_q),
            on_p.angular_speed * window,
            acceleration,
        )
    )
