"""The form of a body: its convex shapes as the engine's arrays take them, found once for a shape.

Bodies that come and go in a game are of few shapes, so that adding one finds its form kept.
"""

import math
from collections.abc import Sequence
from functools import lru_cache
from itertools import chain
from typing import NamedTuple

import numpy as np

from tamias2d.engine.shapes.shape_rows import ShapeRow, shape_rows
from tamias2d.engine.shapes.stated_surfaces import UNSTATED
from tamias2d.scene.compound import Shape
from tamias2d.state import Array, IntArray

_KEPT = 256  # forms


class Pieces(NamedTuple):
    """Convex shapes (m,) side by side, as the engine's arrays take them."""

    kinds: IntArray
    """(m,), each one of those in `tables`"""
    radii: Array
    """(m,), how far each reaches around its vertices, m"""
    bounds: Array
    """(m, 6), what `tables` holds of a material besides friction and restitution"""
    surfaces: Array
    """(m, 2), friction and restitution that parts state for themselves, UNSTATED where none"""
    vertices: Array
    """(v, 4), vertex, m, and outward normal of the side that begins there, shape by shape"""
    counts: tuple[int, ...]
    """m numbers of vertices"""
    stating: bool
    """whether a part states something for itself"""


class Form(NamedTuple):
    """What the engine holds of a body's shape."""

    pieces: Pieces
    extents: tuple[float, float, float]
    """bounding radius, least half width and core radius of the body, m"""
    numbers: tuple[float, ...]
    """all numbers of the shape, by which bodies are ordered"""


@lru_cache(_KEPT)
def form_of(shape: Shape | None) -> Form:
    """Return the form of a body's shape; that of a particle has no pieces."""
    rows = shape_rows(shape)
    bounds = [(row.bounding_radius, row.inradius, *row.corners) for row in rows]
    pieces = Pieces(
        kinds=np.array([row.kind for row in rows], dtype=np.int64),
        radii=np.array([row.radius for row in rows]),
        bounds=np.array(bounds).reshape(-1, 6),
        surfaces=np.array([row.surface for row in rows]).reshape(-1, 2),
        vertices=np.concatenate([np.zeros((0, 4)), *(row.vertices for row in rows)]),
        counts=tuple(len(row.vertices) for row in rows),
        stating=any(value != UNSTATED for row in rows for value in row.surface),
    )
    numbers = (value for row in rows for value in _numbers(row))
    return Form(pieces, _extents(rows), tuple(numbers))


def joined(forms: Sequence[Form]) -> Pieces:
    """Return the pieces of forms one after another; those of one alone are not copied."""
    if len(forms) == 1:
        return forms[0].pieces
    none = form_of(None).pieces
    *columns, counts, stating = zip(none, *(form.pieces for form in forms), strict=True)
    kinds, radii, bounds, surfaces, vertices = map(np.concatenate, columns)
    each = tuple(chain.from_iterable(counts))
    return Pieces(kinds, radii, bounds, surfaces, vertices, each, any(stating))


def _extents(rows: Sequence[ShapeRow]) -> tuple[float, float, float]:
    reach = [row.bounding_radius for row in rows]
    return (
        max((value for value in reach if value < math.inf), default=0.0),
        min((row.min_extent for row in rows), default=math.inf),
        max((row.core_radius for row in rows), default=0.0),
    )


def _numbers(row: ShapeRow) -> Sequence[float]:
    return row.kind, row.radius, len(row.vertices), *row.vertices.ravel().tolist(), *row.surface
