"""Which equations are known but for whole turns, and what is left of them."""

import math

import pytest

from tamias2d.spec.evaluate import evaluate
from tamias2d.spec.expression import parse
from tamias2d.spec.symbols import Symbol, SymbolTable
from tamias2d.spec.whole_turns import without_turns

TABLE = SymbolTable(
    [Symbol(name, unit, name, "scalar") for name, unit in (("x", "m"), ("s", "1"))], []
)
DIRECTION = "atan2(x, 1[m])"


@pytest.mark.parametrize(
    ("text", "turn"),
    [
        (f"{DIRECTION} - s", math.tau),
        (f"2*{DIRECTION} - 6*atan2(s, 2) + s", 2 * math.tau),
        (f"x - {DIRECTION}*0.5[m]", math.pi),
        (f"s - {DIRECTION}*180/pi", 360.0),
    ],
)
def test_what_is_linear_in_a_direction_is_left_to_half_a_jump(text: str, turn: float) -> None:
    tree = parse(text)
    for s in (-50.0, -3.0, 0.2, 7.0):
        place = {"x": 0.3 * s, "s": s}
        before, after = evaluate(tree, place), evaluate(without_turns(tree, TABLE), place)
        assert abs(after) <= turn / 2
        turns = (before - after) / turn
        assert turns == pytest.approx(round(turns), abs=1e-9)


@pytest.mark.parametrize(
    "text",
    [
        "x - 1[m]",
        f"{DIRECTION}**2 - 1",
        f"s*{DIRECTION} - 1",
        f"sin({DIRECTION}) - 1",
        f"2*{DIRECTION} - 3*atan2(s, 2)",
        f"min({DIRECTION}, 1)",
    ],
)
def test_all_else_stays_as_it_is(text: str) -> None:
    assert without_turns(parse(text), TABLE) == parse(text)
