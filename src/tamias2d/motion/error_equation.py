"""The error of a path by adaptive steps, integrated beside them (R5).

A path P of steps misses the accelerations f by a defect. How far the exact motion is ahead of it,
e, begins with nothing and solves e'' = f(P + e, P' + e') - P'' (Skeel, Thirteen ways to estimate
global error, Numerische Mathematik 48, 1986, section 7, after Zadunaisky). Few digits of e are
wanted, so that an explicit scheme of low order does; but over a step the defect nearly cancels,
which takes a quadrature of a higher order than the steps have: Lobatto's.

Joints hold exact motion too: as steps do, P + e returns to them after each (GD18).
"""

from collections.abc import Callable, Sequence
from functools import cache
from itertools import pairwise
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.polynomial import legendre

from tamias2d.errors import SimulationError
from tamias2d.motion.adaptive import Adaptive
from tamias2d.motion.marching import Error, HeldMarching, Rule
from tamias2d.motion.memoised_field import MemoisedField
from tamias2d.motion.polynomial import DenseStep, derivative
from tamias2d.motion.step_batch import StepBatch
from tamias2d.state import Array

_AT_ONCE, _SHARE = 4, 4
"""So many steps, or this share of those before, are taken before somebody may have seen enough."""

Fitted: TypeAlias = Callable[[float, Array, Array], tuple[Array, Array]]
"""Moves coordinates and rates (n, 3) at a time in s to where joints hold; raises `JointError`."""


class Held(NamedTuple):
    """How joints hold some bodies."""

    fitted: Fitted
    marching: HeldMarching | None
    """What knows that for many steps at once, if anything does."""


Watch: TypeAlias = Callable[[float, Array, Array], None]
"""Hears of the time reached, s, and of the largest errors and extents (n, 3) so far, m and rad."""


