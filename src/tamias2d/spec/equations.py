"""The executable equations of an item: parsed, checked, with their arguments.

Serves: the generator and the derivation check. Hides: which names become arguments of a
function and which become named intermediate quantities inside it.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import PurePosixPath

from tamias2d.spec.chapter import Item
from tamias2d.spec.check import TRUTH, Type, expect, infer
from tamias2d.spec.circles import rings
from tamias2d.spec.expression import Node, Relation, names, parse
from tamias2d.spec.messages import Code, Diagnostic, SpecFault
from tamias2d.spec.symbols import Symbol, SymbolTable

Report = Callable[[Diagnostic], None]


@dataclass(frozen=True)
class Function:
    """One executable equation: `name(arguments) = expression`, with intermediates before it."""

    name: str
    arguments: tuple[str, ...]
    intermediates: tuple[tuple[str, Node], ...]
    expression: Node
    item: Item
    key: str


def module_of(item: Item) -> str:
    """The generated module that holds an item's functions."""
    default = PurePosixPath(item.file).stem if item.kind == "model" else "definitions"
    return str(item.data.get("module", default))


def parsed(item: Item, text: str, report: Report, *path: str | int) -> Node | None:
    """The tree of a text in an item; a fault is reported at its place."""
    try:
        return parse(text)
    except SpecFault as fault:
        report(placed(item, fault, *path))
        return None


def placed(item: Item, fault: SpecFault, *path: str | int) -> Diagnostic:
    """A fault of a text as a diagnostic in the item that holds the text."""
    return item.diagnostic(fault.code, fault.message, *path, offset=fault.offset)


def typed(
    item: Item, node: Node, table: SymbolTable, report: Report, *path: str | int
) -> Type | None:
    """The type of a tree in an item; a fault is reported at its place."""
    try:
        return infer(node, table)
    except SpecFault as fault:
        report(placed(item, fault, *path))
        return None


def symbol_of(
    item: Item, name: str, table: SymbolTable, report: Report, *path: str | int
) -> Symbol | None:
    """The symbol that a name in an item stands for; a fault is reported at its place."""
    try:
        return table.resolve(name).symbol
    except SpecFault as fault:
        report(item.diagnostic(fault.code, fault.message, *path))
        return None


def relation(
    item: Item, text: str, table: SymbolTable, report: Report, *path: str | int
) -> Relation | None:
    """A checked equation `lhs == rhs`, or None with a report."""
    node = parsed(item, text, report, *path)
    if node is None or typed(item, node, table, report, *path) is None:
        return None
    if not (isinstance(node, Relation) and node.operator == "=="):
        report(
            item.diagnostic(
                Code.BAD_VALUE, f"'{text}' must be an equation 'left == right'. Write it so", *path
            )
        )
        return None
    return node


def functions(item: Item, table: SymbolTable, report: Report) -> list[Function]:
    """The functions that an item defines; faults are reported at their places."""
    found: list[Function] = []
    for key in ("equations", "closed_form"):
        trees = dict(_trees(item, key, table, report))
        if _circular(item, key, trees, report):
            continue
        for name, arguments in item.data.get("arguments", {}).items():
            if name in trees:
                function = _function(item, key, name, arguments, trees, report)
                found.extend([function] if function else [])
    _check_argument_keys(item, report)
    return found


def _check_argument_keys(item: Item, report: Report) -> None:
    known = {**item.data.get("equations", {}), **item.data.get("closed_form", {})}
    for name in item.data.get("arguments", {}):
        if name not in known:
            text = f"'arguments' names '{name}', which no equation defines. Correct the name"
            report(item.diagnostic(Code.UNKNOWN_NAME, text, "arguments", name, "key"))


def _trees(item: Item, key: str, table: SymbolTable, report: Report) -> Iterator[tuple[str, Node]]:
    for name, text in item.data.get(key, {}).items():
        if name == "when":
            continue
        node = parsed(item, text, report, key, name)
        if node is not None and _fits(item, key, name, node, table, report):
            yield name, node


def _fits(item: Item, key: str, name: str, node: Node, table: SymbolTable, report: Report) -> bool:
    try:
        found = infer(node, table)
        if found != TRUTH:
            symbol = table.resolve(name).symbol
            expect(node, table, Type(symbol.shape, symbol.dimension))
    except SpecFault as fault:
        where = (
            (key, name, "key")
            if fault.code is Code.UNKNOWN_NAME and f"'{name}'" in fault.message
            else (key, name)
        )
        report(placed(item, fault, *where))
        return False
    return True


def _circular(item: Item, key: str, trees: dict[str, Node], report: Report) -> bool:
    """Whether a quantity is defined by itself, which is reported."""
    found = list(rings({name: _rests_on(item, name, trees) for name in trees}))
    for ring in found:
        text = f"'{ring[0]}' is defined by itself: {' by '.join(ring)}. Write what it is"
        report(item.diagnostic(Code.CIRCLE, text, key, ring[0]))
    return bool(found)


def _rests_on(item: Item, name: str, trees: dict[str, Node]) -> list[str]:
    """The equations that one rests on; two functions may be solutions for each other's argument."""
    arguments = item.data.get("arguments", {})
    return [
        word
        for word in names(trees[name])
        if word in trees
        and (word == name or word not in arguments or word not in arguments.get(name, ()))
    ]


def _function(
    item: Item, key: str, name: str, arguments: list[str], trees: dict[str, Node], report: Report
) -> Function | None:
    order: dict[str, Node] = {}
    missing = _collect(trees[name], {name, *arguments}, trees, order)
    used = {word for tree in (*order.values(), trees[name]) for word in names(tree)}
    faults = [(wrong, "is neither an argument nor an equation of this item") for wrong in missing]
    faults += [
        (wrong, "is an argument that no term uses") for wrong in arguments if wrong not in used
    ]
    for wrong, why in faults:
        text = f"'{wrong}' of {name} {why}. Correct 'arguments'"
        report(item.diagnostic(Code.UNKNOWN_NAME, text, "arguments", name))
    if faults:
        return None
    return Function(name, tuple(arguments), tuple(order.items()), trees[name], item, key)


def _collect(
    node: Node, known: set[str], trees: dict[str, Node], order: dict[str, Node]
) -> list[str]:
    """Put the intermediates that a tree needs into order; return names that nothing defines."""
    missing: list[str] = []
    for name in names(node):
        if name in known or name in order:
            continue
        if name not in trees:
            missing.append(name)
            continue
        missing += _collect(trees[name], known | {name}, trees, order)
        order[name] = trees[name]
    return missing
