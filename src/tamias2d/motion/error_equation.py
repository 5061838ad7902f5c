"""The error of a path by adaptive steps, integrated beside them (R5).

A path P of steps misses the accelerations f by a defect. How far the exact motion is ahead of it,
e, begins with nothing and solves e'' = f(P + e, P' + e') - P'' (Skeel, Thirteen ways to estimate
global error, Numerische Mathematik 48, 1986, section 7, after Zadunaisky). Few digits of e are
wanted, so that an explicit scheme of low order does; but over a step the defect nearly cancels,
which takes a quadrature of a higher order than the steps have: Lobatto's.
"""

from collections.abc import Callable
from typing import TypeAlias

import numpy as np
from numpy.polynomial import legendre

from tamias2d.errors import SimulationError
from tamias2d.motion.adaptive import Adaptive
from tamias2d.motion.memoised_field import MemoisedField
from tamias2d.motion.polynomial import derivative
from tamias2d.motion.step_batch import StepBatch
from tamias2d.state import Array

_AT_ONCE = 16  # steps, after which somebody may have seen enough

Watch: TypeAlias = Callable[[float, Array, Array], None]
"""Hears of the time reached, s, and of the largest errors and extents (n, 3) so far, m and rad."""


class ErrorEquation:
    """Takes the steps of a pair, and integrates the error of their path."""

    def __init__(self, steps: Adaptive, watch: Watch, *, sweeps: int) -> None:
        self._steps = steps
        self._watch = watch
        self._sweeps = sweeps
        """The first knows rates within a step badly; where these are felt, one more knows them."""
        self._rule = _Rule((steps.power + 5) // 2)
        self._end: tuple[float, Array, Array] | None = None
        self._last: tuple[Array, Array, Array] | None = None
        self._low = self._high = np.zeros((0, 3))
        self.largest: Array | None = np.zeros((0, 3))
        """(n, 3): of each coordinate of the bodies that move, m and rad.

        None where another path was begun, as impacts do, where a force has no value beside it, and
        where a law did what errors of steps had not told of.
        """

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
        """Take several steps at once, if the field can; raises as those do."""
        most = min(most, _AT_ONCE)
        steps = self._steps.batch(field, start, limit, position, velocity, most=most)
        if self.largest is not None:
            try:
                self.largest = self._followed(field, steps, self.largest)
            except SimulationError:
                self.largest = None
        if self._steps.missed:
            self.largest = None
        if self.largest is not None:
            self._watch(steps.end, self.largest, self._high - self._low)
        return steps

    def _followed(self, field: MemoisedField, steps: StepBatch, largest: Array) -> Array | None:
        """Return the largest errors up to the end of some steps, whose errors are integrated."""
        first = steps.times[0], steps.knots[0, 0], steps.knots[0, 1]
        beside = field.beside()
        if self._last is None:
            still = np.zeros_like(first[1])
            self._last = still, still, beside(*first)
            self._low = self._high = first[1]
            largest = still
        elif self._end is None or not _same(self._end, first):
            return None
        paths = self._rule.along(steps)
        for k, (time, end) in enumerate(zip(steps.times[:-1], steps.times[1:], strict=True)):
            within = self._step(beside, time, end - time, paths[:, :, k])
            largest = np.maximum(largest, np.abs(within).max(axis=0))
        self._low = np.minimum(self._low, steps.knots[:, 0].min(axis=0))
        self._high = np.maximum(self._high, steps.knots[:, 0].max(axis=0))
        self._end = steps.end, *steps.last
        return largest if np.isfinite(largest).all() else None

    def _step(self, field: MemoisedField, time: float, step: float, path: Array) -> Array:
        """Go on over a step, s, and return the errors (m, n, 3) within it.

        The path (3, m, n, 3) is that of coordinates, rates and accelerations.
        """
        assert self._last is not None
        rule = self._rule
        ahead, rate, pull = self._last
        ways = ahead + step * np.multiply.outer(rule.nodes, rate)
        lacking = np.empty_like(ways)
        lacking[0] = pull - path[2, 0]
        for sweep in range(self._sweeps):
            for i in range(1, len(rule.nodes)):
                weights, of = (rule.all[:, i], lacking) if sweep else (rule.early[i], lacking[:i])
                turn, bend = np.tensordot(weights, of, 1)
                pull = field(
                    time + step * rule.nodes[i],
                    path[0, i] + ways[i] + step * step * bend,
                    path[1, i] + rate + step * turn,
                )
                lacking[i] = pull - path[2, i]
        turns, bends = np.tensordot(rule.all, lacking, 1)
        within: Array = ways + step * step * bends
        self._last = within[-1], rate + step * turns[-1], pull
        return within


def _same(one: tuple[float, Array, Array], other: tuple[float, Array, Array]) -> bool:
    """Whether times, coordinates and rates are those of the same state."""
    equal = (np.array_equal(mine, theirs) for mine, theirs in zip(one[1:], other[1:], strict=True))
    return one[0] == other[0] and all(equal)


class _Rule:
    """Lobatto's quadrature with m nodes, and from its nodes to any of them."""

    def __init__(self, count: int) -> None:
        inner = legendre.legroots(legendre.legder(np.eye(count)[-1]))
        self.nodes = (np.concatenate(([-1.0], np.sort(inner), [1.0])) + 1) / 2
        self.early = [_weights(self.nodes[:i], self.nodes[i]) for i in range(count)]
        """From the nodes before it: (2, i) of the integral up to a node, and of that once more"""
        self.all = np.stack([_weights(self.nodes, node) for node in self.nodes], axis=1)
        """The same from all nodes, (2, m, m)"""

    def along(self, steps: StepBatch) -> Array:
        """Return coordinates, rates and accelerations (3, m, k, n, 3) at the nodes of k steps."""
        powers = steps.coefficients
        half = steps.half[:, None, None]
        found = np.empty((3, len(self.nodes), *powers.shape[1:]))
        for order in range(3):
            terms = derivative(powers, order)
            basis = np.vander(2 * self.nodes - 1, len(terms), increasing=True)
            found[order] = np.tensordot(basis, terms, 1) / half**order
        return found


def _weights(nodes: Array, until: float) -> Array:
    """Return the weights (2, i) of values at i nodes in an integral to a place, and in its own."""
    powers = np.arange(len(nodes))
    values = np.linalg.inv(np.vander(nodes, increasing=True)) if len(nodes) else np.zeros((0, 0))
    once = until ** (powers + 1) / (powers + 1)
    twice = until ** (powers + 2) / ((powers + 1) * (powers + 2))
    found: Array = np.stack((once @ values, twice @ values))
    return found
