"""Motion along a lasting contact whose normal turns.

The contact's force depends on the state, so that the path is integrated whatever the method.
"""

import math

from tamias2d.motion.loads import Loads, coordinates
from tamias2d.motion.memoised_field import MemoisedField
from tamias2d.motion.motion import Tally
from tamias2d.motion.reference import ScipyDop853
from tamias2d.path import Piece
from tamias2d.scene import Scene
from tamias2d.state import Constraint, State
from tamias2d.work_limit import Work

_TOLERANCE = 1e-13
"""Relative; as far as float64 goes."""


class ConstrainedMotion:
    """Paths of single bodies under state-dependent constraints, step by step."""

    def __init__(self, scene: Scene, tally: Tally) -> None:
        self._scene = scene
        self._tally = tally
        self._loads = Loads(scene)
        self._integrators: dict[int, ScipyDop853] = {}

    def restart(
        self, body: int, start: float, state: State, end: float, constraint: Constraint, work: Work
    ) -> Piece:
        """Return one step of the path of a body from `start` towards `end`, s."""
        if body not in self._integrators:
            self._integrators[body] = ScipyDop853(_TOLERANCE, self._scale(body, start, state))
        field = MemoisedField(
            self._loads.field([body], [constraint]), [body], [constraint], self._tally
        )
        q, rate = coordinates([state])
        piece = self._integrators[body].step(field, start, end, q, rate).piece(0)
        work.step(piece.end)
        return piece

    def _scale(self, body: int, time: float, state: State) -> tuple[float, float]:
        """Return the body's size, m, and the time in which it moves by as much, s."""
        shape = self._scene.bodies[body].shape
        size = shape.bounding_radius if shape else 1.0
        pull = math.hypot(*self._loads.acceleration(body, time, lambda _: state)[:2])
        speed = math.hypot(*state.velocity) + abs(state.angular_velocity) * size
        return size, size / (speed + math.sqrt(pull * size))
