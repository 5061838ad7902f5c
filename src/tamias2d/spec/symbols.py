"""The symbols of the specification: name, unit, shape and admissible range.

Serves: checks of expressions and of scene values (R4). Hides: how a name with indices
(`velocity_a_after`) finds its symbol.
"""

import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Literal

from tamias2d.spec.messages import Code, SpecFault
from tamias2d.spec.units import Dimension, parse_unit

Shape = Literal["scalar", "vector"]
_HALF_LINE = re.compile(r"(>=|>|<=|<)\s*(-?[0-9]+(?:\.[0-9]*)?(?:e-?[0-9]+)?)")
_INTERVAL = re.compile(r"([\[(])\s*(-?[^,]+?)\s*,\s*(-?[^,]+?)\s*([\])])")
_BOUND = re.compile(r"(-)?(?:([0-9]+\.?[0-9]*)\s*\*?\s*)?(pi)?")


@dataclass(frozen=True)
class Range:
    """The values that a symbol may take; its text is the rule."""

    text: str = ""
    low: float = -math.inf
    high: float = math.inf
    low_open: bool = True
    high_open: bool = True

    @cached_property
    def least(self) -> float:
        """The least finite value inside."""
        return math.nextafter(self.low, math.inf) if self.low_open else self.low

    @cached_property
    def most(self) -> float:
        """The greatest finite value inside."""
        return math.nextafter(self.high, -math.inf) if self.high_open else self.high

    def admits(self, value: float) -> bool:
        """Whether a finite value lies inside; NaN and infinities never do."""
        return self.least <= value <= self.most


def parse_range(text: str) -> Range:
    """Read `> 0`, `[0, 1]` or `[0, 2*pi)`.

    Raises:
        SpecFault: the text has neither form, or hardly a number lies inside.
    """
    limits = _range(text)
    if not limits.low < limits.high or math.inf in (limits.low, -limits.high):
        rule = "the first bound must be below the second, and finite. Correct them"
        raise SpecFault(Code.BAD_RANGE, f"no range of numbers is '{text}': {rule}")
    return limits


def _range(text: str) -> Range:
    if match := _HALF_LINE.fullmatch(text.strip()):
        sign, bound = match.group(1), float(match.group(2))
        if sign.startswith(">"):
            return Range(text, low=bound, low_open=sign == ">")
        return Range(text, high=bound, high_open=sign == "<")
    if match := _INTERVAL.fullmatch(text.strip()):
        left, low, high, right = match.groups()
        return Range(text, _bound(low), _bound(high), left == "(", right == ")")
    raise SpecFault(Code.BAD_RANGE, f"range '{text}' must be like '> 0' or '[0, 1]'. Write it so")


def _bound(text: str) -> float:
    match = _BOUND.fullmatch(text)
    if not match or not text:
        raise SpecFault(
            Code.BAD_RANGE, f"bound '{text}' must be a number or a multiple of pi. Write it so"
        )
    size = float(match.group(2) or 1) * (math.pi if match.group(3) else 1)
    return -size if match.group(1) else size


@dataclass(frozen=True)
class Symbol:
    """A physical quantity of the specification, as declared in srs/symbols.md."""

    name: str
    unit: str
    says: str
    shape: Shape = "scalar"
    range: Range = Range()
    tex: str = field(default="", compare=False)
    typical: str = field(default="", compare=False)
    uncertainty: str = field(default="", compare=False)
    file: str = field(default="", compare=False)
    line: int = field(default=0, compare=False)

    @cached_property
    def dimension(self) -> Dimension:
        """Powers of the base units."""
        return parse_unit(self.unit).dimension

    def admits(self, value: float) -> bool:
        """Whether the range holds a value (of one component, for a vector)."""
        return self.range.admits(value)

    @property
    def rule(self) -> str:
        """The range as a rule for messages, with the symbol as its id."""
        must = f"must be {self._range_words()}" if self.range.text else "must be finite"
        return f"{must} (symbol {self.name})"

    def _range_words(self) -> str:
        return f"in {self.range.text}" if self.range.text[0] in "[(" else self.range.text


@dataclass(frozen=True)
class Index:
    """A suffix of names: body A, after the impact, each vertex."""

    name: str
    tex: str
    says: str
    place: str = "sub"


@dataclass(frozen=True)
class Reference:
    """What a name stands for: a symbol and its indices."""

    symbol: Symbol
    indices: tuple[Index, ...] = ()


class SymbolTable:
    """Declared symbols and indices; finds what a name stands for."""

    def __init__(self, symbols: Iterable[Symbol], indices: Iterable[Index] = ()) -> None:
        self.symbols = {symbol.name: symbol for symbol in symbols}
        self.indices = {index.name: index for index in indices}
        self._found: dict[str, Reference] = {}

    def resolve(self, name: str, offset: int = 0) -> Reference:
        """The symbol and indices of a name; the longest symbol wins.

        Raises:
            SpecFault: no symbol with known indices reads so.
        """
        if name not in self._found:
            self._found[name] = self._search(name, offset)
        return self._found[name]

    def _search(self, name: str, offset: int) -> Reference:
        words = name.split("_")
        for length in range(len(words), 0, -1):
            symbol = self.symbols.get("_".join(words[:length]))
            suffixes = words[length:]
            if symbol and all(word in self.indices for word in suffixes):
                return Reference(symbol, tuple(self.indices[word] for word in suffixes))
        raise SpecFault(
            Code.UNKNOWN_NAME,
            f"'{name}' is no symbol{self._likely(name)} (srs/symbols.md). Declare or correct it",
            offset,
        )

    def _likely(self, name: str) -> str:
        import difflib

        close = difflib.get_close_matches(name, self.symbols, n=1)
        return f"; did you mean '{close[0]}'?" if close else ""

    def with_locals(self, symbols: Iterable[Symbol]) -> "SymbolTable":
        """A table that knows some more symbols."""
        return SymbolTable([*self.symbols.values(), *symbols], self.indices.values())


def table_from(symbols: Mapping[str, Symbol]) -> SymbolTable:
    """A table of symbols without indices, for expressions in scenes."""
    return SymbolTable(symbols.values())
