"""The canonical order of bodies: of those that are new together, by where and what they are.

The order goes along the x axis in strips, and in each of them upwards, number by number: the order
of adding changes nothing. Bodies that are equal in all of it can be swapped without a difference.
"""

from collections.abc import Sequence

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import World
from tamias2d.state import Array, IntArray

STRIP = 4.0  # median bounding radii of bodies: the width of a strip of the canonical order


def in_order(
    world: World, rows: IntArray, shapes: IntArray, forms: Sequence[tuple[float, ...]]
) -> IntArray:
    """Return new bodies (k,) in their order; they own shapes, and have forms of such numbers."""
    if len(rows) < 2:
        return rows
    return rows[np.lexsort(_keys(world, rows, shapes, forms)[::-1])]


def _keys(
    world: World, rows: IntArray, owned: IntArray, forms: Sequence[tuple[float, ...]]
) -> list[Array]:
    """Return by what bodies are ordered, the first first."""
    state, shapes = world.state, world.shapes
    first = np.full(len(state.pose), -1)
    first[state.body_of_shape[owned][::-1]] = owned[::-1]
    properties = state.properties[rows]
    tables = (
        state.pose[rows],
        state.velocity[rows],
        state.load[rows],
        properties[:, : tb.PROPAGATOR],
        world.bodies.propagators[properties[:, tb.PROPAGATOR].astype(np.int64)],
        np.concatenate((shapes.material, np.zeros((1, shapes.material.shape[1]))))[first[rows]],
        np.concatenate((shapes.filters, np.zeros((1, 4), dtype=np.int64)))[first[rows]],
    )
    columns = [column for table in tables for column in table.T]
    return [
        state.kind[rows],
        _strips(world, rows),
        state.pose[rows, tb.Y],
        *columns,
        _places_of(forms),
    ]


def _strips(world: World, rows: IntArray) -> Array:
    """Return in which strip of the x axis each body is, all some bodies wide.

    Bodies that are near each other are so in the order, too, and thus in memory.
    """
    state = world.state
    return strips(state.pose[rows, tb.X], state.properties[rows, tb.BOUNDING_RADIUS])


def _places_of(forms: Sequence[tuple[float, ...]]) -> IntArray:
    """Return the place of each form in the order of the forms themselves."""
    place = {form: k for k, form in enumerate(sorted(set(forms)))}
    return np.array([place[form] for form in forms], dtype=np.int64)


def strips(x: Array, reach: Array) -> Array:
    """Return in which strip bodies (..., n) are, from how far each reaches from its centre (n,)."""
    width = STRIP * np.median(reach[reach > 0.0]) if (reach > 0.0).any() else np.inf
    with np.errstate(all="ignore"):
        found: Array = np.floor(x / width)
    return found
