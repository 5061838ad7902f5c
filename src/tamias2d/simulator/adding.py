"""Bodies that are added while a simulator runs, from arrays of arguments (R2, R3, R4)."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from tamias2d.engine.bodies.batch import Batch
from tamias2d.engine.tables import DYNAMIC, KINEMATIC, STATIC
from tamias2d.scene.checks import SHAPES, fault_of_turning, refuse_shape
from tamias2d.scene.compound import Shape
from tamias2d.scene.rules import RuleError, sequence
from tamias2d.scene.shapes import HalfPlane
from tamias2d.simulator.columns import (
    Column,
    as_array,
    column,
    is_finite,
    plain_pair,
    table,
    two_columns,
    whole_table,
)
from tamias2d.simulator.constitution import constitution

Shapes = Shape | None | Sequence[Shape | None]
_OF = {
    kind: f"the {word}bodies added"
    for kind, word in ((STATIC, "static "), (KINEMATIC, "kinematic "), (DYNAMIC, ""))
}
_NUMBERS = {
    "orientation": "Give it in rad.",
    "angular_velocity": "Give it in rad/s.",
    "torque": "Give it in N m.",
}
_VECTORS = {
    "position": "Give (x, y) in m.",
    "velocity": "Give (x, y) in m/s.",
    "force": "Give (x, y) in N.",
}


def added_batch(kind: int, given: Mapping[str, Any]) -> Batch:
    """Return the batch of bodies of one kind from the arguments of a call, by their names.

    The `position` or the `shape` tells how many there are.

    Raises:
        InputError: a value breaks a rule; the message names it, and its place in its array.
    """
    of = _OF[kind]
    known = _counted(given["shape"], given["position"], of)
    count = len(known)
    for shape in {id(shape): shape for shape in known}.values():  # none may have a hash yet
        refuse_shape(shape, of, static=kind == STATIC, told=kind == KINEMATIC, none=kind == DYNAMIC)
    _refuse_placed(known, given)
    turn, spin, torque = (
        column(given[key], key, of, remedy, count=count, symbol=key) if key in given else 0.0
        for key, remedy in _NUMBERS.items()
    )
    place, velocity, force = (
        two_columns(given[key], key, of, remedy, count=count, symbol=key)
        if key in given
        else (0.0, 0.0)
        for key, remedy in _VECTORS.items()
    )
    are = constitution(kind, known, given, of)
    if kind == DYNAMIC:
        turned = {"torque": torque, "angular_velocity": spin}
        _refuse_turned(turned, are.inertia, of, stated=given.get("inertia") is not None)
    columns = (*place, turn, *velocity, spin, *force, torque, *are.numbers)
    return Batch(table(columns, count), whole_table(are.wholes, count), known)


def listed_shapes(shapes: object, count: int, of: str) -> list[Any]:
    """Return a shape for each of so many bodies: one for all, or a list."""
    if not isinstance(shapes, Sequence | np.ndarray):
        return [shapes] * count
    listed = list(sequence(shapes, of, "Give shapes.", at=("shape",)))
    if len(listed) != count:
        raise RuleError(
            f"shape of {of}: found {len(listed)} for {count} bodies: must be as many (R4). Give "
            "one shape, or one for each body.",
            "shape",
        )
    return listed


def _counted(shapes: object, position: object, of: str) -> tuple[Shape | None, ...]:
    """Return a shape for each body: one for all, as many as there are positions, or a list."""
    rows = count_of(position, of)
    single = isinstance(shapes, SHAPES) or not isinstance(shapes, Sequence | np.ndarray)
    listed: Any = (shapes,) if single else sequence(shapes, of, "Give shapes.", at=("shape",))
    if single:
        return tuple(listed) * (1 if rows is None else rows)
    if rows is not None and rows != len(listed):
        raise RuleError(
            f"position of {of}: found {rows} rows beside {len(listed)} shapes: must be as many "
            "(R4). Give one shape, or one for each row.",
            "position",
        )
    return tuple(listed)


def count_of(position: object, of: str = "the bodies added") -> int | None:
    """Return for how many bodies places are given, or None for one place, or raise `RuleError`."""
    if plain_pair(position) is not None:
        return None
    place = as_array(position, "position", of, _VECTORS["position"])
    return place.shape[0] if place.ndim == 2 else None


def _refuse_placed(shapes: Sequence[Shape | None], given: Mapping[str, Any]) -> None:
    if not any(isinstance(shape, HalfPlane) for shape in shapes):
        return
    if np.any(given["position"]) or np.any(given.get("orientation", 0.0)):
        raise RuleError(
            "position of the static bodies added: a half-plane has none (R4). Say where it is by "
            "its normal and offset.",
            "position",
        )


def _refuse_turned(many: dict[str, Column], inertia: Column, of: str, *, stated: bool) -> None:
    """Refuse a torque or spin where nothing says the inertia, or where that is infinite."""
    if is_finite(inertia):
        return
    for key in ("torque", "angular_velocity"):
        bad = np.isinf(inertia) & np.not_equal(many[key], 0.0)
        if bad.any():
            raise RuleError(
                f"inertia[{int(np.argmax(bad))}] of {of}: {fault_of_turning(key, stated)}",
                "inertia",
            )
