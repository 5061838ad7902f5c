"""What bodies and their parts state of surfaces, and the friction and restitution that follow (R3).

What a part states counts for it, and else what its body does.
"""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Shapes
from tamias2d.state import Array, IntArray

UNSTATED = -1.0
"""Friction or restitution where a body, or a part of one, states none."""


def as_stated(value: float | None) -> float:
    """Return a friction or restitution as the engine's arrays have it."""
    return UNSTATED if value is None else value


def effective_surfaces(stated: Array) -> Array:
    """Return friction and restitution (m, 2) of shapes by what is stated for them (m, 4)."""
    by_part = stated[:, tb.BY_PART : tb.BY_BODY]
    return np.where(by_part < 0.0, stated[:, tb.BY_BODY :], by_part)


def state_surfaces(
    shapes: Shapes, places: IntArray, columns: Mapping[int, Array], by: int
) -> NDArray[np.bool_]:
    """State columns of the material of shapes (k,), each (k,); return which changed.

    Friction and restitution are stated `by` their parts or by their bodies, of `tables`; a surface
    runs with all of a body.
    """
    table, before = shapes.material, shapes.material[places, : tb.SHAPE_RADIUS]
    for column, values in columns.items():
        if column == tb.SURFACE_SPEED:
            table[places, column] = values
        else:
            shapes.stated[places, by + column] = values
    table[places, : tb.SURFACE_SPEED] = effective_surfaces(shapes.stated[places])
    changed: NDArray[np.bool_] = (table[places, : tb.SHAPE_RADIUS] != before).any(axis=1)
    return changed
