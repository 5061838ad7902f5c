"""The soft step through blocks: warm start, solve, relax and restitution, lane by lane.

Each loop goes over a fixed number of lanes, over two arrays, without branches, so that compiled
code takes several lanes in one instruction. Cost: a visit to two bodies for each lane, and loop.
Source: Catto (2024), soft step.
"""

from typing import NamedTuple

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Bodies, Constraints, Integers
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
from tamias2d.kernels.assembled import inlined
from tamias2d.kernels.lanes import LANES, both_above, load_half, load_rows, store_half
from tamias2d.state import Array, Vector

FEW_LANES = 2  # lanes that hold a contact, for which those of a block cost more than one by one
OPEN = -1e-300  # m: a larger gap is one that closes, or has just closed
SETTLED_RESTITUTION = 2.0**-40  # of its impulses: a change that does not count


def load_velocities(lane: Integers, motion: Array, scratch: Array) -> None:
    """Load the velocities of the bodies of a block into the scratch array."""
    load_half(lane, tb.BODY_A, motion, scratch, tb.B_VX_A)
    load_half(lane, tb.BODY_B, motion, scratch, tb.B_VX_B)


def load_motions(lane: Integers, motion: Array, scratch: Array) -> None:
    """Load the velocities of the bodies of a block, and their displacements in the step."""
    load_rows(lane, tb.BODY_A, motion, scratch, tb.B_VX_A)
    load_rows(lane, tb.BODY_B, motion, scratch, tb.B_VX_B)


def store_velocities(lane: Integers, motion: Array, scratch: Array) -> None:
    """Store the velocities of the bodies of a block."""
    store_half(lane, tb.BODY_A, motion, scratch, tb.B_VX_A)
    store_half(lane, tb.BODY_B, motion, scratch, tb.B_VX_B)


class Velocities(NamedTuple):
    """Those of both bodies of a lane."""

    a: Vector  # m/s
    spin_a: float  # rad/s
    b: Vector
    spin_b: float


@inlined
def velocities_of(m: int, scratch: Array) -> Velocities:
    """Return the velocities of the bodies of a lane."""
    return Velocities(
        (scratch[tb.B_VX_A + m], scratch[tb.B_VY_A + m]),
        scratch[tb.B_SPIN_A + m],
        (scratch[tb.B_VX_B + m], scratch[tb.B_VY_B + m]),
        scratch[tb.B_SPIN_B + m],
    )


@inlined
def set_velocities(m: int, now: Velocities, scratch: Array) -> None:
    """Set the velocities of the bodies of a lane."""
    scratch[tb.B_VX_A + m], scratch[tb.B_VY_A + m] = now.a
    scratch[tb.B_SPIN_A + m] = now.spin_a
    scratch[tb.B_VX_B + m], scratch[tb.B_VY_B + m] = now.b
    scratch[tb.B_SPIN_B + m] = now.spin_b


@inlined
def pushed(
    m: int, amount: float, line: Vector, arm_a: float, arm_b: float, now: Velocities, row: Array
) -> Velocities:
    """Return velocities after an impulse, N s, along a line; turning arms in m."""
    return Velocities(
        velocity_a_after(now.a, amount, line, row[tb.R_MASS_A + m]),
        angular_velocity_a_after(now.spin_a, amount, arm_a, row[tb.R_INERTIA_A + m]),
        velocity_b_after(now.b, amount, line, row[tb.R_MASS_B + m]),
        angular_velocity_b_after(now.spin_b, amount, arm_b, row[tb.R_INERTIA_B + m]),
    )


@inlined
def pushed_apart(m: int, at: int, amount: float, now: Velocities, row: Array) -> Velocities:
    """Return velocities after an impulse, N s, along the normal of a point."""
    line = (row[tb.R_NX + m], row[tb.R_NY + m])
    arm_a, arm_b = row[at + tb.P_NORMAL_ARM_A + m], row[at + tb.P_NORMAL_ARM_B + m]
    return pushed(m, amount, line, arm_a, arm_b, now, row)


@inlined
def pushed_along(m: int, at: int, amount: float, now: Velocities, row: Array) -> Velocities:
    """Return velocities after an impulse, N s, along the tangent of a point."""
    line = (-row[tb.R_NY + m], row[tb.R_NX + m])
    arm_a, arm_b = row[at + tb.P_TANGENT_ARM_A + m], row[at + tb.P_TANGENT_ARM_B + m]
    return pushed(m, amount, line, arm_a, arm_b, now, row)


