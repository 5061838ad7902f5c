"""Elementary functions that take floats and arrays alike.

Serves: generated code and the evaluation of expressions, which thereby agree to the bit. Hides:
whether `math` or NumPy computes.
"""

import math
from collections.abc import Callable
from typing import Any

import numpy as np

Scalar = Any  # a float, or an array of floats
Truth = Any  # a truth value, or an array of them
Vector = tuple[Any, Any]  # two components, each a float or an array

pi = math.pi


def _either(scalar: Callable[..., float], array: Callable[..., Any]) -> Callable[..., Scalar]:
    def apply(*operands: Scalar) -> Scalar:
        for operand in operands:
            if isinstance(operand, np.ndarray):
                return array(*operands)
        return scalar(*operands)

    return apply


sqrt = _either(math.sqrt, np.sqrt)
sin = _either(math.sin, np.sin)
cos = _either(math.cos, np.cos)
tan = _either(math.tan, np.tan)
exp = _either(math.exp, np.exp)
log = _either(math.log, np.log)
atan2 = _either(math.atan2, np.arctan2)
least = _either(min, np.minimum)
largest = _either(max, np.maximum)


def phi1(argument: Scalar) -> Scalar:
    """(exp z - 1)/z, the mean of the exponential from 0 to z; 1 at 0, without cancellation."""
    if isinstance(argument, np.ndarray):
        return np.expm1(argument) / np.where(argument == 0, 1.0, argument) + (argument == 0)
    return math.expm1(argument) / argument if argument else 1.0


def phi2(argument: Scalar) -> Scalar:
    """(exp z - 1 - z)/z^2; 1/2 at 0, and near 0 by its series, where the quotient cancels."""
    if isinstance(argument, np.ndarray):
        near = np.abs(argument) < 1
        far = np.where(near, 1.0, argument)
        return np.where(near, series(np.where(near, argument, 0.0)), (phi1(far) - 1) / far)
    return series(argument) if abs(argument) < 1 else (phi1(argument) - 1) / argument


def series(argument: Scalar) -> Scalar:
    """Sum of z^k/(k + 2)!; for |z| < 1 what is left out is below rounding."""
    result = 0.0
    for divisor in range(19, 2, -1):
        result = (result + 1) * argument / divisor
    return (result + 1) / 2


def power(base: Scalar, exponent: int) -> Scalar:
    """A whole positive power as repeated products: `**` rounds differently for arrays."""
    result = base
    for _ in range(exponent - 1):
        result = result * base
    return result


def total(terms: Scalar) -> Scalar:
    """The sum over particles or vertices."""
    return float(np.sum(terms))
