"""What the generated tests lean on: values drawn from the symbols' ranges, and references."""

import inspect
import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from hypothesis import assume, reject, strategies as st
from scipy.integrate import solve_ivp

from tamias2d.generated.symbols import SYMBOLS
from tamias2d.spec.constraint_functions import ConstraintFunctions
from tamias2d.spec.evaluate import evaluate
from tamias2d.spec.expression import Node, parse

Value = Any
_VERTICES = 5


def _symbol(name: str) -> Any:
    words = name.split("_")
    return next(
        SYMBOLS[key] for n in range(len(words), 0, -1) if (key := "_".join(words[:n])) in SYMBOLS
    )


def _component(name: str) -> st.SearchStrategy[Any]:
    limits = _symbol(name).range
    low = max(limits.low, -10.0)
    high = min(limits.high, 10.0)
    low = low + 0.1 if limits.low == low and limits.low_open else low
    number = st.floats(low, high, allow_nan=False, allow_subnormal=False)
    if not name.endswith(("_i", "_j")):
        return number
    return st.lists(number, min_size=_VERTICES, max_size=_VERTICES).map(np.array)


def values(name: str) -> st.SearchStrategy[Value]:
    """Values of a symbol, within its range and of ordinary size."""
    if _symbol(name).shape == "vector":
        return st.tuples(_component(name), _component(name))
    return _component(name)


def close(found: Value, wanted: Value, tolerance: float = 1e-9) -> None:
    """Equal up to rounding that a few hundred terms of size 1e3 could leave."""
    np.testing.assert_allclose(
        np.array(found, float), np.array(wanted, float), rtol=tolerance, atol=tolerance
    )


def agrees(
    function: Callable[..., Value],
    expression: Node,
    given: Mapping[str, Value],
    where: Mapping[str, Node],
) -> None:
    """A printed function gives what its expression gives; values outside its domain are drawn anew.

    Where no value that is drawn lies within the domain, hypothesis fails the test.
    """
    known = dict(given)
    with np.errstate(all="ignore"):
        try:
            for name, tree in where.items():
                known[name] = evaluate(tree, known)
            wanted = evaluate(expression, known)
        except (ZeroDivisionError, ValueError):  # such as the root of a negative number
            reject()
        assume(np.all(np.isfinite(np.array(wanted, float))))
        close(function(**given), wanted)


def follows(constraint: ConstraintFunctions, given: Mapping[str, Value]) -> None:
    """Slopes, rate and convective part agree with differences of what they are derivatives of.

    Central differences over a way of 1e-3 err by 1e-7 of third derivatives, after one halving
    that takes away the square by 1e-12 of fifth ones; rounding adds 1e-12. Where two places are
    nearly one, a distance bends too sharply for that, and other values are drawn.
    """
    assume(all(abs(span) > 1.0 for span in _spans(constraint, given)))
    known = {"time": 0.3, **given}
    entries = {end: constraint.slopes[end](known) for end in constraint.bodies}
    for end in constraint.bodies:
        for column, seed in enumerate(("x", "y", "turn")):
            slope = _difference(lambda s, e=end, c=seed: constraint.constraint(_at(known, e, c, s)))
            close(np.array(entries[end], float).reshape(-1, 3)[:, column], slope, 1e-7)
    # times in which no body goes farther than such a way
    fastest = max(1.0, *(float(np.abs(known[name]).max()) for name in known if "velocity" in name))
    drift = _difference(lambda s: constraint.constraint(_moved(known, s / fastest))) * fastest
    close(constraint.rate(known), drift, 1e-6)
    bend = _difference(lambda s: constraint.rate(_moved(known, s / fastest))) * fastest
    close(constraint.convective(known), bend, 1e-5)


def _difference(value: Callable[[float], Value]) -> Any:
    """The derivative at 0, by central differences of two widths."""

    def central(h: float) -> Any:
        return (np.array(value(h), float) - np.array(value(-h), float)) / (2 * h)

    return (4 * central(5e-4) - central(1e-3)) / 3


def _at(known: Mapping[str, Value], end: str, seed: str, way: float) -> dict[str, Value]:
    x, y = known[f"position_{end}"]
    turn = known[f"orientation_{end}"]
    place = (x + way * (seed == "x"), y + way * (seed == "y"))
    moved = {f"position_{end}": place, f"orientation_{end}": turn + way * (seed == "turn")}
    return {**known, **moved}


