"""Bodies that go far in a step: they meet what is in their way, and go on from there.

Serves: a step, for what the solver has not seen coming. Hides: in which order they meet.

In a step every body goes along a line and turns evenly. Where one goes farther than its own
thickness, the instants at which it comes close to others are found, and at the first of them the
impact happens at once: both go on along new lines for the rest of the step (IM10, one row). What
then is in their way is looked for again, and where a new line leaves the room in which neighbours
are known, all pairs are. What is pressed together again for the rest of the step stays together.
"""

from tamias2d.generated.soft_contact import (
    angular_velocity_a_kicked,
    angular_velocity_b_kicked,
    bouncing_push,
    limited_rub,
    row_mass,
    row_velocity,
    turning_arm,
    velocity_a_kicked,
    velocity_b_kicked,
)
from tamias2d.state import Array, Vector
from tamias2d.stepped.layout import (
    ARM,
    COUNT,
    DTURN,
    DX,
    DY,
    DYNAMIC,
    FLOWN_NORMAL,
    FRAME_X,
    FRAME_Y,
    GAP,
    GRAVITY_X,
    GRAVITY_Y,
    HALF_PLANE,
    HIGH_X,
    HIGH_Y,
    INNER,
    INVERSE_INERTIA,
    INVERSE_MASS,
    KINEMATIC,
    LOW_X,
    LOW_Y,
    NX,
    NY,
    PAIR_FRICTION,
    PAIR_RESTITUTION,
    PAIRS,
    POINT,
    PX,
    PY,
    REACH,
    SENSOR,
    SHAPE_REACH,
    SPIN,
    TIME_STEP,
    TOTAL,
    TOUCHED,
    TURN,
    VX,
    VY,
    WHERE,
    Whole,
    X,
    Y,
)
from tamias2d.stepped.manifold import touch_pair
from tamias2d.stepped.pairs import AROUND
from tamias2d.stepped.sweep import MISSED, NEAR, WIDE, place, time_of_impact

FAST = 0.35  # of half its width: how far a body goes before it is looked after
THROUGH = 0.7  # of half the widths of both: how far one may go into another and be pushed back,
# but not farther than the smaller one reaches
IMPACTS = 64  # in one step, and four more for every pair that meets
LOOKS_AROUND = 32  # in one step: then a body waits where its neighbours are not known any more
BENT, LEANT = 0, 1  # columns of what bodies gained that are free: 1 where a line is bent; where a
# body has contacts, so that its velocity at the end says little of that on its way


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
    (p,) is for when pairs meet, `scratch` (k, 8) for the corners of two shapes. Returns the
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


def earliest(pairs: int, times: Array) -> int:
    """Return the pair that meets first."""
    first = 0
    for p in range(1, pairs):
        if times[p] < times[first]:
            first = p
    return first


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


def seen_from_b(i: int, j: int, now: float, at_a: Vector, pose: Array, motion: Array) -> Vector:
    """Return from the centre of B what is known from that of A, at a fraction of the step."""
    return (
        at_a[0] - (pose[j, X] - pose[i, X] + now * (motion[j, DX] - motion[i, DX])),
        at_a[1] - (pose[j, Y] - pose[i, Y] + now * (motion[j, DY] - motion[i, DY])),
    )


def contact_of(row: Array) -> tuple[float, float]:
    """Return where two shapes touch: the deeper point, or midway where both are as deep."""
    apart = row[GAP + POINT] - row[GAP]
    near = NEAR * (abs(row[PX + POINT] - row[PX]) + abs(row[PY + POINT] - row[PY]))
    if row[GAP + POINT] < WIDE and abs(apart) <= near:
        return 0.5 * (row[PX] + row[PX + POINT]), 0.5 * (row[PY] + row[PY + POINT])
    if apart < 0.0:
        return row[PX + POINT], row[PY + POINT]
    return row[PX], row[PY]


