"""The form of a body: its convex shapes as the engine's arrays take them, found once for a shape.

Bodies that come and go in a game are of few shapes, so that adding one finds its form kept.
"""

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine.shape_rows import ShapeRow, shape_rows
from tamias2d.scene.compound import Shape
from tamias2d.state import Array, IntArray

_KEPT = 256  # forms


class Form(NamedTuple):
    """The m convex shapes of a body, side by side."""

    kinds: IntArray
    """(m,), each one of those in `tables`"""
    radii: Array
    """(m,), how far each reaches around its vertices, m"""
    bounds: Array
    """(m, 6), what `tables` holds of a material besides friction and restitution"""
    vertices: Array
    """(v, 4), vertex, m, and outward normal of the side that begins there, shape by shape"""
    counts: tuple[int, ...]
    """m numbers of vertices"""
    extents: tuple[float, float, float]
    """bounding radius, least half width and core radius of the body, m"""
    numbers: tuple[float, ...]
    """all numbers of the shape, by which bodies are ordered"""


@lru_cache(_KEPT)
def form_of(shape: Shape | None) -> Form:
    """Return the form of a body's shape; that of a particle is empty."""
    rows = shape_rows(shape)
    bounds = [(row.bounding_radius, row.inradius, *row.corners) for row in rows]
    return Form(
        kinds=np.array([row.kind for row in rows], dtype=np.int64),
        radii=np.array([row.radius for row in rows]),
        bounds=np.array(bounds).reshape(-1, 6),
        vertices=np.concatenate([np.zeros((0, 4)), *(row.vertices for row in rows)]),
        counts=tuple(len(row.vertices) for row in rows),
        extents=_extents(rows),
        numbers=tuple(value for row in rows for value in _numbers(row)),
    )


def joined(values: Sequence[NDArray[Any]]) -> NDArray[Any]:
    """Return arrays one after another; one alone is not copied."""
    return values[0] if len(values) == 1 else np.concatenate(values)


def _extents(rows: Sequence[ShapeRow]) -> tuple[float, float, float]:
    reach = [row.bounding_radius for row in rows]
    return (
        max((value for value in reach if value < math.inf), default=0.0),
        min((row.min_extent for row in rows), default=math.inf),
        max((row.core_radius for row in rows), default=0.0),
    )


def _numbers(row: ShapeRow) -> Sequence[float]:
    return row.kind, row.radius, len(row.vertices), *row.vertices.ravel().tolist()
