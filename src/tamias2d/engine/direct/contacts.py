"""The contacts of tree-like islands, each a lane of a block: what is read there, and written.

The substeps go on from the same blocks, whether an island was solved directly or not.
"""

from tamias2d.engine.tables import (
    BIAS,
    BODY_A,
    BODY_B,
    C_BLOCK,
    C_LANE,
    C_NODE_A,
    C_NODE_B,
    CHANGE,
    DANGLE,
    DX,
    DY,
    NEW_NORMAL,
    NEW_TANGENT,
    P_GAP,
    P_GAP_NOW,
    P_NORMAL_ARM_A,
    P_NORMAL_ARM_B,
    P_NORMAL_IMPULSE,
    P_TANGENT_ARM_A,
    P_TANGENT_ARM_B,
    P_TANGENT_IMPULSE,
    POINT_SIZE,
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
    SHARED,
    SOFTNESS,
    SPEED_ERROR,
    SPIN,
    VX,
    VY,
    Bodies,
    Constraints,
    Direct,
    Integers,
)
from tamias2d.generated.firm_contact import (
    angular_momentum_a_after,
    angular_momentum_b_after,
    limited_tangent_impulse,
    momentum_a_after,
    momentum_b_after,
    tangent_impulse_most,
)
from tamias2d.generated.soft_contact import (
    angular_velocity_a_after,
    angular_velocity_b_after,
    bias_velocity,
    bias_velocity_later,
    row_velocity,
    separation,
    separation_later,
    velocity_a_after,
    velocity_b_after,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array, Vector


def point_speed(a: Array, b: Array, arm_a: float, arm_b: float, line: Vector) -> float:
    """Return the velocity along a line at a point of two bodies, m/s; turning arms in m."""
    return row_velocity((a[VX], a[VY]), a[SPIN], arm_a, (b[VX], b[VY]), b[SPIN], arm_b, line)


def open_contact(
    contact: int,
    relaxing: bool,
    substep: float,
    rate: float,
    bodies: Bodies,
    constraints: Constraints,
    direct: Direct,
) -> tuple[float, float]:
    """Write the bias of the points of a contact, and how far their velocities are off it, m/s.

    Returns the largest of these differences, and the least bias.
    """
    b, m = direct.sparse[contact, C_BLOCK], direct.sparse[contact, C_LANE]
    row, lane = constraints.blocks[b], constraints.lanes[b]
    one, other = bodies.motion[lane[BODY_A + m]], bodies.motion[lane[BODY_B + m]]
    normal = (row[R_NX + m], row[R_NY + m])
    largest = least = 0.0
    for k in range(lane[POINTS]):
        at = SHARED + k * POINT_SIZE + m
        arm_a, arm_b = row[at + P_NORMAL_ARM_A], row[at + P_NORMAL_ARM_B]
        speed = point_speed(one, other, arm_a, arm_b, normal)
        if relaxing:
            bias = bias_velocity_later(row[at + P_GAP_NOW], speed, substep)
        else:
            gap = gap_later(m, at, row, one, other)
            bias = bias_velocity(gap, rate, row[R_BIAS_LEAST + m], substep)
        direct.factors[contact, BIAS + k] = bias
        direct.factors[contact, SPEED_ERROR + k] = speed + bias
        largest, least = max(largest, abs(speed + bias)), min(least, bias)
    return largest, least


@inlined
def gap_later(m: int, at: int, row: Array, a: Array, b: Array) -> float:
    """Return the gap of a point where its bodies are now, m."""
    return separation_later(
        row[at + P_GAP],
        (a[DX], a[DY]),
        a[DANGLE],
        row[at + P_NORMAL_ARM_A],
        row[at + P_TANGENT_ARM_A] - row[R_RADIUS_A + m],
        (b[DX], b[DY]),
        b[DANGLE],
        row[at + P_NORMAL_ARM_B],
        row[at + P_TANGENT_ARM_B] + row[R_RADIUS_B + m],
        (row[R_NX + m], row[R_NY + m]),
    )


def add_to_nodes(
    contact: int,
    impulse: float,
    arm_a: float,
    arm_b: float,
    line: Vector,
    sparse: Integers,
    factors: Array,
) -> None:
    """Add an impulse, N s, to the momenta of the nodes of a contact."""
    a, b = sparse[contact, C_NODE_A], sparse[contact, C_NODE_B]
    if a >= 0:
        node = factors[a]
        momentum = (node[CHANGE], node[CHANGE + 1])
        node[CHANGE], node[CHANGE + 1] = momentum_a_after(momentum, impulse, line)
        node[CHANGE + 2] = angular_momentum_a_after(node[CHANGE + 2], impulse, arm_a)
    if b >= 0:
        node = factors[b]
        momentum = (node[CHANGE], node[CHANGE + 1])
        node[CHANGE], node[CHANGE + 1] = momentum_b_after(momentum, impulse, line)
        node[CHANGE + 2] = angular_momentum_b_after(node[CHANGE + 2], impulse, arm_b)


def apply_contact(contact: int, bodies: Bodies, constraints: Constraints, direct: Direct) -> float:
    """Apply the proposed impulses, as far as a contact can give them; return the largest normal."""
    b, m = direct.sparse[contact, C_BLOCK], direct.sparse[contact, C_LANE]
    row, lane, factors = constraints.blocks[b], constraints.lanes[b], direct.factors
    one, other = bodies.motion[lane[BODY_A + m]], bodies.motion[lane[BODY_B + m]]
    line, across = (row[R_NX + m], row[R_NY + m]), (-row[R_NY + m], row[R_NX + m])
    largest = 0.0
    for k in range(lane[POINTS]):
        at = SHARED + k * POINT_SIZE + m
        normal = max(factors[contact, NEW_NORMAL + k], 0.0)
        limit = tangent_impulse_most(normal, row[R_FRICTION + m])
        tangent = limited_tangent_impulse(factors[contact, NEW_TANGENT + k], limit)
        factors[contact, NEW_NORMAL + k], factors[contact, NEW_TANGENT + k] = normal, tangent
        arm_a, arm_b = row[at + P_NORMAL_ARM_A], row[at + P_NORMAL_ARM_B]
        apply_impulse_to(
            m, normal - row[at + P_NORMAL_IMPULSE], line, arm_a, arm_b, row, one, other
        )
        arm_a, arm_b = row[at + P_TANGENT_ARM_A], row[at + P_TANGENT_ARM_B]
        more = tangent - row[at + P_TANGENT_IMPULSE]
        apply_impulse_to(m, more, across, arm_a, arm_b, row, one, other)
        largest = max(largest, normal)
    return largest


def apply_impulse_to(
    m: int,
    impulse: float,
    line: Vector,
    arm_a: float,
    arm_b: float,
    row: Array,
    a: Array,
    b: Array,
) -> None:
    """Apply an impulse, N s, to the motion of two bodies."""
    a[VX], a[VY] = velocity_a_after((a[VX], a[VY]), impulse, line, row[R_MASS_A + m])
    a[SPIN] = angular_velocity_a_after(a[SPIN], impulse, arm_a, row[R_INERTIA_A + m])
    b[VX], b[VY] = velocity_b_after((b[VX], b[VY]), impulse, line, row[R_MASS_B + m])
    b[SPIN] = angular_velocity_b_after(b[SPIN], impulse, arm_b, row[R_INERTIA_B + m])


def store_contact(contact: int, constraints: Constraints, direct: Direct) -> None:
    """Write the impulses of a contact that was solved to its block."""
    b, m = direct.sparse[contact, C_BLOCK], direct.sparse[contact, C_LANE]
    row = constraints.blocks[b]
    for k in range(constraints.lanes[b, POINTS]):
        at = SHARED + k * POINT_SIZE + m
        row[at + P_NORMAL_IMPULSE] = direct.factors[contact, NEW_NORMAL + k]
        row[at + P_TANGENT_IMPULSE] = direct.factors[contact, NEW_TANGENT + k]


def harden(
    contact: int, solved: bool, rate: float, constraints: Constraints, direct: Direct
) -> None:
    """Let the substep that follows take a contact as hard if it was solved, otherwise as soft."""
    soft = direct.factors[contact]
    row, m = constraints.blocks[direct.sparse[contact, C_BLOCK]], direct.sparse[contact, C_LANE]
    row[R_BIAS_RATE + m] = rate if solved else soft[SOFTNESS]
    row[R_MASS_SHARE + m] = 1.0 if solved else soft[SOFTNESS + 1]
    row[R_IMPULSE_SHARE + m] = 0.0 if solved else soft[SOFTNESS + 2]


def note_gaps(
    contact: int, substep: float, bodies: Bodies, constraints: Constraints, direct: Direct
) -> None:
    """Write the gaps of a contact for the relaxation that follows, from its velocity now."""
    b, m = direct.sparse[contact, C_BLOCK], direct.sparse[contact, C_LANE]
    row, lane = constraints.blocks[b], constraints.lanes[b]
    one, other = bodies.motion[lane[BODY_A + m]], bodies.motion[lane[BODY_B + m]]
    normal = (row[R_NX + m], row[R_NY + m])
    for k in range(lane[POINTS]):
        at = SHARED + k * POINT_SIZE + m
        arm_a, arm_b = row[at + P_NORMAL_ARM_A], row[at + P_NORMAL_ARM_B]
        speed = point_speed(one, other, arm_a, arm_b, normal)
        row[at + P_GAP_NOW] = separation(direct.factors[contact, BIAS + k], speed, substep)