@inlined
def normal_speed(m: int, at: int, now: Velocities, row: Array) -> float:
    """Return the normal velocity of a point, m/s, at which its gap opens."""
    arm_a, arm_b = row[at + tb.P_NORMAL_ARM_A + m], row[at + tb.P_NORMAL_ARM_B + m]
    line = (row[tb.R_NX + m], row[tb.R_NY + m])
    return row_velocity(now.a, now.spin_a, arm_a, now.b, now.spin_b, arm_b, line)


@inlined
def friction_impulse(m: int, at: int, now: Velocities, row: Array) -> float:
    """Return the tangent impulse of a point, N s, within what friction allows."""
    arm_a, arm_b = row[at + tb.P_TANGENT_ARM_A + m], row[at + tb.P_TANGENT_ARM_B + m]
    line = (-row[tb.R_NY + m], row[tb.R_NX + m])
    return limited_tangent_impulse(
        row[at + tb.P_TANGENT_IMPULSE + m],
        row_velocity(now.a, now.spin_a, arm_a, now.b, now.spin_b, arm_b, line),
        row[at + tb.P_TANGENT_MASS + m],
        row[tb.R_FRICTION + m],
        row[at + tb.P_NORMAL_IMPULSE + m],
    )


@inlined
def after_friction(m: int, at: int, now: Velocities, row: Array) -> Velocities:
    """Correct the tangent impulse of a point; return the velocities after it."""
    before = row[at + tb.P_TANGENT_IMPULSE + m]
    after = friction_impulse(m, at, now, row)
    row[at + tb.P_TANGENT_IMPULSE + m] = after
    return pushed_along(m, at, after - before, now, row)


@inlined
def gap_in_substep(m: int, at: int, row: Array, scratch: Array) -> float:
    """Return the gap of a point, m, where bodies are in this substep."""
    return separation_later(
        row[at + tb.P_GAP + m],
        (scratch[tb.B_DX_A + m], scratch[tb.B_DY_A + m]),
        scratch[tb.B_ANGLE_A + m],
        row[at + tb.P_NORMAL_ARM_A + m],
        row[at + tb.P_TANGENT_ARM_A + m] - row[tb.R_RADIUS_A + m],
        (scratch[tb.B_DX_B + m], scratch[tb.B_DY_B + m]),
        scratch[tb.B_ANGLE_B + m],
        row[at + tb.P_NORMAL_ARM_B + m],
        row[at + tb.P_TANGENT_ARM_B + m] + row[tb.R_RADIUS_B + m],
        (row[tb.R_NX + m], row[tb.R_NY + m]),
    )


@inlined
def after_soft(
    m: int, at: int, now: Velocities, row: Array, scratch: Array, substep: float
) -> Velocities:
    """Correct the normal impulse of a soft constraint; the substep in s."""
    gap = gap_in_substep(m, at, row, scratch)
    row[at + tb.P_GAP_NOW + m] = gap
    bias = bias_velocity(gap, row[tb.R_BIAS_RATE + m], row[tb.R_BIAS_LEAST + m], substep)
    is_open = gap > 0.0
    mass_share = 1.0 if is_open else row[tb.R_MASS_SHARE + m]
    impulse_share = 0.0 if is_open else row[tb.R_IMPULSE_SHARE + m]
    before, speed = row[at + tb.P_NORMAL_IMPULSE + m], normal_speed(m, at, now, row)
    mass = row[at + tb.P_NORMAL_MASS + m]
    after = soft_normal_impulse(before, speed, bias, mass, mass_share, impulse_share)
    row[at + tb.P_NORMAL_IMPULSE + m] = after
    return pushed_apart(m, at, after - before, now, row)


@inlined
def after_relaxing(
    m: int, at: int, now: Velocities, row: Array, substep: float, share: float
) -> Velocities:
    """Correct the normal impulse so that a point approaches by no more than its gap.

    A share of it is counted: 1 where it is what a substep leaves, 0 elsewhere.
    """
    speed = normal_speed(m, at, now, row)
    bias = bias_velocity_later(row[at + tb.P_GAP_NOW + m], speed, substep)
    before = row[at + tb.P_NORMAL_IMPULSE + m]
    after = soft_normal_impulse(before, speed, bias, row[at + tb.P_NORMAL_MASS + m], 1.0, 0.0)
    row[at + tb.P_NORMAL_IMPULSE + m] = after
    row[at + tb.P_TOTAL_IMPULSE + m] = row[at + tb.P_TOTAL_IMPULSE + m] + share * after
    return pushed_apart(m, at, after - before, now, row)


