"""One impact in flight: two bodies part, or stay together.

Serves: flight. Hides: how velocities of the step's end are seen from an instant within it.
"""

from tamias2d.engine.continuous.conservative_advancement import NEAR, WIDE
from tamias2d.engine.continuous.trajectory import offset_at, redirect_both
from tamias2d.engine.continuous.work import (
    energy_seen,
    support_velocity,
    take_energy_back,
    work_ahead,
)
from tamias2d.engine.tables import (
    DANGLE,
    DX,
    DY,
    DYNAMIC,
    FORCE_GAIN,
    GAP,
    IMPACT_NORMAL,
    INVERSE_INERTIA,
    INVERSE_MASS,
    NX,
    NY,
    POINT,
    POINT_COUNT,
    PX,
    PY,
    SPIN,
    SUPPORTED,
    TIME_STEP,
    TOTAL_IMPULSE,
    TOUCHES,
    VX,
    VY,
    WORLD_POINT,
    Bodies,
    Control,
    Integers,
    X,
    Y,
)
from tamias2d.generated.continuous_collision import position_later
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


def seen_from_b(i: int, j: int, now: float, at_a: Vector, pose: Array, motion: Array) -> Vector:
    """Return from the centre of B what is known from that of A, at a fraction of the step."""
    x, y = offset_at(i, j, now, pose, motion)
    return at_a[0] - x, at_a[1] - y


def contact_point(row: Array) -> tuple[float, float]:
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
    control: Control,
    bodies: Bodies,
    row: Array,
) -> float:
    """Let the impact of two bodies happen, as `part` does, so that it makes no energy.

    Impacts take none of the way that both go in all, as masses count. But a body whose way leads
    into something that nothing moves loses a part of it.
    """
    time_step, left = control.settings[TIME_STEP], 1.0 - now
    if bodies.kind[i] == bodies.kind[j]:
        return apply_impact(i, j, now, time_step, friction, restitution, bodies, row)
    k, wall = (i, j) if bodies.kind[i] == DYNAMIC else (j, i)
    support, spin = (
        support_velocity(k, wall, now, bodies.pose, bodies.motion),
        bodies.motion[wall, SPIN],
    )
    before = energy_seen(k, support, spin, bodies.motion, bodies.properties)
    before -= work_ahead(k, left, control, bodies)
    push = apply_impact(i, j, now, time_step, friction, restitution, bodies, row)
    after = energy_seen(k, support, spin, bodies.motion, bodies.properties)
    after -= work_ahead(k, left, control, bodies)
    take_energy_back(k, after - before, support, spin, bodies.motion, bodies.properties)
    return push


def apply_impact(
    i: int,
    j: int,
    now: float,
    time_step: float,
    friction: float,
    restitution: float,
    bodies: Bodies,
    row: Array,
) -> float:
    """Let the impact of two bodies happen, by one row along the normal and one along the tangent.

    Where forces press them together again in the rest of the step, they stay together. Returns the
    impulse along the normal, N s; a negative number where nothing happens.
    """
    at_a = contact_point(row)
    at_b = seen_from_b(i, j, now, at_a, bodies.pose, bodies.motion)
    line = (row[NX], row[NY])
    mass = mass_along(i, j, at_a, at_b, line, bodies.properties)
    leant = bodies.flight[i, SUPPORTED] + bodies.flight[j, SUPPORTED] > 0.0
    left = 0.0 if leant else 1.0 - now
    before = speed_along(i, j, left, at_a, at_b, line, bodies.motion, bodies.flight)
    rate = path_speed_along(i, j, time_step, at_a, at_b, line, bodies.motion)
    if before >= 0.0 and rate >= 0.0:
        return -1.0
    back = bouncing_push(0.0, 0.0, min(max(before, rate), 0.0), restitution, mass)
    if leant:
        push = max(-mass * before, 0.0) + back
        apply_impulse_to_both(i, j, push, at_a, at_b, line, bodies.motion, bodies.properties)
        way = (max(-mass * rate, 0.0) + back) * time_step
        redirect_both(i, j, now, way, at_a, at_b, line, bodies)
    else:
        push = bouncing_push(0.0, before, before, restitution, mass) if before < 0.0 else 0.0
        strike(i, j, now, time_step, push, at_a, at_b, line, bodies)
    rate = path_speed_along(i, j, time_step, at_a, at_b, line, bodies.motion)
    if rate < 0.0:
        redirect_both(i, j, now, -mass * rate * time_step, at_a, at_b, line, bodies)
        after = speed_along(i, j, 0.0, at_a, at_b, line, bodies.motion, bodies.flight)
        held = max(-mass * after, 0.0)
        apply_impulse_to_both(i, j, held, at_a, at_b, line, bodies.motion, bodies.properties)
        push += held
    if friction > 0.0:
        line = (-row[NY], row[NX])
        speed = speed_along(i, j, left, at_a, at_b, line, bodies.motion, bodies.flight)
        mass = mass_along(i, j, at_a, at_b, line, bodies.properties)
        rub = limited_rub(0.0, speed, mass, friction, push)
        strike(i, j, now, time_step, rub, at_a, at_b, line, bodies)
    return push


