"""Pairs that meet at one instant and share bodies that move: they are listed, one after another."""

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.conservative_advancement import NEAR
from tamias2d.engine.continuous.events import manifold_at, relative_motion
from tamias2d.engine.continuous.passing import smaller_radius
from tamias2d.engine.joined import unless_joined
from tamias2d.engine.narrow_phase.polygon import held_normal
from tamias2d.engine.tables import Bodies, Contacts, Events, Integers, Shapes

STRAYED = 2.0**-40  # of a way: more than rounding
EARLY = 4.0  # distances that count as meeting: pairs that are farther from it meet later


def gather_meetings(
    p: int,
    now: float,
    time_step: float,
    bodies: Bodies,
    shapes: Shapes,
    contacts: Contacts,
    events: Events,
) -> int:
    """List the pairs that meet when one does, and share a body with one of them; return how many.

    Bodies whose contacts the solver has treated meet others one by one.
    """
    add_meeting(p, 0, shapes, contacts, events)
    if was_solved(p, time_step, bodies, contacts):
        return 1
    count, k = 1, 0
    while k < count:
        for i in (events.met[k, tb.MET_A], events.met[k, tb.MET_B]):
            if bodies.kind[i] == tb.DYNAMIC:
                count = add_meetings_of(i, now, time_step, count, bodies, shapes, contacts, events)
        k += 1
    return count


def add_meetings_of(
    i: int,
    now: float,
    time_step: float,
    count: int,
    bodies: Bodies,
    shapes: Shapes,
    contacts: Contacts,
    events: Events,
) -> int:
    """List the pairs of a body that meet, too; return how many are listed then."""
    p = events.met[0, tb.MET_CONTACT]
    for k in range(events.queue[tb.FIRST_OF_BODY, i], events.queue[tb.FIRST_OF_BODY, i + 1]):
        q = events.queue[tb.CONTACT_OF_BODY, k]
        if events.times[len(bodies.kind) + q] > 1.0:
            continue
        if count == tb.MOST_AT_ONCE or is_listed(q, count, events.met):
            continue
        near = max(near_of(p, shapes, contacts), near_of(q, shapes, contacts))
        solved = was_solved(q, time_step, bodies, contacts)
        if not solved and may_meet_at(now, q, near, bodies, contacts, events):
            add_meeting(q, count, shapes, contacts, events)
            if measure_meeting(count, now, bodies, shapes, contacts, events) <= near:
                count += 1
    return count


def is_listed(q: int, count: int, met: Integers) -> bool:
    """Return whether a contact is listed."""
    found = False
    for k in range(count):
        found = found or met[k, tb.MET_CONTACT] == q
    return found


def is_first_listed(i: int, k: int, met: Integers) -> bool:
    """Return whether no pair that is listed before number k has a body."""
    found = False
    for n in range(k):
        found = found or i in (met[n, tb.MET_A], met[n, tb.MET_B])
    return not found


def was_solved(p: int, time_step: float, bodies: Bodies, contacts: Contacts) -> bool:
    """Return whether the solver has treated contacts of a body of a pair."""
    i, j = contacts.pairs[p, tb.SLOT_A], contacts.pairs[p, tb.SLOT_B]
    supported = bodies.flight[i, tb.SUPPORTED] + bodies.flight[j, tb.SUPPORTED] > 0.0
    return bool(supported or strays(i, time_step, bodies) or strays(j, time_step, bodies))


def strays(i: int, time_step: float, bodies: Bodies) -> bool:
    """Return whether the path of a body that no force pushes is not that of its velocity."""
    gain, motion = bodies.flight[i], bodies.motion[i]
    pushed = (
        abs(gain[tb.FORCE_GAIN]) + abs(gain[tb.FORCE_GAIN + 1]) + abs(gain[tb.FORCE_GAIN + 2]) > 0.0
    )
    if bodies.kind[i] != tb.DYNAMIC or pushed:
        return False
    off = far = 0.0
    for n in range(3):
        size = bodies.properties[i, tb.CORE_RADIUS] if n == 2 else 1.0
        off += size * abs(motion[tb.DX + n] - time_step * motion[n])
        far += size * abs(time_step * motion[n])
    return bool(off > STRAYED * far)


def near_of(p: int, shapes: Shapes, contacts: Contacts) -> float:
    """Return the distance at which the shapes of a pair count as meeting, m."""
    s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
    return NEAR * smaller_radius(s, t, shapes.material)


def may_meet_at(
    now: float, q: int, near: float, bodies: Bodies, contacts: Contacts, events: Events
) -> bool:
    """Return whether a pair may be so near at an instant, m, as it is found to meet later."""
    i, j = contacts.pairs[q, tb.SLOT_A], contacts.pairs[q, tb.SLOT_B]
    later = events.times[len(bodies.kind) + q] - now
    close = later * relative_motion(i, j, bodies) <= EARLY * near
    close = unless_joined(close, i, j, bodies)
    return close and contacts.flags[q, tb.SENSES] == 0


def add_meeting(q: int, k: int, shapes: Shapes, contacts: Contacts, events: Events) -> None:
    """List a pair as the one of number k."""
    turned = 1 if shapes.kind[contacts.pairs[q, 1]] == tb.HALF_PLANE else 0
    events.met[k, tb.MET_CONTACT], events.met[k, tb.MET_TURNED] = q, turned
    events.met[k, tb.MET_A] = contacts.pairs[q, tb.SLOT_B if turned else tb.SLOT_A]
    events.met[k, tb.MET_B] = contacts.pairs[q, tb.SLOT_A if turned else tb.SLOT_B]
    for n in range(2):
        events.met_sides[k, n] = 0.0


def measure_meeting(
    k: int, now: float, bodies: Bodies, shapes: Shapes, contacts: Contacts, events: Events
) -> float:
    """Write the manifold of a listed pair at an instant to the scratch; return its gap, m.

    Thin shapes stay on the side on which they are seen to be first.
    """
    q, turned = events.met[k, tb.MET_CONTACT], events.met[k, tb.MET_TURNED]
    s, t = contacts.pairs[q, turned], contacts.pairs[q, 1 - turned]
    held = held_normal(contacts.manifolds[q], contacts.flags[q])
    if held[0] == 0.0 and held[1] == 0.0:
        held = (events.met_sides[k, 0], events.met_sides[k, 1])
    gap = manifold_at(s, t, now, held, bodies, shapes, events)
    events.met_sides[k, 0], events.met_sides[k, 1] = (
        events.scratch[0, tb.NX],
        events.scratch[0, tb.NY],
    )
    return gap