def _moved(known: Mapping[str, Value], time: float) -> dict[str, Value]:
    """Values a little later, where no body is accelerated."""
    moved = {**known, "time": known["time"] + time}
    for end in "abc":
        (x, y), (u, v) = known[f"position_{end}"], known[f"velocity_{end}"]
        moved[f"position_{end}"] = (x + u * time, y + v * time)
        turn, spin = known[f"orientation_{end}"], known[f"angular_velocity_{end}"]
        moved[f"orientation_{end}"] = turn + spin * time
    return moved


def _spans(constraint: ConstraintFunctions, given: Mapping[str, Value]) -> list[float]:
    """The distances by which slopes are divided, in m."""
    places = {}
    for end in "abc":
        turn = complex(math.cos(given[f"orientation_{end}"]), math.sin(given[f"orientation_{end}"]))
        center = complex(*given[f"position_{end}"])
        for name in (f"anchor_{end}", "post_a", "post_b"):
            if name in given:
                places[name, end] = center + turn * complex(*given[name])
    if ("post_a", "c") in places:
        return [abs(places[f"anchor_{e}", e] - places[f"post_{e}", "c"]) for e in "ab"]
    if "joint_length" in constraint.parameters:
        return [abs(places["anchor_a", "a"] - places["anchor_b", "b"])]
    return []


def only(given: Mapping[str, Value], function: Callable[..., Value]) -> dict[str, Value]:
    """The values that a function takes."""
    return {name: given[name] for name in inspect.signature(function).parameters}


def solve(states: Mapping[str, str], given: Mapping[str, Value]) -> dict[str, Value]:
    """States at `time`, from their rates, by scipy's DOP853 at rtol 1e-12 over the share of it."""
    rates = {name: parse(text) for name, text in states.items()}
    sizes = {name: len(np.atleast_1d(np.array(given[f"{name}_start"]))) for name in states}

    def unpack(flat: Any) -> dict[str, Value]:
        parts, place = {}, 0
        for name, size in sizes.items():
            piece = flat[place : place + size]
            parts[name] = tuple(piece) if size == 2 else float(piece[0])
            place += size
        return parts

    def rate(_time: float, flat: Any) -> Any:
        known = {**given, **unpack(flat)}
        slopes = [np.atleast_1d(np.array(evaluate(rates[name], known))) for name in states]
        return given["time"] * np.concatenate(slopes)

    start = np.concatenate(
        [np.atleast_1d(np.array(given[f"{name}_start"], float)) for name in states]
    )
    share = solve_ivp(rate, (0.0, 1.0), start, method="DOP853", rtol=1e-12, atol=1e-12)
    return unpack(share.y[:, -1])


def _slope(errors: list[float]) -> float:
    """Observed order over the halvings of the step."""
    halvings = len(errors) - 1
    return math.log2(errors[0] / errors[-1]) / halvings


def observed_order(step: Callable[..., Any], span: float = 1.7, steps: int = 64) -> float:
    """Order on the oscillator y'' = -y, whose solution is known, at a generic phase."""
    errors = []
    for halving in range(5):
        count = steps * 2**halving
        h, y, v = span / count, 1.0, 0.3
        for k in range(count):
            y, v, *_ = step(k * h, h, y, v, lambda _t, p, _v: -p)
        errors.append(abs(y - (math.cos(span) + 0.3 * math.sin(span))))
    return _slope(errors)


def observed_order_under_drag(step: Callable[..., Any]) -> float:
    """Order on y'' = -y - y'/2, of which the scheme solves the drag exactly."""
    rate, span = 0.25, 1.7
    fast = math.sqrt(1 - rate * rate)

    def drift(_t: float, h: float, y: float, v: float) -> tuple[float, float]:
        kept = math.exp(-2 * rate * h)
        return y + v * (1 - kept) / (2 * rate), v * kept

    exact = math.exp(-rate * span) * (
        math.cos(fast * span) + (0.3 + rate) / fast * math.sin(fast * span)
    )
    errors = []
    for count in (64, 128, 256, 512, 1024):
        h, y, v = span / count, 1.0, 0.3
        for k in range(count):
            y, v = step(k * h, h, y, v, lambda _t, p, _v: -p, drift)
        errors.append(abs(y - exact))
    return _slope(errors)


def observed_order_of_levels(step: Callable[..., tuple[float, float]]) -> float:
    """Order on y'' = cos t, for schemes that remember one acceleration: 0 before the first step."""
    errors = []
    for count in (64, 128, 256, 512, 1024):
        h, y, v, before = 1.7 / count, 1.0, 0.3, 0.0
        for k in range(count):
            now = math.cos(k * h)
            y, v = step(h, y, v, before, now)
            before = now
        errors.append(abs(y - (2.0 + 0.3 * 1.7 - math.cos(1.7))))
    return _slope(errors)
