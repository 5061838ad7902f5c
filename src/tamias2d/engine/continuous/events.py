"""When two bodies meet on their paths through a step."""

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.conservative_advancement import (
    MISSED,
    NEAR,
    measure_gap,
    measure_gap_of_piece,
    time_of_impact,
)
from tamias2d.engine.continuous.event_queue import update_event
from tamias2d.engine.continuous.impact import normal_line
from tamias2d.engine.continuous.impulse import path_speed_along
from tamias2d.engine.continuous.passing import keep_away, smaller_radius, turn_shape_to
from tamias2d.engine.continuous.sensing import may_be_sensed, time_of_sensing
from tamias2d.engine.continuous.trajectory import relative_path, relative_place
from tamias2d.engine.joined import unless_joined
from tamias2d.engine.narrow_phase.approach import opening
from tamias2d.engine.narrow_phase.core import core_of, is_piece
from tamias2d.engine.narrow_phase.margins import BULLET
from tamias2d.engine.narrow_phase.material import BOUNCY, mixed_material
from tamias2d.engine.narrow_phase.polygon import held_normal
from tamias2d.engine.tables import Bodies, BroadPhase, Contacts, Control, Events, Shapes
from tamias2d.generated.continuous_collision import closing_bound, motion_bound
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array, Vector

# how far one body may go into another, from where the solver pushes it back, as a fraction of half
# the width of the thinner one; it is not farther than the smaller bounding radius
PUSHED_BACK = 0.7
THIN = 0.25  # of the smaller radius: for the length of parts thinner bodies are as thick as this
SHALLOW = 0.12  # of that: how far one goes in before its impact is looked for
MOST_SHALLOW = 24  # pairs in a part that are looked at for that
SHORT_LIST = 256  # contacts of a list on which all are
MANY = -1  # more than these
RESTING = 0.1  # of the limit: how far bodies go in a part that rest in each other
SWUNG = 0.35  # of the smaller radius: how far a body may turn about a contact, in which it is held


def find_events(
    now: float,
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    broad_phase: BroadPhase,
    contacts: Contacts,
    events: Events,
) -> int:
    """Find when pairs meet, from `now` on, that the solver may let through; return how many do.

    Shallow impacts are looked for if they are few.
    """
    found = sought = 0
    body_count, listed = len(bodies.pose), broad_phase.counts[tb.CONTACTS]
    most = MOST_SHALLOW if listed > SHORT_LIST else SHORT_LIST
    for p in range(listed):
        events.times[body_count + p] = MISSED
        s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
        i, j = contacts.pairs[p, tb.SLOT_A], contacts.pairs[p, tb.SLOT_B]
        redirected = bodies.flight[i, tb.REDIRECTED] + bodies.flight[j, tb.REDIRECTED] > 0.0
        reach = smaller_radius(s, t, shapes.material)
        located = 0 < contacts.flags[p, tb.LOCATED] < tb.SPENT
        share = control.progress[tb.DEPTH_SHARE]
        if not (redirected or located) and stay_near(i, j, share, reach, bodies):
            continue
        if contacts.flags[p, tb.SENSES] == 1:
            if may_be_sensed(contacts.flags[p]):
                time = time_of_sensing(s, t, now, bodies, shapes, events)
                events.times[body_count + p] = time
                found += time <= 1.0
            continue
        looked = redirected or located or may_pass(p, i, j, share, reach, bodies, contacts)
        looked = unless_joined(looked, i, j, bodies)
        if looked:
            sought += 1
            if share < 1.0 and sought > most:
                return MANY
            time = next_event(p, s, t, now, control, bodies, shapes, contacts, events)
            events.times[body_count + p] = time
            found += time <= 1.0
    return found


def bounces(p: int, shapes: Shapes, contacts: Contacts) -> bool:
    """Return whether an impact gives most of its energy back."""
    s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
    _, restitution = mixed_material(s, t, shapes.material, shapes.pair_overrides)
    return bool(restitution > BOUNCY)