def part(
    i: int,
    j: int,
    now: float,
    time_step: float,
    friction: float,
    restitution: float,
    pose: Array,
    motion: Array,
    body: Array,
    gained: Array,
    row: Array,
) -> float:
    """Let the impact of two bodies happen, by one row along the normal and one along the tangent.

    Where forces press them together again in the rest of the step, they stay together. Returns the
    impulse along the normal, N s; a negative number where nothing happens.
    """
    at_a = contact_of(row)
    at_b = seen_from_b(i, j, now, at_a, pose, motion)
    line = (row[NX], row[NY])
    mass = mass_along(i, j, at_a, at_b, line, body)
    before = speed_along(i, j, 1.0 - now, at_a, at_b, line, motion, gained)
    rate = rate_along(i, j, time_step, at_a, at_b, line, motion)
    if before >= 0.0 and rate >= 0.0:
        return -1.0
    back = bouncing_push(0.0, 0.0, min(max(before, rate), 0.0), restitution, mass)
    if gained[i, LEANT] + gained[j, LEANT] > 0.0:
        push = max(-mass * before, 0.0) + back
        kick_both(i, j, push, at_a, at_b, line, motion, body)
        way = (max(-mass * rate, 0.0) + back) * time_step
        bend(i, j, now, way, at_a, at_b, line, pose, motion, body)
    else:
        push = bouncing_push(0.0, before, before, restitution, mass) if before < 0.0 else 0.0
        strike(i, j, now, time_step, push, at_a, at_b, line, pose, motion, body)
    rate = rate_along(i, j, time_step, at_a, at_b, line, motion)
    if rate < 0.0:
        bend(i, j, now, -mass * rate * time_step, at_a, at_b, line, pose, motion, body)
        after = speed_along(i, j, 0.0, at_a, at_b, line, motion, gained)
        held = max(-mass * after, 0.0)
        kick_both(i, j, held, at_a, at_b, line, motion, body)
        push += held
    if friction > 0.0:
        line = (-row[NY], row[NX])
        speed = speed_along(i, j, 1.0 - now, at_a, at_b, line, motion, gained)
        mass = mass_along(i, j, at_a, at_b, line, body)
        rub = limited_rub(0.0, speed, mass, friction, push)
        strike(i, j, now, time_step, rub, at_a, at_b, line, pose, motion, body)
    return push


def note_impact(
    push: float,
    i: int,
    now: float,
    sense: float,
    pose: Array,
    motion: Array,
    row: Array,
    touch: Array,
    trace: Whole,
) -> None:
    """Note an impact for what is told of the step: those of a pair add up, at the first place."""
    if trace[TOUCHED] & 1:
        touch[TOTAL] += push
        return
    trace[TOUCHED] |= 1
    touch[TOTAL] = push
    if trace[COUNT] == 0:
        x, y = contact_of(row)
        touch[WHERE] = pose[i, X] + now * motion[i, DX] + x
        touch[WHERE + 1] = pose[i, Y] + now * motion[i, DY] + y
        touch[FLOWN_NORMAL], touch[FLOWN_NORMAL + 1] = sense * row[NX], sense * row[NY]


def speed_along(
    i: int,
    j: int,
    left: float,
    at_a: Vector,
    at_b: Vector,
    line: Vector,
    motion: Array,
    gained: Array,
) -> float:
    """Return the velocity of B's point against A's along a line, m/s.

    `left` is the share of the step for which forces have not acted yet.
    """
    return row_velocity(
        (motion[i, VX] - left * gained[i, 3], motion[i, VY] - left * gained[i, 4]),
        motion[i, SPIN] - left * gained[i, 5],
        turning_arm(at_a, line),
        (motion[j, VX] - left * gained[j, 3], motion[j, VY] - left * gained[j, 4]),
        motion[j, SPIN] - left * gained[j, 5],
        turning_arm(at_b, line),
        line,
    )


def rate_along(
    i: int, j: int, time_step: float, at_a: Vector, at_b: Vector, line: Vector, motion: Array
) -> float:
    """Return the same along the lines on which bodies go, m/s."""
    return (
        row_velocity(
            (motion[i, DX], motion[i, DY]),
            motion[i, DTURN],
            turning_arm(at_a, line),
            (motion[j, DX], motion[j, DY]),
            motion[j, DTURN],
            turning_arm(at_b, line),
            line,
        )
        / time_step
    )


def mass_along(i: int, j: int, at_a: Vector, at_b: Vector, line: Vector, body: Array) -> float:
    """Return the mass that an impulse along a line meets, kg."""
    return row_mass(
        body[i, INVERSE_MASS],
        body[i, INVERSE_INERTIA],
        turning_arm(at_a, line),
        body[j, INVERSE_MASS],
        body[j, INVERSE_INERTIA],
        turning_arm(at_b, line),
    )


