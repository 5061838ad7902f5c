"""The soft step through all blocks: what contacts do to velocities, lane by lane.

Serves: a step. Hides: the order of what is loaded and stored, which decides whether compiled code
takes many lanes at once: loops over a fixed number of lanes, over two arrays, without branches.
"""

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
from tamias2d.stepped.layout import DTURN, DX, DY, SPIN, VX, VY, Whole
from tamias2d.stepped.rows import (
    BODY_A,
    BODY_B,
    FIRST,
    LANES,
    P_ARM_A,
    P_ARM_B,
    P_BEFORE,
    P_GAP,
    P_MASS,
    P_NOW,
    P_PUSH,
    P_RUB,
    P_SIDE_A,
    P_SIDE_B,
    P_SIDE_MASS,
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
)

# the bench on which the motion of a block's bodies is worked on
B_VX_A, B_VY_A, B_SPIN_A, B_VX_B, B_VY_B, B_SPIN_B = 0, 16, 32, 48, 64, 80
B_DX_A, B_DY_A, B_TURN_A, B_DX_B, B_DY_B, B_TURN_B = 96, 112, 128, 144, 160, 176
ALL_FIRST, ALL_NOW, ALL_GIVEN = 192, 193, 194  # sums of energy of all bodies with contacts, J
FETCHED = 195  # of no use: what is read ahead would not be read if it went nowhere
BENCH = 196

OPEN = -1e-300  # m: a gap that is more is one that closes, or has just closed


def load(lane: Whole, motion: Array, bench: Array) -> None:
    """Bring the velocities of a block's bodies to the bench."""
    for m in range(LANES):
        a, b = motion[lane[BODY_A + m]], motion[lane[BODY_B + m]]
        bench[B_VX_A + m], bench[B_VY_A + m], bench[B_SPIN_A + m] = a[VX], a[VY], a[SPIN]
        bench[B_VX_B + m], bench[B_VY_B + m], bench[B_SPIN_B + m] = b[VX], b[VY], b[SPIN]


def load_all(lane: Whole, motion: Array, bench: Array) -> None:
    """Bring the velocities of a block's bodies, and what they have moved since the step began."""
    for m in range(LANES):
        a, b = motion[lane[BODY_A + m]], motion[lane[BODY_B + m]]
        bench[B_VX_A + m], bench[B_VY_A + m], bench[B_SPIN_A + m] = a[VX], a[VY], a[SPIN]
        bench[B_DX_A + m], bench[B_DY_A + m], bench[B_TURN_A + m] = a[DX], a[DY], a[DTURN]
        bench[B_VX_B + m], bench[B_VY_B + m], bench[B_SPIN_B + m] = b[VX], b[VY], b[SPIN]
        bench[B_DX_B + m], bench[B_DY_B + m], bench[B_TURN_B + m] = b[DX], b[DY], b[DTURN]


def store(lane: Whole, motion: Array, bench: Array) -> None:
    """Bring the velocities back from the bench."""
    for m in range(LANES):
        a, b = motion[lane[BODY_A + m]], motion[lane[BODY_B + m]]
        a[VX], a[VY], a[SPIN] = bench[B_VX_A + m], bench[B_VY_A + m], bench[B_SPIN_A + m]
        b[VX], b[VY], b[SPIN] = bench[B_VX_B + m], bench[B_VY_B + m], bench[B_SPIN_B + m]


def kick(
    m: int, amount: float, line: Vector, arm_a: float, arm_b: float, row: Array, bench: Array
) -> None:
    """Let an impulse, N s, along a line act on the bodies of a lane; turning arms in m."""
    bench[B_VX_A + m], bench[B_VY_A + m] = velocity_a_kicked(
        (bench[B_VX_A + m], bench[B_VY_A + m]), amount, line, row[R_MASS_A + m]
    )
    bench[B_SPIN_A + m] = angular_velocity_a_kicked(
        bench[B_SPIN_A + m], amount, arm_a, row[R_INERTIA_A + m]
    )
    bench[B_VX_B + m], bench[B_VY_B + m] = velocity_b_kicked(
        (bench[B_VX_B + m], bench[B_VY_B + m]), amount, line, row[R_MASS_B + m]
    )
    bench[B_SPIN_B + m] = angular_velocity_b_kicked(
        bench[B_SPIN_B + m], amount, arm_b, row[R_INERTIA_B + m]
    )


