"""Constraints of the specification: what an item says, checked, as a constraint to differentiate.

Serves: the reader and the generator. Hides: which names an equation of a joint may use, and that
units and derivatives are checked before anything is printed.
"""

from collections.abc import Iterator

from tamias2d.spec.chapter import Item
from tamias2d.spec.check import Type, expect, infer
from tamias2d.spec.constraint import COORDINATES, ENDS, Constraint, Values, table_with
from tamias2d.spec.equations import Report, parsed, placed, typed
from tamias2d.spec.expression import Node, names
from tamias2d.spec.messages import Code, SpecFault
from tamias2d.spec.symbols import SymbolTable
from tamias2d.spec.units import SECOND, Dimension

_PLACES = frozenset(f"{coordinate}_{end}" for coordinate in COORDINATES for end in ENDS)


def constraint_of(item: Item, table: SymbolTable) -> Constraint:
    """The constraint of an item that has been checked."""
    where = {name: _tree(item, text, "equations", name) for name, text in _equations(item).items()}
    trees = [
        _tree(item, text, "constraint", number)
        for number, text in enumerate(item.data["constraint"])
    ]
    return Constraint(tuple(trees), tuple(where.items()), table)


def check_constraint(item: Item, table: SymbolTable, report: Report) -> None:
    """Report names, units and shapes that do not fit, and what has no derivative."""
    faults = [fault for fault in _faults(item, table, report) if fault]
    if faults:
        return
    constraint = constraint_of(item, table)
    try:
        for order, values in ((1, constraint.rates()), (2, constraint.convective())):
            _check_units(constraint, values, order)
        for end in constraint.bodies:
            constraint.slopes(end)
    except ValueError as error:
        text = f"{error}: a joint needs its first and second one. Rewrite it"
        report(item.diagnostic(Code.BAD_VALUE, text, "constraint"))


def _faults(item: Item, table: SymbolTable, report: Report) -> Iterator[bool]:
    """Whether each tree of an item is at fault, which is reported."""
    parameters = item.data["parameters"]
    known = {*_PLACES, *parameters}
    used: set[str] = set()
    for name, text in _equations(item).items():
        yield _faulty(item, text, known, table, report, used, "equations", name)
        known.add(name)
    for number, text in enumerate(item.data["constraint"]):
        yield _faulty(item, text, known, table, report, used, "constraint", number)
    for number, name in enumerate(parameters):
        if name not in used:
            text = f"'{name}' stands in no equation. Correct 'parameters'"
            report(item.diagnostic(Code.UNKNOWN_NAME, text, "parameters", number))
            yield True


def _faulty(
    item: Item,
    text: str,
    known: set[str],
    table: SymbolTable,
    report: Report,
    used: set[str],
    key: str,
    name: str | int,
) -> bool:
    node = parsed(item, text, report, key, name)
    if node is None or typed(item, node, table, report, key, name) is None:
        return True
    used.update(names(node))
    for word in names(node):
        if word not in known:
            text = f"'{word}' is no parameter, no equation before and no place of a body"
            report(item.diagnostic(Code.UNKNOWN_NAME, f"{text}. Declare it", key, name))
            return True
    return isinstance(name, str) and not _fits(item, name, node, table, report)


def _fits(item: Item, name: str, node: Node, table: SymbolTable, report: Report) -> bool:
    try:
        symbol = table.resolve(name).symbol
        expect(node, table, Type(symbol.shape, symbol.dimension))
    except SpecFault as fault:
        report(placed(item, fault, "equations", name))
        return False
    return True


def _check_units(constraint: Constraint, values: Values, order: int) -> None:
    """Raise an error where a derivative has not the unit of its equation over time."""
    table = table_with(constraint.table, values.where)
    wanted: list[Dimension | None] = []
    for found in constraint.types:
        over = found.dimension and found.dimension / SECOND**order
        wanted += [over] * (2 if found.shape == "vector" else 1)
    for row, unit in zip(values.rows, wanted, strict=True):
        found = infer(row, table)
        if found.shape != "scalar" or found.dimension not in (None, unit):
            raise AssertionError(f"derivative {order} of {constraint} is {found}, not in {unit}")


def _equations(item: Item) -> dict[str, str]:
    equations: dict[str, str] = item.data.get("equations", {})
    return equations


def _tree(item: Item, text: str, *path: str | int) -> Node:
    node = parsed(item, text, _unexpected, *path)
    assert node is not None
    return node


def _unexpected(fault: object) -> None:
    raise AssertionError(f"the check let a fault through: {fault}")