def strike(
    i: int,
    j: int,
    now: float,
    time_step: float,
    amount: float,
    at_a: Vector,
    at_b: Vector,
    line: Vector,
    pose: Array,
    motion: Array,
    body: Array,
) -> None:
    """Let an impulse act on both bodies, on their velocities and on their lines from now on."""
    kick_both(i, j, amount, at_a, at_b, line, motion, body)
    bend(i, j, now, amount * time_step, at_a, at_b, line, pose, motion, body)


def kick_both(
    i: int,
    j: int,
    amount: float,
    at_a: Vector,
    at_b: Vector,
    line: Vector,
    motion: Array,
    body: Array,
) -> None:
    """Let an impulse change the velocities of both bodies."""
    motion[i, VX], motion[i, VY] = velocity_a_kicked(
        (motion[i, VX], motion[i, VY]), amount, line, body[i, INVERSE_MASS]
    )
    motion[i, SPIN] = angular_velocity_a_kicked(
        motion[i, SPIN], amount, turning_arm(at_a, line), body[i, INVERSE_INERTIA]
    )
    motion[j, VX], motion[j, VY] = velocity_b_kicked(
        (motion[j, VX], motion[j, VY]), amount, line, body[j, INVERSE_MASS]
    )
    motion[j, SPIN] = angular_velocity_b_kicked(
        motion[j, SPIN], amount, turning_arm(at_b, line), body[j, INVERSE_INERTIA]
    )


def bend(
    i: int,
    j: int,
    now: float,
    amount: float,
    at_a: Vector,
    at_b: Vector,
    line: Vector,
    pose: Array,
    motion: Array,
    body: Array,
) -> None:
    """Bend the lines of both bodies as an impulse does, in N s times the time step, s."""
    none = (0.0, 0.0)
    by = velocity_a_kicked(none, amount, line, body[i, INVERSE_MASS])
    turn = angular_velocity_a_kicked(0.0, amount, turning_arm(at_a, line), body[i, INVERSE_INERTIA])
    bend_line(i, now, by, turn, pose, motion)
    by = velocity_b_kicked(none, amount, line, body[j, INVERSE_MASS])
    turn = angular_velocity_b_kicked(0.0, amount, turning_arm(at_b, line), body[j, INVERSE_INERTIA])
    bend_line(j, now, by, turn, pose, motion)


def bend_line(i: int, now: float, by: Vector, turn: float, pose: Array, motion: Array) -> None:
    """Let a line go on from where it is now with another way over a whole step, m and rad.

    It is kept as where it would have begun, and how far it goes in all.
    """
    pose[i, X] -= now * by[0]
    pose[i, Y] -= now * by[1]
    pose[i, TURN] -= now * turn
    motion[i, DX] += by[0]
    motion[i, DY] += by[1]
    motion[i, DTURN] += turn


def wait_at_border(
    settings: Array, i: int, now: float, pose: Array, motion: Array, home: Array, kind: Whole
) -> None:
    """Stop a body where its line leaves the room in which its neighbours are known."""
    if kind[i] != DYNAMIC:
        return
    until = 1.0
    for k in range(2):
        start, way = pose[i, k] - settings[FRAME_X + k], motion[i, DX + k]
        if way > 0.0 and start + way > home[i, HIGH_X + k]:
            until = min(until, (home[i, HIGH_X + k] - start) / way)
        elif way < 0.0 and start + way < home[i, LOW_X + k]:
            until = min(until, (home[i, LOW_X + k] - start) / way)
    if until < 1.0:
        until = max(until, now)
        for k in range(3):
            here = pose[i, k] + now * motion[i, DX + k]
            motion[i, DX + k] *= (until - now) / (1.0 - now)
            pose[i, k] = here - now * motion[i, DX + k]


def stop_at(i: int, now: float, pose: Array, motion: Array, kind: Whole) -> None:
    """Let a body stay where it is at a fraction of the step; it keeps its velocity."""
    if kind[i] == DYNAMIC:
        for k in range(3):
            pose[i, k] += now * motion[i, DX + k]
            motion[i, DX + k] = 0.0
