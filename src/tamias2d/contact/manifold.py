"""The contact manifold of a touching pair: one point, or the two ends of a flat contact.

Velocities (IM3) and accelerations (GD3) of a contact come from the generated functions.
"""

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

from tamias2d.contact.core import Core, Placed
from tamias2d.contact.gap import Axis, Gap, axes, from_side, gaps, nearest_gap
from tamias2d.contact.refusal import UndecidedContactError, named
from tamias2d.contact.terrain import normals
from tamias2d.float64 import EPSILON
from tamias2d.generated import definitions, friction, impact, rest
from tamias2d.state import Acceleration, State, Vector

LASTING_NOISE = 1e-9
"""Of the speeds: the excluded velocity that a lasting contact may have gathered by rounding."""


class Contact(NamedTuple):
    """One touching point of bodies A and B."""

    a: int
    b: int
    normal: Vector
    """Unit, from A to B."""
    arm_a: Vector
    """From the centre of mass of A to the point, m."""
    arm_b: Vector
    point: Vector
    """In the world, m."""
    axis: Axis
    gap: Gap
    found: tuple[bool, int]
    """Axis (`swapped`) and corner of Q by which it was found; `axis` and `gap` are others where the
    side of P ends before that corner."""


def manifold(
    a: Placed,
    b: Placed,
    tolerance: float,
    time: float,
    lasting: Sequence[Contact] = (),
    separating_direction: Vector | None = None,
) -> list[Contact]:
    """Return the contacts of a pair that touches within a tolerance in m; none if corners part.

    The `lasting` contacts stay in it, whatever rounding does to their gaps, and a side that one of
    them touches keeps it where corner comes upon corner.
    `separating_direction` is the direction from A to B in which they were last apart.
    """
    found = axes(a, b)
    found = normals(a, b, found) or found
    found = from_side(a, b, found, lasting[0].normal if lasting else separating_direction)
    axis = max(found, key=lambda each: each.gap)
    directions = _equal_directions(found, axis, tolerance)
    if directions:
        found = _facing(a, b, found, axis.gap - tolerance, tolerance)
        axis = max(found, key=lambda each: each.gap)
        directions = _equal_directions(found, axis, tolerance)
    if directions and (own := _own_axis(found, axis.gap - tolerance, lasting)):
        axis = own
    elif directions:
        noise = LASTING_NOISE if lasting else 64 * EPSILON
        contact = _corner_on_corner(a, b, axis, directions, time, noise)
        return [] if contact is None else [contact]
    if axis.side is None:
        return [_contact(a, b, axis, nearest_gap(a, b, axis))]
    touching = _touching_corners(a, b, axis, tolerance, lasting)
    if len(touching) == 1:
        return [_contact(a, b, axis, touching[0])]
    return _flat_manifold(a, b, axis, axis.side.ends, touching, tolerance)


def _touching_corners(
    a: Placed, b: Placed, axis: Axis, tolerance: float, lasting: Sequence[Contact]
) -> list[Gap]:
    """Return the gaps of the corners that touch a side: of the nearest one at least."""
    known = [contact.found for contact in lasting] + [
        (contact.axis.swapped, contact.gap.which[1]) for contact in lasting
    ]
    found = gaps(a, b, axis)
    last = [gap.value for gap in found if (axis.swapped, gap.which[1]) in known]
    drifted = max([0.0, *(gap for gap in last if gap > tolerance)])
    limit = (drifted if lasting else axis.gap) + tolerance
    touching = [gap for gap in found if gap.value <= limit or (axis.swapped, gap.which[1]) in known]
    return touching or [min(found, key=lambda gap: gap.value)]


def _flat_manifold(
    a: Placed, b: Placed, axis: Axis, ends: Vector, touching: list[Gap], tolerance: float
) -> list[Contact]:
    """Return the two ends of what a side and several corners have in common."""
    along = [_along(a, b, axis, gap) for gap in touching]
    first, last = along.index(min(along)), along.index(max(along))
    low, high = ends
    if min(along[last], high) - max(along[first], low) <= tolerance:  # only ends meet: one point
        return [_contact(a, b, axis, touching[first])]
    return [
        _at_end(a, b, axis, touching[first], 0)
        if along[first] < low
        else _contact(a, b, axis, touching[first]),
        _at_end(a, b, axis, touching[last], 1)
        if along[last] > high
        else _contact(a, b, axis, touching[last]),
    ]


