"""Few discs and half-planes from impact to impact: a table of pairs, in which all bodies are lanes.

It finds the impacts that the queue of events finds, in the same order. Of each pair the table has
when it meets, or a time before which it does not (DD46, DD80), which costs no search; that follows
once no other time is earlier. Cost of an event: two rows of the table, all lanes at once, and a
look for the least time of each row.
"""

from math import inf, nan

from tamias2d.event_driven import tables as tb
from tamias2d.event_driven.approach import EPSILON, MARGIN, time_of_impact
from tamias2d.event_driven.bound import BLURRED, earliest_meeting
from tamias2d.event_driven.cluster import resolve
from tamias2d.event_driven.instant import collide, is_full, seems_endless, stop_sliding
from tamias2d.event_driven.kinds import has_hull, is_pushed
from tamias2d.event_driven.meeting import meets
from tamias2d.event_driven.settling import rests
from tamias2d.event_driven.tables import Few, World
from tamias2d.event_driven.touch import touches_third
from tamias2d.generated import translation
from tamias2d.generated.continuous_collision import (
    advance_closing,
    advance_opening,
    discriminant,
    reach_gap,
    reach_gap_acceleration,
    reach_gap_rate,
)
from tamias2d.kernels.assembled import inlined


def are_few(world: World) -> bool:
    """Return whether there is a lane for each body, and none has corners."""
    count, corners = len(world.kinds), False
    for k in range(count):
        corners = corners or has_hull(k, k, world)
    return count <= tb.LANES and not corners


def follow_few(world: World, few: Few) -> int:
    """Go on from impact to impact up to the limit, from the start; return why it ended."""
    count = len(world.kinds)
    few.times[:, :] = inf
    few.exact[:, :] = 0
    few.bodies[:] = nan
    for k in range(count):
        take_up(k, world, few)
    place_all(0.0, few)
    for k in range(count):
        if is_pushed(k, world) and not look_around(k, -1, 0.0, world, few):
            return tb.SEARCH
    for k in range(count):
        find_first(k, world, few)
    world.counts[tb.AT_START] = world.counts[tb.CHANGED] = 0
    while True:
        k = first_of_all(world, few)
        if k < 0 or few.least[k] > world.numbers[tb.LIMIT]:
            world.numbers[tb.NOW] = world.numbers[tb.LIMIT]
            return tb.DONE
        other = few.partner[k]
        if few.exact[k, other] == 0:
            if not search_pair(k, other, world, few):
                return tb.SEARCH
            find_first(k, world, few)
            find_first(other, world, few)
            continue
        if is_full(world):
            return tb.FULL
        status = happen_to(min(k, other), max(k, other), few.least[k], world, few)
        if status != tb.DONE or seems_endless(world):
            return tb.FULL if status == tb.DONE else status


@inlined
def happen_to(i: int, j: int, time: float, world: World, few: Few) -> int:
    """Let a pair meet, or a body end its sliding, and find when both meet others."""
    world.numbers[tb.NOW] = time
    place_all(time, few)
    if i == j:
        return take_changed(time, world, few) if stop_sliding(i, time, world) else tb.INSTANT
    third = is_third_near(i, j, world, few) or is_third_near(j, i, world, few)
    if rests(i, world) or rests(j, world) or (third and touches_third(i, j, time, world)):
        return take_changed(time, world, few) if resolve(i, j, time, world) else tb.INSTANT
    if not collide(i, j, time, world):
        return tb.INSTANT
    take_up(i, world, few)
    take_up(j, world, few)
    place(i, few)
    place(j, few)
    both = is_pushed(i, world) and is_pushed(j, world)
    good = True
    if is_pushed(i, world):
        good = look_around(i, j if both else -1, time, world, few)
    if good and is_pushed(j, world):
        good = look_around(j, -1, time, world, few)
    if not good:
        return tb.SEARCH
    find_first(i, world, few)
    find_first(j, world, few)
    return tb.DONE


@inlined
def take_changed(time: float, world: World, few: Few) -> int:
    """Find when the bodies whose paths are new meet others."""
    count = world.counts[tb.CHANGED]
    world.counts[tb.CHANGED] = 0
    for n in range(count):
        take_up(world.changed[n], world, few)
        place(world.changed[n], few)
    for n in range(count):
        if not look_around(world.changed[n], -1, time, world, few):
            return tb.SEARCH
    for n in range(count):
        find_first(world.changed[n], world, few)
    return tb.DONE


