"""A straight-line program: expressions as a list of operations on numbered scalars.

Serves: compiled code that runs what it did not know when it was compiled. Hides: how vectors become
scalars, and that what is written twice is computed once.

Scalars are numbered: first the inputs, then one for each operation. A constant is an operation that
yields what is there.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction

from tamias2d.spec import expression as ex
from tamias2d.spec.expression import Node

(
    CONSTANT, NEGATE, ADD, SUBTRACT, MULTIPLY, DIVIDE, SQRT, SIN, COS, TAN, EXP, LOG, ATAN2,
) = range(13)  # fmt: skip
_ELEMENTARY = {
    "sqrt": SQRT, "sin": SIN, "cos": COS, "tan": TAN, "exp": EXP, "log": LOG, "atan2": ATAN2,
}  # fmt: skip
_BINARY = {"+": ADD, "-": SUBTRACT, "*": MULTIPLY, "/": DIVIDE}

Operation = tuple[int, int, int]
"""What is done, and the numbers of the one or two scalars it is done to."""
_Value = int | tuple[int, int]  # the number of a scalar, or those of a vector's components


class StraightLine:
    """A program that is being written."""

    def __init__(
        self, inputs: Sequence[str], where: Mapping[str, Node], known: Mapping[Node, str]
    ) -> None:
        """Begin with the names of the inputs; components of a vector end in `_x` and `_y`.

        Some names stand for other expressions (`where`), and some expressions are `known`: their
        values are among the inputs, such as the cosine of an orientation.
        """
        self.operations: list[Operation] = []
        self.constants: list[float] = []
        """Of each operation: what a constant yields, 0 for all others."""
        self._number = {name: k for k, name in enumerate(inputs)}
        self._where, self._known = where, known
        self._values: dict[Node, _Value] = {}
        self._made: dict[tuple[float, ...], int] = {}

    def scalar(self, node: Node) -> int:
        """Return the number of the scalar that an expression is, after what it needs.

        Raises:
            KeyError: a part of it has no operation here.
            TypeError: it is a vector.
        """
        found = self._value(node)
        if isinstance(found, tuple):
            raise TypeError(node)
        return found

    def constant(self, value: float) -> int:
        """Return the number of a constant."""
        return self._put((CONSTANT, value))

    def _put(self, made: tuple[float, ...]) -> int:
        """Return the number of what an operation yields."""
        if made not in self._made:
            number = len(self._number) + len(self.operations)
            is_constant = made[0] == CONSTANT
            one, other = (number, number) if is_constant else (int(made[1]), int(made[-1]))
            self.operations.append((int(made[0]), one, other))
            self.constants.append(made[1] if is_constant else 0.0)
            self._made[made] = number
        return self._made[made]

    def _value(self, node: Node) -> _Value:
        if node not in self._values:
            self._values[node] = self._written(node)
        return self._values[node]

    def _written(self, node: Node) -> _Value:
        if node in self._known:
            return self._number[self._known[node]]
        match node:
            case ex.Number() | ex.Measure():
                return self.constant(node.number)
            case ex.Name(name=name):
                return self._named(name)
            case ex.Negative(operand=operand):
                return self._each(lambda a: self._put((NEGATE, a)), self._value(operand))
            case ex.Binary(operator=sign, left=left, right=right):
                does = _BINARY[sign]
                return self._each(
                    lambda a, b: self._put((does, a, b)), self._value(left), self._value(right)
                )
            case ex.Power(base=base, exponent=exponent):
                return self._power(self.scalar(base), exponent)
            case ex.Call(function=function, arguments=arguments):
                return self._call(function, arguments)
        raise KeyError(f"{node} has no operation")

    def _named(self, name: str) -> _Value:
        if name in self._where:
            return self._value(self._where[name])
        if name == "pi":
            return self.constant(math.pi)
        if f"{name}_x" in self._number:
            return self._number[f"{name}_x"], self._number[f"{name}_y"]
        return self._number[name]

    def _each(self, write: Callable[..., int], *operands: _Value) -> _Value:
        """Write something for each component; a scalar goes with both."""
        if not any(isinstance(operand, tuple) for operand in operands):
            return write(*operands)
        pairs = [each if isinstance(each, tuple) else (each, each) for each in operands]
        x, y = (write(*components) for components in zip(*pairs, strict=True))
        return x, y

    def _power(self, base: int, exponent: Fraction) -> int:
        whole = base if exponent else self.constant(1.0)
        for _ in range(abs(exponent.numerator) - 1):
            whole = self._put((MULTIPLY, whole, base))
        root = self._put((SQRT, whole)) if exponent.denominator == 2 else whole
        return self._put((DIVIDE, self.constant(1.0), root)) if exponent < 0 else root

    def _call(self, function: str, arguments: tuple[Node, ...]) -> _Value:
        if function in _ELEMENTARY:
            return self._put((_ELEMENTARY[function], *map(self.scalar, arguments)))
        if function == "vector":
            x, y = map(self.scalar, arguments)
            return x, y
        if function == "rotate":
            arm, angle = arguments
            cosine, sine = (self.scalar(ex.Call(name, (angle,))) for name in ("cos", "sin"))
            return self._turned(self._vector(arm), cosine, sine)
        values = [self._value(argument) for argument in arguments]
        match function, values:
            case "x", ((x, _),):
                return x
            case "y", ((_, y),):
                return y
            case "perp", ((x, y),):
                return self._put((NEGATE, y)), x
            case "norm", ((x, y),):
                return self._put((SQRT, self._sum_of_products((x, y), (x, y), ADD)))
            case "dot", ((x, y), (u, v)):
                return self._sum_of_products((x, y), (u, v), ADD)
            case "cross", ((x, y), (u, v)):
                return self._sum_of_products((x, y), (v, u), SUBTRACT)
            case "cross", (int() as turn, (x, y)):
                along_x = self._put((NEGATE, self._put((MULTIPLY, turn, y))))
                return along_x, self._put((MULTIPLY, turn, x))
        raise KeyError(f"{function} has no operation")

    def _vector(self, node: Node) -> tuple[int, int]:
        found = self._value(node)
        if not isinstance(found, tuple):
            raise TypeError(node)
        return found

    def _turned(self, arm: tuple[int, int], cosine: int, sine: int) -> tuple[int, int]:
        x = self._sum_of_products((cosine, sine), arm, SUBTRACT)
        return x, self._sum_of_products((sine, cosine), arm, ADD)

    def _sum_of_products(self, ones: tuple[int, int], others: tuple[int, int], sign: int) -> int:
        first, second = (self._put((MULTIPLY, a, b)) for a, b in zip(ones, others, strict=True))
        return self._put((sign, first, second))
