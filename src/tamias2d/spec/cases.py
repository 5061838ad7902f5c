"""The check of a case: it holds what it compares, and answers with the units of their quantities.

Serves: the reader. Hides: where in a case expressions stand.
"""

from collections.abc import Iterator

from tamias2d.spec.chapter import Item
from tamias2d.spec.check import Type, expect
from tamias2d.spec.comparisons import COMPARISONS, WITHOUT_RUN
from tamias2d.spec.equations import Report, parsed, placed
from tamias2d.spec.messages import Code, SpecFault
from tamias2d.spec.symbols import SymbolTable
from tamias2d.spec.units import SECOND


def check_case(item: Item, table: SymbolTable, report: Report) -> None:
    """Report what a case lacks, or an exact answer with a wrong unit or shape."""
    compared = [key for key in COMPARISONS if key in item.data]
    if not compared:
        known = ", ".join(COMPARISONS)
        report(item.diagnostic(Code.BAD_KEY, f"a case compares something: one of {known}. Add one"))
    _check_run(item, [key for key in compared if key not in WITHOUT_RUN], report)
    for path, text, wanted in _answers(item, table, report):
        node = parsed(item, text, report, *path)
        if node is None:
            continue
        try:
            expect(node, table, wanted)
        except SpecFault as fault:
            report(placed(item, fault, *path))


def _check_run(item: Item, on_a_run: list[str], report: Report) -> None:
    """Report a case that has comparisons of a run and does not say of what, or for how long."""
    for needed in ("scene", "duration"):
        if on_a_run and needed not in item.data:
            text = f"found no '{needed}': '{on_a_run[0]}' compares a run and needs one. State it"
            report(item.diagnostic(Code.BAD_KEY, text))


def _answers(
    item: Item, table: SymbolTable, report: Report
) -> Iterator[tuple[tuple[str | int, ...], str, Type]]:
    for number, text in enumerate(item.data.get("impacts", {}).get("times", [])):
        yield ("impacts", "times", number), text, Type("scalar", SECOND)
    for key in ("exact", "final", "stepped", "worlds"):
        for body, quantities in item.data.get(key, {}).get("bodies", {}).items():
            for name, text in quantities.items():
                path = (key, "bodies", body, name)
                try:
                    symbol = table.resolve(name).symbol
                except SpecFault as fault:
                    report(item.diagnostic(fault.code, fault.message, *path, "key"))
                    continue
                yield path, text, Type(symbol.shape, symbol.dimension)
