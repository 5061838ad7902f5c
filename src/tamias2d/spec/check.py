"""Units and shapes of an expression.

Serves: every expression before it is printed or evaluated. Hides: the rules of each operator.
A message names both sides with their units.
"""

from dataclasses import dataclass
from fractions import Fraction
from typing import Literal

from tamias2d.spec import expression as ex
from tamias2d.spec.expression import Node
from tamias2d.spec.messages import Code, SpecFault
from tamias2d.spec.symbols import SymbolTable
from tamias2d.spec.tex import plain
from tamias2d.spec.units import ONE, Dimension

Kind = Literal["scalar", "vector", "truth"]


@dataclass(frozen=True)
class Type:
    """Shape and dimension of a value; dimension None is a bare zero, which fits any unit."""

    shape: Kind
    dimension: Dimension | None = ONE

    def __str__(self) -> str:
        if self.shape == "truth":
            return "a condition"
        return f"a {self.shape} in {self.dimension or 'any unit'}"


TRUTH = Type("truth")
_NOT_STATED = {
    **dict.fromkeys(("d", "integral", "sum"), "has no value at an instant"),
    **dict.fromkeys(("phi1", "phi2"), "is for closed forms alone. Write it with exp"),
}
"""Functions that only chapters use, and why."""


def infer(node: Node, table: SymbolTable) -> Type:
    """Shape and dimension of an expression.

    Raises:
        SpecFault: a name is unknown, or units or shapes disagree.
    """
    return _Checker(table).type_of(node)


def expect(node: Node, table: SymbolTable, wanted: Type) -> None:
    """Check that an expression has the wanted shape and dimension.

    Raises:
        SpecFault: it has not.
    """
    found = infer(node, table)
    if found.shape != wanted.shape:
        raise SpecFault(
            Code.SHAPE_MISMATCH,
            f"'{plain(node)}' is {found}, {wanted} is wanted. Correct it",
            node.offset,
        )
    if found.dimension not in (None, wanted.dimension):
        raise SpecFault(
            Code.UNIT_MISMATCH,
            f"'{plain(node)}' is {found}, {wanted} is wanted. Correct it",
            node.offset,
        )


def refuse_not_stated(node: Node) -> None:
    """Refuse functions that no law and no equation of a scene may use.

    Raises:
        SpecFault: there is one; says where.
    """
    for part in ex.walk(node):
        if isinstance(part, ex.Call) and (why := _NOT_STATED.get(part.function)):
            raise SpecFault(Code.NOT_ALLOWED, f"'{part.function}' {why}", part.offset)


