"""Motion by integration: the steps of an integrator as paths of bodies."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import TypeAlias

import numpy as np

from tamias2d.errors import TamiasError
from tamias2d.motion.adaptive import Adaptive
from tamias2d.motion.answers import Answers
from tamias2d.motion.constrained import ConstrainedMotion
from tamias2d.motion.error_equation import ErrorEquation, Held, Watch, rule_beside
from tamias2d.motion.fixed_steps import FixedSteps
from tamias2d.motion.halved import Halved, Halving
from tamias2d.motion.held_splitting import HeldSplitting
from tamias2d.motion.integrator import Integrator
from tamias2d.motion.joint_code import JointCodes
from tamias2d.motion.joint_events import JointEvents, joint_events
from tamias2d.motion.jointed_steps import JointedSteps
from tamias2d.motion.law_resolution import LawResolution, States
from tamias2d.motion.loads import (
    HeldMarchingOf,
    Loads,
    MarchingOf,
    StateOf,
    coordinates,
    quicker,
    start_states,
)
from tamias2d.motion.marching import Rule
from tamias2d.motion.mechanisms import fitted
from tamias2d.motion.memoised_field import MemoisedField
from tamias2d.motion.motion import Tally
from tamias2d.motion.polynomial import DenseStep, JoinedPath
from tamias2d.motion.step_batch import BatchPath, StepBatch
from tamias2d.motion.uniform import Uniform
from tamias2d.path import PathPiece
from tamias2d.scene import Scene
from tamias2d.scene.acting import (
    felt_velocity,
    loads_feel_velocity,
    only_slowed,
)
from tamias2d.state import Acceleration, Array, Constraint, History, SharedConstraint, State
from tamias2d.work_limit import Work, WorkLimitError

_STILL: Acceleration = (0.0, 0.0, 0.0)
_NEAR = 1e-3  # of a step: so close to its ends a path is as good as there
_MOST = 64  # steps that are taken at once
_LONGEST = 256  # of a scene in which nothing meets
_SHARE = 2  # of the steps since the last impact are taken at once: what is beyond the next is lost


_Batching: TypeAlias = FixedSteps | Adaptive | Halved | ErrorEquation


class IntegratedMotion(Answers):
    """Paths by an integrator; what is static stands still."""

    def __init__(
        self, scene: Scene, duration: float, integrator: Integrator, notes: tuple[str, ...] = ()
    ) -> None:
        self._scene = scene
        self._duration = duration
        self._integrator = integrator
        self._batching: _Batching | None = _batching(integrator)
        self._steps_since_impact = 0  # steps without an impact
        self.tally = Tally()
        self.work = Work(duration)
        self.sampled: History | None = None
        self._loads = Loads(scene)
        self._resolution = LawResolution(scene, duration)
        self._constrained = ConstrainedMotion(scene, self._loads, self.tally, self._resolution)
        self._felt_velocity = bool(self._loads.varying) and felt_velocity(scene)
        self._fields: dict[tuple[int, ...], MemoisedField] = {}
        self._held: dict[tuple[int, ...], tuple[MemoisedField, HeldSplitting]] = {}
        self.marching: MarchingOf = lambda _: None
        """What takes many steps at once of bodies that act on no others, if anything does."""
        self.moving = [i for i, body in enumerate(scene.bodies) if body.dynamic]
        """The bodies that move."""
        self.unresolved: str | None = None
        self.notes = notes + self._loads.joint_notes(self.moving)

    def take_joint_codes(self, codes: JointCodes, makers: MarchingOf, held: HeldMarchingOf) -> None:
        """Let code that is made for mechanisms find the reactions of joints, loads and steps."""
        self._loads.take_codes(codes, makers, held)

    def segment(
        self, start: float, states: Sequence[State], constraints: Sequence[Constraint | None]
    ) -> tuple[float, list[PathPiece]]:
        """Return the end of one step, or of some, and the path of every body to it.

        Where nothing is held and nothing has met for a while, several steps are taken at once.
        """
        free = [i for i in self.moving if not _state_dependent(constraints[i])]
        field = self._field(free, constraints)
        now = coordinates([states[i] for i in free])
        held = any(constraints) or self._loads.mechanisms(free)
        plain = isinstance(self._integrator, FixedSteps) and not held
        many = min(self._steps_since_impact // _SHARE, _MOST) if plain else 1
        step = next(self._batches(field, start, self._duration, now, many))
        self._steps_since_impact += len(step.times) - 1 if isinstance(step, StepBatch) else 1
        end = step.end
        paths: dict[int, PathPiece] = {body: step.piece(k) for k, body in enumerate(free)}
        constrained = [i for i in self.moving if i not in paths]
        paths |= self.restart(constrained, start, states.__getitem__, end, constraints)
        pieces: list[PathPiece] = [
            paths.get(i) or Uniform(start=start, end=end, state=state, acceleration=_STILL)
            for i, state in enumerate(states)
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
        """Return the paths from `start` towards `end`, s, of some bodies and of all they act on.

        Where a constraint depends on the state, the path is one step, of a body on which no other
        acts. A path ends before its time where a force has no value further on: it may be beyond a
        wall.
        """
        pieces: dict[int, PathPiece] = {}
        alone = []
        for body in bodies:
            constraint = constraints[body]
            if not isinstance(constraint, SharedConstraint):
                alone.append(body)
            elif body not in pieces:
                pieces |= self._constrained.restart_together(
                    constraint, start, state, end, self.work
                )
        groups = {min(group): group for group in map(self._loads.group_of.__getitem__, alone)}
        self._steps_since_impact *= not (groups or pieces)
        for group in groups.values():
            body = group[0]
            if (constraint := constraints[body]) and constraint.state_dependent:
                pieces[body] = self._constrained.restart(
                    body, start, state(body), end, constraint, self.work
                )
                continue
            field = self._field(group, constraints)
            now = coordinates([state(i) for i in group])
            many = 1 if any(constraints[i] for i in group) else _MOST
            steps = list(_begun(self._batches(field, start, end, now, many)))
            if self._loads.mechanisms(group):  # their paths are those of steps one by one
                steps = list(_apart(steps))
            for k, body in enumerate(group):
                parts: list[PathPiece] = [step.piece(k) for step in steps]
                parts = parts or [_instant(start, state(body))]
                pieces[body] = parts[0] if len(parts) == 1 else JoinedPath(parts)
        return pieces

    def approach(
        self,
        bodies: Iterable[int],
        time: float,
        path: Callable[[int], PathPiece],
        constraints: Sequence[Constraint | None],
    ) -> dict[int, PathPiece]:
        """Return paths of some bodies, and of all they act on, with the end of a step at `time`, s.

        They begin and end with their paths of now. Nothing is returned for those that are as good
        as they can be there.
        """
        if not self._integrator.best_at_ends:
            return {}
        groups = {min(group): group for group in map(self._loads.group_of.get, bodies) if group}
        pieces: dict[int, PathPiece] = {}
        for group in groups.values():
            if any(_state_dependent(constraints[i]) for i in group):
                continue
            now = path(group[0])
            start, end = now.around(time) if isinstance(now, BatchPath) else (now.start, now.end)
            near = _NEAR * (end - start)
            if start + near < time < end - near:
                pieces |= self._split_at(group, time, start, path, constraints)
        return pieces

    def _split_at(
        self,
        group: Sequence[int],
        time: float,
        start: float,
        path: Callable[[int], PathPiece],
        constraints: Sequence[Constraint | None],
    ) -> dict[int, PathPiece]:
        """Return the paths of now until `start`, from where on a step ends at `time`."""
        end = path(group[0]).end
        before = self.restart(group, start, lambda i: path(i).at(start), time, constraints)
        after = self.restart(group, time, lambda i: before[i].at(time), end, constraints)
        pieces: dict[int, PathPiece] = {}
        for body in group:
            now = path(body)
            kept = [now.until(start)] if isinstance(now, BatchPath) and now.start < start else []
            pieces[body] = JoinedPath([*kept, before[body], after[body]])
        return pieces

    def struck(
        self, time: float, impulses: Mapping[int, Acceleration], state: StateOf
    ) -> dict[int, Acceleration]:
        """Return what impulses on jointed bodies change at a time in s, in their mechanisms."""
        return self._loads.struck(time, impulses, state)

    def history(self, times: Array) -> History:
        """Return the states at sorted times (k,), s: all bodies at once."""
        states = coordinates(start_states(self._scene))
        rows = np.repeat(np.stack(states)[None], len(times), axis=0)
        if len(self.moving) == 0:
            self.sampled = history_of(rows)
            return self.sampled
        field = self._field(self.moving, [None] * len(self._scene))
        moving = (states[0][self.moving], states[1][self.moving])
        done = int(np.searchsorted(times, 0.0, side="right"))
        quick = field.marching is not None or self._loads.mechanisms(self.moving)
        most = _LONGEST if quick else 1
        try:
            for step in self._followed(field, moving, most):
                until = int(np.searchsorted(times, step.end, side="right"))
                if isinstance(step, StepBatch):
                    rows[done:until, :, self.moving] = step.at(times[done:until])
                else:
                    for k in range(done, until):
                        rows[k, :, self.moving] = np.stack(step.at(float(times[k])), axis=1)
                done = until
        finally:
            self.sampled = history_of(rows[:done])
        return self.sampled

    def _followed(
        self, field: MemoisedField, now: tuple[Array, Array], most: int
    ) -> Iterator[DenseStep | StepBatch]:
        """Yield all steps of the run, through the events of joints."""
        start = 0.0
        while start < self._duration:
            for step in self._batches(field, start, self._duration, now, most):
                yield step
                start, now = step.end, step.last

    @property
    def halving(self) -> Halving | None:
        """How far coordinates are at most from those by whole steps, which are taken in halves.

        None for other steps, and where whole ones could not be followed to the end of the run.
        """
        if not isinstance(self._integrator, Halved) or self._integrator.apart is None:
            return None
        apart, still = self._integrator.apart, np.zeros(3)
        rows = np.array([apart.get(k, still) for k in range(len(self._scene))])
        return Halving(rows, self._integrator.sudden)

    def integrate_error(self, watch: Watch) -> None:
        """Integrate the error of the path from here on, if steps are chosen."""
        if isinstance(self._integrator, Adaptive):
            self._batching = ErrorEquation(self._integrator, watch, sweeps=self._sweeps)

    @property
    def error_rule(self) -> tuple[Rule, int]:
        """How the error within a step is found: by which quadrature, and how often."""
        assert isinstance(self._integrator, Adaptive)
        return rule_beside(self._integrator), self._sweeps

    @property
    def _sweeps(self) -> int:
        """The first knows rates within a step badly; where these are felt, one more knows them.

        Where loads feel them a third does: a damper may be so strong that it all but stops what
        moves within one step.
        """
        if not self._felt_velocity or only_slowed(self._scene):
            return 1
        return 3 if loads_feel_velocity(self._scene) else 2

    def beside(self) -> MemoisedField:
        """Return the accelerations of all bodies that move, of which nothing is remembered yet."""
        return self._field(self.moving, [None] * len(self._scene)).beside()

    @property
    def missed(self) -> bool:
        """Whether steps had to be shorter than errors said, as for what a law does for a moment."""
        return isinstance(self._integrator, Adaptive) and self._integrator.missed

    @property
    def largest_error(self) -> Array | None:
        """The largest error (n, 3) of each coordinate, m and rad, where it was integrated."""
        if not isinstance(self._batching, ErrorEquation) or self._batching.largest is None:
            return None
        rows = np.zeros((len(self._scene), 3))
        rows[self.moving] = self._batching.largest
        return rows

    def joint_events(self) -> JointEvents:
        """Return what has happened in joints."""
        return joint_events(self._loads.timeline.events)

    def _field(
        self, bodies: Sequence[int], constraints: Sequence[Constraint | None]
    ) -> MemoisedField:
        """Return the accelerations of some bodies; the same object while the constraints last."""
        held = tuple(constraints[i] for i in bodies)
        known = self._fields.get(tuple(bodies))
        if known is None or known.constraints != held:
            marching = None if any(held) else self.marching(bodies)
            field = quicker(self._loads.field(bodies, held), marching)
            known = MemoisedField(
                field,
                bodies,
                held,
                self.tally,
                felt_velocity=self._felt_velocity,
                marching=marching,
            )
            self._fields[tuple(bodies)] = known
        return known

    def _stepping(self, field: MemoisedField) -> Integrator:
        """Return what steps some bodies; the same object while their accelerations last."""
        steps, found = self._integrator, self._loads.mechanisms(field.bodies)
        if not (found and isinstance(steps, FixedSteps) and steps.splits):
            return steps
        known = self._held.get(field.bodies)
        if known is None or known[0] is not field:
            kicks = MemoisedField(
                self._loads.loaded_field(field.bodies, field.constraints),
                field.bodies,
                field.constraints,
                self.tally,
                felt_velocity=loads_feel_velocity(self._scene),
            )
            known = self._held[field.bodies] = field, HeldSplitting(steps, found, kicks)
        return known[1]

    def _note_missed(self, field: MemoisedField, times: Sequence[float], states: States) -> None:
        """Note what steps have missed of a law, where they could not be shorter for it."""
        if not isinstance(self._integrator, FixedSteps) or self.unresolved is not None:
            return
        missed = self._resolution.unresolved(field.bodies, times, states, given=True)
        if missed is not None:
            self.unresolved = str(missed)
            self.notes += (self.unresolved,)

    def _jointed(
        self, field: MemoisedField, start: float, end: float, now: tuple[Array, Array], most: int
    ) -> Iterator[DenseStep | StepBatch]:
        """Yield steps, up to the first event of a joint: one by one where it is not known there."""
        jointed = JointedSteps(self._loads, self._stepping(field), field, field.constraints)
        watched = self._batching if jointed.mechanisms else None
        watched = watched if isinstance(watched, ErrorEquation) else None

        def many() -> int:
            return most if watched is None else min(most, watched.at_once)

        for step in jointed.until(start, end, *now, most=many):
            if watched is not None:
                first = step.times[0] if isinstance(step, StepBatch) else step.start
                marching = self._loads.marching(field.bodies, first)
                watched.follow(field, step, Held(partial(fitted, jointed.mechanisms), marching))
            if isinstance(step, StepBatch):
                yield from self._counted(field, step)
                continue
            self._note_missed(field, (step.start, step.end), step.states)
            self.tally.steps += 1
            if not isinstance(self._integrator, FixedSteps):
                self.work.step(step.end)
            yield step

    def _batches(
        self, field: MemoisedField, start: float, end: float, now: tuple[Array, Array], most: int
    ) -> Iterator[DenseStep | StepBatch]:
        """Yield steps, up to `most` of them as one where the integrator can do that."""
        joined = self._loads.mechanisms(field.bodies)
        compared = isinstance(self._batching, Halved | ErrorEquation)
        alone = most <= 1 and field.marching is None and not compared
        if joined or self._batching is None or alone:
            yield from self._jointed(field, start, end, now, most)
            return
        while start < end:
            batch = self._batching.batch(field, start, end, *now, most=max(most, 1))
            yield from self._counted(field, batch)
            start, now = batch.end, batch.last

    def _counted(self, field: MemoisedField, batch: StepBatch) -> Iterator[StepBatch]:
        """Yield steps as far as the work that is allowed goes."""
        self._note_missed(field, batch.times, batch.at)
        for k, time in enumerate(batch.times[1:]):
            self.tally.steps += 1
            if not isinstance(self._integrator, FixedSteps):
                try:
                    self.work.step(time)
                except WorkLimitError:
                    if k:
                        yield batch.only(k)
                    raise
        yield batch


def _batching(integrator: Integrator) -> _Batching | None:
    """Return an integrator that can take several steps at once."""
    if isinstance(integrator, FixedSteps):
        return integrator if integrator.plain else None
    return integrator if isinstance(integrator, Adaptive | Halved) else None


def _state_dependent(constraint: Constraint | None) -> bool:
    return constraint is not None and constraint.state_dependent


def _begun(steps: Iterator[DenseStep | StepBatch]) -> Iterator[DenseStep | StepBatch]:
    """Yield steps up to one that cannot be taken, which is no fault but of the first."""
    begun = False
    try:
        for step in steps:
            yield step
            begun = True
    except WorkLimitError:
        raise
    except TamiasError:
        if not begun:
            raise


def _apart(steps: Iterable[DenseStep | StepBatch]) -> Iterator[DenseStep]:
    """Yield steps one by one."""
    for step in steps:
        yield from step.steps() if isinstance(step, StepBatch) else (step,)


def _instant(time: float, state: State) -> PathPiece:
    """Return the path of a body that was hit at the very end of its time."""
    return Uniform(start=time, end=time, state=state, acceleration=_STILL)


def history_of(rows: Array) -> History:
    """Return coordinates and rates (k, 2, n, 3) as a history."""
    return History(
        rows[:, 0, :, :2].copy(),
        rows[:, 0, :, 2].copy(),
        rows[:, 1, :, :2].copy(),
        rows[:, 1, :, 2].copy(),
    )
