"""The check of letters: what a chapter prints alike is one quantity.

Serves: the reader. Hides: where formulas stand in an item.
"""

from collections.abc import Iterable, Iterator
from typing import Any

from tamias2d.spec.chapter import Item
from tamias2d.spec.expression import Name, names, parse
from tamias2d.spec.messages import Code, Diagnostic, SpecFault
from tamias2d.spec.symbols import Reference, SymbolTable
from tamias2d.spec.tex import tex

_FORMULAS = ("equation", "equations", "closed_form", "states", "derivation", "constraint")
_PROSE = ("by", "when")


def check_letters(items: Iterable[Item], table: SymbolTable) -> list[Diagnostic]:
    """The faults of items in whose chapter another quantity has a letter, or prints, alike."""
    faults: list[Diagnostic] = []
    seen: dict[tuple[str, str], str] = {}
    for item in items:
        if item.kind in ("case", "scheme"):
            continue
        for name in dict.fromkeys(_names(item.data)):
            if reference := _resolved(name, table):
                symbol = reference.symbol
                printed = ((symbol.tex, symbol.name), (tex(Name(name), table), name))
                for letter, means in printed:
                    other = seen.setdefault((item.file, letter), means)
                    if other != means:
                        text = f"'{means}' and '{other}' print as {letter} here. Give one another"
                        faults.append(item.diagnostic(Code.SAME_LETTER, text))
    return faults


def _names(data: Any) -> Iterator[str]:
    """The names in the formulas of an item, as often as they stand there."""
    for key in _FORMULAS:
        if key in data:
            yield from _names_in(data[key])


def _names_in(value: Any) -> Iterator[str]:
    if isinstance(value, dict):
        for key, inner in value.items():
            if key not in _PROSE:
                yield from _names_in(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from _names_in(inner)
    else:
        yield from names(parse(value))


def _resolved(name: str, table: SymbolTable) -> Reference | None:
    try:
        return table.resolve(name)
    except SpecFault:
        return None  # a quantity of the item alone
