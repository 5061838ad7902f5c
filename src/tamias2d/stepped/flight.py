"""Bodies that go far in a step: they meet what is in their way, and go on from there.

Serves: a step, for what the solver has not seen coming. Hides: in which order they meet.

In a step every body goes along a line and turns evenly. Where one goes farther than its own
thickness, the instants at which it comes close to others are found, and at the first of them the
impact happens at once: both go on along new lines for the rest of the step (IM10, one row). What
then is in their way is looked for again, and where one comes to the border of the room in which
its neighbours are known, all pairs are. What is pressed together again for the rest of the step
stays together. Where there are too many impacts in a step, what meets waits for the next one.
"""

from tamias2d.state import Array
from tamias2d.stepped.flight_agenda import TOURNAMENT, WINNER, list_by_body, play_again, play_all
from tamias2d.stepped.flight_events import (
    SHALLOW,
    THROUGH,
    find_meetings,
    meet_at,
    next_meeting,
    renew_meetings,
)
from tamias2d.stepped.flight_impact import BENT, BEYOND, LEANT, WAY, note_impact, rebound
from tamias2d.stepped.flight_rooms import leaves_at, way_of
from tamias2d.stepped.flight_wait import cannot_wait, stand_by, wait
from tamias2d.stepped.layout import (
    DYNAMIC,
    GRAVITY_X,
    GRAVITY_Y,
    HALF_PLANE,
    INNER,
    OF_A,
    OF_B,
    PAIRS,
    TIME_STEP,
    Whole,
)
from tamias2d.stepped.surfaces import surfaces_of
from tamias2d.stepped.sweep import MISSED, WIDE

IMPACTS = 64  # in one step, and four more for every pair that meets
WAITS = 128  # in one step, for every body: more than it takes until nothing is led on any more
LOOKS_AROUND = 32  # in one step, and as many for what is pushed by something that cannot wait


def fly(
    settings: Array,
    counts: Whole,
    pose: Array,
    motion: Array,
    load: Array,
    body: Array,
    home: Array,
    kind: Whole,
    gained: Array,
    shape_body: Whole,
    shape_kind: Whole,
    shape_first: Whole,
    shape_count: Whole,
    shape_radius: Array,
    surface: Array,
    mixed: Array,
    filters: Whole,
    corner: Array,
    turned: Array,
    pair: Whole,
    touch: Array,
    trace: Whole,
    times: Array,
    agenda: Whole,
    scratch: Array,
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
        begin_flight(settings, kind, motion, body, gained)
    bodies, events = len(kind), len(kind) + counts[PAIRS]
    for k in range(bodies):
        times[k] = MISSED
    found = find_meetings(
        since, settings, counts, pose, motion, body, gained, shape_body, shape_kind, shape_first,
        shape_count, shape_radius, surface, filters, corner, turned, pair, touch, trace, times,
        scratch,
    )  # fmt: skip
    if found == 0:
        return MISSED
    list_by_body(counts, bodies, pair, agenda)
    play_all(events, times, agenda)
    left = IMPACTS + 4 * found
    last = -WAITS * bodies
    while left > last:
        event = agenda[TOURNAMENT, WINNER]
        now = times[event]
        if now > 1.0:
            return MISSED
        if event < bodies:
            if looks > (-LOOKS_AROUND if cannot_wait(event, gained, kind) else 0):
                return now
            i, j, waits = event, event, True
            wait(i, now, settings, pose, motion, load, body, kind)
        else:
            p = event - bodies
            i, j, waits = pair[p, OF_A], pair[p, OF_B], left <= 0
            bent = happen(
                p, now, settings, pose, motion, load, body, gained, kind, shape_body, shape_kind,
                shape_first, shape_count, shape_radius, surface, mixed, corner, turned, pair,
                touch, trace, scratch,
            ) if left > 0 else stand_by(
                i, j, now, settings, pose, motion, load, body, gained, kind
            )  # fmt: skip
            left -= 1
            if not bent:
                later = now if left < 0 else next_meeting(
                    pair[p, 0], pair[p, 1], now, settings[TIME_STEP], pose, motion, shape_body,
                    shape_kind, shape_first, shape_count, shape_radius, surface, corner, turned,
                    scratch,
                )  # fmt: skip
                times[event] = later if later > now else MISSED  # it does not close in where it is
                play_again(event, events, times, agenda)
                continue
        for one, but in ((i, -1), (j, i if kind[i] == DYNAMIC else -1)):
            times[one] = leaves_at(one, now, settings, kind, pose, motion, body, home)
            play_again(one, events, times, agenda)
            renew_meetings(
                one, but, now, SHALLOW if waits else 0.0, settings, counts, pose, motion, body,
                kind, shape_body, shape_kind, shape_first, shape_count, shape_radius, surface,
                filters, corner, turned, pair, times, agenda, scratch,
            )  # fmt: skip
    return MISSED


def happen(
    p: int,
    now: float,
    settings: Array,
    pose: Array,
    motion: Array,
    load: Array,
    body: Array,
    gained: Array,
    kind: Whole,
    shape_body: Whole,
    shape_kind: Whole,
    shape_first: Whole,
    shape_count: Whole,
    shape_radius: Array,
    surface: Array,
    mixed: Array,
    corner: Array,
    turned: Array,
    pair: Whole,
    touch: Array,
    trace: Whole,
    scratch: Array,
) -> bool:
    """Let a pair that meets collide; return whether it did."""
    s, t = pair[p, 0], pair[p, 1]
    sense = 1.0
    if shape_kind[t] == HALF_PLANE:
        s, t = t, s
        sense = -1.0
    i, j = shape_body[s], shape_body[t]
    meet_at(
        s, t, now, pose, motion, shape_body, shape_kind, shape_first, shape_count, shape_radius,
        corner, turned, scratch,
    )  # fmt: skip
    row = scratch[0]
    friction, restitution = surfaces_of(s, t, surface, mixed)
    push = rebound(
        i, j, now, friction, restitution, settings, pose, motion, load, body, gained, kind, row
    )
    if push < 0.0:
        return False
    if push > 0.0:
        note_impact(push, i, now, sense, pose, motion, row, touch[p], trace[p])
    gained[i, BENT] = gained[j, BENT] = 1.0
    return True


def begin_flight(settings: Array, kind: Whole, motion: Array, body: Array, gained: Array) -> None:
    """Mark what has contacts: nothing is noted that gravity has added to its velocity.

    Noted is how far each goes; once its line is bent, that is of no use.
    """
    pulled = settings[GRAVITY_X] != 0.0 or settings[GRAVITY_Y] != 0.0
    for i in range(len(kind)):
        still = gained[i, 3] == 0.0 and gained[i, 4] == 0.0
        gained[i, BENT] = 0.0
        way, wide = way_of(i, motion, body), body[i, INNER]
        gained[i, WAY] = way
        gained[i, BEYOND] = way - (THROUGH * wide if wide <= WIDE else 0.0)
        gained[i, LEANT] = 1.0 if pulled and still and kind[i] == DYNAMIC else 0.0
