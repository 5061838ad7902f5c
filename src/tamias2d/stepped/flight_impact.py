"""One impact in flight: two bodies part, or stay together.

Serves: flight. Hides: how velocities of the step's end are seen from an instant within it.
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
from tamias2d.stepped.flight_work import energy_seen, give_back, support_of, work_ahead
from tamias2d.stepped.layout import (
    COUNT,
    DTURN,
    DX,
    DY,
    DYNAMIC,
    FLOWN_NORMAL,
    GAP,
    INVERSE_INERTIA,
    INVERSE_MASS,
    NX,
    NY,
    POINT,
    PX,
    PY,
    SPIN,
    TIME_STEP,
    TOTAL,
    TOUCHED,
    VX,
    VY,
    WHERE,
    Whole,
    X,
    Y,
)
from tamias2d.stepped.sweep import NEAR, WIDE
from tamias2d.stepped.trajectory import bend

# columns of what bodies gained that are free: 1 where a line is bent; 1 where a body has contacts,
# so that its velocity at the end says little of that on its way; as flight begins, how far it goes,
# and by how much farther than it is thick, m
BENT, LEANT, WAY, BEYOND = 0, 1, 6, 7


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


def rebound(
    i: int,
    j: int,
    now: float,
    friction: float,
    restitution: float,
    settings: Array,
    pose: Array,
    motion: Array,
    load: Array,
    body: Array,
    gained: Array,
    kind: Whole,
    row: Array,
) -> float:
    """Let the impact of two bodies happen, as `part` does, so that it makes no energy.

    Impacts take none of the way that both go in all, as masses count. But a body whose way leads
    into something that nothing moves loses a part of it.
    """
    time_step, left = settings[TIME_STEP], 1.0 - now
    if kind[i] == kind[j]:
        return part(i, j, now, time_step, friction, restitution, pose, motion, body, gained, row)
    k, wall = (i, j) if kind[i] == DYNAMIC else (j, i)
    support, spin = support_of(k, wall, now, pose, motion), motion[wall, SPIN]
    before = energy_seen(k, support, spin, motion, body)
    before -= work_ahead(k, left, settings, motion, load, body)
    push = part(i, j, now, time_step, friction, restitution, pose, motion, body, gained, row)
    after = energy_seen(k, support, spin, motion, body)
    after -= work_ahead(k, left, settings, motion, load, body)
    give_back(k, after - before, support, spin, motion, body)
    return push


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
    leant = gained[i, LEANT] + gained[j, LEANT] > 0.0
    left = 0.0 if leant else 1.0 - now
    before = speed_along(i, j, left, at_a, at_b, line, motion, gained)
    rate = rate_along(i, j, time_step, at_a, at_b, line, motion)
    if before >= 0.0 and rate >= 0.0:
        return -1.0
    back = bouncing_push(0.0, 0.0, min(max(before, rate), 0.0), restitution, mass)
    if leant:
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
        speed = speed_along(i, j, left, at_a, at_b, line, motion, gained)
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