@inlined
def may_pass(
    p: int, i: int, j: int, share: float, reach: float, bodies: Bodies, contacts: Contacts
) -> bool:
    """Return whether the paths of two bodies may lead one through the other.

    The solver holds bodies in contact back along the normal: only what goes against it, or turns,
    can come farther in.
    """
    motion = bodies.motion
    by_x, by_y = motion[j, tb.DX] - motion[i, tb.DX], motion[j, tb.DY] - motion[i, tb.DY]
    turn = turning_reach(i, j, motion, bodies.properties)
    deep = allowed_depth(i, j, reach, bodies.properties)
    if contacts.flags[p, tb.POINT_COUNT] == 0:
        return bool(abs(by_x) + abs(by_y) + turn > share * deep)
    fast = abs(by_x) + abs(by_y) + turn > BULLET * reach  # its corners have no contact ahead
    manifold, limit = contacts.manifolds[p], deep if fast else max(deep, SWUNG * reach)
    into = max(0.0, -manifold[tb.NX] * by_x - manifold[tb.NY] * by_y) + turn
    overlap = 0.0
    for n in range(contacts.flags[p, tb.POINT_COUNT]):
        overlap = max(overlap, -manifold[tb.GAP + tb.POINT * n])
    room = max(limit - overlap, RESTING * limit)
    return bool(into > room and closing_at_points(p, i, j, reach, bodies, contacts) > room)


def closing_at_points(
    p: int, i: int, j: int, reach: float, bodies: Bodies, contacts: Contacts
) -> float:
    """Return how far two bodies that touch come together at most, m."""
    manifold, a, b = contacts.manifolds[p], bodies.motion[i], bodies.motion[j]
    least = 0.0
    for n in range(contacts.flags[p, tb.POINT_COUNT]):
        least = min(least, opening(n, i, j, tb.DX, bodies, manifold))
    return closing_bound(
        least,
        a[tb.DANGLE],
        bodies.properties[i, tb.CORE_RADIUS],
        b[tb.DANGLE],
        bodies.properties[j, tb.CORE_RADIUS],
        2.0 * reach,
        abs(b[tb.DX] - a[tb.DX]) + abs(b[tb.DY] - a[tb.DY]),
    )


def turning_reach(i: int, j: int, motion: Array, properties: Array) -> float:
    """Return how far vertices of two bodies go by turning in a step, m."""
    none = (0.0, 0.0)
    of_i = motion_bound(none, motion[i, tb.DANGLE], properties[i, tb.CORE_RADIUS])
    return of_i + motion_bound(none, motion[j, tb.DANGLE], properties[j, tb.CORE_RADIUS])


def allowed_depth(i: int, j: int, reach: float, properties: Array) -> float:
    """Return how far one body may go into another and be pushed back, m."""
    thinner = min(properties[i, tb.MIN_EXTENT], properties[j, tb.MIN_EXTENT])
    return min(PUSHED_BACK * thinner, reach)


def stay_near(i: int, j: int, share: float, reach: float, bodies: Bodies) -> bool:
    """Return whether two bodies go too little for one to get far into the other.

    This is what follows from how far each goes, and not from where both go.
    """
    length: float = bodies.flight[i, tb.PATH_LENGTH] + bodies.flight[j, tb.PATH_LENGTH]
    return length <= share * allowed_depth(i, j, reach, bodies.properties)


def update_events_of(
    i: int,
    except_for: int,
    now: float,
    shallow: float,
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    contacts: Contacts,
    events: Events,
) -> None:
    """Find anew when a body meets all others but one: its path has changed.

    Pairs of moving bodies that come together by no more than a share of the depth from which they
    are pushed back do not count.
    """
    if bodies.kind[i] != tb.DYNAMIC:
        return
    body_count = len(bodies.pose)
    for k in range(events.queue[tb.FIRST_OF_BODY, i], events.queue[tb.FIRST_OF_BODY, i + 1]):
        p = events.queue[tb.CONTACT_OF_BODY, k]
        s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
        a, b = contacts.pairs[p, tb.SLOT_A], contacts.pairs[p, tb.SLOT_B]
        if except_for in (a, b):
            continue
        if contacts.flags[p, tb.SENSES] == 1:
            if may_be_sensed(contacts.flags[p]):
                time = time_of_sensing(s, t, now, bodies, shapes, events)
                events.times[body_count + p] = time
                update_event(body_count + p, events.times, events.queue)
            continue
        time = MISSED
        reach = smaller_radius(s, t, shapes.material)
        located = contacts.flags[p, tb.LOCATED]
        share = shallow if located == 0 else 1.0 if located == tb.SPENT else 0.0
        if shallow < 1.0 and bounces(p, shapes, contacts):
            share = 0.0
        looked = not goes_little(a, b, now, share, reach, bodies)
        looked = unless_joined(looked, a, b, bodies)
        if looked:
            time = next_event(p, s, t, now, control, bodies, shapes, contacts, events)
        events.times[body_count + p] = time
        update_event(body_count + p, events.times, events.queue)