def refreshed(contact: Contact, a: Placed, b: Placed) -> Contact:
    """Return a contact of the same corners and sides at the present places of the bodies."""
    axis = contact.axis
    p, q = (b, a) if axis.swapped else (a, b)
    i, j = contact.gap.which
    w = q.corners[j]
    if axis.side is not None:
        now = axis._replace(direction=p.turned(axis.side.normal))
        gap = contact.gap._replace(corner=w)
    else:
        (px, py), (qx, qy) = p.state.position, q.state.position
        v = p.corners[i]
        x, y = qx - px + w[0] - v[0], qy - py + w[1] - v[1]
        distance = math.hypot(x, y)
        now = axis._replace(direction=(x / distance, y / distance))
        gap = contact.gap._replace(corner=w, corner_p=v)
    return _contact(a, b, now, gap)._replace(found=contact.found)


def normal_velocity(contact: Contact, a: State, b: State) -> float:
    """Return the normal velocity of a contact, m/s; negative when the bodies approach."""
    return float(impact.normal_velocity(*_at(contact, a, b)))


def tangential_velocity(contact: Contact, a: State, b: State) -> float:
    """Return the tangential velocity of a contact, m/s (DD22)."""
    return float(friction.tangential_velocity(*_at(contact, a, b)))


def _at(contact: Contact, a: State, b: State) -> tuple[Any, ...]:
    return _motion(a, contact.arm_a, b, contact.arm_b, contact.normal)


def _motion(a: State, arm_a: Vector, b: State, arm_b: Vector, axis: Vector) -> tuple[Any, ...]:
    """Return what velocities at a point of two bodies, along an axis or across it, follow from."""
    return a.velocity, a.angular_velocity, arm_a, b.velocity, b.angular_velocity, arm_b, axis


def tangent_of(contact: Contact) -> Contact:
    """Return the contact with its tangent in place of its normal."""
    return contact._replace(normal=definitions.tangent(contact.normal))


def gap_acceleration(
    contact: Contact, a: Placed, b: Placed, of_a: Acceleration, of_b: Acceleration
) -> float:
    """Return the second derivative of the gap, m/s^2, under given accelerations (GD15)."""
    points = rest.normal_acceleration(
        of_a[:2], of_a[2], contact.arm_a, of_b[:2], of_b[2], contact.arm_b, contact.normal
    )
    p, q = (b, a) if contact.axis.swapped else (a, b)
    u, v, w = contact.axis.direction, contact.gap.corner_p, contact.gap.corner
    (px, py), (qx, qy) = p.state.position, q.state.position
    distance = u[0] * (qx - px + w[0] - v[0]) + u[1] * (qy - py + w[1] - v[1])
    spin_p, spin_q = p.state.angular_velocity, q.state.angular_velocity
    along = slip_velocity(contact, a.state, b.state)
    if contact.axis.side is not None:
        found = rest.gap_acceleration_side(points, spin_p, spin_q, w, u, along, distance)
    else:
        along, distance = (along, distance) if distance else (0.0, 1.0)
        found = rest.gap_acceleration_corner(points, spin_p, v, spin_q, w, u, along, distance)
    return float(found)


def tangential_acceleration(
    contact: Contact, a: Placed, b: Placed, of_a: Acceleration, of_b: Acceleration
) -> float:
    """Return the tangential acceleration of a contact that sticks, m/s^2, under given ones (GD16).

    A corner circles about its centre of mass; a rim stays where it is. That is right where the
    normal does not turn: for one body on what stands still.
    """
    points = friction.tangential_acceleration(
        of_a[:2], of_a[2], contact.arm_a, of_b[:2], of_b[2], contact.arm_b, contact.normal
    )
    spin_a, spin_b = (
        body.state.angular_velocity if len(body.core.corners) > 1 else 0.0 for body in (a, b)
    )
    tangent = definitions.tangent(contact.normal)
    return float(
        friction.tangential_acceleration_turning(
            points, spin_a, contact.arm_a, spin_b, contact.arm_b, tangent
        )
    )


