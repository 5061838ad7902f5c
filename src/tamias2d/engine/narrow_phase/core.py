"""Convex cores: the vertices of a shape, which its radius grows."""

from typing import NamedTuple

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Shapes


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


def is_thin(a: Core, b: Core) -> bool:
    """Return whether one of two shapes is next to nothing across, such as a piece of a chain."""
    return a.kind >= tb.THIN_CAPSULE or b.kind >= tb.THIN_CAPSULE


def next_vertex(k: int, count: int) -> int:
    """Return the vertex after the k-th of some, counter-clockwise."""
    return k + 1 if k + 1 < count else 0
