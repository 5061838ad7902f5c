"""Formal parts of an item as formulas: equations, derivation steps, closed forms.

Serves: the pages of items. Hides: the language of the specification, its TeX, and where a
formula that is too wide for the page is broken.
"""

import re
from collections.abc import Iterable, Iterator

from tamias2d.spec.chapter import Item
from tamias2d.spec.expression import Binary, Both, Call, Negative, Node, Relation, names, parse
from tamias2d.spec.messages import SpecFault
from tamias2d.spec.symbols import SymbolTable
from tamias2d.spec.tex import factor, tex
from weave.woven import Woven

WIDTH = 56  # letters that fit beside each other, about
_PRODUCTS = {"dot": "cdot", "cross": "times"}
_MARKUP = re.compile(r"\\(?:left|right|mathrm|boldsymbol|tfrac|[Bb]ig[lr]|[,;])|[{}\\^_ ]")
_FRACTION = re.compile(r"\\frac\{((?:[^{}]|\{[^{}]*\})*)\}\{((?:[^{}]|\{[^{}]*\})*)\}")


def relation(woven: Woven, text: str) -> str:
    """An equation `left == right` of the specification, aligned at its sign."""
    node = parse(text)
    if isinstance(node, Relation) and node.operator == "==":
        left = r" \\ & \quad ".join(_lines(node.left, woven))
        return _aligned(left, "=", node.right, woven)
    return f"& {tex(node, woven.spec.table)}"


def equation(woven: Woven, name: str, text: str) -> str:
    """`name = expression`, or `name if and only if condition`, aligned at its sign."""
    node = parse(text)
    left = woven.letter(name)
    if isinstance(node, Relation):
        return rf"{left} & \iff {tex(node, woven.spec.table)}"
    if isinstance(node, Both):
        parts = [tex(part, woven.spec.table) for part in node.parts]
        return rf"{left} & \iff " + r" \\ & \;\;\land\;\; ".join(parts)
    return _aligned(left, "=", node, woven)


def rate(woven: Woven, state: str, text: str) -> str:
    """The equation of a state's rate of change."""
    return relation(woven, f"d({state}, time) == {text}")


def stack(lines: Iterable[str]) -> str:
    """Aligned equations as one formula."""
    return r"\begin{aligned} " + r" \\[.6em] ".join(lines) + r" \end{aligned}"


def _aligned(left: str, sign: str, right: Node, woven: Woven) -> str:
    whole = tex(right, woven.spec.table)
    if _length(left) + _length(whole) <= WIDTH:
        return f"{left} & {sign} {whole}"
    lines = list(_lines(right, woven))
    if _length(left) > WIDTH / 3:  # the left side has a line of its own
        return r" \\ & ".join([f"& {left}", rf"\quad {sign} {lines[0]}", *lines[1:]])
    return f"{left} & {sign} " + r" \\ & \quad ".join(lines)


def _lines(node: Node, woven: Woven) -> Iterator[str]:
    line = ""
    for chunk in _chunks(node, woven.spec.table):
        if line and _length(line + chunk) > WIDTH:
            yield line
            line = ""
        line += f" {chunk}"
    yield line


def _chunks(node: Node, table: SymbolTable) -> list[str]:
    """The TeX of a node in pieces between which a line may end: one piece if it is short."""
    whole = tex(node, table)
    match node:
        case Binary(operator="+" | "-" as sign, left=left, right=right):
            return [*_chunks(left, table), *_ahead(f"{sign} ", _term(node, right, table))]
        case _ if _length(whole) <= WIDTH:
            return [whole]
        case Negative(operand=operand):
            return _ahead("-", _factors(operand, table))
        case Binary(operator="*", left=left, right=right):
            return _joined(_factors(left, table), r" \, ", _factors(right, table))
        case Binary(operator="/", left=left, right=right):
            inverse = rf"\frac{{1}}{{{tex(right, table)}}} \, "
            return _ahead(inverse, _in_brackets(_chunks(left, table)))
        case Call(function="dot" | "cross" as product, arguments=(left, right)):
            sign = rf" \{_PRODUCTS[product]} "
            return _joined(_factors(left, table), sign, _factors(right, table))
        case Call(function="vector", arguments=(x, y)):
            return _in_brackets(_joined(_chunks(x, table), ",", _chunks(y, table), apart=True))
    return [whole]


def _term(whole: Binary, right: Node, table: SymbolTable) -> list[str]:
    """The right side of a sum or a difference, in brackets if it is a sum that is taken away."""
    subtracted = whole.operator == "-" and isinstance(right, Binary) and right.operator in "+-"
    return _factors(right, table) if subtracted else _chunks(right, table)


def _factors(node: Node, table: SymbolTable) -> list[str]:
    """The pieces of a factor, in brackets if it needs them."""
    whole = factor(node, table)
    if _length(whole) <= WIDTH:
        return [whole]
    pieces = _chunks(node, table)
    return _in_brackets(pieces) if whole != tex(node, table) else pieces


def _in_brackets(pieces: list[str]) -> list[str]:
    *most, last = _ahead(r"\Bigl(", pieces)
    return [*most, rf"{last}\Bigr)"]


def _ahead(text: str, pieces: list[str]) -> list[str]:
    first, *others = pieces
    return [f"{text}{first}", *others]


def _joined(left: list[str], sign: str, right: list[str], *, apart: bool = False) -> list[str]:
    """Both sides with a sign between them, after which a line may end if they stand `apart`."""
    *most, last = left
    first, *others = right
    middle = [f"{last}{sign}", first] if apart else [f"{last}{sign}{first}"]
    return [*most, *middle, *others]


def _length(text: str) -> int:
    longest = _FRACTION.sub(lambda match: max(match.groups(), key=len), text)
    return len(_MARKUP.sub("", longest))


def named(item: Item) -> list[str]:
    """The names that an item's formal parts use, in order, each once."""
    found: dict[str, None] = {}
    for text in _texts(item):
        try:
            found |= dict.fromkeys(names(parse(text)))
        except SpecFault:
            continue
    return list(found)


def _texts(item: Item) -> Iterator[str]:
    data = item.data
    yield from filter(None, [data.get("equation")])
    for key in ("equations", "states", "closed_form"):
        for name, text in data.get(key, {}).items():
            if name != "when":
                yield from (name, text)
    yield from data.get("constraint", [])
    for step in data.get("derivation", []):
        yield step["equation"]