@inlined
def warm_started(m: int, at: int, now: Velocities, row: Array) -> Velocities:
    """Return velocities after the impulses of the last substep at a point."""
    apart = pushed_apart(m, at, row[at + tb.P_NORMAL_IMPULSE + m], now, row)
    return pushed_along(m, at, row[at + tb.P_TANGENT_IMPULSE + m], apart, row)


@inlined
def soften(
    m: int, points: int, now: Velocities, row: Array, scratch: Array, substep: float
) -> Velocities:
    """Correct the impulses of a contact with one or two points; return velocities after it."""
    then = after_friction(m, tb.FIRST_POINT, now, row)
    if points == 2:
        then = after_friction(m, tb.SECOND_POINT, then, row)
    then = after_soft(m, tb.FIRST_POINT, then, row, scratch, substep)
    if points == 2:
        then = after_soft(m, tb.SECOND_POINT, then, row, scratch, substep)
    return then


@inlined
def relaxed(
    m: int, points: int, now: Velocities, row: Array, substep: float, share: float
) -> Velocities:
    """Relax a contact with one or two points; return velocities after it."""
    then = after_friction(m, tb.FIRST_POINT, now, row)
    if points == 2:
        then = after_friction(m, tb.SECOND_POINT, then, row)
    then = after_relaxing(m, tb.FIRST_POINT, then, row, substep, share)
    if points == 2:
        then = after_relaxing(m, tb.SECOND_POINT, then, row, substep, share)
    return then


@inlined
def after_restitution(
    m: int, at: int, bounce: int, now: Velocities, row: Array, scratch: Array, slowest: float
) -> Velocities:
    """Let a point rebound that met faster than `slowest`, m/s, and has an impulse.

    The impulses that it is given are added up in the column `bounce`.
    """
    before = row[at + tb.P_NORMAL_IMPULSE + m]
    meets = (
        (row[at + tb.P_APPROACH + m] < -slowest)
        & (row[at + tb.P_TOTAL_IMPULSE + m] > 0.0)
        & (row[tb.R_RESTITUTION + m] > 0.0)
    )
    bounced = restitution_impulse(
        before,
        normal_speed(m, at, now, row),
        row[at + tb.P_APPROACH + m],
        row[tb.R_RESTITUTION + m],
        row[at + tb.P_NORMAL_MASS + m],
    )
    after = bounced if meets else before
    row[at + tb.P_NORMAL_IMPULSE + m] = after
    row[bounce + m] += after - before
    least = SETTLED_RESTITUTION * abs(row[bounce + m])
    scratch[tb.B_UNSETTLED + m] = abs(after - before) - least
    row[at + tb.P_TOTAL_IMPULSE + m] = row[at + tb.P_TOTAL_IMPULSE + m] + (after - before)
    return pushed_apart(m, at, after - before, now, row)


@inlined
def after_closed_friction(
    m: int, at: int, closed: int, least: float, now: Velocities, row: Array
) -> Velocities:
    """Correct the tangent impulse of a point that has met or bounced in this substep."""
    before, limited = row[at + tb.P_TANGENT_IMPULSE + m], friction_impulse(m, at, now, row)
    met = (row[closed + m] > least) & (row[at + tb.P_NORMAL_IMPULSE + m] > 0.0)
    after = limited if met else before
    row[at + tb.P_TANGENT_IMPULSE + m] = after
    return pushed_along(m, at, after - before, now, row)


# -- all lanes of a block


def warm_start_lanes(at: int, row: Array, scratch: Array) -> None:
    """Apply the impulses of the last substep again."""
    for m in range(LANES):
        now = velocities_of(m, scratch)
        now = warm_started(m, at, now, row)
        set_velocities(m, now, scratch)


def soft_lanes(row: Array, scratch: Array, substep: float) -> None:
    """Correct the impulses of contacts with one point; the substep in s."""
    for m in range(LANES):
        now = velocities_of(m, scratch)
        now = soften(m, 1, now, row, scratch, substep)
        set_velocities(m, now, scratch)


def soft_lanes_of_two(row: Array, scratch: Array, substep: float) -> None:
    """Correct the impulses of contacts with two points; the substep in s."""
    for m in range(LANES):
        now = velocities_of(m, scratch)
        now = soften(m, 2, now, row, scratch, substep)
        set_velocities(m, now, scratch)


def relax_lanes(row: Array, scratch: Array, substep: float, share: float) -> None:
    """Relax contacts with one point; the substep in s."""
    for m in range(LANES):
        now = velocities_of(m, scratch)
        now = relaxed(m, 1, now, row, substep, share)
        set_velocities(m, now, scratch)


