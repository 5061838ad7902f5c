"""Bodies that go far in a step: they meet what is in their way, and go on from there.

Serves: a step, for what the solver has not seen coming. Hides: in which order they meet.

In a step every body goes along a line and turns evenly. Where one goes farther than its own
thickness, the instants at which it comes close to others are found, and at the first of them the
impact happens at once: both go on along new lines for the rest of the step (IM10, one row). What
then is in their way is looked for again, and where a new line leaves the room in which neighbours
are known, all pairs are. What is pressed together again for the rest of the step stays together.
"""

from tamias2d.state import Array
from tamias2d.stepped.flight_events import earliest, meet_at, next_meeting
from tamias2d.stepped.flight_impact import BENT, LEANT, note_impact, part
from tamias2d.stepped.layout import (
    ARM,
    COUNT,
    DTURN,
    DX,
    DY,
    DYNAMIC,
    FRAME_X,
    FRAME_Y,
    GRAVITY_X,
    GRAVITY_Y,
    HALF_PLANE,
    HIGH_X,
    HIGH_Y,
    INNER,
    KINEMATIC,
    LOW_X,
    LOW_Y,
    PAIR_FRICTION,
    PAIR_RESTITUTION,
    PAIRS,
    REACH,
    SENSOR,
    SHAPE_REACH,
    TIME_STEP,
    Whole,
    X,
    Y,
)
from tamias2d.stepped.pairs import AROUND
from tamias2d.stepped.sweep import MISSED, WIDE
from tamias2d.stepped.trajectory import stop_at, wait_at_border

FAST = 0.35  # of half its width: how far a body goes before it is looked after
THROUGH = 0.7  # of half the widths of both: how far one may go into another and be pushed back,
# but not farther than the smaller one reaches
IMPACTS = 64  # in one step, and four more for every pair that meets
LOOKS_AROUND = 32  # in one step: then a body waits where its neighbours are not known any more


def goes_far(kind: Whole, motion: Array, body: Array) -> bool:
    """Return whether some body goes farther in this step than it could be pushed back from."""
    far = False
    for i in range(len(kind)):
        far = far | ((way_of(i, motion, body) > FAST * body[i, INNER]) & (kind[i] >= KINEMATIC))
    return far


def mark_outrun(
    settings: Array,
    kind: Whole,
    pose: Array,
    motion: Array,
    body: Array,
    home: Array,
    used: Whole,
) -> int:
    """Mark bodies that go far and leave the room in which neighbours are known; return how many.

    They are known a little farther than the room, too.
    """
    left = 0
    for i in range(len(kind)):
        used[i] = 1 if leaves(i, settings, kind, pose, motion, body, home) else 0
        left += used[i]
    return left


def leaves(
    i: int, settings: Array, kind: Whole, pose: Array, motion: Array, body: Array, home: Array
) -> bool:
    """Return whether a body goes far, and out of where its neighbours are known."""
    if kind[i] != DYNAMIC or way_of(i, motion, body) <= FAST * body[i, INNER]:
        return False
    x = pose[i, X] + motion[i, DX] - settings[FRAME_X]
    y = pose[i, Y] + motion[i, DY] - settings[FRAME_Y]
    more = AROUND * body[i, REACH]
    return bool(
        (x < home[i, LOW_X] - more)
        | (x > home[i, HIGH_X] + more)
        | (y < home[i, LOW_Y] - more)
        | (y > home[i, HIGH_Y] + more)
    )


def way_of(i: int, motion: Array, body: Array) -> float:
    """Return how far some point of a body may go in this step, m."""
    return abs(motion[i, DX]) + abs(motion[i, DY]) + abs(motion[i, DTURN]) * body[i, ARM]


