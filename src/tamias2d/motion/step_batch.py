"""A batch of steps as one path, so that contacts are searched for once and not step by step."""

from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Self

import numpy as np

from tamias2d.generated.schemes import Pair
from tamias2d.motion.loads import state_of
from tamias2d.motion.polynomial import (
    DenseStep,
    JoinedPath,
    Polynomial,
    dense_path,
    derivative,
    moved_path,
    quintic,
    sampled,
)
from tamias2d.path import Bounds, PathPiece
from tamias2d.state import Acceleration, Array, State


class StepBatch:
    """Steps of n bodies from each of the `times` (k + 1,), s, to the next.

    `knots` (k + 1, 3, n, 3) are coordinates, rates and accelerations at these times. Paths go
    through all of these; those of an embedded pair follow its slopes `dense` (m, k, n, 3) instead.
    Where something moves the end of each step, `reached` (k, 3, n, 3) is where it led before.
    """

    def __init__(
        self,
        times: list[float],
        knots: Array,
        dense: Array | None = None,
        reached: Array | None = None,
    ) -> None:
        self.times = times
        self.end = times[-1]
        self.knots = knots
        self.dense = dense
        self.reached = knots[1:] if reached is None else reached

    @classmethod
    def of_pair(cls, start: float, end: float, first: tuple[Array, Array], pair: Pair) -> Self:
        """Return a batch of one step of an embedded pair."""
        still = np.zeros_like(first[0])
        knots = np.stack(
            [np.stack((*first, still)), np.stack((pair.position, pair.velocity, still))]
        )
        return cls([start, end], knots, np.array(pair.dense)[:, None])

    @property
    def last(self) -> tuple[Array, Array]:
        """Coordinates and rates (n, 3) at the end."""
        return self.knots[-1, 0], self.knots[-1, 1]

    def piece(self, body: int) -> PathPiece:
        """Return the path of one of the bodies."""
        return BatchPath(self, body, 0, len(self.times) - 1)

    def only(self, count: int) -> "StepBatch":
        """Return the first of the steps."""
        dense = None if self.dense is None else self.dense[:, :count]
        knots, reached = self.knots[: count + 1], self.reached[:count]
        return StepBatch(self.times[: count + 1], knots, dense, reached)

    def step(self, k: int) -> DenseStep:
        """Return one of the steps."""
        first, last = ((knot[0], knot[1]) for knot in (self.knots[k], self.reached[k]))
        return DenseStep(self.times[k], self.times[k + 1], first, last, self.coefficients[:, k])

    def steps(self) -> Iterator[DenseStep]:
        """Yield the steps one by one."""
        return map(self.step, range(len(self.times) - 1))

    def at(self, times: Array) -> Array:
        """Return coordinates and rates (k, 2, n, 3) at times (k,), s, within the steps.

        To the bit what each step alone says, which is what is known of its ends.
        """
        after = np.searchsorted(self.times[1:], times, side="left")
        start = np.take(self.times, after)
        rows = np.where(
            (times == start)[:, None, None, None],
            self.knots[after, :2],
            self.reached[after, :2],
        )
        inside = np.flatnonzero((times != start) & (times != np.take(self.times, after + 1)))
        if not len(inside):
            return rows
        within = after[inside]
        half = self.half[within]
        x = ((times[inside] - start[inside]) / half - 1)[:, None, None]
        value = slope = np.zeros_like(rows[inside, 0])
        for c in self.coefficients[::-1, within]:
            slope = slope * x + value
            value = value * x + c
        rows[inside, 0], rows[inside, 1] = value, slope / half[:, None, None]
        return rows

    @cached_property
    def half(self) -> Array:
        """(k,), half the length of each step, s."""
        return np.diff(self.times) / 2

    @cached_property
    def coefficients(self) -> Array:
        """(m, k, n, 3), as those of a `DenseStep`."""
        if self.dense is not None:
            start = self.knots[:-1, 0], self.knots[:-1, 1]
            length = np.diff(self.times)[:, None, None]
            return dense_path(length, start, self.reached[:, 0], tuple(self.dense))
        first, last = np.moveaxis(self.knots[:-1], 1, 0), np.moveaxis(self.reached, 1, 0)
        return quintic(self.half[:, None, None], tuple(first), tuple(last))

    @cached_property
    def bounds(self) -> Array:
        """(k, n, 6): those of each step, in the order of `Bounds`."""
        half = self.half[:, None, None]
        rates = np.abs(derivative(self.coefficients, 1)).sum(axis=0) / half
        second = derivative(self.coefficients, 2) / half**2
        spread = np.abs(second[1:]).sum(axis=0)
        columns = (
            second[0, ..., 0],
            second[0, ..., 1],
            np.hypot(spread[..., 0], spread[..., 1]),
            np.hypot(rates[..., 0], rates[..., 1]),
            rates[..., 2],
            np.abs(second[0, ..., 2]) + spread[..., 2],
        )
        return np.stack(columns, axis=-1)


