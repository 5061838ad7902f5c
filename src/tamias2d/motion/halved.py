"""Adaptive steps, each taken in two halves: how far both ways are apart tells the error (R5).

The whole steps of a pair choose their length and go their own way; the halves follow over the same
times. By a scheme of order p these err 2^p times less, at every time and however errors grow, for
both have the same cause (Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I,
section II.8). The halves are what is returned.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tamias2d.motion.adaptive import Adaptive
from tamias2d.motion.marching import Start, name_of
from tamias2d.motion.memoised_field import MemoisedField
from tamias2d.motion.polynomial import DenseStep
from tamias2d.motion.step_batch import StepBatch, joined
from tamias2d.state import Array

_SUDDEN = 0.5  # of the step before is one that meets something sudden


class Halving(NamedTuple):
    """How far whole steps are from their halves."""

    apart: Array
    """(n, 3): coordinates of all bodies, at most"""
    sudden: bool
    """Whether some steps were suddenly far shorter than those before"""


@dataclass
class _Whole:
    """Where whole steps of some bodies are, and where their halves were by then."""

    of: MemoisedField
    field: MemoisedField
    time: float
    state: tuple[Array, Array]
    halved: tuple[Array, Array]
    length: float = 0.0
    """Of the last step, s."""

    def shortens(self, steps: StepBatch, limit: float) -> bool:
        """Return whether one of the steps that follow is far shorter than the one before it.

        The last one of all, up to the limit, may be.
        """
        lengths = np.array([self.length, *np.diff(steps.times)])
        self.length = float(lengths[-1])
        sudden = lengths[1:] < _SUDDEN * lengths[:-1]
        return bool(sudden[:-1].any() or (sudden[-1] and steps.end < limit))


class Halved:
    """The halves of the steps of a pair."""

    best_at_ends = False

    def __init__(self, whole: Adaptive) -> None:
        self._whole = whole
        self._known: dict[tuple[int, ...], _Whole] = {}
        self.apart: dict[int, Array] | None = {}
        """Of each body (3,): how far its coordinates were from those of whole steps, at most.

        None where something else changed a state, as impacts do, and whole steps began anew, and
        where a law did what errors had not told of: there halves do not err less by the order.
        """
        self.sudden = False
        """Whether steps met something sudden."""

    def step(
        self, field: MemoisedField, start: float, limit: float, position: Array, velocity: Array
    ) -> DenseStep:
        """Take the first half of a step, of the length that the tolerance allows.

        Raises:
            StepSizeError: it allows none.
        """
        return self.batch(field, start, limit, position, velocity, most=1).step(0)

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
        """Take several steps at once, if the field can; raises as `step` does."""
        known = self._at(field, start, position, velocity)
        whole = self._whole.batch(known.field, start, limit, *known.state, most=max(most // 2, 1))
        times = np.repeat(whole.times, 2)[:-1]
        times[1::2] = (times[:-1:2] + times[2::2]) / 2
        halves = self._halves(field, times.tolist(), position, velocity)
        self.sudden = known.shortens(whole, limit) or self.sudden
        if self._whole.missed:
            self.apart = None
        self._compare(field.bodies, whole, halves)
        known.time, known.state, known.halved = whole.end, whole.last, halves.last
        return halves

    def _at(self, field: MemoisedField, start: float, position: Array, velocity: Array) -> _Whole:
        """Return the whole steps that these halves belong to, or some that begin with them."""
        known = self._known.get(field.bodies)
        if known is not None:
            same = map(np.array_equal, known.halved, (position, velocity))
            if known.of is field and known.time == start and all(same):
                return known
            self.apart = None
        state = position, velocity
        self._known[field.bodies] = _Whole(field, field.beside(), start, state, state)
        return self._known[field.bodies]

    def _halves(
        self, field: MemoisedField, times: list[float], position: Array, velocity: Array
    ) -> StepBatch:
        """Step from each of the times, s, to the next."""
        parts: list[StepBatch] = []
        done, now = 0, (position, velocity)
        while done < len(times) - 1:
            parts.append(self._some(field, times[done:], *now))
            done, now = done + len(parts[-1].times) - 1, parts[-1].last
        return joined(parts)

    def _some(
        self, field: MemoisedField, times: list[float], position: Array, velocity: Array
    ) -> StepBatch:
        """Step from the first of some times, s, to the next, and from there on if that is quick."""
        if field.marching is not None:
            now = Start(position, velocity, field.known(times[0], position, velocity))
            steps = field.marching.along(name_of(self._whole.scheme), times, now)
            if steps is not None and field.took(steps):
                return StepBatch(steps.times, steps.knots, steps.dense)
        pair = self._whole.scheme(times[0], times[1] - times[0], position, velocity, field)
        if field.marching is not None:
            field.settle(times[1], pair.position, pair.velocity)
        return StepBatch.of_pair(times[0], times[1], (position, velocity), pair)

    def _compare(self, bodies: tuple[int, ...], whole: StepBatch, halves: StepBatch) -> None:
        """Note how far whole steps are from their halves, at their ends and in their middles."""
        if self.apart is None:
            return
        middles = whole.at(np.array(halves.times[1::2]))[:, 0]
        away = np.maximum(
            np.abs(whole.knots[1:, 0] - halves.knots[2::2, 0]),
            np.abs(middles - halves.knots[1::2, 0]),
        ).max(axis=0)
        for body, most in zip(bodies, away, strict=True):
            self.apart[body] = np.maximum(self.apart.get(body, 0.0), most)
