"""The soft step through all blocks: what contacts do to velocities, lane by lane.

Serves: a step. Hides: the order of what is loaded and stored, which decides whether compiled code
takes many lanes at once: loops over a fixed number of lanes, over two arrays, without branches.
"""

from tamias2d.engine.tables import (
    B_ANGLE_A,
    B_ANGLE_B,
    B_DX_A,
    B_DX_B,
    B_DY_A,
    B_DY_B,
    B_SPIN_A,
    B_SPIN_B,
    B_VX_A,
    B_VX_B,
    B_VY_A,
    B_VY_B,
    BODY_A,
    BODY_B,
    DANGLE,
    DX,
    DY,
    FIRST,
    FIRST_BOUNCE,
    LANES,
    P_APPROACH,
    P_ARM_A,
    P_ARM_B,
    P_GAP,
    P_GAP_NOW,
    P_MASS,
    P_NORMAL,
    P_SIDE_A,
    P_SIDE_B,
    P_SIDE_MASS,
    P_TANGENT,
    P_TOTAL,
    POINTS,
    R_BIAS,
    R_FRICTION,
    R_INERTIA_A,
    R_INERTIA_B,
    R_KEEP,
    R_LIMIT,
    R_MASS_A,
    R_MASS_B,
    R_NX,
    R_NY,
    R_RESTITUTION,
    R_ROUND_A,
    R_ROUND_B,
    R_SHARE,
    SECOND,
    SECOND_BOUNCE,
    SPIN,
    VX,
    VY,
    Bodies,
    Constraints,
    Integers,
)
from tamias2d.generated.soft_contact import (
    angular_velocity_a_kicked,
    angular_velocity_b_kicked,
    bias_velocity,
    bias_velocity_later,
    bouncing_push,
    limited_rub,
    row_velocity,
    separation_later,
    soft_push,
    velocity_a_kicked,
    velocity_b_kicked,
)
from tamias2d.state import Array, Vector

# the bench on which the motion of a block's bodies is worked on

OPEN = -1e-300  # m: a gap that is more is one that closes, or has just closed


def load_velocities(lane: Integers, motion: Array, scratch: Array) -> None:
    """Bring the velocities of a block's bodies to the bench."""
    for m in range(LANES):
        a, b = motion[lane[BODY_A + m]], motion[lane[BODY_B + m]]
        scratch[B_VX_A + m], scratch[B_VY_A + m], scratch[B_SPIN_A + m] = a[VX], a[VY], a[SPIN]
        scratch[B_VX_B + m], scratch[B_VY_B + m], scratch[B_SPIN_B + m] = b[VX], b[VY], b[SPIN]


def load_motions(lane: Integers, motion: Array, scratch: Array) -> None:
    """Bring the velocities of a block's bodies, and what they have moved since the step began."""
    for m in range(LANES):
        a, b = motion[lane[BODY_A + m]], motion[lane[BODY_B + m]]
        scratch[B_VX_A + m], scratch[B_VY_A + m], scratch[B_SPIN_A + m] = a[VX], a[VY], a[SPIN]
        scratch[B_DX_A + m], scratch[B_DY_A + m], scratch[B_ANGLE_A + m] = a[DX], a[DY], a[DANGLE]
        scratch[B_VX_B + m], scratch[B_VY_B + m], scratch[B_SPIN_B + m] = b[VX], b[VY], b[SPIN]
        scratch[B_DX_B + m], scratch[B_DY_B + m], scratch[B_ANGLE_B + m] = b[DX], b[DY], b[DANGLE]


def store_velocities(lane: Integers, motion: Array, scratch: Array) -> None:
    """Bring the velocities back from the bench."""
    for m in range(LANES):
        a, b = motion[lane[BODY_A + m]], motion[lane[BODY_B + m]]
        a[VX], a[VY], a[SPIN] = scratch[B_VX_A + m], scratch[B_VY_A + m], scratch[B_SPIN_A + m]
        b[VX], b[VY], b[SPIN] = scratch[B_VX_B + m], scratch[B_VY_B + m], scratch[B_SPIN_B + m]


def apply_impulse(
    m: int, amount: float, line: Vector, arm_a: float, arm_b: float, row: Array, scratch: Array
) -> None:
    """Let an impulse, N s, along a line act on the bodies of a lane; turning arms in m."""
    scratch[B_VX_A + m], scratch[B_VY_A + m] = velocity_a_kicked(
        (scratch[B_VX_A + m], scratch[B_VY_A + m]), amount, line, row[R_MASS_A + m]
    )
    scratch[B_SPIN_A + m] = angular_velocity_a_kicked(
        scratch[B_SPIN_A + m], amount, arm_a, row[R_INERTIA_A + m]
    )
    scratch[B_VX_B + m], scratch[B_VY_B + m] = velocity_b_kicked(
        (scratch[B_VX_B + m], scratch[B_VY_B + m]), amount, line, row[R_MASS_B + m]
    )
    scratch[B_SPIN_B + m] = angular_velocity_b_kicked(
        scratch[B_SPIN_B + m], amount, arm_b, row[R_INERTIA_B + m]
    )