def relax_lanes_of_two(row: Array, scratch: Array, substep: float, share: float) -> None:
    """Relax contacts with two points; the substep in s."""
    for m in range(LANES):
        now = velocities_of(m, scratch)
        now = relaxed(m, 2, now, row, substep, share)
        set_velocities(m, now, scratch)


def restitution_lanes(at: int, bounce: int, row: Array, scratch: Array, slowest: float) -> None:
    """Apply restitution to the points of contacts."""
    for m in range(LANES):
        now = velocities_of(m, scratch)
        now = after_restitution(m, at, bounce, now, row, scratch, slowest)
        set_velocities(m, now, scratch)


def closed_friction_lanes(at: int, closed: int, least: float, row: Array, scratch: Array) -> None:
    """Correct the tangent impulses of points that have met or bounced in this substep."""
    for m in range(LANES):
        now = velocities_of(m, scratch)
        now = after_closed_friction(m, at, closed, least, now, row)
        set_velocities(m, now, scratch)


def apply_closed_friction(
    lane: Integers, first: int, second: int, least: float, row: Array, scratch: Array
) -> None:
    """Apply friction to points whose column, of gaps or bounces, is above the least, if any is."""
    two = lane[tb.POINTS] == 2
    if some_closed(tb.FIRST_POINT, first, least, row) or (
        two and some_closed(tb.SECOND_POINT, second, least, row)
    ):
        closed_friction_lanes(tb.FIRST_POINT, first, least, row, scratch)
        if two:
            closed_friction_lanes(tb.SECOND_POINT, second, least, row, scratch)


def some_closed(at: int, closed: int, least: float, row: Array) -> bool:
    """Return whether a lane with a normal impulse has a gap, or a bounce, above the least."""
    return both_above(row, closed, least, at + tb.P_NORMAL_IMPULSE, 0.0)


def some_above(row: Array, column: int) -> bool:
    """Return whether a lane has a positive number in a column."""
    return both_above(row, column, 0.0, column, 0.0)


# -- the few lanes of a block that hold contacts, one by one


@inlined
def load_pair(m: int, lane: Integers, motion: Array, scratch: Array) -> Velocities:
    """Load how far both bodies of a lane have gone in the step; return their velocities."""
    a, b = motion[lane[tb.BODY_A + m]], motion[lane[tb.BODY_B + m]]
    scratch[tb.B_DX_A + m], scratch[tb.B_DY_A + m] = a[tb.DX], a[tb.DY]
    scratch[tb.B_DX_B + m], scratch[tb.B_DY_B + m] = b[tb.DX], b[tb.DY]
    scratch[tb.B_ANGLE_A + m], scratch[tb.B_ANGLE_B + m] = a[tb.DANGLE], b[tb.DANGLE]
    return Velocities((a[tb.VX], a[tb.VY]), a[tb.SPIN], (b[tb.VX], b[tb.VY]), b[tb.SPIN])


@inlined
def store_pair(m: int, now: Velocities, lane: Integers, motion: Array) -> None:
    """Store the velocities of both bodies of a lane."""
    a, b = motion[lane[tb.BODY_A + m]], motion[lane[tb.BODY_B + m]]
    a[tb.VX], a[tb.VY] = now.a
    b[tb.VX], b[tb.VY] = now.b
    a[tb.SPIN], b[tb.SPIN] = now.spin_a, now.spin_b


def warm_start_few(lane: Integers, motion: Array, row: Array, scratch: Array) -> None:
    """Apply the impulses of the last substep to the few contacts of a block again."""
    for m in range(lane[tb.FILLED]):
        now = load_pair(m, lane, motion, scratch)
        now = warm_started(m, tb.FIRST_POINT, now, row)
        if lane[tb.POINTS] == 2:
            now = warm_started(m, tb.SECOND_POINT, now, row)
        store_pair(m, now, lane, motion)


def soften_few(lane: Integers, motion: Array, row: Array, scratch: Array, substep: float) -> None:
    """Correct the impulses of the few contacts of a block; the substep in s."""
    for m in range(lane[tb.FILLED]):
        now = load_pair(m, lane, motion, scratch)
        now = soften(m, lane[tb.POINTS], now, row, scratch, substep)
        store_pair(m, now, lane, motion)