@inlined
def first_of_all(world: World, few: Few) -> int:
    """Return the body whose next meeting is the first of all, -1 if there is none."""
    found, least = -1, inf
    for k in range(len(world.kinds)):
        if few.least[k] < least:
            found, least = k, few.least[k]
    return found


@inlined
def find_first(k: int, world: World, few: Few) -> None:
    """Find the first meeting of a body, with the first body of some at once."""
    row, found, least = few.times[k], -1, inf
    for other in range(len(world.kinds)):
        if row[other] < least:
            found, least = other, row[other]
    few.partner[k], few.least[k] = found, least


@inlined
def search_pair(i: int, j: int, world: World, few: Few) -> bool:
    """Find when a pair meets; return whether that can be told."""
    first, second = min(i, j), max(i, j)
    start = max(world.paths[first, tb.START], world.paths[second, tb.START])
    time = time_of_impact(first, second, start, world.numbers[tb.END], world)
    note_meeting(i, j, time, 1, few)
    return time >= 0.0


@inlined
def note_meeting(i: int, j: int, time: float, exact: int, few: Few) -> None:
    """Note when a pair meets, s, or a time before which it does not."""
    few.times[i, j], few.times[j, i] = time, time
    few.exact[i, j], few.exact[j, i] = exact, exact


@inlined
def look_around(k: int, but: int, time: float, world: World, few: Few) -> bool:
    """Note when a body that is on a new path meets the others, but for one of them.

    Return whether that can be told.
    """
    measure_gaps(k, world.numbers[tb.END], few)
    measure_times(k, world.counts[tb.AT_START] == 0, few)
    for other in range(len(world.kinds)):
        if other == but:
            continue
        if other == k:
            note_meeting(k, k, world.sliding[k], 1, few)
            continue
        early = few.now[tb.NOW_TIME + other]
        i, j = min(k, other), max(k, other)
        if not meets(i, j, world):
            early = inf
        elif early == tb.UNLIKE:
            early = earliest_meeting(i, j, time, world.numbers[tb.END], world) - time
        if early > 0.0:
            note_meeting(k, other, time + early, 0, few)
        elif not search_pair(i, j, world, few):
            return False
        if few.partner[other] == k or few.times[k, other] <= few.least[other]:
            find_first(other, world, few)
    return True


@inlined
def is_third_near(k: int, partner: int, world: World, few: Few) -> bool:
    """Return whether a body may touch another one than its partner."""
    if not is_pushed(k, world):
        return False
    measure_gaps(k, world.numbers[tb.END], few)
    near = 0
    for other in range(tb.LANES):
        near += 1 if few.now[tb.NOW_GAP + other] <= 0.0 else 0
    near -= 1 if few.now[tb.NOW_GAP + k] <= 0.0 else 0
    near -= 1 if few.now[tb.NOW_GAP + partner] <= 0.0 else 0
    return near > 0


# -- lanes


@inlined
def take_up(k: int, world: World, few: Few) -> None:
    """Put a body into its lane: what it is, and its path; one without a shape stays away."""
    path, body, lanes = world.paths[k], world.bodies[k], few.bodies
    lanes[tb.LANE_X + k], lanes[tb.LANE_Y + k] = path[tb.X], path[tb.Y]
    lanes[tb.LANE_U + k], lanes[tb.LANE_V + k] = path[tb.VX], path[tb.VY]
    lanes[tb.LANE_AX + k], lanes[tb.LANE_AY + k] = path[tb.AX], path[tb.AY]
    lanes[tb.LANE_START + k] = path[tb.START]
    plane = world.kinds[k] == tb.PLANE
    lanes[tb.LANE_PLANE + k] = 1.0 if plane else 0.0
    lanes[tb.LANE_NX + k], lanes[tb.LANE_NY + k] = body[tb.NORMAL_X], body[tb.NORMAL_Y]
    lanes[tb.LANE_OFFSET + k] = body[tb.OFFSET]
    lanes[tb.LANE_RADIUS + k] = body[tb.RADIUS] if world.kinds[k] >= tb.PLANE else nan
    lanes[tb.LANE_FAR + k] = abs(body[tb.OFFSET]) if plane else body[tb.RADIUS]


