"""Clipping: the ends of what a reference side and an incident side have in common.

Along the reference side, from its first vertex p1 to p2, the incident side runs from q1 down to
q2. What they have in common has an end at p1 or q2 and one at p2 or q1: these pairs of vertices are
the features of the two points, whichever of the sides is the reference and whichever of the
vertices is the end. So a point keeps its feature, and with it its impulses, while bodies rock and
slide. Source: Catto, Box2D v3 (2024).
"""

from math import sqrt
from typing import NamedTuple

from tamias2d.engine import tables as tb
from tamias2d.engine.narrow_phase.core import Core, next_vertex
from tamias2d.engine.narrow_phase.separation import (
    EITHER_IS_REFERENCE,
    REFERENCE_B,
    side_separation,
)
from tamias2d.state import Array

FEATURES = 1 << 15  # more than the vertices of a shape
PARALLEL = 2.0**-6  # slope to the other side, as if parallel: an error of 2**-13 of the gap
LEVEL_SLOPE = 2.0**-20  # slope up to which no point is the deeper one
TINY = 1e-290  # m^2: squares of lengths below are too inexact for a direction
NO_GAP = 1e308  # m, of a point that is not there


class Facing(NamedTuple):
    """An incident side in the axes of its reference side, m."""

    nx: float  # outward normal of the reference side
    ny: float
    x: float  # first vertex of the reference side, from the centre of A
    y: float
    length: float  # of the reference side
    along1: float  # first vertex of the incident side
    gap1: float
    along2: float  # its second vertex
    gap2: float


def clip_reference(
    manifold: Array,
    state: int,
    a: Core,
    side_a: int,
    b: Core,
    side_b: int,
    x: float,
    y: float,
    margin: float,
    vertices: Array,
) -> tuple[int, int]:
    """Write the points between two sides that face each other; the state tells the reference."""
    b_is_reference = state == REFERENCE_B
    if state == EITHER_IS_REFERENCE:
        b_is_reference = side_separation(b, side_b, a, side_a, -x, -y, vertices) > side_separation(
            a, side_a, b, side_b, x, y, vertices
        )
    if b_is_reference:
        return clip_sides(manifold, b, side_b, a, side_a, -x, -y, margin, True, vertices)
    return clip_sides(manifold, a, side_a, b, side_b, x, y, margin, False, vertices)


def clip_sides(
    manifold: Array,
    p: Core,
    side_p: int,
    q: Core,
    side_q: int,
    x: float,
    y: float,
    margin: float,
    swapped: bool,
    vertices: Array,
) -> tuple[int, int]:
    """Write the points between P's reference side and Q's incident side.

    Q's centre is at (x, y) from P's, m; `swapped` says that P is B. Returns the features of the
    points, 0 for one whose gap is not below the margin, m.
    """
    end_p, end_q = next_vertex(side_p, p.vertex_count), next_vertex(side_q, q.vertex_count)
    facing = facing_sides(
        p.first + side_p, p.first + end_p, q.first + side_q, q.first + end_q, x, y, swapped,
        vertices,
    )  # fmt: skip
    separation = facing.gap1 if facing.gap1 < facing.gap2 else facing.gap2
    low, high = common_part(facing)
    if separation >= 0.0 or (
        p.vertex_count == 2 and q.vertex_count == 2
    ):  # segments have no sides at their ends
        which = nearest_vertices(facing)
        if which > 0 and (separation >= 0.0 or high < low):
            vertex_p, vertex_q = end_p if which > 2 else side_p, side_q
            if which == 1 or which == 4:
                vertex_q = end_q
            near = collide_vertices(manifold, facing, which, p.radius, q.radius, margin, swapped)
            return feature_of(vertex_p, vertex_q, swapped) if near else 0, 0
    manifold[tb.NX] = -facing.nx if swapped else facing.nx
    manifold[tb.NY] = -facing.ny if swapped else facing.ny
    feature_low, feature_high = (
        feature_of(side_p, end_q, swapped),
        feature_of(end_p, side_q, swapped),
    )
    return clip_points(
        manifold, facing, low, high, p.radius, q.radius, margin, feature_low, feature_high
    )


def facing_sides(
    p1: int, p2: int, q1: int, q2: int, x: float, y: float, swapped: bool, vertices: Array
) -> Facing:
    """Return the side from vertex q1 to q2 in the axes of that from p1 to p2.

    Q's centre is at (x, y) from P's, m; `swapped` says that Q is A.
    """
    nx, ny = vertices[p1, 2], vertices[p1, 3]
    vx, vy = vertices[p1, 0], vertices[p1, 1]
    x1, y1 = vertices[q1, 0] + (x - vx), vertices[q1, 1] + (y - vy)
    x2, y2 = vertices[q2, 0] + (x - vx), vertices[q2, 1] + (y - vy)
    length = nx * (vertices[p2, 1] - vy) - ny * (vertices[p2, 0] - vx)
    gap1, gap2 = nx * x1 + ny * y1, nx * x2 + ny * y2
    along1, along2 = nx * y1 - ny * x1, nx * y2 - ny * x2
    if swapped:
        vx, vy = vx - x, vy - y
    return Facing(nx, ny, vx, vy, length, along1, gap1, along2, gap2)


