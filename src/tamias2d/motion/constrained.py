"""Motion along a lasting contact whose normal turns.

The contact's force depends on the state, so that the path is integrated whatever the method.
"""

import math

from tamias2d.motion.jointed_steps import JointedSteps
from tamias2d.motion.law_resolution import LawResolution
from tamias2d.motion.loads import Loads, StateOf, coordinates, state_of
from tamias2d.motion.memoised_field import MemoisedField
from tamias2d.motion.motion import Tally
from tamias2d.motion.reference import ScipyDop853
from tamias2d.motion.uniform import Uniform
from tamias2d.path import PathPiece
from tamias2d.scene import Scene
from tamias2d.state import Array, Constraint, SharedConstraint, State
from tamias2d.work_limit import Work

_STILL = (0.0, 0.0, 0.0)
_TOLERANCE = 1e-13
"""Relative; as far as float64 goes."""


class ConstrainedMotion:
    """Paths of bodies under state-dependent constraints, step by step."""

    def __init__(self, scene: Scene, loads: Loads, tally: Tally, resolution: LawResolution) -> None:
        self._scene = scene
        self._tally = tally
        self._resolution = resolution
        self._loads = loads
        self._integrators: dict[int, ScipyDop853] = {}
        self._coupled: dict[tuple[int, ...], ScipyDop853] = {}

    def restart(
        self, body: int, start: float, state: State, end: float, constraint: Constraint, work: Work
    ) -> PathPiece:
        """Return one step of the path of a body from `start` towards `end`, s."""
        if body not in self._integrators:
            scale = self._scale(body, start, end, lambda _: state)
            self._integrators[body] = ScipyDop853(_TOLERANCE, scale, self._resolution)
        field = MemoisedField(
            self._loads.field([body], [constraint]), [body], [constraint], self._tally
        )
        q, rate = coordinates([state])
        piece = self._integrators[body].step(field, start, end, q, rate).piece(0)
        work.step(piece.end)
        return piece

    def restart_together(
        self,
        constraint: SharedConstraint,
        start: float,
        state: StateOf,
        end: float,
        work: Work,
    ) -> dict[int, PathPiece]:
        """Return one step of the paths of all bodies that a constraint holds, towards `end`, s."""
        bodies = constraint.bodies
        states = [state(i) for i in bodies]
        if not start < end:
            return {
                body: Uniform(start=start, end=start, state=now, acceleration=_STILL)
                for body, now in zip(bodies, states, strict=True)
            }
        if bodies not in self._coupled:
            scales = [self._scale(i, start, end, state) for i in bodies]
            scale = min(length for length, _ in scales), min(time for _, time in scales)
            self._coupled[bodies] = ScipyDop853(_TOLERANCE, scale, self._resolution)
        loads = self._loads.field(bodies, [None] * len(bodies))

        def held(time: float, position: Array, velocity: Array) -> Array:
            rows = zip(position, velocity, strict=True)
            now = [state_of(place, rate) for place, rate in rows]
            return constraint.together(time, loads(time, position, velocity), now)

        field = MemoisedField(held, bodies, [None] * len(bodies), self._tally)
        steps = JointedSteps(self._loads, self._coupled[bodies], field, [constraint])
        step = next(steps.until(start, end, *coordinates(states)))
        work.step(step.end)
        return {body: step.piece(k) for k, body in enumerate(bodies)}

    def _scale(self, body: int, start: float, end: float, state: StateOf) -> tuple[float, float]:
        """Return the body's size, m, and the time in which it moves by as much, s.

        For one that nothing moves yet that is the time to the `end`.
        """
        shape, now = self._scene.bodies[body].shape, state(body)
        size = shape.bounding_radius if shape else 1.0
        pull = math.hypot(*self._loads.acceleration(body, start, state)[:2])
        speed = math.hypot(*now.velocity) + abs(now.angular_velocity) * size
        moves = speed + math.sqrt(pull * size)
        return size, size / moves if moves > 0 else end - start
