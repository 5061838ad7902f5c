"""The gap between two bodies along an axis that separates them.

An axis belongs to a side of one of the bodies, and turns with it, or to the world. Along it, the
gap between one body and each corner of the other is a smooth function of time, and the smallest
of these gaps is never more than the true separation of the two convex bodies:

    side of P, corner of Q:    gap = u . (q + w - p) - offset - radius_q    (offset has radius_p)
    corner of P, corner of Q:  gap = u . (q + w - p - v) - radius_p - radius_q

with centres p and q, corners v and w from them, and the unit axis u from P to Q. Its rate is the
normal velocity (DD11) of the corner of Q against P's point there, or against P's corner.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from tamias2d.contact.core import Placed, Side
from tamias2d.float64 import EPSILON
from tamias2d.generated.impact import normal_velocity
from tamias2d.state import Array, Vector

_LEAST = 5e-324
_BEHIND = -0.5  # cosine between directions that separate a pair from either side
_MANY = 256  # products, from which on numpy is faster
_AWAY = 4  # of the rounding of a place: by how far a step that leaves a side turns away from it
_IN_LINE = 1e-12  # of the sizes: by how much rounding may make collinear cores seem to cross


class Axis(NamedTuple):
    """A direction that separates a pair: `side` of the owner, or of the world if it is None."""

    swapped: bool
    """Whether the owner, P, is the second of the pair."""
    side: Side | None
    direction: Vector
    """u at this instant, from P to Q."""
    gap: float
    """The smallest gap at this instant, m."""

    @property
    def separating_direction(self) -> Vector:
        """The direction from the first body of the pair to the second."""
        x, y = self.direction
        return (-x, -y) if self.swapped else (x, y)


class Gap(NamedTuple):
    """The gap to one corner at one instant."""

    value: float
    """m"""
    rate: float
    """m/s"""
    reach: tuple[float, float]
    """Distance of the corners of P and Q from their centres, m; 0 for a side."""
    corner: Vector
    """The corner of Q, from its centre, m."""
    corner_p: Vector
    """The corner of P, from its centre, m; (0, 0) for a side."""
    which: tuple[int, int]
    """Which corners of P and Q these are; -1 for a side."""


def axes(a: Placed, b: Placed) -> list[Axis]:
    """Return the axes of a pair; the largest of their gaps is at most the separation.

    It is 0 exactly when they touch, and negative when they overlap.
    """
    found = []
    if a.core.sides and b.core.corners:
        found += _of_sides(a, b, swapped=False)
    if b.core.sides and a.core.corners:
        found += _of_sides(b, a, swapped=True)
    if not found:
        return [_of_centres(a, b)]
    if len(a.core.corners) == 1:
        return _with_corner(found, b, a, swapped=True)
    if len(b.core.corners) == 1:
        return _with_corner(found, a, b, swapped=False)
    if a.core.radius or b.core.radius or min(len(a.core.corners), len(b.core.corners)) == 2:
        return _with_nearest(found, a, b)
    return found


def from_side(
    a: Placed, b: Placed, found: list[Axis], separating_direction: Vector | None
) -> list[Axis]:
    """Return the axes that do not point against the direction in which the pair was last apart.

    Where thin bodies touch, the axes of both their sides have no gap: to go on along the other one
    would be to pass through. Corners that rounding has let past each other overlap.
    """
    if separating_direction is None:
        return found
    ux, uy = separating_direction
    same = [
        axis
        for axis in found
        if ux * axis.separating_direction[0] + uy * axis.separating_direction[1] > _BEHIND
    ]
    if same or found[0].side is not None:
        return same or found
    (x, y), base = found[0].direction, a.core.radius + b.core.radius
    return [found[0]._replace(direction=(-x, -y), gap=-found[0].gap - 2 * base)]


def either_side(found: list[Axis], tolerance: float) -> Vector | None:
    """Return the direction of an axis of which the opposite one has no gap either, or None."""
    touching = [axis.separating_direction for axis in found if abs(axis.gap) <= tolerance]
    for ux, uy in touching:
        if any(ux * x + uy * y < _BEHIND for x, y in touching):
            return ux, uy
    return None


def gaps(a: Placed, b: Placed, axis: Axis) -> list[Gap]:
    """Return the gaps along an axis, with their rates, one for each corner."""
    p, q = (b, a) if axis.swapped else (a, b)
    direction = ux, uy = axis.direction
    (px, py), (qx, qy) = p.state.position, q.state.position
    dx, dy, v_p, v_q = qx - px, qy - py, p.state.velocity, q.state.velocity
    spin_p, spin_q = p.state.angular_velocity, q.state.angular_velocity
    found = []
    if axis.side is not None:
        base = axis.side.offset + q.core.radius
        for j, (wx, wy) in enumerate(q.corners):
            x, y = dx + wx, dy + wy
            rate = normal_velocity(v_p, spin_p, (x, y), v_q, spin_q, (wx, wy), direction)
            reach = (0.0, q.core.reaches[j])
            value = ux * x + uy * y - base
            found.append(Gap(value, rate, reach, (wx, wy), (0.0, 0.0), (-1, j)))
        return found
    base = p.core.radius + q.core.radius
    for i, (vx, vy) in enumerate(p.corners):
        for j, (wx, wy) in enumerate(q.corners):
            x, y = dx + wx - vx, dy + wy - vy
            rate = normal_velocity(v_p, spin_p, (vx, vy), v_q, spin_q, (wx, wy), direction)
            value = ux * x + uy * y - base
            reach = (p.core.reaches[i], q.core.reaches[j])
            found.append(Gap(value, rate, reach, (wx, wy), (vx, vy), (i, j)))
    return found


def nearest_gap(a: Placed, b: Placed, axis: Axis) -> Gap:
    """Return the least gap along an axis; of one from corner to corner, the gap between these.

    Other corners may be as far along it: both of a side from whose end it starts.
    """
    found = gaps(a, b, axis)
    if axis.side is not None:
        return min(found, key=lambda gap: gap.value)
    p, q = (b, a) if axis.swapped else (a, b)
    (px, py), (qx, qy) = p.state.position, q.state.position

    def distance(gap: Gap) -> float:
        (wx, wy), (vx, vy) = gap.corner, gap.corner_p
        return math.hypot(qx - px + wx - vx, qy - py + wy - vy)

    return min(found, key=distance)


def resolution(a: Placed, b: Placed, time: float) -> float:
    """Return the gap in m that float64 cannot tell from 0, at such positions and times."""
    (ax, ay), (bx, by) = a.state.position, b.state.position
    (au, av), (bu, bv) = a.state.velocity, b.state.velocity
    length = abs(ax) + abs(ay) + abs(bx) + abs(by) + a.core.size + b.core.size
    speed = abs(bu - au) + abs(bv - av)
    for body in (a, b):
        if body.core.sides:
            speed += abs(body.state.angular_velocity) * body.core.size
    return EPSILON * (16 * length + 4 * speed * time)


def slight_opening(a: Placed, b: Placed, time: float, until: float) -> float:
    """Return the acceleration in m/s^2 by which a pair opens too little to be seen `until` then."""
    left = max(until - time, _LEAST)  # its square may be beyond float64
    return 2 * resolution(a, b, time) / left / left


def _of_sides(p: Placed, q: Placed, *, swapped: bool) -> list[Axis]:
    (px, py), (qx, qy) = p.state.position, q.state.position
    dx, dy = qx - px, qy - py
    radius, sides = q.core.radius, p.core.sides
    directions = [p.turned(side.normal) for side in sides]
    found = []
    for side, (ux, uy), nearest in zip(sides, directions, _nearest(directions, q), strict=True):
        gap = ux * dx + uy * dy + nearest - side.offset - radius
        found.append(Axis(swapped, side, (ux, uy), gap))
    return found


def _nearest(directions: Sequence[Vector], q: Placed) -> list[float]:
    """Return where the first corner of a body lies along each direction, from its centre, m.

    Many at once are found by numpy, with the same bits: products and sums are rounded alike.
    """
    if len(directions) * len(q.corners) < _MANY:
        return [min([ux * wx + uy * wy for wx, wy in q.corners]) for ux, uy in directions]
    u, w = np.array(directions), np.array(q.corners)
    along: Array = np.multiply.outer(u[:, 0], w[:, 0]) + np.multiply.outer(u[:, 1], w[:, 1])
    nearest: list[float] = along.min(axis=1).tolist()
    return nearest


def _of_centres(a: Placed, b: Placed) -> Axis:
    (ax, ay), (bx, by) = a.state.position, b.state.position
    return _between((bx - ax, by - ay), a.core.radius + b.core.radius, swapped=False)


def _with_corner(found: list[Axis], p: Placed, disc: Placed, *, swapped: bool) -> list[Axis]:
    """Add the axis from a polygon's corner to a disc, if a corner is what is nearest to it."""
    best = max(found, key=lambda axis: axis.gap)
    radius = p.core.radius + disc.core.radius
    inside = best.gap + radius <= 0 and len(p.corners) > 2  # nothing is inside of a line
    if best.side is None or inside or math.isinf(best.side.ends[0]):
        return found
    ux, uy = best.direction
    (px, py), (qx, qy) = p.state.position, disc.state.position
    dx, dy = qx - px, qy - py
    along = dy * ux - dx * uy
    low, high = best.side.ends
    if low <= along <= high:
        return found
    t = low if along < low else high
    offset = best.side.offset - p.core.radius
    corner = (offset * ux - t * uy, offset * uy + t * ux)
    return [_between((dx - corner[0], dy - corner[1]), radius, swapped=swapped)]


