"""Programs of rows find what the expressions themselves say, and stop where they are told to."""

import math
from typing import Any

import pytest

from tamias2d.engine.joints.equation import result
from tamias2d.scene.joint_equation import equation_rows, read_equations
from tamias2d.spec import straight_line
from tamias2d.spec.constraint import ENDS
from tamias2d.spec.row_program import INPUTS, SLOPES, TIME_SLOPE, VALUE, RowProgram

EQUATIONS = [
    "y(position_a)*1[m] - x(position_a)**2",
    "point_b - point_a",
    "norm(point_b - point_a) - 2[m]",
    "dot(point_a - position_c, perp(point_b - position_c))/1[m] - 0.3[m]*sin(2[rad/s]*time)",
    "cross(position_a - position_b, rotate(vector(1[m], 2[m]), orientation_b))/1[m]",
    "x(cross(orientation_a, position_b - position_a)) + exp(-orientation_b)*1[m]",
    "atan2(y(position_b), x(position_b)) - tan(orientation_a/7)",
    "sqrt(x(position_b)/1[m]) + log(y(position_b)/1[m])",
    "(x(position_a)**3/1[m^2]) / norm(position_c)**2 * 1[m^2] + pi*1[m]*cos(3*orientation_c)",
    "(x(position_b)/1[m])**1.5 + (y(position_b)/1[m])**-2",
]
PLACES: dict[str, Any] = {
    "position_a": (0.3, -0.7),
    "position_b": (1.9, 0.8),
    "position_c": (-0.4, 2.1),
    "orientation_a": 0.9,
    "orientation_b": -2.3,
    "orientation_c": 0.2,
    "anchor_a": (0.1, 0.2),
    "anchor_b": (-0.3, 0.4),
    "anchor_c": (0.0, 0.5),
    "time": 1.7,
}


def outputs(program: RowProgram, part: int, places: dict[str, Any]) -> list[float]:
    """Run a program up to its value (0), its slopes (1) or its bends (2)."""
    given = dict(places)
    for name, value in places.items():
        if isinstance(value, tuple):
            given[f"{name}_x"], given[f"{name}_y"] = value
    for end in ENDS:
        given[f"cosine_{end}"] = math.cos(places[f"orientation_{end}"])
        given[f"sine_{end}"] = math.sin(places[f"orientation_{end}"])
    scalars = [given[name] for name in INPUTS] + list(program.constants)
    for k, (does, one, other) in enumerate(program.operations[: program.counts[part]]):
        scalars[len(INPUTS) + k] = result(does, scalars[one], scalars[other])
    return [scalars[output] for output in program.outputs]


def same(found: float) -> Any:
    return pytest.approx(found, rel=1e-14, abs=1e-14)  # other orders of a few sums and products


@pytest.mark.parametrize("text", EQUATIONS)
def test_programs_find_values_and_slopes(text: str) -> None:
    functions, programs = read_equations([text], "a joint"), equation_rows((text,))
    assert programs is not None
    rows = functions.constraint(PLACES)
    slopes = {end: formula(PLACES) for end, formula in functions.slopes.items()}
    for k, (row, program) in enumerate(zip(rows, programs, strict=True)):
        assert outputs(program, 0, PLACES)[VALUE] == same(row)
        found = outputs(program, 1, PLACES)
        for n, end in enumerate(ENDS):
            expected = slopes[end][3 * k : 3 * k + 3] if end in slopes else (0.0, 0.0, 0.0)
            assert found[SLOPES + 3 * n : SLOPES + 3 * n + 3] == same(list(expected))


@pytest.mark.parametrize("text", EQUATIONS)
def test_bends_and_slopes_in_time_are_those_of_differences(text: str) -> None:
    step = 1e-4
    for program in equation_rows((text,)) or ():
        bends = outputs(program, 2, PLACES)[TIME_SLOPE:]
        for n, name in enumerate(("time", *(f"orientation_{end}" for end in ENDS))):
            near = [
                outputs(program, 0, PLACES | {name: PLACES[name] + by})[VALUE]
                for by in (-step, 0.0, step)
            ]
            first, second = (near[2] - near[0]) / (2 * step), near[0] - 2 * near[1] + near[2]
            by_differences = first if name == "time" else second / step**2
            assert bends[n] == pytest.approx(by_differences, abs=1e-6)  # step squared, rounding


def test_what_is_written_twice_is_computed_once() -> None:
    one = equation_rows(("sin(x(position_a)/1[m])*1[m]",))
    twice = equation_rows(("sin(x(position_a)/1[m])*1[m] + sin(x(position_a)/1[m])*1[m]",))
    assert one is not None
    assert twice is not None
    assert twice[0].counts[0] == one[0].counts[0] + 1


def test_programs_say_whether_time_drives_them() -> None:
    for text, timed in (("x(position_a)", False), ("x(position_a) - 1[m/s]*time", True)):
        (program,) = equation_rows((text,)) or ()
        assert program.timed is timed


@pytest.mark.parametrize(
    ("does", "a", "b"),
    [("DIVIDE", 1.0, 0.0), ("SQRT", -1.0, 0.0), ("LOG", 0.0, 0.0), ("SIN", math.inf, 0.0)],
)
def test_what_has_no_value_is_no_number(does: str, a: float, b: float) -> None:
    assert math.isnan(result(getattr(straight_line, does), a, b))


@pytest.mark.parametrize(
    ("text", "free"),
    [
        ("norm(point_b - point_a) - 2[m]", True),
        ("orientation_b - 2*orientation_a", False),
        ("orientation_b - orientation_a - sin(2[rad/s]*time)", True),
        ("dot(rotate(vector(1, 0), orientation_a), point_b - point_a)", True),
        ("cross(position_b - position_a, position_c - position_a)/1[m]", True),
        ("x(point_b - point_a)", False),
        ("y(position_a)*1[m] - x(position_a)**2", False),
        ("y(position_a) + y(position_b)", False),
        ("norm(position_a) - norm(position_b)", False),
        ("sqrt(y(position_a)/1[m] - 100)", False),
    ],
)
def test_programs_say_whether_something_else_bears_them(text: str, free: bool) -> None:
    """One that is not changed as its bodies are moved and turned as one keeps their momenta."""
    (program,) = equation_rows((text,)) or ()
    assert program.free is free


@pytest.mark.parametrize(
    ("texts", "free"),
    [
        (("x(point_b - point_a)", "y(point_b - point_a)"), True),  # a hinge
        (("x(point_b - point_a)", "y(point_b - point_a)", "orientation_b - orientation_a"), True),
        (("x(point_b - point_a) - 1[m]", "y(point_b - point_a)"), False),  # keeps a direction
        (("x(point_b - point_a)", "y(point_b) - 1[m]"), False),
    ],
)
def test_rows_are_looked_at_where_all_of_them_hold(texts: tuple[str, ...], free: bool) -> None:
    assert all(program.free for program in equation_rows(texts) or ()) is free


def test_what_overflows_where_it_is_tried_says_nothing(capfd: pytest.CaptureFixture[str]) -> None:
    assert equation_rows(("(1e200*x(position_a)/1[m])**2 - (1e200*y(position_a)/1[m])**2",))
    assert capfd.readouterr() == ("", "")  # LAPACK itself writes of what is not finite
