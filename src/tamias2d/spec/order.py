"""The order that the coefficients of a scheme really have.

Serves: the reader, which checks each claim of order. Hides: how the order is found. One step is
made on power series in the step size h, for a coupled nonlinear problem without symmetries, and
is compared with the Taylor series of its solution: the first power of h at which they part is
the order plus one. Rational coefficients are compared exactly, long decimal ones in float64.
"""

from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import chain, zip_longest
from math import factorial
from typing import Any

from tamias2d.spec.chapter import Item
from tamias2d.spec.equations import Report
from tamias2d.spec.messages import Code
from tamias2d.spec.scheme import Scheme, scheme_of

Number = Any  # a Fraction, or a float
Series = tuple[Number, ...]  # coefficients of the powers of h
State = tuple[Series, Series]  # two coordinates, or their two velocities
Field = Callable[[Series, State, State], State]
Weights = Sequence[Number]

_ROUNDING = 1e-9  # of float64 over the longest sums, relative
_EXACT_UP_TO = 10**4  # of denominators: larger ones make exact fractions slow
_DRAG = Fraction(3, 7)  # rate of a velocity's decay, which an exponential scheme solves exactly
_SHARE = Fraction(1, 3)  # of the step, at which dense output is compared


def check_orders(item: Item, report: Report) -> None:
    """Report a scheme whose coefficients do not have an order that is claimed."""
    scheme = scheme_of(item, report)
    if scheme is None:
        return
    claims: list[tuple[str, int, Weights | None, Fraction]]
    claims = [("order", scheme.order, None, Fraction(1))]
    for row, claimed in zip(scheme.error, scheme.error_orders, strict=True):
        lower = [b - e for b, e in zip(scheme.b, row, strict=True)]
        claims.append(("error_orders", claimed, lower, Fraction(1)))
    if scheme.dense:
        claims.append(("dense_order", scheme.dense_order, scheme.weights(_SHARE), _SHARE))
    for key, claimed, weights, share in claims:
        found = order(scheme, claimed + 1, weights=weights, share=share)
        if found != claimed:
            text = f"the coefficients have {key} {found}, {claimed} is claimed. Correct one of them"
            report(item.diagnostic(Code.SCHEME_ORDER, text, key))


def order(
    scheme: Scheme, highest: int, *, weights: Weights | None = None, share: Fraction = Fraction(1)
) -> int:
    """The order of consistency, up to `highest`.

    A Runge-Kutta scheme may be given other weights than its own, for a share of the step.
    """
    exact = all(c.denominator <= _EXACT_UP_TO for c in chain(scheme.coefficients, weights or ()))
    trial = _Trial(scheme, highest, Fraction if exact else float)
    made, wanted = trial.step(weights), trial.solution
    for power in range(1, highest + 1):
        for a, b in zip(chain(*made), chain(*wanted), strict=True):
            at_share = b[power] * trial.number(share) ** power
            if abs(a[power] - at_share) > trial.tolerance * max(1, abs(at_share)):
                return power - 1
    return highest


