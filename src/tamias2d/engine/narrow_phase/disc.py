"""Manifolds of a disc: with another disc, and with a shape that has sides."""

from math import sqrt

from tamias2d.engine import tables as tb
from tamias2d.engine.narrow_phase.clip import TINY
from tamias2d.engine.narrow_phase.core import Core, next_vertex
from tamias2d.state import Array


def collide_discs(
    manifold: Array, a: Core, b: Core, x: float, y: float, margin: float, vertices: Array
) -> int:
    """Write the point between two discs; return its feature, or 0."""
    ax, ay = vertices[a.first, 0], vertices[a.first, 1]
    dx, dy = x + vertices[b.first, 0] - ax, y + vertices[b.first, 1] - ay
    radii = a.radius + b.radius
    square = dx * dx + dy * dy
    if square >= (radii + margin) * (radii + margin):
        return 0
    distance = sqrt(square)
    nx, ny = (dx / distance, dy / distance) if square > TINY else (0.0, 1.0)
    middle = 0.5 * (distance + a.radius - b.radius)
    manifold[tb.NX], manifold[tb.NY] = nx, ny
    manifold[tb.PX], manifold[tb.PY] = ax + nx * middle, ay + ny * middle
    manifold[tb.GAP] = distance - radii
    return 1


def collide_disc(
    manifold: Array,
    p: Core,
    disc: Core,
    x: float,
    y: float,
    margin: float,
    swapped: bool,
    vertices: Array,
) -> int:
    """Write the point between a shape with sides and a disc; return its feature, or 0.

    The disc's body is at (x, y) from the other, m; `swapped` says that the disc is A.
    """
    centre_x, centre_y = vertices[disc.first, 0], vertices[disc.first, 1]
    x, y = x + centre_x, y + centre_y
    if not swapped:
        centre_x, centre_y = x, y
    cutoff = p.radius + disc.radius + margin
    side, separation = side_below(p, x, y, vertices)
    if separation >= cutoff:
        return 0
    distance, nx, ny = nearest_feature(p, side, separation, x, y, vertices)
    if distance >= cutoff:
        return 0
    middle = 0.5 * (p.radius - disc.radius - distance)
    manifold[tb.NX], manifold[tb.NY] = (-nx, -ny) if swapped else (nx, ny)
    manifold[tb.PX], manifold[tb.PY] = centre_x + nx * middle, centre_y + ny * middle
    manifold[tb.GAP] = distance - p.radius - disc.radius
    return 1


def side_below(p: Core, x: float, y: float, vertices: Array) -> tuple[int, float]:
    """Return the side that a point is farthest in front of, and how far, m."""
    best = -1e308
    side = 0
    for k in range(p.vertex_count):
        v = p.first + k
        height = vertices[v, 2] * (x - vertices[v, 0]) + vertices[v, 3] * (y - vertices[v, 1])
        if height > best:
            best = height
            side = k
    return side, best


def nearest_feature(
    p: Core, side: int, separation: float, x: float, y: float, vertices: Array
) -> tuple[float, float, float]:
    """Return the distance of a point from a side or its nearer vertex, m, and the normal there."""
    v, w = p.first + side, p.first + next_vertex(side, p.vertex_count)
    nx, ny = vertices[v, 2], vertices[v, 3]
    vx, vy = vertices[v, 0], vertices[v, 1]
    length = nx * (vertices[w, 1] - vy) - ny * (vertices[w, 0] - vx)
    along = nx * (y - vy) - ny * (x - vx)
    distance = separation
    if separation >= 0.0 and (along < 0.0 or along > length):
        vertex = v if along < 0.0 else w
        dx, dy = x - vertices[vertex, 0], y - vertices[vertex, 1]
        square = dx * dx + dy * dy
        distance = sqrt(square)
        if square > TINY:
            nx, ny = dx / distance, dy / distance
    return distance, nx, ny