def sticking_acceleration(
    contact: Contact, a: Placed, b: Placed, of_a: Acceleration, of_b: Acceleration
) -> float:
    """Return the tangential acceleration of a contact that sticks or rolls on anything (DD69).

    It holds where the normal turns, too; of a corner that sticks to a side that does not turn it
    says the same as `tangential_acceleration`.
    """
    points = friction.tangential_acceleration(
        of_a[:2], of_a[2], contact.arm_a, of_b[:2], of_b[2], contact.arm_b, contact.normal
    )
    swapped, side = contact.axis[:2]
    p, q = (b, a) if swapped else (a, b)
    corner_p, corner_q, u = contact.gap.corner_p, contact.gap.corner, contact.axis.direction
    if side is not None:
        turning = p.state.angular_velocity
    else:
        (px, py), (qx, qy) = p.state.position, q.state.position
        x, y = qx - px + corner_q[0] - corner_p[0], qy - py + corner_q[1] - corner_p[1]
        distance = u[0] * x + u[1] * y
        turning = slip_velocity(contact, a.state, b.state) / distance if distance else 0.0
    tangent = definitions.tangent(contact.normal)
    corners = (corner_q, corner_p) if swapped else (corner_p, corner_q)
    changes = [
        friction.reach_change(body.state.angular_velocity, corner, contact.normal, turning, tangent)
        for body, corner in zip((a, b), corners, strict=True)
    ]
    return float(
        friction.tangential_acceleration_rolling(
            points,
            turning,
            a.state.velocity,
            b.state.velocity,
            contact.normal,
            a.state.angular_velocity,
            changes[0],
            b.state.angular_velocity,
            changes[1],
        )
    )


def speed_scale(contact: Contact, a: State, b: State) -> float:
    """Return the size of the terms that make up the velocity of a contact, m/s."""
    return (
        math.hypot(*a.velocity)
        + math.hypot(*b.velocity)
        + abs(a.angular_velocity) * math.hypot(*contact.arm_a)
        + abs(b.angular_velocity) * math.hypot(*contact.arm_b)
    )


def slip_velocity(contact: Contact, a: State, b: State) -> float:
    """Return how fast the corner of Q moves along the side or past the corner of P, m/s.

    A disc is the corner in its middle: its spin slips nowhere.
    """
    p, q = (b, a) if contact.axis.swapped else (a, b)
    return float(
        friction.tangential_velocity(
            *_motion(p, contact.gap.corner_p, q, contact.gap.corner, contact.axis.direction)
        )
    )


def _along(a: Placed, b: Placed, axis: Axis, gap: Gap) -> float:
    """Return where a corner of Q lies along the side of P, from the centre of P, m."""
    p, q = (b, a) if axis.swapped else (a, b)
    ux, uy = axis.direction
    (px, py), (qx, qy) = p.state.position, q.state.position
    return ux * (qy - py + gap.corner[1]) - uy * (qx - px + gap.corner[0])


def _contact(a: Placed, b: Placed, axis: Axis, gap: Gap) -> Contact:
    """Return the contact at a corner of Q."""
    p, q = (b, a) if axis.swapped else (a, b)
    ux, uy = axis.direction
    (px, py), (qx, qy) = p.state.position, q.state.position
    arm_q = (gap.corner[0] - q.core.radius * ux, gap.corner[1] - q.core.radius * uy)
    arm_p = (arm_q[0] + (qx - px), arm_q[1] + (qy - py))
    point = (qx + arm_q[0], qy + arm_q[1])
    normal, arm_a, arm_b = (ux, uy), arm_p, arm_q
    if axis.swapped:
        normal, arm_a, arm_b = (-ux, -uy), arm_q, arm_p
    a_index, b_index = a.core.index, b.core.index
    return Contact(
        a_index, b_index, normal, arm_a, arm_b, point, axis, gap, (axis.swapped, gap.which[1])
    )


def _at_end(a: Placed, b: Placed, axis: Axis, gap: Gap, end: int) -> Contact:
    """Return the contact of P's corner with Q's side, where the side of P ends before Q's."""
    p, q = (b, a) if axis.swapped else (a, b)
    ux, uy = axis.direction
    index = (p.core.sides.index(axis.side) + end) % len(p.corners)
    side = min(q.core.sides, key=lambda each: _dot(q.turned(each.normal), (ux, uy)))
    other = Axis(not axis.swapped, side, (-ux, -uy), axis.gap)
    corner = gap._replace(corner=p.corners[index], which=(-1, index))
    return _contact(a, b, other, corner)._replace(found=(axis.swapped, gap.which[1]))


