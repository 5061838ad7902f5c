"""Steps of a generated scheme, all of one length but for the last and those around impacts."""

from collections.abc import Callable
from itertools import pairwise
from typing import Any, TypeAlias

import numpy as np

from tamias2d.errors import TamiasError
from tamias2d.generated.schemes import SPLITTING
from tamias2d.motion.loads import Field
from tamias2d.motion.marching import HeldMarching, Start, name_of
from tamias2d.motion.memoised_field import MemoisedField
from tamias2d.motion.polynomial import DenseStep, hermite
from tamias2d.motion.step_batch import MovedBatch, StepBatch
from tamias2d.state import Array

Scheme: TypeAlias = Callable[[float, float, Array, Array, Field], tuple[Any, Any]]
"""One generated step: time, time step, coordinates, rates, accelerations -> coordinates, rates."""


class FixedSteps:
    """Steps of a scheme that end at the multiples of the time step, and at the end of the run."""

    best_at_ends = True
    plain = True
    """Whether the path of a step is the polynomial through its ends."""

    def __init__(self, scheme: Scheme, duration: float, time_step: float) -> None:
        self.scheme = scheme
        self.times = grid(duration, time_step)

    @property
    def splits(self) -> bool:
        """Whether a step consists of kicks and drifts."""
        return name_of(self.scheme) in SPLITTING

    def step(
        self, field: MemoisedField, start: float, limit: float, position: Array, velocity: Array
    ) -> DenseStep:
        """Step to the next time of the grid; from between two of them by a shorter step."""
        end = self._end(start, limit)
        first = (position, velocity, field(start, position, velocity))
        q, rate = self.advance(field, start, end - start, position, velocity)
        return hermite(start, end, first, (q, rate, field(end, q, rate)))

    def batch(
        self,
        field: MemoisedField,
        start: float,
        limit: float,
        position: Array,
        velocity: Array,
        *,
        most: int,
    ) -> StepBatch:
        """Take several steps at once, fewer where a force has no value further on.

        Raises:
            TamiasError: there is no value within the first step.
        """
        times, ahead = self.ends(start, limit, most)
        if field.marching is not None:
            now = Start(position, velocity, field.known(start, position, velocity))
            steps = field.marching.fixed(name_of(self.scheme), times, now, ahead)
            if steps is not None and field.took(steps):
                return StepBatch(steps.times, steps.knots)
            times = times if steps is None else times[:2]
        batch = self._one_by_one(field, times, position, velocity)
        if field.marching is not None:
            field.settle(batch.end, *batch.last)
        return batch

    def ends(self, start: float, limit: float, most: int) -> tuple[list[float], int]:
        """Return a time, s, and the next ends of steps after it; and how many there are in all."""
        first = int(np.searchsorted(self.times, start, side="right"))
        ends = self.times[first : first + most]
        count = int(np.searchsorted(ends, limit))  # up to the first that is not before it
        times = [start, *ends[:count].tolist(), *([limit] if count < len(ends) else [])]
        return times, len(self.times) - first

    def marched(
        self,
        field: MemoisedField,
        marching: HeldMarching,
        start: float,
        limit: float,
        position: Array,
        velocity: Array,
        *,
        most: int,
    ) -> StepBatch | None:
        """Take several steps of jointed bodies at once, fewer where it is open how one ends.

        None are returned where that is the first.
        """
        times, ahead = self.ends(start, limit, most)
        now = Start(position, velocity, field.known(start, position, velocity))
        steps = marching.fixed(name_of(self.scheme), times, now, ahead)
        if steps is None or not field.took(steps):
            return None
        return MovedBatch(StepBatch(steps.times, steps.knots, reached=steps.reached))

    def undone(
        self,
        field: MemoisedField,
        start: float,
        limit: float,  # noqa: ARG002
        position: Array,
        velocity: Array,
    ) -> Callable[[], None]:
        """Return what takes back all steps that are taken from a state on."""
        return field.undone(start, position, velocity)

    def _one_by_one(
        self, field: MemoisedField, times: list[float], position: Array, velocity: Array
    ) -> StepBatch:
        q, rate = position, velocity
        knots = [(q, rate, field(times[0], q, rate))]
        for k, (start, end) in enumerate(pairwise(times)):
            try:
                q, rate = self.advance(field, start, end - start, q, rate)
                knots.append((q, rate, field(end, q, rate)))
            except TamiasError:  # it may be beyond a wall
                if k == 0:
                    raise
                break
        return StepBatch(times[: len(knots)], np.array(knots))

    def _end(self, start: float, limit: float) -> float:
        return min(limit, float(self.times[np.searchsorted(self.times, start, side="right")]))

    def advance(
        self, field: MemoisedField, start: float, time_step: float, position: Array, velocity: Array
    ) -> tuple[Array, Array]:
        """Return coordinates and rates (n, 3) after one step from `start`, s."""
        after: tuple[Array, Array] = self.scheme(start, time_step, position, velocity, field)
        return after


def grid(duration: float, time_step: float) -> Array:
    """Return the times of all steps, s: the last one is shorter if the duration asks for it."""
    count = max(round(duration / time_step), 1)
    if abs(count * time_step - duration) > 1e-9 * time_step:  # more than rounding
        count = int(np.ceil(duration / time_step))
    times = np.arange(count + 1, dtype=np.float64) * time_step
    times[-1] = duration
    return times
