"""Numbers from an expression, for given values.

Serves: forces that depend on time, oracles, checks of derivations. Hides: whether a value is a
float or an array, and in which order the parts are computed. A vector is a pair (x, y).
"""

import math
import operator
from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from tamias2d.spec import expression as ex, functions as fn
from tamias2d.spec.expression import Node

Value = Any  # a float, an array, a pair of these, or a truth value


class Program:
    """An expression made ready to be evaluated many times: what is written twice is done once."""

    def __init__(self, node: Node) -> None:
        """Take a tree. Raises: KeyError: a part of it, such as a derivative, has no value."""
        self._node = node
        self._place: dict[Node, int] = {}
        self._names: list[tuple[int, str]] = []
        self._start: list[Value] = []
        self._steps: list[tuple[int, Callable[..., Value], tuple[int, ...]]] = []
        self._last = self._put(node)

    def __call__(self, values: Mapping[str, Value]) -> Value:
        """Return the value in SI units; raise `KeyError` for a name without one."""
        found = self._start.copy()
        for place, name in self._names:
            found[place] = values[name]
        for place, function, arguments in self._steps:
            found[place] = function(*[found[k] for k in arguments])
        return found[self._last]

    def __reduce__(self) -> tuple[type["Program"], tuple[Node]]:
        return Program, (self._node,)

    def _put(self, node: Node) -> int:
        """Return where the value of a part will be, the same place for equal parts."""
        if node in self._place:
            return self._place[node]
        constant: Value = None
        match node:
            case ex.Number() | ex.Measure():
                constant = node.number
            case ex.Name(name="pi"):
                constant = math.pi
            case ex.Name(name=name):
                self._names.append((len(self._start), name))
            case _:
                function, parts = _operation(node)
                arguments = tuple([self._put(part) for part in parts])
                self._steps.append((len(self._start), function, arguments))
        self._start.append(constant)
        self._place[node] = len(self._start) - 1
        return self._place[node]


def evaluate(node: Node, values: Mapping[str, Value]) -> Value:
    """The value of an expression, in SI units; names are looked up in `values`.

    Raises:
        KeyError: a name has no value.
    """
    return Program(node)(values)


def _operation(node: Node) -> tuple[Callable[..., Value], tuple[Node, ...]]:
    """Return what to do with the values of which parts."""
    match node:
        case ex.Negative(operand=operand):
            return lambda a: _each(operator.neg, a), (operand,)
        case ex.Binary(operator=sign, left=left, right=right):
            return _BINARY[sign], (left, right)
        case ex.Power(base=base, exponent=exponent):
            return lambda a: _power(a, exponent), (base,)
        case ex.Relation(operator=sign, left=left, right=right):
            return _RELATION[sign], (left, right)
        case ex.Both(parts=conditions):
            return lambda *truths: all(truths), conditions
        case ex.Call(function=function, arguments=arguments) if function in _CALL:
            return _CALL[function], arguments
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


def _rotated(a: Value, cosine: Value, sine: Value) -> Value:
    return cosine * a[0] - sine * a[1], sine * a[0] + cosine * a[1]


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
    "rotate": lambda a, angle: _rotated(a, fn.cos(angle), fn.sin(angle)),
    "norm": lambda a: fn.sqrt(a[0] * a[0] + a[1] * a[1]),
    "sum": lambda a: _each(fn.total, a),
}