def apply_normal(m: int, at: int, amount: float, row: Array, scratch: Array) -> None:
    """Let an impulse, N s, act along the normal of a lane."""
    line = (row[R_NX + m], row[R_NY + m])
    apply_impulse(m, amount, line, row[at + P_ARM_A + m], row[at + P_ARM_B + m], row, scratch)


def apply_tangent(m: int, at: int, amount: float, row: Array, scratch: Array) -> None:
    """Let an impulse, N s, act along the tangent of a lane."""
    line = (-row[R_NY + m], row[R_NX + m])
    apply_impulse(m, amount, line, row[at + P_SIDE_A + m], row[at + P_SIDE_B + m], row, scratch)


def normal_speed(m: int, at: int, row: Array, scratch: Array) -> float:
    """Return the rate at which the gap of a lane opens, m/s."""
    return row_velocity(
        (scratch[B_VX_A + m], scratch[B_VY_A + m]),
        scratch[B_SPIN_A + m],
        row[at + P_ARM_A + m],
        (scratch[B_VX_B + m], scratch[B_VY_B + m]),
        scratch[B_SPIN_B + m],
        row[at + P_ARM_B + m],
        (row[R_NX + m], row[R_NY + m]),
    )


def tangent_speed(m: int, at: int, row: Array, scratch: Array) -> float:
    """Return the velocity of a lane along its tangent, m/s."""
    return row_velocity(
        (scratch[B_VX_A + m], scratch[B_VY_A + m]),
        scratch[B_SPIN_A + m],
        row[at + P_SIDE_A + m],
        (scratch[B_VX_B + m], scratch[B_VY_B + m]),
        scratch[B_SPIN_B + m],
        row[at + P_SIDE_B + m],
        (-row[R_NY + m], row[R_NX + m]),
    )


def warm_start_lanes(at: int, row: Array, scratch: Array) -> None:
    """Apply again what was found before."""
    for m in range(LANES):
        apply_normal(m, at, row[at + P_NORMAL + m], row, scratch)
        apply_tangent(m, at, row[at + P_TANGENT + m], row, scratch)


def friction_lanes(at: int, row: Array, scratch: Array) -> None:
    """Correct the impulses along the tangents."""
    for m in range(LANES):
        speed = tangent_speed(m, at, row, scratch)
        before = row[at + P_TANGENT + m]
        after = limited_rub(
            before, speed, row[at + P_SIDE_MASS + m], row[R_FRICTION + m], row[at + P_NORMAL + m]
        )
        row[at + P_TANGENT + m] = after
        apply_tangent(m, at, after - before, row, scratch)


def soft_lanes(at: int, row: Array, scratch: Array, substep: float) -> None:
    """Correct the pushes along the normals, softly; the substep in s."""
    for m in range(LANES):
        gap = separation_later(
            row[at + P_GAP + m],
            (scratch[B_DX_A + m], scratch[B_DY_A + m]),
            scratch[B_ANGLE_A + m],
            row[at + P_ARM_A + m],
            row[at + P_SIDE_A + m] - row[R_ROUND_A + m],
            (scratch[B_DX_B + m], scratch[B_DY_B + m]),
            scratch[B_ANGLE_B + m],
            row[at + P_ARM_B + m],
            row[at + P_SIDE_B + m] + row[R_ROUND_B + m],
            (row[R_NX + m], row[R_NY + m]),
        )
        row[at + P_GAP_NOW + m] = gap
        bias = bias_velocity(gap, row[R_BIAS + m], row[R_LIMIT + m], substep)
        apart = gap > 0.0
        part = 1.0 if apart else row[R_SHARE + m]
        kept = 0.0 if apart else row[R_KEEP + m]
        before = row[at + P_NORMAL + m]
        after = soft_push(
            before, normal_speed(m, at, row, scratch), bias, row[at + P_MASS + m], part, kept
        )
        row[at + P_NORMAL + m] = after
        apply_normal(m, at, after - before, row, scratch)


def relax_lanes(at: int, row: Array, scratch: Array, substep: float) -> None:
    """Correct the pushes along the normals so that nothing approaches beyond its gap."""
    for m in range(LANES):
        speed = normal_speed(m, at, row, scratch)
        bias = bias_velocity_later(row[at + P_GAP_NOW + m], speed, substep)
        before = row[at + P_NORMAL + m]
        after = soft_push(before, speed, bias, row[at + P_MASS + m], 1.0, 0.0)
        row[at + P_NORMAL + m] = after
        row[at + P_TOTAL + m] = row[at + P_TOTAL + m] + after
        apply_normal(m, at, after - before, row, scratch)


