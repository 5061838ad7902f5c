"""The equations of thin islands, written and eliminated.

Serves: the direct solver. Hides: how blocks of three by three are kept, one of each body and one of
each link, and what rounding makes of them.

Each contact that holds is like a very large mass which resists its velocity, and is added to the
masses of the bodies (DD33). What comes out is symmetric and positive, so that a triangle and its
mirror image take its place (Cholesky).

Source: George and Liu (1981).
"""

from math import sqrt

from tamias2d.engine.tables import (
    BESIDE,
    C_BLOCK,
    C_BUILT,
    C_EDGE,
    C_LANE,
    C_ONE,
    C_OTHER,
    C_STATE,
    CHANGE,
    DIAGONAL,
    E_ONE,
    E_OTHER,
    FILL,
    FIRM,
    I_CONTACT,
    I_NODE,
    NODE_INERTIA,
    NODE_MASS,
    P_ARM_A,
    P_ARM_B,
    P_SIDE_A,
    P_SIDE_B,
    POINTS,
    R_NX,
    R_NY,
    SHARE,
    SHARED,
    SIZE,
    V_COUNT,
    V_FIRST,
    V_NODE,
    Constraints,
    Direct,
    Integers,
)
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

BOTH = 3  # points of a joint that push, one bit each; with them, what friction does:
LOOSE, HELD, LEFT, RIGHT = 0, 4, 8, 12  # nothing, hold, or slide

# weave: columns of numbers beside those of the web


def assemble_matrix(n: int, constraints: Constraints, direct: Direct) -> None:
    """Write the equations of an island."""
    for turn in range(direct.sparse[n, I_NODE], direct.sparse[n + 1, I_NODE]):
        knot, start = direct.sparse[turn, V_NODE], direct.sparse[turn, V_FIRST]
        mass, inertia = direct.factors[knot, NODE_MASS], direct.factors[knot, NODE_INERTIA]
        for k in range(6):
            direct.factors[knot, DIAGONAL + k] = 0.0
        direct.factors[knot, DIAGONAL] = direct.factors[knot, DIAGONAL + 2] = (
            mass if mass > 0.0 else 1.0
        )
        direct.factors[knot, DIAGONAL + 5] = inertia if inertia > 0.0 else 1.0
        for at in range(start, start + direct.sparse[turn, V_COUNT]):
            for k in range(9):
                direct.factors[direct.sparse[at, FILL], BESIDE + k] = 0.0
    firm = direct.factors[n, FIRM]
    for joint in range(direct.sparse[n, I_CONTACT], direct.sparse[n + 1, I_CONTACT]):
        b, m = direct.sparse[joint, C_BLOCK], direct.sparse[joint, C_LANE]
        row = constraints.blocks[b]
        state = direct.sparse[joint, C_STATE]
        direct.sparse[joint, C_BUILT] = state
        line, tangent = (row[R_NX + m], row[R_NY + m]), (-row[R_NY + m], row[R_NX + m])
        for k in range(constraints.lanes[b, POINTS]):
            at = SHARED + k * SIZE + m
            if (state >> k) & 1 == 1:
                add_row(
                    joint,
                    firm,
                    line,
                    row[at + P_ARM_A],
                    row[at + P_ARM_B],
                    direct.sparse,
                    direct.factors,
                )
        if state & RIGHT == HELD:
            at, last = SHARED + m, SHARED + (constraints.lanes[b, POINTS] - 1) * SIZE + m
            share = share_of(0, state, joint, direct.factors)
            side_a = turning_arm_both(row[at + P_SIDE_A], row[last + P_SIDE_A], share)
            side_b = turning_arm_both(row[at + P_SIDE_B], row[last + P_SIDE_B], share)
            add_row(joint, firm, tangent, side_a, side_b, direct.sparse, direct.factors)


def add_row(
    joint: int,
    firm: float,
    line: Vector,
    arm_a: float,
    arm_b: float,
    sparse: Integers,
    factors: Array,
) -> None:
    """Add one row of a joint to the equations."""
    one, other, link = sparse[joint, C_ONE], sparse[joint, C_OTHER], sparse[joint, C_EDGE]
    if one >= 0:
        if factors[one, NODE_INERTIA] == 0.0:
            arm_a = 0.0
        add_diagonal(one, firm, line, arm_a, factors)
    if other >= 0:
        if factors[other, NODE_INERTIA] == 0.0:
            arm_b = 0.0
        add_diagonal(other, firm, line, arm_b, factors)
    if link >= 0:
        early, late = arm_a, arm_b
        if sparse[link, E_ONE] != one:
            early, late = arm_b, arm_a
        add_off_diagonal(link, firm, line, early, late, factors)


def add_diagonal(knot: int, firm: float, line: Vector, arm: float, factors: Array) -> None:
    """Add a row to the block of a knot itself."""
    y_x, y_y = firm_mass_y(line, firm)
    turn_x, turn_y = firm_lever(line, arm, firm)
    factors[knot, DIAGONAL] += firm_mass_x(line, firm)[0]
    factors[knot, DIAGONAL + 1] += y_x
    factors[knot, DIAGONAL + 2] += y_y
    factors[knot, DIAGONAL + 3] += turn_x
    factors[knot, DIAGONAL + 4] += turn_y
    factors[knot, DIAGONAL + 5] += firm_inertia(arm, arm, firm)


