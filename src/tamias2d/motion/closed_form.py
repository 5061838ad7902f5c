"""Exact motion under constant force and torque: the closed forms of IM1 and IM2."""

import math
from collections.abc import Sequence

import numpy as np

from tamias2d.generated import rotation, translation
from tamias2d.motion.loads import Loads, coordinates, start_states
from tamias2d.motion.piece import Bounds, Piece
from tamias2d.scene import Scene
from tamias2d.state import Acceleration, Array, History, Hold, State, Vector


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
        position, orientation, velocity, angular_velocity = self.at(times)  # type: ignore[arg-type]
        columns = (*position, orientation, *velocity, angular_velocity)
        return np.stack([np.broadcast_to(column, times.shape) for column in columns], axis=-1)


class ClosedFormMotion:
    """Exact paths, each to the end of the run."""

    def __init__(self, scene: Scene, duration: float) -> None:
        self._scene = scene
        self._duration = duration
        self._loads = Loads(scene)

    def segment(
        self, start: float, states: Sequence[State], holds: Sequence[Hold | None]
    ) -> tuple[float, list[Piece]]:
        """Return the end of the run and the path of every body to it."""
        end = self._duration
        pieces: list[Piece] = [
            self.restart(i, start, state, end, hold)
            for i, (state, hold) in enumerate(zip(states, holds, strict=True))
        ]
        return end, pieces

    def restart(
        self, body: int, start: float, state: State, end: float, hold: Hold | None
    ) -> Uniform:
        """Return the path of one body from `start` to `end`, s."""
        acceleration = self._loads.acceleration(body, start, hold)
        return Uniform(start=start, end=end, state=state, acceleration=acceleration)

    def free(self, body: int, time: float) -> Acceleration:
        """Return the acceleration of a body that nothing holds, at a time in s."""
        return self._loads.acceleration(body, time)

    def history(self, times: Array) -> History:
        """Return the states at times (k,), s: all bodies and times at once."""
        bodies = range(len(self._scene.bodies))
        q, rate = coordinates(start_states(self._scene))
        a = np.array([self._loads.acceleration(i, 0.0) for i in bodies]).reshape(-1, 3)
        start, velocity, acceleration = ((x[:, 0], x[:, 1]) for x in (q, rate, a))
        t = times[:, None]
        shape = (len(times), len(bodies))
        orientation = rotation.orientation(q[:, 2], rate[:, 2], a[:, 2], t)
        return History(
            np.stack(translation.position(start, velocity, acceleration, t), axis=-1),
            np.broadcast_to(orientation, shape).copy(),
            np.stack(translation.velocity(velocity, acceleration, t), axis=-1),
            np.broadcast_to(rotation.angular_velocity(rate[:, 2], a[:, 2], t), shape).copy(),
        )