def _dot(normal: Vector, direction: Vector) -> float:
    return normal[0] * direction[0] + normal[1] * direction[1]


def _facing(a: Placed, b: Placed, found: list[Axis], least: float, tolerance: float) -> list[Axis]:
    """Return, of the axes whose gap is not less than the least one, those of sides at a corner.

    Of sides that are nearly parallel both touch, wherever along them the corners are.
    """
    touching = [axis for axis in found if axis.gap >= least]
    return [axis for axis in touching if _faces(a, b, axis, tolerance)] or touching


def _faces(a: Placed, b: Placed, axis: Axis, tolerance: float) -> bool:
    """Return whether corners that touch a side are not all beyond the same end of it."""
    if axis.side is None:
        return True
    low, high = axis.side.ends
    touching = [gap for gap in gaps(a, b, axis) if gap.value <= axis.gap + tolerance]
    along = [_along(a, b, axis, gap) for gap in touching]
    return max(along) >= low - tolerance and min(along) <= high + tolerance


def _equal_directions(found: list[Axis], best: Axis, tolerance: float) -> list[Vector]:
    """Return all directions from A to B in which a pair only just touches, if they differ."""
    ux, uy = best.direction
    equal = [axis for axis in found if axis.gap >= best.gap - tolerance]
    if all(abs(ux * v - uy * u) <= 1e-9 for _, _, (u, v), _ in equal):
        return []
    return [(-u, -v) if swapped else (u, v) for swapped, _, (u, v), _ in equal]


def _own_axis(found: Sequence[Axis], least: float, lasting: Sequence[Contact]) -> Axis | None:
    """Return the axis of the side that a lasting contact is on, if its gap is not less."""
    sides = [contact.axis[:2] for contact in lasting if contact.axis.side is not None]
    return next((axis for axis in found if axis[:2] in sides and axis.gap >= least), None)


def _corner_on_corner(
    a: Placed, b: Placed, axis: Axis, directions: list[Vector], time: float, noise: float
) -> Contact | None:
    """Return the contact of two corners: its normal is their approach, or nearest to it (GD11).

    There is none if they part in one of the directions. `noise` is the share of the speeds that
    rounding leaves of an approach.

    Raises:
        UndecidedContactError: they neither approach nor part.
    """
    contact = _contact(a, b, axis, nearest_gap(a, b, axis))
    at_a, at_b = (
        definitions.point_velocity(body.state.velocity, body.state.angular_velocity, arm)
        for body, arm in ((a, contact.arm_a), (b, contact.arm_b))
    )
    if at_a != at_b:
        normal = definitions.normal(at_a, at_b)
        if not _between(normal, directions):
            normal = max(directions, key=lambda each: _dot(each, normal))
        contact = contact._replace(
            normal=normal,
            axis=Axis(False, None, normal, axis.gap),
            gap=contact.gap._replace(corner=contact.arm_b, corner_p=contact.arm_a),
        )
        unseen = noise * speed_scale(contact, a.state, b.state)
        if normal_velocity(contact, a.state, b.state) < -unseen:
            return contact
        u, v = at_b[0] - at_a[0], at_b[1] - at_a[1]
        if max(_dot((u, v), each) for each in directions) > unseen:
            return None
    raise corner_on_corner_error(a.core, b.core, time)


def corner_on_corner_error(a: Core, b: Core, time: float) -> UndecidedContactError:
    """Return the error of a sharp corner that stays on another."""
    return UndecidedContactError(
        f"{named(a.name, b.name)} at {time!r} s: corner meets corner without approach, so that "
        "the normal is not unique (GD11). Move one of them a little.",
        time=time,
    )


def _between(direction: Vector, others: list[Vector]) -> bool:
    """Whether a direction is a sum of others, none of them turned around."""
    x, y = direction
    turns = [x * v - y * u for u, v in others]
    separating_direction = [x * u + y * v > 0 for u, v in others]
    return all(separating_direction) and min(turns) <= 0 <= max(turns)