class ErrorEquation:
    """Takes the steps of a pair, and integrates the error of their path."""

    def __init__(self, steps: Adaptive, watch: Watch, *, sweeps: int) -> None:
        self._steps = steps
        self._watch = watch
        self._sweeps = sweeps
        self._rule = rule_beside(steps)
        self._taken = 0  # steps
        self._end: tuple[float, Array, Array] | None = None
        self._error: Error | None = None
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
        most = min(most, self.at_once)
        steps = self._steps.batch(field, start, limit, position, velocity, most=most)
        self._go_on(field, _Path(steps.times, steps.knots[:, :2], steps.coefficients), None)
        return steps

    @property
    def at_once(self) -> int:
        """How many steps are taken before somebody may have seen enough."""
        return max(_AT_ONCE, self._taken // _SHARE)

    def follow(self, field: MemoisedField, steps: StepBatch | DenseStep, held: Held) -> None:
        """Integrate the error over steps that were taken, and that end where joints hold."""
        if isinstance(steps, StepBatch):
            path = _Path(steps.times, steps.knots[:, :2], steps.coefficients)
        else:
            states = np.stack([np.stack(steps.first), np.stack(steps.last)])
            path = _Path([steps.start, steps.end], states, steps.coefficients[:, None])
        self._go_on(field, path, held)

    def _go_on(self, field: MemoisedField, path: "_Path", held: Held | None) -> None:
        """Integrate the error over some steps, unless something hides it, and tell who watches."""
        self._taken += len(path.times) - 1
        if self.largest is not None:
            self.largest = self._followed(field, path, held)
        if self._steps.missed:
            self.largest = None
        if self.largest is not None:
            self._watch(path.times[-1], self.largest, self._high - self._low)

    def _followed(self, field: MemoisedField, path: "_Path", held: Held | None) -> Array | None:
        """Return the largest errors up to the end of some steps, whose errors are integrated."""
        first, last = (path.times[0], *path.states[0]), (path.times[-1], *path.states[-1])
        beside = field.beside()
        try:
            if self._error is None:
                still = np.zeros_like(first[1])
                self._error = Error(np.stack((still, still, beside(*first))), still.copy())
                self._low = self._high = first[1]
            elif self._end is None or not _same(self._end, first):
                return None
            self._low = np.minimum(self._low, path.states[:, 0].min(axis=0))
            self._high = np.maximum(self._high, path.states[:, 0].max(axis=0))
            self._end = last
            nodes = along(path.coefficients, np.diff(path.times) / 2, self._rule.nodes)
            if held is not None:
                self._returned(beside, path, nodes, self._error, held)
            elif not self._integrated(beside, path.times, nodes, self._error):
                return None
        except SimulationError:
            return None
        return self._error.largest if np.isfinite(self._error.state).all() else None

    def _returned(
        self, field: MemoisedField, path: "_Path", nodes: Array, error: Error, held: Held
    ) -> None:
        """Integrate the error over steps of jointed bodies, at once where that is known."""
        rule, times, ends = self._rule, path.times, path.states[1:]
        if held.marching is not None:
            known = held.marching.follow(times, nodes, ends, rule, self._sweeps, error)
            if known:
                count = self._sweeps * (len(rule.nodes) - 1)
                field.tally.force_evaluations += count * (len(times) - 1)
                return
        for k, (time, end) in enumerate(pairwise(times)):
            follow_step(field, rule, self._sweeps, time, end - time, nodes[k], error)
            _return_to_joints(error, (end, *ends[k]), held.fitted)

    def _integrated(
        self, field: MemoisedField, times: Sequence[float], paths: Array, error: Error
    ) -> bool:
        """Integrate the error over some steps, at once if the field can; return whether it did.

        Raises:
            SimulationError: a force has no value beside them.
        """
        rule = self._rule
        if field.marching is not None:
            done = field.marching.follow(times, paths, rule, self._sweeps, error)
            if done is not None:
                nodes = self._sweeps * (len(rule.nodes) - 1)
                field.tally.force_evaluations += nodes * (len(times) - 1)
                return done
        for time, end, path in zip(times[:-1], times[1:], paths, strict=True):
            follow_step(field, rule, self._sweeps, time, end - time, path, error)
        return True


class _Path(NamedTuple):
    """Some steps, as what lies between them needs them."""

    times: Sequence[float]
    """(k + 1,), s"""
    states: Array
    """(k + 1, 2, n, 3): coordinates and rates at these times"""
    coefficients: Array
    """(m, k, n, 3), as those of a `StepBatch`"""


def _return_to_joints(error: Error, end: tuple[float, Array, Array], fitted: Fitted) -> None:
    """Move the exact motion at the end of a step to where the joints hold it."""
    time, position, velocity = end
    ahead, rate = error.state[:2]
    place, speed = fitted(time, position + ahead, velocity + rate)
    error.state[:2] = place - position, speed - velocity


def follow_step(
    field: MemoisedField,
    rule: Rule,
    sweeps: int,
    time: float,
    step: float,
    path: Array,
    error: Error,
) -> None:
    """Go on over a step, s, whose path (3, m, n, 3) is that of places, rates, accelerations."""
    nodes, early, whole = rule
    ahead, rate, pull = error.state
    lacking = np.empty_like(path[0])
    lacking[0] = pull - path[2, 0]

    def within(i: int, of: Array, last: int) -> tuple[Array, Array]:
        turn, bend = (_summed(weights[i, :last], lacking) for weights in of)
        way = ahead + step * nodes[i] * rate + step * step * bend
        return way, rate + step * turn

    for sweep in range(sweeps):
        field.forget()  # what a sweep finds as before is counted as code that knows no memory does
        for i in range(1, len(nodes)):
            way, turned = within(i, *((whole, len(nodes)) if sweep else (early, i)))
            pull = field(time + step * nodes[i], path[0, i] + way, path[1, i] + turned)
            lacking[i] = pull - path[2, i]
    for i in range(1, len(nodes)):
        way, turned = within(i, whole, len(nodes))
        np.maximum(error.largest, np.abs(way), out=error.largest)
    error.state[:] = way, turned, pull


def _same(one: tuple[float, Array, Array], other: tuple[float, Array, Array]) -> bool:
    """Whether times, coordinates and rates are those of the same state."""
    equal = (np.array_equal(mine, theirs) for mine, theirs in zip(one[1:], other[1:], strict=True))
    return one[0] == other[0] and all(equal)


def _summed(weights: Array, rows: Array) -> Array:
    """Return the weighted sum of the first of some rows: in this order, as compiled code has it."""
    total: Array = weights[0] * rows[0]
    for weight, row in zip(weights[1:], rows[1:], strict=False):
        total = total + weight * row
    return total


def rule_beside(steps: Adaptive) -> Rule:
    """Return the quadrature of the error of steps."""
    return lobatto((steps.power + 5) // 2)


@cache
def lobatto(count: int) -> Rule:
    """Return Lobatto's quadrature with so many nodes."""
    inner = legendre.legroots(legendre.legder(np.eye(count)[-1]))
    nodes = (np.concatenate(([-1.0], np.sort(inner), [1.0])) + 1) / 2
    early, whole = np.zeros((2, 2, count, count))
    for i, node in enumerate(nodes.tolist()):
        whole[:, i] = _weights(nodes, node)
        early[:, i, :i] = _weights(nodes[:i], node)
    return Rule(nodes, early, whole)


def along(powers: Array, half: Array, nodes: Array) -> Array:
    """Return coordinates, rates and accelerations (k, 3, m, n, 3) at the nodes of k steps.

    Of each half the length is given (k,), s, and the coefficients of its path (j, k, n, 3).
    """
    half = half[:, None, None]
    x = (2 * nodes - 1).reshape(-1, 1, 1, 1)
    found = np.empty((3, len(nodes), *powers.shape[1:]))
    for order in range(3):
        terms = derivative(powers, order)
        value = terms[-1]
        for term in terms[-2::-1]:
            value = value * x + term
        found[order] = value / half**order
    return np.ascontiguousarray(np.moveaxis(found, 2, 0))


def _weights(nodes: Array, until: float) -> Array:
    """Return the weights (2, i) of values at i nodes in an integral to a place, and in its own."""
    powers = np.arange(len(nodes))
    values = np.linalg.inv(np.vander(nodes, increasing=True)) if len(nodes) else np.zeros((0, 0))
    once = until ** (powers + 1) / (powers + 1)
    twice = until ** (powers + 2) / ((powers + 1) * (powers + 2))
    found: Array = np.stack((once @ values, twice @ values))
    return found
