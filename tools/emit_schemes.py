"""The generated module of integration schemes: one step function for each."""

import math
import textwrap
from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from itertools import zip_longest

from tamias2d.spec.chapter import Item
from tamias2d.spec.scheme import Scheme, scheme_of
from tamias2d.spec.specification import Specification
from tools.quoting import docstring, quoted

HEADER = '''"""Integration schemes: one step of each.

Generated from {sources} by `python -m tools.generate`. Edit the chapter, not this file.
Positions and velocities are arrays of any one shape, angles and their rates among them; an
acceleration is a function of time, position and velocity.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

Acceleration = Callable[[Any, Any, Any], Any]
Drift = Callable[[Any, Any, Any, Any], tuple[Any, Any]]
"""From time, time step, position and velocity to both after motion under a part of the forces."""


class Facts(NamedTuple):
    """What is known of a scheme before it runs."""

    order: int
    symplectic: bool
    oscillation: float
    """Longest stable step, times the angular frequency."""
    decay: float
    """Longest stable step, times the rate of the decay."""
    evaluations: int
    """Of the accelerations in a step."""


class Pair(NamedTuple):
    """A step that knows its error.

    `position_errors` and `velocity_errors` have one estimate for each lower order, the highest
    first. Where a share x of the step has passed, the velocity is that at the start plus the
    time step times the sum of `dense[k]` times the power k + 1 of x.
    """

    position: Any
    velocity: Any
    position_errors: tuple[Any, ...]
    velocity_errors: tuple[Any, ...]
    dense: tuple[Any, ...]


Weighted = tuple[float, tuple[tuple[int, float], ...]]
"""A divisor of the time step, and the slopes that are summed, each with its weight."""


class RungeKutta(NamedTuple):
    """A scheme of slopes, as numbers: what its function says, for code that loops over them."""

    moments: tuple[tuple[float, float], ...]
    """Of each slope: a factor of the time step, and a divisor."""
    stages: tuple[Weighted, ...]
    """What each slope but the first is taken from."""
    end: Weighted
    errors: tuple[Weighted, ...]
    dense: tuple[Weighted, ...]


class Splitting(NamedTuple):
    """A scheme of kicks and drifts, as numbers, likewise."""

    parts: tuple[tuple[bool, float, float, float, float], ...]
    """In order: whether it is a kick; factor and divisor of the time step for its length, and for
    the time that has passed before it."""


'''
_LARGEST = 10**12  # denominators beyond it are those of decimal coefficients
_STEP = "time: Any, time_step: Any, position: Any, velocity: Any, acceleration: Acceleration"
_DRIFT = f"{_STEP}, drift: Drift"
_LEVELS = "time_step: Any, position: Any, velocity: Any, previous: Any, current: Any"


def emit(specification: Specification) -> str:
    """Source of the module, not yet formatted."""
    items = specification.of_kind("scheme")
    files = dict.fromkeys(item.file for item in items)
    bodies = [_function(item) for item in items]
    return "\n\n".join(
        [
            HEADER.format(sources=",\n".join(map(quoted, files))),
            *bodies,
            _facts(items),
            _tables(items, "RUNGE_KUTTA", "RungeKutta", "runge_kutta", _as_runge_kutta),
            _tables(items, "SPLITTING", "Splitting", "splitting", _as_splitting),
        ]
    )


def _tables(
    items: Sequence[Item], name: str, kind: str, family: str, printed: Callable[[Scheme], str]
) -> str:
    schemes = [scheme for item in items if (scheme := scheme_of(item, print)) is not None]
    lines = [f"{name}: dict[str, {kind}] = {{"]
    lines += [f'    "{s.name}": {printed(s)},' for s in schemes if s.family == family]
    return "\n".join([*lines, "}"])


