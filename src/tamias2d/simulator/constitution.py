"""What bodies are, wherever they are: masses, inertias, drag, surface and filters (R2, R3, R4).

Bodies that come and go in a game are alike: what plain numbers say of a shape is judged once.
"""

import math
from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from tamias2d.engine.shapes.stated_surfaces import UNSTATED
from tamias2d.engine.tables import DYNAMIC
from tamias2d.scene.checks import REMEDY_OF_INERTIA, REMEDY_OF_SURFACE_SPEED, checked_inertia
from tamias2d.scene.compound import Shape
from tamias2d.scene.filters import ALL, checked_sensor, checked_whole
from tamias2d.scene.rules import RuleError
from tamias2d.simulator.batch import drag_rates
from tamias2d.simulator.columns import (
    Column,
    WholeColumn,
    as_array,
    column,
    is_finite,
    numbers,
    whole_column,
)
from tamias2d.state import Array

DRAGS = {
    "linear_drag": "Give it in kg/s, 0 for none.",
    "angular_drag": "Give it in kg m^2/s, 0 for none.",
}
SURFACE = {
    "friction": "Give a number such as 0.5, or 0 for a smooth surface.",
    "restitution": "Give a number from 0 to 1.",
    "surface_speed": REMEDY_OF_SURFACE_SPEED,
}
_LEFT_OUT: dict[str, Any] = {
    "mass": None,
    "inertia": None,
    "linear_drag": 0.0,
    "angular_drag": 0.0,
    "friction": None,
    "restitution": None,
    "surface_speed": 0.0,
    "category": 1,
    "mask": None,
    "group": 0,
    "sensor": False,
}
_PLAIN = {float, int, bool, type(None), np.float64}
_KEPT = 256


class Constitution(NamedTuple):
    """What k bodies are, as columns of a `Batch`."""

    numbers: tuple[Column, ...]
    """seven: mass, inertia, rates of drag, friction, restitution and surface speed"""
    wholes: tuple[WholeColumn, ...]
    """five: kind and filters"""

    @property
    def inertia(self) -> Column:
        """kg m^2, infinite where nothing turns a body."""
        return self.numbers[1]


def constitution(
    kind: int, shapes: Sequence[Shape | None], given: Mapping[str, Any], of: str
) -> Constitution:
    """Return what bodies of one kind are, from their shapes and the arguments of a call.

    Raises:
        InputError: a value breaks a rule (R4).
    """
    said = [given.get(key, left_out) for key, left_out in _LEFT_OUT.items()]
    if _PLAIN.issuperset(map(type, said)) and len(set(map(id, shapes))) == 1:
        return _of_plain(kind, shapes[0], of, *said)
    return _constitution(kind, shapes, of, dict(zip(_LEFT_OUT, said, strict=True)))


@lru_cache(_KEPT, typed=True)
def _of_plain(kind: int, shape: Shape | None, of: str, *said: object) -> Constitution:
    """Return what bodies of one shape are, of which all is said by plain numbers."""
    return _constitution(kind, (shape,), of, dict(zip(_LEFT_OUT, said, strict=True)))


def _constitution(
    kind: int, shapes: Sequence[Shape | None], of: str, said: Mapping[str, Any]
) -> Constitution:
    count, dynamic = len(shapes), kind == DYNAMIC
    drags = {
        key: column(said[key], key, of, remedy, count=count, symbol=key)
        for key, remedy in DRAGS.items()
    }
    mass = _mass(said["mass"], of, count) if dynamic else math.inf
    inertia = _inertias(shapes, mass, said["inertia"], of) if dynamic else math.inf
    rates = drag_rates(drags["linear_drag"], mass, drags["angular_drag"], inertia)
    filters = {**said, "mask": ALL if said["mask"] is None else said["mask"]}
    wholes = (
        whole_column(filters[key], key, of, count=count, check=checked_whole)
        for key in ("category", "mask", "group")
    )
    sensor = int(checked_sensor(said["sensor"], of))
    surface = (_surface(said[key], key, of, count) for key in SURFACE)
    return Constitution((mass, inertia, *rates, *surface), (kind, *wholes, sensor))


def masses(value: object, of: str, count: int) -> Array:
    """Return the masses of so many bodies, kg, or raise `RuleError`."""
    return np.full(count, _mass(value, of, count))


def _mass(value: object, of: str, count: int) -> Column:
    remedy = "Give a positive mass in kg, or add the body as a static one."
    mass = column(value, "mass", of, remedy, count=count, symbol="mass")
    refuse_tiny(mass, "mass", of)
    return mass


def stated_inertias(value: object, of: str, count: int) -> Array:
    """Return the inertias that are stated of so many bodies, kg m^2, or raise `RuleError`.

    They are infinite for what nothing turns.
    """
    given = as_array(value, "inertia", of, REMEDY_OF_INERTIA)
    floats = given.dtype.kind == "f"
    endless = np.equal(given, math.inf) if floats else np.zeros(given.shape, dtype=bool)
    finite = np.where(endless, 1.0, given) if endless.any() else value
    inertia = numbers(finite, "inertia", of, REMEDY_OF_INERTIA, count=count, symbol="inertia")
    refuse_tiny(inertia, "inertia", of)
    inertia[np.broadcast_to(endless, inertia.shape)] = math.inf
    return inertia


def _inertias(shapes: Sequence[Shape | None], mass: Column, stated: object, of: str) -> Column:
    if stated is not None:
        return stated_inertias(stated, of, len(shapes))
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


def _surface(value: object, key: str, of: str, count: int) -> Column:
    if value is None:
        return UNSTATED
    return column(value, key, of, SURFACE[key], count=count, symbol=key)
