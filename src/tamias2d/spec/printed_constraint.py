"""Constraints as Python functions, which are printed as those of the specification are.

Serves: the generator, and constraints that a scene states by equations of its own. Hides: how a
text becomes a function whose lines a traceback shows, and whose source kernels take over.
"""

import hashlib
import linecache
from collections.abc import Callable, Iterator, Sequence
from typing import Any

from tamias2d.spec import functions as elementary
from tamias2d.spec.check import infer
from tamias2d.spec.constraint import COORDINATES, ENDS, TIME, Constraint, Values, table_with
from tamias2d.spec.constraint_functions import ConstraintFunctions, Formula
from tamias2d.spec.expression import names
from tamias2d.spec.python import PythonPrinter
from tamias2d.spec.symbols import SymbolTable

_PRINTED: dict[str, ConstraintFunctions] = {}


def parts_of(constraint: Constraint) -> Iterator[tuple[str, str, Values]]:
    """Yield the functions of a constraint: kind, body and values."""
    yield "constraint", "", constraint.values()
    for end in constraint.bodies:
        yield "slopes", end, constraint.slopes(end)
    yield "rate", "", constraint.rates()
    yield "convective", "", constraint.convective()


def arguments_of(values: Values, parameters: Sequence[str]) -> list[str]:
    """Return what values are written with: parameters, places and velocities, and the time."""
    used = {name for tree in (*values.rows, *(t for _, t in values.where)) for name in names(tree)}
    moving = [f"{name}_{end}" for end in ENDS for pair in COORDINATES.items() for name in pair]
    return [name for name in (*parameters, *moving, TIME) if name in used]


def body_of(
    values: Values, arguments: Sequence[str], table: SymbolTable
) -> tuple[list[str], set[str]]:
    """Return the lines of a function of some arguments, and the helpers that it calls."""
    known = table_with(table, values.where)
    printer = PythonPrinter(known)
    lines = [
        f"    {name}_x, {name}_y = {name}"
        for name in arguments
        if table.resolve(name).symbol.shape == "vector"
    ]
    for name, tree in values.where:
        vector = infer(tree, known).shape == "vector"
        targets = f"{name}_x, {name}_y" if vector else name
        lines.append(f"    {targets} = {printer.value(tree)}")
    rows = [printer.scalar(row) for row in values.rows]
    lines.append(f"    return ({', '.join(rows)},)")
    return lines, printer.helpers


def printed(constraint: Constraint, parameters: Sequence[str]) -> ConstraintFunctions:
    """Return the functions of a constraint with some parameters, by a name of their own."""
    texts: dict[tuple[str, str], tuple[list[str], list[str]]] = {}
    for kind, end, values in parts_of(constraint):
        arguments = arguments_of(values, parameters)
        texts[kind, end] = arguments, body_of(values, arguments, constraint.table)[0]
    whole = repr(texts).encode()
    name = f"own_{hashlib.sha256(whole).hexdigest()[:16]}"
    formulas = {
        (kind, end): Formula(
            _function(f"{name}_{kind}{end and f'_{end}'}", arguments, lines), tuple(arguments)
        )
        for (kind, end), (arguments, lines) in texts.items()
    }
    units = [
        str(found.dimension or 1)
        for found in constraint.types
        for _ in range(2 if found.shape == "vector" else 1)
    ]
    found = ConstraintFunctions(
        name=name,
        parameters=tuple(parameters),
        bodies=constraint.bodies,
        units=tuple(units),
        constraint=formulas["constraint", ""],
        slopes={end: formulas["slopes", end] for end in constraint.bodies},
        rate=formulas["rate", ""],
        convective=formulas["convective", ""],
    )
    _PRINTED[name] = found
    return found


def printed_by(name: str) -> ConstraintFunctions:
    """Return the functions that were printed by a name."""
    return _PRINTED[name]


def _function(name: str, arguments: Sequence[str], lines: Sequence[str]) -> Callable[..., Any]:
    text = "\n".join([f"def {name}({', '.join(arguments)}):", *lines]) + "\n"
    file = f"<tamias2d {name}>"
    linecache.cache[file] = (len(text), None, text.splitlines(keepends=True), file)
    namespace = dict(vars(elementary))
    exec(compile(text, file, "exec"), namespace)
    function: Callable[..., Any] = namespace[name]
    return function
