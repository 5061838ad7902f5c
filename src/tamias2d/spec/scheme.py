"""Integration schemes as coefficients, and the order that these really have.

Serves: the reader (a claim of order is checked) and the generator. Hides: how the order is
found. One step is made in exact rational arithmetic on power series in the step size h, for a
coupled nonlinear problem without symmetries, and is compared with the Taylor series of its
solution: the first power of h at which they part is the order plus one.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import zip_longest

from tamias2d.spec.chapter import Item
from tamias2d.spec.equations import Report
from tamias2d.spec.messages import Code

HIGHEST = 6  # powers of h that are compared
_NEEDS = {
    "runge_kutta": ("a", "b", "c"),
    "splitting": ("kick", "drift"),
    "two_level": ("position", "velocity"),
}
_LEVELS = {"position": ("velocity", "previous", "current"), "velocity": ("previous", "current")}


@dataclass(frozen=True)
class Scheme:
    """One scheme: its family and the coefficients of that family."""

    name: str
    family: str
    order: int
    a: tuple[tuple[Fraction, ...], ...] = ()
    b: tuple[Fraction, ...] = ()
    c: tuple[Fraction, ...] = ()
    kick: tuple[Fraction, ...] = ()
    drift: tuple[Fraction, ...] = ()
    position: tuple[Fraction, ...] = ()  # of v h, and of the previous and current a h^2
    velocity: tuple[Fraction, ...] = ()  # of the previous and current a h


def scheme_of(item: Item, report: Report) -> Scheme | None:
    """Read a scheme item; a fault is reported at its place."""
    family = item.data["family"]
    for key in _NEEDS[family]:
        if key not in item.data:
            report(
                item.diagnostic(Code.BAD_KEY, f"a {family} scheme needs '{key}'. Give it", "family")
            )
            return None
    try:
        scheme = _coefficients(item)
    except (ValueError, ZeroDivisionError):
        report(
            item.diagnostic(
                Code.BAD_VALUE,
                "a coefficient is no rational like 1/2. Correct it",
                _NEEDS[family][0],
            )
        )
        return None
    if not _shapes_fit(scheme):
        report(
            item.diagnostic(
                Code.BAD_VALUE,
                "the coefficients do not fit together in number. Count them",
                _NEEDS[family][0],
            )
        )
        return None
    return scheme


def _coefficients(item: Item) -> Scheme:
    data = item.data

    def row(key: str) -> tuple[Fraction, ...]:
        return tuple(Fraction(text) for text in data.get(key, []))

    def levels(key: str) -> tuple[Fraction, ...]:
        weights = data.get(key, {})
        if set(weights) - set(_LEVELS[key]):
            raise ValueError(key)
        return tuple(Fraction(weights.get(name, "0")) for name in _LEVELS[key])

    square = tuple(tuple(Fraction(text) for text in line) for line in data.get("a", []))
    return Scheme(
        item.id, data["family"], int(data["order"]), square, row("b"), row("c"), row("kick"),
        row("drift"), levels("position"), levels("velocity"),
    )  # fmt: skip


def _shapes_fit(scheme: Scheme) -> bool:
    if scheme.family == "runge_kutta":
        stages = len(scheme.b)
        lower = all(len(line) == k for k, line in enumerate(scheme.a))
        return stages > 0 and len(scheme.c) == stages == len(scheme.a) and lower
    if scheme.family == "splitting":
        return len(scheme.drift) > 0 and len(scheme.kick) - len(scheme.drift) in (0, 1)
    return True


def check_order(item: Item, report: Report) -> None:
    """Report a scheme whose coefficients do not have the claimed order."""
    scheme = scheme_of(item, report)
    if scheme is None:
        return
    found = order(scheme)
    if found != scheme.order:
        text = (
            f"the coefficients have order {found}, {scheme.order} is claimed. Correct one of them"
        )
        report(item.diagnostic(Code.SCHEME_ORDER, text, "order"))


# Exact power series in h, cut off after HIGHEST.
Series = tuple[Fraction, ...]


def _constant(value: Fraction | int) -> Series:
    return (Fraction(value), *(Fraction(0),) * HIGHEST)


def _plus(*terms: Series) -> Series:
    return tuple(sum(column, Fraction(0)) for column in zip(*terms, strict=True))


def _scaled(factor: Fraction | int, series: Series) -> Series:
    return tuple(factor * c for c in series)


def _times(first: Series, second: Series) -> Series:
    return tuple(
        sum((first[m] * second[k - m] for m in range(k + 1)), Fraction(0))
        for k in range(HIGHEST + 1)
    )


def _by_h(series: Series) -> Series:
    return (Fraction(0), *series[:-1])


State = tuple[Series, Series]  # two coordinates, or their two velocities
Field = Callable[[Series, State, State], State]


def _field(with_velocity: bool) -> Field:
    """A generic acceleration: coupled, nonlinear, dependent on time, on velocity if wanted."""

    def acceleration(time: Series, position: State, velocity: State) -> State:
        p, q = position
        first = _plus(_times(p, q), _scaled(2, time), _times(q, _times(q, time)), _constant(1))
        second = _plus(_times(p, p), _scaled(-3, _times(p, q)), _times(time, time), _scaled(2, q))
        if with_velocity:
            u, w = velocity
            first = _plus(first, _times(u, q), _scaled(-1, w))
            second = _plus(second, _times(u, w), _times(p, w))
        return first, second

    return acceleration


_START: tuple[State, State] = (
    (_constant(1), _constant(-2)),
    (_constant(3), _constant(Fraction(1, 2))),
)
_TIME = Fraction(1, 3)


def order(scheme: Scheme) -> int:
    """The order of consistency, found by exact comparison of power series."""
    field = _field(with_velocity=scheme.family == "runge_kutta")
    exact = _taylor(field)
    made = _step(scheme, field, exact)
    for power in range(1, HIGHEST + 1):
        pairs = zip((*exact[0], *exact[1]), (*made[0], *made[1]), strict=True)
        if any(a[power] != b[power] for a, b in pairs):
            return power - 1
    return HIGHEST


def _taylor(field: Field) -> tuple[State, State]:
    """The solution from the start, by Picard iteration: each pass settles one more power."""
    position, velocity = _START
    for _ in range(HIGHEST + 1):
        rate = field(_plus(_constant(_TIME), _by_h(_constant(1))), position, velocity)
        position = _moved(_START[0], velocity)
        velocity = _moved(_START[1], rate)
    return position, velocity


def _moved(start: State, rate: State) -> State:
    def integral(series: Series) -> Series:
        return (Fraction(0), *(c / (k + 1) for k, c in enumerate(series[:-1])))

    return _plus(start[0], integral(rate[0])), _plus(start[1], integral(rate[1]))


def _combined(start: State, weights: Sequence[Fraction], rates: Sequence[State]) -> State:
    """start + h * sum of weighted rates."""
    result = list(start)
    for axis in range(2):
        terms = [_scaled(w, rate[axis]) for w, rate in zip(weights, rates, strict=True)]
        result[axis] = _plus(start[axis], *(_by_h(term) for term in terms))
    return result[0], result[1]


def _step(scheme: Scheme, field: Field, exact: tuple[State, State]) -> tuple[State, State]:
    if scheme.family == "runge_kutta":
        return _runge_kutta(scheme, field)
    if scheme.family == "splitting":
        return _splitting(scheme, field)
    return _two_level(scheme, field, exact)


def _at(fraction: Fraction) -> Series:
    return _plus(_constant(_TIME), _by_h(_constant(fraction)))


def _runge_kutta(scheme: Scheme, field: Field) -> tuple[State, State]:
    velocities: list[State] = []
    accelerations: list[State] = []
    for line, node in zip(scheme.a, scheme.c, strict=True):
        position = _combined(_START[0], line, velocities)
        velocity = _combined(_START[1], line, accelerations)
        velocities.append(velocity)
        accelerations.append(field(_at(node), position, velocity))
    return _combined(_START[0], scheme.b, velocities), _combined(_START[1], scheme.b, accelerations)


def _splitting(scheme: Scheme, field: Field) -> tuple[State, State]:
    position, velocity = _START
    passed = Fraction(0)
    for kick, drift in zip_longest(scheme.kick, scheme.drift, fillvalue=Fraction(0)):
        velocity = _combined(velocity, [kick], [field(_at(passed), position, velocity)])
        position = _combined(position, [drift], [velocity])
        passed += drift
    return position, velocity


def _two_level(scheme: Scheme, field: Field, exact: tuple[State, State]) -> tuple[State, State]:
    """`previous` is the acceleration at the start of the step, `current` the one at its end."""
    previous = field(_at(Fraction(0)), *_START)
    current = field(_at(Fraction(1)), *exact)
    of_velocity, of_previous, of_current = scheme.position
    squared = [(_by_h(a[0]), _by_h(a[1])) for a in (previous, current)]
    moved = _combined(_START[0], [of_velocity, of_previous, of_current], [_START[1], *squared])
    return moved, _combined(_START[1], scheme.velocity, [previous, current])
