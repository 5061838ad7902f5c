"""Continuous collision: bodies that go far in a step meet what is in their way, in order of time.

In a step every body goes along a line and turns evenly. Where one goes farther than its own
thickness, the instants at which it comes close to others are found. At the first of them the
impact is resolved: both bodies go on along new paths for the rest of the step, and their events are
found anew. Where a body leaves its fat bounds, pairs are updated. Bodies that forces press together
again in the rest of the step stay together. After too many impacts in a step, bodies that meet go
on together until the next one.

Cost: for each impact, the contacts of both bodies. Source: Mirtich, Impulse-based dynamic
simulation (1996).
"""

from tamias2d.engine.continuous.bend import bend_paths, is_first, put_on_parabola
from tamias2d.engine.continuous.bounds import path_length, time_of_leaving
from tamias2d.engine.continuous.clusters import hold, is_carried, join_or_carry, leave
from tamias2d.engine.continuous.conservative_advancement import MISSED
from tamias2d.engine.continuous.event_queue import (
    build_tournament,
    list_contacts_by_body,
    update_event,
)
from tamias2d.engine.continuous.events import (
    MANY,
    SHALLOW,
    THIN,
    allowed_depth,
    find_events,
    goes_little,
    manifold_at,
    next_event,
    relative_motion,
    smaller_radius,
    update_events_of,
)
from tamias2d.engine.continuous.gap_bound import UNBOUNDED
from tamias2d.engine.continuous.impact import (
    contact_point,
    place_on_path,
    rebound,
    record_impact,
)
from tamias2d.engine.continuous.impact_points import (
    is_point,
    list_points,
    rebound_at_points,
    total_push,
)
from tamias2d.engine.continuous.meetings import (
    gather_meetings,
    is_first_listed,
    measure_meeting,
)
from tamias2d.engine.narrow_phase.core import core_of, is_thin
from tamias2d.engine.narrow_phase.material import mixed_material
from tamias2d.engine.narrow_phase.polygon import held_normal
from tamias2d.engine.narrow_phase.seams import extend_ground, goes_on, is_seam
from tamias2d.engine.tables import (
    BOUNDING_RADIUS,
    CONTACTS,
    DEPTH_SHARE,
    DX,
    DY,
    DYNAMIC,
    FORCE_GAIN,
    GRAVITY_X,
    GRAVITY_Y,
    HALF_PLANE,
    LEVEL,
    LOCATED,
    M_NORMAL,
    MET_A,
    MET_B,
    MET_CONTACT,
    MET_TURNED,
    MOST_LEVEL,
    NX,
    NY,
    PART_TIME,
    PATH_LENGTH,
    REDIRECTED,
    SLOT_A,
    SLOT_B,
    SPENT,
    START_NOTED,
    STATIC,
    SUPPORTED,
    TOURNAMENT,
    WINNER,
    Bodies,
    BroadPhase,
    Contacts,
    Control,
    Events,
    Integers,
    Shapes,
    X,
    Y,
)
from tamias2d.generated.continuous_collision import position_later

MOST_IMPACTS = 256  # in a step in all
MOST_IMPACTS_OF_PAIR = 4  # in a part, for a pair that meets; in one of the shortest one
MOST_JOINS = 128  # in one step, for every body: more than it takes until nothing is carried on
TOO_LONG = -1.0  # a part of the step that is to be taken in shorter ones
MOST_UPDATES = 32  # of pairs in one step, and as many for bodies that cannot be held


