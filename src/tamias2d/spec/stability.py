"""How long the steps of a scheme may be before it grows what should not grow.

Serves: the check of what a scheme item claims, and the generator. Hides: the two trial problems,
a free oscillation and a free decay, whose steps are matrices.
"""

from collections.abc import Callable
from itertools import zip_longest
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tamias2d.spec.chapter import Item
from tamias2d.spec.equations import Report
from tamias2d.spec.messages import Code
from tamias2d.spec.scheme import Scheme, scheme_of

_Row = NDArray[np.float64]

_GROWTH = 1e-12  # more than this in a step is more than rounding
_SCAN = 0.05
_LONGEST = 12.0
_AGREES = 1e-3  # of claimed limits


class Limits(NamedTuple):
    """The longest steps, as multiples of 1/angular frequency and of 1/decay rate."""

    oscillation: float
    decay: float


def check_stability(item: Item, report: Report) -> None:
    """Report a scheme whose coefficients do not have the limits that are claimed."""
    scheme = scheme_of(item, lambda _fault: None)  # the check of the order reports it
    claimed = item.data.get("stability", {})
    if scheme is None or not claimed:
        return
    for name, found in limits(scheme)._asdict().items():
        if name not in claimed or abs(float(claimed[name]) - found) > _AGREES:
            text = f"the coefficients have {name} limit {found:.3f}. Say so"
            report(item.diagnostic(Code.SCHEME_STABILITY, text, "stability"))


def limits(scheme: Scheme) -> Limits:
    """The limits of a scheme, from its coefficients."""
    return Limits(
        _first_growth(lambda z: growth(scheme, z * z, 0.0)),
        _first_growth(lambda z: growth(scheme, 0.0, z)),
    )


def growth(scheme: Scheme, stiffness: float, damping: float) -> float:
    """The factor by which a step of length 1 multiplies what grows most.

    The problem is that the acceleration is -stiffness*position - damping*velocity.
    """
    step = _runge_kutta if scheme.family == "runge_kutta" else _splitting
    start = np.eye(2)

    def rate(position: _Row, velocity: _Row) -> _Row:
        return -stiffness * position - damping * velocity

    end = np.stack(step(scheme, start[0], start[1], rate))
    return float(np.max(np.abs(np.linalg.eigvals(end))))


def _first_growth(growth_at: Callable[[float], float]) -> float:
    low = 0.0
    while growth_at(low + _SCAN) <= 1 + _GROWTH:
        low += _SCAN
        if low > _LONGEST:
            return np.inf
    high = low + _SCAN
    while high - low > 1e-9:
        middle = (low + high) / 2
        low, high = (middle, high) if growth_at(middle) <= 1 + _GROWTH else (low, middle)
    return low


def _runge_kutta(
    scheme: Scheme, position: _Row, velocity: _Row, rate: Callable[[_Row, _Row], _Row]
) -> tuple[_Row, _Row]:
    velocities: list[_Row] = []
    rates: list[_Row] = []

    def moved(start: _Row, weights: tuple[float, ...], slopes: list[_Row]) -> _Row:
        return start + sum(w * s for w, s in zip(weights, slopes, strict=True))

    for line in scheme.a:
        row = tuple(map(float, line))
        at, speed = moved(position, row, velocities), moved(velocity, row, rates)
        velocities.append(speed)
        rates.append(rate(at, speed))
    weights = tuple(map(float, scheme.b))
    return moved(position, weights, velocities), moved(velocity, weights, rates)


def _splitting(
    scheme: Scheme, position: _Row, velocity: _Row, rate: Callable[[_Row, _Row], _Row]
) -> tuple[_Row, _Row]:
    for kick, drift in zip_longest(scheme.kick, scheme.drift, fillvalue=0):
        velocity = velocity + float(kick) * rate(position, velocity)
        position = position + float(drift) * velocity
    return position, velocity
