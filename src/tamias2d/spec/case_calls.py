"""The calls of functions in a case of `values`: each function exists and gets what it takes.

Serves: the check of a case. Hides: how values are matched with arguments and their symbols.
"""

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from tamias2d.spec.case_numbers import check_quantity
from tamias2d.spec.chapter import Item
from tamias2d.spec.equations import Report, module_of, symbol_of
from tamias2d.spec.expression import Both, Relation, parse
from tamias2d.spec.links import rests_on
from tamias2d.spec.messages import Code, SpecFault
from tamias2d.spec.symbols import Symbol, SymbolTable

Path = tuple[str | int, ...]
_TRUTH = ("true", "false")
_OUTLINE = ("vertex_i", "vertex_j")  # the pairs of neighbours of `vertices`


class Called(NamedTuple):
    """A function of a generated module: its arguments, the item that it comes from, its text."""

    arguments: tuple[str, ...]
    item: str
    text: str

    @property
    def is_condition(self) -> bool:
        """Whether it gives true or false; a text that cannot be read was reported before."""
        try:
            return isinstance(parse(self.text), Relation | Both)
        except SpecFault:
            return False


def check_calls(item: Item, items: Mapping[str, Item], table: SymbolTable, report: Report) -> None:
    """Report functions and arguments that do not exist or do not fit, and values with a wrong unit.

    A function that the case does not use is reported, too: no change of it would make the case
    stale.
    """
    if "values" not in item.data:
        return
    module = item.data["values"]["module"]
    functions = _functions(items, module)
    if not functions:
        text = f"'{module}' is no generated module with functions of items. Correct the name"
        report(item.diagnostic(Code.UNKNOWN_NAME, text, "values", "module"))
        return
    used = rests_on(item, items)
    for number, call in enumerate(item.data["values"]["calls"]):
        path = ("values", "calls", number)
        for name in call["expect"]:
            if name not in functions:
                text = f"'{name}' is no function of {module}. Correct the name"
                report(item.diagnostic(Code.UNKNOWN_NAME, text, *path, "expect", name, "key"))
            elif functions[name].item not in used:
                text = f"'{name}' is of {functions[name].item}, which the case does not use. Add it"
                report(item.diagnostic(Code.WRONG_LINK, text, *path, "expect", name, "key"))
        if set(call["expect"]) <= set(functions):
            if not _takes(item, call, functions, report, path):
                continue
            for name, value in call["given"].items():
                _check_value(item, name, value, table, report, (*path, "given", name))
            for name, value in call["expect"].items():
                place = (*path, "expect", name)
                if not functions[name].is_condition:
                    _check_value(item, name, value, table, report, place)
                elif value not in _TRUTH:
                    text = f"'{name}' is a condition: must be true or false. Write one"
                    report(item.diagnostic(Code.BAD_VALUE, text, *place))


def _functions(items: Mapping[str, Item], module: str) -> dict[str, Called]:
    """The functions of a generated module, by name."""
    return {
        name: Called(tuple(arguments), item.id, texts.get(name, ""))
        for item in items.values()
        if item.data.get("arguments") and module_of(item) == module
        for texts in [item.data.get("equations", {}) | item.data.get("closed_form", {})]
        for name, arguments in item.data["arguments"].items()
    }


def _takes(
    item: Item,
    call: Mapping[str, Any],
    functions: Mapping[str, Called],
    report: Report,
    path: Path,
) -> bool:
    """Whether each argument has a value and each value is an argument; else that is reported."""
    fits = True
    known = {*call["given"], *(_OUTLINE if "vertices" in call["given"] else ())}
    taken: set[str] = set()
    for name in call["expect"]:
        for argument in functions[name].arguments:
            if argument not in known:
                fits = False
                text = f"'{name}' takes '{argument}', which is not given. Give it"
                report(item.diagnostic(Code.UNKNOWN_NAME, text, *path, "expect", name, "key"))
        taken.update(functions[name].arguments)
        known.add(name)
    taken.update({"vertices"} if taken & set(_OUTLINE) else ())
    for name in call["given"]:
        if name not in taken:
            fits = False
            text = f"'{name}' is an argument of no function here. Correct the name or leave it out"
            report(item.diagnostic(Code.UNKNOWN_NAME, text, *path, "given", name, "key"))
    return fits


def _check_value(
    item: Item, name: str, value: Any, table: SymbolTable, report: Report, path: Path
) -> None:
    """Report a value that is no quantity of its symbol."""
    symbol = symbol_of(item, "vertex" if name == "vertices" else name, table, report, *path)
    if symbol is None:
        return
    many = name == "vertices" or name.endswith(("_i", "_j"))
    for place, text in _parts(item, symbol, value, report, path, many=many):
        check_quantity(item, text, symbol, report, *place)


def _parts(
    item: Item, symbol: Symbol, value: Any, report: Report, path: Path, *, many: bool
) -> Iterator[tuple[Path, str]]:
    """The texts of the numbers in a value, each with its place; a wrong shape is reported."""
    if many and isinstance(value, list):
        for number, part in enumerate(value):
            yield from _parts(item, symbol, part, report, (*path, number), many=False)
        return
    wanted = symbol.shape if not many else f"list, each a {symbol.shape}"
    if many or isinstance(value, list) != (symbol.shape == "vector"):
        text = f"must be a {wanted} (symbol {symbol.name}). Write it so"
        report(item.diagnostic(Code.SHAPE_MISMATCH, text, *path))
    elif isinstance(value, str):
        yield path, value
    elif len(value) != 2 or not all(isinstance(part, str) for part in value):
        text = f"must be two numbers (symbol {symbol.name}). Write it so"
        report(item.diagnostic(Code.SHAPE_MISMATCH, text, *path))
    else:
        yield from (((*path, number), part) for number, part in enumerate(value))
