"""Exact motion: the closed forms of IM1 and IM2, of IM6 and of IM7."""

from collections.abc import Iterable, Sequence

import numpy as np

from tamias2d.generated import rotation, translation
from tamias2d.motion.answers import Answers
from tamias2d.motion.constrained import ConstrainedMotion
from tamias2d.motion.dragged import Dragged
from tamias2d.motion.joint_events import JointEvents, joint_events
from tamias2d.motion.law_resolution import LawResolution
from tamias2d.motion.loads import Loads, StateOf, coordinates, start_states
from tamias2d.motion.motion import Tally
from tamias2d.motion.oscillating import Oscillating
from tamias2d.motion.track import sample
from tamias2d.motion.uniform import Uniform
from tamias2d.path import PathPiece
from tamias2d.scene import Scene
from tamias2d.scene.exact import closed_forms, spring_of
from tamias2d.state import Acceleration, Array, Constraint, History, SharedConstraint, State
from tamias2d.work_limit import Work


class ClosedFormMotion(Answers):
    """Exact paths, each to the end of the run."""

    def __init__(self, scene: Scene, duration: float) -> None:
        self.tally = Tally()
        self.work = Work(duration)
        self.sampled: History | None = None
        self.notes: tuple[str, ...] = ()
        self.unresolved: str | None = None
        self._scene = scene
        self._duration = duration
        self._loads = Loads(scene)
        self._constrained = ConstrainedMotion(
            scene, self._loads, self.tally, LawResolution(scene, duration)
        )
        self._forms = closed_forms(scene)

    def segment(
        self, start: float, states: Sequence[State], constraints: Sequence[Constraint | None]
    ) -> tuple[float, list[PathPiece]]:
        """Return the end of the run and the path of every body to it."""
        end = self._duration
        pieces = [
            self._path(body, start, state, end, constraint)
            for body, (state, constraint) in enumerate(zip(states, constraints, strict=True))
        ]
        return end, pieces

    def restart(
        self,
        bodies: Iterable[int],
        start: float,
        state: StateOf,
        end: float,
        constraints: Sequence[Constraint | None],
    ) -> dict[int, PathPiece]:
        """Return the paths of some bodies from `start` to `end`, s; they act on no others.

        Where a constraint depends on the state, the path is one step.
        """
        pieces: dict[int, PathPiece] = {}
        for body in bodies:
            constraint = constraints[body]
            if isinstance(constraint, SharedConstraint):
                if body not in pieces:
                    pieces |= self._constrained.restart_together(
                        constraint, start, state, end, self.work
                    )
            else:
                pieces[body] = self._path(body, start, state(body), end, constraint)
        return pieces

    def approach(self, *_: object) -> dict[int, PathPiece]:
        """Return nothing: exact paths need not be better anywhere."""
        return {}

    def joint_events(self) -> JointEvents:
        """Return none: what has a closed form is held by no joint."""
        return joint_events()

    def struck(self, *_: object) -> dict[int, Acceleration]:
        """Return nothing: what has a closed form is held by no joint."""
        return {}

    def history(self, times: Array) -> History:
        """Return the states at times (k,), s."""
        if self._loads.varying:
            _, pieces = self.segment(0.0, start_states(self._scene), [None] * len(self._scene))
            return sample([[piece] for piece in pieces], times)
        return self._uniform(times)

    def _path(
        self, body: int, start: float, state: State, end: float, constraint: Constraint | None
    ) -> PathPiece:
        if constraint and constraint.state_dependent:
            return self._constrained.restart(body, start, state, end, constraint, self.work)
        steady = self._loads.steady(body)
        match self._forms.get(body):
            case "linear drag" | "angular drag":
                return Dragged(self._scene.bodies[body], start, end, state, steady, constraint)
            case "spring without length":
                spring = spring_of(self._scene, body)
                return Oscillating(
                    self._scene.bodies[body], spring, start, end, state, steady, constraint
                )
        acceleration = constraint(steady, state) if constraint else steady
        return Uniform(start=start, end=end, state=state, acceleration=acceleration)

    def _uniform(self, times: Array) -> History:
        """Return the states under constant loads: all bodies and times at once."""
        bodies = range(len(self._scene.bodies))
        q, rate = coordinates(start_states(self._scene))
        a = np.array([self._loads.steady(i) for i in bodies]).reshape(-1, 3)
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
