"""When hard discs meet on their paths, and when one that slides does not slide any more.

Of each pair it is noted for how many steps nothing happens to it. The first root of its gap is when
it meets (DD46, DD80); the gap of discs that accelerate unlike is approached from below.
"""

from math import inf

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.conservative_advancement import NEAR
from tamias2d.engine.motion.hard_paths import alike, closing_of, disc_and_other, place_at
from tamias2d.engine.motion.hard_rest import DEEPEST, end_of_sliding
from tamias2d.engine.tables import Bodies, Contacts, Control, Events, Shapes
from tamias2d.generated.continuous_collision import (
    advance_closing,
    advance_opening,
    discriminant,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

SPARE = 2.0**-6  # of a step, by which pairs are looked at before they may meet
MOST_LOOKS = 64  # at a pair that accelerates unlike
MOST_FREE = 2.0**40  # steps
LEAST = 2.0**-1000  # m/s, or m/s^2: what a divisor is at least
TINY_ADVANCE = 2.0**-50  # of a step: what comes closer by less has met


@inlined
def time_of_meeting(gap: float, rate: float, acceleration: float) -> float:
    """Return after which time a gap closes that is a parabola in time, s; infinite for never.

    All cases are worked out, and one is chosen, so that many gaps may be looked at in lanes.
    """
    inside = discriminant(gap, rate, acceleration)
    root = inside if inside > 0.0 else 0.0
    closing = advance_closing(gap, rate if rate < -LEAST else -LEAST, root)
    still = (rate == 0.0) & ((inside == 0.0) | (gap <= 0.0))
    closing = inf if (inside < 0.0) | still else closing
    back = acceleration if acceleration < -LEAST else -LEAST
    opening = inf if acceleration >= 0.0 else advance_opening(rate, back, root)
    later = opening if rate > 0.0 else closing
    pressed = (rate < 0.0) | ((rate == 0.0) & (acceleration < 0.0))
    return 0.0 if (gap <= 0.0) & pressed else later


@inlined
def steps_free(gap: float, later: float, now: float, taken: int, per_second: float) -> float:
    """Return after how many steps of this call a gap may close, s after a time in one, s."""
    free = taken + (now + later) * per_second - SPARE
    free = free if free < MOST_FREE else MOST_FREE
    return free if gap > 0.0 else taken


def find_due(count: int, now: float, taken: int, step: float, ahead: Array) -> None:
    """Write after how many steps of this call some gaps may close, as seen at a time in one, s."""
    per_second = 1.0 / step
    for k in range(count):
        gap = ahead[tb.GAP_AHEAD, k]
        later = time_of_meeting(gap, ahead[tb.RATE_AHEAD, k], ahead[tb.BY_AHEAD, k])
        ahead[tb.DUE_AHEAD, k] = steps_free(gap, later, now, taken, per_second)


@inlined
def foretell(
    p: int, taken: int, control: Control, bodies: Bodies, shapes: Shapes, contacts: Contacts,
    events: Events,
) -> None:  # fmt: skip
    """Note after how many steps of this call a pair may meet, as a step begins."""
    s, t = disc_and_other(p, shapes, contacts)
    if bodies.path[shapes.slot[s], tb.RESTS_ON] == p + 1:
        note_sliding(p, taken, control, bodies, shapes, contacts, events)
        return
    at, going = place_at(shapes.slot[s], 0.0, bodies)
    gap, rate, acceleration = closing_of(s, t, at, going, 0.0, NEAR, bodies, shapes)
    later = time_of_meeting(gap, rate, acceleration)
    per_second = 1.0 / control.settings[tb.TIME_STEP]
    events.due[p] = int(steps_free(gap, later, 0.0, taken, per_second))


@inlined
def note_sliding(
    p: int, taken: int, control: Control, bodies: Bodies, shapes: Shapes, contacts: Contacts,
    events: Events,
) -> None:  # fmt: skip
    """Note until when a disc slides on the half-plane on which it rests."""
    events.times[p] = end_of_sliding(p, bodies, shapes, contacts)
    per_second = 1.0 / control.settings[tb.TIME_STEP]
    events.due[p] = int(steps_free(1.0, events.times[p], 0.0, taken, per_second))


@inlined
def note_meeting(
    p: int, now: float, control: Control, bodies: Bodies, shapes: Shapes, contacts: Contacts,
    events: Events,
) -> bool:  # fmt: skip
    """Note when a pair meets in this step, s; return whether it does not overlap deeply now."""
    s, t = disc_and_other(p, shapes, contacts)
    i, j = shapes.slot[s], shapes.slot[t]
    if bodies.path[i, tb.RESTS_ON] == p + 1:
        events.times[p] = end_of_sliding(p, bodies, shapes, contacts)
        return True
    at, going = place_at(i, now, bodies)
    gap, rate, acceleration = closing_of(s, t, at, going, now, 0.0, bodies, shapes)
    events.times[p] = now + time_of_meeting(gap, rate, acceleration)
    if shapes.kind[t] == tb.DISC and not alike(i, j, bodies):
        events.times[p] = approached(s, t, events.times[p], control, bodies, shapes)
    if gap > 0.0:
        return True
    core, _, _ = closing_of(s, t, at, going, now, -DEEPEST, bodies, shapes)
    return core > 0.0


def approached(
    s: int, t: int, earliest: float, control: Control, bodies: Bodies, shapes: Shapes
) -> float:
    """Return when two discs that accelerate unlike meet in a step, s, at the earliest at a time.

    Along the line of centres of each moment their gap is a parabola that they do not fall below.
    """
    step, now = control.settings[tb.TIME_STEP], earliest
    for _ in range(MOST_LOOKS):
        if now > step:
            return now
        at, going = place_at(shapes.slot[s], now, bodies)
        gap, rate, least = closing_of(s, t, at, going, now, 0.0, bodies, shapes)
        later = time_of_meeting(gap, rate, least)
        now += later
        if later <= TINY_ADVANCE * step:
            return now
    return now


@inlined
def soonest_of(listed: int, events: Events) -> int:
    """Return after how many steps of this call the first pair may meet."""
    soonest = int(MOST_FREE)
    for p in range(listed):
        soonest = min(soonest, events.due[p])
    return soonest


@inlined
def list_due(taken: int, listed: int, events: Events) -> int:
    """List the pairs that may meet in a step; return how many do."""
    near = 0
    for p in range(listed):
        if events.due[p] <= taken:
            events.queue[tb.WAITING, near] = p
            near += 1
    return near