def common_part(facing: Facing) -> tuple[float, float]:
    """Return from where to where both sides are along the reference side, m; there may be none."""
    low = facing.along2 if facing.along2 > 0.0 else 0.0
    high = facing.along1 if facing.along1 < facing.length else facing.length
    return low, high


def clip_points(
    manifold: Array,
    facing: Facing,
    low: float,
    high: float,
    radius_p: float,
    radius_q: float,
    margin: float,
    feature_low: int,
    feature_high: int,
) -> tuple[int, int]:
    """Write the points at both ends of the common part that are within the margin.

    Returns their features. The deeper point comes first, and is solved first, whichever end it is
    at: so it is in a mirror. Of a shape that lies level rounding must not choose it.
    """
    if high < low or facing.along1 <= facing.along2:  # no common part: the deepest vertex alone
        deepest_first = facing.gap1 < facing.gap2
        low = high = facing.along1 if deepest_first else facing.along2
        gap_low, gap_high = facing.gap1 if deepest_first else facing.gap2, NO_GAP
    else:
        span, rise = facing.along1 - facing.along2, facing.gap1 - facing.gap2
        gap_low = facing.gap2 + rise * ((low - facing.along2) / span)
        gap_high = NO_GAP
        if high > low:
            gap_high = facing.gap1 + (facing.gap2 - facing.gap1) * ((facing.along1 - high) / span)
    radii, uneven = radius_p + radius_q, radius_p - radius_q
    near_low, near_high = gap_low - radii < margin, gap_high - radii < margin
    high_first = gap_high < gap_low - LEVEL_SLOPE * (high - low)
    if near_low:
        at = tb.POINT if high_first else 0
        write_point(manifold, at, facing, low, 0.5 * (gap_low + uneven), gap_low - radii)
    if near_high:
        at = tb.POINT if near_low and not high_first else 0
        write_point(manifold, at, facing, high, 0.5 * (gap_high + uneven), gap_high - radii)
    feature_low, feature_high = feature_low if near_low else 0, feature_high if near_high else 0
    return (
        (feature_high, feature_low) if high_first or not near_low else (feature_low, feature_high)
    )


def write_point(
    manifold: Array, at: int, facing: Facing, along: float, height: float, gap: float
) -> None:
    """Write a point along the reference side and over it, m."""
    manifold[tb.PX + at] = facing.x + facing.nx * height - facing.ny * along
    manifold[tb.PY + at] = facing.y + facing.ny * height + facing.nx * along
    manifold[tb.GAP + at] = gap


def collide_vertices(
    manifold: Array,
    facing: Facing,
    which: int,
    radius_p: float,
    radius_q: float,
    margin: float,
    swapped: bool,
) -> bool:
    """Write the point between the vertices that are nearest; return whether it is near enough."""
    nx, ny = facing.nx, facing.ny
    at = facing.length if which > 2 else 0.0
    of_first = which == 2 or which == 3
    beside = (facing.along1 if of_first else facing.along2) - at
    across = facing.gap1 if of_first else facing.gap2
    square = beside * beside + across * across
    distance = sqrt(square)
    gap = distance - radius_p - radius_q
    if gap >= margin:
        return False
    ux, uy = nx, ny
    if square > TINY:
        ux, uy = (nx * across - ny * beside) / distance, (ny * across + nx * beside) / distance
    manifold[tb.NX] = -ux if swapped else ux
    manifold[tb.NY] = -uy if swapped else uy
    middle = 0.5 * (distance + radius_p - radius_q)
    manifold[tb.PX] = facing.x - ny * at + ux * middle
    manifold[tb.PY] = facing.y + nx * at + uy * middle
    manifold[tb.GAP] = gap
    return True


def nearest_vertices(facing: Facing) -> int:
    """Return which vertices are nearest: 1 p1 and q2, 2 p1 and q1, 3 p2 and q1, 4 p2 and q2.

    0 where the inside of a side is nearest, or nearly so: of sides that are almost parallel and
    beside each other both ends count, since bodies in line are to rest on two points.
    """
    along1, along2, length = facing.along1, facing.along2, facing.length
    span, rise = along1 - along2, facing.gap1 - facing.gap2
    beside = along1 >= 0.0 and along2 <= length
    if beside and abs(rise) <= PARALLEL * span:
        return 0
    if along2 < 0.0 and -along2 * span <= facing.gap2 * rise:
        return 1
    if along1 < 0.0:
        return 2
    if along1 > length and (along1 - length) * span <= -facing.gap1 * rise:
        return 3
    if along2 > length:
        return 4
    return 0


def feature_of(p: int, q: int, swapped: bool) -> int:
    """Return the feature of a point between a vertex of P and one of Q."""
    return 1 + (q * FEATURES + p if swapped else p * FEATURES + q)
