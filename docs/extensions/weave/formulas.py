"""Formal parts of an item as formulas: equations, derivation steps, closed forms.

Serves: the pages of items. Hides: the language of the specification, its TeX, and where a
formula that is too wide for the page is broken.
"""

import re
from collections.abc import Iterable, Iterator
from fractions import Fraction

from tamias2d.spec.chapter import Item
from tamias2d.spec.expression import Binary, Both, Node, Number, Relation, names, parse
from tamias2d.spec.messages import SpecFault
from tamias2d.spec.tex import tex
from weave.woven import Woven

WIDTH = 60  # letters that fit beside each other, about
_MARKUP = re.compile(r"\\(?:left|right|mathrm|boldsymbol|tfrac|[,;])|[{}\\^_ ]")
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
    for term in _terms(node, woven):
        if line and _length(line + term) > WIDTH:
            yield line
            line = ""
        line += f" {term}"
    yield line


def _terms(node: Node, woven: Woven) -> Iterator[str]:
    if isinstance(node, Binary) and node.operator in "+-":
        yield from _terms(node.left, woven)
        # Printed as the right side of a sum, so that the printer sets the brackets.
        both = tex(Binary(node.operator, Number(Fraction(0)), node.right), woven.spec.table)
        yield both.removeprefix("0").strip()
    else:
        yield tex(node, woven.spec.table)


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
    for step in data.get("derivation", []):
        yield step["equation"]
