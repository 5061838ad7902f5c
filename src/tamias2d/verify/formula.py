"""Exact answers, from the text of a case: an expression evaluated at given times.

Nothing here knows the models, and each expression's unit and shape are checked.
"""

from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np

from tamias2d.errors import SpecError
from tamias2d.generated.symbols import SYMBOLS
from tamias2d.spec.check import Type, expect
from tamias2d.spec.evaluate import evaluate
from tamias2d.spec.expression import Node, parse
from tamias2d.spec.messages import SpecFault
from tamias2d.spec.symbols import SymbolTable, table_from
from tamias2d.spec.units import parse_quantity
from tamias2d.state import Array


def history(text: str, quantity: str, times: Array, *, time_step: float | None = None) -> Array:
    """Return an expression of `time` at the times (k,) in s: (k,), or (k, 2) for a vector.

    Raises:
        SpecError: the text is no expression of time in the quantity's unit and shape.
    """
    symbol = SYMBOLS[quantity]
    node = _read(text, quantity, Type(symbol.shape, symbol.dimension), _clock())
    value = evaluate(node, {"time": times, "time_step": time_step})
    if symbol.shape == "scalar":
        return np.broadcast_to(np.asarray(value, dtype=float), times.shape)
    return np.stack([np.broadcast_to(part, times.shape) for part in value], axis=-1)


def instant(text: str) -> float:
    """Return an expression that is a time, in s. Raises: SpecError, as above."""
    symbol = SYMBOLS["time"]
    node = _read(text, "time", Type("scalar", symbol.dimension), table_from({}))
    return float(evaluate(node, {}))


def measure(value: Any, symbol: str) -> Any:
    """Return a quantity, or a pair of them, in SI units. Raises: SpecError, for a wrong unit."""
    if isinstance(value, list):
        return tuple(measure(part, symbol) for part in value)
    try:
        quantity = parse_quantity(value)
    except SpecFault as fault:
        raise SpecError(f"{symbol}: '{value}': {fault.message}.") from None
    wanted = SYMBOLS[symbol].dimension
    if quantity.dimension != wanted:
        raise SpecError(
            f"{symbol}: '{value}' is in {quantity.dimension}: must be in {wanted} "
            f"(symbol {symbol}). Correct the unit."
        )
    return quantity.value


def _read(text: str, what: str, wanted: Type, table: SymbolTable) -> Node:
    try:
        node = parse(text)
        expect(node, table, wanted)
    except SpecFault as fault:
        raise SpecError(f"{what}: '{text}': {fault.message}.") from None
    return node


@cache
def _clock() -> SymbolTable:
    return table_from({name: SYMBOLS[name] for name in ("time", "time_step")})


def distance(found: Array, exact: Array) -> float:
    """Return the norm of the difference over the norm of the exact answer.

    Where that norm is 0 the difference itself is the error. Values that are not finite make it
    infinite.
    """
    difference = float(np.linalg.norm(np.asarray(found) - exact))
    size = float(np.linalg.norm(exact))
    error = difference / size if size else difference
    return error if np.isfinite(error) else np.inf


Bodies = Mapping[str, Mapping[str, str]]
"""Body -> quantity -> expression."""
