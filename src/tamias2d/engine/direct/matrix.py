"""The matrix of a tree-like island: blocks of three by three, one of each node and of each edge.

Each row of a contact in the active set is like a very large mass that resists its velocity, and is
added to the masses of the bodies (DD33). The matrix is symmetric and positive definite.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.direct.active_set import HELD, RIGHT, share_of
from tamias2d.engine.tables import Constraints, Direct, Integers
from tamias2d.generated.firm_contact import (
    firm_inertia,
    firm_lever,
    firm_mass_x,
    firm_mass_y,
    firm_moment,
    turning_arm_both,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array, Vector


def assemble_matrix(n: int, constraints: Constraints, direct: Direct) -> None:
    """Write the matrix of an island for the active set as it is."""
    sparse = direct.sparse
    for pivot in range(sparse[n, tb.I_NODE], sparse[n + 1, tb.I_NODE]):
        clear_pivot(pivot, sparse, direct.factors)
    firm = direct.factors[n, tb.FIRM_MASS]
    for contact in range(sparse[n, tb.I_CONTACT], sparse[n + 1, tb.I_CONTACT]):
        sparse[contact, tb.C_FACTORED] = sparse[contact, tb.C_STATE]
        add_contact(contact, firm, constraints, direct)


def clear_pivot(pivot: int, sparse: Integers, factors: Array) -> None:
    """Write the mass of a node into its block, and zeros into those of its edges."""
    node, start = sparse[pivot, tb.PIVOT_NODE], sparse[pivot, tb.PIVOT_FIRST]
    mass, inertia = factors[node, tb.NODE_MASS], factors[node, tb.NODE_INERTIA]
    for k in range(6):
        factors[node, tb.DIAGONAL + k] = 0.0
    factors[node, tb.DIAGONAL] = factors[node, tb.DIAGONAL + 2] = mass if mass > 0.0 else 1.0
    factors[node, tb.DIAGONAL + 5] = inertia if inertia > 0.0 else 1.0
    for at in range(start, start + sparse[pivot, tb.PIVOT_COUNT]):
        for k in range(9):
            factors[sparse[at, tb.FILL], tb.OFF_DIAGONAL + k] = 0.0


def add_contact(contact: int, firm: float, constraints: Constraints, direct: Direct) -> None:
    """Add the rows of a contact that are in the active set."""
    sparse, factors = direct.sparse, direct.factors
    b, m, state = (
        sparse[contact, tb.C_BLOCK],
        sparse[contact, tb.C_LANE],
        sparse[contact, tb.C_STATE],
    )
    row, points = constraints.blocks[b], constraints.lanes[b, tb.POINTS]
    normal, tangent = (row[tb.R_NX + m], row[tb.R_NY + m]), (-row[tb.R_NY + m], row[tb.R_NX + m])
    for k in range(points):
        at = tb.SHARED + k * tb.POINT_SIZE + m
        if (state >> k) & 1 == 1:
            arm_a, arm_b = row[at + tb.P_NORMAL_ARM_A], row[at + tb.P_NORMAL_ARM_B]
            add_row(contact, firm, normal, arm_a, arm_b, sparse, factors)
    if state & RIGHT == HELD:
        at, last = tb.SHARED + m, tb.SHARED + (points - 1) * tb.POINT_SIZE + m
        share = share_of(0, state, contact, factors)
        arm_a = turning_arm_both(
            row[at + tb.P_TANGENT_ARM_A], row[last + tb.P_TANGENT_ARM_A], share
        )
        arm_b = turning_arm_both(
            row[at + tb.P_TANGENT_ARM_B], row[last + tb.P_TANGENT_ARM_B], share
        )
        add_row(contact, firm, tangent, arm_a, arm_b, sparse, factors)


def add_row(
    contact: int,
    firm: float,
    line: Vector,
    arm_a: float,
    arm_b: float,
    sparse: Integers,
    factors: Array,
) -> None:
    """Add one row of a contact to the blocks of its nodes and of its edge."""
    a, b, edge = (
        sparse[contact, tb.C_NODE_A],
        sparse[contact, tb.C_NODE_B],
        sparse[contact, tb.C_EDGE],
    )
    if a >= 0:
        if factors[a, tb.NODE_INERTIA] == 0.0:
            arm_a = 0.0
        add_diagonal(a, firm, line, arm_a, factors)
    if b >= 0:
        if factors[b, tb.NODE_INERTIA] == 0.0:
            arm_b = 0.0
        add_diagonal(b, firm, line, arm_b, factors)
    if edge >= 0:
        early, late = arm_a, arm_b
        if sparse[edge, tb.E_NODE_A] != a:
            early, late = arm_b, arm_a
        add_off_diagonal(edge, firm, line, early, late, factors)


def add_diagonal(node: int, firm: float, line: Vector, arm: float, factors: Array) -> None:
    """Add a row to the block of a node."""
    y_x, y_y = firm_mass_y(line, firm)
    turn_x, turn_y = firm_lever(line, arm, firm)
    factors[node, tb.DIAGONAL] += firm_mass_x(line, firm)[0]
    factors[node, tb.DIAGONAL + 1] += y_x
    factors[node, tb.DIAGONAL + 2] += y_y
    factors[node, tb.DIAGONAL + 3] += turn_x
    factors[node, tb.DIAGONAL + 4] += turn_y
    factors[node, tb.DIAGONAL + 5] += firm_inertia(arm, arm, firm)


@inlined
def add_off_diagonal(
    edge: int, firm: float, line: Vector, early: float, late: float, factors: Array
) -> None:
    """Add a row to the block of an edge, with its arms at the earlier and at the later node."""
    x_x, x_y = firm_mass_x(line, firm)
    y_x, y_y = firm_mass_y(line, firm)
    x_turn, y_turn = firm_moment(line, early, firm)
    turn_x, turn_y = firm_lever(line, late, firm)
    factors[edge, tb.OFF_DIAGONAL] -= x_x
    factors[edge, tb.OFF_DIAGONAL + 1] -= x_y
    factors[edge, tb.OFF_DIAGONAL + 2] -= x_turn
    factors[edge, tb.OFF_DIAGONAL + 3] -= y_x
    factors[edge, tb.OFF_DIAGONAL + 4] -= y_y
    factors[edge, tb.OFF_DIAGONAL + 5] -= y_turn
    factors[edge, tb.OFF_DIAGONAL + 6] -= turn_x
    factors[edge, tb.OFF_DIAGONAL + 7] -= turn_y
    factors[edge, tb.OFF_DIAGONAL + 8] -= firm_inertia(early, late, firm)
