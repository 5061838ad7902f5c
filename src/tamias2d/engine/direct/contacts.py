"""Joints: the contacts of thin islands, each a lane of a block of rows.

Serves: the direct solver. Hides: where a joint reads and writes in rows that sweeps go on from, and
which knots its impulses load.
"""

from tamias2d.engine.tables import (
    ASKED,
    BIAS,
    BODY_A,
    BODY_B,
    C_BLOCK,
    C_LANE,
    C_ONE,
    C_OTHER,
    CHANGE,
    DANGLE,
    DX,
    DY,
    P_ARM_A,
    P_ARM_B,
    P_GAP,
    P_GAP_NOW,
    P_NORMAL,
    P_SIDE_A,
    P_SIDE_B,
    P_TANGENT,
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
    R_ROUND_A,
    R_ROUND_B,
    R_SHARE,
    SHARED,
    SIZE,
    SOFT,
    SPIN,
    VX,
    VY,
    Bodies,
    Constraints,
    Direct,
    Integers,
)
from tamias2d.generated.firm_contact import (
    angular_momentum_a_kicked,
    angular_momentum_b_kicked,
    limited_rub,
    momentum_a_kicked,
    momentum_b_kicked,
    rub_most,
)
from tamias2d.generated.soft_contact import (
    angular_velocity_a_kicked,
    angular_velocity_b_kicked,
    bias_velocity,
    bias_velocity_later,
    row_velocity,
    separation,
    separation_later,
    velocity_a_kicked,
    velocity_b_kicked,
)
from tamias2d.state import Array, Vector


def row_speed(
    m: int, at: int, row: Array, a: Array, b: Array, arm_a: int, arm_b: int, line: Vector
) -> float:
    """Return the velocity of a row of a lane, m/s."""
    return row_velocity(
        (a[VX], a[VY]),
        a[SPIN],
        row[at + arm_a + m],
        (b[VX], b[VY]),
        b[SPIN],
        row[at + arm_b + m],
        line,
    )


def open_contact(
    joint: int,
    relaxing: bool,
    substep: float,
    rate: float,
    bodies: Bodies,
    constraints: Constraints,
    direct: Direct,
) -> tuple[float, float]:
    """Find the velocity that a joint is to have; return how far it is off that, and least bias."""
    b, m = direct.sparse[joint, C_BLOCK], direct.sparse[joint, C_LANE]
    row = constraints.blocks[b]
    one, other = (
        bodies.motion[constraints.lanes[b, BODY_A + m]],
        bodies.motion[constraints.lanes[b, BODY_B + m]],
    )
    line = (row[R_NX + m], row[R_NY + m])
    fastest = least = 0.0
    for k in range(constraints.lanes[b, POINTS]):
        at = SHARED + k * SIZE
        speed = row_speed(m, at, row, one, other, P_ARM_A, P_ARM_B, line)
        if relaxing:
            bias = bias_velocity_later(row[at + P_GAP_NOW + m], speed, substep)
        else:
            gap = separation_later(
                row[at + P_GAP + m],
                (one[DX], one[DY]),
                one[DANGLE],
                row[at + P_ARM_A + m],
                row[at + P_SIDE_A + m] - row[R_ROUND_A + m],
                (other[DX], other[DY]),
                other[DANGLE],
                row[at + P_ARM_B + m],
                row[at + P_SIDE_B + m] + row[R_ROUND_B + m],
                line,
            )
            bias = bias_velocity(gap, rate, row[R_LIMIT + m], substep)
        direct.factors[joint, BIAS + k] = bias
        direct.factors[joint, ASKED + k] = speed + bias
        fastest, least = max(fastest, abs(speed + bias)), min(least, bias)
    return fastest, least


def add_to_nodes(
    joint: int,
    m: int,
    at: int,
    arm_a: int,
    arm_b: int,
    amount: float,
    line: Vector,
    row: Array,
    sparse: Integers,
    factors: Array,
) -> None:
    """Add an impulse, N s, to what its two knots take."""
    one, other = sparse[joint, C_ONE], sparse[joint, C_OTHER]
    if one >= 0:
        knot = factors[one]
        momentum = (knot[CHANGE], knot[CHANGE + 1])
        knot[CHANGE], knot[CHANGE + 1] = momentum_a_kicked(momentum, amount, line)
        knot[CHANGE + 2] = angular_momentum_a_kicked(knot[CHANGE + 2], amount, row[at + arm_a + m])
    if other >= 0:
        knot = factors[other]
        momentum = (knot[CHANGE], knot[CHANGE + 1])
        knot[CHANGE], knot[CHANGE + 1] = momentum_b_kicked(momentum, amount, line)
        knot[CHANGE + 2] = angular_momentum_b_kicked(knot[CHANGE + 2], amount, row[at + arm_b + m])