class _Trial:
    """A problem and one step of it, as series of one kind of number."""

    def __init__(self, scheme: Scheme, highest: int, number: type) -> None:
        self.scheme = scheme
        self.highest = highest
        self.number = number
        self.tolerance = 0 if number is Fraction else _ROUNDING
        self.depends_on_velocity = scheme.family == "runge_kutta"
        self.time = self.constant(Fraction(1, 3))
        self.start: tuple[State, State] = (
            (self.constant(1), self.constant(-2)),
            (self.constant(3), self.constant(Fraction(1, 2))),
        )
        self.solution = self.taylor()

    def constant(self, value: Fraction | int) -> Series:
        return (self.number(value), *(self.number(0),) * self.highest)

    def times(self, first: Series, second: Series) -> Series:
        zero = self.number(0)
        return tuple(
            sum((first[m] * second[k - m] for m in range(k + 1)), zero)
            for k in range(self.highest + 1)
        )

    def reciprocal(self, series: Series) -> Series:
        result: list[Number] = [1 / series[0]]
        for k in range(1, self.highest + 1):
            rest = sum((series[m] * result[k - m] for m in range(1, k + 1)), self.number(0))
            result.append(-rest / series[0])
        return tuple(result)

    def field(self, time: Series, position: State, velocity: State) -> State:
        """An acceleration with derivatives of every order in time, position and velocity."""
        p, q = position
        one = self.constant(1)
        well = self.reciprocal(_plus(self.constant(4), q, _scaled(self.number(2), p), time))
        first = _plus(self.times(p, q), self.times(q, well), _scaled(self.number(2), time), one)
        second = _plus(self.times(p, p), self.times(time, well), _scaled(self.number(2), q))
        if self.depends_on_velocity:
            u, w = velocity
            drag = self.reciprocal(_plus(self.constant(5), u, w))
            first = _plus(first, self.times(u, q), drag)
            second = _plus(second, self.times(u, w), self.times(p, drag))
        return first, second

    def at(self, moment: Number) -> Series:
        return _plus(self.time, _by_h(self.constant(moment)))

    def taylor(self) -> tuple[State, State]:
        """The solution, by Picard iteration: each pass settles one more power."""
        position, velocity = self.start
        for _ in range(self.highest + 1):
            rate = self.field(self.at(1), position, velocity)
            if self.scheme.family == "exponential":
                slowed = [_scaled(-self.number(_DRAG), axis) for axis in velocity]
                rate = _plus(rate[0], slowed[0]), _plus(rate[1], slowed[1])
            position = self.moved(self.start[0], velocity)
            velocity = self.moved(self.start[1], rate)
        return position, velocity

    def moved(self, start: State, rate: State) -> State:
        def integral(series: Series) -> Series:
            return (self.number(0), *(c / (k + 1) for k, c in enumerate(series[:-1])))

        return _plus(start[0], integral(rate[0])), _plus(start[1], integral(rate[1]))

    def combined(self, start: State, weights: Weights, rates: Sequence[State]) -> State:
        """start + h * sum of weighted rates."""
        axes = []
        for axis in range(2):
            pairs = ((w, r[axis]) for w, r in zip(weights, rates, strict=True) if w)
            axes.append(_plus(start[axis], *(_by_h(_scaled(self.number(w), r)) for w, r in pairs)))
        return axes[0], axes[1]

    def step(self, weights: Weights | None) -> tuple[State, State]:
        if self.scheme.family == "runge_kutta":
            return self.runge_kutta(self.scheme.b if weights is None else weights)
        return self.two_level() if self.scheme.family == "two_level" else self.splitting()

    def runge_kutta(self, weights: Weights) -> tuple[State, State]:
        velocities: list[State] = []
        accelerations: list[State] = []
        for line, moment in zip(self.scheme.a, self.scheme.c, strict=True):
            position = self.combined(self.start[0], line, velocities)
            velocity = self.combined(self.start[1], line, accelerations)
            velocities.append(velocity)
            accelerations.append(self.field(self.at(moment), position, velocity))
        return (
            self.combined(self.start[0], weights, velocities),
            self.combined(self.start[1], weights, accelerations),
        )

    def splitting(self) -> tuple[State, State]:
        position, velocity = self.start
        passed = Fraction(0)
        for kick, drift in zip_longest(self.scheme.kick, self.scheme.drift, fillvalue=Fraction(0)):
            rate = self.field(self.at(passed), position, velocity)
            velocity = self.combined(velocity, [kick], [rate])
            position, velocity = self.drifted(position, velocity, drift)
            passed += drift
        return position, velocity

    def drifted(self, position: State, velocity: State, share: Fraction) -> tuple[State, State]:
        """A share of a step without kicks, or with drag alone."""
        if self.scheme.family == "splitting":
            return self.combined(position, [share], [velocity]), velocity
        powers = [(-_DRAG * share) ** k / factorial(k) for k in range(self.highest + 2)]
        kept = tuple(map(self.number, powers[:-1]))
        way = (self.number(0), *(self.number(-c / _DRAG) for c in powers[1:-1]))
        x, y = (self.times(way, axis) for axis in velocity)
        u, w = (self.times(kept, axis) for axis in velocity)
        return (_plus(position[0], x), _plus(position[1], y)), (u, w)

    def two_level(self) -> tuple[State, State]:
        """`current` is the acceleration at the start of the step, `previous` the one a step before.

        The step before is taken to have been exact.
        """
        position, velocity = self.solution
        previous = self.field(self.at(-1), _reflected(position), _reflected(velocity))
        current = self.field(self.at(0), *self.start)
        squared = [(_by_h(a[0]), _by_h(a[1])) for a in (previous, current)]
        moved = self.combined(self.start[0], self.scheme.position, [self.start[1], *squared])
        return moved, self.combined(self.start[1], self.scheme.velocity, [previous, current])


def _plus(*terms: Series) -> Series:
    return tuple(map(sum, zip(*terms, strict=True)))


def _scaled(factor: Number, series: Series) -> Series:
    return tuple(factor * c for c in series)


def _reflected(state: State) -> State:
    """A state as a series in -h."""
    first, second = (tuple(-c if k % 2 else c for k, c in enumerate(axis)) for axis in state)
    return first, second


def _by_h(series: Series) -> Series:
    return (series[0] * 0, *series[:-1])
