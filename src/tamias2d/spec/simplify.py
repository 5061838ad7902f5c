"""Sums, products and components of expressions, without what adds nothing: zeros and ones.

Serves: derivatives, most of whose terms vanish. Hides: the rules by which terms vanish. A zero fits
any shape and unit.
"""

from fractions import Fraction

from tamias2d.spec.expression import Binary, Call, Negative, Node, Number, Power

ZERO = Number(Fraction(0))
ONE = Number(Fraction(1))
_AXES = "xy"


def is_zero(node: Node) -> bool:
    """Whether an expression is plainly zero, of whatever shape."""
    if isinstance(node, Call) and node.function == "vector":
        return all(is_zero(part) for part in node.arguments)
    return node == ZERO


def negative(node: Node) -> Node:
    """The expression with its sign changed."""
    match node:
        case Number(value=value):
            return Number(-value)
        case Negative(operand=operand):
            return operand
        case Binary(operator="-", left=left, right=right):
            return Binary("-", right, left)
        case Call(function="vector", arguments=(x, y)):
            return Call("vector", (negative(x), negative(y)))
    return ZERO if node == ZERO else Negative(node)


def added(left: Node, right: Node) -> Node:
    """The sum."""
    if is_zero(left):
        return right
    if is_zero(right):
        return left
    if isinstance(right, Negative):
        return subtracted(left, right.operand)
    return Binary("+", left, right)


def subtracted(left: Node, right: Node) -> Node:
    """The difference."""
    if is_zero(right):
        return left
    if is_zero(left):
        return negative(right)
    if isinstance(right, Negative):
        return added(left, right.operand)
    return ZERO if left == right else Binary("-", left, right)


def times(left: Node, right: Node) -> Node:
    """The product of two scalars, or of a scalar and a vector."""
    if is_zero(left) or is_zero(right):
        return ZERO
    match left, right:
        case Number(value=a), Number(value=b):
            return Number(a * b)
        case (Number(value=1), other) | (other, Number(value=1)):
            return other
        case (Number(value=-1), other) | (other, Number(value=-1)):
            return negative(other)
        case Negative(operand=a), Negative(operand=b):
            return times(a, b)
        case (Negative(operand=operand), other) | (other, Negative(operand=operand)):
            return Negative(times(operand, other))
    return Binary("*", left, right)


def over(left: Node, right: Node) -> Node:
    """The quotient by a scalar."""
    if is_zero(left):
        return ZERO
    return left if right == ONE else Binary("/", left, right)


def power(base: Node, exponent: Fraction) -> Node:
    """The base to a whole or half power."""
    if exponent == 0:
        return ONE
    return base if exponent == 1 else Power(base, exponent)


def call(function: str, *arguments: Node) -> Node:
    """A function of the language, linear in each of its arguments; a fixed axis selects."""
    if any(is_zero(argument) for argument in arguments) and function != "vector":
        return ZERO
    match function, arguments:
        case (("x" | "y"), (inner,)):
            return component(inner, function)
        case "dot", (other, Call(function="vector", arguments=(Number() as u, Number() as v))):
            return added(times(u, component(other, "x")), times(v, component(other, "y")))
        case "dot", (Call(function="vector", arguments=(Number(), Number())) as fixed, other):
            return call("dot", other, fixed)
        case "dot", (Negative(operand=left), right) | (right, Negative(operand=left)):
            return negative(call("dot", left, right))
        case "dot", (
            Call(function="perp", arguments=(left,)),
            Call(function="perp", arguments=(right,)),
        ):
            return call("dot", left, right)
        case "perp", (Call(function="vector", arguments=(x, y)),):
            return Call("vector", (negative(y), x))
        case "perp", (Call(function="perp", arguments=(inner,)),):
            return negative(inner)
        case "perp", (Negative(operand=operand),):
            return negative(call("perp", operand))
        case "perp", (Binary(operator="*", left=left, right=right),) if _plainly_vector(right):
            return times(left, call("perp", right))
    return Call(function, arguments)


def component(node: Node, axis: str) -> Node:
    """One component of a vector."""
    match node:
        case _ if is_zero(node):
            return ZERO
        case Negative(operand=operand):
            return negative(component(operand, axis))
        case Binary(operator="+", left=left, right=right):
            return added(component(left, axis), component(right, axis))
        case Binary(operator="-", left=left, right=right):
            return subtracted(component(left, axis), component(right, axis))
        case Binary(operator="/", left=left, right=right):
            return over(component(left, axis), right)
        case Call(function="vector", arguments=arguments):
            return arguments[_AXES.index(axis)]
        case Call(function="perp", arguments=(inner,)):
            return negative(component(inner, "y")) if axis == "x" else component(inner, "x")
        case Call(function="cross", arguments=(turn, arm)):
            across = component(arm, "y" if axis == "x" else "x")
            return negative(times(turn, across)) if axis == "x" else times(turn, across)
    return Call(axis, (node,))


def _plainly_vector(node: Node) -> bool:
    """Whether an expression is a vector by its form, so that what it is multiplied by is none."""
    match node:
        case Negative(operand=operand) | Binary(operator="*", right=operand):
            return _plainly_vector(operand)
        case Call(function=function):
            return function in ("vector", "perp", "rotate")
    return False
