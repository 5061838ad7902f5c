"""Which value of the state is not valid, so that no step can be taken from it."""

from typing import NamedTuple

import numpy as np

from tamias2d.engine.store import Store
from tamias2d.engine.tables import STATIC
from tamias2d.state import Array

_COLUMNS = {
    "position": ("pose", slice(0, 2)),
    "orientation": ("pose", slice(2, 3)),
    "velocity": ("velocity", slice(0, 2)),
    "angular_velocity": ("velocity", slice(2, 3)),
    "force": ("load", slice(0, 2)),
    "torque": ("load", slice(2, 3)),
}


LARGEST = 2.0**256
"""The fourth root of the largest float64, 1.2e77: products of four such numbers are finite."""


class Invalid(NamedTuple):
    """A value that is not valid, or a static body that moves."""

    quantity: str
    row: int
    found: list[float]
    moves: bool


def first_invalid(store: Store) -> Invalid | None:
    """Return the first value of a body that is not valid, or None if that is gravity."""
    state = store.world.state
    for quantity, (array, columns) in _COLUMNS.items():
        values: Array = getattr(state, array)[: store.size, columns]
        bad = ~np.isfinite(values).all(axis=1)
        if bad.any():
            row = int(np.argmax(bad))
            return Invalid(quantity, row, values[row].tolist(), moves=False)
    velocity = state.velocity[: store.size]
    moving = velocity.any(axis=1) & (state.kind[: store.size] == STATIC)
    if moving.any():
        row = int(np.argmax(moving))
        return Invalid("velocity", row, velocity[row].tolist(), moves=True)
    return None
