"""A printed function gives what the expression of its chapter gives.

This judges the printer. The equations themselves are judged by derivations, closed forms and cases.
"""

from importlib import import_module
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings, strategies as st

from tamias2d.spec.equations import Function
from tamias2d.spec.reader import read
from tests.support import agrees, values
from tools.emit_functions import functions_by_module

FUNCTIONS = [
    pytest.param(module, function, id=f"{function.item.id}-{module}.{function.name}")
    for module, made in functions_by_module(read(Path(__file__).parents[2] / "srs")).items()
    for function in made
]


@pytest.mark.parametrize(("module", "function"), FUNCTIONS)
@settings(suppress_health_check=[HealthCheck.filter_too_much])
@given(data=st.data())
def test_a_function_gives_what_its_equation_says(
    module: str, function: Function, data: st.DataObject
) -> None:
    drawn = {name: data.draw(values(name), name) for name in function.arguments}
    printed = getattr(import_module(f"tamias2d.generated.{module}"), function.name)
    agrees(printed, function.expression, drawn, dict(function.intermediates))
