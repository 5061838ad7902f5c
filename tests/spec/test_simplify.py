"""Sums, products and derivatives of expressions end, keep the value, and settle."""

import math
from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given, settings, strategies as st

from tamias2d.spec import simplify
from tamias2d.spec.derivative import differentiate
from tamias2d.spec.evaluate import evaluate
from tamias2d.spec.expression import ARITY, Binary, Call, Name, Negative, Node, Number, Power

SCALARS, VECTORS = ("s", "t"), ("p", "q")
PLACES: list[dict[str, Any]] = [
    {"s": 0.37, "t": -0.81, "p": (0.63, -0.29), "q": (-0.47, 0.91)},
    {"s": -1.13, "t": 0.59, "p": (-0.17, 0.77), "q": (0.41, 0.23)},
]
OF_SCALARS = ("sin", "cos", "tan", "exp", "abs", "phi1", "phi2")
OF_TWO = ("min", "max", "atan2")
UNTRIED = {"d", "integral", "sum", "sqrt", "log"}
"""What has no value at an instant, or none everywhere: roots are tried as powers."""
KINKED = ("min", "max", "abs")

Trees = st.SearchStrategy[Node]


def calls(functions: tuple[str, ...], *parts: Trees) -> Trees:
    return st.builds(Call, st.sampled_from(functions), st.tuples(*parts))


def binary(signs: str, left: Trees, right: Trees) -> Trees:
    return st.builds(Binary, st.sampled_from(signs), left, right)


numbers = st.builds(Number, st.sampled_from([Fraction(k, 2) for k in (-4, -2, -1, 0, 1, 2, 3)]))
powers = st.sampled_from([Fraction(2), Fraction(3), Fraction(-1)])
scalars: Trees = st.deferred(
    lambda: st.one_of(
        numbers,
        st.builds(Name, st.sampled_from(SCALARS)),
        st.builds(Negative, scalars),
        binary("+-*/", scalars, scalars),
        st.builds(Power, scalars, powers),
        calls(OF_SCALARS, scalars),
        calls(OF_TWO, scalars, scalars),
        calls(("x", "y", "norm"), vectors),
        calls(("dot", "cross"), vectors, vectors),
    )
)
vectors: Trees = st.deferred(
    lambda: st.one_of(
        st.builds(Name, st.sampled_from(VECTORS)),
        calls(("vector",), scalars, scalars),
        st.builds(Negative, vectors),
        binary("+-", vectors, vectors),
        binary("*", scalars, vectors),
        binary("*/", vectors, scalars),
        calls(("perp",), vectors),
        calls(("cross",), scalars, vectors),
        calls(("rotate",), vectors, scalars),
    )
)


def simplified(node: Node) -> Node:
    """Return a tree that is built again, from below, without what adds nothing."""
    match node:
        case Negative(operand=operand):
            return simplify.negative(simplified(operand))
        case Binary(operator=sign, left=left, right=right):
            build = {
                "+": simplify.added,
                "-": simplify.subtracted,
                "*": simplify.times,
                "/": simplify.over,
            }
            return build[sign](simplified(left), simplified(right))
        case Power(base=base, exponent=exponent):
            return simplify.power(simplified(base), exponent)
        case Call(function="x" | "y" | "dot" | "cross" | "perp" | "vector" as function):
            return simplify.call(function, *map(simplified, node.arguments))
        case Call(function="norm" | "rotate"):
            parts = tuple(map(simplified, node.arguments))
            return simplify.ZERO if simplify.is_zero(parts[0]) else Call(node.function, parts)
        case Call(function=function, arguments=arguments):
            return Call(function, tuple(map(simplified, arguments)))
    return node


def value(node: Node, place: dict[str, Any]) -> float:
    """Return the value of a tree; nan where it has none, or none that float64 holds well."""
    try:
        found = float(evaluate(node, place))
    except (ArithmeticError, ValueError):
        return math.nan
    return found if abs(found) < 1e6 else math.nan


def test_every_function_is_tried() -> None:
    tried = {*OF_SCALARS, *OF_TWO, "x", "y", "norm", "dot", "cross", "perp", "rotate", "vector"}
    assert tried | UNTRIED == set(ARITY)


@settings(max_examples=150, deadline=None)
@given(scalars)
def test_what_adds_nothing_is_left_out_and_the_value_stays(tree: Node) -> None:
    once = simplified(tree)
    for place in PLACES:
        if not math.isnan(before := value(tree, place)):
            assert value(once, place) == pytest.approx(before, rel=1e-6, abs=1e-6)


@settings(max_examples=150, deadline=None)
@given(scalars)
def test_what_is_simple_settles(tree: Node) -> None:
    found = [simplified(tree)]
    while (again := simplified(found[-1])) not in found:
        found.append(again)
    assert again == found[-1]
    assert len(found) < 5


@settings(max_examples=150, deadline=None)
@given(scalars)
def test_derivatives_are_the_slopes_of_values(tree: Node) -> None:
    try:
        slope = differentiate(tree, "s")
    except ValueError as error:
        assert any(f"{name} has no derivative" in str(error) for name in KINKED)
        return
    for place in PLACES:
        step = 1e-5
        ends = [{**place, "s": place["s"] + by} for by in (-step, step, -2 * step, 2 * step)]
        low, high, lowest, highest = (value(tree, end) for end in ends)
        near, far = (high - low) / (2 * step), (highest - lowest) / (4 * step)
        if abs(near - far) <= 1e-6 * (1 + abs(near)):  # also where a value is none
            assert value(slope, place) == pytest.approx(near, rel=1e-4, abs=1e-4)
