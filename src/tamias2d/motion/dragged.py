"""Exact paths under linear and angular drag and constant loads: the closed form of IM6."""

import math
from typing import Any

from tamias2d.generated import drag, rotation, translation
from tamias2d.motion.track import columns
from tamias2d.path import Bounds
from tamias2d.scene import Body
from tamias2d.state import Acceleration, Array, Constraint, State, Vector

_ROUNDING = 1 + 2.0**-48


class Dragged:
    """A path on which velocity and angular velocity decay towards terminal ones.

    `steady` is what the constant loads alone would give. A contact that lasts takes from it what it
    takes from the drag as well, which is along the velocity.
    """

    def __init__(
        self,
        body: Body,
        start: float,
        end: float,
        state: State,
        steady: Acceleration,
        constraint: Constraint | None,
    ) -> None:
        self.start = start
        self.end = end
        self._body = body
        self._state = state
        *linear, self._angular = constraint(steady, state) if constraint else steady
        self._linear: Vector = (linear[0], linear[1])
        self._rate = drag.drag_rate(body.linear_drag, body.mass)
        self._angular_rate = drag.angular_drag_rate(body.angular_drag, body.inertia)

    def at(self, time: float) -> State:
        """Return the state at a time in s."""
        position, orientation, velocity, angular_velocity = self._state
        elapsed = time - self.start
        return State(
            drag.position(position, velocity, self._linear, self._rate, elapsed),
            self._orientation(orientation, angular_velocity, elapsed),
            drag.velocity(velocity, self._linear, self._rate, elapsed),
            self._spin(angular_velocity, elapsed),
        )

    def _orientation(self, orientation: float, spin: float, elapsed: Any) -> Any:
        if not self._angular_rate:
            return rotation.orientation(orientation, spin, self._angular, elapsed)
        return drag.orientation(orientation, spin, self._angular, self._angular_rate, elapsed)

    def _spin(self, spin: float, elapsed: Any) -> Any:
        if not self._angular_rate:
            return rotation.angular_velocity(spin, self._angular, elapsed)
        return drag.angular_velocity(spin, self._angular, self._angular_rate, elapsed)

    def acceleration(self, time: float) -> Acceleration:
        """Return the acceleration at a time in s."""
        now = self.at(time)
        force = drag.linear_drag_force(self._body.linear_drag, now.velocity)
        x, y = translation.acceleration(self._linear, force, self._body.mass)
        return float(x), float(y), self._angular + self._slowing(now.angular_velocity)

    def _slowing(self, spin: float) -> float:
        if not self._angular_rate:
            return 0.0
        torque = drag.angular_drag_torque(self._body.angular_drag, spin)
        return float(rotation.angular_acceleration(torque, self._body.inertia))

    def bounds(self, first: float, last: float) -> Bounds:
        """Return what holds from `first` to `last`, s.

        Velocity and acceleration change along straight lines, from one end to the other.
        """
        early, late = self.at(first), self.at(last)
        (ax, ay, turn), (bx, by, later) = self.acceleration(first), self.acceleration(last)
        spread = math.hypot(bx - ax, by - ay) / 2 + (_ROUNDING - 1) * (abs(ax) + abs(ay))
        return Bounds(
            ((ax + bx) / 2, (ay + by) / 2),
            spread * _ROUNDING,
            max(math.hypot(*early.velocity), math.hypot(*late.velocity)) * _ROUNDING,
            max(abs(early.angular_velocity), abs(late.angular_velocity)),
            max(abs(turn), abs(later)),
        )

    def sample(self, times: Array) -> Array:
        """Return (k, 6) at times (k,), s."""
        return columns(self.at(times), times)  # type: ignore[arg-type]