def fly(
    settings: Array,
    counts: Whole,
    pose: Array,
    motion: Array,
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
    filters: Whole,
    corner: Array,
    turned: Array,
    pair: Whole,
    touch: Array,
    trace: Whole,
    times: Array,
    scratch: Array,
    looks: int,
    since: float,
) -> float:
    """Let all impacts of a step happen that the solver has not seen, in their order.

    `gained` (n+1, 6) holds in its last columns what forces add to velocities in this step; `times`
    (p,) is for when pairs meet, `scratch` (k, 32) for the corners of two shapes. Returns the
    fraction of the step from which pairs are to be looked for and this is to be called again, as
    `since`, if `looks` are left; else `MISSED`.
    """
    if since == 0.0:
        begin_flight(settings, kind, gained)
    found = 0
    for p in range(counts[PAIRS]):
        times[p] = MISSED
        s, t = pair[p, 0], pair[p, 1]
        i, j = shape_body[s], shape_body[t]
        bent = gained[i, BENT] + gained[j, BENT] > 0.0
        if trace[p, COUNT] > 0 and not bent:
            continue
        if filters[s, SENSOR] != 0 or filters[t, SENSOR] != 0:
            continue
        way = (
            abs(motion[j, DX] - motion[i, DX])
            + abs(motion[j, DY] - motion[i, DY])
            + abs(motion[i, DTURN]) * body[i, ARM]
            + abs(motion[j, DTURN]) * body[j, ARM]
        )
        deep = THROUGH * width(body[i, INNER], body[j, INNER])
        deep = min(deep, surface[s, SHAPE_REACH], surface[t, SHAPE_REACH])
        if bent or way > deep:
            times[p] = next_meeting(
                s, t, since, settings[TIME_STEP], pose, motion, shape_body, shape_kind,
                shape_first, shape_count, shape_radius, surface, corner, turned, scratch,
            )  # fmt: skip
            found += times[p] <= 1.0
    for _ in range(IMPACTS + 4 * found):
        first = earliest(counts[PAIRS], times)
        now = times[first]
        if now > 1.0:
            return MISSED
        times[first] = MISSED
        s, t = pair[first, 0], pair[first, 1]
        if shape_kind[t] == HALF_PLANE:
            s, t = t, s
        i, j = shape_body[s], shape_body[t]
        meet_at(
            s, t, now, pose, motion, shape_body, shape_kind, shape_first, shape_count,
            shape_radius, corner, turned, scratch,
        )  # fmt: skip
        friction, restitution = touch[first, PAIR_FRICTION], touch[first, PAIR_RESTITUTION]
        push = part(
            i, j, now, settings[TIME_STEP], friction, restitution, pose, motion, body, gained,
            scratch[0],
        )  # fmt: skip
        if push < 0.0:
            continue
        if push > 0.0:
            note_impact(
                push, i, now, 1.0 if s == pair[first, 0] else -1.0, pose, motion, scratch[0],
                touch[first], trace[first],
            )  # fmt: skip
        gained[i, BENT] = gained[j, BENT] = 1.0
        if leaves(i, settings, kind, pose, motion, body, home) or leaves(
            j, settings, kind, pose, motion, body, home
        ):
            if looks > 0:
                return now
            wait_at_border(settings, i, now, pose, motion, home, kind)
            wait_at_border(settings, j, now, pose, motion, home, kind)
        for p in range(counts[PAIRS]):
            s, t = pair[p, 0], pair[p, 1]
            a, b = shape_body[s], shape_body[t]
            new = ((a == i) | (b == i)) & (kind[i] == DYNAMIC)
            new = new | (((a == j) | (b == j)) & (kind[j] == DYNAMIC))
            if new and filters[s, SENSOR] == 0 and filters[t, SENSOR] == 0:
                times[p] = next_meeting(
                    s, t, now, settings[TIME_STEP], pose, motion, shape_body, shape_kind,
                    shape_first, shape_count, shape_radius, surface, corner, turned, scratch,
                )  # fmt: skip
    now = times[earliest(counts[PAIRS], times)]
    for p in range(counts[PAIRS]):  # too many impacts: what would meet waits for the next step
        if times[p] <= 1.0:
            stop_at(shape_body[pair[p, 0]], now, pose, motion, kind)
            stop_at(shape_body[pair[p, 1]], now, pose, motion, kind)
    return MISSED


def begin_flight(settings: Array, kind: Whole, gained: Array) -> None:
    """Mark what has contacts: nothing is noted that gravity has added to its velocity."""
    pulled = settings[GRAVITY_X] != 0.0 or settings[GRAVITY_Y] != 0.0
    for i in range(len(kind)):
        still = gained[i, 3] == 0.0 and gained[i, 4] == 0.0
        gained[i, BENT] = 0.0
        gained[i, LEANT] = 1.0 if pulled and still and kind[i] == DYNAMIC else 0.0


def width(one: float, other: float) -> float:
    """Return half the widths of two bodies, m; of a half-plane only the other's counts."""
    return one if other > WIDE else other if one > WIDE else one + other