class MovedBatch(StepBatch):
    """Steps whose ends are moved to where the next begins, as `moved_end` moves that of one."""

    def __init__(self, steps: StepBatch) -> None:
        super().__init__(steps.times, steps.knots, steps.dense)
        self._steps = steps

    def only(self, count: int) -> StepBatch:
        """Return the first of the steps."""
        return MovedBatch(self._steps.only(count))

    @cached_property
    def coefficients(self) -> Array:
        """(m, k, n, 3), as those of a `DenseStep`."""
        way, change = np.moveaxis(self.knots[1:, :2] - self._steps.reached[:, :2], 1, 0)
        length = np.diff(self.times)[:, None, None]
        return moved_path(self._steps.coefficients, way, change * length)


def joined(parts: Sequence[StepBatch]) -> StepBatch:
    """Return batches of steps of a pair that follow each other as one."""
    if len(parts) == 1:
        return parts[0]
    times = [parts[0].times[0], *(time for part in parts for time in part.times[1:])]
    knots = [parts[0].knots[:1], *(part.knots[1:] for part in parts)]
    dense = [part.dense for part in parts if part.dense is not None]
    return StepBatch(times, np.concatenate(knots), np.concatenate(dense, axis=1))


class BatchPath:
    """The path of one body over some of the steps of all."""

    def __init__(self, all_steps: StepBatch, body: int, first: int, last: int) -> None:
        self.start = all_steps.times[first]
        self.end = all_steps.times[last]
        self._all = all_steps
        self._body = body
        self._span = first, last
        self._known: dict[int, Polynomial] = {}

    @property
    def times(self) -> list[float]:
        """The ends of its steps, s."""
        first, last = self._span
        return self._all.times[first : last + 1]

    def around(self, time: float) -> tuple[float, float]:
        """Return start and end of the step that a time falls into, s."""
        k = self._index(time)
        return self._all.times[k], self._all.times[k + 1]

    def until(self, time: float) -> "BatchPath":
        """Return the path up to one of its times between steps, s."""
        first, _ = self._span
        return BatchPath(self._all, self._body, first, bisect_left(self._all.times, time))

    def at(self, time: float) -> State:
        """Return the state at a time in s, to the bit between two steps."""
        return self._step(time).at(time)

    def acceleration(self, time: float) -> Acceleration:
        """Return the acceleration at a time in s."""
        return self._step(time).acceleration(time)

    def bounds(self, first: float, last: float) -> Bounds:
        """Return what holds from `first` to `last`, s: over all steps that they touch."""
        low, high = self._index(first), self._index(last) + 1
        if (low, high) == self._span:
            return self._whole
        return self._over(low, high)

    def sample(self, times: Array) -> Array:
        """Return (k, 6) at times (k,), s."""
        return sampled(self, times)

    @cached_property
    def _whole(self) -> Bounds:
        return self._over(*self._span)

    def _over(self, low: int, high: int) -> Bounds:
        rows = self._all.bounds[low:high, self._body]
        least, most = rows.min(axis=0), rows.max(axis=0)
        x, y = ((least[:2] + most[:2]) / 2).tolist()
        off = rows[:, 2] + np.hypot(rows[:, 0] - x, rows[:, 1] - y)
        return Bounds((x, y), float(off.max()), *most[3:].tolist())

    def _index(self, time: float) -> int:
        first, last = self._span
        return min(max(bisect_right(self._all.times, time) - 1, first), last - 1)

    def _step(self, time: float) -> Polynomial:
        k = self._index(time)
        if k not in self._known:
            times, knots, body = self._all.times, self._all.knots, self._body
            self._known[k] = Polynomial(
                times[k],
                times[k + 1],
                state_of(knots[k, 0, body], knots[k, 1, body]),
                state_of(knots[k + 1, 0, body], knots[k + 1, 1, body]),
                self._all.coefficients[:, k, body].tolist(),
            )
        return self._known[k]


def breaks(piece: PathPiece) -> Sequence[float]:
    """Return the times, s, between which a piece is a polynomial."""
    match piece:
        case BatchPath():
            return piece.times
        case JoinedPath():
            return [time for part in piece.pieces for time in breaks(part)]
    return piece.start, piece.end
