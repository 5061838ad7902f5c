"""Bodies that are added while a simulator runs, from arrays of arguments (R2, R3, R4)."""

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
from tamias2d.simulator.columns import as_array, numbers, vectors, wholes
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
        key: numbers(given.get(key, 0.0), key, of, remedy, count=count, symbol=key)
        for key, remedy in _NUMBERS.items()
    }
    pairs = {
        key: vectors(given.get(key, (0.0, 0.0)), key, of, remedy, count=count, symbol=key)
        for key, remedy in _VECTORS.items()
    }
    mass = masses(given["mass"], of, count) if kind == DYNAMIC else np.full(count, np.inf)
    inertia = _inertias(known, mass, given, of) if kind == DYNAMIC else np.full(count, np.inf)
    _refuse_turned(many, inertia, of, kind)
    return Batch(
        kind=np.full(count, kind),
        pose=np.column_stack((pairs["position"], many["orientation"])),
        motion=np.column_stack((pairs["velocity"], many["angular_velocity"])),
        load=np.column_stack((pairs["force"], many["torque"])),
        mass=mass,
        inertia=inertia,
        drag_rates=drag_rates(many["linear_drag"], mass, many["angular_drag"], inertia),
        filters=_filters(given, of, count),
        shapes=known,
        **{key: _surface(given.get(key), key, of, count) for key in SURFACE},
    )


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
    place = as_array(position, "position", of, _VECTORS["position"])
    single = shapes is None or not isinstance(shapes, Sequence | np.ndarray)
    listed: Any = (shapes,) if single else sequence(shapes, of, "Give shapes.", at=("shape",))
    rows = place.shape[0] if place.ndim == 2 else None
    if single:
        return tuple(listed) * (1 if rows is None else rows)
    if rows is not None and rows != len(listed):
        raise RuleError(
            f"position of {of}: found {rows} rows beside {len(listed)} shapes: must be as many "
            "(R4). Give one shape, or one for each row.",
            "position",
        )
    return tuple(listed)


def _refuse_placed(shapes: Sequence[Shape | None], given: dict[str, Any]) -> None:
    placed = np.any(given["position"]) or np.any(given.get("orientation", 0.0))
    if placed and any(isinstance(shape, HalfPlane) for shape in shapes):
        raise RuleError(
            "position of the static bodies added: a half-plane has none (R4). Say where it is by "
            "its normal and offset.",
            "position",
        )


def masses(value: object, of: str, count: int) -> Array:
    """Return the masses of so many bodies, kg, or raise `RuleError`."""
    remedy = "Give a positive mass in kg, or add the body as a static one."
    mass = numbers(value, "mass", of, remedy, count=count, symbol="mass")
    refuse_tiny(mass, "mass", of)
    return mass


def stated_inertias(value: object, of: str, count: int) -> Array:
    """Return the inertias that are stated of so many bodies, kg m^2, or raise `RuleError`."""
    remedy = remedy_of_inertia(value)
    inertia = numbers(value, "inertia", of, remedy, count=count, symbol="inertia")
    refuse_tiny(inertia, "inertia", of)
    return inertia


def _inertias(shapes: Sequence[Shape | None], mass: Array, given: dict[str, Any], of: str) -> Array:
    if given.get("inertia") is not None:
        return stated_inertias(given["inertia"], of, len(mass))
    found: dict[tuple[Shape | None, float], float] = {}
    for key in zip(shapes, mass.tolist(), strict=True):
        if key not in found:
            found[key] = checked_inertia(None, key[1], key[0], of)
    return np.array([found[key] for key in zip(shapes, mass.tolist(), strict=True)])


def refuse_tiny(values: Array, key: str, of: str) -> None:
    """Refuse masses or inertias whose inverses float64 cannot hold."""
    with np.errstate(all="ignore"):
        bad = ~np.isfinite(1 / values)
    if bad.any():
        k = int(np.argmax(bad))
        raise RuleError(
            f"{key}[{k}] {values[k]:g} of {of}: float64 cannot hold its inverse (R4). Choose units "
            "in which it is nearer to 1.",
            key,
            k,
        )


def _refuse_turned(many: dict[str, Array], inertia: Array, of: str, kind: int) -> None:
    """Refuse a torque or spin where nothing says the inertia."""
    for key in ("torque", "angular_velocity"):
        bad = np.isinf(inertia) & (many[key] != 0.0)
        if kind == DYNAMIC and bad.any():
            raise RuleError(
                f"inertia[{int(np.argmax(bad))}] of {of}: found none, though its {key} is not 0 "
                "(R2, IM2). State the inertia in kg m^2, or give the body a shape.",
                "inertia",
            )


def _surface(value: object, key: str, of: str, count: int) -> Array:
    if value is None:
        return np.full(count, UNSTATED)
    return numbers(value, key, of, SURFACE[key], count=count, symbol=key)


def _filters(given: dict[str, Any], of: str, count: int) -> IntArray:
    columns = [
        wholes(value, key, of, count=count, check=checked_whole)
        for key, value in (
            ("category", given.get("category", 1)),
            ("mask", ALL if given.get("mask") is None else given["mask"]),
            ("group", given.get("group", 0)),
        )
    ]
    sensor = checked_sensor(given.get("sensor", False), of)
    return np.column_stack((*columns, np.full(count, int(sensor))))
