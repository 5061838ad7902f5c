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

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.bounds import path_length, time_of_leaving
from tamias2d.engine.continuous.clusters import hold, is_carried, join_or_carry
from tamias2d.engine.continuous.collision_response import resolve_impact
from tamias2d.engine.continuous.conservative_advancement import MISSED
from tamias2d.engine.continuous.event_queue import (
    NO_EVENT,
    begin_queue,
    first_event,
    update_event,
)
from tamias2d.engine.continuous.events import (
    MANY,
    SHALLOW,
    THIN,
    allowed_depth,
    find_events,
    goes_little,
    next_event,
    relative_motion,
    update_events_of,
)
from tamias2d.engine.continuous.meetings import is_first_listed
from tamias2d.engine.continuous.passing import smaller_radius
from tamias2d.engine.continuous.sensing import note_sensed
from tamias2d.engine.tables import Bodies, BroadPhase, Contacts, Control, Events, Integers, Shapes

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
    body_count = len(bodies.kind)
    found = find_all_events(since, control, bodies, shapes, broad_phase, contacts, events)
    if found == 0:
        return MISSED
    begin_queue(broad_phase, contacts, events, body_count)
    impacts_left = most_impacts(found, control.counts[tb.LEVEL])
    last = -MOST_JOINS * body_count
    while impacts_left > last:
        event = first_event(events.queue)
        if event == NO_EVENT:
            return MISSED
        now = events.times[event]
        if event < body_count:
            least = -MOST_UPDATES if is_carried(event, bodies.flight, bodies.kind) else 0
            if updates_left > least:
                return now
            wide = bodies.properties[event, tb.BOUNDING_RADIUS]
            if may_retake(path_length(event, bodies.motion, bodies.properties), wide, control):
                return TOO_LONG
            i, j, joins, met = event, event, True, 1
            hold(i, now, control, bodies, events.together)
        else:
            p, joins = event - body_count, impacts_left <= 0
            if contacts.flags[p, tb.SENSES] == 1:
                note_sensed(p, now, bodies, shapes, contacts, events)
                continue
            if joins and pair_may_retake(p, now, control, bodies, shapes, contacts):
                return TOO_LONG
            i, j = contacts.pairs[p, tb.SLOT_A], contacts.pairs[p, tb.SLOT_B]
            impacts_left -= 1
            count_located(contacts.flags[p])
            met = handle_meeting(p, now, joins, control, bodies, shapes, contacts, events)
            update_event(event, events.times, events.queue)
            if met == 0:
                continue
            impacts_left -= met - 1
            now = max(now, events.times[event])  # on parabolas they meet later than on chords
        share = 1.0 if impacts_left <= 0 else control.progress[tb.DEPTH_SHARE]
        stays = bodies.kind[i] != tb.DYNAMIC or joins
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
    control.progress[tb.DEPTH_SHARE] = 1.0
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
    events.times[i] = time_of_leaving(i, now, bodies, broad_phase)
    update_event(i, events.times, events.queue)
    update_events_of(i, except_for, now, share, control, bodies, shapes, contacts, events)


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
        count_located(contacts.flags[events.met[k, tb.MET_CONTACT]])
    for k in range(1, met):
        for i in (events.met[k, tb.MET_A], events.met[k, tb.MET_B]):
            if is_first_listed(i, k, events.met):
                update_body(
                    i, -1, now, share, control, bodies, shapes, broad_phase, contacts, events
                )


def may_retake(length: float, deep: float, control: Control) -> bool:
    """Return whether shorter parts make a way, m, short."""
    shortest = length / (1 << (tb.MOST_LEVEL - control.counts[tb.LEVEL]))
    return bool((control.counts[tb.START_NOTED] == 1) & (length > deep) & (shortest <= deep))


def pair_may_retake(
    p: int, now: float, control: Control, bodies: Bodies, shapes: Shapes, contacts: Contacts
) -> bool:
    """Return whether a pair that goes too far does not in shorter parts."""
    if reaches_little(p, now, bodies, shapes, contacts):
        return False
    i, j = contacts.pairs[p, tb.SLOT_A], contacts.pairs[p, tb.SLOT_B]
    reach = smaller_radius(contacts.pairs[p, 0], contacts.pairs[p, 1], shapes.material)
    deep = max(allowed_depth(i, j, reach, bodies.properties), THIN * reach)
    return may_retake(relative_motion(i, j, bodies), deep, control)


def count_located(flags: Integers) -> None:
    """Count an impact of a contact whose impacts are located."""
    if 0 < flags[tb.LOCATED] < tb.SPENT:
        flags[tb.LOCATED] = flags[tb.LOCATED] - 1 if flags[tb.LOCATED] > 1 else tb.SPENT


def most_impacts(found: int, level: int) -> int:
    """Return how many impacts a part may have in which so many pairs meet."""
    of_pair = MOST_IMPACTS_OF_PAIR if level < tb.MOST_LEVEL else 1
    return (MOST_IMPACTS >> level) + of_pair * found


def begin_continuous(control: Control, bodies: Bodies, events: Events) -> None:
    """Note how far each body goes, alone, and which ones had contacts while gravity acts.

    The solver notes no velocity gained by forces for bodies with contacts.
    """
    falls = control.settings[tb.GRAVITY_X] != 0.0 or control.settings[tb.GRAVITY_Y] != 0.0
    control.progress[tb.DEPTH_SHARE] = SHALLOW
    for i in range(len(bodies.kind)):
        events.together[i] = i
        flight = bodies.flight[i]
        held = flight[tb.FORCE_GAIN] == 0.0 and flight[tb.FORCE_GAIN + 1] == 0.0
        length = path_length(i, bodies.motion, bodies.properties)
        flight[tb.REDIRECTED], flight[tb.PATH_LENGTH] = 0.0, length
        flight[tb.SUPPORTED] = 1.0 if falls and held and bodies.kind[i] == tb.DYNAMIC else 0.0


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
        i, j = contacts.pairs[p, tb.SLOT_A], contacts.pairs[p, tb.SLOT_B]
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
    i, j = contacts.pairs[p, tb.SLOT_A], contacts.pairs[p, tb.SLOT_B]
    return goes_little(i, j, now, 1.0, smaller_radius(s, t, shapes.material), bodies)