def restitution_lanes(at: int, bounce: int, row: Array, scratch: Array, slowest: float) -> None:
    """Let points that met faster than `slowest`, m/s, and were pushed, part as restitution says."""
    for m in range(LANES):
        speed = normal_speed(m, at, row, scratch)
        before = row[at + P_NORMAL + m]
        meets = (
            (row[at + P_APPROACH + m] < -slowest)
            & (row[at + P_TOTAL + m] > 0.0)
            & (row[R_RESTITUTION + m] > 0.0)
        )
        bounced = bouncing_push(
            before, speed, row[at + P_APPROACH + m], row[R_RESTITUTION + m], row[at + P_MASS + m]
        )
        after = bounced if meets else before
        row[at + P_NORMAL + m] = after
        row[bounce + m] = after - before
        row[at + P_TOTAL + m] = row[at + P_TOTAL + m] + (after - before)
        apply_normal(m, at, after - before, row, scratch)


def some_closed(at: int, closed: int, least: float, row: Array) -> bool:
    """Return whether some lane is pushed whose gap, or bounce, is more than the least."""
    met = 0
    for m in range(LANES):
        met += 1 if (row[closed + m] > least) & (row[at + P_NORMAL + m] > 0.0) else 0
    return met > 0


def closed_friction_lanes(at: int, closed: int, least: float, row: Array, scratch: Array) -> None:
    """Let friction act on what has met or bounced, up to its share of all of the push."""
    for m in range(LANES):
        speed = tangent_speed(m, at, row, scratch)
        before = row[at + P_TANGENT + m]
        rubbed = limited_rub(
            before, speed, row[at + P_SIDE_MASS + m], row[R_FRICTION + m], row[at + P_NORMAL + m]
        )
        met = (row[closed + m] > least) & (row[at + P_NORMAL + m] > 0.0)
        after = rubbed if met else before
        row[at + P_TANGENT + m] = after
        apply_tangent(m, at, after - before, row, scratch)


def apply_closed_friction(
    lane: Integers, first: int, second: int, least: float, row: Array, scratch: Array
) -> None:
    """Let friction act where a point's column, of gaps or bounces, is above the least, if any is."""
    two = lane[POINTS] == 2
    if some_closed(FIRST, first, least, row) or (two and some_closed(SECOND, second, least, row)):
        closed_friction_lanes(FIRST, first, least, row, scratch)
        if two:
            closed_friction_lanes(SECOND, second, least, row, scratch)


def warm_start(first: int, last: int, bodies: Bodies, constraints: Constraints) -> None:
    """Apply the impulses of before."""
    for b in range(first, last):
        row, lane = constraints.blocks[b], constraints.lanes[b]
        load_velocities(lane, bodies.motion, constraints.scratch)
        warm_start_lanes(FIRST, row, constraints.scratch)
        if lane[POINTS] == 2:
            warm_start_lanes(SECOND, row, constraints.scratch)
        store_velocities(lane, bodies.motion, constraints.scratch)


def solve_soft(
    first: int, last: int, bodies: Bodies, constraints: Constraints, substep: float
) -> None:
    """Correct all impulses once, softly: friction first, so that pushes have the last word."""
    for b in range(first, last):
        row, lane = constraints.blocks[b], constraints.lanes[b]
        load_motions(lane, bodies.motion, constraints.scratch)
        friction_lanes(FIRST, row, constraints.scratch)
        if lane[POINTS] == 2:
            friction_lanes(SECOND, row, constraints.scratch)
        soft_lanes(FIRST, row, constraints.scratch, substep)
        if lane[POINTS] == 2:
            soft_lanes(SECOND, row, constraints.scratch, substep)
        store_velocities(lane, bodies.motion, constraints.scratch)


def relax(first: int, last: int, bodies: Bodies, constraints: Constraints, substep: float) -> None:
    """Correct all impulses once so that no softness is left in the velocities.

    What meets in this substep gets its push here, and so its friction after it.
    """
    for b in range(first, last):
        row, lane = constraints.blocks[b], constraints.lanes[b]
        load_velocities(lane, bodies.motion, constraints.scratch)
        friction_lanes(FIRST, row, constraints.scratch)
        if lane[POINTS] == 2:
            friction_lanes(SECOND, row, constraints.scratch)
        relax_lanes(FIRST, row, constraints.scratch, substep)
        if lane[POINTS] == 2:
            relax_lanes(SECOND, row, constraints.scratch, substep)
        apply_closed_friction(
            lane, FIRST + P_GAP_NOW, SECOND + P_GAP_NOW, OPEN, row, constraints.scratch
        )
        store_velocities(lane, bodies.motion, constraints.scratch)


def apply_restitution(
    first: int, last: int, bodies: Bodies, constraints: Constraints, slowest: float
) -> None:
    """Let what has met part."""
    for b in range(first, last):
        row, lane = constraints.blocks[b], constraints.lanes[b]
        load_velocities(lane, bodies.motion, constraints.scratch)
        restitution_lanes(FIRST, FIRST_BOUNCE, row, constraints.scratch, slowest)
        if lane[POINTS] == 2:
            restitution_lanes(SECOND, SECOND_BOUNCE, row, constraints.scratch, slowest)
        apply_closed_friction(lane, FIRST_BOUNCE, SECOND_BOUNCE, 0.0, row, constraints.scratch)
        store_velocities(lane, bodies.motion, constraints.scratch)