def solve_continuous(
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    broad_phase: BroadPhase,
    contacts: Contacts,
    events: Events,
    updates_left: int,
    since: float,
) -> float:
    """Resolve all impacts of a step that the solver has not seen, in order of time.

    Returns the fraction of the step at which a body leaves its bounds, if updates are left: pairs
    are to be updated, and this is to be called again with it as `since`. Otherwise returns
    `MISSED`. A body that leaves its bounds when no updates are left is held there.
    """
    if since == 0.0:
        begin_continuous(control, bodies, events)
    body_count, event_count = len(bodies.kind), len(bodies.kind) + broad_phase.counts[CONTACTS]
    found = find_all_events(since, control, bodies, shapes, broad_phase, contacts, events)
    if found == 0:
        return MISSED
    list_contacts_by_body(broad_phase, contacts, events, body_count)
    build_tournament(event_count, events.times, events.queue)
    impacts_left = most_impacts(found, control.counts[LEVEL])
    last = -MOST_JOINS * body_count
    while impacts_left > last:
        event = events.queue[TOURNAMENT, WINNER]
        now = events.times[event]
        if now > 1.0:
            return MISSED
        if event < body_count:
            least = -MOST_UPDATES if is_carried(event, bodies.flight, bodies.kind) else 0
            if updates_left > least:
                return now
            wide = bodies.properties[event, BOUNDING_RADIUS]
            if may_retake(path_length(event, bodies.motion, bodies.properties), wide, control):
                return TOO_LONG
            i, j, joins, met = event, event, True, 1
            hold(i, now, control, bodies, events.together)
        else:
            p, joins = event - body_count, impacts_left <= 0
            if joins and pair_may_retake(p, now, control, bodies, shapes, contacts):
                return TOO_LONG
            i, j = contacts.pairs[p, SLOT_A], contacts.pairs[p, SLOT_B]
            impacts_left -= 1
            count_located(contacts.flags[p])
            met = handle_meeting(p, now, joins, control, bodies, shapes, contacts, events)
            if met == 0:
                update_event(event, event_count, events.times, events.queue)
                continue
            impacts_left -= met - 1
            now = max(now, events.times[event])  # on parabolas they meet later than on chords
        share = 1.0 if impacts_left <= 0 else control.progress[DEPTH_SHARE]
        stays = bodies.kind[i] != DYNAMIC or joins
        for one, other in ((i, -1), (j, -1 if stays else i)):
            update_body(
                one, other, now, share, control, bodies, shapes, broad_phase, contacts, events
            )
        if joins:
            update_others(i, now, share, control, bodies, shapes, broad_phase, contacts, events)
        if met > 1:
            update_met(met, now, share, control, bodies, shapes, broad_phase, contacts, events)
    return MISSED


def find_all_events(
    since: float,
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    broad_phase: BroadPhase,
    contacts: Contacts,
    events: Events,
) -> int:
    """Find when bodies leave their bounds and pairs meet; return how many pairs do.

    Shallow impacts are left out where they are many.
    """
    for k in range(len(bodies.kind)):
        events.times[k] = MISSED
    found = find_events(since, control, bodies, shapes, broad_phase, contacts, events)
    if found != MANY:
        return found
    control.progress[DEPTH_SHARE] = 1.0
    for k in range(len(bodies.kind)):
        events.times[k] = MISSED
    return find_events(since, control, bodies, shapes, broad_phase, contacts, events)


def update_body(
    i: int,
    except_for: int,
    now: float,
    share: float,
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    broad_phase: BroadPhase,
    contacts: Contacts,
    events: Events,
) -> None:
    """Find anew when a body leaves its bounds, and when it meets all others but one."""
    count = len(bodies.kind) + broad_phase.counts[CONTACTS]
    events.times[i] = time_of_leaving(i, now, bodies, broad_phase)
    update_event(i, count, events.times, events.queue)
    update_events_of(
        i, except_for, now, share, control, bodies, shapes, broad_phase, contacts, events
    )


def update_others(
    i: int,
    now: float,
    share: float,
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    broad_phase: BroadPhase,
    contacts: Contacts,
    events: Events,
) -> None:
    """Find anew what the bodies meet that go on together with one."""
    k = events.together[i]
    while k != i:
        update_body(k, -1, now, share, control, bodies, shapes, broad_phase, contacts, events)
        k = events.together[k]


def update_met(
    met: int,
    now: float,
    share: float,
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    broad_phase: BroadPhase,
    contacts: Contacts,
    events: Events,
) -> None:
    """Find anew what the bodies meet that rebounded together with the first pair."""
    for k in range(1, met):
        count_located(contacts.flags[events.met[k, MET_CONTACT]])
    for k in range(1, met):
        for i in (events.met[k, MET_A], events.met[k, MET_B]):
            if is_first_listed(i, k, events.met):
                update_body(
                    i, -1, now, share, control, bodies, shapes, broad_phase, contacts, events
                )


def may_retake(length: float, deep: float, control: Control) -> bool:
    """Return whether shorter parts make a way, m, short."""
    shortest = length / (1 << (MOST_LEVEL - control.counts[LEVEL]))
    return bool((control.counts[START_NOTED] == 1) & (length > deep) & (shortest <= deep))


