"""Generated tests: closed forms against scipy, schemes against their order, and laws in crowds.

Tests that only repeat a loop over the specification are parametrised by it, in tests/.
"""

import json
from collections.abc import Iterable

from tamias2d.spec.chapter import Item
from tamias2d.spec.constraint import COORDINATES, ENDS
from tamias2d.spec.equations import module_of
from tamias2d.spec.specification import Specification
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
        "test_closed_forms.py": _closed_forms(specification),
        "test_constraints.py": _constraints(specification),
        "test_laws.py": _laws(specification),
        "test_schemes.py": _schemes(specification),
    }


def _file(title: str, imports: Iterable[str], tests: Iterable[str]) -> str:
    return "\n\n".join([HEADER.format(title=title, imports="\n".join(imports)), *tests])


def _says(text: str) -> str:
    return "\n".join(docstring([text]))


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


def _constraints(specification: Specification) -> str:
    items = specification.of_kind("constraint")
    imports = [
        "from hypothesis import given",
        "from tamias2d.generated.constraints import CONSTRAINTS",
        "from tests.support import Value, follows, values",
    ]
    title = "Slopes, rate and convective part of each constraint follow from its equation."
    return _file(title, imports, map(_constraint, items))


def _constraint(item: Item) -> str:
    names = dict.fromkeys(item.data["parameters"])
    places = [f"{name}_{end}" for end in ENDS for pair in COORDINATES.items() for name in pair]
    names |= dict.fromkeys(places)
    drawn = "\n".join(f'    {name}=values("{name}"),' for name in names)
    return (
        f"@given(\n{drawn}\n)\n"
        f"def test_{item.id}_follows_from_its_equation(**given: Value) -> None:\n"
        f"{_says(f'{item.file}:{item.line}.')}\n"
        f'    follows(CONSTRAINTS["{item.id}"], given)\n'
    )


def _laws(specification: Specification) -> str:
    items = [item for item in specification.of_kind("property") if "crowd" in item.data]
    imports = ["import pytest", "from tests.crowd_laws import SEEDS, holds"]
    return _file("Each law holds in every step of random crowds.", imports, map(_law, items))


def _law(item: Item) -> str:
    crowd = item.data["crowd"]
    conditions = {
        "steady": "bodies" in crowd,
        "at_most": "relation" in crowd,
    }
    given = ", ".join(f"{name}={value}" for name, value in conditions.items())
    equation = " ".join(item.data["equation"].split())
    return (
        '@pytest.mark.parametrize("seed", SEEDS)\n'
        f"def test_{item.id.lower()}_holds_in_a_crowd(seed: int) -> None:\n"
        f"{_says(f'{item.id}, {item.file}:{item.line}.')}\n"
        f"    law = {json.dumps(equation)}\n"
        f"    holds(law, seed, within={crowd['within']}, {given})\n"
    )


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
