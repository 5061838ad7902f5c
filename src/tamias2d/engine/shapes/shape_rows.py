"""Convex shapes as rows of the engine's arrays."""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.engine.shapes.stated_surfaces import UNSTATED, as_stated
from tamias2d.scene import Chain, HalfPlane
from tamias2d.scene.compound import Part, Shape, pieces_of
from tamias2d.scene.rules import Vector
from tamias2d.state import Array


class ShapeRow(NamedTuple):
    """One convex shape of a body, in the axes of the body."""

    kind: int
    """one of those in `tables`"""
    radius: float
    """how far the shape reaches around its vertices, m"""
    vertices: Array
    """(c, 4), vertex, m, and outward normal of the side that begins there"""
    core_radius: float
    """distance of the farthest vertex from the centre of mass, m; 0 for a half-plane"""
    bounding_radius: float
    """distance of its farthest point from the centre of mass, m; infinite for a half-plane"""
    min_extent: float
    """half of the least width, m; infinite for a half-plane"""
    inradius: float
    """least distance of the sides from the centre of mass, m; minus infinity if that is outside"""
    corners: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
    """of a piece of a chain: cosine and sine of the corners at its start and its end (DD73)"""
    surface: tuple[float, float] = (UNSTATED, UNSTATED)
    """friction and restitution that a part states for itself"""


def shape_rows(shape: Shape | None) -> tuple[ShapeRow, ...]:
    """Return the convex shapes of a body's shape; a particle has none."""
    if shape is None:
        return ()
    if isinstance(shape, HalfPlane):
        side = np.array([[shape.offset, 0.0, *shape.normal]])
        return (ShapeRow(tb.HALF_PLANE, 0.0, side, 0.0, math.inf, math.inf, -math.inf),)
    if isinstance(shape, Chain):
        return _chain(shape)
    return tuple(_bounded(part) for part in pieces_of(shape))


def _bounded(part: Part) -> ShapeRow:
    core, radius = part.core, part.shape.rounding
    far = max(math.hypot(x, y) for x, y in core)
    vertices = _with_normals(core)
    across = vertices[:, 2:] @ vertices[:, :2].T
    inradius = float((vertices[:, :2] * vertices[:, 2:]).sum(axis=1).min())
    widths = np.ptp(across, axis=1)
    length = 2.0 * radius + math.hypot(*np.ptp(vertices[:, :2], axis=0))
    thin = 2.0 * radius + float(widths.min()) < tb.THINNEST * length
    return ShapeRow(
        kind=_kind(len(core), thin),
        radius=radius,
        vertices=vertices,
        core_radius=far,
        bounding_radius=far + radius,
        min_extent=radius + float(widths.min()) / 2,
        inradius=inradius if inradius >= 0.0 else -math.inf,
        surface=(as_stated(part.friction), as_stated(part.restitution)),
    )


def _kind(corners: int, thin: bool) -> int:
    if corners == 1:
        return tb.DISC
    if corners == 2:
        return tb.THIN_CAPSULE if thin else tb.CAPSULE
    return tb.THIN_POLYGON if thin else tb.POLYGON


def _chain(chain: Chain) -> tuple[ShapeRow, ...]:
    """Return the pieces of a chain, as parts of something that is as large as all of it.

    Behind a piece that is solid from one side nothing is too thin to push a body back.
    """
    far = chain.bounding_radius
    kind, extent = (tb.ONE_SIDED_PIECE, math.inf) if chain.one_sided else (tb.PIECE, 0.0)
    corners = chain.corners
    return tuple(
        ShapeRow(kind, 0.0, _with_normals(core), far, far, extent, -math.inf, (*start, *end))
        for core, start, end in zip(chain.segments, corners[:-1], corners[1:], strict=True)
    )


def _with_normals(core: Sequence[Vector]) -> Array:
    """Return vertices with the outward normals of the sides that begin there."""
    rows = np.zeros((len(core), 4))
    rows[:, :2] = core
    if len(core) > 1:
        for k, (x, y) in enumerate(core):
            end_x, end_y = core[(k + 1) % len(core)]
            length = math.hypot(end_x - x, end_y - y)
            rows[k, 2:] = (end_y - y) / length + 0.0, (x - end_x) / length + 0.0
    return rows