def apply_contact(joint: int, bodies: Bodies, constraints: Constraints, direct: Direct) -> float:
    """Let the impulses that were found act, as contacts can give them; return the larger push."""
    b, m = direct.sparse[joint, C_BLOCK], direct.sparse[joint, C_LANE]
    row = constraints.blocks[b]
    one, other = (
        bodies.motion[constraints.lanes[b, BODY_A + m]],
        bodies.motion[constraints.lanes[b, BODY_B + m]],
    )
    line, tangent = (row[R_NX + m], row[R_NY + m]), (-row[R_NY + m], row[R_NX + m])
    most = 0.0
    for k in range(constraints.lanes[b, POINTS]):
        at = SHARED + k * SIZE + m
        push = max(direct.factors[joint, ASKED + k], 0.0)
        rub = limited_rub(direct.factors[joint, ASKED + 2 + k], rub_most(push, row[R_FRICTION + m]))
        direct.factors[joint, ASKED + k], direct.factors[joint, ASKED + 2 + k] = push, rub
        more = push - row[at + P_NORMAL]
        apply_impulse_to(m, more, line, row[at + P_ARM_A], row[at + P_ARM_B], row, one, other)
        more = rub - row[at + P_TANGENT]
        apply_impulse_to(m, more, tangent, row[at + P_SIDE_A], row[at + P_SIDE_B], row, one, other)
        most = max(most, push)
    return most


def apply_impulse_to(
    m: int,
    amount: float,
    line: Vector,
    arm_a: float,
    arm_b: float,
    row: Array,
    one: Array,
    other: Array,
) -> None:
    """Let an impulse, N s, act on two bodies."""
    one[VX], one[VY] = velocity_a_kicked((one[VX], one[VY]), amount, line, row[R_MASS_A + m])
    one[SPIN] = angular_velocity_a_kicked(one[SPIN], amount, arm_a, row[R_INERTIA_A + m])
    other[VX], other[VY] = velocity_b_kicked(
        (other[VX], other[VY]), amount, line, row[R_MASS_B + m]
    )
    other[SPIN] = angular_velocity_b_kicked(other[SPIN], amount, arm_b, row[R_INERTIA_B + m])


def store_contact(joint: int, constraints: Constraints, direct: Direct) -> None:
    """Write the impulses that were found where sweeps go on from."""
    b, m = direct.sparse[joint, C_BLOCK], direct.sparse[joint, C_LANE]
    for k in range(constraints.lanes[b, POINTS]):
        at = SHARED + k * SIZE + m
        constraints.blocks[b, at + P_NORMAL] = direct.factors[joint, ASKED + k]
        constraints.blocks[b, at + P_TANGENT] = direct.factors[joint, ASKED + 2 + k]


def harden(joint: int, good: bool, rate: float, constraints: Constraints, direct: Direct) -> None:
    """Let the next sweep take a joint as hard, where it was solved, otherwise as soft."""
    row, m = constraints.blocks[direct.sparse[joint, C_BLOCK]], direct.sparse[joint, C_LANE]
    row[R_BIAS + m] = rate if good else direct.factors[joint, SOFT]
    row[R_SHARE + m] = 1.0 if good else direct.factors[joint, SOFT + 1]
    row[R_KEEP + m] = 0.0 if good else direct.factors[joint, SOFT + 2]


def note_gaps(
    joint: int, substep: float, bodies: Bodies, constraints: Constraints, direct: Direct
) -> None:
    """Tell the next visit of a joint how far it is open, from its velocity now."""
    b, m = direct.sparse[joint, C_BLOCK], direct.sparse[joint, C_LANE]
    row = constraints.blocks[b]
    one, other = (
        bodies.motion[constraints.lanes[b, BODY_A + m]],
        bodies.motion[constraints.lanes[b, BODY_B + m]],
    )
    line = (row[R_NX + m], row[R_NY + m])
    for k in range(constraints.lanes[b, POINTS]):
        at = SHARED + k * SIZE
        speed = row_speed(m, at, row, one, other, P_ARM_A, P_ARM_B, line)
        row[at + P_GAP_NOW + m] = separation(direct.factors[joint, BIAS + k], speed, substep)
