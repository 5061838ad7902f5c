"""Few discs and half-planes from impact to impact: a table of pairs, in which all bodies are lanes.

It finds the impacts that the queue of events finds, in the same order. Of each pair the table has
when it meets, or a time before which it does not (DD46, DD80), which costs no search; that follows
once no other time is earlier. Cost of an event: two rows of the table, all lanes at once, and a
look for the least time of each row.
"""

from math import inf, nan

from tamias2d.event_driven.approach import EPSILON, MARGIN, time_of_impact
from tamias2d.event_driven.bound import BLURRED, earliest_meeting
from tamias2d.event_driven.instant import collide, is_full
from tamias2d.event_driven.kinds import has_hull, is_pushed
from tamias2d.event_driven.meeting import meets
from tamias2d.event_driven.tables import (
    AT_START,
    AX,
    AY,
    BLUR,
    DONE,
    END,
    FULL,
    INSTANT,
    LANE_AX,
    LANE_AY,
    LANE_FAR,
    LANE_NX,
    LANE_NY,
    LANE_OFFSET,
    LANE_PLANE,
    LANE_RADIUS,
    LANE_START,
    LANE_U,
    LANE_V,
    LANE_X,
    LANE_Y,
    LANES,
    LIMIT,
    NORMAL_X,
    NORMAL_Y,
    NOW,
    NOW_FAR,
    NOW_GAP,
    NOW_TIME,
    NOW_U,
    NOW_V,
    NOW_X,
    NOW_Y,
    OFFSET,
    PLANE,
    RADIUS,
    SEARCH,
    START,
    UNLIKE,
    VX,
    VY,
    Few,
    World,
    X,
    Y,
)
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
    return count <= LANES and not corners


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
            return SEARCH
    for k in range(count):
        find_first(k, world, few)
    world.counts[AT_START] = 0
    while True:
        k = first_of_all(world, few)
        if k < 0 or few.least[k] > world.numbers[LIMIT]:
            world.numbers[NOW] = world.numbers[LIMIT]
            return DONE
        other = few.partner[k]
        if few.exact[k, other] == 0:
            if not search_pair(k, other, world, few):
                return SEARCH
            find_first(k, world, few)
            find_first(other, world, few)
            continue
        if is_full(world):
            return FULL
        status = happen_to(min(k, other), max(k, other), few.least[k], world, few)
        if status != DONE:
            return status


@inlined
def happen_to(i: int, j: int, time: float, world: World, few: Few) -> int:
    """Let a pair meet, and find when both meet others."""
    world.numbers[NOW] = time
    place_all(time, few)
    third = is_third_near(i, j, world, few) or is_third_near(j, i, world, few)
    if third and touches_third(i, j, time, world):
        return INSTANT
    if not collide(i, j, time, world):
        return INSTANT
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
        return SEARCH
    find_first(i, world, few)
    find_first(j, world, few)
    return DONE


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
    start = max(world.paths[first, START], world.paths[second, START])
    time = time_of_impact(first, second, start, world.numbers[END], world)
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
    measure_gaps(k, world.numbers[END], few)
    measure_times(k, world.counts[AT_START] == 0, few)
    for other in range(len(world.kinds)):
        if other == but:
            continue
        early = few.now[NOW_TIME + other]
        i, j = min(k, other), max(k, other)
        if not meets(i, j, world):
            early = inf
        elif early == UNLIKE:
            early = earliest_meeting(i, j, time, world.numbers[END], world) - time
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
    measure_gaps(k, world.numbers[END], few)
    near = 0
    for other in range(LANES):
        near += 1 if few.now[NOW_GAP + other] <= 0.0 else 0
    near -= 1 if few.now[NOW_GAP + k] <= 0.0 else 0
    near -= 1 if few.now[NOW_GAP + partner] <= 0.0 else 0
    return near > 0


# -- lanes


@inlined
def take_up(k: int, world: World, few: Few) -> None:
    """Put a body into its lane: what it is, and its path; one without a shape stays away."""
    path, body, lanes = world.paths[k], world.bodies[k], few.bodies
    lanes[LANE_X + k], lanes[LANE_Y + k] = path[X], path[Y]
    lanes[LANE_U + k], lanes[LANE_V + k] = path[VX], path[VY]
    lanes[LANE_AX + k], lanes[LANE_AY + k] = path[AX], path[AY]
    lanes[LANE_START + k] = path[START]
    plane = world.kinds[k] == PLANE
    lanes[LANE_PLANE + k] = 1.0 if plane else 0.0
    lanes[LANE_NX + k], lanes[LANE_NY + k] = body[NORMAL_X], body[NORMAL_Y]
    lanes[LANE_OFFSET + k] = body[OFFSET]
    lanes[LANE_RADIUS + k] = body[RADIUS] if world.kinds[k] >= PLANE else nan
    lanes[LANE_FAR + k] = abs(body[OFFSET]) if plane else body[RADIUS]


