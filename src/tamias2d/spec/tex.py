r"""Expressions as TeX for the docs, and as plain text for messages.

Serves: docs and diagnostics. Hides: brackets by precedence and the symbols' letters.
"""

import re
from decimal import Decimal
from fractions import Fraction

from tamias2d.spec import expression as ex
from tamias2d.spec.expression import Node
from tamias2d.spec.symbols import SymbolTable

_SIGNS = {"==": "=", "<": "<", "<=": r"\le", ">": ">", ">=": r"\ge"}
_CALLS = {
    "d": r"\frac{{\mathrm{{d}}{0}}}{{\mathrm{{d}}{1}}}",
    "integral": r"\int {0}\,\mathrm{{d}}{1}",
    "dot": r"{0} \cdot {1}",
    "cross": r"{0} \times {1}",
    "perp": r"{0}^{{\perp}}",
    "rotate": r"\mathbf{{R}}\left({1}\right) {0}",
    "norm": r"\left\lVert {0} \right\rVert",
    "vector": r"\left({0},\; {1}\right)",
    "x": r"\left({0}\right)_x",
    "y": r"\left({0}\right)_y",
    "sqrt": r"\sqrt{{{0}}}",
    "abs": r"\left| {0} \right|",
    "min": r"\min\left({0}, {1}\right)",
    "max": r"\max\left({0}, {1}\right)",
    "atan2": r"\operatorname{{atan2}}\left({0}, {1}\right)",
    "sum": r"\sum {0}",
    "phi1": r"\phi_1\left({0}\right)",
    "phi2": r"\phi_2\left({0}\right)",
}
_BARE = (
    "norm",
    "abs",
    "sqrt",
    "vector",
    "min",
    "max",
    "atan2",
    "x",
    "y",
    "phi1",
    "phi2",
)  # own brackets


def plain(node: Node) -> str:
    """The expression as text, much as it was written."""
    match node:
        case ex.Number(value=value):
            return _number(value)
        case ex.Measure(value=value, unit=unit):
            return f"{_number(value)}[{unit.text}]"
        case ex.Name(name=name):
            return name
        case ex.Negative(operand=operand):
            return f"-{_grouped(operand)}"
        case ex.Binary(operator=operator, left=left, right=right):
            tight = operator in "*/"
            sides = (_factor(left), _grouped(right)) if tight else (plain(left), _after(right))
            return (
                f"{sides[0]}{operator}{sides[1]}" if tight else f"{sides[0]} {operator} {sides[1]}"
            )
        case ex.Power(base=base, exponent=exponent):
            inner = f"({plain(base)})" if isinstance(base, ex.Power) else _grouped(base)
            return f"{inner}**{_number(exponent)}"
        case ex.Relation(operator=operator, left=left, right=right):
            return f"{plain(left)} {operator} {plain(right)}"
        case ex.Both(parts=conditions):
            return " and ".join(plain(condition) for condition in conditions)
        case ex.Call(function=function, arguments=arguments):
            return f"{function}({', '.join(plain(argument) for argument in arguments)})"
    raise TypeError(node)


def _factor(node: Node) -> str:
    leads = isinstance(node, ex.Negative) or (isinstance(node, ex.Binary) and node.operator in "*/")
    return plain(node) if leads else _grouped(node)


def _grouped(node: Node) -> str:
    return f"({plain(node)})" if isinstance(node, ex.Binary | ex.Negative) else plain(node)


def _after(node: Node) -> str:
    loose = isinstance(node, ex.Binary) and node.operator in "+-"
    return f"({plain(node)})" if loose else plain(node)


def _number(value: Fraction) -> str:
    if value.denominator == 1:
        return str(value.numerator)
    if Fraction(text := str(float(value))) == value:
        return text
    decimal = str(Decimal(value.numerator) / value.denominator)
    return decimal if Fraction(decimal) == value else f"({value})"


def tex(node: Node, table: SymbolTable) -> str:
    """The expression as TeX, with the letters that the symbols declare."""
    return _Printer(table).print(node)


def factor(node: Node, table: SymbolTable) -> str:
    """The expression as TeX, in brackets if it needs them as a factor of a product."""
    return _Printer(table).factor(node)


