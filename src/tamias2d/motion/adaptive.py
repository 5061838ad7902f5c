"""Adaptive steps: an embedded pair estimates its error, which sets the length of the next step.

The error of a step is compared with the tolerance for each coordinate and rate, and the next step
is as long as the errors of this step and of the last suggest (Hairer, Norsett and Wanner, Solving
Ordinary Differential Equations I, section II.4).
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias

import numpy as np

from tamias2d.errors import SimulationError
from tamias2d.generated.schemes import Pair
from tamias2d.motion.law_resolution import LawResolution, States, Unresolved
from tamias2d.motion.marching import Control, HeldMarching, Marching, Start, name_of
from tamias2d.motion.memoised_field import MemoisedField
from tamias2d.motion.polynomial import DenseStep, dense_path
from tamias2d.motion.step_batch import MovedBatch, StepBatch
from tamias2d.spec.functions import Scalar, largest, sqrt
from tamias2d.state import Array

EmbeddedScheme: TypeAlias = Callable[[float, float, Array, Array, MemoisedField], Pair]

SAFETY = 0.9
LONGER, SHORTER = 6.0, 0.2  # a step is to the one before at most and at least
_SMALLEST = 16.0  # times the resolution of float64 at the time reached
CORRECTION = 0.01  # of an estimate by one of lower order (ibid., section II.10)
NONE = 1e-300  # of an error, beside which others can be divided


class StepSizeError(SimulationError):
    """No step that float64 can take meets the tolerance."""

    code = "step-size"


@dataclass(frozen=True)
class Tolerance:
    """What is allowed of an error: a share of the value, and a size for values that are small."""

    relative: float
    length: float
    """For positions, m; for orientations as many rad."""
    rate: float
    """For velocities, m/s and rad/s."""

    def of(self, position: Array, velocity: Array) -> tuple[Array, Array]:
        """Return what is allowed for coordinates and rates (n, 3) of this size."""
        return (
            self.length + self.relative * np.abs(position),
            self.rate + self.relative * np.abs(velocity),
        )


@dataclass
class Memory:
    """What one step of some bodies leaves to the next."""

    step: float
    """The length that the next one should have, s."""
    error: float = 1e-4
    """Of the last step, in shares of what is allowed."""


class Adaptive:
    """Steps of a pair whose error stays within a tolerance.

    `orders` are those of the error estimates, the highest first; `damping` is the weight of the
    last error but one in the choice of the next step.
    """

    best_at_ends = False

    def __init__(
        self,
        name: str,
        scheme: EmbeddedScheme,
        *,
        orders: Sequence[int],
        tolerance: Tolerance,
        damping: float,
        resolution: LawResolution,
    ) -> None:
        self._name = name
        self.scheme = scheme
        self.tolerance = tolerance
        # an estimate of order p errs as h^(p+1); two of them combine to the first squared
        # over the second
        powers = [order + 1 for order in orders]
        self.power = powers[0] if len(powers) == 1 else 2 * powers[0] - powers[1]
        self.damping = damping
        self._resolution = resolution
        self.missed = False
        """Whether some steps had to be shorter than errors said."""
        self._memory: dict[tuple[int, ...], Memory] = {}

    def step(
        self, field: MemoisedField, start: float, limit: float, position: Array, velocity: Array
    ) -> DenseStep:
        """Take one step, of the length that the tolerance and the laws allow.

        Raises:
            StepSizeError: it allows none.
            SimulationError: no force is finite as near ahead as float64 can tell.
        """
        while True:
            end, pair = self._accepted(field, start, limit, position, velocity)
            step = dense_step(start, end, (position, velocity), pair)
            missed = self._missed(field, (start, end), step.states)
            if missed is None:
                return step
            limit = missed.time

    def _accepted(
        self, field: MemoisedField, start: float, limit: float, position: Array, velocity: Array
    ) -> tuple[float, Pair]:
        """Return the end of a step whose error is small enough, and what it came to."""
        memory = self.memory(field, start, limit, position, velocity)
        wanted = step = memory.step
        rejected = False
        while True:
            end = start + step if step < limit - start else limit
            step = end - start
            pair, error = self._trial(field, start, step, position, velocity)
            if error <= 1 and not isinstance(pair, SimulationError):
                break
            field.tally.rejected += 1
            rejected = True
            step *= shrinking(error, self.power)
            if step <= max(_SMALLEST * math.ulp(start), math.ulp(0.0)):
                raise pair if isinstance(pair, SimulationError) else self._none(start, error)
        longer = step * growth(error, memory.error, self.power, self.damping, rejected)
        memory.step = max(longer, wanted) if end == limit and not rejected else longer
        memory.error = max(error, 1e-4)
        return end, pair

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
        """Take several steps at once, if the field can.

        Raises as `step` does.
        """
        memory = self.memory(field, start, limit, position, velocity)
        known = field.known(start, position, velocity)  # from the first step's length on
        while True:
            before = replace(memory), replace(field.tally)
            steps = self._batch(field, start, limit, position, velocity, most)
            missed = self._missed(field, steps.times, steps.at)
            if missed is None:
                return steps
            if len(steps.times) == 2:
                limit = missed.time
                field.recall(start, position, velocity)
                continue
            most = max(missed.step, 1)  # anew, at the cost of these alone
            vars(memory).update(vars(before[0]))
            vars(field.tally).update(vars(before[1]))
            if known is not None:
                field.remember(start, position, velocity, known)

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

        None are returned where that is the first, or where that one misses what a law does.
        """
        undo = self.undone(field, start, limit, position, velocity)
        steps = self._marched(field, marching, start, limit, position, velocity, most)
        if steps is None:
            return None
        missed = self._missed(field, steps.times, steps.at)
        if missed is None:
            return MovedBatch(steps)
        undo()  # anew, at the cost of those before alone
        if missed.step == 0:
            return None
        steps = self._marched(field, marching, start, limit, position, velocity, missed.step)
        return None if steps is None else MovedBatch(steps)

    def undone(
        self, field: MemoisedField, start: float, limit: float, position: Array, velocity: Array
    ) -> Callable[[], None]:
        """Return what takes back all steps that are taken from a state on."""
        memory = self.memory(field, start, limit, position, velocity)
        before, steps = replace(memory), field.undone(start, position, velocity)

        def undo() -> None:
            vars(memory).update(vars(before))
            steps()

        return undo

    def _marched(
        self,
        field: MemoisedField,
        marching: Marching | HeldMarching,
        start: float,
        limit: float,
        position: Array,
        velocity: Array,
        most: int,
    ) -> StepBatch | None:
        """Take several steps by what takes them at once, whatever they miss of a law."""
        memory = self.memory(field, start, limit, position, velocity)
        now = Start(position, velocity, field.known(start, position, velocity))
        control = Control(
            memory.step, memory.error, **vars(self.tolerance),
            power=self.power, damping=self.damping,
        )  # fmt: skip
        steps = marching.adaptive(name_of(self.scheme), start, limit, most, now, control)
        if steps is None or not field.took(steps):
            return None
        memory.step, memory.error = control.step, control.error
        return StepBatch(steps.times, steps.knots, steps.dense, steps.reached)

    def _missed(
        self, field: MemoisedField, times: Sequence[float], states: States
    ) -> Unresolved | None:
        """Return which of the steps between some times, s, has missed what a law does."""
        relative, rate = self.tolerance.relative, self.tolerance.rate
        found = self._resolution.unresolved(
            field.bodies, times, states, relative=relative, rate=rate
        )
        self.missed = self.missed or found is not None
        return found

    def _batch(
        self,
        field: MemoisedField,
        start: float,
        limit: float,
        position: Array,
        velocity: Array,
        most: int,
    ) -> StepBatch:
        """Take several steps at once, if the field can, whatever they miss of a law."""
        if field.marching is not None:
            steps = self._marched(field, field.marching, start, limit, position, velocity, most)
            if steps is not None:
                return steps
        end, pair = self._accepted(field, start, limit, position, velocity)
        if field.marching is not None:
            field.settle(end, pair.position, pair.velocity)
        return StepBatch.of_pair(start, end, (position, velocity), pair)

    def memory(
        self, field: MemoisedField, start: float, limit: float, position: Array, velocity: Array
    ) -> Memory:
        """Return what the last step of some bodies left, or how long the first should be."""
        if field.bodies not in self._memory:
            first = self._first(field, start, limit, position, velocity)
            self._memory[field.bodies] = Memory(first)
            field.settle(start, position, velocity)  # code that steps at once knows no trial
        return self._memory[field.bodies]

    def _trial(
        self, field: MemoisedField, start: float, step: float, position: Array, velocity: Array
    ) -> tuple[Pair | SimulationError, float]:
        """Return a step and its error, the largest of all, in shares of what is allowed.

        Where it meets no finite force it went too far: the refusal is returned.
        """
        with np.errstate(all="ignore"):
            try:
                pair = self.scheme(start, step, position, velocity, field)
            except SimulationError as refusal:
                return refusal, math.inf
            allowed = self.tolerance.of(
                np.maximum(np.abs(position), np.abs(pair.position)),
                np.maximum(np.abs(velocity), np.abs(pair.velocity)),
            )
            estimates = (
                np.stack((q / allowed[0], rate / allowed[1]))
                for q, rate in zip(pair.position_errors, pair.velocity_errors, strict=True)
            )
            error = float(np.max(combined(*estimates), initial=0.0))
        return pair, error if math.isfinite(error) else math.inf

    def _none(self, start: float, error: float) -> StepSizeError:
        """Return the error of no step at all: that of the smallest is too large."""
        smallest = _SMALLEST * math.ulp(start)
        found = f"{error:.3g} times what is allowed" if math.isfinite(error) else "not finite"
        return StepSizeError(
            f"{self._name} at {start!r} s: the error of a step of {smallest:.3g} s, the smallest "
            f"that float64 can take there, is {found} (R5). Give a larger rtol, end the run "
            "before, or look for a force that jumps or has no limit there."
        )

    def _first(
        self, field: MemoisedField, start: float, limit: float, position: Array, velocity: Array
    ) -> float:
        """Return the length of the first step, s (ibid., section II.4, starting step size)."""
        allowed = np.stack(self.tolerance.of(position, velocity))
        rates = np.stack((velocity, field(start, position, velocity)))
        value = _largest(np.stack((position, velocity)) / allowed)
        slope = _largest(rates / allowed)
        trial = 0.01 * value / slope if min(value, slope) > 1e-5 else 1e-6 * (limit - start)
        trial = min(trial, limit - start)
        q, v = position + trial * velocity, velocity + trial * rates[1]
        try:
            bend = _largest((np.stack((v, field(start + trial, q, v))) - rates) / allowed) / trial
        except SimulationError:
            return trial
        steepest = max(slope, bend)
        if steepest <= 1e-15:
            return limit - start
        return min(100 * trial, float((0.01 / steepest) ** (1 / self.power)), limit - start)


def _largest(values: Array) -> float:
    """Return the largest magnitude; 0 where no body is free, so that one step is enough."""
    return float(np.max(np.abs(values), initial=0.0))


def combined(first: Scalar, second: Scalar = 0.0) -> Scalar:
    """Return the size of an error; one that happens to be small is held up by the next order."""
    size = sqrt(first * first + CORRECTION * second * second)
    return first * first / largest(size, NONE)


def growth(error: float, before: float, power: float, damping: float, rejected: bool) -> float:
    """Return how much longer than a step the next should be."""
    slope = 1 / power - 0.75 * damping
    factor: float = SAFETY * max(error, 1e-10) ** -slope * before**damping
    return min(max(factor, SHORTER), 1.0 if rejected else LONGER)


def shrinking(error: float, power: float) -> float:
    """Return how much shorter than a step that erred too much its next trial should be."""
    factor: float = SAFETY * error ** (-1 / power)
    return max(SHORTER, factor)


def dense_step(start: float, end: float, first: tuple[Array, Array], pair: Pair) -> DenseStep:
    """Return the path of a step."""
    last = pair.position, pair.velocity
    coefficients = dense_path(end - start, first, pair.position, pair.dense)
    return DenseStep(start, end, first, last, coefficients)
