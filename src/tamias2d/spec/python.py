"""Expressions as Python source, component by component.

Serves: the generator. Hides: how vectors become pairs, and that whole powers become products,
because `**` rounds differently in compiled code.
"""

from fractions import Fraction

from tamias2d.spec import expression as ex
from tamias2d.spec.check import infer
from tamias2d.spec.expression import Node
from tamias2d.spec.symbols import SymbolTable

_HELPERS = {
    "sqrt": "sqrt", "sin": "sin", "cos": "cos", "tan": "tan", "exp": "exp", "log": "log",
    "atan2": "atan2", "min": "least", "max": "largest", "sum": "total",
}  # fmt: skip


class PythonPrinter:
    """Prints expressions and remembers which helper functions they call."""

    def __init__(self, table: SymbolTable) -> None:
        self.table = table
        self.helpers: set[str] = set()

    def is_vector(self, node: Node) -> bool:
        """Whether the expression is a vector."""
        return infer(node, self.table).shape == "vector"

    def value(self, node: Node) -> str:
        """Source of the whole value: a pair for a vector."""
        if self.is_vector(node):
            return f"({self.component(node, 'x')}, {self.component(node, 'y')})"
        return self.scalar(node)

    def component(self, node: Node, axis: str) -> str:
        """Source of one component of a vector."""
        match node:
            case ex.Name(name=name):
                return f"{name}_{axis}"
            case ex.Negative(operand=operand):
                return f"-{self.tight(operand, axis)}"
            case ex.Binary(operator="+" | "-" as operator, left=left, right=right):
                return self.part(left, axis) + self.added(operator, right, axis)
            case ex.Binary(operator=operator, left=left, right=right):
                return f"{self.tight(left, axis)} {operator} {self.tight(right, axis, operator)}"
            case ex.Call(function="vector", arguments=arguments):
                return self.scalar(arguments["xy".index(axis)])
            case ex.Call(function="perp", arguments=(inner,)):
                return f"-{self.tight(inner, 'y')}" if axis == "x" else self.component(inner, "x")
            case ex.Call(function="cross", arguments=(turn, arm)):
                other = self.tight(arm, "y" if axis == "x" else "x")
                return f"{'-' if axis == 'x' else ''}{self.tight(turn)} * {other}"
            case ex.Call(function="rotate", arguments=(arm, angle)):
                return self.rotated(arm, self.scalar(angle), axis)
            case ex.Call(function="sum", arguments=(inner,)):
                return self.helper("sum", self.component(inner, axis))
        raise TypeError(node)

    def rotated(self, arm: Node, angle: str, axis: str) -> str:
        """Source of one component of a vector turned by an angle."""
        cosine, sine = self.helper("cos", angle), self.helper("sin", angle)
        x, y = self.tight(arm, "x"), self.tight(arm, "y")
        return f"{cosine} * {x} - {sine} * {y}" if axis == "x" else f"{sine} * {x} + {cosine} * {y}"

    def scalar(self, node: Node) -> str:
        """Source of a scalar or a condition."""
        match node:
            case ex.Number(value=value):
                return number(value)
            case ex.Measure(value=value, unit=unit):
                return repr(float(value) * unit.factor)
            case ex.Name(name=name):
                self.helpers |= {"pi"} & {name}
                return name
            case ex.Negative(operand=operand):
                return f"-{self.tight(operand)}"
            case ex.Binary(operator="+" | "-" as operator, left=left, right=right):
                return self.part(left) + self.added(operator, right)
            case ex.Binary(operator=operator, left=left, right=right):
                return f"{self.tight(left)} {operator} {self.tight(right, '', operator)}"
            case ex.Power(base=base, exponent=exponent):
                return self.power(base, exponent)
            case ex.Relation(operator=operator, left=left, right=right):
                return f"{self.scalar(left)} {operator} {self.scalar(right)}"
            case ex.Both(parts=conditions):
                return " & ".join(f"({self.scalar(condition)})" for condition in conditions)
            case ex.Call(function=function, arguments=arguments):
                return self.call(function, arguments)
        raise TypeError(node)

    def part(self, node: Node, axis: str = "") -> str:
        """Source of one component, or of a scalar that stands beside vectors."""
        scalar = not axis or not self.is_vector(node)
        return self.scalar(node) if scalar else self.component(node, axis)

    def added(self, operator: str, node: Node, axis: str = "") -> str:
        """Source of a further term with its sign; a minus of its own joins with the sign."""
        node, axis = entry(node, axis)
        text = self.part(node, axis)
        if text.startswith("-") and not self.is_sum(node):
            return f" {'-' if operator == '+' else '+'} {text[1:]}"
        return (
            f" {operator} ({text})"
            if operator == "-" and self.is_sum(node)
            else f" {operator} {text}"
        )

    def tight(self, node: Node, axis: str = "", operator: str = "*") -> str:
        """Source of a factor, in brackets where it needs them."""
        node, axis = entry(node, axis)
        text = self.part(node, axis)
        chain = isinstance(node, ex.Binary) and node.operator in "*/" and operator == "/"
        powers = isinstance(node, ex.Power) and operator == "/" and " " in text
        turned = isinstance(node, ex.Call) and node.function in ("cross", "perp") and bool(axis)
        loose = self.is_sum(node) or isinstance(node, ex.Negative) or turned
        return f"({text})" if loose or chain or powers else text

    def is_sum(self, node: Node) -> bool:
        """Whether the source is a sum; scalar products and turned vectors are printed as sums."""
        if isinstance(node, ex.Call) and node.function == "rotate":
            return True
        if isinstance(node, ex.Call) and node.function in ("dot", "cross"):
            return not self.is_vector(node)
        return isinstance(node, ex.Binary) and node.operator in "+-"

    def power(self, base: Node, exponent: Fraction) -> str:
        """Source of a power, as products."""
        count = abs(exponent.numerator)
        if not count:
            return "1.0"
        if isinstance(base, ex.Name) and count <= 3:
            whole = " * ".join([base.name] * count)
        else:
            whole = self.helper("power", f"{self.scalar(base)}, {count}")
        if exponent.denominator == 2:
            whole = self.helper("sqrt", whole)
        return f"(1 / ({whole}))" if exponent < 0 else whole

    def helper(self, function: str, inner: str) -> str:
        """Source of a call of a helper function, which is remembered."""
        name = _HELPERS.get(function, function)
        self.helpers.add(name)
        return f"{name}({inner})"

    def call(self, function: str, arguments: tuple[Node, ...]) -> str:
        """Source of a function of the language with a scalar value."""
        match function, arguments:
            case "dot", (a, b):
                terms = (f"{self.tight(a, axis)} * {self.tight(b, axis)}" for axis in "xy")
                return " + ".join(terms)
            case "cross", (a, b):
                first, second = (
                    (self.tight(a, "x"), self.tight(b, "y")),
                    (self.tight(a, "y"), self.tight(b, "x")),
                )
                return f"{' * '.join(first)} - {' * '.join(second)}"
            case "norm", (a,):
                squares = (f"{self.tight(a, axis)} * {self.tight(a, axis)}" for axis in "xy")
                return self.helper("sqrt", " + ".join(squares))
            case (("x" | "y"), (a,)):
                return self.tight(a, function)
            case "abs", (a,):
                return f"abs({self.scalar(a)})"
        return self.helper(function, ", ".join(self.scalar(argument) for argument in arguments))


def entry(node: Node, axis: str) -> tuple[Node, str]:
    """The scalar that stands for an axis of a vector of entries; else what is given."""
    if axis and isinstance(node, ex.Call) and node.function == "vector":
        return node.arguments["xy".index(axis)], ""
    return node, axis


def number(value: Fraction) -> str:
    """A rational as source: whole numbers stay whole, others are the nearest float."""
    return str(value.numerator) if value.denominator == 1 else repr(float(value))
