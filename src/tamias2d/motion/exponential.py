"""Exponential steps: linear drag and constant loads are solved exactly, all other loads by kicks.

Between the ends of a step the path is the exact one, plus a polynomial for what the kicks change.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tamias2d.generated import drag, rotation, schemes, translation
from tamias2d.motion.dragged import Dragged
from tamias2d.motion.fixed_steps import FixedSteps
from tamias2d.motion.loads import Loads, state_of
from tamias2d.motion.memoised_field import MemoisedField
from tamias2d.motion.polynomial import DenseStep, hermite, sampled
from tamias2d.path import Bounds, PathPiece
from tamias2d.scene import Scene
from tamias2d.state import Acceleration, Array, State

_ANY = State((0.0, 0.0), 0.0, (0.0, 0.0), 0.0)
"""Constraints that do not depend on the state do not read it."""


class _Exact(NamedTuple):
    """What is solved exactly, for n bodies."""

    mass: Array
    linear_drag: Array
    inertia: Array
    angular_drag: Array
    steady: Array
    """(n, 3), of all constant loads"""

    def acceleration(self, velocity: Array) -> Array:
        """Return the accelerations (n, 3) at rates (n, 3)."""
        force = drag.linear_drag_force(self.linear_drag, (velocity[:, 0], velocity[:, 1]))
        steady = (self.steady[:, 0], self.steady[:, 1])
        x, y = translation.acceleration(steady, force, self.mass)
        turn = self.steady[:, 2]
        if self.angular_drag.any():
            torque = drag.angular_drag_torque(self.angular_drag, velocity[:, 2])
            turn = turn + rotation.angular_acceleration(torque, self.inertia)
        return np.stack((x, y, turn), axis=-1)

    def moved(self, elapsed: float, q: Array, rate: Array) -> tuple[Array, Array]:
        """Return coordinates and rates (n, 3) after a time in s."""
        steady, spin = (self.steady[:, 0], self.steady[:, 1]), self.steady[:, 2]
        decay = drag.drag_rate(self.linear_drag, self.mass)
        velocity = (rate[:, 0], rate[:, 1])
        place = drag.position((q[:, 0], q[:, 1]), velocity, steady, decay, elapsed)
        later = drag.velocity(velocity, steady, decay, elapsed)
        turned = rotation.orientation(q[:, 2], rate[:, 2], spin, elapsed)
        turning = rotation.angular_velocity(rate[:, 2], spin, elapsed)
        if self.angular_drag.any():
            decay = drag.angular_drag_rate(self.angular_drag, self.inertia)
            turned = drag.orientation(q[:, 2], rate[:, 2], spin, decay, elapsed)
            turning = drag.angular_velocity(rate[:, 2], spin, decay, elapsed)
        return np.stack((*place, turned), axis=-1), np.stack((*later, turning), axis=-1)


class _Sum:
    """A path as the sum of the exact one and of what the kicks change."""

    def __init__(self, exact: PathPiece, change: PathPiece, first: State, last: State) -> None:
        self.start, self.end = exact.start, exact.end
        self._parts = (exact, change)
        self._first, self._last = first, last

    def at(self, time: float) -> State:
        """Return the state at a time in s, to the bit at both ends."""
        if time == self.start:
            return self._first
        if time == self.end:
            return self._last
        (p, turn, v, spin), (dp, more, dv, faster) = (part.at(time) for part in self._parts)
        position, velocity = (p[0] + dp[0], p[1] + dp[1]), (v[0] + dv[0], v[1] + dv[1])
        return State(position, turn + more, velocity, spin + faster)

    def acceleration(self, time: float) -> Acceleration:
        """Return the acceleration at a time in s."""
        (x, y, turn), (dx, dy, more) = (part.acceleration(time) for part in self._parts)
        return x + dx, y + dy, turn + more

    def bounds(self, first: float, last: float) -> Bounds:
        """Return what holds from `first` to `last`, s."""
        exact, change = (part.bounds(first, last) for part in self._parts)
        (x, y), (dx, dy) = exact.acceleration, change.acceleration
        rest = (a + b for a, b in zip(exact[1:], change[1:], strict=True))
        return Bounds((x + dx, y + dy), *rest)

    def sample(self, times: Array) -> Array:
        """Return (k, 6) at times (k,), s."""
        return sampled(self, times)


@dataclass(frozen=True)
class _Kicked(DenseStep):
    """A step of n bodies; the coefficients are those of what the kicks change."""

    exact: _Exact
    paths: Sequence[Dragged]

    def at(self, time: float) -> tuple[Array, Array]:
        """Return coordinates and rates (n, 3) at a time in s, to the bit at both ends."""
        if time in (self.start, self.end):
            return super().at(time)
        q, rate = self.exact.moved(time - self.start, *self.first)
        more, faster = super().at(time)
        return q + more, rate + faster

    def piece(self, body: int) -> PathPiece:
        """Return the path of one of the bodies."""
        first, last = (state_of(q[body], rate[body]) for q, rate in (self.first, self.last))
        return _Sum(self.paths[body], super().piece(body), first, last)


class ExponentialSteps(FixedSteps):
    """Exponential steps on a grid."""

    plain = False

    def __init__(self, scene: Scene, duration: float, time_step: float) -> None:
        super().__init__(schemes.velocity_verlet, duration, time_step)
        self._scene = scene
        self._loads = Loads(scene)
        self._last: tuple[MemoisedField, _Exact] | None = None

    def step(
        self, field: MemoisedField, start: float, limit: float, position: Array, velocity: Array
    ) -> DenseStep:
        """Step to the next time of the grid; from between two of them by a shorter step."""
        end = self._end(start, limit)
        exact = self._exact(field)
        kick = field(start, position, velocity) - exact.acceleration(velocity)
        q, rate = self.advance(field, start, end - start, position, velocity)
        moved, faster = exact.moved(end - start, position, velocity)
        last_kick = field(end, q, rate) - exact.acceleration(faster)
        none = np.zeros_like(position)
        change = hermite(start, end, (none, none, kick), (q - moved, rate - faster, last_kick))
        paths = [
            Dragged(
                self._scene.bodies[i],
                start,
                end,
                state_of(position[row], velocity[row]),
                self._loads.steady(i),
                field.constraints[row],
            )
            for row, i in enumerate(field.bodies)
        ]
        return _Kicked(
            start, end, (position, velocity), (q, rate), change.coefficients, exact, paths
        )

    def advance(
        self, field: MemoisedField, start: float, time_step: float, position: Array, velocity: Array
    ) -> tuple[Array, Array]:
        """Return coordinates and rates (n, 3) after one step from `start`, s."""
        exact = self._exact(field)
        return schemes.exponential_verlet(
            start,
            time_step,
            position,
            velocity,
            lambda time, q, rate: field(time, q, rate) - exact.acceleration(rate),
            lambda _, elapsed, q, rate: exact.moved(elapsed, q, rate),
        )

    def _exact(self, field: MemoisedField) -> _Exact:
        if self._last is None or self._last[0] is not field:
            self._last = (field, self._solved(field))
        return self._last[1]

    def _solved(self, field: MemoisedField) -> _Exact:
        bodies = [self._scene.bodies[i] for i in field.bodies]
        steady = [
            constraint(self._loads.steady(i), _ANY) if constraint else self._loads.steady(i)
            for i, constraint in zip(field.bodies, field.constraints, strict=True)
        ]
        return _Exact(
            np.array([body.mass for body in bodies]),
            np.array([body.linear_drag for body in bodies]),
            np.array([body.inertia for body in bodies]),
            np.array([body.angular_drag for body in bodies]),
            np.array(steady).reshape(-1, 3),
        )
