"""The soft step through all blocks: what contacts do to velocities, lane by lane.

Serves: a step. Hides: the order of what is loaded and stored, which decides whether compiled code
takes many lanes at once: loops over a fixed number of lanes, over two arrays, without branches.
"""

from tamias2d.state import Array
from tamias2d.stepped.layout import DTURN, DX, DY, SPIN, VX, VY, Whole
from tamias2d.stepped.rows import (
    BODY_A,
    BODY_B,
    LANES,
    P_ARM_A,
    P_ARM_B,
    P_BEFORE,
    P_GAP,
    P_MASS,
    P_PUSH,
    P_RUB,
    P_SIDE_A,
    P_SIDE_B,
    P_SIDE_MASS,
    P_TOTAL,
    POINTS,
    R_FRICTION,
    R_INERTIA_A,
    R_INERTIA_B,
    R_LIMIT,
    R_MASS_A,
    R_MASS_B,
    R_NX,
    R_NY,
    R_RESTITUTION,
    R_ROUND_A,
    R_ROUND_B,
    SHARED,
    SIZE,
)
from tamias2d.stepped.soft import (
    bouncing_push,
    row_velocity,
    rub,
    separation_later,
    soft_push,
)

# the bench on which a block is worked on: what its points share, as in the row, then the motion
B_VX_A, B_VY_A, B_SPIN_A, B_VX_B, B_VY_B, B_SPIN_B = 176, 192, 208, 224, 240, 256
B_DX_A, B_DY_A, B_TURN_A, B_DX_B, B_DY_B, B_TURN_B = 272, 288, 304, 320, 336, 352
BENCH = 368


def load(row: Array, lane: Whole, motion: Array, bench: Array) -> None:
    """Bring a block to the bench."""
    for m in range(LANES):
        i, j = lane[BODY_A + m], lane[BODY_B + m]
        a, b = motion[i], motion[j]
        bench[B_VX_A + m], bench[B_VY_A + m], bench[B_SPIN_A + m] = a[VX], a[VY], a[SPIN]
        bench[B_VX_B + m], bench[B_VY_B + m], bench[B_SPIN_B + m] = b[VX], b[VY], b[SPIN]
    for m in range(SHARED):
        bench[m] = row[m]


def load_moved(lane: Whole, motion: Array, bench: Array) -> None:
    """Bring what the bodies of a block have moved since the step began."""
    for m in range(LANES):
        i, j = lane[BODY_A + m], lane[BODY_B + m]
        a, b = motion[i], motion[j]
        bench[B_DX_A + m], bench[B_DY_A + m], bench[B_TURN_A + m] = a[DX], a[DY], a[DTURN]
        bench[B_DX_B + m], bench[B_DY_B + m], bench[B_TURN_B + m] = b[DX], b[DY], b[DTURN]


def store(lane: Whole, motion: Array, bench: Array) -> None:
    """Bring the velocities back from the bench."""
    for m in range(LANES):
        i, j = lane[BODY_A + m], lane[BODY_B + m]
        a, b = motion[i], motion[j]
        a[VX], a[VY], a[SPIN] = bench[B_VX_A + m], bench[B_VY_A + m], bench[B_SPIN_A + m]
        b[VX], b[VY], b[SPIN] = bench[B_VX_B + m], bench[B_VY_B + m], bench[B_SPIN_B + m]


def kick(m: int, push: float, rubbed: float, point: Array, bench: Array) -> None:
    """Let impulses along normal and tangent act on the bodies of a lane."""
    x, y = bench[R_NX + m], bench[R_NY + m]
    along_x, along_y = push * x - rubbed * y, push * y + rubbed * x
    turn_a = push * point[P_ARM_A + m] + rubbed * point[P_SIDE_A + m]
    turn_b = push * point[P_ARM_B + m] + rubbed * point[P_SIDE_B + m]
    bench[B_VX_A + m] = bench[B_VX_A + m] - bench[R_MASS_A + m] * along_x
    bench[B_VY_A + m] = bench[B_VY_A + m] - bench[R_MASS_A + m] * along_y
    bench[B_SPIN_A + m] = bench[B_SPIN_A + m] - bench[R_INERTIA_A + m] * turn_a
    bench[B_VX_B + m] = bench[B_VX_B + m] + bench[R_MASS_B + m] * along_x
    bench[B_VY_B + m] = bench[B_VY_B + m] + bench[R_MASS_B + m] * along_y
    bench[B_SPIN_B + m] = bench[B_SPIN_B + m] + bench[R_INERTIA_B + m] * turn_b


def warm_lanes(point: Array, bench: Array) -> None:
    """Apply again what was found before, and sum up what it has been so far."""
    for m in range(LANES):
        push = point[P_PUSH + m]
        point[P_TOTAL + m] = point[P_TOTAL + m] + push
        kick(m, push, point[P_RUB + m], point, bench)


