"""Paths as polynomials of time through the states at both ends of a step.

The coordinates are x, y and orientation. The velocity is the derivative of the coordinates'
polynomial, so that the place of a contact and the speed of its approach cannot disagree.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property

import numpy as np

from tamias2d.motion.loads import state_of
from tamias2d.path import Bounds, PathPiece
from tamias2d.state import Acceleration, Array, State

_NARROW = 0.125  # of a step is a window in which it changes less than it does over all


@dataclass(frozen=True)
class DenseStep:
    """One step of n bodies: coordinates and rates (n, 3) at both ends, and what lies between.

    `coefficients` (m, n, 3) are those of the powers of x, which goes from -1 at the start to 1 at
    the end.
    """

    start: float
    end: float
    first: tuple[Array, Array]
    last: tuple[Array, Array]
    coefficients: Array

    def at(self, time: float) -> tuple[Array, Array]:
        """Return coordinates and rates (n, 3) at a time in s, to the bit at both ends."""
        if time == self.start:
            return self.first
        if time == self.end:
            return self.last
        half, x = _place(self, time)
        value, slope = np.zeros_like(self.first[0]), np.zeros_like(self.first[0])
        for c in self.coefficients[::-1]:
            slope = slope * x + value
            value = value * x + c
        return value, slope / half

    def states(self, times: Array) -> Array:
        """Return coordinates and rates (k, 2, n, 3) at times (k,), s, within the step."""
        return np.stack([np.stack(self.at(time)) for time in times.tolist()])

    def piece(self, body: int) -> PathPiece:
        """Return the path of one of the bodies."""
        return Polynomial(
            self.start,
            self.end,
            state_of(self.first[0][body], self.first[1][body]),
            state_of(self.last[0][body], self.last[1][body]),
            self.coefficients[:, body].tolist(),
        )


def moved_end(step: DenseStep, position: Array, velocity: Array) -> DenseStep:
    """Return a step that ends at other coordinates and rates (n, 3), and begins as it did.

    A cubic that is level at the start is added to its path.
    """
    way, change = position - step.last[0], (velocity - step.last[1]) * (step.end - step.start)
    powers = moved_path(step.coefficients, way, change)
    return replace(step, last=(position, velocity), coefficients=powers)


def moved_path(coefficients: Array, way: Array, change: Array) -> Array:
    """Return the coefficients of paths that end elsewhere, with a change of rates times lengths."""
    cubic = (way / 2 - change / 8, 3 * way / 4 - change / 8, change / 8, (change - 2 * way) / 8)
    powers = np.zeros((max(len(coefficients), 4), *way.shape))
    powers[: len(coefficients)] = coefficients
    powers[:4] += np.stack(cubic)
    return powers


def hermite(
    start: float,
    end: float,
    first: tuple[Array, Array, Array],
    last: tuple[Array, Array, Array],
) -> DenseStep:
    """Return the quintic with given coordinates, rates and accelerations (n, 3) at both ends."""
    powers = quintic((end - start) / 2, first, last)
    return DenseStep(start, end, first[:2], last[:2], powers)


def quintic(half: float | Array, first: tuple[Array, ...], last: tuple[Array, ...]) -> Array:
    """Return the coefficients of quintics, stacked, for steps of which half is given in s.

    They have given coordinates, rates and accelerations at both ends.
    """
    value, slope, bend = (  # of the even part and of the odd one, at x = 1
        ((end_ + start_) / 2 * scale, (end_ - start_) / 2 * scale)
        for start_, end_, scale in zip(first, last, (1.0, half, half * half), strict=True)
    )
    fourth = (bend[0] - slope[1]) / 8
    second = slope[1] / 2 - 2 * fourth
    fifth = (bend[1] - 3 * (slope[0] - value[1])) / 8
    third = (slope[0] - value[1]) / 2 - 2 * fifth
    powers = [
        value[0] - second - fourth,
        value[1] - third - fifth,
        second,
        third,
        fourth,
        fifth,
    ]
    return np.stack(powers)


def dense_path(
    step: float | Array, first: tuple[Array, Array], end: Array, dense: Sequence[Array]
) -> Array:
    """Return the coefficients of the path of a step: the dense velocity, integrated once.

    It ends at the position of the pair. What the integral lacks of that, of the order of the
    dense output's own error, is added as a cubic that is level at both ends.
    """
    position, velocity = first
    powers = [position, step * velocity]
    powers += [step * step * c / (k + 2) for k, c in enumerate(dense)]
    lacking = end - sum(powers[1:], powers[0])
    powers[2] = powers[2] + 3 * lacking
    powers[3] = powers[3] - 2 * lacking
    matrix = _centred(len(powers)).reshape(-1, len(powers), *[1] * position.ndim)
    total = matrix[:, 0] * powers[0]
    for k, power in enumerate(powers[1:], start=1):  # in this order, whatever their number
        total = total + matrix[:, k] * power
    return total


@cache
def _centred(count: int) -> Array:
    """Return the matrix from powers of s, from 0 to 1, to those of x = 2 s - 1."""
    rows = [[math.comb(k, j) / 2.0**k for k in range(count)] for j in range(count)]
    return np.array(rows)


class Polynomial:
    """The path of one body over one step."""

    def __init__(
        self,
        start: float,
        end: float,
        first: State,
        last: State,
        coefficients: list[list[float]],
    ) -> None:
        self.start = start
        self.end = end
        self._first = first
        self._last = last
        self._coefficients = coefficients
        self._falling = coefficients[::-1]

    def at(self, time: float) -> State:
        """Return the state at a time in s, to the bit at both ends."""
        if time == self.start:
            return self._first
        if time == self.end:
            return self._last
        half, s = _place(self, time)
        x = y = turn = u = v = spin = 0.0
        for cx, cy, ct in self._falling:
            u, v, spin = u * s + x, v * s + y, spin * s + turn
            x, y, turn = x * s + cx, y * s + cy, turn * s + ct
        return State((x, y), turn, (u / half, v / half), spin / half)

    def acceleration(self, time: float) -> Acceleration:
        """Return the acceleration at a time in s."""
        half, s = _place(self, time)
        x = y = turn = 0.0
        for k in range(len(self._coefficients) - 1, 1, -1):
            cx, cy, ct = self._coefficients[k]
            weight = k * (k - 1)
            x, y, turn = x * s + weight * cx, y * s + weight * cy, turn * s + weight * ct
        return x / half**2, y / half**2, turn / half**2

    def bounds(self, first: float, last: float) -> Bounds:
        """Return what holds from `first` to `last`, s: of a long window, over the whole step."""
        half = (self.end - self.start) / 2
        width = (last - first) / 2 / half if half else 1.0
        if width > _NARROW:
            return self._bounds
        centre = _place(self, first)[1] + width
        terms = [_shifted(axis, centre) for axis in zip(*self._coefficients, strict=True)]
        speeds = [_reach(axis, 1, 1, width) / half for axis in terms]
        spread = [_reach(axis, 2, 3, width) / half**2 for axis in terms]
        x, y, angular = (2 * axis[2] / half**2 if len(axis) > 2 else 0.0 for axis in terms)
        return Bounds(
            (x, y),
            math.hypot(spread[0], spread[1]),
            math.hypot(speeds[0], speeds[1]),
            speeds[2],
            abs(angular) + spread[2],
        )

    @cached_property
    def _bounds(self) -> Bounds:
        half = (self.end - self.start) / 2
        rates = np.abs(derivative(self._coefficients, 1)).sum(axis=0) / half
        second = derivative(self._coefficients, 2) / half**2
        spread = np.abs(second[1:]).sum(axis=0)
        x, y, angular = second[0].tolist()
        return Bounds(
            (x, y),
            float(np.hypot(spread[0], spread[1])),
            float(np.hypot(rates[0], rates[1])),
            float(rates[2]),
            abs(angular) + float(spread[2]),
        )

    def sample(self, times: Array) -> Array:
        """Return (k, 6) at times (k,), s."""
        return sampled(self, times)


class JoinedPath:
    """Pieces that follow each other, as one."""

    def __init__(self, pieces: Sequence[PathPiece]) -> None:
        self.start = pieces[0].start
        self.end = pieces[-1].end
        self.pieces = pieces

    def _piece(self, time: float) -> PathPiece:
        return next((p for p in self.pieces if time <= p.end), self.pieces[-1])

    def at(self, time: float) -> State:
        """Return the state at a time in s."""
        return self._piece(time).at(time)

    def acceleration(self, time: float) -> Acceleration:
        """Return the acceleration at a time in s."""
        return self._piece(time).acceleration(time)

    def bounds(self, first: float, last: float) -> Bounds:
        """Return what holds from `first` to `last`, s."""
        inside = [p.bounds(first, last) for p in self.pieces if p.start <= last and p.end >= first]
        x, y = inside[0].acceleration
        return Bounds(
            (x, y),
            max(
                b.deviation + math.hypot(b.acceleration[0] - x, b.acceleration[1] - y)
                for b in inside
            ),
            *(max(column) for column in zip(*(b[2:] for b in inside), strict=True)),
        )

    def sample(self, times: Array) -> Array:
        """Return (k, 6) at times (k,), s."""
        return sampled(self, times)


def sampled(piece: PathPiece, times: Array) -> Array:
    """Return (k, 6) of a piece at times (k,), s, one by one."""
    states = [piece.at(time) for time in times.tolist()]
    rows = [(*p, turn, *v, spin) for p, turn, v, spin in states]
    return np.array(rows).reshape(-1, 6)


def _shifted(coefficients: Sequence[float], by: float) -> list[float]:
    """Return the coefficients of a polynomial around another place."""
    terms = list(coefficients)
    for first in range(len(terms) - 1):
        for k in range(len(terms) - 2, first - 1, -1):
            terms[k] += by * terms[k + 1]
    return terms


def _reach(terms: Sequence[float], order: int, first: int, width: float) -> float:
    """Return how large a derivative gets within a width at most, by its terms from one on."""
    return sum(
        math.perm(k, order) * abs(terms[k]) * width ** (k - order) for k in range(first, len(terms))
    )


def _place(step: "DenseStep | Polynomial", time: float) -> tuple[float, float]:
    """Return half the length of a step in s, and the x of a time."""
    half = (step.end - step.start) / 2
    return half, (time - step.start) / half - 1


def derivative(coefficients: list[list[float]] | Array, order: int) -> Array:
    """Return the coefficients, along the first axis, of a derivative by x."""
    powers = np.array(coefficients)
    for _ in range(order):
        weights = np.arange(1, len(powers)).reshape(-1, *[1] * (powers.ndim - 1))
        powers = powers[1:] * weights
    return powers
