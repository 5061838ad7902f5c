"""Generated module of the constraints: each with its slopes, its rate and its convective part."""

import re
import textwrap
from collections.abc import Iterator

from tamias2d.spec.chapter import Item
from tamias2d.spec.constraint import Constraint, Values
from tamias2d.spec.constraint_items import constraint_of
from tamias2d.spec.printed_constraint import arguments_of, body_of, parts_of
from tamias2d.spec.specification import Specification
from tamias2d.spec.symbols import SymbolTable
from tamias2d.spec.tex import plain
from tools.emit_functions import describe
from tools.quoting import docstring, quoted

HEADER = '''"""Constraints: {titles}.

Generated from {sources}
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.constraint_functions import ConstraintFunctions, Formula
from tamias2d.spec.functions import {imports}
'''
_LEADS = {
    "constraint": "{title}: zero where it holds",
    "slopes": "{title}: slopes by x, y and orientation of body {end}",
    "rate": "{title}: rate of the constraint along the motion",
    "convective": "{title}: second derivative of the constraint where no body is accelerated",
}


def owners(specification: Specification) -> list[tuple[str, str]]:
    """The printed functions: the item's id and the function's name."""
    return [
        (item.id, name)
        for item in specification.of_kind("constraint")
        for name, *_ in _parts(item, constraint_of(item, specification.table))
    ]


def emit(specification: Specification) -> str:
    """Source of the module, not yet formatted."""
    items = specification.of_kind("constraint")
    helpers: set[str] = set()
    bodies = [text for item in items for text in _functions(item, specification.table, helpers)]
    table = [_entry(item, specification.table) for item in items]
    used = "\n".join(bodies)
    types = {name for name in ("Scalar", "Vector") if re.search(rf"\b{name}\b", used)}
    titles = "; ".join(item.title for item in items)
    head = HEADER.format(
        titles="\n".join(map(quoted, textwrap.wrap(titles, 80))),
        sources=" and ".join(dict.fromkeys(item.file for item in items)),
        imports=", ".join(sorted(types | helpers)),
    )
    entries = "\n".join(table)
    known = f"CONSTRAINTS: dict[str, ConstraintFunctions] = {{\n{entries}\n}}\n"
    return "\n\n".join([head, *bodies, known])


def _parts(item: Item, constraint: Constraint) -> Iterator[tuple[str, str, str, Values]]:
    """The functions of a constraint: name, kind, body, values."""
    for kind, end, values in parts_of(constraint):
        yield f"{item.id}_{kind}{end and f'_{end}'}", kind, end, values


def _functions(item: Item, table: SymbolTable, helpers: set[str]) -> Iterator[str]:
    for name, kind, end, values in _parts(item, constraint_of(item, table)):
        body, used = body_of(values, _arguments(item, values), table)
        lines = [f"def {name}("]
        lines += [f"    {each}: {_type(each, table)}," for each in _arguments(item, values)]
        lines.append(") -> tuple[Scalar, ...]:")
        lines += _docstring(item, kind, end, values, table)
        helpers |= used
        yield "\n".join([*lines, *body])


def _arguments(item: Item, values: Values) -> list[str]:
    return arguments_of(values, item.data["parameters"])


def _docstring(item: Item, kind: str, end: str, values: Values, table: SymbolTable) -> list[str]:
    lead = _LEADS[kind].format(title=item.title, end=end.upper())
    lines = [f"{lead}.", ""]
    for row in values.rows:
        lines += textwrap.wrap(plain(row), 90, subsequent_indent="    ")
    for name, tree in values.where:
        text = f"    where {name} = {plain(tree)}"
        lines += textwrap.wrap(text, 90, subsequent_indent="        ")
    lines += ["", "Args:"]
    for name in _arguments(item, values):
        meaning, unit = describe(name, table)
        text = f"    {name}: {meaning}, {unit}"
        lines += textwrap.wrap(text, 92, subsequent_indent="        ")
    if lines[-1] == "Args:":
        lines = lines[:-2]
    lines += ["", f"Source: {item.id}, {item.file}:{item.line}."]
    return docstring(lines)


def _type(name: str, table: SymbolTable) -> str:
    return str(table.resolve(name).symbol.shape).capitalize()


def _entry(item: Item, table: SymbolTable) -> str:
    constraint = constraint_of(item, table)
    units = [
        str(found.dimension)
        for found in constraint.types
        for _ in range(2 if found.shape == "vector" else 1)
    ]
    formulas = {
        name: _formula(name, item, values) for name, _, _, values in _parts(item, constraint)
    }
    slopes = ", ".join(
        f'"{end}": {formulas[f"{item.id}_slopes_{end}"]}' for end in constraint.bodies
    )
    return (
        f'"{item.id}": ConstraintFunctions('
        f"name={item.id!r}, parameters={_tuple(item.data['parameters'])}, "
        f"bodies={_tuple(constraint.bodies)}, "
        f"units={_tuple(units)}, constraint={formulas[f'{item.id}_constraint']}, "
        f"slopes={{{slopes}}}, rate={formulas[f'{item.id}_rate']}, "
        f"convective={formulas[f'{item.id}_convective']},),"
    )


def _formula(name: str, item: Item, values: Values) -> str:
    return f"Formula({name}, {_tuple(_arguments(item, values))})"


def _tuple(words: list[str] | tuple[str, ...]) -> str:
    return f"({''.join(f'{word!r}, ' for word in words)})"
