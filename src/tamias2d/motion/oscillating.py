"""Exact paths on a spring of no length to a point: the closed form of IM7."""

import math
from typing import Any

from tamias2d.generated import rotation, spring as model, translation
from tamias2d.motion.track import columns
from tamias2d.path import Bounds
from tamias2d.scene import Body, Spring
from tamias2d.state import Acceleration, Array, Constraint, State, Vector

_ROUNDING = 1 + 2.0**-48


class Oscillating:
    """A path on an ellipse around the place at which spring and constant loads balance.

    A body on a support oscillates along it: the support takes the same part from all forces.
    """

    def __init__(
        self,
        body: Body,
        spring: Spring,
        start: float,
        end: float,
        state: State,
        steady: Acceleration,
        constraint: Constraint | None,
    ) -> None:
        self.start = start
        self.end = end
        self._state = state
        self._mass = body.mass
        self._stiffness = spring.stiffness
        self._frequency = model.angular_frequency(spring.stiffness, body.mass)
        self._center: Vector = model.equilibrium(spring.point, steady[:2], self._frequency)
        self._angular = steady[2]
        if constraint:
            (x, y), (cx, cy) = state.position, self._center
            along_x, along_y, self._angular = constraint((cx - x, cy - y, steady[2]), state)
            self._center = (x + along_x, y + along_y)

    def at(self, time: float) -> State:
        """Return the state at a time in s."""
        return self._state if time == self.start else self._formula(time)

    def _formula(self, time: Any) -> State:
        position, orientation, velocity, angular_velocity = self._state
        elapsed = time - self.start
        return State(
            model.position(self._center, position, velocity, self._frequency, elapsed),
            rotation.orientation(orientation, angular_velocity, self._angular, elapsed),
            model.velocity(self._center, position, velocity, self._frequency, elapsed),
            rotation.angular_velocity(angular_velocity, self._angular, elapsed),
        )

    def acceleration(self, time: float) -> Acceleration:
        """Return the acceleration at a time in s."""
        return (*self._pull(self.at(time).position), self._angular)

    def _pull(self, position: Vector) -> Vector:
        still = (0.0, 0.0)
        force = model.spring_force(self._stiffness, 0.0, 0.0, position, still, self._center, still)
        x, y = translation.acceleration(still, force, self._mass)
        return float(x), float(y)

    def bounds(self, first: float, last: float) -> Bounds:
        """Return what holds from `first` to `last`, s.

        Pull and velocity swing with the angular frequency, each about zero: neither is ever larger
        than at its start and a quarter of a period later taken together, nor does the pull change
        faster than the largest velocity allows.
        """
        pull = math.hypot(*self._pull(self._state.position))
        speed = math.hypot(*self._state.velocity)
        frequency = self._frequency
        largest = math.hypot(pull, frequency * speed) * _ROUNDING
        fastest = math.hypot(pull / frequency, speed) * _ROUNDING
        middle = (first + last) / 2
        x, y, _ = self.acceleration(middle)
        spread = frequency * largest * (last - first) / 2 + (_ROUNDING - 1) * largest
        center, deviation = ((x, y), spread) if spread < largest else ((0.0, 0.0), largest)
        spins = [self.at(time).angular_velocity for time in (first, last)]
        return Bounds(center, deviation, fastest, max(map(abs, spins)), abs(self._angular))

    def sample(self, times: Array) -> Array:
        """Return (k, 6) at times (k,), s."""
        rows = columns(self._formula(times), times)
        (x, y), turn, (u, v), spin = self._state
        rows[times == self.start] = (x, y, turn, u, v, spin)
        return rows