def goes_little(i: int, j: int, now: float, share: float, reach: float, bodies: Bodies) -> bool:
    """Return whether two bodies come together by no more than a share of the allowed depth."""
    deep = allowed_depth(i, j, reach, bodies.properties)
    return bool(relative_motion(i, j, bodies) * (1.0 - now) <= share * deep)


def relative_motion(i: int, j: int, bodies: Bodies) -> float:
    """Return how far two bodies may come together in a part of a step, m."""
    motion = bodies.motion
    by = abs(motion[j, tb.DX] - motion[i, tb.DX]) + abs(motion[j, tb.DY] - motion[i, tb.DY])
    return float(by + turning_reach(i, j, motion, bodies.properties))


@inlined
def next_event(
    p: int,
    s: int,
    t: int,
    now: float,
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    contacts: Contacts,
    events: Events,
) -> float:
    """Return the fraction of the step, from `now` on, at which two shapes meet, or `MISSED`."""
    if keep_away(s, t, now, bodies, shapes):  # most do, and are not asked more
        return MISSED
    return event_on_path(p, s, t, now, control, bodies, shapes, contacts, events)


def event_on_path(
    p: int,
    s: int,
    t: int,
    now: float,
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    contacts: Contacts,
    events: Events,
) -> float:
    """Return the same of shapes that may come near.

    A pair that is close now meets now if it approaches by more than counts as close; or by more
    than its gap, if its impact is located: nothing else holds it.
    """
    time_step = control.progress[tb.PART_TIME]
    held = held_normal(contacts.manifolds[p], contacts.flags[p])
    if shapes.kind[t] == tb.HALF_PLANE:
        s, t = t, s
    i, j = shapes.slot[s], shapes.slot[t]
    near = NEAR * smaller_radius(s, t, shapes.material)
    gap = manifold_at(s, t, now, held, bodies, shapes, events)
    rest = 1.0 - now
    if gap <= near:
        line = normal_line(i, j, now, events.scratch[0], bodies)
        closing = time_step * path_speed_along(line, time_step, bodies.motion)
        enough = max(gap, 0.0) if 0 < contacts.flags[p, tb.LOCATED] < tb.SPENT else near
        if closing * rest < -enough:
            return now
    path = relative_path(i, j, now, bodies)
    ahead = time_of_impact(s, t, False, path, held, shapes, events)
    return now + ahead * rest if ahead <= 1.0 else MISSED


def manifold_at(
    s: int, t: int, now: float, held: Vector, bodies: Bodies, shapes: Shapes, events: Events
) -> float:
    """Write the manifold of two shapes at a fraction of the step; return their gap, m.

    It is huge beside a piece of a chain.
    """
    i, j = shapes.slot[s], shapes.slot[t]
    turn_shape_to(s, i, now, bodies, shapes)
    turn_shape_to(t, j, now, bodies, shapes)
    x, y = relative_place(i, j, now, bodies.pose, bodies.motion)
    a, b, manifold = core_of(s, shapes), core_of(t, shapes), events.scratch[0]
    gap = measure_gap(manifold, a, b, x, y, held, shapes.world_vertices)
    if is_piece(a) or is_piece(b):
        _, gap = measure_gap_of_piece(
            s, t, a, b, (x, y), gap, held, manifold, shapes.world_vertices, shapes
        )
    return gap
