"""Bodies that are added while a simulator runs, from arrays of arguments (R2, R3, R4)."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from tamias2d.engine.batch import UNSTATED, Batch
from tamias2d.engine.tables import DYNAMIC, KINEMATIC, STATIC
from tamias2d.scene.checks import checked_inertia, refuse_shape, remedy_of_inertia
from tamias2d.scene.compound import Shape
from tamias2d.scene.filters import ALL, checked_sensor, checked_whole
from tamias2d.scene.rules import RuleError, sequence
from tamias2d.scene.shapes import HalfPlane
from tamias2d.simulator.batch import drag_rates
from tamias2d.simulator.columns import (
    Column,
    as_array,
    column,
    is_finite,
    numbers,
    plain_pair,
    table,
    two_columns,
    whole_column,
)
from tamias2d.state import Array, IntArray

Shapes = Shape | None | Sequence[Shape | None]
_OF = {STATIC: "the static bodies", KINEMATIC: "the kinematic bodies", DYNAMIC: "the bodies"}
DRAGS = {
    "linear_drag": "Give it in kg/s, 0 for none.",
    "angular_drag": "Give it in kg m^2/s, 0 for none.",
}
_NUMBERS = {
    "orientation": "Give it in rad.",
    "angular_velocity": "Give it in rad/s.",
    "torque": "Give it in N m.",
    **DRAGS,
}
_VECTORS = {
    "position": "Give (x, y) in m.",
    "velocity": "Give (x, y) in m/s.",
    "force": "Give (x, y) in N.",
}
SURFACE = {
    "friction": "Give a number such as 0.5, or 0 for a smooth surface.",
    "restitution": "Give a number from 0 to 1.",
}


def added_batch(kind: int, shapes: object, **given: Any) -> Batch:
    """Return the batch of bodies of one kind; `position` or the shapes tell how many there are.

    Raises:
        InputError: a value breaks a rule; the message names it, and its place in its array.
    """
    of = f"{_OF[kind]} added"
    known = _counted(shapes, given["position"], of)
    count = len(known)
    for shape in {id(shape): shape for shape in known}.values():  # none may have a hash yet
        refuse_shape(shape, of, static=kind == STATIC, told=kind == KINEMATIC, none=kind == DYNAMIC)
    _refuse_placed(known, given)
    many = {
        key: column(given[key], key, of, remedy, count=count, symbol=key) if key in given else 0.0
        for key, remedy in _NUMBERS.items()
    }
    pairs = {
        key: two_columns(given[key], key, of, remedy, count=count, symbol=key)
        if key in given
        else (0.0, 0.0)
        for key, remedy in _VECTORS.items()
    }
    mass: Column = _mass(given["mass"], of, count) if kind == DYNAMIC else math.inf
    inertia = _inertias(known, mass, given, of) if kind == DYNAMIC else math.inf
    if kind == DYNAMIC:
        _refuse_turned(many, inertia, of)
    columns = (
        *(*pairs["position"], many["orientation"]),
        *(*pairs["velocity"], many["angular_velocity"]),
        *(*pairs["force"], many["torque"]),
        *(mass, inertia),
        *drag_rates(many["linear_drag"], mass, many["angular_drag"], inertia),
        *(_surface(given.get(key), key, of, count) for key in SURFACE),
    )
    return Batch(table(columns, count), _wholes(kind, given, of, count), known)


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
    single = shapes is None or not isinstance(shapes, Sequence | np.ndarray)
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


def _refuse_placed(shapes: Sequence[Shape | None], given: dict[str, Any]) -> None:
    if not any(isinstance(shape, HalfPlane) for shape in shapes):
        return
    if np.any(given["position"]) or np.any(given.get("orientation", 0.0)):
        raise RuleError(
            "position of the static bodies added: a half-plane has none (R4). Say where it is by "
            "its normal and offset.",
            "position",
        )


def masses(value: object, of: str, count: int) -> Array:
    """Return the masses of so many bodies, kg, or raise `RuleError`."""
    return np.full(count, _mass(value, of, count))


def _mass(value: object, of: str, count: int) -> Column:
    remedy = "Give a positive mass in kg, or add the body as a static one."
    mass = column(value, "mass", of, remedy, count=count, symbol="mass")
    refuse_tiny(mass, "mass", of)
    return mass


def stated_inertias(value: object, of: str, count: int) -> Array:
    """Return the inertias that are stated of so many bodies, kg m^2, or raise `RuleError`."""
    remedy = remedy_of_inertia(value)
    inertia = numbers(value, "inertia", of, remedy, count=count, symbol="inertia")
    refuse_tiny(inertia, "inertia", of)
    return inertia


def _inertias(
    shapes: Sequence[Shape | None], mass: Column, given: dict[str, Any], of: str
) -> Column:
    if given["inertia"] is not None:
        return stated_inertias(given["inertia"], of, len(shapes))
    if isinstance(mass, float) and len(shapes) == 1:
        return checked_inertia(None, mass, shapes[0], of)
    each = np.full(len(shapes), mass).tolist()
    found: dict[tuple[Shape | None, float], float] = {}
    for key in zip(shapes, each, strict=True):
        if key not in found:
            found[key] = checked_inertia(None, key[1], key[0], of)
    return np.array([found[key] for key in zip(shapes, each, strict=True)])


def refuse_tiny(values: Column, key: str, of: str) -> None:
    """Refuse masses or inertias whose inverses float64 cannot hold."""
    with np.errstate(all="ignore"):
        inverse = 1 / values
    if not is_finite(inverse):
        k = int(np.argmin(np.isfinite(inverse)))
        raise RuleError(
            f"{key}[{k}] {np.atleast_1d(values)[k]:g} of {of}: float64 cannot hold its inverse "
            "(R4). Choose units in which it is nearer to 1.",
            key,
            k,
        )


def _refuse_turned(many: dict[str, Column], inertia: Column, of: str) -> None:
    """Refuse a torque or spin where nothing says the inertia."""
    if is_finite(inertia):
        return
    for key in ("torque", "angular_velocity"):
        bad = np.isinf(inertia) & np.not_equal(many[key], 0.0)
        if bad.any():
            raise RuleError(
                f"inertia[{int(np.argmax(bad))}] of {of}: found none, though its {key} is not 0 "
                "(R2, IM2). State the inertia in kg m^2, or give the body a shape.",
                "inertia",
            )


def _surface(value: object, key: str, of: str, count: int) -> Column:
    if value is None:
        return UNSTATED
    return column(value, key, of, SURFACE[key], count=count, symbol=key)


def _wholes(kind: int, given: dict[str, Any], of: str, count: int) -> IntArray:
    """Return the kind and the filters (count, 5)."""
    found = np.empty((count, 5), dtype=np.int64)
    found[:, 0] = kind
    mask = given["mask"]
    for k, (key, value) in enumerate(
        (
            ("category", given["category"]),
            ("mask", ALL if mask is None else mask),
            ("group", given["group"]),
        )
    ):
        found[:, 1 + k] = whole_column(value, key, of, count=count, check=checked_whole)
    found[:, 4] = checked_sensor(given["sensor"], of)
    return found
