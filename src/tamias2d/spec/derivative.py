"""The derivative of an expression: with respect to one name, or along a motion.

Serves: the check that a closed form solves its equations, and the rates of constraints. Hides: the
rules of calculus.
"""

from collections.abc import Callable, Mapping
from fractions import Fraction

from tamias2d.spec.expression import Binary, Call, Measure, Name, Negative, Node, Number, Power
from tamias2d.spec.simplify import ONE, ZERO, added, call, negative, over, power, subtracted, times

_TWO = Number(Fraction(2))
_OUTER: dict[str, Callable[[Node], Node]] = {
    "sin": lambda a: Call("cos", (a,)),
    "cos": lambda a: Negative(Call("sin", (a,))),
    "exp": lambda a: Call("exp", (a,)),
    "log": lambda a: over(ONE, a),
    "sqrt": lambda a: over(Power(a, Fraction(-1, 2)), _TWO),
    "tan": lambda a: Power(Call("cos", (a,)), Fraction(-2)),
    "phi1": lambda a: Binary("-", Call("phi1", (a,)), Call("phi2", (a,))),
    "phi2": lambda a: over(_less_twice(Call("phi1", (a,)), Call("phi2", (a,))), a),
}


def differentiate(node: Node, name: str) -> Node:
    """d(node)/d(name); all other names count as constants.

    Raises:
        ValueError: the expression has a part without a derivative here (min, abs, a relation).
    """
    return along(node, {name: ONE})


def along(node: Node, rates: Mapping[str, Node]) -> Node:
    """The rate of an expression whose names change at the given rates; others are constants.

    Raises:
        ValueError: as `differentiate`.
    """
    match node:
        case Number() | Measure():
            return ZERO
        case Name(name=name):
            return rates.get(name, ZERO)
        case Negative(operand=operand):
            return negative(along(operand, rates))
        case Binary(operator=operator, left=left, right=right):
            return _binary(operator, left, right, rates)
        case Power(base=base, exponent=exponent):
            outer = times(Number(exponent), power(base, exponent - 1))
            return times(outer, along(base, rates))
        case Call(function=function, arguments=arguments):
            return _call(node, function, arguments, rates)
    raise ValueError(f"{type(node).__name__} has no derivative here")


def _binary(operator: str, left: Node, right: Node, rates: Mapping[str, Node]) -> Node:
    first, second = along(left, rates), along(right, rates)
    match operator:
        case "+":
            return added(first, second)
        case "-":
            return subtracted(first, second)
        case "*":
            return added(times(first, right), times(left, second))
    return subtracted(over(first, right), over(times(left, second), power(right, Fraction(2))))


def _call(
    node: Node, function: str, arguments: tuple[Node, ...], rates: Mapping[str, Node]
) -> Node:
    slopes = [along(argument, rates) for argument in arguments]
    match function, arguments:
        case (("dot" | "cross"), (left, right)):
            return added(call(function, slopes[0], right), call(function, left, slopes[1]))
        case (("perp" | "vector" | "x" | "y" | "sum"), _):
            return call(function, *slopes)
        case "rotate", (_, angle):
            turned = times(slopes[1], call("perp", node))
            return added(ZERO if slopes[0] == ZERO else Call("rotate", (slopes[0], angle)), turned)
        case "norm", (inner,):
            return over(call("dot", inner, slopes[0]), node)
        case "atan2", (up, along_):
            crossed = subtracted(times(along_, slopes[0]), times(up, slopes[1]))
            return over(crossed, added(power(up, Fraction(2)), power(along_, Fraction(2))))
        case _, (inner,) if function in _OUTER:
            return times(_OUTER[function](inner), slopes[0])
    if all(slope == ZERO for slope in slopes):
        return ZERO
    raise ValueError(f"{function} has no derivative here")


def _less_twice(first: Node, second: Node) -> Node:
    return Binary("-", first, Binary("*", _TWO, second))
