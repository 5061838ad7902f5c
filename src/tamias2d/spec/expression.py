"""Expressions of the specification language, read into a tree.

Serves: equations, closed forms, oracles and forces that depend on time. Hides: that Python's
own parser does the first reading. Nothing is ever evaluated by Python: the syntax tree is
walked with a list of what is allowed, and all else is refused with its place.
"""

import ast
import re
import warnings
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from itertools import pairwise

from tamias2d.spec.messages import Code, SpecFault, excerpt
from tamias2d.spec.units import Unit, parse_unit

MAX_LENGTH = 1000
MAX_DEPTH = 40
MAX_POWER = 16
MAX_DIGITS = 40

ARITY = {
    "d": 2, "integral": 2, "dot": 2, "cross": 2, "perp": 1, "norm": 1, "vector": 2, "x": 1, "y": 1,
    "sqrt": 1, "sin": 1, "cos": 1, "tan": 1, "exp": 1, "log": 1, "abs": 1, "min": 2, "max": 2,
    "atan2": 2, "sum": 1, "phi1": 1, "phi2": 1, "rotate": 2,
}  # fmt: skip
_OPERATORS = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/"}
_RELATIONS = {ast.Eq: "==", ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">="}
_NUMBER = re.compile(r"([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]{1,3})?")
_TOKEN = re.compile(rf"{_NUMBER.pattern}|\w+|\S")
_OPERAND = re.compile(r"(?!and$)\.?\w[\w.]*")


@dataclass(frozen=True)
class Node:
    """A part of an expression; `offset` is its place in the text."""

    offset: int = field(default=0, compare=False, kw_only=True)


@dataclass(frozen=True)
class Number(Node):
    """A pure number, kept as an exact fraction."""

    value: Fraction

    @cached_property
    def number(self) -> float:
        """The nearest float."""
        return float(self.value)


@dataclass(frozen=True)
class Measure(Node):
    """A number with a unit, `9.81[m/s^2]`."""

    value: Fraction
    unit: Unit

    @cached_property
    def number(self) -> float:
        """The value in SI units."""
        return float(self.value) * self.unit.factor


@dataclass(frozen=True)
class Name(Node):
    """A symbol, perhaps with indices."""

    name: str


@dataclass(frozen=True)
class Negative(Node):
    """The operand with its sign changed."""

    operand: Node


@dataclass(frozen=True)
class Binary(Node):
    """A sum, difference, product or quotient."""

    operator: str
    left: Node
    right: Node


@dataclass(frozen=True)
class Power(Node):
    """A base to a whole or half power."""

    base: Node
    exponent: Fraction


@dataclass(frozen=True)
class Call(Node):
    """One of the language's functions."""

    function: str
    arguments: tuple[Node, ...]


@dataclass(frozen=True)
class Relation(Node):
    """An equation or a comparison."""

    operator: str
    left: Node
    right: Node


@dataclass(frozen=True)
class Both(Node):
    """Conditions that hold together."""

    parts: tuple[Node, ...]


def parse(text: str) -> Node:
    """Read an expression.

    Raises:
        SpecFault: the text is not in the language; the fault has the offset of the place.
    """
    source = text.strip()
    lead = len(text) - len(text.lstrip())
    if len(source) > MAX_LENGTH:
        raise SpecFault(Code.TOO_LARGE, f"an expression may have {MAX_LENGTH} characters. Split it")
    if not source.isascii():
        place = next(k for k, letter in enumerate(source) if not letter.isascii())
        raise SpecFault(
            Code.NOT_ALLOWED,
            f"'{source[place]}' is not ASCII. Write names as words, digits as 0 to 9",
            lead + place,
        )
    if "#" in source:
        raise SpecFault(
            Code.NOT_ALLOWED, "an expression has no comments. Remove '#'", lead + source.index("#")
        )
    source = re.sub(r"\s", " ", source)
    tree = _python_tree(source, lead)
    return _Reader(source, lead).read(tree, 0)


def _python_tree(source: str, lead: int) -> ast.expr:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return ast.parse(source, mode="eval").body
    except SyntaxError as error:
        reason, place = "Correct the expression", max((error.offset or 1) - 1, 0)
        if factors := _factors(source):
            first, second = factors
            reason = f"Nothing is between '{first.group()}' and '{second.group()}'. Write '*'"
            place = second.start()
        raise SpecFault(
            Code.SYNTAX, f"'{excerpt(source)}' cannot be read here. {reason}", lead + place
        ) from None
    except (ValueError, RecursionError, MemoryError):
        raise SpecFault(
            Code.SYNTAX, f"'{excerpt(source)}' cannot be read. Correct the expression", lead
        ) from None


def _factors(source: str) -> tuple[re.Match[str], re.Match[str]] | None:
    """The first two operands without an operator between them: a product as people write it."""
    for first, second in pairwise(_TOKEN.finditer(source)):
        ends = first.group() in (")", "]") or _OPERAND.fullmatch(first.group())
        if ends and _OPERAND.fullmatch(second.group()):
            return first, second
    return None