def relax_few(
    lane: Integers, motion: Array, row: Array, scratch: Array, substep: float, share: float
) -> None:
    """Relax the few contacts of a block, and apply friction to what has met."""
    first, second = tb.FIRST_POINT + tb.P_GAP_NOW, tb.SECOND_POINT + tb.P_GAP_NOW
    for m in range(lane[tb.FILLED]):
        now = load_pair(m, lane, motion, scratch)
        now = relaxed(m, lane[tb.POINTS], now, row, substep, share)
        now = after_closed_friction(m, tb.FIRST_POINT, first, OPEN, now, row)
        if lane[tb.POINTS] == 2:
            now = after_closed_friction(m, tb.SECOND_POINT, second, OPEN, now, row)
        store_pair(m, now, lane, motion)


# -- all blocks


def warm_start(first: int, last: int, bodies: Bodies, constraints: Constraints) -> None:
    """Apply the impulses of the last substep to the bodies of some blocks."""
    motion, scratch = bodies.motion, constraints.scratch
    for b in range(first, last):
        row, lane = constraints.blocks[b], constraints.lanes[b]
        if lane[tb.FILLED] <= FEW_LANES:
            warm_start_few(lane, motion, row, scratch)
            continue
        load_velocities(lane, motion, scratch)
        warm_start_lanes(tb.FIRST_POINT, row, scratch)
        if lane[tb.POINTS] == 2:
            warm_start_lanes(tb.SECOND_POINT, row, scratch)
        store_velocities(lane, motion, scratch)


def solve_soft(
    first: int, last: int, bodies: Bodies, constraints: Constraints, substep: float
) -> None:
    """Solve soft constraints once: friction first, so that normal impulses have the last word."""
    motion, scratch = bodies.motion, constraints.scratch
    for b in range(first, last):
        row, lane = constraints.blocks[b], constraints.lanes[b]
        if lane[tb.FILLED] <= FEW_LANES:
            soften_few(lane, motion, row, scratch, substep)
            continue
        load_motions(lane, motion, scratch)
        if lane[tb.POINTS] == 2:
            soft_lanes_of_two(row, scratch, substep)
        else:
            soft_lanes(row, scratch, substep)
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
    motion, scratch, share = bodies.motion, constraints.scratch, 1.0 if counted else 0.0
    for b in range(first, last):
        row, lane = constraints.blocks[b], constraints.lanes[b]
        if lane[tb.FILLED] <= FEW_LANES:
            relax_few(lane, motion, row, scratch, substep, share)
            continue
        load_velocities(lane, motion, scratch)
        if lane[tb.POINTS] == 2:
            relax_lanes_of_two(row, scratch, substep, share)
        else:
            relax_lanes(row, scratch, substep, share)
        apply_closed_friction(
            lane, tb.FIRST_POINT + tb.P_GAP_NOW, tb.SECOND_POINT + tb.P_GAP_NOW, OPEN, row, scratch
        )
        store_velocities(lane, motion, scratch)


def clear_restitution(constraints: Constraints) -> None:
    """Let restitution have given no impulse yet."""
    for b in range(constraints.counts[tb.BLOCKS]):
        for m in range(LANES):
            constraints.blocks[b, tb.FIRST_RESTITUTION + m] = 0.0
            constraints.blocks[b, tb.SECOND_RESTITUTION + m] = 0.0


def apply_restitution(
    again: bool, bodies: Bodies, constraints: Constraints, slowest: float
) -> bool:
    """Apply restitution to the bodies of all blocks once; return whether impulses have settled.

    Again, it visits the blocks only to which it has given some.
    """
    motion, scratch = bodies.motion, constraints.scratch
    settled = True
    for b in range(constraints.counts[tb.BLOCKS]):
        row, lane = constraints.blocks[b], constraints.lanes[b]
        if again and not (
            some_above(row, tb.FIRST_RESTITUTION) or some_above(row, tb.SECOND_RESTITUTION)
        ):
            continue
        load_velocities(lane, motion, scratch)
        restitution_lanes(tb.FIRST_POINT, tb.FIRST_RESTITUTION, row, scratch, slowest)
        settled = settled and not some_above(scratch, tb.B_UNSETTLED)
        if lane[tb.POINTS] == 2:
            restitution_lanes(tb.SECOND_POINT, tb.SECOND_RESTITUTION, row, scratch, slowest)
            settled = settled and not some_above(scratch, tb.B_UNSETTLED)
        apply_closed_friction(lane, tb.FIRST_RESTITUTION, tb.SECOND_RESTITUTION, 0.0, row, scratch)
        store_velocities(lane, motion, scratch)
    return settled
