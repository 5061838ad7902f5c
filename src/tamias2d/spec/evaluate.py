"""Numbers from an expression: the tree is walked with given values.

Serves: forces that depend on time, oracles, checks of derivations. Hides: whether a value is a
float or an array. A vector is a pair (x, y).
"""

import math
import operator
from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from tamias2d.spec import functions as fn
from tamias2d.spec.expression import (
    Binary,
    Both,
    Call,
    Measure,
    Name,
    Negative,
    Node,
    Number,
    Power,
    Relation,
)

Value = Any  # a float, an array, a pair of these, or a truth value


def evaluate(node: Node, values: Mapping[str, Value]) -> Value:
    """The value of an expression, in SI units; names are looked up in `values`.

    Raises:
        KeyError: a name has no value.
    """
    match node:
        case Number() | Measure():
            return node.number
        case Name(name=name):
            return math.pi if name == "pi" else values[name]
        case Negative(operand=operand):
            return _each(lambda a: -a, evaluate(operand, values))
        case Binary(operator=sign, left=left, right=right):
            return _BINARY[sign](evaluate(left, values), evaluate(right, values))
        case Power(base=base, exponent=exponent):
            return _power(evaluate(base, values), exponent)
        case Relation(operator=sign, left=left, right=right):
            return _RELATION[sign](evaluate(left, values), evaluate(right, values))
        case Both(parts=conditions):
            return all(evaluate(condition, values) for condition in conditions)
        case Call(function=function, arguments=arguments) if function in _CALL:
            return _CALL[function](*(evaluate(argument, values) for argument in arguments))
    raise KeyError(f"{node} has no value of its own")


def _power(base: Value, exponent: Fraction) -> Value:
    whole = fn.power(base, abs(exponent.numerator)) if exponent else 1.0
    root = fn.sqrt(whole) if exponent.denominator == 2 else whole
    return 1 / root if exponent < 0 else root


def _each(function: Callable[..., Value], *operands: Value) -> Value:
    """Apply component by component; a scalar goes with both components."""
    for operand in operands:
        if isinstance(operand, tuple):
            break
    else:
        return function(*operands)
    pairs = [operand if isinstance(operand, tuple) else (operand, operand) for operand in operands]
    return tuple(function(*components) for components in zip(*pairs, strict=True))


def _cross(a: Value, b: Value) -> Value:
    return a[0] * b[1] - a[1] * b[0] if isinstance(a, tuple) else (-a * b[1], a * b[0])


_BINARY: dict[str, Callable[[Value, Value], Value]] = {
    "+": lambda a, b: _each(operator.add, a, b),
    "-": lambda a, b: _each(operator.sub, a, b),
    "*": lambda a, b: _each(operator.mul, a, b),
    "/": lambda a, b: _each(operator.truediv, a, b),
}
_RELATION: dict[str, Callable[[Value, Value], Value]] = {
    "==": lambda a, b: a == b,
    "<": lambda a, b: a < b,
    "<=": lambda a, b: a <= b,
    ">": lambda a, b: a > b,
    ">=": lambda a, b: a >= b,
}
_CALL: dict[str, Callable[..., Value]] = {
    "sqrt": fn.sqrt,
    "sin": fn.sin,
    "cos": fn.cos,
    "tan": fn.tan,
    "exp": fn.exp,
    "log": fn.log,
    "phi1": fn.phi1,
    "phi2": fn.phi2,
    "abs": abs,
    "min": fn.least,
    "max": fn.largest,
    "atan2": fn.atan2,
    "vector": lambda a, b: (a, b),
    "x": lambda a: a[0],
    "y": lambda a: a[1],
    "dot": lambda a, b: a[0] * b[0] + a[1] * b[1],
    "cross": _cross,
    "perp": lambda a: (-a[1], a[0]),
    "norm": lambda a: fn.sqrt(a[0] * a[0] + a[1] * a[1]),
    "sum": lambda a: _each(fn.total, a),
}
