"""Convex cores: the vertices of a shape, which its radius grows."""

from math import sqrt
from typing import NamedTuple

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Shapes
from tamias2d.state import Array


class Core(NamedTuple):
    """Consecutive rows of vertices with the normals of their sides, and the radius around them."""

    kind: int
    first: int  # vertex
    vertex_count: int
    radius: float  # m
    inradius: float  # least distance of a side from the body's centre, m; negative if outside


def core_of(s: int, shapes: Shapes) -> Core:
    """Return the core of a shape."""
    return Core(
        int(shapes.kind[s]),
        int(shapes.first[s]),
        int(shapes.vertex_count[s]),
        float(shapes.radius[s]),
        float(shapes.material[s, tb.SHAPE_INRADIUS]),
    )


def is_piece(p: Core) -> bool:
    """Return whether a core is a piece of a chain."""
    return p.kind >= tb.PIECE


def is_thin(a: Core, b: Core) -> bool:
    """Return whether one of two shapes is next to nothing across, such as a piece of a chain."""
    return a.kind >= tb.THIN_CAPSULE or b.kind >= tb.THIN_CAPSULE


def next_vertex(k: int, count: int) -> int:
    """Return the vertex after the k-th of some, counter-clockwise."""
    return k + 1 if k + 1 < count else 0


def smaller_size(p: Core, q: Core, vertices: Array) -> float:
    """Return the smaller extent of two shapes, m; Q is no half-plane, whose extent is infinite.

    So is that of a piece of a chain.
    """
    if is_piece(q):
        return extent_of(p, vertices) + p.radius
    extent = extent_of(q, vertices) + q.radius
    if p.kind == tb.HALF_PLANE or is_piece(p):
        return extent
    return min(extent, extent_of(p, vertices) + p.radius)


def extent_of(p: Core, vertices: Array) -> float:
    """Return half of the distance of the first vertex from the farthest one, m."""
    far = 0.0
    for k in range(p.first + 1, p.first + p.vertex_count):
        x, y = vertices[k, 0] - vertices[p.first, 0], vertices[k, 1] - vertices[p.first, 1]
        far = max(far, x * x + y * y)
    return 0.5 * sqrt(far)
