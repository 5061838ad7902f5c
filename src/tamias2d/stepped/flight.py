"""Bodies that go far in a step: they meet what is in their way, and go on from there.

Serves: a step, for what the solver has not seen coming. Hides: in which order they meet.

In a step every body goes along a line and turns evenly. Where one goes farther than its own
thickness, the instants at which it comes close to others are found, and at the first of them the
impact happens at once: both go on along new lines for the rest of the step (IM10, one row). What
then is in their way is looked for again. A body whose new line leaves the room in which its
neighbours are known waits at its border until the next step.
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
THROUGH = 0.7  # of half the widths of both: how far one may go into another and be pushed back
IMPACTS = 64  # in one step, and as many again for every pair that meets


def goes_far(kind: Whole, motion: Array, body: Array) -> bool:
    """Return whether some body goes farther in this step than it could be pushed back from."""
    far = False
    for i in range(len(kind)):
        far = far | ((way_of(i, motion, body) > FAST * body[i, INNER]) & (kind[i] >= KINEMATIC))
    return far


def outruns(
    settings: Array, kind: Whole, pose: Array, motion: Array, body: Array, home: Array
) -> bool:
    """Return whether a body that goes far leaves the room in which its neighbours are known.

    They are known a little farther than the room, too.
    """
    out = False
    for i in range(len(kind)):
        if kind[i] == DYNAMIC and way_of(i, motion, body) > FAST * body[i, INNER]:
            x = pose[i, X] + motion[i, DX] - settings[FRAME_X]
            y = pose[i, Y] + motion[i, DY] - settings[FRAME_Y]
            more = AROUND * body[i, REACH]
            inside = (
                (x >= home[i, LOW_X] - more)
                & (x <= home[i, HIGH_X] + more)
                & (y >= home[i, LOW_Y] - more)
                & (y <= home[i, HIGH_Y] + more)
            )
            out = out | (not inside)
    return out


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
) -> None:
    """Let all impacts of a step happen that the solver has not seen, in their order.

    `gained` (n+1, 6) holds in its last columns what forces add to velocities in this step; `times`
    (p,) is for when pairs meet, `scratch` (k, 8) for the corners of two shapes.
    """
    found = 0
    for p in range(counts[PAIRS]):
        times[p] = MISSED
        s, t = pair[p, 0], pair[p, 1]
        if trace[p, COUNT] > 0 or filters[s, SENSOR] != 0 or filters[t, SENSOR] != 0:
            continue
        i, j = shape_body[s], shape_body[t]
        way = (
            abs(motion[j, DX] - motion[i, DX])
            + abs(motion[j, DY] - motion[i, DY])
            + abs(motion[i, DTURN]) * body[i, ARM]
            + abs(motion[j, DTURN]) * body[j, ARM]
        )
        if way > THROUGH * width(body[i, INNER], body[j, INNER]):
            times[p] = next_meeting(
                s, t, 0.0, pose, motion, shape_body, shape_kind, shape_first, shape_count,
                shape_radius, surface, corner, turned, scratch,
            )  # fmt: skip
            found += times[p] <= 1.0
    for _ in range(IMPACTS * found):
        first = earliest(counts[PAIRS], times)
        now = times[first]
        if now > 1.0:
            return
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
        if push == 0.0:
            continue
        note_impact(
            push, i, now, 1.0 if s == pair[first, 0] else -1.0, pose, motion, scratch[0],
            touch[first], trace[first],
        )  # fmt: skip
        wait_at_border(settings, i, now, pose, motion, home, kind)
        wait_at_border(settings, j, now, pose, motion, home, kind)
        for p in range(counts[PAIRS]):
            s, t = pair[p, 0], pair[p, 1]
            a, b = shape_body[s], shape_body[t]
            new = ((a == i) | (b == i)) & (kind[i] == DYNAMIC)
            new = new | (((a == j) | (b == j)) & (kind[j] == DYNAMIC))
            if new and filters[s, SENSOR] == 0 and filters[t, SENSOR] == 0:
                times[p] = next_meeting(
                    s, t, now, pose, motion, shape_body, shape_kind, shape_first, shape_count,
                    shape_radius, surface, corner, turned, scratch,
                )  # fmt: skip
    for p in range(counts[PAIRS]):  # too many impacts: what would meet waits for the next step
        if times[p] <= 1.0:
            stop_at(shape_body[pair[p, 0]], times[p], pose, motion, kind)
            stop_at(shape_body[pair[p, 1]], times[p], pose, motion, kind)


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
    gap = meet_at(
        s, t, now, pose, motion, shape_body, shape_kind, shape_first, shape_count, shape_radius,
        corner, turned, scratch,
    )  # fmt: skip
    near = NEAR * min(surface[s, SHAPE_REACH], surface[t, SHAPE_REACH])
    rest = 1.0 - now
    if gap <= near:
        x, y = contact_of(scratch[0])
        closing = row_velocity(
            (motion[i, DX], motion[i, DY]),
            motion[i, DTURN],
            turning_arm((x, y), (scratch[0, NX], scratch[0, NY])),
            (motion[j, DX], motion[j, DY]),
            motion[j, DTURN],
            turning_arm(
                (
                    x - (pose[j, X] - pose[i, X] + now * (motion[j, DX] - motion[i, DX])),
                    y - (pose[j, Y] - pose[i, Y] + now * (motion[j, DY] - motion[i, DY])),
                ),
                (scratch[0, NX], scratch[0, NY]),
            ),
            (scratch[0, NX], scratch[0, NY]),
        )
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

    Returns the impulse along the normal, N s; 0 where they do not approach.
    """
    x, y = contact_of(row)
    at_b = (
        x - (pose[j, X] - pose[i, X] + now * (motion[j, DX] - motion[i, DX])),
        y - (pose[j, Y] - pose[i, Y] + now * (motion[j, DY] - motion[i, DY])),
    )
    line = (row[NX], row[NY])
    before = speed_along(i, j, now, (x, y), at_b, line, motion, gained)
    if before >= 0.0:
        return 0.0
    mass = mass_along(i, j, (x, y), at_b, line, body)
    push = bouncing_push(0.0, before, before, restitution, mass)
    strike(i, j, now, time_step, push, (x, y), at_b, line, pose, motion, body)
    if friction > 0.0:
        line = (-row[NY], row[NX])
        speed = speed_along(i, j, now, (x, y), at_b, line, motion, gained)
        mass = mass_along(i, j, (x, y), at_b, line, body)
        rub = limited_rub(0.0, speed, mass, friction, push)
        strike(i, j, now, time_step, rub, (x, y), at_b, line, pose, motion, body)
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
    now: float,
    at_a: Vector,
    at_b: Vector,
    line: Vector,
    motion: Array,
    gained: Array,
) -> float:
    """Return the velocity of B's point against A's along a line at a fraction of the step, m/s."""
    left = 1.0 - now
    return row_velocity(
        (motion[i, VX] - left * gained[i, 3], motion[i, VY] - left * gained[i, 4]),
        motion[i, SPIN] - left * gained[i, 5],
        turning_arm(at_a, line),
        (motion[j, VX] - left * gained[j, 3], motion[j, VY] - left * gained[j, 4]),
        motion[j, SPIN] - left * gained[j, 5],
        turning_arm(at_b, line),
        line,
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
    none = (0.0, 0.0)
    by = velocity_a_kicked(none, amount, line, body[i, INVERSE_MASS])
    turn = angular_velocity_a_kicked(0.0, amount, turning_arm(at_a, line), body[i, INVERSE_INERTIA])
    bend_line(i, now, time_step, by, turn, pose, motion)
    by = velocity_b_kicked(none, amount, line, body[j, INVERSE_MASS])
    turn = angular_velocity_b_kicked(0.0, amount, turning_arm(at_b, line), body[j, INVERSE_INERTIA])
    bend_line(j, now, time_step, by, turn, pose, motion)


def bend_line(
    i: int, now: float, time_step: float, by: Vector, turn: float, pose: Array, motion: Array
) -> None:
    """Change a velocity, and the line so that it goes on from where it is now.

    The line is kept as where it would have begun, and how far it goes in all.
    """
    motion[i, VX] += by[0]
    motion[i, VY] += by[1]
    motion[i, SPIN] += turn
    pose[i, X] -= now * (by[0] * time_step)
    pose[i, Y] -= now * (by[1] * time_step)
    pose[i, TURN] -= now * (turn * time_step)
    motion[i, DX] += by[0] * time_step
    motion[i, DY] += by[1] * time_step
    motion[i, DTURN] += turn * time_step


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
