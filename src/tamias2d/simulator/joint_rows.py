"""Joints as rows for the engine (TM7), and what steps do not know of joints (R13)."""

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import Any, cast

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.joint_row import JointRow, LawNumbers
from tamias2d.generated.joint_rows import MOST_ROWS
from tamias2d.scene.freedoms import Freedom
from tamias2d.scene.joint_equation import equation_rows
from tamias2d.scene.joints import Joint
from tamias2d.scene.rules import RuleError
from tamias2d.spec.row_program import RowProgram
from tamias2d.state import IntArray


def refuse_unknown(joints: Iterable[Joint]) -> None:
    """Raise `RuleError` where a joint has what steps do not know."""
    for joint in joints:
        if what := joint.beyond_steps:
            raise RuleError(
                f"joint '{joint.name}' ({joint.kind}): steps know no {what} (R13). Leave it out, "
                "or take simulate(scene, ...) without Stepped(), which knows it.",
                "joints",
            )


def joint_rows(joint: Joint) -> list[JointRow]:
    """Return a joint as the engine takes it: what it keeps, then what governs its freedoms."""
    if programs := equation_rows(joint.equations) if joint.equations else None:
        steepness = joint.steepness
        return [_own(joint, *each) for each in zip(programs, steepness, strict=True)]
    kept = [_row(joint)] if joint.rigid else []
    return [*kept, *(row for each in joint.freedoms for row in _governed(joint, each))]


def row_count(joint: Joint) -> int:
    """Return how many of `joint_rows` a joint has."""
    if joint.equations:
        return len(joint.equations)
    return joint.rigid + sum(1 for each in joint.freedoms for _ in laws_of(each))


def _governed(joint: Joint, freedom: Freedom) -> Iterable[JointRow]:
    for law, at, numbers in laws_of(freedom):
        row = _row(joint.measured(freedom, at), law, numbers)
        yield row._replace(across=freedom.across) if joint.kind == "target" else row


def laws_of(freedom: Freedom) -> Iterable[tuple[int, float, LawNumbers]]:
    """Yield what governs a freedom: each law, the value at which it is measured, its numbers."""
    limits, motor, spring = freedom.limits, freedom.motor, freedom.spring
    bounces = (0.0, 0.0, 0.0, 0.0, limits.restitution if limits else 0.0)
    if limits and limits.lower is not None:
        yield tb.LOWER_LIMIT, limits.lower, bounces
    if limits and limits.upper is not None:
        yield tb.UPPER_LIMIT, limits.upper, bounces
    if motor:
        most = math.inf if motor.maximum is None else motor.maximum
        yield tb.MOTOR, 0.0, (motor.speed, most, 0.0, 0.0, 0.0)
    if spring:
        most = math.inf if spring.maximum is None else spring.maximum
        numbers = (0.0, most, spring.stiffness, spring.damping, 0.0)
        yield tb.SPRING, cast(float, spring.rest), numbers


def rows_by_law(joints: Sequence[Joint]) -> Iterator[tuple[int, int, int, Freedom, float]]:
    """Yield for each row of a law its place among all rows, the number of its joint, and the law.

    Its freedom and the value at which it is measured come last.
    """
    r = 0
    for k, joint in enumerate(joints):
        freedoms = () if joint.equations else joint.freedoms
        laws = [(freedom, *law) for freedom in freedoms for law in laws_of(freedom)]
        r += row_count(joint) - len(laws)
        for freedom, law, value, _ in laws:
            yield r, k, law, freedom, value
            r += 1


def _row(
    joint: Joint,
    law: int = tb.KEPT,
    numbers: LawNumbers = (0.0,) * 5,
) -> JointRow:
    given = joint.given.values()
    parts = [x for value in given for x in (value if isinstance(value, tuple) else (value,))]
    apart = not joint.collide
    return JointRow(joint.model, joint.ends, tuple(map(float, parts)), apart, law, numbers)


def _own(joint: Joint, program: RowProgram, steepness: tuple[float, float]) -> JointRow:
    """Return a row of a joint's own equation."""
    anchors = tuple(float(x) for anchor in joint.anchors for x in anchor)
    apart = not joint.collide
    return JointRow(
        joint.model, joint.ends, anchors, apart, tb.KEPT, (0.0,) * 5, program, steepness
    )


def place_of_row(row: JointRow, rank: IntArray) -> tuple[Any, ...]:
    """Return by what rows are ordered: their bodies in canonical order, then what they are."""
    bodies = [-1 if body is None else int(rank[body]) for body in row.ends]
    return bodies, row.law, row.kind, row.given, row.numbers, row.apart, row.program


def units_of_row(row: JointRow) -> list[str]:
    """Return the units of the rows of a joint, of as many as there may be."""
    return [*row.units, *["1"] * (MOST_ROWS - len(row.units))]
