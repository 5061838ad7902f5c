"""Manifolds of a half-plane with any other shape."""

from tamias2d.engine import tables as tb
from tamias2d.engine.narrow_phase.clip import FEATURES
from tamias2d.engine.narrow_phase.core import Core, next_vertex
from tamias2d.engine.narrow_phase.separation import incident_side
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

ROUNDED_OFF = 2.0**-48  # of lengths along a normal: more than rounding does to their sum


def collide_half_plane(
    manifold: Array,
    plane: int,
    q: Core,
    x: float,
    y: float,
    margin: float,
    swapped: bool,
    vertices: Array,
) -> tuple[int, int]:
    """Write the points between a half-plane and a shape; return their features, or 0.

    The shape's body is at (x, y) from the half-plane's, m; `swapped` says that the shape is A. The
    points are its lowest vertex and the other end of the side that faces the half-plane more: of a
    thin card the next lower vertex may be at the same end.
    """
    nx, ny = vertices[plane, 2], vertices[plane, 3]
    base = nx * x + ny * y - vertices[plane, 0] - q.radius
    lowest, height = lowest_vertex(q, nx, ny, vertices)
    if base + height >= margin:
        return 0, 0
    manifold[tb.NX], manifold[tb.NY] = (-nx, -ny) if swapped else (nx, ny)
    if swapped:
        x, y = 0.0, 0.0
    write_vertex_point(
        manifold, 0, q.first + lowest, x, y, base + height, q.radius, vertices, plane
    )
    first = 1 + (lowest * FEATURES if swapped else lowest)
    if q.vertex_count == 1:
        return first, 0
    other = incident_side(q, lowest, nx, ny, vertices)
    if other == lowest:
        other = next_vertex(lowest, q.vertex_count)
    height = nx * vertices[q.first + other, 0] + ny * vertices[q.first + other, 1]
    if base + height >= margin:
        return first, 0
    write_vertex_point(
        manifold, tb.POINT, q.first + other, x, y, base + height, q.radius, vertices, plane
    )
    return first, 1 + (other * FEATURES if swapped else other)


@inlined
def is_above(x: float, y: float, radius: float, margin: float, side: Array) -> bool:
    """Return whether a circle is farther from a half-plane than a margin, m; also after rounding.

    Its centre is at (x, y) from the body of the half-plane, whose side is a row of vertices.
    """
    height = side[2] * x + side[3] * y - side[0] - radius
    return bool(height > margin + ROUNDED_OFF * (abs(x) + abs(y) + abs(side[0])))


def lowest_vertex(q: Core, nx: float, ny: float, vertices: Array) -> tuple[int, float]:
    """Return the vertex that is least far along a direction, and how far, m."""
    lowest = 0
    least = 1e308
    for k in range(q.vertex_count):
        height = nx * vertices[q.first + k, 0] + ny * vertices[q.first + k, 1]
        if height < least:
            least = height
            lowest = k
    return lowest, least


def write_vertex_point(
    manifold: Array,
    at: int,
    vertex: int,
    x: float,
    y: float,
    gap: float,
    radius: float,
    vertices: Array,
    plane: int,
) -> None:
    """Write the point below a vertex of a shape, whose body is at (x, y) from A, over a plane."""
    down = radius + 0.5 * gap
    manifold[tb.PX + at] = x + vertices[vertex, 0] - vertices[plane, 2] * down
    manifold[tb.PY + at] = y + vertices[vertex, 1] - vertices[plane, 3] * down
    manifold[tb.GAP + at] = gap