def push(m: int, at: int, amount: float, row: Array, bench: Array) -> None:
    """Let an impulse, N s, act along the normal of a lane."""
    line = (row[R_NX + m], row[R_NY + m])
    kick(m, amount, line, row[at + P_ARM_A + m], row[at + P_ARM_B + m], row, bench)


def rub(m: int, at: int, amount: float, row: Array, bench: Array) -> None:
    """Let an impulse, N s, act along the tangent of a lane."""
    line = (-row[R_NY + m], row[R_NX + m])
    kick(m, amount, line, row[at + P_SIDE_A + m], row[at + P_SIDE_B + m], row, bench)


def approach(m: int, at: int, row: Array, bench: Array) -> float:
    """Return the rate at which the gap of a lane opens, m/s."""
    return row_velocity(
        (bench[B_VX_A + m], bench[B_VY_A + m]),
        bench[B_SPIN_A + m],
        row[at + P_ARM_A + m],
        (bench[B_VX_B + m], bench[B_VY_B + m]),
        bench[B_SPIN_B + m],
        row[at + P_ARM_B + m],
        (row[R_NX + m], row[R_NY + m]),
    )


def slip(m: int, at: int, row: Array, bench: Array) -> float:
    """Return the velocity of a lane along its tangent, m/s."""
    return row_velocity(
        (bench[B_VX_A + m], bench[B_VY_A + m]),
        bench[B_SPIN_A + m],
        row[at + P_SIDE_A + m],
        (bench[B_VX_B + m], bench[B_VY_B + m]),
        bench[B_SPIN_B + m],
        row[at + P_SIDE_B + m],
        (-row[R_NY + m], row[R_NX + m]),
    )


def warm_lanes(at: int, row: Array, bench: Array) -> None:
    """Apply again what was found before."""
    for m in range(LANES):
        push(m, at, row[at + P_PUSH + m], row, bench)
        rub(m, at, row[at + P_RUB + m], row, bench)


def rub_lanes(at: int, row: Array, bench: Array) -> None:
    """Correct the impulses along the tangents."""
    for m in range(LANES):
        speed = slip(m, at, row, bench)
        before = row[at + P_RUB + m]
        after = limited_rub(
            before, speed, row[at + P_SIDE_MASS + m], row[R_FRICTION + m], row[at + P_PUSH + m]
        )
        row[at + P_RUB + m] = after
        rub(m, at, after - before, row, bench)


def push_lanes(at: int, row: Array, bench: Array, substep: float) -> None:
    """Correct the pushes along the normals, softly; the substep in s."""
    for m in range(LANES):
        gap = separation_later(
            row[at + P_GAP + m],
            (bench[B_DX_A + m], bench[B_DY_A + m]),
            bench[B_TURN_A + m],
            row[at + P_ARM_A + m],
            row[at + P_SIDE_A + m] - row[R_ROUND_A + m],
            (bench[B_DX_B + m], bench[B_DY_B + m]),
            bench[B_TURN_B + m],
            row[at + P_ARM_B + m],
            row[at + P_SIDE_B + m] + row[R_ROUND_B + m],
            (row[R_NX + m], row[R_NY + m]),
        )
        row[at + P_NOW + m] = gap
        bias = bias_velocity(gap, row[R_BIAS + m], row[R_LIMIT + m], substep)
        apart = gap > 0.0
        part = 1.0 if apart else row[R_SHARE + m]
        kept = 0.0 if apart else row[R_KEEP + m]
        before = row[at + P_PUSH + m]
        after = soft_push(
            before, approach(m, at, row, bench), bias, row[at + P_MASS + m], part, kept
        )
        row[at + P_PUSH + m] = after
        push(m, at, after - before, row, bench)


def relax_lanes(at: int, row: Array, bench: Array, substep: float) -> None:
    """Correct the pushes along the normals so that nothing approaches beyond its gap."""
    for m in range(LANES):
        speed = approach(m, at, row, bench)
        bias = bias_velocity_later(row[at + P_NOW + m], speed, substep)
        before = row[at + P_PUSH + m]
        after = soft_push(before, speed, bias, row[at + P_MASS + m], 1.0, 0.0)
        row[at + P_PUSH + m] = after
        row[at + P_TOTAL + m] = row[at + P_TOTAL + m] + after
        push(m, at, after - before, row, bench)