def _with_nearest(found: list[Axis], a: Placed, b: Placed) -> list[Axis]:
    """Return the axis from corner to corner instead, if these are nearest: round or thin ends."""
    base = a.core.radius + b.core.radius
    crossed = max(axis.gap for axis in found) + base < -_IN_LINE * (a.core.size + b.core.size)
    if crossed or not (a.core.corners and b.core.corners):
        return found
    (ax, ay), (bx, by) = a.state.position, b.state.position
    dx, dy = bx - ax, by - ay
    steps = [
        ((dx + qx - px, dy + qy - py), i, j)
        for i, (px, py) in enumerate(a.corners)
        for j, (qx, qy) in enumerate(b.corners)
    ]
    (x, y), i, j = min(steps, key=lambda each: math.hypot(*each[0]))
    # thin ends at no distance have a direction by rounding alone
    slack = _AWAY * EPSILON * (abs(dx) + abs(dy) + a.core.size + b.core.size) if base else 0.0
    if _leaves((x, y), a.corners, i, slack) and _leaves((-x, -y), b.corners, j, slack):
        return [_between((x, y), base, swapped=False)]
    return found


def _leaves(step: Vector, corners: Sequence[Vector], k: int, slack: float) -> bool:
    """Return whether a step from a corner turns away from both sides there.

    A comparison of distances would tell that only to the root of rounding.
    """
    x, y = corners[k]
    sides = [(u - x, v - y) for u, v in (corners[k - 1], corners[(k + 1) % len(corners)])]
    return all(step[0] * u + step[1] * v < -slack * math.hypot(u, v) for u, v in sides)


def _between(difference: Vector, base: float, *, swapped: bool) -> Axis:
    x, y = difference
    distance = math.hypot(x, y)
    direction = (x / distance, y / distance) if distance else (1.0, 0.0)
    return Axis(swapped, None, direction, distance - base)
