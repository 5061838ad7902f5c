"""Steps of jointed bodies: they end where joints hold, and at what these do in an instant."""

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from functools import cached_property

import numpy as np

from tamias2d.motion.adaptive import Adaptive
from tamias2d.motion.fixed_steps import FixedSteps
from tamias2d.motion.held_splitting import HeldSplitting
from tamias2d.motion.integrator import Integrator
from tamias2d.motion.joint_decision import begin
from tamias2d.motion.joint_instant import Now
from tamias2d.motion.joint_search import JointSearch
from tamias2d.motion.limited_mechanism import LimitedMechanism
from tamias2d.motion.loads import Field, Loads, state_of
from tamias2d.motion.mechanisms import fitted
from tamias2d.motion.memoised_field import MemoisedField
from tamias2d.motion.polynomial import DenseStep, moved_end
from tamias2d.motion.quiet_steps import quiet
from tamias2d.motion.step_batch import StepBatch
from tamias2d.state import Array, ExertingConstraint

_REFINED = 6  # times that a step is taken anew to end at an event of a joint


class JointedSteps:
    """Takes the steps of some bodies by an integrator; joints may hold them."""

    def __init__(
        self,
        loads: Loads,
        integrator: Integrator,
        field: MemoisedField,
        constraints: Iterable[object],
    ) -> None:
        """Take the accelerations of bodies, and the constraints on them by lasting contacts."""
        self._integrator = integrator
        self._field = field
        self._loads = loads
        self.mechanisms = loads.mechanisms(field.bodies)
        """Those that hold some, with the rows of the bodies in each."""
        constraints = [each for each in constraints if each is not None]
        self._constrained = bool(constraints)
        self._pressing: list[ExertingConstraint] = []
        """What lasting contacts do to these bodies, each once."""
        for constraint in constraints:
            if isinstance(constraint, ExertingConstraint) and constraint not in self._pressing:
                self._pressing.append(constraint)
        self._limited = [
            (own, one) for own, one in self.mechanisms if isinstance(one, LimitedMechanism)
        ]

    def until(
        self,
        start: float,
        end: float,
        position: Array,
        velocity: Array,
        *,
        most: Callable[[], int] = lambda: 1,
    ) -> Iterator[DenseStep | StepBatch]:
        """Yield steps from a time to another, s, or to the first event of a joint.

        Up to `most` are one where they can be taken at once.
        """
        if self.mechanisms and start == 0:
            position, velocity = fitted(self.mechanisms, start, position, velocity)
        if self._limited:
            velocity = self._begun(start, position, velocity)
        taken = 0
        while start < end:
            many = most()
            some = min(many, max(taken, 1)) if self._limited else many  # those beyond it are lost
            batch = self._batch(start, end, position, velocity, some)
            taken += 1 if batch is None else len(batch.times) - 1
            if batch is not None:
                middles = (np.array(batch.times[:-1]) + batch.times[1:]) / 2
                self._grow(middles, batch.at)
                yield batch if many > 1 else batch.step(0)
                start, (position, velocity) = batch.end, batch.last
                continue
            step = self._step(start, end, position, velocity)
            event = self._event(step)
            step = event or step
            self._grow(np.array([(step.start + step.end) / 2]), step.states)
            yield step
            if event:
                return  # what follows is another motion
            start, (position, velocity) = step.end, step.last

    def _batch(
        self, start: float, end: float, position: Array, velocity: Array, most: int
    ) -> StepBatch | None:
        """Return several steps if all are known, and surely nothing else happens in joints."""
        steps = self._integrator
        if self._constrained or not isinstance(steps, FixedSteps | Adaptive):
            return None
        marching = self._loads.marching(self._field.bodies, start)
        if marching is None:
            return None
        field, now = self._field, (position, velocity)
        undo = steps.undone(field, start, end, *now)
        batch = steps.marched(field, marching, start, end, *now, most=most)
        if batch is None:
            return None
        count = min((quiet(one, own, batch) for own, one in self._limited), default=most)
        if count >= len(batch.times) - 1:
            return batch
        undo()  # what follows an event is another motion
        return steps.marched(field, marching, start, end, *now, most=count) if count else None

    def _grow(self, times: Array, states: Callable[[Array], Array]) -> None:
        """Let mechanisms know how large they have been, by states at times, s."""
        if self._limited:
            positions = states(times)[:, 0]
            for own, one in self._limited:
                one.grow(positions[:, own])

    @cached_property
    def _free(self) -> Field:
        """Accelerations without what joints exert."""
        return self._loads.free_field(self._field.bodies)

    @cached_property
    def _without_contacts(self) -> Field:
        """Accelerations with what joints exert, but no contacts."""
        bodies = self._field.bodies
        return self._loads.field(bodies, [None] * len(bodies))

    def _pull(self, time: float, position: Array, velocity: Array) -> Array:
        """Return the accelerations by loads and by contacts that last, without joints."""
        pull = self._free(time, position, velocity)
        if not self._pressing:
            return pull
        pull, place = pull.copy(), {body: k for k, body in enumerate(self._field.bodies)}
        free = self._without_contacts(time, position, velocity)
        for constraint in self._pressing:
            own = [place[body] for body in constraint.bodies]
            states = [state_of(position[k], velocity[k]) for k in own]
            exerted = constraint.exerted(time, free[own], states)
            pull[own] += self._loads.inverse[list(constraint.bodies)] * exerted
        return pull

    def _step(self, start: float, end: float, position: Array, velocity: Array) -> DenseStep:
        """Return a step that ends where the joints hold."""
        with self._stepped_from(start):
            step = self._integrator.step(self._field, start, end, position, velocity)
        if not self.mechanisms or isinstance(self._integrator, HeldSplitting):
            return step
        return moved_end(step, *fitted(self.mechanisms, step.end, *step.last))

    @contextmanager
    def _stepped_from(self, start: float) -> Iterator[None]:
        """Let joints do what they do from a time in s on, whatever time they are asked for."""
        try:
            for _, one in self._limited:
                one.stepped_from = start
            yield
        finally:
            for _, one in self._limited:
                one.stepped_from = -np.inf

    def _begun(self, start: float, position: Array, velocity: Array) -> Array:
        """Return the velocities with which joints begin what they do from here on."""
        pull = self._pull(start, position, velocity)
        velocity = velocity.copy()
        for own, mechanism in self._limited:
            now = Now(start, position[own], velocity[own], pull[own])
            velocity[own] = begin(mechanism, now, anew=bool(self._pressing))
        self._field.forget()
        if isinstance(self._integrator, HeldSplitting):
            self._integrator.kicks.forget()
        return velocity

    def _event(self, step: DenseStep) -> DenseStep | None:
        """Return a step that ends at the first event of a joint, if one is within the step.

        It is taken anew up to the event, where the ends of steps are known better than their
        middles, until the event is at its end.
        """
        found = [
            (hit[0], k, hit[1])
            for k, (own, one) in enumerate(self._limited)
            if (hit := JointSearch(one, own, self._pull, step).first())
        ]
        if not found:
            return None
        time, k, watch = min(found, key=lambda each: each[0])
        own, mechanism = self._limited[k]
        for _ in range(_REFINED):
            if not step.start < time:
                time = float(np.nextafter(step.start, np.inf))
            shorter = self._step(step.start, time, *step.first)
            if shorter.end < time:  # it is further off than a step may be here
                return self._event(shorter) or shorter
            later = JointSearch(mechanism, own, self._pull, shorter).zero(watch)
            beyond = not step.start < later <= step.end  # a step is too coarse to say more
            if abs(later - time) <= 4 * np.spacing(time) or beyond:
                break
            time = later
        mechanism.expect(watch.cause(shorter.end))
        return shorter
