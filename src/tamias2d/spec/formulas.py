"""The checks of one item's formal parts: equations, states, derivations, orders, exact answers.

Serves: the reader, and whoever changes an item and asks whether it still holds. Hides: which
checks belong to which kind of item.
"""

from collections.abc import Mapping

from tamias2d.spec.cases import check_case
from tamias2d.spec.chapter import Item
from tamias2d.spec.check import Type
from tamias2d.spec.constraint_items import check_constraint
from tamias2d.spec.derivation import check_closed_form, check_derivation
from tamias2d.spec.equations import Report, functions, parsed, relation, symbol_of, typed
from tamias2d.spec.messages import Code, Diagnostic
from tamias2d.spec.model import check_model
from tamias2d.spec.order import check_orders
from tamias2d.spec.stability import check_stability
from tamias2d.spec.symbols import Symbol, SymbolTable
from tamias2d.spec.units import SECOND


def check_item(item: Item, items: Mapping[str, Item], table: SymbolTable) -> list[Diagnostic]:
    """The faults of an item's formal parts, none if it holds; `items` are all, by their ids."""
    faults: list[Diagnostic] = []
    report = faults.append
    if item.kind == "scheme":
        check_orders(item, report)
        check_stability(item, report)
    elif item.kind == "case":
        check_case(item, items, table, report)
    elif item.kind == "constraint":
        check_constraint(item, table, report)
    elif item.kind in ("theory", "definition", "model", "property"):
        _check_statement(item, table, report)
        if not faults:  # a faulty formula would only be reported twice
            check_derivation(item, items, table, report)
            check_closed_form(item, table, report)
            if item.kind == "model":
                check_model(item, items, report)
    return faults


def _check_statement(item: Item, table: SymbolTable, report: Report) -> None:
    if text := item.data.get("equation"):
        relation(item, text, table, report, "equation")
    functions(item, table, report)
    for key in ("input", "output"):
        for number, name in enumerate(item.data.get(key, [])):
            symbol_of(item, name, table, report, key, number)
    for name, text in item.data.get("states", {}).items():
        node = parsed(item, text, report, "states", name)
        rate = typed(item, node, table, report, "states", name) if node else None
        symbol = symbol_of(item, name, table, report, "states", name, "key")
        if rate and symbol:
            _check_rate(item, symbol, rate, report, name)


def _check_rate(item: Item, symbol: Symbol, rate: Type, report: Report, name: str) -> None:
    wanted = symbol.dimension / SECOND
    if (rate.shape, rate.dimension) != (symbol.shape, wanted):
        text = f"the rate of '{name}' is {rate}, not a {symbol.shape} in {wanted}. Correct it"
        report(item.diagnostic(Code.UNIT_MISMATCH, text, "states", name))
