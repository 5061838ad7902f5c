"""The shape of a body, found again from its rows in the engine's arrays."""

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.scene import Box, Capsule, Chain, Compound, Disc, HalfPlane, Part, Polygon, Segment
from tamias2d.scene.compound import Shape
from tamias2d.scene.rules import Vector
from tamias2d.scene.shapes import Single
from tamias2d.state import Array


class ConvexRow(NamedTuple):
    """What the engine holds of one convex shape."""

    kind: int
    """one of those in `tables`"""
    radius: float
    """m"""
    vertices: Array
    """(c, 4), vertex, m, and outward normal of the side that begins there"""
    restitution: float | None = None
    """that it states as a part"""
    friction: float | None = None
    """likewise"""


def shape_of(rows: Sequence[ConvexRow]) -> Shape | None:
    """Return the shape of a body from its rows, in their order; a particle has none.

    Polygons and compounds are given about their centre, to rounding; all others are as they were.
    """
    if not rows:
        return None
    first = rows[0]
    if first.kind == tb.HALF_PLANE:
        offset, _, x, y = first.vertices[0].tolist()
        return HalfPlane(normal=(x, y), offset=offset)
    if first.kind in (tb.PIECE, tb.ONE_SIDED_PIECE):
        return _chain(rows)
    parts = [
        replace(_part(row), restitution=row.restitution, friction=row.friction) for row in rows
    ]
    return parts[0].shape if parts == [Part(shape=parts[0].shape)] else Compound(parts=parts)


def _chain(rows: Sequence[ConvexRow]) -> Chain:
    """Return the chain whose pieces follow each other."""
    starts = [_corner(row, 0) for row in rows]
    end = _corner(rows[-1], 1)
    loop = end == starts[0]
    return Chain(
        vertices=starts if loop else [*starts, end],
        loop=loop,
        one_sided=rows[0].kind == tb.ONE_SIDED_PIECE,
    )


def _part(row: ConvexRow) -> Part:
    core = [_corner(row, k) for k in range(len(row.vertices))]
    if len(core) == 1:
        return Part(shape=Disc(radius=row.radius), position=core[0])
    if len(core) == 2:
        (ax, ay), (bx, by) = core
        return Part(
            shape=_around_line(math.dist(*core), row.radius),
            position=(ax / 2 + bx / 2, ay / 2 + by / 2),
            orientation=math.atan2(by - ay, bx - ax),
        )
    return _polygon(core)


def _around_line(length: float, radius: float) -> Single:
    return Capsule(length=length, radius=radius) if radius else Segment(length=length)


def _polygon(core: list[Vector]) -> Part:
    x, y = core[2]
    if core == [(-x, -y), (x, -y), (x, y), (-x, y)]:
        return Part(shape=Box(width=2 * x, height=2 * y))
    found = Polygon(vertices=core)
    off = np.hypot(*found.centroid) > np.spacing(found.bounding_radius) * len(core)
    return Part(shape=found, position=found.centroid if off else (0.0, 0.0))


def _corner(row: ConvexRow, k: int) -> Vector:
    x, y = row.vertices[k, :2].tolist()
    return x, y