def record_impact(
    push: float,
    i: int,
    now: float,
    sense: float,
    pose: Array,
    motion: Array,
    row: Array,
    manifolds: Array,
    flags: Integers,
) -> None:
    """Note an impact for what is told of the step: those of a pair add up, at the first place."""
    if flags[TOUCHES] & 1:
        manifolds[TOTAL_IMPULSE] += push
        return
    flags[TOUCHES] |= 1
    manifolds[TOTAL_IMPULSE] = push
    if flags[POINT_COUNT] == 0:
        at_x, at_y = position_later((pose[i, X], pose[i, Y]), (motion[i, DX], motion[i, DY]), now)
        x, y = contact_point(row)
        manifolds[WORLD_POINT], manifolds[WORLD_POINT + 1] = at_x + x, at_y + y
        manifolds[IMPACT_NORMAL], manifolds[IMPACT_NORMAL + 1] = sense * row[NX], sense * row[NY]


def speed_along(
    i: int,
    j: int,
    left: float,
    at_a: Vector,
    at_b: Vector,
    line: Vector,
    motion: Array,
    flight: Array,
) -> float:
    """Return the velocity of B's point against A's along a line, m/s.

    `left` is the share of the step for which forces have not acted yet.
    """
    return row_velocity(
        (
            motion[i, VX] - left * flight[i, FORCE_GAIN],
            motion[i, VY] - left * flight[i, FORCE_GAIN + 1],
        ),
        motion[i, SPIN] - left * flight[i, FORCE_GAIN + 2],
        turning_arm(at_a, line),
        (
            motion[j, VX] - left * flight[j, FORCE_GAIN],
            motion[j, VY] - left * flight[j, FORCE_GAIN + 1],
        ),
        motion[j, SPIN] - left * flight[j, FORCE_GAIN + 2],
        turning_arm(at_b, line),
        line,
    )


def path_speed_along(
    i: int, j: int, time_step: float, at_a: Vector, at_b: Vector, line: Vector, motion: Array
) -> float:
    """Return the same along the lines on which bodies go, m/s."""
    return (
        row_velocity(
            (motion[i, DX], motion[i, DY]),
            motion[i, DANGLE],
            turning_arm(at_a, line),
            (motion[j, DX], motion[j, DY]),
            motion[j, DANGLE],
            turning_arm(at_b, line),
            line,
        )
        / time_step
    )


def mass_along(
    i: int, j: int, at_a: Vector, at_b: Vector, line: Vector, properties: Array
) -> float:
    """Return the mass that an impulse along a line meets, kg."""
    return row_mass(
        properties[i, INVERSE_MASS],
        properties[i, INVERSE_INERTIA],
        turning_arm(at_a, line),
        properties[j, INVERSE_MASS],
        properties[j, INVERSE_INERTIA],
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
    bodies: Bodies,
) -> None:
    """Let an impulse act on both bodies, on their velocities and on their lines from now on."""
    apply_impulse_to_both(i, j, amount, at_a, at_b, line, bodies.motion, bodies.properties)
    redirect_both(i, j, now, amount * time_step, at_a, at_b, line, bodies)


def apply_impulse_to_both(
    i: int,
    j: int,
    amount: float,
    at_a: Vector,
    at_b: Vector,
    line: Vector,
    motion: Array,
    properties: Array,
) -> None:
    """Let an impulse change the velocities of both bodies."""
    motion[i, VX], motion[i, VY] = velocity_a_kicked(
        (motion[i, VX], motion[i, VY]), amount, line, properties[i, INVERSE_MASS]
    )
    motion[i, SPIN] = angular_velocity_a_kicked(
        motion[i, SPIN], amount, turning_arm(at_a, line), properties[i, INVERSE_INERTIA]
    )
    motion[j, VX], motion[j, VY] = velocity_b_kicked(
        (motion[j, VX], motion[j, VY]), amount, line, properties[j, INVERSE_MASS]
    )
    motion[j, SPIN] = angular_velocity_b_kicked(
        motion[j, SPIN], amount, turning_arm(at_b, line), properties[j, INVERSE_INERTIA]
    )