def pair_may_retake(
    p: int, now: float, control: Control, bodies: Bodies, shapes: Shapes, contacts: Contacts
) -> bool:
    """Return whether a pair that goes too far does not in shorter parts."""
    if reaches_little(p, now, bodies, shapes, contacts):
        return False
    i, j = contacts.pairs[p, SLOT_A], contacts.pairs[p, SLOT_B]
    reach = smaller_radius(contacts.pairs[p, 0], contacts.pairs[p, 1], shapes.material)
    deep = max(allowed_depth(i, j, reach, bodies.properties), THIN * reach)
    return may_retake(relative_motion(i, j, bodies), deep, control)


def count_located(flags: Integers) -> None:
    """Count an impact of a contact whose impacts are located."""
    if 0 < flags[LOCATED] < SPENT:
        flags[LOCATED] = flags[LOCATED] - 1 if flags[LOCATED] > 1 else SPENT


def most_impacts(found: int, level: int) -> int:
    """Return how many impacts a part may have in which so many pairs meet."""
    of_pair = MOST_IMPACTS_OF_PAIR if level < MOST_LEVEL else 1
    return (MOST_IMPACTS >> level) + of_pair * found


def begin_continuous(control: Control, bodies: Bodies, events: Events) -> None:
    """Note how far each body goes, alone, and which ones had contacts while gravity acts.

    The solver notes no velocity gained by forces for bodies with contacts.
    """
    falls = control.settings[GRAVITY_X] != 0.0 or control.settings[GRAVITY_Y] != 0.0
    control.progress[DEPTH_SHARE] = SHALLOW
    for i in range(len(bodies.kind)):
        events.together[i] = i
        flight = bodies.flight[i]
        held = flight[FORCE_GAIN] == 0.0 and flight[FORCE_GAIN + 1] == 0.0
        length = path_length(i, bodies.motion, bodies.properties)
        flight[REDIRECTED], flight[PATH_LENGTH] = 0.0, length
        flight[SUPPORTED] = 1.0 if falls and held and bodies.kind[i] == DYNAMIC else 0.0


def handle_meeting(
    p: int,
    now: float,
    joins: bool,
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    contacts: Contacts,
    events: Events,
) -> int:
    """Resolve the impact of a pair, or join it; return how many pairs have changed their paths.

    If none has, the event of this one is the next one after now.
    """
    if joins:
        i, j = contacts.pairs[p, SLOT_A], contacts.pairs[p, SLOT_B]
        if reaches_little(p, now, bodies, shapes, contacts):
            later, met = MISSED, 0
        else:
            later = now
            met = 1 if join_or_carry(i, j, now, control, bodies, events.together) else 0
    else:
        later = MISSED
        met = resolve_impact(p, now, control, bodies, shapes, contacts, events)
        if met == 0:
            s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
            later = next_event(p, s, t, now, control, bodies, shapes, contacts, events)
    if met == 0:  # a pair that meets where it is does not approach
        events.times[len(bodies.kind) + p] = later if later > now else MISSED
    return met


def reaches_little(p: int, now: float, bodies: Bodies, shapes: Shapes, contacts: Contacts) -> bool:
    """Return whether a pair comes together by no more than what it is pushed back from."""
    s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
    i, j = contacts.pairs[p, SLOT_A], contacts.pairs[p, SLOT_B]
    return goes_little(i, j, now, 1.0, smaller_radius(s, t, shapes.material), bodies)


def meets_seam(s: int, t: int, now: float, bodies: Bodies, shapes: Shapes, events: Events) -> bool:
    """Return whether a body meets a static shape where that joins its ground."""
    i, j, manifold = shapes.slot[s], shapes.slot[t], events.scratch[0]
    if bodies.kind[i] != STATIC and bodies.kind[j] != STATIC:
        return False
    at, shift = bodies.pose[i], bodies.motion[i]
    x, y = position_later((at[X], at[Y]), (shift[DX], shift[DY]), now)
    by_x, by_y = contact_point(manifold)
    place, normal = (x + by_x, y + by_y), (manifold[NX], manifold[NY])
    if bodies.kind[i] != STATIC:
        s, t, normal = t, s, (-normal[0], -normal[1])
    straight = goes_on(s, t, place, normal, bodies.motion[shapes.slot[t]], shapes, events.ground)
    if not straight and is_seam(s, t, place, normal, bodies, shapes, events.ground):
        extend_ground(s, t, bodies, shapes, events.ground)
        return True
    return straight


