"""Generated module of the rows of joints: each constraint and its slopes, written into an array.

It is for the engine: without trigonometry, because a body's cosine and sine stand beside its place,
and all kinds of joints behind one function, because compiled code knows no tables of functions.
"""

import re
import textwrap
from collections.abc import Callable, Iterator, Mapping, Sequence

from tamias2d.spec.chapter import Item
from tamias2d.spec.check import infer
from tamias2d.spec.constraint import COORDINATES, ENDS, Constraint, Values, table_with
from tamias2d.spec.constraint_items import constraint_of
from tamias2d.spec.expression import Node, names
from tamias2d.spec.python import PythonPrinter
from tamias2d.spec.specification import Specification
from tamias2d.spec.symbols import SymbolTable
from tools.quoting import docstring, quoted

HEADER = '''"""Rows of joints: {titles}.

Places are rows of x, y (m), orientation (rad), and its cosine and sine. Each row of a joint takes
ten numbers: its value, then its slopes by x, y and orientation of bodies A, B and C. The second
derivatives by the orientations of these are three numbers for each row.

Generated from {sources}
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from typing import Any

from tamias2d.spec.functions import {imports}

ROW = {row}  # numbers of a row
MOST_ROWS = {most}  # rows of a joint
MOST_PARAMETERS = {parameters}  # numbers that a joint is given
'''
_ARGUMENTS = ("given", *ENDS, "row")
_ROW = 1 + 3 * len(ENDS)
_PARTS = ("values", "rows", "bends")
_LAYOUT = {
    "values": (_ROW, range(1)),
    "rows": (_ROW, range(_ROW)),
    "bends": (len(ENDS), range(1, 4)),
}
"""Numbers from a row to the next, and the columns that are written of each."""


def owners(specification: Specification) -> list[tuple[str, str]]:
    """The printed functions: the item's id and the function's name."""
    items = specification.of_kind("constraint")
    return [(item.id, f"{item.id}_{part}") for item in items for part in _PARTS]


def emit(specification: Specification) -> str:
    """Source of the module, not yet formatted."""
    items, table = specification.of_kind("constraint"), specification.table
    helpers: set[str] = set()
    made = {name: one for item in items for name, one in _functions(item, table, helpers)}
    arguments = {name: taken for name, (taken, _) in made.items()}
    bodies = [text for _, text in made.values()]
    counts = {item.id: _row_count(constraint_of(item, table)) for item in items}
    titles = "; ".join(item.title for item in items)
    head = HEADER.format(
        titles="\n".join(map(quoted, textwrap.wrap(titles, 80))),
        sources=" and ".join(dict.fromkeys(item.file for item in items)),
        imports=", ".join(sorted(helpers)),
        row=_ROW,
        most=max(counts.values()),
        parameters=max(_width(item, table) for item in items),
    )
    kinds = f"KINDS = ({', '.join(repr(item.id) for item in items)},)"
    rows = f"ROWS_OF_KIND = ({', '.join(str(counts[item.id]) for item in items)},)"
    tables = [f'{kinds}\n"""By which number of a kind."""\n{rows}\n']
    return "\n\n".join([head, *tables, *bodies, *map(_choice(items, arguments), _PARTS)])


def _choice(items: Sequence[Item], arguments: Mapping[str, Sequence[str]]) -> Callable[[str], str]:
    """Return what prints the function that chooses by the kind of a joint."""

    def printed(part: str) -> str:
        says = {
            "values": "Write how far each row of a joint of a kind is from holding.",
            "rows": "Write the rows of a joint of a kind with their slopes.",
            "bends": "Write the second derivatives of a joint of a kind by orientations.",
        }
        lines = [f"def joint_{part}(kind: int, given: Any, a: Any, b: Any, c: Any, row: Any)"]
        lines[0] += " -> None:"
        lines.append(f'    """{says[part]}"""')
        for number, item in enumerate(items):
            lines.append(f"    {'el' if number else ''}if kind == {number}:")
            taken = ", ".join(arguments[f"{item.id}_{part}"])
            lines.append(f"        {item.id}_{part}({taken})")
        return "\n".join(lines) + "\n"

    return printed