def _as_runge_kutta(scheme: Scheme) -> str:
    moments = _many(_factor(moment) for moment in scheme.c)
    stages = _many(_weighted(row) for row in scheme.a[1:])
    errors = _many(_weighted(row) for row in scheme.error)
    dense = _many(_weighted(row, 1) for row in zip(*scheme.dense, strict=True))
    return f"RungeKutta({moments}, {stages}, {_weighted(scheme.b)}, {errors}, {dense})"


def _as_splitting(scheme: Scheme) -> str:
    parts = []
    passed = Fraction(0)
    for kick, drift in zip_longest(scheme.kick, scheme.drift, fillvalue=Fraction(0)):
        if kick:
            parts.append(f"(True, {_factor(kick)[1:-1]}, {_factor(passed)[1:-1]})")
        if drift:
            parts.append(f"(False, {_factor(drift)[1:-1]}, {_factor(passed)[1:-1]})")
        passed += drift
    return f"Splitting(({', '.join(parts)},))"


def _factor(weight: Fraction) -> str:
    """The numbers with which `_times` multiplies and divides."""
    if weight.denominator > _LARGEST:
        return f"({float(weight)!r}, 1)"
    return f"({weight.numerator}, {weight.denominator})"


def _weighted(weights: Sequence[Fraction], divisor: int | None = None) -> str:
    """The numbers in what `_increment` prints; in what `_sum` prints, if the divisor is 1."""
    common = divisor or math.lcm(*(weight.denominator for weight in weights))
    if common > _LARGEST:
        common = 1
    terms = [(k, weight * common) for k, weight in enumerate(weights) if weight]
    short = (f"({k}, {w.numerator if w.denominator == 1 else float(w)!r})" for k, w in terms)
    return f"({common}, {_many(short)})"


def _many(parts: Iterable[str]) -> str:
    """A tuple, however many there are."""
    found = list(parts)
    return f"({found[0]},)" if len(found) == 1 else f"({', '.join(found)})"


def _facts(items: Sequence[Item]) -> str:
    lines = ["FACTS: dict[str, Facts] = {"]
    for item in items:
        if "stability" in item.data:
            symplectic = item.data["family"] == "splitting"
            stable = item.data["stability"]
            calls = len(item.data.get("c") or item.data["kick"])
            given = f"{item.data['order']}, {symplectic}, {float(stable['oscillation'])}"
            lines.append(f'    "{item.id}": Facts({given}, {float(stable["decay"])}, {calls}),')
    return "\n".join([*lines, "}"])


def _function(item: Item) -> str:
    scheme = scheme_of(item, print)
    if scheme is None:
        raise ValueError(item.id)
    body = {
        "runge_kutta": _runge_kutta,
        "splitting": _splitting,
        "exponential": _splitting,
        "two_level": _two_level,
    }
    arguments = {"two_level": _LEVELS, "exponential": _DRIFT}.get(scheme.family, _STEP)
    result = "Pair" if scheme.error else "tuple[Any, Any]"
    lines = [f"def {scheme.name}({arguments}) -> {result}:"]
    says = textwrap.wrap(" ".join(item.data["says"].split()) + ".", 92)
    source = f"Source: {item.file}:{item.line}; {', '.join(item.data['source'])}."
    head = f"{item.title}, of order {scheme.order}."
    lines += docstring([head, "", says[0][0].upper() + says[0][1:], *says[1:], "", source])
    return "\n".join(lines + [f"    {line}" for line in body[scheme.family](scheme)])


def _times(weight: Fraction, factor: str) -> str:
    """weight * factor, as one writes it."""
    if weight.denominator > _LARGEST:
        return f"{float(weight)!r} * {factor}"
    above = factor if weight.numerator == 1 else f"{weight.numerator} * {factor}"
    return above if weight.denominator == 1 else f"{above} / {weight.denominator}"


def _at(moment: Fraction) -> str:
    return "time" if moment == 0 else f"time + {_times(moment, 'time_step')}"


