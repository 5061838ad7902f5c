"""Which expressions have kinks, worked out by hand."""

import pytest

from tamias2d.spec.expression import parse
from tamias2d.spec.kinks import has_kinks


@pytest.mark.parametrize(
    "text",
    [
        "abs(x(position))",
        "x(position)/sqrt(x(position)**2)",
        "sqrt(sqrt((x(position)-0.3[m])**2))",
        "norm(velocity)*x(velocity)",
        "x(position)/norm(position)",
        "norm(position)**3",
        "(x(position)**2 + y(position)**2)**(1/2)",
        "sin(sqrt(time**2))",
        "1/(2[m]+norm(position))",
        "x(velocity)*dot(velocity, velocity)**(3/2)",
    ],
)
def test_kinks_where_something_comes_to_nothing(text: str) -> None:
    assert has_kinks(parse(text), ("time", "position", "velocity"))


@pytest.mark.parametrize(
    "text",
    [
        "sin(time)*x(position)",
        "x(position)/norm(position)**3",
        "x(position)/(dot(position, position)**(3/2))",
        "x(position)/(mass*norm(position)**2)",
        "x(position)/sqrt(x(position)**2 + y(position)**2 + 1[m]**2)",
        "norm(position)**2",
        "sqrt(mass)*time",
        "abs(mass)",
        "exp(-time)**(1/2)",
        "sqrt(1 + dot(position, position)/(1[m]**2))",
    ],
)
def test_no_kinks_where_nothing_passes_or_nothing_is_rooted(text: str) -> None:
    assert not has_kinks(parse(text), ("time", "position", "velocity"))