class _Reader:
    """Walks Python's syntax tree and keeps only what the language has."""

    def __init__(self, source: str, lead: int) -> None:
        self.source = source
        self.lead = lead

    def text(self, node: ast.expr) -> str:
        return self.source[node.col_offset : node.end_col_offset]

    def refuse(self, node: ast.expr, why: str = "is not allowed in an expression") -> SpecFault:
        return SpecFault(
            Code.NOT_ALLOWED, f"'{self.text(node)}' {why}. Rewrite it", self.lead + node.col_offset
        )

    def refuse_caret(self, place: int) -> SpecFault:
        text = "'^' is for units alone: an expression has '**' for powers. Write '**'"
        return SpecFault(Code.NOT_ALLOWED, text, self.lead + place)

    def read(self, node: ast.expr, depth: int) -> Node:
        """Our node for one of Python's; what is not in this list is refused."""
        if depth > MAX_DEPTH:
            raise SpecFault(
                Code.TOO_LARGE, f"an expression may nest {MAX_DEPTH} deep. Name a part of it"
            )
        at = self.lead + node.col_offset
        match node:
            case ast.Name(id=name):
                return Name(name, offset=at)
            case ast.Constant():
                return Number(self.number(node), offset=at)
            case ast.Subscript(value=ast.Constant() as value, slice=unit):
                return Measure(self.number(value), self.unit(unit), offset=at)
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return Negative(self.read(operand, depth + 1), offset=at)
            case ast.UnaryOp(op=ast.UAdd(), operand=operand):
                return self.read(operand, depth + 1)
            case ast.BinOp(op=ast.Pow(), left=base, right=exponent):
                return Power(self.read(base, depth + 1), self.exponent(exponent, depth), offset=at)
            case ast.BinOp(op=ast.BitXor(), left=left):
                raise self.refuse_caret(self.source.index("^", left.end_col_offset))
            case ast.BinOp(op=op, left=left, right=right) if type(op) in _OPERATORS:
                sides = self.read(left, depth + 1), self.read(right, depth + 1)
                return Binary(_OPERATORS[type(op)], *sides, offset=at)
            case ast.Compare(ops=[op], left=left, comparators=[right]) if type(op) in _RELATIONS:
                sides = self.read(left, depth + 1), self.read(right, depth + 1)
                return Relation(_RELATIONS[type(op)], *sides, offset=at)
            case ast.BoolOp(op=ast.And(), values=values):
                return Both(tuple(self.read(value, depth + 1) for value in values), offset=at)
            case ast.Call(func=ast.Name(id=name), args=arguments, keywords=[]) if name in ARITY:
                return self.call(node, name, arguments, depth)
            case ast.Call(func=ast.Constant() | ast.BinOp() | ast.Call()):
                raise self.refuse(node, "calls what is no function: products need '*'")
        raise self.refuse(node)

    def call(self, node: ast.expr, name: str, arguments: list[ast.expr], depth: int) -> Call:
        if len(arguments) != ARITY[name]:
            raise self.refuse(node, f"has {len(arguments)} arguments, {name} takes {ARITY[name]}")
        read = tuple(self.read(argument, depth + 1) for argument in arguments)
        return Call(name, read, offset=self.lead + node.col_offset)

    def number(self, node: ast.Constant) -> Fraction:
        text = self.text(node)
        if not _NUMBER.fullmatch(text):
            raise self.refuse(node, "is not a decimal number")
        if len(text) > MAX_DIGITS or not _fits_float64(value := Fraction(text)):
            raise SpecFault(
                Code.TOO_LARGE,
                f"'{excerpt(text)}' does not fit float64. Give a number that does",
                self.lead + node.col_offset,
            )
        return value

    def unit(self, node: ast.expr) -> Unit:
        try:
            return parse_unit(self.text(node))
        except SpecFault as fault:
            fault.offset += self.lead + node.col_offset
            raise

    def exponent(self, node: ast.expr, depth: int) -> Fraction:
        value = _constant(self.read(node, depth + 1))
        if value is None or value.denominator > 2 or abs(value) > MAX_POWER:
            raise self.refuse(node, f"is no exponent: whole or half powers up to {MAX_POWER} are")
        return value


def _fits_float64(value: Fraction) -> bool:
    return value == 0 or Fraction(10) ** -300 < value < Fraction(10) ** 300


def _constant(node: Node) -> Fraction | None:
    match node:
        case Number(value=value):
            return value
        case Negative(operand=Number(value=value)):
            return -value
        case Binary(operator="/", left=Number(value=above), right=Number(value=below)) if below:
            return above / below
    return None


def parts(node: Node) -> tuple[Node, ...]:
    """The direct parts of a node."""
    match node:
        case Negative(operand=operand):
            return (operand,)
        case Binary(left=left, right=right) | Relation(left=left, right=right):
            return (left, right)
        case Power(base=base):
            return (base,)
        case Call(arguments=arguments):
            return arguments
        case Both(parts=conditions):
            return conditions
    return ()


def rebuilt(node: Node, change: Callable[[Node], Node | None]) -> Node:
    """The tree with each outermost node for which `change` gives another one replaced."""
    changed = change(node)
    if changed is not None:
        return changed
    match node:
        case Negative(operand=operand):
            return replace(node, operand=rebuilt(operand, change))
        case Binary(left=left, right=right) | Relation(left=left, right=right):
            return replace(node, left=rebuilt(left, change), right=rebuilt(right, change))
        case Power(base=base):
            return replace(node, base=rebuilt(base, change))
        case Call(arguments=arguments):
            return replace(node, arguments=tuple(rebuilt(part, change) for part in arguments))
        case Both(parts=conditions):
            return replace(node, parts=tuple(rebuilt(part, change) for part in conditions))
    return node


def substituted(node: Node, values: Mapping[str, Node]) -> Node:
    """The tree with some names replaced by trees."""
    return rebuilt(node, lambda part: values.get(part.name) if isinstance(part, Name) else None)


def walk(node: Node) -> Iterator[Node]:
    """The node and all nodes below it, in reading order."""
    yield node
    for part in parts(node):
        yield from walk(part)


def names(node: Node) -> tuple[str, ...]:
    """The names in an expression, each once, in reading order; `pi` is a number."""
    found = (part.name for part in walk(node) if isinstance(part, Name))
    return tuple(dict.fromkeys(name for name in found if name != "pi"))
