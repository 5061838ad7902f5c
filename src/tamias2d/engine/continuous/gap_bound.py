"""A lower bound of the gap between two cores that move on, and how far it stays positive.

The bound (DD48), phi below, is concave in the fraction of the step, so that it is positive before
its root, and secants find the root from below. Where that allows a longer advance, a body that
turns far is taken as a disc around its centre, or the normal turns with a body, whose side then
rests. Cost: linear in the vertices for each value.
"""

from math import sqrt
from typing import NamedTuple

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.trajectory import RelativePath
from tamias2d.generated.continuous_collision import (
    arc_bend,
    centre_acceleration_turning,
    circling,
    distance_bound,
    gap_change,
    motion_bound,
    normal_turned,
    separation_least,
)
from tamias2d.state import Array, Vector

UNBOUNDED = 1e100  # m, farther than anything
BISECTIONS = 6  # of the fraction that is not known to be free


class Sweep(NamedTuple):
    """A core that turns through a step."""

    first: int  # row of its first vertex
    vertex_count: int  # 0 for a half-plane, whose offset is in the first row
    turn: float  # in the whole step, rad
    lever: float  # distance of its farthest vertex from the body's centre, m


class GapBound(NamedTuple):
    """The coefficients of phi; the vertices of A begin in the first row."""

    nx: float
    ny: float
    base: float  # m
    rate: float  # m in the whole step
    curvature: float  # m
    turn_a: float  # rad
    turn_b: float  # rad
    count_a: int  # of vertices; 0 if A is a half-plane or taken as a disc
    first_b: int
    count_b: int  # of vertices; 0 if B is taken as a disc


def safe_advance(
    manifold: Array,
    a: Sweep,
    b: Sweep,
    x: float,
    y: float,
    path: RelativePath,
    radii: float,
    rest: float,
    rows: Array,
) -> float:
    """Return the fraction, at most the rest, for which the cores stay more than `radii` apart.

    B is at (x, y) from A, m. The normal of a half-plane turns with it.
    """
    nx, ny = manifold[tb.NX], manifold[tb.NY]
    curvature_a, curvature_b = arc_bend(a.turn, a.lever), arc_bend(b.turn, b.lever)
    spin = a.turn if a.vertex_count == 0 else 0.0  # of the normal
    rate = gap_change((path.dx, path.dy), (nx, ny), spin, (x, y))
    if spin != 0.0:
        curvature_a = turning_curvature(a.turn, b, x, y, path, rest)
    base = nx * x + ny * y - radii - (rows[0, 0] if a.vertex_count == 0 else 0.0)
    free = 0.0
    for choice in range(4):
        disc_a, disc_b = choice % 2 == 1, choice >= 2
        if disc_a and (a.vertex_count == 0 or abs(a.turn) * rest < 1.0):
            continue
        if disc_b and abs(b.turn) * rest < 1.0:
            continue
        bound = GapBound(
            nx,
            ny,
            base - (a.lever if disc_a else 0.0) - (b.lever if disc_b else 0.0),
            rate,
            (0.0 if disc_a else curvature_a) + (0.0 if disc_b else curvature_b),
            a.turn,
            b.turn - spin,
            0 if disc_a else a.vertex_count,
            b.first,
            0 if disc_b else b.vertex_count,
        )
        free = max(free, fraction_below_root(bound, rest, rows))
        if free >= rest:
            return free
    if a.vertex_count > 1 and a.turn != 0.0:
        free = max(free, advance_seen_from(a, b, (nx, ny), (x, y), path, radii, rest, rows))
    if free < rest and a.vertex_count > 0 and b.vertex_count > 1 and b.turn != 0.0:
        back = RelativePath(-path.x, -path.y, -path.dx, -path.dy, path.turn_b, path.turn_a)
        free = max(free, advance_seen_from(b, a, (-nx, -ny), (-x, -y), back, radii, rest, rows))
    return free


def advance_seen_from(
    a: Sweep,
    b: Sweep,
    normal: Vector,
    at: Vector,
    path: RelativePath,
    radii: float,
    rest: float,
    rows: Array,
) -> float:
    """Return the same along a normal that turns with A; B is at a place from A, m."""
    nx, ny = normal
    reach_a = -least_along(a.first, a.vertex_count, -nx, -ny, rows)
    bound = GapBound(
        nx,
        ny,
        nx * at[0] + ny * at[1] - radii - reach_a,
        gap_change((path.dx, path.dy), normal, a.turn, at),
        turning_curvature(a.turn, b, at[0], at[1], path, rest) + arc_bend(b.turn, b.lever),
        0.0,
        b.turn - a.turn,
        0,
        b.first,
        b.vertex_count,
    )
    return fraction_below_root(bound, rest, rows)


def turning_curvature(
    turn: float, b: Sweep, x: float, y: float, path: RelativePath, rest: float
) -> float:
    """Return the largest part of second order in a gap along a normal that turns with A, m."""
    centre = motion_bound((path.dx, path.dy), 0.0, 0.0)
    far = distance_bound(sqrt(x * x + y * y), b.lever, rest, centre)
    speed = motion_bound((path.dx, path.dy), b.turn, b.lever)
    turned = circling(turn, 0.0)
    return -centre_acceleration_turning(turned, far, abs(turn), speed, 0.0, 0.0, 0.0)


def fraction_below_root(bound: GapBound, rest: float, rows: Array) -> float:
    """Return a fraction below the root of phi, near it, or the rest if the root is not within."""
    low, high = 0.0, rest
    over = least_gap(low, bound, rows)
    if over <= 0.0:
        return 0.0
    enough = 2.0**-4 * over
    under = least_gap(high, bound, rows)
    if under >= 0.0:
        return rest
    for _ in range(BISECTIONS):
        low += (high - low) * over / (over - under)
        over = least_gap(low, bound, rows)
        if over <= enough:
            break
        middle = 0.5 * (low + high)
        value = least_gap(middle, bound, rows)
        if value > 0.0:
            low, over = middle, value
        else:
            high, under = middle, value
    return low


def least_gap(ahead: float, bound: GapBound, rows: Array) -> float:
    """Return phi after a further fraction, m."""
    against_x, against_y = normal_turned((-bound.nx, -bound.ny), bound.turn_a, ahead)
    along_x, along_y = normal_turned((bound.nx, bound.ny), bound.turn_b, ahead)
    low_a = least_along(0, bound.count_a, against_x, against_y, rows)
    low_b = least_along(bound.first_b, bound.count_b, along_x, along_y, rows)
    return separation_least(bound.base, low_a, low_b, bound.rate, bound.curvature, ahead)


def least_along(first: int, count: int, nx: float, ny: float, rows: Array) -> float:
    """Return how far the vertices are along a direction at least, m; 0 for none."""
    low = UNBOUNDED if count > 0 else 0.0
    for k in range(first, first + count):
        low = min(low, nx * rows[k, 0] + ny * rows[k, 1])
    return low