@inlined
def add_off_diagonal(
    link: int, firm: float, line: Vector, early: float, late: float, factors: Array
) -> None:
    """Add a row to the block of a link, with its arms at the two knots."""
    x_x, x_y = firm_mass_x(line, firm)
    y_x, y_y = firm_mass_y(line, firm)
    x_turn, y_turn = firm_moment(line, early, firm)
    turn_x, turn_y = firm_lever(line, late, firm)
    factors[link, BESIDE] -= x_x
    factors[link, BESIDE + 1] -= x_y
    factors[link, BESIDE + 2] -= x_turn
    factors[link, BESIDE + 3] -= y_x
    factors[link, BESIDE + 4] -= y_y
    factors[link, BESIDE + 5] -= y_turn
    factors[link, BESIDE + 6] -= turn_x
    factors[link, BESIDE + 7] -= turn_y
    factors[link, BESIDE + 8] -= firm_inertia(early, late, firm)


def factor(n: int, sparse: Integers, factors: Array) -> bool:
    """Eliminate the knots of an island in turn; False where rounding leaves nothing of one."""
    for turn in range(sparse[n, I_NODE], sparse[n + 1, I_NODE]):
        knot, start, count = sparse[turn, V_NODE], sparse[turn, V_FIRST], sparse[turn, V_COUNT]
        d = factors[knot]
        if not d[0] > 0.0:
            return False
        a = 1.0 / sqrt(d[0])
        p, q = d[1] * a, d[3] * a
        second = d[2] - p * p
        if not second > 0.0:
            return False
        b = 1.0 / sqrt(second)
        r = (d[4] - q * p) * b
        third = d[5] - q * q - r * r
        if not third > 0.0:
            return False
        c = 1.0 / sqrt(third)
        d[0], d[1], d[2], d[3], d[4], d[5] = a, p, b, q, r, c
        for k in range(start, start + count):
            e = factors[sparse[k, FILL]]
            for m in range(3):
                at = BESIDE + 3 * m
                u = e[at] * a
                v = (e[at + 1] - u * p) * b
                e[at], e[at + 1], e[at + 2] = u, v, (e[at + 2] - u * q - v * r) * c
            d = factors[sparse[sparse[k, FILL], E_OTHER]]
            d[0] -= dot3(e, 0, e, 0)
            d[1] -= dot3(e, 1, e, 0)
            d[2] -= dot3(e, 1, e, 1)
            d[3] -= dot3(e, 2, e, 0)
            d[4] -= dot3(e, 2, e, 1)
            d[5] -= dot3(e, 2, e, 2)
        at = start + count
        for k in range(count):
            for m in range(k):
                one, other = sparse[start + k, FILL], sparse[start + m, FILL]
                link = sparse[at, FILL]
                if sparse[link, E_ONE] == sparse[one, E_OTHER]:
                    one, other = other, one
                f, g, e = factors[one], factors[other], factors[link]
                for i in range(3):
                    for j in range(3):
                        e[BESIDE + 3 * i + j] -= dot3(f, i, g, j)
                at += 1
    return True


def dot3(one: Array, i: int, other: Array, j: int) -> float:
    """Multiply a row of the block of one link with a row of another's."""
    i, j = BESIDE + 3 * i, BESIDE + 3 * j
    return one[i] * other[j] + one[i + 1] * other[j + 1] + one[i + 2] * other[j + 2]


def substitute(n: int, sparse: Integers, factors: Array) -> None:
    """Solve the eliminated equations of an island for the change of its velocities."""
    for turn in range(sparse[n, I_NODE], sparse[n + 1, I_NODE]):
        start = sparse[turn, V_FIRST]
        d = factors[sparse[turn, V_NODE]]
        x = d[CHANGE] * d[0]
        y = (d[CHANGE + 1] - d[1] * x) * d[2]
        z = (d[CHANGE + 2] - d[3] * x - d[4] * y) * d[5]
        d[CHANGE], d[CHANGE + 1], d[CHANGE + 2] = x, y, z
        for k in range(start, start + sparse[turn, V_COUNT]):
            e, d = factors[sparse[k, FILL]], factors[sparse[sparse[k, FILL], E_OTHER]]
            for m in range(3):
                at = BESIDE + 3 * m
                d[CHANGE + m] -= e[at] * x + e[at + 1] * y + e[at + 2] * z
    for turn in range(sparse[n + 1, I_NODE] - 1, sparse[n, I_NODE] - 1, -1):
        start = sparse[turn, V_FIRST]
        d = factors[sparse[turn, V_NODE]]
        x, y, z = d[CHANGE], d[CHANGE + 1], d[CHANGE + 2]
        for k in range(start, start + sparse[turn, V_COUNT]):
            e, f = factors[sparse[k, FILL]], factors[sparse[sparse[k, FILL], E_OTHER]]
            for m in range(3):
                at, by = BESIDE + 3 * m, f[CHANGE + m]
                x -= e[at] * by
                y -= e[at + 1] * by
                z -= e[at + 2] * by
        z = z * d[5]
        y = (y - d[4] * z) * d[2]
        x = (x - d[1] * y - d[3] * z) * d[0]
        d[CHANGE], d[CHANGE + 1], d[CHANGE + 2] = x, y, z


def share_of(k: int, state: int, joint: int, factors: Array) -> float:
    """Return the share of a point in what friction does at a joint."""
    if state & BOTH == BOTH:
        return factors[joint, SHARE] if k == 0 else 1.0 - factors[joint, SHARE]
    return 1.0 if (state >> k) & 1 == 1 else 0.0
