"""Bodies that go far in a step: they meet what is in their way, and go on from there.

Serves: a step, for what the solver has not seen coming. Hides: in which order they meet.

In a step every body goes along a line and turns evenly. Where one goes farther than its own
thickness, the instants at which it comes close to others are found, and at the first of them the
impact happens at once: both go on along new lines for the rest of the step (IM10, one row). What
then is in their way is looked for again, and where one comes to the border of the room in which
its neighbours are known, all pairs are. What is pressed together again for the rest of the step
stays together. Where there are too many impacts in a step, what meets waits for the next one.
"""

from tamias2d.engine.continuous.bounds import path_length, time_of_leaving
from tamias2d.engine.continuous.conservative_advancement import MISSED, WIDE
from tamias2d.engine.continuous.event_queue import (
    build_tournament,
    list_contacts_by_body,
    update_event,
)
from tamias2d.engine.continuous.events import (
    SHALLOW,
    THROUGH,
    find_events,
    manifold_at,
    next_event,
    update_events_of,
)
from tamias2d.engine.continuous.impact import rebound, record_impact
from tamias2d.engine.continuous.impact_limit import cannot_freeze, freeze, freeze_or_carry
from tamias2d.engine.narrow_phase.material import mixed_material
from tamias2d.engine.tables import (
    CONTACTS,
    DYNAMIC,
    FORCE_GAIN,
    GRAVITY_X,
    GRAVITY_Y,
    HALF_PLANE,
    MIN_EXTENT,
    PATH_EXCESS,
    PATH_LENGTH,
    REDIRECTED,
    SLOT_A,
    SLOT_B,
    SUPPORTED,
    TIME_STEP,
    TOURNAMENT,
    WINNER,
    Bodies,
    BroadPhase,
    Contacts,
    Control,
    Events,
    Shapes,
)

MOST_IMPACTS = 64  # in one step, and four more for every pair that meets
MOST_FREEZES = (
    128  # in one step, for every body: more than it takes until nothing is led on any more
)
MOST_UPDATES = 32  # in one step, and as many for what is pushed by something that cannot wait


def solve_continuous(
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    broad_phase: BroadPhase,
    contacts: Contacts,
    events: Events,
    looks: int,
    since: float,
) -> float:
    """Let all impacts of a step happen that the solver has not seen, in their order.

    `gained` (n+1, 16) holds in columns 3 to 5 what forces add to velocities in this step; `times`
    (n+1+p,) is for when bodies leave their rooms and pairs meet, `agenda` (3, k) for their order,
    and `scratch` (k, 32) for the corners of two shapes. Returns the fraction of the step from which
    pairs are to be looked for and this is to be called again, as `since`, if `looks` are left; else
    `MISSED`. Until its next meeting a body is where nothing else is: there it waits for the next
    step, after too many impacts or looks in this one.
    """
    if since == 0.0:
        begin_continuous(control, bodies)
    body_count, event_count = len(bodies.kind), len(bodies.kind) + broad_phase.counts[CONTACTS]
    for k in range(body_count):
        events.times[k] = MISSED
    found = find_events(since, control, bodies, shapes, broad_phase, contacts, events)
    if found == 0:
        return MISSED
    list_contacts_by_body(broad_phase, contacts, events, body_count)
    build_tournament(event_count, events.times, events.queue)
    left = MOST_IMPACTS + 4 * found
    last = -MOST_FREEZES * body_count
    while left > last:
        event = events.queue[TOURNAMENT, WINNER]
        now = events.times[event]
        if now > 1.0:
            return MISSED
        if event < body_count:
            if looks > (-MOST_UPDATES if cannot_freeze(event, bodies.flight, bodies.kind) else 0):
                return now
            i, j, waits = event, event, True
            freeze(i, now, control, bodies)
        else:
            p = event - body_count
            i, j, waits = contacts.pairs[p, SLOT_A], contacts.pairs[p, SLOT_B], left <= 0
            bent = (
                resolve_impact(p, now, control, bodies, shapes, contacts, events)
                if left > 0
                else freeze_or_carry(i, j, now, control, bodies)
            )
            left -= 1
            if not bent:
                later = (
                    now
                    if left < 0
                    else next_event(
                        contacts.pairs[p, 0],
                        contacts.pairs[p, 1],
                        now,
                        control.settings[TIME_STEP],
                        bodies,
                        shapes,
                        events,
                    )
                )
                events.times[event] = (
                    later if later > now else MISSED
                )  # it does not close in where it is
                update_event(event, event_count, events.times, events.queue)
                continue
        for one, but in ((i, -1), (j, i if bodies.kind[i] == DYNAMIC else -1)):
            events.times[one] = time_of_leaving(one, now, bodies, broad_phase)
            update_event(one, event_count, events.times, events.queue)
            update_events_of(
                one,
                but,
                now,
                SHALLOW if waits else 0.0,
                control,
                bodies,
                shapes,
                broad_phase,
                contacts,
                events,
            )
    return MISSED


def resolve_impact(
    p: int,
    now: float,
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    contacts: Contacts,
    events: Events,
) -> bool:
    """Let a pair that meets collide; return whether it did."""
    s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
    sense = 1.0
    if shapes.kind[t] == HALF_PLANE:
        s, t = t, s
        sense = -1.0
    i, j = shapes.slot[s], shapes.slot[t]
    manifold_at(s, t, now, bodies, shapes, events)
    row = events.scratch[0]
    friction, restitution = mixed_material(s, t, shapes.material, shapes.pair_overrides)
    push = rebound(i, j, now, friction, restitution, control, bodies, row)
    if push < 0.0:
        return False
    if push > 0.0:
        record_impact(
            push,
            i,
            now,
            sense,
            bodies.pose,
            bodies.motion,
            row,
            contacts.manifolds[p],
            contacts.flags[p],
        )
    bodies.flight[i, REDIRECTED] = bodies.flight[j, REDIRECTED] = 1.0
    return True


def begin_continuous(control: Control, bodies: Bodies) -> None:
    """Mark what has contacts: nothing is noted that gravity has added to its velocity.

    Noted is how far each goes; once its line is bent, that is of no use.
    """
    pulled = control.settings[GRAVITY_X] != 0.0 or control.settings[GRAVITY_Y] != 0.0
    for i in range(len(bodies.kind)):
        still = bodies.flight[i, FORCE_GAIN] == 0.0 and bodies.flight[i, FORCE_GAIN + 1] == 0.0
        bodies.flight[i, REDIRECTED] = 0.0
        way, wide = (
            path_length(i, bodies.motion, bodies.properties),
            bodies.properties[i, MIN_EXTENT],
        )
        bodies.flight[i, PATH_LENGTH] = way
        bodies.flight[i, PATH_EXCESS] = way - (THROUGH * wide if wide <= WIDE else 0.0)
        bodies.flight[i, SUPPORTED] = 1.0 if pulled and still and bodies.kind[i] == DYNAMIC else 0.0
