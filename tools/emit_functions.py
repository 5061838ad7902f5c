"""Generated modules of the executable equations: one function for each."""

import re
import textwrap
from collections import defaultdict

from tamias2d.spec.check import infer
from tamias2d.spec.equations import Function, functions, module_of
from tamias2d.spec.messages import SpecFault
from tamias2d.spec.python import PythonPrinter
from tamias2d.spec.specification import Specification
from tamias2d.spec.symbols import SymbolTable
from tamias2d.spec.tex import plain
from tools.quoting import docstring, quoted

HEADER = '''"""{title}

Generated from {sources}
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.functions import {imports}
'''


def functions_by_module(specification: Specification) -> dict[str, list[Function]]:
    """All executable equations, by the module that holds them."""
    found: dict[str, list[Function]] = defaultdict(list)
    for item in specification.of_kind("theory", "definition", "model"):
        made = functions(item, specification.table, _unexpected)
        if made:
            found[module_of(item)] += made
    return found


def _unexpected(fault: object) -> None:
    raise AssertionError(f"the reader let a fault through: {fault}")


def emit(module: str, made: list[Function], specification: Specification) -> str:
    """Source of one generated module, not yet formatted."""
    printer = PythonPrinter(specification.table)
    bodies = [_function(function, printer) for function in made]
    used = "\n".join(bodies)
    types = {name for name in ("Scalar", "Truth", "Vector") if re.search(rf"\b{name}\b", used)}
    files = dict.fromkeys(function.item.file for function in made)
    name = module.replace("_", " ").capitalize()
    title = f"{name}: {'; '.join(dict.fromkeys(f.item.title for f in made))}."
    head = HEADER.format(
        title="\n".join(map(quoted, textwrap.wrap(title, 96))),
        sources=quoted(" and ".join(files)),
        imports=", ".join(sorted(types | printer.helpers)),
    )
    return "\n\n".join([head, *bodies])


def _function(function: Function, printer: PythonPrinter) -> str:
    table = printer.table
    arguments = ", ".join(f"{name}: {_type(name, table)}" for name in function.arguments)
    lines = [f"def {function.name}({arguments}) -> {_result(function, printer)}:"]
    lines += _docstring(function, table)
    lines += [
        f"    {name}_x, {name}_y = {name}"
        for name in function.arguments
        if _type(name, table) == "Vector"
    ]
    for name, tree in function.intermediates:
        targets = f"{name}_x, {name}_y" if _type(name, table) == "Vector" else name
        lines.append(f"    {targets} = {printer.value(tree)}")
    lines.append(f"    return {printer.value(function.expression)}")
    return "\n".join(lines)


def _type(name: str, table: SymbolTable) -> str:
    return str(table.resolve(name).symbol.shape).capitalize()


def _result(function: Function, printer: PythonPrinter) -> str:
    found = infer(function.expression, printer.table)
    return found.shape.capitalize()


def _docstring(function: Function, table: SymbolTable) -> list[str]:
    says, unit = describe(function.name, table)
    item = function.item
    line = item.at(function.key, function.name, "key")[0]
    lines = textwrap.wrap(f"{says}{f' ({unit})' if unit else ''}.", 92)
    lines += ["", *textwrap.wrap(f"{function.name} = {plain(function.expression)}", 90)]
    lines += [f"    where {name} = {plain(tree)}" for name, tree in function.intermediates]
    if (
        when := item.data.get("closed_form", {}).get("when")
        if function.key == "closed_form"
        else None
    ):
        lines += ["", *textwrap.wrap(f"Valid when {when}.", 92)]
    lines += ["", "Args:"]
    for name in function.arguments:
        meaning, own_unit = describe(name, table)
        lines += textwrap.wrap(
            f"    {name}: {meaning}, {own_unit}", 92, subsequent_indent="        "
        )
    lines += ["", f"Source: {item.id}, {item.file}:{line}."]
    return docstring(lines)


def describe(name: str, table: SymbolTable) -> tuple[str, str]:
    """What a name means, with its indices, and its unit; a condition has no unit."""
    try:
        reference = table.resolve(name)
    except SpecFault:
        return name.replace("_", " ").capitalize(), ""
    meaning = "; ".join([reference.symbol.says, *(index.says for index in reference.indices)])
    return meaning[0].upper() + meaning[1:], reference.symbol.unit