def push_lanes(
    point: Array, bench: Array, rate: float, bias_rate: float, share: float, keep: float
) -> None:
    """Correct the pushes along the normals; `rate` is one over the substep, 1/s."""
    for m in range(LANES):
        normal = (bench[R_NX + m], bench[R_NY + m])
        arm_a, arm_b = point[P_ARM_A + m], point[P_ARM_B + m]
        gap = separation_later(
            point[P_GAP + m],
            (bench[B_DX_A + m], bench[B_DY_A + m]),
            bench[B_TURN_A + m],
            arm_a,
            point[P_SIDE_A + m] - bench[R_ROUND_A + m],
            (bench[B_DX_B + m], bench[B_DY_B + m]),
            bench[B_TURN_B + m],
            arm_b,
            point[P_SIDE_B + m] + bench[R_ROUND_B + m],
            normal,
        )
        back = bias_rate * gap
        back = back if back > bench[R_LIMIT + m] else bench[R_LIMIT + m]
        apart = gap > 0.0
        bias = gap * rate if apart else back
        part = 1.0 if apart else share
        kept = 0.0 if apart else keep
        speed = row_velocity(
            (bench[B_VX_A + m], bench[B_VY_A + m]),
            bench[B_SPIN_A + m],
            arm_a,
            (bench[B_VX_B + m], bench[B_VY_B + m]),
            bench[B_SPIN_B + m],
            arm_b,
            normal,
        )
        before = point[P_PUSH + m]
        after = soft_push(before, speed, bias, point[P_MASS + m], part, kept)
        point[P_PUSH + m] = after
        kick(m, after - before, 0.0, point, bench)


def rub_lanes(point: Array, bench: Array) -> None:
    """Correct the impulses along the tangents."""
    for m in range(LANES):
        tangent = (-bench[R_NY + m], bench[R_NX + m])
        speed = row_velocity(
            (bench[B_VX_A + m], bench[B_VY_A + m]),
            bench[B_SPIN_A + m],
            point[P_SIDE_A + m],
            (bench[B_VX_B + m], bench[B_VY_B + m]),
            bench[B_SPIN_B + m],
            point[P_SIDE_B + m],
            tangent,
        )
        before = point[P_RUB + m]
        after = rub(before, speed, point[P_SIDE_MASS + m], bench[R_FRICTION + m], point[P_PUSH + m])
        point[P_RUB + m] = after
        kick(m, 0.0, after - before, point, bench)


def bounce_lanes(point: Array, bench: Array, slowest: float) -> None:
    """Let points that met faster than `slowest`, m/s, and were pushed, part as restitution says."""
    for m in range(LANES):
        speed = row_velocity(
            (bench[B_VX_A + m], bench[B_VY_A + m]),
            bench[B_SPIN_A + m],
            point[P_ARM_A + m],
            (bench[B_VX_B + m], bench[B_VY_B + m]),
            bench[B_SPIN_B + m],
            point[P_ARM_B + m],
            (bench[R_NX + m], bench[R_NY + m]),
        )
        before = point[P_PUSH + m]
        meets = (
            (point[P_BEFORE + m] < -slowest)
            & (point[P_TOTAL + m] > 0.0)
            & (bench[R_RESTITUTION + m] > 0.0)
        )
        bounced = bouncing_push(
            before, speed, point[P_BEFORE + m], bench[R_RESTITUTION + m], point[P_MASS + m]
        )
        after = bounced if meets else before
        point[P_PUSH + m] = after
        point[P_TOTAL + m] = point[P_TOTAL + m] + (after - before)
        kick(m, after - before, 0.0, point, bench)


def warm(blocks: int, rows: Array, lanes: Whole, motion: Array, bench: Array) -> None:
    """Apply the impulses of before."""
    for b in range(blocks):
        row, lane = rows[b], lanes[b]
        load(row, lane, motion, bench)
        for n in range(lane[POINTS]):
            warm_lanes(row[SHARED + n * SIZE : SHARED + n * SIZE + SIZE], bench)
        store(lane, motion, bench)


def sweep(
    first: int,
    last: int,
    rows: Array,
    lanes: Whole,
    motion: Array,
    bench: Array,
    rate: float,
    bias_rate: float,
    share: float,
    keep: float,
) -> None:
    """Correct all impulses of some blocks once: friction first, so that pushes have the last word."""
    for b in range(first, last):
        row, lane = rows[b], lanes[b]
        load(row, lane, motion, bench)
        load_moved(lane, motion, bench)
        for n in range(lane[POINTS]):
            rub_lanes(row[SHARED + n * SIZE : SHARED + n * SIZE + SIZE], bench)
        for n in range(lane[POINTS]):
            point = row[SHARED + n * SIZE : SHARED + n * SIZE + SIZE]
            push_lanes(point, bench, rate, bias_rate, share, keep)
        store(lane, motion, bench)


def bounce(
    blocks: int, rows: Array, lanes: Whole, motion: Array, bench: Array, slowest: float
) -> None:
    """Let what has met part."""
    for b in range(blocks):
        row, lane = rows[b], lanes[b]
        load(row, lane, motion, bench)
        for n in range(lane[POINTS]):
            bounce_lanes(row[SHARED + n * SIZE : SHARED + n * SIZE + SIZE], bench, slowest)
        store(lane, motion, bench)