@inlined
def place_all(time: float, few: Few) -> None:
    """Find where all bodies are at a time, s, and how fast."""
    lanes, now = few.bodies, few.now
    for m in range(tb.LANES):
        elapsed = time - lanes[tb.LANE_START + m]
        going, by = (
            (lanes[tb.LANE_U + m], lanes[tb.LANE_V + m]),
            (lanes[tb.LANE_AX + m], lanes[tb.LANE_AY + m]),
        )
        x, y = translation.position(
            (lanes[tb.LANE_X + m], lanes[tb.LANE_Y + m]), going, by, elapsed
        )
        u, v = translation.velocity(going, by, elapsed)
        now[tb.NOW_X + m], now[tb.NOW_Y + m], now[tb.NOW_U + m], now[tb.NOW_V + m] = x, y, u, v
        now[tb.NOW_FAR + m] = abs(x) + abs(y) + lanes[tb.LANE_FAR + m]


@inlined
def place(k: int, few: Few) -> None:
    """Note how fast a body is that starts on its path now."""
    few.now[tb.NOW_U + k], few.now[tb.NOW_V + k] = (
        few.bodies[tb.LANE_U + k],
        few.bodies[tb.LANE_V + k],
    )


@inlined
def measure_gaps(k: int, end: float, few: Few) -> None:
    """Measure how far one body is from all, by the circle around it, taken larger.

    To a half-plane it is the gap, m, to a disc what DD80 says, m^2; `BLUR` where rounding may count
    up to an end, s.
    """
    lanes, now = few.bodies, few.now
    x, y, u, v = now[tb.NOW_X + k], now[tb.NOW_Y + k], now[tb.NOW_U + k], now[tb.NOW_V + k]
    radius, far = lanes[tb.LANE_RADIUS + k], now[tb.NOW_FAR + k]
    for m in range(tb.LANES):
        plane = lanes[tb.LANE_PLANE + m] > 0.0
        dx, dy = now[tb.NOW_X + m] - x, now[tb.NOW_Y + m] - y
        base = radius if plane else radius + lanes[tb.LANE_RADIUS + m]
        reach = base * (1.0 + MARGIN)
        away = (
            -(lanes[tb.LANE_NX + m] * dx + lanes[tb.LANE_NY + m] * dy)
            - lanes[tb.LANE_OFFSET + m]
            - reach
        )
        gap = away if plane else reach_gap((dx, dy), reach)
        speed = abs(now[tb.NOW_U + m] - u) + abs(now[tb.NOW_V + m] - v)
        blur = (BLURRED * EPSILON) * (16 * (far + now[tb.NOW_FAR + m]) + 4 * speed * end)
        now[tb.NOW_GAP + m] = tb.BLUR if blur > base * MARGIN else gap


@inlined
def measure_times(k: int, may_part: bool, few: Few) -> None:
    """Find how long one body does not meet each other one, s, from gaps that were measured (DD46).

    It is 0 where they may touch now, and `UNLIKE` for discs that are accelerated otherwise.
    """
    lanes, now = few.bodies, few.now
    x, y, u, v = now[tb.NOW_X + k], now[tb.NOW_Y + k], now[tb.NOW_U + k], now[tb.NOW_V + k]
    ax, ay, radius = lanes[tb.LANE_AX + k], lanes[tb.LANE_AY + k], lanes[tb.LANE_RADIUS + k]
    for m in range(tb.LANES):
        plane, gap = lanes[tb.LANE_PLANE + m] > 0.0, now[tb.NOW_GAP + m]
        span = (now[tb.NOW_X + m] - x, now[tb.NOW_Y + m] - y)
        du, dv = now[tb.NOW_U + m] - u, now[tb.NOW_V + m] - v
        nx, ny = lanes[tb.LANE_NX + m], lanes[tb.LANE_NY + m]
        rate = -(nx * du + ny * dv) if plane else reach_gap_rate(span, (du, dv))
        least = nx * ax + ny * ay if plane else reach_gap_acceleration((du, dv))
        inside = discriminant(gap, rate, least)
        real = max(inside, 0.0)
        opening = advance_opening(rate, least, real) if least < 0.0 else inf
        closing = advance_closing(gap, rate, real) if rate < 0.0 or real > 0.0 else inf
        apart = opening if rate > 0.0 else closing
        apart = apart if inside >= 0.0 else inf
        reach = 1.0 if plane else radius + lanes[tb.LANE_RADIUS + m]
        parting = may_part and gap > tb.BLUR and rate > MARGIN * reach * (abs(du) + abs(dv))
        touching = opening if parting and (inside > 0.0 or least >= 0.0) else 0.0
        found = apart if gap > 0.0 else touching
        like = plane or (lanes[tb.LANE_AX + m] == ax and lanes[tb.LANE_AY + m] == ay)
        now[tb.NOW_TIME + m] = found if like else tb.UNLIKE