def _functions(
    item: Item, table: SymbolTable, helpers: set[str]
) -> Iterator[tuple[str, tuple[list[str], str]]]:
    """The functions of a joint by their names: their arguments and their texts."""
    constraint = constraint_of(item, table)
    found = {"values": {0: constraint.values()}}
    slopes = {1 + 3 * ENDS.index(end): constraint.slopes(end) for end in constraint.bodies}
    found["rows"] = {0: constraint.values(), **slopes}
    found["bends"] = {1 + ENDS.index(end): constraint.bends(end) for end in constraint.bodies}
    for part, columns in found.items():
        yield f"{item.id}_{part}", _function(item, part, columns, table, helpers)


def _function(
    item: Item, part: str, found: dict[int, Values], table: SymbolTable, helpers: set[str]
) -> tuple[list[str], str]:
    """The function that writes some columns of the rows of a joint: its arguments and its text."""
    where = {name: tree for values in found.values() for name, tree in values.where}
    known = table_with(table, tuple(where.items()))
    printer = _Printer(known)
    body = []
    for name, tree in where.items():
        targets = f"{name}_x, {name}_y" if infer(tree, known).shape == "vector" else name
        body.append(f"    {targets} = {printer.value(tree)}")
    count = _row_count(constraint_of(item, table))
    for number in range(count):
        written: set[int] = set()
        start, columns = _LAYOUT[part]
        for first, values in found.items():
            width = 3 if first and part == "rows" else 1
            for k, tree in enumerate(values.rows[width * number : width * (number + 1)]):
                written.add(first + k)
                at = start * number + first + k - (part == "bends")
                body.append(f"    row[{at}] = {printer.scalar(tree)}")
        for column in sorted(set(columns) - written):
            body.append(f"    row[{start * number + column - (part == 'bends')}] = 0.0")
    helpers |= printer.helpers
    used = {name for values in found.values() for tree in _trees(values) for name in names(tree)}
    lead = {
        "values": f"{item.title}: how far each row is from holding.",
        "rows": f"{item.title}: its rows with their slopes.",
        "bends": f"{item.title}: second derivatives of its rows by orientations.",
    }[part]
    body = [
        *_parameters(item, used, table),
        *_places(used, printer.turned, "\n".join(body)),
        *body,
    ]
    text = "\n".join(body)
    taken = [name for name in _ARGUMENTS if re.search(rf"\b{name}\[", text)]
    head = [
        f"def {item.id}_{part}({', '.join(f'{name}: Any' for name in taken)}) -> None:",
        *docstring([lead, "", f"Source: {item.id}, {item.file}:{item.line}."]),
    ]
    return taken, "\n".join([*head, *body])


def _trees(values: Values) -> Iterator[Node]:
    yield from values.rows
    yield from (tree for _, tree in values.where)


def _parameters(item: Item, used: set[str], table: SymbolTable) -> Iterator[str]:
    """Lines that take the parameters of a joint out of its numbers."""
    at = 0
    for name in item.data["parameters"]:
        vector = table.resolve(name).symbol.shape == "vector"
        if name in used and vector:
            yield f"    {name}_x, {name}_y = given[{at}], given[{at + 1}]"
        elif name in used:
            yield f"    {name} = given[{at}]"
        at += 2 if vector else 1


def _places(used: set[str], turned: set[str], body: str) -> Iterator[str]:
    """Lines that take the places of bodies out of their rows."""
    for end in ENDS:
        position, orientation = (f"{name}_{end}" for name in COORDINATES)
        if position in used:
            yield f"    {position}_x, {position}_y = {end}[0], {end}[1]"
        if re.search(rf"\b{orientation}\b", body):
            yield f"    {orientation} = {end}[2]"
        if orientation in turned:
            yield f"    cosine_{end}, sine_{end} = {end}[3], {end}[4]"


def _row_count(constraint: Constraint) -> int:
    return sum(2 if found.shape == "vector" else 1 for found in constraint.types)


def _width(item: Item, table: SymbolTable) -> int:
    shapes = [table.resolve(name).symbol.shape for name in item.data["parameters"]]
    return sum(2 if shape == "vector" else 1 for shape in shapes)


class _Printer(PythonPrinter):
    """Prints the cosine and the sine of an orientation as numbers that are known."""

    def __init__(self, table: SymbolTable) -> None:
        super().__init__(table)
        self.turned: set[str] = set()
        """Orientations of which these are used."""

    def helper(self, function: str, inner: str) -> str:
        """Source of a call of a helper function, or the name of what it returns."""
        names = {"cos": "cosine", "sin": "sine"}
        if function in names and inner in {f"orientation_{end}" for end in ENDS}:
            self.turned.add(inner)
            return f"{names[function]}_{inner[-1]}"
        return super().helper(function, inner)
