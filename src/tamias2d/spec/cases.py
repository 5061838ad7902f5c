"""The check of a case's exact answers: each must have the unit and shape of its quantity.

Serves: the reader. Hides: where in a case expressions stand.
"""

from collections.abc import Iterator

from tamias2d.spec.chapter import Item
from tamias2d.spec.check import Type, expect
from tamias2d.spec.comparisons import COMPARISONS
from tamias2d.spec.equations import Report, parsed, placed
from tamias2d.spec.messages import Code, SpecFault
from tamias2d.spec.symbols import SymbolTable
from tamias2d.spec.units import SECOND


def check_case(item: Item, table: SymbolTable, report: Report) -> None:
    """Report a case that compares nothing, or an exact answer with a wrong unit or shape."""
    if not any(key in item.data for key in COMPARISONS):
        known = ", ".join(COMPARISONS)
        report(item.diagnostic(Code.BAD_KEY, f"a case compares something: one of {known}. Add one"))
    for path, text, wanted in _answers(item, table, report):
        node = parsed(item, text, report, *path)
        if node is None:
            continue
        try:
            expect(node, table, wanted)
        except SpecFault as fault:
            report(placed(item, fault, *path))


def _answers(
    item: Item, table: SymbolTable, report: Report
) -> Iterator[tuple[tuple[str | int, ...], str, Type]]:
    for number, text in enumerate(item.data.get("impacts", {}).get("times", [])):
        yield ("impacts", "times", number), text, Type("scalar", SECOND)
    for key in ("exact", "final", "worlds"):
        for body, quantities in item.data.get(key, {}).get("bodies", {}).items():
            for name, text in quantities.items():
                path = (key, "bodies", body, name)
                try:
                    symbol = table.resolve(name).symbol
                except SpecFault as fault:
                    report(item.diagnostic(fault.code, fault.message, *path, "key"))
                    continue
                yield path, text, Type(symbol.shape, symbol.dimension)
