"""Which value of the state keeps a step from being taken."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.engine.arrays.store import Store
from tamias2d.engine.state import LARGEST, RESOLVED
from tamias2d.state import Array

NOT_FINITE, TOO_LARGE, TOO_FAR, MOVES, OVERFLOWED, PUSHED, NO_BODY, SPINS = range(8)
"""Why a value is not valid; one has overflowed if it was not finite after a step."""

_COLUMNS = {
    "position": ("pose", slice(0, 2)),
    "orientation": ("pose", slice(2, 3)),
    "velocity": ("velocity", slice(0, 2)),
    "angular_velocity": ("velocity", slice(2, 3)),
    "force": ("load", slice(0, 2)),
    "torque": ("load", slice(2, 3)),
}


class Invalid(NamedTuple):
    """A value that is not valid."""

    quantity: str
    """as users call it, such as 'velocity'"""
    row: int
    """of its body; -1 for gravity"""
    found: list[float]
    """its numbers; radius of the body, m, where that is too far away"""
    reason: int


def first_invalid(store: Store) -> Invalid:
    """Return the first value of which `gather_state` says that it is not valid."""
    state, size = store.world.state, store.size
    columns = {
        quantity: getattr(state, array)[:size, where]
        for quantity, (array, where) in _COLUMNS.items()
    }
    for quantity, values in columns.items():
        if (invalid := _first(quantity, values, ~np.isfinite(values), NOT_FINITE)) is not None:
            return invalid
    speed, load = np.abs(state.velocity[:size]), np.abs(state.load[:size])
    with np.errstate(over="ignore"):
        large = speed.sum(axis=1) + load.sum(axis=1) > LARGEST
    if large.any():
        row = int(np.argmax(large))
        quantity = max(list(_COLUMNS)[2:], key=lambda q: np.abs(columns[q][row]).max())
        return Invalid(quantity, row, columns[quantity][row].tolist(), TOO_LARGE)
    radius = state.properties[:size, tb.BOUNDING_RADIUS]
    with np.errstate(over="ignore"):
        most = np.where(radius > 0.0, RESOLVED * radius, LARGEST)
    place = columns["position"]
    far = (np.abs(place) > most[:, None] / 2) & (np.abs(place).sum(axis=1) > most)[:, None]
    if (invalid := _first("position", place, far, TOO_FAR)) is not None:
        return invalid
    kind = state.kind[:size, None]
    for quantity, values in columns.items():
        there = values.reshape(size, -1) != 0.0
        if (invalid := _first(quantity, values, there & (kind == tb.ABSENT), NO_BODY)) is not None:
            return invalid
    moving = (speed > 0.0) & (kind == tb.STATIC)
    if (invalid := _first("velocity", state.velocity[:size], moving, MOVES)) is not None:
        return invalid
    unturned = (kind == tb.DYNAMIC) & (state.properties[:size, [tb.INVERSE_INERTIA]] == 0.0)
    spin = columns["angular_velocity"]
    if (invalid := _first("angular_velocity", spin, unturned & (spin != 0.0), SPINS)) is not None:
        return invalid
    for quantity in ("force", "torque"):
        pushed = (columns[quantity] != 0.0) & (kind != tb.DYNAMIC)
        if (invalid := _first(quantity, columns[quantity], pushed, PUSHED)) is not None:
            return invalid
    gravity = store.world.control.settings[:2]
    reason = TOO_LARGE if np.isfinite(gravity).all() else NOT_FINITE
    return Invalid("gravity", -1, gravity.tolist(), reason)


def overflowed(store: Store) -> Invalid:
    """Return the body whose numbers were not finite after a step, or the largest, before it."""
    world = store.world
    numbers = np.hstack((world.bodies.pose, world.bodies.motion[:, :3]))
    slots = world.state.slot_of_body[: store.size]
    with np.errstate(all="ignore"):
        total = np.abs(numbers[slots]).sum(axis=1)
    total[np.isnan(total)] = np.inf
    total[world.state.kind[: store.size] != tb.DYNAMIC] = -1.0
    row = int(np.argmax(total))
    return Invalid("velocity", row, world.state.velocity[row].tolist(), OVERFLOWED)


def _first(quantity: str, values: Array, bad: NDArray[np.bool_], reason: int) -> Invalid | None:
    if not bad.any():
        return None
    row = int(np.argmax(bad.any(axis=1)))
    return Invalid(quantity, row, values[row].tolist(), reason)
