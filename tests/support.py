"""What the generated tests lean on: values drawn from the symbols' ranges, and references."""

import inspect
import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from hypothesis import assume, reject, strategies as st
from scipy.integrate import solve_ivp

from tamias2d.generated.symbols import SYMBOLS
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
    """Order on y'' = cos t, for schemes that remember one acceleration."""
    errors = []
    for count in (64, 128, 256, 512, 1024):
        h, y, v = 1.7 / count, 1.0, 0.3
        for k in range(count):
            y, v = step(h, y, v, math.cos(k * h), math.cos((k + 1) * h))
        errors.append(abs(y - (2.0 + 0.3 * 1.7 - math.cos(1.7))))
    return _slope(errors)
