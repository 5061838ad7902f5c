"""When two bodies on their ways meet.

Serves: flight. Hides: how shapes are turned to where they are at an instant.
"""

from tamias2d.state import Array
from tamias2d.stepped.flight_agenda import PAIRS_OF, STARTS_OF, play_again
from tamias2d.stepped.flight_impact import BENT, BEYOND, WAY, contact_of, rate_along, seen_from_b
from tamias2d.stepped.layout import (
    ARM,
    COUNT,
    DTURN,
    DX,
    DY,
    DYNAMIC,
    GAP,
    HALF_PLANE,
    INNER,
    NX,
    NY,
    OF_A,
    OF_B,
    PAIRS,
    POINT,
    SENSOR,
    SHAPE_REACH,
    TIME_STEP,
    TURN,
    Whole,
    X,
    Y,
)
from tamias2d.stepped.manifold import touch_pair
from tamias2d.stepped.sweep import MISSED, NEAR, WIDE, place, time_of_impact

THROUGH = 0.7  # of half the widths of both: how far one may go into another and be pushed back,
# but not farther than the smaller one reaches
SHALLOW = 0.5  # of that: how far what waits may come into what is not a wall, or that into it
SWUNG = 0.35  # of the smaller reach: how far one may turn about a contact, which the solver follows


def find_meetings(
    now: float,
    settings: Array,
    counts: Whole,
    pose: Array,
    motion: Array,
    body: Array,
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
) -> int:
    """Find when all pairs meet from `now` on that the solver may let through; return how many do.

    The line that parts two bodies in contact holds them back: only what goes through it, or turns,
    can come farther in.
    """
    found = 0
    bodies = len(pose)
    for p in range(counts[PAIRS]):
        times[bodies + p] = MISSED
        s, t = pair[p, 0], pair[p, 1]
        i, j = pair[p, OF_A], pair[p, OF_B]
        bent = gained[i, BENT] + gained[j, BENT] > 0.0
        reach = min(surface[s, SHAPE_REACH], surface[t, SHAPE_REACH])
        if not bent and stay_near(gained[i], gained[j], reach):
            continue
        touches = trace[p, COUNT] > 0
        if filters[s, SENSOR] != 0 or filters[t, SENSOR] != 0:
            continue
        by_x, by_y = motion[j, DX] - motion[i, DX], motion[j, DY] - motion[i, DY]
        turn = turn_of(i, j, motion, body)
        deep = depth_of(i, j, reach, body)
        if not bent and abs(by_x) + abs(by_y) + turn <= deep:
            continue
        into = max(0.0, -touch[p, NX] * by_x - touch[p, NY] * by_y) if touches else WIDE
        if bent or into + turn > max(deep, SWUNG * reach):
            times[bodies + p] = next_meeting(
                s, t, now, settings[TIME_STEP], pose, motion, shape_body, shape_kind,
                shape_first, shape_count, shape_radius, surface, corner, turned, scratch,
            )  # fmt: skip
            found += times[bodies + p] <= 1.0
    return found


def turn_of(i: int, j: int, motion: Array, body: Array) -> float:
    """Return how far corners of two bodies go by turning in a step, m."""
    return abs(motion[i, DTURN]) * body[i, ARM] + abs(motion[j, DTURN]) * body[j, ARM]


def depth_of(i: int, j: int, reach: float, body: Array) -> float:
    """Return how far one body may go into another and be pushed back, m."""
    return min(THROUGH * width(body[i, INNER], body[j, INNER]), reach)


def stay_near(one: Array, other: Array, reach: float) -> bool:
    """Return whether two bodies go too little for one to get far into the other.

    This is what follows from how far each goes, and not from where both go.
    """
    return bool((one[BEYOND] + other[BEYOND] <= 0.0) & (one[WAY] + other[WAY] <= reach))


def renew_meetings(
    i: int,
    but: int,
    now: float,
    shallow: float,
    settings: Array,
    counts: Whole,
    pose: Array,
    motion: Array,
    body: Array,
    kind: Whole,
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
    times: Array,
    agenda: Whole,
    scratch: Array,
) -> None:
    """Find anew when a body meets others `but` one: its line is not what it was.

    What can be pushed comes into it, if by no more than a share of what can be undone.
    """
    if kind[i] != DYNAMIC:
        return
    bodies = len(pose)
    for k in range(agenda[STARTS_OF, i], agenda[STARTS_OF, i + 1]):
        p = agenda[PAIRS_OF, k]
        s, t, a, b = pair[p, 0], pair[p, 1], pair[p, OF_A], pair[p, OF_B]
        if but in (a, b) or filters[s, SENSOR] != 0 or filters[t, SENSOR] != 0:
            continue
        way = abs(motion[b, DX] - motion[a, DX]) + abs(motion[b, DY] - motion[a, DY])
        way += turn_of(a, b, motion, body)
        deep = depth_of(a, b, min(surface[s, SHAPE_REACH], surface[t, SHAPE_REACH]), body)
        harmless = kind[a] == kind[b] and way * (1.0 - now) <= shallow * deep
        times[bodies + p] = MISSED if harmless else next_meeting(
            s, t, now, settings[TIME_STEP], pose, motion, shape_body, shape_kind,
            shape_first, shape_count, shape_radius, surface, corner, turned, scratch,
        )  # fmt: skip
        play_again(bodies + p, bodies + counts[PAIRS], times, agenda)