class _Checker:
    def __init__(self, table: SymbolTable) -> None:
        self.table = table

    def type_of(self, node: Node) -> Type:
        """The type of any node: one case for each kind of it."""
        match node:
            case ex.Number(value=value):
                return Type("scalar", None if value == 0 else ONE)
            case ex.Measure(unit=unit):
                return Type("scalar", unit.dimension)
            case ex.Name(name="pi"):
                return Type("scalar")
            case ex.Name(name=name):
                symbol = self.table.resolve(name, node.offset).symbol
                return Type(symbol.shape, symbol.dimension)
            case ex.Negative(operand=operand):
                return self.value(operand)
            case ex.Binary(operator="+" | "-" as operator, left=left, right=right):
                return self.alike(node, left, right, "add" if operator == "+" else "subtract")
            case ex.Binary():
                return self.product(node)
            case ex.Power(base=base, exponent=exponent):
                dimension = self.scalar(base).dimension
                return Type("scalar", dimension and dimension**exponent)
            case ex.Relation(operator=operator, left=left, right=right):
                return self.relation(node, operator, left, right)
            case ex.Both(parts=conditions):
                return self.both(conditions)
            case ex.Call():
                return self.call(node)
        raise TypeError(node)

    def value(self, node: Node) -> Type:
        found = self.type_of(node)
        if found.shape == "truth":
            raise SpecFault(
                Code.SHAPE_MISMATCH,
                f"'{plain(node)}' is a condition, a value is wanted. Correct it",
                node.offset,
            )
        return found

    def scalar(self, node: Node) -> Type:
        return self.shaped(node, "scalar")

    def vector(self, node: Node) -> Type:
        return self.shaped(node, "vector")

    def shaped(self, node: Node, shape: Kind) -> Type:
        found = self.value(node)
        if found.shape != shape:
            raise SpecFault(
                Code.SHAPE_MISMATCH,
                f"'{plain(node)}' is {found}, a {shape} is wanted. Correct it",
                node.offset,
            )
        return found

    def pure(self, node: Node) -> Type:
        found = self.scalar(node)
        if found.dimension not in (None, ONE):
            raise SpecFault(
                Code.UNIT_MISMATCH,
                f"'{plain(node)}' is {found}, a pure number is wanted. Divide by its unit",
                node.offset,
            )
        return Type("scalar")

    def alike(self, node: Node, left: Node, right: Node, verb: str) -> Type:
        a, b = self.value(left), self.value(right)
        text = f"cannot {verb}: '{plain(left)}' is {a}, '{plain(right)}' is {b}. Correct one side"
        if any(one.shape == "scalar" and one.dimension for one in (a, b)) and a.shape != b.shape:
            raise SpecFault(Code.SHAPE_MISMATCH, text, node.offset)
        if None not in (a.dimension, b.dimension) and a.dimension != b.dimension:
            raise SpecFault(Code.UNIT_MISMATCH, text, node.offset)
        shape: Kind = "scalar" if a.shape == b.shape == "scalar" else "vector"
        return Type(shape, a.dimension or b.dimension)

    def product(self, node: ex.Binary) -> Type:
        a, b = self.value(node.left), self.value(node.right)
        if b.shape == "vector" and (a.shape == "vector" or node.operator == "/"):
            text = f"'{plain(node)}' combines {a} and {b}. Use dot or cross, and divide by scalars"
            raise SpecFault(Code.SHAPE_MISMATCH, text, node.offset)
        shape: Kind = "vector" if "vector" in (a.shape, b.shape) else "scalar"
        if a.dimension is None or b.dimension is None:
            return Type(shape, None)
        times = node.operator == "*"
        return Type(shape, a.dimension * b.dimension if times else a.dimension / b.dimension)

    def relation(self, node: Node, operator: str, left: Node, right: Node) -> Type:
        found = self.alike(node, left, right, "compare")
        if operator != "==" and found.shape == "vector":
            raise SpecFault(
                Code.SHAPE_MISMATCH,
                f"'{plain(node)}' orders vectors. Compare their norms",
                node.offset,
            )
        return TRUTH

    def both(self, conditions: tuple[Node, ...]) -> Type:
        for condition in conditions:
            if self.type_of(condition) != TRUTH:
                raise SpecFault(
                    Code.SHAPE_MISMATCH,
                    f"'{plain(condition)}' is a value, a condition is wanted. Compare it",
                    condition.offset,
                )
        return TRUTH

    def call(self, node: ex.Call) -> Type:
        """The type of a function of the language."""
        first, *rest = node.arguments
        match node.function:
            case "sin" | "cos" | "tan" | "exp" | "log" | "phi1" | "phi2":
                return self.pure(first)
            case "sqrt":
                dimension = self.scalar(first).dimension
                return Type("scalar", dimension and dimension ** Fraction(1, 2))
            case "abs":
                return self.scalar(first)
            case "min" | "max" | "atan2":
                self.scalar(first)
                self.scalar(rest[0])
                found = self.alike(node, first, rest[0], "compare")
                return Type("scalar") if node.function == "atan2" else found
            case "norm" | "x" | "y":
                return Type("scalar", self.vector(first).dimension)
            case "perp":
                return self.vector(first)
            case "rotate":
                self.pure(rest[0])
                return self.vector(first)
            case "vector":
                self.scalar(first)
                self.scalar(rest[0])
                return Type("vector", self.alike(node, first, rest[0], "pair").dimension)
            case "sum":
                return self.value(first)
        return self.two(node.function, first, rest[0])

    def two(self, function: str, first: Node, second: Node) -> Type:
        """The type of a derivative, an integral or a product of vectors."""
        a, b = self.value(first), self.value(second)
        over = a.dimension and b.dimension
        match function:
            case "d":
                self.scalar(second)
                return Type(a.shape, over and a.dimension / b.dimension)  # type: ignore[operator]
            case "integral":
                self.scalar(second)
                return Type(a.shape, over and a.dimension * b.dimension)  # type: ignore[operator]
            case "dot":
                self.vector(first)
        self.vector(second)
        shape: Kind = "vector" if a.shape == "scalar" else "scalar"
        return Type(shape, over and a.dimension * b.dimension)  # type: ignore[operator]
