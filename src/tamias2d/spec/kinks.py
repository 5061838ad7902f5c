"""Kinks of an expression: where it, or a derivative of it, jumps.

Roots have them, too: of what comes to nothing and grows again, as of the square of a coordinate
that passes through zero. What a root divides by often enough grows without end there instead, and
nothing passes.
"""

from collections.abc import Collection
from fractions import Fraction

from tamias2d.spec.expression import (
    Binary,
    Call,
    Measure,
    Name,
    Negative,
    Node,
    Number,
    Power,
    names,
    parts,
)

_SWITCHES = ("abs", "min", "max", "atan2")
_ROOTS = ("sqrt", "norm")
_HALF, _ONE = Fraction(1, 2), Fraction(1)


def has_kinks(node: Node, varying: Collection[str]) -> bool:
    """Return whether an expression has a kink where some names in it vary."""
    return _has_kinks(node, _ONE, frozenset(varying))


def _has_kinks(node: Node, power: Fraction, varying: frozenset[str]) -> bool:
    """Return whether a power of an expression has a kink where some names in it vary."""
    if varying.isdisjoint(names(node)):
        return False
    match node:
        case Negative():
            return _has_kinks(node.operand, power, varying)
        case Power():
            return _has_kinks(node.base, power * node.exponent, varying)
        case Binary(operator="*"):
            return any(_has_kinks(part, power, varying) for part in (node.left, node.right))
        case Binary(operator="/"):
            divisor = _has_kinks(node.right, -power, varying)
            return divisor or _has_kinks(node.left, power, varying)
        case Call(function=function) if function in _SWITCHES:
            return True
        case Call(function=function) if function in _ROOTS:
            return _root_has_kinks(node.arguments[0], power * _HALF, varying)
    if power.denominator > 1:
        return _root_has_kinks(node, power, varying)
    return any(_has_kinks(part, _ONE, varying) for part in parts(node))


def _root_has_kinks(node: Node, power: Fraction, varying: frozenset[str]) -> bool:
    """Return whether a power of a root has a kink; that of a vector is of its square."""
    bent = power.denominator > 1 and power > -1 and not _is_positive(node)
    return bent or _has_kinks(node, _ONE, varying)


def _is_positive(node: Node) -> bool:
    """Return whether an expression is surely more than zero."""
    match node:
        case Number() | Measure():
            return node.value > 0
        case Name():
            return node.name in ("mass", "pi")
        case Power():
            return _is_positive(node.base)
        case Call():
            return node.function == "exp" or (
                node.function == "sqrt" and _is_positive(node.arguments[0])
            )
        case Binary(operator="+"):
            left, right = node.left, node.right
            some = _is_positive(left) or _is_positive(right)
            return some and _is_nonnegative(left) and _is_nonnegative(right)
        case Binary(operator="*" | "/"):
            return _is_positive(node.left) and _is_positive(node.right)
    return False


def _is_nonnegative(node: Node) -> bool:
    """Return whether an expression is surely not less than zero."""
    if _is_positive(node):
        return True
    match node:
        case Number() | Measure():
            return node.value >= 0
        case Power():
            return node.exponent % 2 == 0 or node.exponent.denominator > 1
        case Call(function="dot"):
            return node.arguments[0] == node.arguments[1]
        case Call():
            return node.function in ("abs", *_ROOTS)
        case Binary(operator="+" | "*" | "/"):
            return _is_nonnegative(node.left) and _is_nonnegative(node.right)
    return False
