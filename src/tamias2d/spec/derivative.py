"""The derivative of an expression with respect to one name.

Serves: the check that a closed form solves its equations. Hides: the rules of calculus.
"""

from collections.abc import Callable
from fractions import Fraction

from tamias2d.spec.expression import Binary, Call, Measure, Name, Negative, Node, Number, Power

ZERO = Number(Fraction(0))
ONE = Number(Fraction(1))


def _less_twice(first: Node, second: Node) -> Node:
    return Binary("-", first, Binary("*", Number(Fraction(2)), second))


_OUTER: dict[str, Callable[[Node], Node]] = {
    "sin": lambda a: Call("cos", (a,)),
    "cos": lambda a: Negative(Call("sin", (a,))),
    "exp": lambda a: Call("exp", (a,)),
    "log": lambda a: Binary("/", ONE, a),
    "sqrt": lambda a: Power(a, Fraction(-1, 2)),
    "tan": lambda a: Power(Call("cos", (a,)), Fraction(-2)),
    "phi1": lambda a: Binary("-", Call("phi1", (a,)), Call("phi2", (a,))),
    "phi2": lambda a: Binary("/", _less_twice(Call("phi1", (a,)), Call("phi2", (a,))), a),
}


def differentiate(node: Node, name: str) -> Node:
    """d(node)/d(name); all other names count as constants.

    Raises:
        ValueError: the expression has a part without a derivative here (min, abs, a relation).
    """
    match node:
        case Number() | Measure():
            return ZERO
        case Name(name=other):
            return ONE if other == name else ZERO
        case Negative(operand=operand):
            return Negative(differentiate(operand, name))
        case Binary(operator="+" | "-" as operator, left=left, right=right):
            return Binary(operator, differentiate(left, name), differentiate(right, name))
        case Binary(operator="*", left=left, right=right):
            return _product(left, right, name, lambda a, b: Binary("*", a, b))
        case Binary(operator="/", left=left, right=right):
            slope = Binary("*", left, differentiate(right, name))
            above = Binary("/", differentiate(left, name), right)
            return Binary("-", above, Binary("/", slope, Power(right, Fraction(2))))
        case Power(base=base, exponent=exponent):
            outer = Binary("*", Number(exponent), Power(base, exponent - 1))
            return Binary("*", outer, differentiate(base, name))
        case Call(function="dot" | "cross" as function, arguments=(left, right)):
            return _product(left, right, name, lambda a, b: Call(function, (a, b)))
        case Call(function="perp" | "vector" | "x" | "y" | "sum" as function, arguments=arguments):
            return Call(function, tuple(differentiate(part, name) for part in arguments))
        case Call(function=function, arguments=(inner,)) if function in _OUTER:
            factor = Number(Fraction(1, 2)) if function == "sqrt" else ONE
            outer = Binary("*", factor, _OUTER[function](inner))
            return Binary("*", outer, differentiate(inner, name))
    raise ValueError(f"{type(node).__name__} has no derivative here")


def _product(left: Node, right: Node, name: str, combine: Callable[[Node, Node], Node]) -> Node:
    first = combine(differentiate(left, name), right)
    return Binary("+", first, combine(left, differentiate(right, name)))