def width(one: float, other: float) -> float:
    """Return half the widths of two bodies, m; of a half-plane only the other's counts."""
    return one if other > WIDE else other if one > WIDE else one + other


def meet_at(
    s: int,
    t: int,
    now: float,
    pose: Array,
    motion: Array,
    shape_body: Whole,
    shape_kind: Whole,
    shape_first: Whole,
    shape_count: Whole,
    shape_radius: Array,
    corner: Array,
    turned: Array,
    scratch: Array,
) -> float:
    """Write the manifold of two shapes at a fraction of the step; return their gap, m."""
    i, j = shape_body[s], shape_body[t]
    half_plane = shape_kind[s] == HALF_PLANE
    turn_to(s, i, now, half_plane, pose, motion, shape_first, shape_count, corner, turned)
    turn_to(t, j, now, False, pose, motion, shape_first, shape_count, corner, turned)
    x = pose[j, X] - pose[i, X] + now * (motion[j, DX] - motion[i, DX])
    y = pose[j, Y] - pose[i, Y] + now * (motion[j, DY] - motion[i, DY])
    row = scratch[0]
    _, second = touch_pair(
        row,
        int(shape_kind[s]),
        int(shape_kind[t]),
        int(shape_first[s]),
        int(shape_count[s]),
        int(shape_first[t]),
        int(shape_count[t]),
        x,
        y,
        float(shape_radius[s]),
        float(shape_radius[t]),
        WIDE,
        turned,
    )
    if second == 0:
        row[GAP + POINT] = WIDE
    return min(row[GAP], row[GAP + POINT])


def turn_to(
    s: int,
    i: int,
    now: float,
    fixed: bool,
    pose: Array,
    motion: Array,
    shape_first: Whole,
    shape_count: Whole,
    corner: Array,
    turned: Array,
) -> None:
    """Turn the corners of a shape to where they are at a fraction of the step."""
    first = int(shape_first[s])
    turn = pose[i, TURN] + now * motion[i, DTURN]
    place(first, int(shape_count[s]), turn, fixed, corner, first, turned)


def next_meeting(
    s: int,
    t: int,
    now: float,
    time_step: float,
    pose: Array,
    motion: Array,
    shape_body: Whole,
    shape_kind: Whole,
    shape_first: Whole,
    shape_count: Whole,
    shape_radius: Array,
    surface: Array,
    corner: Array,
    turned: Array,
    scratch: Array,
) -> float:
    """Return the fraction of the step, from `now` on, at which two shapes meet, or `MISSED`.

    A pair that is close now meets now if it approaches by more than counts as close.
    """
    if shape_kind[t] == HALF_PLANE:
        s, t = t, s
    i, j = shape_body[s], shape_body[t]
    near = NEAR * min(surface[s, SHAPE_REACH], surface[t, SHAPE_REACH])
    if pass_by(i, j, now, surface[s, SHAPE_REACH] + surface[t, SHAPE_REACH] + near, pose, motion):
        return MISSED
    gap = meet_at(
        s, t, now, pose, motion, shape_body, shape_kind, shape_first, shape_count, shape_radius,
        corner, turned, scratch,
    )  # fmt: skip
    rest = 1.0 - now
    if gap <= near:
        at_a = contact_of(scratch[0])
        at_b = seen_from_b(i, j, now, at_a, pose, motion)
        line = (scratch[0, NX], scratch[0, NY])
        closing = time_step * rate_along(i, j, time_step, at_a, at_b, line, motion)
        if closing * rest < -near:
            return now
    ahead = time_of_impact(
        s,
        t,
        pose[j, X] - pose[i, X] + now * (motion[j, DX] - motion[i, DX]),
        pose[j, Y] - pose[i, Y] + now * (motion[j, DY] - motion[i, DY]),
        rest * (motion[j, DX] - motion[i, DX]),
        rest * (motion[j, DY] - motion[i, DY]),
        rest * motion[i, DTURN],
        rest * motion[j, DTURN],
        shape_kind,
        shape_first,
        shape_count,
        shape_radius,
        turned,
        scratch,
    )
    return now + ahead * rest if ahead <= 1.0 else MISSED


def pass_by(i: int, j: int, now: float, reach: float, pose: Array, motion: Array) -> bool:
    """Return whether the centres of two bodies come no nearer to each other than a reach, m."""
    by_x, by_y = motion[j, DX] - motion[i, DX], motion[j, DY] - motion[i, DY]
    x, y = pose[j, X] - pose[i, X] + now * by_x, pose[j, Y] - pose[i, Y] + now * by_y
    ahead = -(x * by_x + y * by_y)
    square = by_x * by_x + by_y * by_y
    if ahead > 0.0:  # to where they are nearest, but not beyond the step
        until = min(ahead / square, 1.0 - now)
        x, y = x + until * by_x, y + until * by_y
    return bool(x * x + y * y > reach * reach)
