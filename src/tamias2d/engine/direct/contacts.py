"""The contacts of tree-like islands, each a lane of a block: what is read there, and written.

The substeps go on from the same blocks, whether an island was solved directly or not.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Bodies, Constraints, Direct, Integers
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
    return row_velocity(
        (a[tb.VX], a[tb.VY]), a[tb.SPIN], arm_a, (b[tb.VX], b[tb.VY]), b[tb.SPIN], arm_b, line
    )


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
    b, m = direct.sparse[contact, tb.C_BLOCK], direct.sparse[contact, tb.C_LANE]
    row, lane = constraints.blocks[b], constraints.lanes[b]
    one, other = bodies.motion[lane[tb.BODY_A + m]], bodies.motion[lane[tb.BODY_B + m]]
    normal = (row[tb.R_NX + m], row[tb.R_NY + m])
    largest = least = 0.0
    for k in range(lane[tb.POINTS]):
        at = tb.SHARED + k * tb.POINT_SIZE + m
        arm_a, arm_b = row[at + tb.P_NORMAL_ARM_A], row[at + tb.P_NORMAL_ARM_B]
        speed = point_speed(one, other, arm_a, arm_b, normal)
        if relaxing:
            bias = bias_velocity_later(row[at + tb.P_GAP_NOW], speed, substep)
        else:
            gap = gap_later(m, at, row, one, other)
            bias = bias_velocity(gap, rate, row[tb.R_BIAS_LEAST + m], substep)
        direct.factors[contact, tb.BIAS + k] = bias
        direct.factors[contact, tb.SPEED_ERROR + k] = speed + bias
        largest, least = max(largest, abs(speed + bias)), min(least, bias)
    return largest, least


@inlined
def gap_later(m: int, at: int, row: Array, a: Array, b: Array) -> float:
    """Return the gap of a point where its bodies are now, m."""
    return separation_later(
        row[at + tb.P_GAP],
        (a[tb.DX], a[tb.DY]),
        a[tb.DANGLE],
        row[at + tb.P_NORMAL_ARM_A],
        row[at + tb.P_TANGENT_ARM_A] - row[tb.R_RADIUS_A + m],
        (b[tb.DX], b[tb.DY]),
        b[tb.DANGLE],
        row[at + tb.P_NORMAL_ARM_B],
        row[at + tb.P_TANGENT_ARM_B] + row[tb.R_RADIUS_B + m],
        (row[tb.R_NX + m], row[tb.R_NY + m]),
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
    a, b = sparse[contact, tb.C_NODE_A], sparse[contact, tb.C_NODE_B]
    if a >= 0:
        node = factors[a]
        momentum = (node[tb.CHANGE], node[tb.CHANGE + 1])
        node[tb.CHANGE], node[tb.CHANGE + 1] = momentum_a_after(momentum, impulse, line)
        node[tb.CHANGE + 2] = angular_momentum_a_after(node[tb.CHANGE + 2], impulse, arm_a)
    if b >= 0:
        node = factors[b]
        momentum = (node[tb.CHANGE], node[tb.CHANGE + 1])
        node[tb.CHANGE], node[tb.CHANGE + 1] = momentum_b_after(momentum, impulse, line)
        node[tb.CHANGE + 2] = angular_momentum_b_after(node[tb.CHANGE + 2], impulse, arm_b)


def apply_contact(
    contact: int, shares: bool, bodies: Bodies, constraints: Constraints, direct: Direct
) -> float:
    """Apply the proposed impulses, as far as a contact can give them; return the largest normal.

    Its points may share what friction they hold by.
    """
    b, m = direct.sparse[contact, tb.C_BLOCK], direct.sparse[contact, tb.C_LANE]
    row, lane, factors = constraints.blocks[b], constraints.lanes[b], direct.factors
    one, other = bodies.motion[lane[tb.BODY_A + m]], bodies.motion[lane[tb.BODY_B + m]]
    line, across = (row[tb.R_NX + m], row[tb.R_NY + m]), (-row[tb.R_NY + m], row[tb.R_NX + m])
    largest = 0.0
    if shares and lane[tb.POINTS] == 2:
        share_tangents(row[tb.R_FRICTION + m], factors[contact])
    for k in range(lane[tb.POINTS]):
        at = tb.SHARED + k * tb.POINT_SIZE + m
        normal = max(factors[contact, tb.NEW_NORMAL + k], 0.0)
        limit = tangent_impulse_most(normal, row[tb.R_FRICTION + m])
        tangent = limited_tangent_impulse(factors[contact, tb.NEW_TANGENT + k], limit)
        factors[contact, tb.NEW_NORMAL + k], factors[contact, tb.NEW_TANGENT + k] = normal, tangent
        arm_a, arm_b = row[at + tb.P_NORMAL_ARM_A], row[at + tb.P_NORMAL_ARM_B]
        apply_impulse_to(
            m, normal - row[at + tb.P_NORMAL_IMPULSE], line, arm_a, arm_b, row, one, other
        )
        arm_a, arm_b = row[at + tb.P_TANGENT_ARM_A], row[at + tb.P_TANGENT_ARM_B]
        more = tangent - row[at + tb.P_TANGENT_IMPULSE]
        apply_impulse_to(m, more, across, arm_a, arm_b, row, one, other)
        largest = max(largest, normal)
    return largest


def share_tangents(friction: float, numbers: Array) -> None:
    """Let each of two points give as much of their tangent impulses as its friction allows."""
    first, second = numbers[tb.NEW_TANGENT], numbers[tb.NEW_TANGENT + 1]
    most = tangent_impulse_most(max(numbers[tb.NEW_NORMAL], 0.0), friction)
    most_second = tangent_impulse_most(max(numbers[tb.NEW_NORMAL + 1], 0.0), friction)
    both = first + second
    second = limited_tangent_impulse(both - limited_tangent_impulse(first, most), most_second)
    numbers[tb.NEW_TANGENT] = limited_tangent_impulse(both - second, most)
    numbers[tb.NEW_TANGENT + 1] = second


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
    a[tb.VX], a[tb.VY] = velocity_a_after((a[tb.VX], a[tb.VY]), impulse, line, row[tb.R_MASS_A + m])
    a[tb.SPIN] = angular_velocity_a_after(a[tb.SPIN], impulse, arm_a, row[tb.R_INERTIA_A + m])
    b[tb.VX], b[tb.VY] = velocity_b_after((b[tb.VX], b[tb.VY]), impulse, line, row[tb.R_MASS_B + m])
    b[tb.SPIN] = angular_velocity_b_after(b[tb.SPIN], impulse, arm_b, row[tb.R_INERTIA_B + m])


def store_contact(contact: int, constraints: Constraints, direct: Direct) -> None:
    """Write the impulses of a contact that was solved to its block."""
    b, m = direct.sparse[contact, tb.C_BLOCK], direct.sparse[contact, tb.C_LANE]
    row = constraints.blocks[b]
    for k in range(constraints.lanes[b, tb.POINTS]):
        at = tb.SHARED + k * tb.POINT_SIZE + m
        row[at + tb.P_NORMAL_IMPULSE] = direct.factors[contact, tb.NEW_NORMAL + k]
        row[at + tb.P_TANGENT_IMPULSE] = direct.factors[contact, tb.NEW_TANGENT + k]


def harden(
    contact: int, solved: bool, rate: float, constraints: Constraints, direct: Direct
) -> None:
    """Let the substep that follows take a contact as hard if it was solved, otherwise as soft."""
    soft = direct.factors[contact]
    row, m = (
        constraints.blocks[direct.sparse[contact, tb.C_BLOCK]],
        direct.sparse[contact, tb.C_LANE],
    )
    row[tb.R_BIAS_RATE + m] = rate if solved else soft[tb.SOFTNESS]
    row[tb.R_MASS_SHARE + m] = 1.0 if solved else soft[tb.SOFTNESS + 1]
    row[tb.R_IMPULSE_SHARE + m] = 0.0 if solved else soft[tb.SOFTNESS + 2]


def note_gaps(
    contact: int, substep: float, bodies: Bodies, constraints: Constraints, direct: Direct
) -> None:
    """Write the gaps of a contact for the relaxation that follows, from its velocity now."""
    b, m = direct.sparse[contact, tb.C_BLOCK], direct.sparse[contact, tb.C_LANE]
    row, lane = constraints.blocks[b], constraints.lanes[b]
    one, other = bodies.motion[lane[tb.BODY_A + m]], bodies.motion[lane[tb.BODY_B + m]]
    normal = (row[tb.R_NX + m], row[tb.R_NY + m])
    for k in range(lane[tb.POINTS]):
        at = tb.SHARED + k * tb.POINT_SIZE + m
        arm_a, arm_b = row[at + tb.P_NORMAL_ARM_A], row[at + tb.P_NORMAL_ARM_B]
        speed = point_speed(one, other, arm_a, arm_b, normal)
        row[at + tb.P_GAP_NOW] = separation(direct.factors[contact, tb.BIAS + k], speed, substep)
