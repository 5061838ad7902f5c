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


def _either(scalar: Callable[..., float], array: Callable[..., Any]) -> Callable[..., Scalar]:
    def apply(*operands: Scalar) -> Scalar:
        any_array = any(isinstance(operand, np.ndarray) for operand in operands)
        return array(*operands) if any_array else scalar(*operands)

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


def power(base: Scalar, exponent: int) -> Scalar:
    """A whole positive power as repeated products: `**` rounds differently for arrays."""
    result = base
    for _ in range(exponent - 1):
        result = result * base
    return result


def total(terms: Scalar) -> Scalar:
    """The sum over particles or vertices."""
    return float(np.sum(terms))
