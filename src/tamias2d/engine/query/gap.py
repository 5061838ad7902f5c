"""The gap between two convex cores, one of which is moved, and where they touch.

It is negative where they overlap: by that much they are to be moved apart along the normal. As a
function of a move in a straight line it is convex. Cost: the product of the numbers of corners.
"""

from math import sqrt
from typing import NamedTuple

from tamias2d.engine.query.overlap_shape import from_line
from tamias2d.state import Array, Vector

ENDLESS = 1e308
ALONG_SIDE = 1.0 + 2.0**-40  # a distance that is larger than along a side by less is that
TIED = 2.0**-30  # of the size: corners that are as far along a normal


class Gap(NamedTuple):
    """How far a core is from another one, m, and the direction that leads away from that."""

    size: float
    nx: float
    ny: float


def gap_between(a: Array, by: Vector, b: Array, rounded: float) -> Gap:
    """Return the gap of a core A, moved by (x, y), from a core B; both (c, 2), m.

    Of corners that are nearer than what is rounded, m, rounding tells the direction.
    """
    along_b = widest_along_sides(b, (0.0, 0.0), a, by)
    along_a = widest_along_sides(a, by, b, (0.0, 0.0))
    best = along_b if along_b.size >= along_a.size else Gap(along_a.size, -along_a.nx, -along_a.ny)
    if -ENDLESS < best.size < 0.0:
        return best
    way = shorter(shortest_way(a, by, b, (0.0, 0.0)), shortest_way(b, (0.0, 0.0), a, by), -1.0)
    far = sqrt(way[0] * way[0] + way[1] * way[1])
    if far <= best.size * ALONG_SIDE + rounded:
        return best
    return Gap(far, way[0] / far, way[1] / far) if far > 0.0 else Gap(0.0, 0.0, 1.0)


def widest_along_sides(p: Array, p_by: Vector, q: Array, q_by: Vector) -> Gap:
    """Return the largest gap of Q along the normals of sides of P; a point has none."""
    best = Gap(-ENDLESS, 0.0, 0.0)
    for k in range(len(p) if len(p) > 1 else 0):
        end = k + 1 if k + 1 < len(p) else 0
        nx, ny = p[end, 1] - p[k, 1], p[k, 0] - p[end, 0]
        length = sqrt(nx * nx + ny * ny)
        nx, ny = nx / length, ny / length
        low = ENDLESS
        for m in range(len(q)):
            x, y = q[m, 0] + q_by[0] - p_by[0], q[m, 1] + q_by[1] - p_by[1]
            low = min(low, nx * (x - p[k, 0]) + ny * (y - p[k, 1]))
        if low > best.size:
            best = Gap(low, nx, ny)
    return best


def shortest_way(p: Array, p_by: Vector, q: Array, q_by: Vector) -> Vector:
    """Return the shortest way to a corner of P from a line of Q."""
    best = (ENDLESS, 0.0)
    for k in range(len(p)):
        corner = (p[k, 0] + p_by[0] - q_by[0], p[k, 1] + p_by[1] - q_by[1])
        for m in range(len(q)):
            end = m + 1 if m + 1 < len(q) else 0
            line = (q[end, 0] - q[m, 0], q[end, 1] - q[m, 1])
            best = shorter(best, from_line(corner, (q[m, 0], q[m, 1]), line), 1.0)
    return best


def shorter(one: Vector, other: Vector, sign: float) -> Vector:
    """Return the shorter one of two ways, the second times a sign."""
    nearer = other[0] * other[0] + other[1] * other[1] < one[0] * one[0] + one[1] * one[1]
    return (sign * other[0], sign * other[1]) if nearer else one


def touching_point(a: Array, by: Vector, b: Array, radius: float, gap: Gap) -> Vector:
    """Return where A, moved by (x, y), touches B, which has a radius around it, m.

    It is on B, in the middle of what sides that touch have in common.
    """
    nx, ny = gap.nx, gap.ny
    low_a, high_a, _ = extent_across(a, -nx, -ny)
    low_b, high_b, height = extent_across(b, nx, ny)
    shift = nx * by[1] - ny * by[0]
    low_a, high_a = shift - high_a, shift - low_a  # seen against the direction
    low, high = max(low_a, low_b), min(high_a, high_b)
    across, along = 0.5 * (low + high), height + radius
    across = min(max(across, low_b), high_b)
    return along * nx - across * ny, along * ny + across * nx


def extent_across(core: Array, nx: float, ny: float) -> tuple[float, float, float]:
    """Return how far corners that are farthest along a direction reach across it, and how far."""
    most, size = -ENDLESS, 0.0
    for k in range(len(core)):
        most = max(most, nx * core[k, 0] + ny * core[k, 1])
        size = max(size, abs(core[k, 0] - core[0, 0]) + abs(core[k, 1] - core[0, 1]))
    low, high = ENDLESS, -ENDLESS
    for k in range(len(core)):
        if nx * core[k, 0] + ny * core[k, 1] >= most - TIED * size:
            across = nx * core[k, 1] - ny * core[k, 0]
            low, high = min(low, across), max(high, across)
    return low, high, most