def _splitting(scheme: Scheme) -> list[str]:
    lines: list[str] = []
    passed = Fraction(0)
    for kick, drift in zip_longest(scheme.kick, scheme.drift, fillvalue=Fraction(0)):
        if kick:
            rate = f"acceleration({_at(passed)}, position, velocity)"
            lines.append(f"velocity = velocity + {_times(kick, 'time_step')} * {rate}")
        if drift and scheme.family == "exponential":
            length = _times(drift, "time_step")
            called = f"drift({_at(passed)}, {length}, position, velocity)"
            lines.append(f"position, velocity = {called}")
        elif drift:
            lines.append(f"position = position + {_times(drift, 'time_step')} * velocity")
        passed += drift
    return [*lines, "return position, velocity"]


def _runge_kutta(scheme: Scheme) -> list[str]:
    lines: list[str] = []
    velocities: list[str] = []
    rates: list[str] = []
    for stage, (row, moment) in enumerate(zip(scheme.a, scheme.c, strict=True), start=1):
        velocity = "velocity"
        if any(row):
            velocity = f"velocity_{stage}"
            lines.append(f"{velocity} = {_moved('velocity', row, rates)}")
        position = _moved("position", row, velocities)
        velocities.append(velocity)
        rates.append(f"rate_{stage}")
        lines.append(f"rate_{stage} = acceleration({_at(moment)}, {position}, {velocity})")
    lines.append(f"position_end = {_moved('position', scheme.b, velocities)}")
    lines.append(f"velocity_end = {_moved('velocity', scheme.b, rates)}")
    if not scheme.error:
        return [*lines, "return position_end, velocity_end"]
    return [
        *lines,
        "return Pair(",
        "    position_end,",
        "    velocity_end,",
        f"    ({', '.join(_increment(row, velocities) for row in scheme.error)},),",
        f"    ({', '.join(_increment(row, rates) for row in scheme.error)},),",
        f"    ({', '.join(_sum(column, rates) for column in zip(*scheme.dense, strict=True))},),",
        ")",
    ]


def _moved(start: str, weights: Sequence[Fraction], slopes: Sequence[str]) -> str:
    """start + time_step * (weighted sum of slopes)."""
    return f"{start} + {_increment(weights, slopes)}" if any(weights) else start


def _increment(weights: Sequence[Fraction], slopes: Sequence[str]) -> str:
    """time_step * (weighted sum of slopes), over a common denominator where that is short."""
    common = math.lcm(*(weight.denominator for weight in weights)) if weights else 1
    if common > _LARGEST:
        return f"time_step * ({_sum(weights, slopes)})"
    total = _sum([weight * common for weight in weights], slopes)
    step = "time_step" if common == 1 else f"time_step / {common}"
    return f"{step} * {total if ' ' not in total else f'({total})'}"


def _sum(weights: Sequence[Fraction], slopes: Sequence[str]) -> str:
    text = ""
    for weight, slope in zip(weights, slopes, strict=True):
        if not weight:
            continue
        sign = "-" if weight < 0 else "+"
        size = abs(weight)
        short = size.denominator == 1
        term = slope if size == 1 else f"{size if short else repr(float(size))} * {slope}"
        text += f" {sign} {term}" if text else f"{'-' if weight < 0 else ''}{term}"
    return text


def _two_level(scheme: Scheme) -> list[str]:
    of_velocity, *of_acceleration = scheme.position
    moves = [f"{_times(of_velocity, 'time_step')} * velocity"] if of_velocity else []
    square = "time_step * time_step"
    names = ("previous", "current")
    moves += [
        f"{_times(w, square)} * {n}" for w, n in zip(of_acceleration, names, strict=True) if w
    ]
    kicks = [
        f"{_times(w, 'time_step')} * {n}" for w, n in zip(scheme.velocity, names, strict=True) if w
    ]
    return [f"return {' + '.join(['position', *moves])}, {' + '.join(['velocity', *kicks])}"]
