"""Exact paths under constant force and torque: the closed forms of IM1 and IM2."""

import math

from tamias2d.generated import rotation, translation
from tamias2d.motion.track import columns
from tamias2d.path import Bounds
from tamias2d.state import Acceleration, Array, State, Vector


class Uniform:
    """A path with constant acceleration."""

    def __init__(
        self, *, start: float, end: float, state: State, acceleration: Acceleration
    ) -> None:
        self.start = start
        self.end = end
        self._state = state
        self._linear: Vector = acceleration[:2]
        self._angular = acceleration[2]

    def at(self, time: float) -> State:
        """Return the state at a time in s."""
        position, orientation, velocity, angular_velocity = self._state
        elapsed = time - self.start
        return State(
            translation.position(position, velocity, self._linear, elapsed),
            rotation.orientation(orientation, angular_velocity, self._angular, elapsed),
            translation.velocity(velocity, self._linear, elapsed),
            rotation.angular_velocity(angular_velocity, self._angular, elapsed),
        )

    def acceleration(self, time: float) -> Acceleration:  # noqa: ARG002
        """Return the acceleration, the same at all times."""
        return (*self._linear, self._angular)

    def bounds(self, first: float, last: float) -> Bounds:
        """Return what holds from `first` to `last`, s; rates are largest at one of the two."""
        v = self._state.velocity
        early = translation.velocity(v, self._linear, first - self.start)
        late = translation.velocity(v, self._linear, last - self.start)
        spin = self._state.angular_velocity
        spin_early = rotation.angular_velocity(spin, self._angular, first - self.start)
        spin_late = rotation.angular_velocity(spin, self._angular, last - self.start)
        return Bounds(
            self._linear,
            0.0,
            max(math.hypot(*early), math.hypot(*late)),
            max(abs(spin_early), abs(spin_late)),
            abs(self._angular),
        )

    def sample(self, times: Array) -> Array:
        """Return (k, 6) at times (k,), s."""
        return columns(self.at(times), times)  # type: ignore[arg-type]
