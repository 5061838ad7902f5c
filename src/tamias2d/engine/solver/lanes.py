"""The soft step through blocks: warm start, solve, relax and restitution, lane by lane.

Each loop goes over a fixed number of lanes, over two arrays, without branches, so that compiled
code takes several lanes in one instruction. Cost: a visit to two bodies for each lane, and loop.
Source: Catto (2024), soft step.
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
    FIRST_POINT,
    FIRST_RESTITUTION,
    P_APPROACH,
    P_GAP,
    P_GAP_NOW,
    P_NORMAL_ARM_A,
    P_NORMAL_ARM_B,
    P_NORMAL_IMPULSE,
    P_NORMAL_MASS,
    P_TANGENT_ARM_A,
    P_TANGENT_ARM_B,
    P_TANGENT_IMPULSE,
    P_TANGENT_MASS,
    P_TOTAL_IMPULSE,
    POINTS,
    R_BIAS_LEAST,
    R_BIAS_RATE,
    R_FRICTION,
    R_IMPULSE_SHARE,
    R_INERTIA_A,
    R_INERTIA_B,
    R_MASS_A,
    R_MASS_B,
    R_MASS_SHARE,
    R_NX,
    R_NY,
    R_RADIUS_A,
    R_RADIUS_B,
    R_RESTITUTION,
    SECOND_POINT,
    SECOND_RESTITUTION,
    Bodies,
    Constraints,
    Integers,
)
from tamias2d.generated.soft_contact import (
    angular_velocity_a_after,
    angular_velocity_b_after,
    bias_velocity,
    bias_velocity_later,
    limited_tangent_impulse,
    restitution_impulse,
    row_velocity,
    separation_later,
    soft_normal_impulse,
    velocity_a_after,
    velocity_b_after,
)
from tamias2d.kernels.lanes import LANES, both_above, load_all, load_few, store_few
from tamias2d.state import Array, Vector

OPEN = -1e-300  # m: a larger gap is one that closes, or has just closed


def load_velocities(lane: Integers, motion: Array, scratch: Array) -> None:
    """Load the velocities of the bodies of a block into the scratch array."""
    load_few(lane, BODY_A, motion, scratch, B_VX_A)
    load_few(lane, BODY_B, motion, scratch, B_VX_B)


def load_motions(lane: Integers, motion: Array, scratch: Array) -> None:
    """Load the velocities of the bodies of a block, and their displacements in the step."""
    load_all(lane, BODY_A, motion, scratch, B_VX_A)
    load_all(lane, BODY_B, motion, scratch, B_VX_B)


def store_velocities(lane: Integers, motion: Array, scratch: Array) -> None:
    """Store the velocities of the bodies of a block."""
    store_few(lane, BODY_A, motion, scratch, B_VX_A)
    store_few(lane, BODY_B, motion, scratch, B_VX_B)


def apply_impulse(
    m: int, amount: float, line: Vector, arm_a: float, arm_b: float, row: Array, scratch: Array
) -> None:
    """Apply an impulse, N s, along a line to the bodies of a lane; turning arms in m."""
    scratch[B_VX_A + m], scratch[B_VY_A + m] = velocity_a_after(
        (scratch[B_VX_A + m], scratch[B_VY_A + m]), amount, line, row[R_MASS_A + m]
    )
    scratch[B_SPIN_A + m] = angular_velocity_a_after(
        scratch[B_SPIN_A + m], amount, arm_a, row[R_INERTIA_A + m]
    )
    scratch[B_VX_B + m], scratch[B_VY_B + m] = velocity_b_after(
        (scratch[B_VX_B + m], scratch[B_VY_B + m]), amount, line, row[R_MASS_B + m]
    )
    scratch[B_SPIN_B + m] = angular_velocity_b_after(
        scratch[B_SPIN_B + m], amount, arm_b, row[R_INERTIA_B + m]
    )


def apply_normal(m: int, at: int, amount: float, row: Array, scratch: Array) -> None:
    """Apply an impulse, N s, along the normal of a lane."""
    line = (row[R_NX + m], row[R_NY + m])
    apply_impulse(
        m, amount, line, row[at + P_NORMAL_ARM_A + m], row[at + P_NORMAL_ARM_B + m], row, scratch
    )


def apply_tangent(m: int, at: int, amount: float, row: Array, scratch: Array) -> None:
    """Apply an impulse, N s, along the tangent of a lane."""
    line = (-row[R_NY + m], row[R_NX + m])
    apply_impulse(
        m, amount, line, row[at + P_TANGENT_ARM_A + m], row[at + P_TANGENT_ARM_B + m], row, scratch
    )


def normal_speed(m: int, at: int, row: Array, scratch: Array) -> float:
    """Return the normal velocity of a lane, m/s, at which its gap opens."""
    return row_velocity(
        (scratch[B_VX_A + m], scratch[B_VY_A + m]),
        scratch[B_SPIN_A + m],
        row[at + P_NORMAL_ARM_A + m],
        (scratch[B_VX_B + m], scratch[B_VY_B + m]),
        scratch[B_SPIN_B + m],
        row[at + P_NORMAL_ARM_B + m],
        (row[R_NX + m], row[R_NY + m]),
    )


def tangent_speed(m: int, at: int, row: Array, scratch: Array) -> float:
    """Return the tangent velocity of a lane, m/s."""
    return row_velocity(
        (scratch[B_VX_A + m], scratch[B_VY_A + m]),
        scratch[B_SPIN_A + m],
        row[at + P_TANGENT_ARM_A + m],
        (scratch[B_VX_B + m], scratch[B_VY_B + m]),
        scratch[B_SPIN_B + m],
        row[at + P_TANGENT_ARM_B + m],
        (-row[R_NY + m], row[R_NX + m]),
    )


def warm_start_lanes(at: int, row: Array, scratch: Array) -> None:
    """Apply the impulses of the last substep again."""
    for m in range(LANES):
        apply_normal(m, at, row[at + P_NORMAL_IMPULSE + m], row, scratch)
        apply_tangent(m, at, row[at + P_TANGENT_IMPULSE + m], row, scratch)


def friction_lanes(at: int, row: Array, scratch: Array) -> None:
    """Correct the tangent impulses, within what friction allows."""
    for m in range(LANES):
        speed = tangent_speed(m, at, row, scratch)
        before = row[at + P_TANGENT_IMPULSE + m]
        after = limited_tangent_impulse(
            before,
            speed,
            row[at + P_TANGENT_MASS + m],
            row[R_FRICTION + m],
            row[at + P_NORMAL_IMPULSE + m],
        )
        row[at + P_TANGENT_IMPULSE + m] = after
        apply_tangent(m, at, after - before, row, scratch)


def soft_lanes(at: int, row: Array, scratch: Array, substep: float) -> None:
    """Correct the normal impulses of soft constraints; the substep in s."""
    for m in range(LANES):
        gap = separation_later(
            row[at + P_GAP + m],
            (scratch[B_DX_A + m], scratch[B_DY_A + m]),
            scratch[B_ANGLE_A + m],
            row[at + P_NORMAL_ARM_A + m],
            row[at + P_TANGENT_ARM_A + m] - row[R_RADIUS_A + m],
            (scratch[B_DX_B + m], scratch[B_DY_B + m]),
            scratch[B_ANGLE_B + m],
            row[at + P_NORMAL_ARM_B + m],
            row[at + P_TANGENT_ARM_B + m] + row[R_RADIUS_B + m],
            (row[R_NX + m], row[R_NY + m]),
        )
        row[at + P_GAP_NOW + m] = gap
        bias = bias_velocity(gap, row[R_BIAS_RATE + m], row[R_BIAS_LEAST + m], substep)
        is_open = gap > 0.0
        mass_share = 1.0 if is_open else row[R_MASS_SHARE + m]
        impulse_share = 0.0 if is_open else row[R_IMPULSE_SHARE + m]
        before = row[at + P_NORMAL_IMPULSE + m]
        after = soft_normal_impulse(
            before,
            normal_speed(m, at, row, scratch),
            bias,
            row[at + P_NORMAL_MASS + m],
            mass_share,
            impulse_share,
        )
        row[at + P_NORMAL_IMPULSE + m] = after
        apply_normal(m, at, after - before, row, scratch)


def relax_lanes(at: int, row: Array, scratch: Array, substep: float, counted: bool) -> None:
    """Correct the normal impulses so that no point approaches by more than its gap.

    Where they are those that a substep leaves, they are counted.
    """
    share = 1.0 if counted else 0.0
    for m in range(LANES):
        speed = normal_speed(m, at, row, scratch)
        bias = bias_velocity_later(row[at + P_GAP_NOW + m], speed, substep)
        before = row[at + P_NORMAL_IMPULSE + m]
        after = soft_normal_impulse(before, speed, bias, row[at + P_NORMAL_MASS + m], 1.0, 0.0)
        row[at + P_NORMAL_IMPULSE + m] = after
        row[at + P_TOTAL_IMPULSE + m] = row[at + P_TOTAL_IMPULSE + m] + share * after
        apply_normal(m, at, after - before, row, scratch)


def restitution_lanes(at: int, bounce: int, row: Array, scratch: Array, slowest: float) -> None:
    """Apply restitution to points that met faster than `slowest`, m/s, and have an impulse."""
    for m in range(LANES):
        speed = normal_speed(m, at, row, scratch)
        before = row[at + P_NORMAL_IMPULSE + m]
        meets = (
            (row[at + P_APPROACH + m] < -slowest)
            & (row[at + P_TOTAL_IMPULSE + m] > 0.0)
            & (row[R_RESTITUTION + m] > 0.0)
        )
        bounced = restitution_impulse(
            before,
            speed,
            row[at + P_APPROACH + m],
            row[R_RESTITUTION + m],
            row[at + P_NORMAL_MASS + m],
        )
        after = bounced if meets else before
        row[at + P_NORMAL_IMPULSE + m] = after
        row[bounce + m] = after - before
        row[at + P_TOTAL_IMPULSE + m] = row[at + P_TOTAL_IMPULSE + m] + (after - before)
        apply_normal(m, at, after - before, row, scratch)


def some_closed(at: int, closed: int, least: float, row: Array) -> bool:
    """Return whether a lane with a normal impulse has a gap, or a bounce, above the least."""
    return both_above(row, closed, least, at + P_NORMAL_IMPULSE, 0.0)


def closed_friction_lanes(at: int, closed: int, least: float, row: Array, scratch: Array) -> None:
    """Correct the tangent impulses of points that have met or bounced in this substep."""
    for m in range(LANES):
        speed = tangent_speed(m, at, row, scratch)
        before = row[at + P_TANGENT_IMPULSE + m]
        limited = limited_tangent_impulse(
            before,
            speed,
            row[at + P_TANGENT_MASS + m],
            row[R_FRICTION + m],
            row[at + P_NORMAL_IMPULSE + m],
        )
        met = (row[closed + m] > least) & (row[at + P_NORMAL_IMPULSE + m] > 0.0)
        after = limited if met else before
        row[at + P_TANGENT_IMPULSE + m] = after
        apply_tangent(m, at, after - before, row, scratch)


def apply_closed_friction(
    lane: Integers, first: int, second: int, least: float, row: Array, scratch: Array
) -> None:
    """Apply friction to points whose column, of gaps or bounces, is above the least, if any is."""
    two = lane[POINTS] == 2
    if some_closed(FIRST_POINT, first, least, row) or (
        two and some_closed(SECOND_POINT, second, least, row)
    ):
        closed_friction_lanes(FIRST_POINT, first, least, row, scratch)
        if two:
            closed_friction_lanes(SECOND_POINT, second, least, row, scratch)


def warm_start(first: int, last: int, bodies: Bodies, constraints: Constraints) -> None:
    """Apply the impulses of the last substep to the bodies of some blocks."""
    motion, scratch = bodies.motion, constraints.scratch
    for b in range(first, last):
        row, lane = constraints.blocks[b], constraints.lanes[b]
        load_velocities(lane, motion, scratch)
        warm_start_lanes(FIRST_POINT, row, scratch)
        if lane[POINTS] == 2:
            warm_start_lanes(SECOND_POINT, row, scratch)
        store_velocities(lane, motion, scratch)


def solve_soft(
    first: int, last: int, bodies: Bodies, constraints: Constraints, substep: float
) -> None:
    """Solve soft constraints once: friction first, so that normal impulses have the last word."""
    motion, scratch = bodies.motion, constraints.scratch
    for b in range(first, last):
        row, lane = constraints.blocks[b], constraints.lanes[b]
        load_motions(lane, motion, scratch)
        friction_lanes(FIRST_POINT, row, scratch)
        if lane[POINTS] == 2:
            friction_lanes(SECOND_POINT, row, scratch)
        soft_lanes(FIRST_POINT, row, scratch, substep)
        if lane[POINTS] == 2:
            soft_lanes(SECOND_POINT, row, scratch, substep)
        store_velocities(lane, motion, scratch)


def relax(
    first: int,
    last: int,
    bodies: Bodies,
    constraints: Constraints,
    substep: float,
    counted: bool,
) -> None:
    """Relax constraints once, so that no softness is left in the velocities.

    Points that meet in this substep get their normal impulse here, and their friction after it. The
    impulses of the last time in a substep are counted.
    """
    motion, scratch = bodies.motion, constraints.scratch
    for b in range(first, last):
        row, lane = constraints.blocks[b], constraints.lanes[b]
        load_velocities(lane, motion, scratch)
        friction_lanes(FIRST_POINT, row, scratch)
        if lane[POINTS] == 2:
            friction_lanes(SECOND_POINT, row, scratch)
        relax_lanes(FIRST_POINT, row, scratch, substep, counted)
        if lane[POINTS] == 2:
            relax_lanes(SECOND_POINT, row, scratch, substep, counted)
        apply_closed_friction(
            lane, FIRST_POINT + P_GAP_NOW, SECOND_POINT + P_GAP_NOW, OPEN, row, scratch
        )
        store_velocities(lane, motion, scratch)


def apply_restitution(
    first: int, last: int, bodies: Bodies, constraints: Constraints, slowest: float
) -> None:
    """Apply restitution to the bodies of some blocks."""
    motion, scratch = bodies.motion, constraints.scratch
    for b in range(first, last):
        row, lane = constraints.blocks[b], constraints.lanes[b]
        load_velocities(lane, motion, scratch)
        restitution_lanes(FIRST_POINT, FIRST_RESTITUTION, row, scratch, slowest)
        if lane[POINTS] == 2:
            restitution_lanes(SECOND_POINT, SECOND_RESTITUTION, row, scratch, slowest)
        apply_closed_friction(lane, FIRST_RESTITUTION, SECOND_RESTITUTION, 0.0, row, scratch)
        store_velocities(lane, motion, scratch)