@inlined
def place_all(time: float, few: Few) -> None:
    """Find where all bodies are at a time, s, and how fast."""
    lanes, now = few.bodies, few.now
    for m in range(LANES):
        elapsed = time - lanes[LANE_START + m]
        going, by = (lanes[LANE_U + m], lanes[LANE_V + m]), (lanes[LANE_AX + m], lanes[LANE_AY + m])
        x, y = translation.position((lanes[LANE_X + m], lanes[LANE_Y + m]), going, by, elapsed)
        u, v = translation.velocity(going, by, elapsed)
        now[NOW_X + m], now[NOW_Y + m], now[NOW_U + m], now[NOW_V + m] = x, y, u, v
        now[NOW_FAR + m] = abs(x) + abs(y) + lanes[LANE_FAR + m]


@inlined
def place(k: int, few: Few) -> None:
    """Note how fast a body is that starts on its path now."""
    few.now[NOW_U + k], few.now[NOW_V + k] = few.bodies[LANE_U + k], few.bodies[LANE_V + k]


@inlined
def measure_gaps(k: int, end: float, few: Few) -> None:
    """Measure how far one body is from all, by the circle around it, taken larger.

    To a half-plane it is the gap, m, to a disc what DD80 says, m^2; `BLUR` where rounding may count
    up to an end, s.
    """
    lanes, now = few.bodies, few.now
    x, y, u, v = now[NOW_X + k], now[NOW_Y + k], now[NOW_U + k], now[NOW_V + k]
    radius, far = lanes[LANE_RADIUS + k], now[NOW_FAR + k]
    for m in range(LANES):
        plane = lanes[LANE_PLANE + m] > 0.0
        dx, dy = now[NOW_X + m] - x, now[NOW_Y + m] - y
        base = radius if plane else radius + lanes[LANE_RADIUS + m]
        reach = base * (1.0 + MARGIN)
        away = -(lanes[LANE_NX + m] * dx + lanes[LANE_NY + m] * dy) - lanes[LANE_OFFSET + m] - reach
        gap = away if plane else reach_gap((dx, dy), reach)
        speed = abs(now[NOW_U + m] - u) + abs(now[NOW_V + m] - v)
        blur = (BLURRED * EPSILON) * (16 * (far + now[NOW_FAR + m]) + 4 * speed * end)
        now[NOW_GAP + m] = BLUR if blur > base * MARGIN else gap


@inlined
def measure_times(k: int, may_part: bool, few: Few) -> None:
    """Find how long one body does not meet each other one, s, from gaps that were measured (DD46).

    It is 0 where they may touch now, and `UNLIKE` for discs that are accelerated otherwise.
    """
    lanes, now = few.bodies, few.now
    x, y, u, v = now[NOW_X + k], now[NOW_Y + k], now[NOW_U + k], now[NOW_V + k]
    ax, ay, radius = lanes[LANE_AX + k], lanes[LANE_AY + k], lanes[LANE_RADIUS + k]
    for m in range(LANES):
        plane, gap = lanes[LANE_PLANE + m] > 0.0, now[NOW_GAP + m]
        span = (now[NOW_X + m] - x, now[NOW_Y + m] - y)
        du, dv = now[NOW_U + m] - u, now[NOW_V + m] - v
        nx, ny = lanes[LANE_NX + m], lanes[LANE_NY + m]
        rate = -(nx * du + ny * dv) if plane else reach_gap_rate(span, (du, dv))
        least = nx * ax + ny * ay if plane else reach_gap_acceleration((du, dv))
        inside = discriminant(gap, rate, least)
        real = max(inside, 0.0)
        opening = advance_opening(rate, least, real) if least < 0.0 else inf
        closing = advance_closing(gap, rate, real) if rate < 0.0 or real > 0.0 else inf
        apart = opening if rate > 0.0 else closing
        apart = apart if inside >= 0.0 else inf
        reach = 1.0 if plane else radius + lanes[LANE_RADIUS + m]
        parting = may_part and gap > BLUR and rate > MARGIN * reach * (abs(du) + abs(dv))
        touching = opening if parting and (inside > 0.0 or least >= 0.0) else 0.0
        found = apart if gap > 0.0 else touching
        like = plane or (lanes[LANE_AX + m] == ax and lanes[LANE_AY + m] == ay)
        now[NOW_TIME + m] = found if like else UNLIKE