class _Printer:
    def __init__(self, table: SymbolTable) -> None:
        self.table = table

    def print(self, node: Node) -> str:
        """The TeX of any node: one case for each kind of it."""
        match node:
            case ex.Number(value=value):
                return self.number(value)
            case ex.Measure(value=value, unit=unit):
                return rf"{self.number(value)}\,\mathrm{{{unit_tex(unit.text)}}}"
            case ex.Name(name=name):
                return r"\pi" if name == "pi" else self.name(name)
            case ex.Negative(operand=operand):
                return f"-{self.factor(operand)}"
            case ex.Binary():
                return self.binary(node)
            case ex.Power(base=base, exponent=exponent):
                if exponent == Fraction(1, 2):
                    return rf"\sqrt{{{self.print(base)}}}"
                inner = (
                    self.bracket(base)
                    if isinstance(base, ex.Binary | ex.Negative | ex.Power | ex.Call | ex.Measure)
                    else self.print(base)
                )
                return f"{{{inner}}}^{{{exponent}}}"
            case ex.Relation(operator=operator, left=left, right=right):
                return f"{self.print(left)} {_SIGNS[operator]} {self.print(right)}"
            case ex.Both(parts=conditions):
                return r" \;\land\; ".join(self.print(condition) for condition in conditions)
            case ex.Call():
                return self.call(node)
        raise TypeError(node)

    def name(self, name: str) -> str:
        """A symbol's letter with its indices below and above."""
        reference = self.table.resolve(name)
        letter = reference.symbol.tex or rf"\mathrm{{{name}}}"
        below = ",".join(index.tex for index in reference.indices if index.place == "sub")
        above = ",".join(index.tex for index in reference.indices if index.place == "super")
        if not (below or above):
            return letter
        stem, _, power = letter.partition("^")
        if below and power and not above:  # the power stays outermost: m_A^{-1}
            return f"{stem}_{{{below}}}^{power}"
        clash = (below and "_" in letter) or (above and power)
        base = f"{{{letter}}}" if clash else letter
        return base + (f"_{{{below}}}" if below else "") + (f"^{{{above}}}" if above else "")

    def number(self, value: Fraction) -> str:
        if value.denominator == 1:
            return str(value.numerator)
        text = _number(value)
        if text[0] == "(":
            return rf"\tfrac{{{value.numerator}}}{{{value.denominator}}}"
        digits, _, power = text.partition("e")
        factor = "" if digits == "1" else rf"{digits} \cdot "
        return rf"{factor}10^{{{int(power)}}}" if power else text

    def binary(self, node: ex.Binary) -> str:
        """Return a quotient, product, sum or difference, with brackets where they are needed."""
        if node.operator == "/":
            return rf"\frac{{{self.print(node.left)}}}{{{self.print(node.right)}}}"
        if node.operator == "*":
            left = (
                self.print(node.left)
                if isinstance(node.left, ex.Negative)
                else self.factor(node.left)
            )
            right = self.factor(node.right)
            return (
                rf"{left} \, {right}"
                if not _ends_in_number(node.right)
                else rf"{left} \cdot {right}"
            )
        right = (
            self.bracket(node.right)
            if _is_sum(node.right) and node.operator == "-"
            else self.print(node.right)
        )
        return f"{self.print(node.left)} {node.operator} {right}"

    def factor(self, node: Node) -> str:
        loose = _is_sum(node) or isinstance(node, ex.Negative)
        product = isinstance(node, ex.Call) and node.function in ("dot", "cross", "sum", "integral")
        return self.bracket(node) if loose or product else self.print(node)

    def bracket(self, node: Node) -> str:
        return rf"\left({self.print(node)}\right)"

    def call(self, node: ex.Call) -> str:
        pattern = _CALLS.get(node.function)
        if pattern is None:
            return rf"\{node.function}\left({self.print(node.arguments[0])}\right)"
        bare = node.function in _BARE
        inner = (
            self.print(part)
            if bare or not isinstance(part, ex.Binary)
            else self._operand(node, part)
            for part in node.arguments
        )
        return pattern.format(*inner)

    def _operand(self, call: ex.Call, part: ex.Binary) -> str:
        fits = call.function in ("sum", "integral") and part.operator in "*/"
        return self.print(part) if fits else self.bracket(part)


def _is_sum(node: Node) -> bool:
    return isinstance(node, ex.Binary) and node.operator in "+-"


def _ends_in_number(node: Node) -> bool:
    first = node.left if isinstance(node, ex.Binary) else node
    return isinstance(first, ex.Number | ex.Measure)


def unit_tex(text: str) -> str:
    """A unit as TeX inside an upright font."""
    powers = re.sub(r"(?:\^|\*\*)(-?\d+)", r"^{\1}", text)
    return powers.replace("*", r"\,")


def has_balanced_braces(text: str) -> bool:
    r"""Whether each brace of TeX has its partner; ``\{`` and ``\}`` are letters."""
    depth = 0
    for sign in re.findall(r"\\.|[{}]", text):
        depth += {"{": 1, "}": -1}.get(sign, 0)
        if depth < 0:
            return False
    return depth == 0
