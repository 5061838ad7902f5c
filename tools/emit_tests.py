"""Generated tests: functions against their equations, closed forms against scipy, schemes
against their order, symbols against their ranges, and one test for each case."""

import json
import math
import re
import textwrap
from collections.abc import Iterable

from tamias2d.spec.chapter import Item
from tamias2d.spec.equations import Function
from tamias2d.spec.specification import Specification
from tamias2d.spec.symbols import Symbol
from tamias2d.spec.tex import plain
from tools.emit_functions import functions_by_module, module_of
from tools.quoting import docstring

HEADER = '''"""{title}

Generated from srs/ by `python -m tools.generate`. Edit the chapter, not this file.
"""

{imports}
'''
_LONG = {5: ("span=10.0", "steps=32"), 8: ("span=30.0", "steps=20")}  # to stay above rounding


def emit(specification: Specification) -> dict[str, str]:
    """Generated tests by file name, not yet formatted."""
    return {
        "__init__.py": "",
        "test_functions.py": _functions(specification),
        "test_closed_forms.py": _closed_forms(specification),
        "test_schemes.py": _schemes(specification),
        "test_symbols.py": _symbols(specification),
        "test_cases.py": _cases(specification),
    }


def _file(title: str, imports: Iterable[str], tests: Iterable[str]) -> str:
    return "\n\n".join([HEADER.format(title=title, imports="\n".join(imports)), *tests])


def _says(text: str) -> str:
    return "\n".join(docstring([text]))


def _functions(specification: Specification) -> str:
    modules = functions_by_module(specification)
    names = ", ".join(sorted(modules))
    imports = [
        "from hypothesis import given",
        f"from tamias2d.generated import {names}",
        "from tests.support import Value, agrees, values",
    ]
    tests = [_function(module, f) for module, made in modules.items() for f in made]
    return _file("Each generated function gives what its equation says.", imports, tests)


def _function(module: str, function: Function) -> str:
    where = {name: plain(tree) for name, tree in function.intermediates}
    drawn = ", ".join(f'{name}=values("{name}")' for name in function.arguments)
    item = function.item
    text = json.dumps(plain(function.expression))
    extra = f", {json.dumps(where)}" if where else ""
    return (
        f"@given({drawn})\n"
        f"def test_{function.name}_is_{item.id.lower()}(**given: Value) -> None:\n"
        f"{_says(f'{item.id}, {item.file}:{item.line}.')}\n"
        f"    agrees({module}.{function.name}, {text}, given{extra})\n"
    )


def _closed_forms(specification: Specification) -> str:
    items = [item for item in specification.of_kind("model") if "closed_form" in item.data]
    imports = [
        "from hypothesis import given",
        f"from tamias2d.generated import {', '.join(sorted(map(module_of, items)))}",
        "from tests.support import Value, close, only, solve, values",
    ]
    return _file(
        "Each closed form agrees with scipy's solution.", imports, map(_closed_form, items)
    )


def _closed_form(item: Item) -> str:
    arguments: dict[str, None] = {}
    states = item.data["states"]
    for state in states:
        arguments |= dict.fromkeys(item.data["arguments"][state])
    drawn = ", ".join(f'{name}=values("{name}")' for name in arguments)
    lines = [
        f"@given({drawn})",
        f"def test_{item.id.lower()}_closed_form_solves_its_equations(**given: Value) -> None:",
        _says(f"{item.id}, {item.file}:{item.line}."),
        f"    solution = solve({json.dumps(states)}, given)",
    ]
    for state in states:
        call = f"{module_of(item)}.{state}(**only(given, {module_of(item)}.{state}))"
        lines.append(f'    close({call}, solution["{state}"])')
    return "\n".join(lines) + "\n"


def _schemes(specification: Specification) -> str:
    items = specification.of_kind("scheme")
    imports = [
        "import pytest",
        "from tamias2d.generated import schemes",
        "from tests.support import (",
        "    observed_order, observed_order_of_levels, observed_order_under_drag,",
        ")",
    ]
    return _file(
        "Each scheme converges with the order that it claims.", imports, map(_scheme, items)
    )


def _scheme(item: Item) -> str:
    kinds = {"two_level": "_of_levels", "exponential": "_under_drag"}
    kind = kinds.get(item.data["family"], "")
    order = item.data["order"]
    given = ", ".join([f"schemes.{item.id}", *_LONG.get(int(order), ())])
    return (
        f"def test_{item.id}_has_order_{order}() -> None:\n"
        f"{_says(f'{item.file}:{item.line}.')}\n"
        f"    found = observed_order{kind}({given})\n"
        f"    assert found == pytest.approx({order}, abs=0.1)\n"
    )


def _symbols(specification: Specification) -> str:
    symbols = [s for s in specification.table.symbols.values() if s.range.text]
    imports = ["from math import inf, nan", "from tamias2d.generated.symbols import SYMBOLS"]
    return _file(
        "Each symbol admits the values of its range and no others.", imports, map(_symbol, symbols)
    )


def _symbol(symbol: Symbol) -> str:
    limits = symbol.range
    inside: list[str] = []
    outside = ["inf", "-inf", "nan"]
    for bound, is_open, away in (
        (limits.low, limits.low_open, -math.inf),
        (limits.high, limits.high_open, math.inf),
    ):
        if math.isfinite(bound):
            (outside if is_open else inside).append(repr(bound))
            outside.append(repr(math.nextafter(bound, away)))
            inside.append(repr(math.nextafter(bound, -away)))
    return (
        f"def test_range_of_{symbol.name}() -> None:\n"
        f"{_says(f'{symbol.file}:{symbol.line}: {limits.text}.')}\n"
        f'    symbol = SYMBOLS["{symbol.name}"]\n'
        f"    assert all(symbol.admits(value) for value in ({', '.join(inside)},))\n"
        f"    assert not any(symbol.admits(value) for value in ({', '.join(outside)}))\n"
    )


def _cases(specification: Specification) -> str:
    imports = ["from tests.support import passes"]
    return _file(
        "Each case of the specification passes.", imports, map(_case, specification.of_kind("case"))
    )


def _case(item: Item) -> str:
    words = re.sub(r"[^a-z0-9]+", "_", item.title.lower()).strip("_")
    verified = ", ".join(item.data["verifies"])
    head = f"{item.id}, {item.file}:{item.line}; verifies {verified or 'no requirement'}."
    text = textwrap.shorten(head, 90)
    name = f"test_{item.id.lower()}_{words}"
    return f'def {name}() -> None:\n{_says(text)}\n    passes("{item.id}")\n'
