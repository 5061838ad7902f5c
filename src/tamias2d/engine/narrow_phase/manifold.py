"""The manifold of a contact: kept while its bodies hardly move, else found within a margin."""

from tamias2d.engine import tables as tb
from tamias2d.engine.narrow_phase.collide import collide
from tamias2d.engine.narrow_phase.half_plane import is_above
from tamias2d.engine.narrow_phase.margins import CLOSE, relative_speeds, speculative_margins
from tamias2d.engine.narrow_phase.reuse import move_gaps, note_pose
from tamias2d.engine.tables import Bodies, Contacts, Integers, Shapes
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

STILL = 2.0**-10  # a way for which a manifold is kept: its gaps are wrong by its square, 1e-6
PARTED = 0.05  # of the margin: how much farther apart points are when a contact loses them


@inlined
def update_manifold(
    p: int,
    smaller: float,
    touched: bool,
    fall: float,
    time: float,
    bodies: Bodies,
    shapes: Shapes,
    contacts: Contacts,
) -> tuple[int, float]:
    """Find the points of a contact, or keep them; return how many, and the margin, m, for them."""
    speeds = relative_speeds(contacts.pairs[p], bodies, shapes)
    way = (speeds[0] + speeds[1]) * time
    slow = touched & (way <= STILL * smaller)
    if slow and keeps_manifold(p, smaller, bodies, shapes, contacts):
        return 2, CLOSE * smaller + way
    margin, further = speculative_margins(
        contacts.pairs[p], smaller, touched, speeds, fall, time, bodies, shapes
    )
    return find_manifold(p, margin, further, bodies, shapes, contacts), margin


@inlined
def keeps_manifold(
    p: int, smaller: float, bodies: Bodies, shapes: Shapes, contacts: Contacts
) -> bool:
    """Let the gaps of two points follow their bodies, which hardly move; return whether they may.

    Which side of a thin shape the other one is on, is asked anew.
    """
    s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
    i, j = contacts.pairs[p, tb.SLOT_A], contacts.pairs[p, tb.SLOT_B]
    if contacts.flags[p, tb.POINT_COUNT] != 2 or not both_plain(s, t, shapes):
        return False
    x, y = bodies.pose[j, tb.X] - bodies.pose[i, tb.X], bodies.pose[j, tb.Y] - bodies.pose[i, tb.Y]
    radii = shapes.material[s, tb.SHAPE_RADIUS] + shapes.material[t, tb.SHAPE_RADIUS]
    angle_a, angle_b = bodies.pose[i, tb.ANGLE], bodies.pose[j, tb.ANGLE]
    return move_gaps(x, y, angle_a, angle_b, radii, STILL * smaller, contacts.manifolds[p])


@inlined
def both_plain(s: int, t: int, shapes: Shapes) -> bool:
    """Return whether neither of two shapes is thin."""
    return bool((shapes.kind[s] < tb.THIN_CAPSULE) & (shapes.kind[t] < tb.THIN_CAPSULE))


@inlined
def find_manifold(
    p: int, margin: float, further: float, bodies: Bodies, shapes: Shapes, contacts: Contacts
) -> int:
    """Find the points of a contact if a gap is below the margin, m; return how many there are.

    Of another point it may be larger by so much further, m. A contact that has points loses them at
    a slightly larger gap than it got them, lest all be arranged anew whenever a gap trembles.
    """
    s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
    i, j = contacts.pairs[p, tb.SLOT_A], contacts.pairs[p, tb.SLOT_B]
    x, y = bodies.pose[j, tb.X] - bodies.pose[i, tb.X], bodies.pose[j, tb.Y] - bodies.pose[i, tb.Y]
    radius_s, radius_t = shapes.material[s, tb.SHAPE_RADIUS], shapes.material[t, tb.SHAPE_RADIUS]
    points = contacts.flags[p, tb.POINT_COUNT]
    radii = radius_s + radius_t + margin
    if points == 0 and (
        x * x + y * y > radii * radii or over_plane(p, x, y, margin, shapes, contacts)
    ):
        return 0
    kept = PARTED * margin
    far = max(further, kept) if points > 0 else 0.0
    count = collide(p, s, t, x, y, margin + far, shapes, contacts)
    if count > 0 and far > 0.0 and smallest_gap(contacts.manifolds[p], count) > margin + kept:
        contacts.flags[p, tb.POINT_COUNT] = 0
        return 0
    if count == 1 and further > far:
        count = collide(p, s, t, x, y, margin + further, shapes, contacts)
    if count == 2 and both_plain(s, t, shapes):
        angle_a, angle_b = bodies.pose[i, tb.ANGLE], bodies.pose[j, tb.ANGLE]
        note_pose(x, y, angle_a, angle_b, 0.0, contacts.manifolds[p])
    return count


@inlined
def over_plane(
    p: int, x: float, y: float, margin: float, shapes: Shapes, contacts: Contacts
) -> bool:
    """Return whether a shape is farther from a half-plane than a margin, m, and keeps no feature.

    The body of the second shape is at (x, y) from that of the first one.
    """
    s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
    if contacts.flags[p, tb.FEATURE] != 0:
        return False
    if shapes.kind[s] == tb.HALF_PLANE:
        side = shapes.world_vertices[shapes.first[s]]
        return is_above(x, y, shapes.material[t, tb.SHAPE_RADIUS], margin, side)
    if shapes.kind[t] == tb.HALF_PLANE:
        side = shapes.world_vertices[shapes.first[t]]
        return is_above(-x, -y, shapes.material[s, tb.SHAPE_RADIUS], margin, side)
    return False


def known_gap(manifold: Array, flags: Integers) -> float:
    """Return the smallest gap of a contact as it was found last, m; 0 without points."""
    return smallest_gap(manifold, flags[tb.POINT_COUNT]) if flags[tb.POINT_COUNT] > 0 else 0.0


def smallest_gap(manifold: Array, count: int) -> float:
    """Return the smallest gap of some points, m."""
    gap: float = manifold[tb.GAP]
    return min(gap, manifold[tb.GAP + tb.POINT]) if count == 2 else gap