def bounce_lanes(at: int, row: Array, bench: Array, slowest: float) -> None:
    """Let points that met faster than `slowest`, m/s, and were pushed, part as restitution says."""
    for m in range(LANES):
        speed = approach(m, at, row, bench)
        before = row[at + P_PUSH + m]
        meets = (
            (row[at + P_BEFORE + m] < -slowest)
            & (row[at + P_TOTAL + m] > 0.0)
            & (row[R_RESTITUTION + m] > 0.0)
        )
        bounced = bouncing_push(
            before, speed, row[at + P_BEFORE + m], row[R_RESTITUTION + m], row[at + P_MASS + m]
        )
        after = bounced if meets else before
        row[at + P_PUSH + m] = after
        row[at + P_NOW + m] = after - before  # the gap is of no more use
        row[at + P_TOTAL + m] = row[at + P_TOTAL + m] + (after - before)
        push(m, at, after - before, row, bench)


def some_met(at: int, least: float, row: Array) -> bool:
    """Return whether some lane is pushed whose gap, or bounce, is more than the least."""
    met = 0
    for m in range(LANES):
        met += 1 if (row[at + P_NOW + m] > least) & (row[at + P_PUSH + m] > 0.0) else 0
    return met > 0


def rub_met_lanes(at: int, least: float, row: Array, bench: Array) -> None:
    """Let friction act on what has met or bounced, up to its share of all of the push."""
    for m in range(LANES):
        speed = slip(m, at, row, bench)
        before = row[at + P_RUB + m]
        rubbed = limited_rub(
            before, speed, row[at + P_SIDE_MASS + m], row[R_FRICTION + m], row[at + P_PUSH + m]
        )
        met = (row[at + P_NOW + m] > least) & (row[at + P_PUSH + m] > 0.0)
        after = rubbed if met else before
        row[at + P_RUB + m] = after
        rub(m, at, after - before, row, bench)


def rub_met(lane: Whole, least: float, row: Array, bench: Array) -> None:
    """Let friction act on what has met or bounced in a block, if something has."""
    two = lane[POINTS] == 2
    if some_met(FIRST, least, row) or (two and some_met(SECOND, least, row)):
        rub_met_lanes(FIRST, least, row, bench)
        if two:
            rub_met_lanes(SECOND, least, row, bench)


def warm(first: int, last: int, rows: Array, lanes: Whole, motion: Array, bench: Array) -> None:
    """Apply the impulses of before."""
    for b in range(first, last):
        row, lane = rows[b], lanes[b]
        load(lane, motion, bench)
        warm_lanes(FIRST, row, bench)
        if lane[POINTS] == 2:
            warm_lanes(SECOND, row, bench)
        store(lane, motion, bench)


def sweep(
    first: int,
    last: int,
    rows: Array,
    lanes: Whole,
    motion: Array,
    bench: Array,
    substep: float,
) -> None:
    """Correct all impulses once, softly: friction first, so that pushes have the last word."""
    for b in range(first, last):
        row, lane = rows[b], lanes[b]
        load_all(lane, motion, bench)
        rub_lanes(FIRST, row, bench)
        if lane[POINTS] == 2:
            rub_lanes(SECOND, row, bench)
        push_lanes(FIRST, row, bench, substep)
        if lane[POINTS] == 2:
            push_lanes(SECOND, row, bench, substep)
        store(lane, motion, bench)


def relax(
    first: int,
    last: int,
    rows: Array,
    lanes: Whole,
    motion: Array,
    bench: Array,
    substep: float,
) -> None:
    """Correct all impulses once so that no softness is left in the velocities.

    What meets in this substep gets its push here, and so its friction after it.
    """
    for b in range(first, last):
        row, lane = rows[b], lanes[b]
        load(lane, motion, bench)
        rub_lanes(FIRST, row, bench)
        if lane[POINTS] == 2:
            rub_lanes(SECOND, row, bench)
        relax_lanes(FIRST, row, bench, substep)
        if lane[POINTS] == 2:
            relax_lanes(SECOND, row, bench, substep)
        rub_met(lane, OPEN, row, bench)
        store(lane, motion, bench)


def bounce(
    first: int,
    last: int,
    rows: Array,
    lanes: Whole,
    motion: Array,
    bench: Array,
    slowest: float,
) -> None:
    """Let what has met part."""
    for b in range(first, last):
        row, lane = rows[b], lanes[b]
        load(lane, motion, bench)
        bounce_lanes(FIRST, row, bench, slowest)
        if lane[POINTS] == 2:
            bounce_lanes(SECOND, row, bench, slowest)
        rub_met(lane, 0.0, row, bench)
        store(lane, motion, bench)
