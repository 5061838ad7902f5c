"""Motion by integration: paths from whatever steps an integrator takes.

Serves: the schemes and the reference. Hides: how steps become a path.
"""

from collections.abc import Iterator, Sequence
from typing import Protocol

import numpy as np

from tamias2d.motion.bent import Bent
from tamias2d.motion.loads import Field, Loads, coordinates, start_states
from tamias2d.motion.piece import Piece
from tamias2d.motion.polynomial import Stretch
from tamias2d.motion.uniform import Uniform
from tamias2d.scene import Scene
from tamias2d.state import Acceleration, Array, History, Hold, State

_STILL: Acceleration = (0.0, 0.0, 0.0)


class Integrator(Protocol):
    """A scheme, with its choice of steps."""

    def step(
        self, field: Field, start: float, limit: float, position: Array, velocity: Array
    ) -> Stretch:
        """Step coordinates and rates (n, 3) from `start` towards `limit`, s, and not past it."""


class IntegratedMotion:
    """Paths by an integrator; what is static stands still."""

    def __init__(self, scene: Scene, duration: float, integrator: Integrator) -> None:
        self._scene = scene
        self._duration = duration
        self._integrator = integrator
        self._loads = Loads(scene)
        self._bent = Bent(scene)
        self._moving = [i for i, body in enumerate(scene.bodies) if body.dynamic]

    def segment(
        self, start: float, states: Sequence[State], holds: Sequence[Hold | None]
    ) -> tuple[float, list[Piece]]:
        """Return the end of one step and the path of every body to it."""
        straight = [i for i in self._moving if not ((hold := holds[i]) and hold.bends)]
        field = self._loads.field(straight, [holds[i] for i in straight])
        q, rate = coordinates([states[i] for i in straight])
        stretch = self._integrator.step(field, start, self._duration, q, rate)
        end = stretch.end
        stepped = {body: stretch.piece(k) for k, body in enumerate(straight)}
        pieces: list[Piece] = []
        for i, state in enumerate(states):
            if i in stepped:
                pieces.append(stepped[i])
            elif self._scene.bodies[i].dynamic:
                pieces.append(self.restart(i, start, state, end, holds[i]))
            else:
                pieces.append(Uniform(start=start, end=end, state=state, acceleration=_STILL))
        return end, pieces

    def restart(
        self, body: int, start: float, state: State, end: float, hold: Hold | None
    ) -> Piece:
        """Return one step of the path of one body from `start` towards `end`, s."""
        if hold and hold.bends:
            return self._bent.restart(body, start, state, end, hold)
        field = self._loads.field([body], [hold])
        return self._integrator.step(field, start, end, *coordinates([state])).piece(0)

    def free(self, body: int, time: float) -> Acceleration:
        """Return the acceleration of a body that nothing holds, at a time in s."""
        return self._loads.acceleration(body, time)

    def history(self, times: Array) -> History:
        """Return the states at sorted times (k,), s: all bodies at once."""
        states = coordinates(start_states(self._scene))
        rows = np.repeat(np.stack(states)[None], len(times), axis=0)
        field = self._loads.field(self._moving, [None] * len(self._moving))
        moving = (states[0][self._moving], states[1][self._moving])
        done = int(np.searchsorted(times, 0.0, side="right"))
        for stretch in self._stretches(field, 0.0, self._duration, *moving):
            until = int(np.searchsorted(times, stretch.end, side="right"))
            for k in range(done, until):
                rows[k, :, self._moving] = np.stack(stretch.at(float(times[k])), axis=1)
            done = until
        return history_of(rows)

    def _stretches(
        self, field: Field, start: float, end: float, position: Array, velocity: Array
    ) -> Iterator[Stretch]:
        while start < end:
            stretch = self._integrator.step(field, start, end, position, velocity)
            yield stretch
            start, (position, velocity) = stretch.end, stretch.last


def history_of(rows: Array) -> History:
    """Return coordinates and rates (k, 2, n, 3) as a history."""
    return History(
        rows[:, 0, :, :2].copy(),
        rows[:, 0, :, 2].copy(),
        rows[:, 1, :, :2].copy(),
        rows[:, 1, :, 2].copy(),
    )
