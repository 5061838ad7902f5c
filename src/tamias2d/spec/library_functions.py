"""Elementary functions with the bits of the C library, of floats and of arrays alike.

Serves: forces, whose compiled code calls the C library, too, and which must not depend on how they
were computed. Hides: that NumPy has a sine and an exponential of its own, and that `math` raises
where the C library returns an infinity or no number.
"""

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from tamias2d.spec.functions import Scalar, pi, power

__all__ = [
    "atan2", "cos", "exp", "largest", "least", "log", "pi", "power", "sin", "sqrt", "tan",
]  # fmt: skip


def _each(function: Callable[..., float]) -> Callable[..., Scalar]:
    """Return a function that takes floats, or arrays of one shape (n,)."""

    def apply(*operands: Scalar) -> Scalar:
        for operand in operands:
            if isinstance(operand, np.ndarray):
                columns = np.broadcast_arrays(*operands)
                values = [
                    function(*row)
                    for row in zip(*(column.tolist() for column in columns), strict=True)
                ]
                return np.array(values, dtype=np.float64)
        return function(*operands)

    return apply


def _total(function: Callable[[float], float]) -> Callable[[float], float]:
    """Return a function that is no number where `math` has none."""

    def apply(operand: float) -> float:
        try:
            return function(operand)
        except ValueError:
            return math.nan
        except OverflowError:
            return math.inf

    return apply


def _log(operand: float) -> float:
    return _total(math.log)(operand) if operand else -math.inf


sin = _each(_total(math.sin))
cos = _each(_total(math.cos))
tan = _each(_total(math.tan))
exp = _each(_total(math.exp))
log = _each(_log)
atan2 = _each(math.atan2)


def sqrt(operand: Scalar) -> Scalar:
    """The square root, which is rounded correctly everywhere."""
    return np.sqrt(operand)


def least(first: Any, second: Any) -> Scalar:
    """The lesser of two; the first if they are equal, or if one is no number."""
    return np.where(second < first, second, first)[()]


def largest(first: Any, second: Any) -> Scalar:
    """The larger of two; the first if they are equal, or if one is no number."""
    return np.where(second > first, second, first)[()]
