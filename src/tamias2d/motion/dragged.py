"""Exact paths under linear drag and otherwise constant loads: the closed form of IM6.

Serves: the closed form. Hides: how the path and its bounds are found.
"""

import math

from tamias2d.generated import drag, rotation, translation
from tamias2d.motion.piece import Bounds
from tamias2d.motion.track import columns
from tamias2d.scene import Body
from tamias2d.state import Acceleration, Array, Hold, State, Vector

_ROUNDING = 1 + 2.0**-48


class Dragged:
    """A path on which the velocity decays towards a terminal one.

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
        hold: Hold | None,
    ) -> None:
        self.start = start
        self.end = end
        self._body = body
        self._state = state
        *linear, self._angular = hold(steady, state) if hold else steady
        self._linear: Vector = (linear[0], linear[1])
        self._rate = drag.drag_rate(body.linear_drag, body.mass)

    def at(self, time: float) -> State:
        """Return the state at a time in s."""
        position, orientation, velocity, angular_velocity = self._state
        elapsed = time - self.start
        return State(
            drag.position(position, velocity, self._linear, self._rate, elapsed),
            rotation.orientation(orientation, angular_velocity, self._angular, elapsed),
            drag.velocity(velocity, self._linear, self._rate, elapsed),
            rotation.angular_velocity(angular_velocity, self._angular, elapsed),
        )

    def acceleration(self, time: float) -> Acceleration:
        """Return the acceleration at a time in s."""
        force = drag.linear_drag_force(self._body.linear_drag, self.at(time).velocity)
        x, y = translation.acceleration(self._linear, force, self._body.mass)
        return float(x), float(y), self._angular

    def bounds(self, first: float, last: float) -> Bounds:
        """Return what holds from `first` to `last`, s.

        Velocity and acceleration change along straight lines, from one end to the other.
        """
        early, late = self.at(first), self.at(last)
        (ax, ay, _), (bx, by, _) = self.acceleration(first), self.acceleration(last)
        spread = math.hypot(bx - ax, by - ay) / 2 + (_ROUNDING - 1) * (abs(ax) + abs(ay))
        return Bounds(
            ((ax + bx) / 2, (ay + by) / 2),
            spread * _ROUNDING,
            max(math.hypot(*early.velocity), math.hypot(*late.velocity)) * _ROUNDING,
            max(abs(early.angular_velocity), abs(late.angular_velocity)),
            abs(self._angular),
        )

    def sample(self, times: Array) -> Array:
        """Return (k, 6) at times (k,), s."""
        return columns(self.at(times), times)  # type: ignore[arg-type]