def resolve_impact(
    p: int,
    now: float,
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    contacts: Contacts,
    events: Events,
) -> int:
    """Let a pair that meets rebound, together with all that meet then; return how many pairs do.

    There are none where it does not approach.
    """
    s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
    sense = 1.0
    if shapes.kind[t] == HALF_PLANE:
        s, t = t, s
        sense = -1.0
    i, j = shapes.slot[s], shapes.slot[t]
    held = held_normal(contacts.manifolds[p], contacts.flags[p])
    time_step = control.progress[PART_TIME]
    count = gather_meetings(p, now, time_step, bodies, shapes, contacts, events)
    bends = contacts.flags[p, LOCATED] > 0 and is_first(i, j, bodies)
    if bends:
        now = bend_paths(s, t, now, time_step, bodies, shapes, events)
        if now > 1.0:
            return 0
        events.times[len(bodies.kind) + p] = now
        a, b = core_of(s, shapes), core_of(t, shapes)
        if is_thin(a, b) and held[0] == 0.0 and held[1] == 0.0:
            held = (events.scratch[0, NX], events.scratch[0, NY])  # rounding hides the gap
    gap = manifold_at(s, t, now, held, bodies, shapes, events)
    if gap >= UNBOUNDED:  # it is beside a piece
        return 0
    manifold = events.scratch[0]
    if meets_seam(s, t, now, bodies, shapes, events):
        return 0
    list_points(0, now, bodies, shapes, contacts, events)
    if count > 1:
        return rebound_together(count, bends, now, control, bodies, shapes, contacts, events)
    friction, restitution = mixed_material(s, t, shapes.material, shapes.pair_overrides)
    impulse = rebound(i, j, now, friction, restitution, control, bodies, events)
    if impulse < 0.0:
        return 0
    if impulse > 0.0:
        normal = (sense * manifold[NX], sense * manifold[NY])
        place = place_on_path(i, now, contact_point(manifold), bodies)
        in_parts = control.counts[LEVEL] > 0
        record_impact(impulse, place, normal, in_parts, contacts.manifolds[p], contacts.flags[p])
    go_alone(i, bodies, events)
    go_alone(j, bodies, events)
    return 1


def rebound_together(
    count: int,
    bends: bool,
    now: float,
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    contacts: Contacts,
    events: Events,
) -> int:
    """Let all pairs that are listed rebound; return how many, none where they do not approach."""
    time_step = control.progress[PART_TIME]
    for k in range(1, count):
        for i in (events.met[k, MET_A], events.met[k, MET_B]):
            if bends and is_first_listed(i, k, events.met) and bodies.flight[i, REDIRECTED] == 0.0:
                put_on_parabola(i, now, time_step, bodies)
    for k in range(1, count):
        measure_meeting(k, now, bodies, shapes, contacts, events)
        list_points(k, now, bodies, shapes, contacts, events)
    if not rebound_at_points(count, now, time_step, bodies, events):
        return 0
    for k in range(count):
        tell_impact(k, now, control.counts[LEVEL] > 0, bodies, contacts, events)
        go_alone(events.met[k, MET_A], bodies, events)
        go_alone(events.met[k, MET_B], bodies, events)
    return count


def tell_impact(
    k: int, now: float, in_parts: bool, bodies: Bodies, contacts: Contacts, events: Events
) -> None:
    """Add the impact of a listed pair to what is told of its contact, if it was pushed."""
    impulse, at = total_push(k, events)
    if impulse <= 0.0:
        return
    q, one = events.met[k, MET_CONTACT], events.met_points[2 * k]
    row = one if is_point(one) else events.met_points[2 * k + 1]
    sense = -1.0 if events.met[k, MET_TURNED] == 1 else 1.0
    normal = (sense * row[M_NORMAL], sense * row[M_NORMAL + 1])
    place = place_on_path(events.met[k, MET_A], now, at, bodies)
    record_impact(impulse, place, normal, in_parts, contacts.manifolds[q], contacts.flags[q])


def go_alone(i: int, bodies: Bodies, events: Events) -> None:
    """Note that an impact has redirected a body that moves freely, which goes on with no other."""
    if bodies.kind[i] == DYNAMIC:
        bodies.flight[i, REDIRECTED] = 1.0
        leave(i, events.together)
