"""Exact motion under constant force and torque: the closed forms of IM1 and IM2.

Serves: runs whose loads are constant. Hides: the closed forms' arguments.
"""

from collections.abc import Sequence

import numpy as np

from tamias2d.generated import rotation, translation
from tamias2d.motion.bent import Bent
from tamias2d.motion.loads import Loads, coordinates, start_states
from tamias2d.motion.piece import Piece
from tamias2d.motion.uniform import Uniform
from tamias2d.scene import Scene
from tamias2d.state import Acceleration, Array, History, Hold, State


class ClosedFormMotion:
    """Exact paths, each to the end of the run."""

    def __init__(self, scene: Scene, duration: float) -> None:
        self._scene = scene
        self._duration = duration
        self._loads = Loads(scene)
        self._bent = Bent(scene)

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
    ) -> Piece:
        """Return the path of one body from `start` to `end`, s, or one step where it bends."""
        if hold and hold.bends:
            return self._bent.restart(body, start, state, end, hold)
        acceleration = self._loads.acceleration(body, start)
        if hold:
            acceleration = hold(acceleration, state)
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
