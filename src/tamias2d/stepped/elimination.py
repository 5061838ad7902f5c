"""The equations of thin islands, written and eliminated.

Serves: the direct solver. Hides: how blocks of three by three are kept, one of each body and one of
each link, and what rounding makes of them.

Each contact that holds is like a very large mass which resists its velocity, and is added to the
masses of the bodies (DD33). What comes out is symmetric and positive, so that a triangle and its
mirror image take its place (Cholesky).

Source: George and Liu (1981).
"""

from math import sqrt

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
from tamias2d.stepped.layout import Whole
from tamias2d.stepped.rows import (
    P_ARM_A,
    P_ARM_B,
    P_SIDE_A,
    P_SIDE_B,
    POINTS,
    R_NX,
    R_NY,
    SHARED,
    SIZE,
)
from tamias2d.stepped.thin import (
    I_JOINT,
    I_KNOT,
    J_BLOCK,
    J_BUILT,
    J_LANE,
    J_LINK,
    J_ONE,
    J_OTHER,
    J_STATE,
    L_ONE,
    L_OTHER,
    T_COUNT,
    T_FIRST,
    T_KNOT,
    TAPE,
)

BOTH = 3  # points of a joint that push, one bit each; with them, what friction does:
LOOSE, HELD, LEFT, RIGHT = 0, 4, 8, 12  # nothing, hold, or slide

# weave: columns of numbers beside those of the web
DIAGONAL = 0  # of a knot, six numbers of a lower triangle
CHANGE, START, MASS, INERTIA = 6, 9, 12, 13
BESIDE = 14  # of a link, nine numbers: rows of the later knot, columns of the earlier
BIAS = 23  # of a joint, of both points
ASKED = 25  # pushes and rubs of both points
SOFT = 29  # what the sweeps take of the joint: bias rate, mass share, impulse share
FIRM, SCALE = 32, 33  # of an island; the second an impulse, N s, beside which others are judged
HEAVIEST = 35
SHARE = 34  # of a joint: of its first point in what friction does
WEAVE = 36


def assemble(n: int, rows: Array, lanes: Whole, web: Whole, weave: Array) -> None:
    """Write the equations of an island."""
    for turn in range(web[n, I_KNOT], web[n + 1, I_KNOT]):
        knot, start = web[turn, T_KNOT], web[turn, T_FIRST]
        mass, inertia = weave[knot, MASS], weave[knot, INERTIA]
        for k in range(6):
            weave[knot, DIAGONAL + k] = 0.0
        weave[knot, DIAGONAL] = weave[knot, DIAGONAL + 2] = mass if mass > 0.0 else 1.0
        weave[knot, DIAGONAL + 5] = inertia if inertia > 0.0 else 1.0
        for at in range(start, start + web[turn, T_COUNT]):
            for k in range(9):
                weave[web[at, TAPE], BESIDE + k] = 0.0
    firm = weave[n, FIRM]
    for joint in range(web[n, I_JOINT], web[n + 1, I_JOINT]):
        b, m = web[joint, J_BLOCK], web[joint, J_LANE]
        row = rows[b]
        state = web[joint, J_STATE]
        web[joint, J_BUILT] = state
        line, tangent = (row[R_NX + m], row[R_NY + m]), (-row[R_NY + m], row[R_NX + m])
        for k in range(lanes[b, POINTS]):
            at = SHARED + k * SIZE + m
            if (state >> k) & 1 == 1:
                stiffen(joint, firm, line, row[at + P_ARM_A], row[at + P_ARM_B], web, weave)
        if state & RIGHT == HELD:
            at, last = SHARED + m, SHARED + (lanes[b, POINTS] - 1) * SIZE + m
            share = share_of(0, state, joint, weave)
            side_a = turning_arm_both(row[at + P_SIDE_A], row[last + P_SIDE_A], share)
            side_b = turning_arm_both(row[at + P_SIDE_B], row[last + P_SIDE_B], share)
            stiffen(joint, firm, tangent, side_a, side_b, web, weave)


def stiffen(
    joint: int, firm: float, line: Vector, arm_a: float, arm_b: float, web: Whole, weave: Array
) -> None:
    """Add one row of a joint to the equations."""
    one, other, link = web[joint, J_ONE], web[joint, J_OTHER], web[joint, J_LINK]
    if one >= 0:
        if weave[one, INERTIA] == 0.0:
            arm_a = 0.0
        add_square(one, firm, line, arm_a, weave)
    if other >= 0:
        if weave[other, INERTIA] == 0.0:
            arm_b = 0.0
        add_square(other, firm, line, arm_b, weave)
    if link >= 0:
        early, late = arm_a, arm_b
        if web[link, L_ONE] != one:
            early, late = arm_b, arm_a
        add_beside(link, firm, line, early, late, weave)


def add_square(knot: int, firm: float, line: Vector, arm: float, weave: Array) -> None:
    """Add a row to the block of a knot itself."""
    y_x, y_y = firm_mass_y(line, firm)
    turn_x, turn_y = firm_lever(line, arm, firm)
    weave[knot, DIAGONAL] += firm_mass_x(line, firm)[0]
    weave[knot, DIAGONAL + 1] += y_x
    weave[knot, DIAGONAL + 2] += y_y
    weave[knot, DIAGONAL + 3] += turn_x
    weave[knot, DIAGONAL + 4] += turn_y
    weave[knot, DIAGONAL + 5] += firm_inertia(arm, arm, firm)


@inlined
def add_beside(
    link: int, firm: float, line: Vector, early: float, late: float, weave: Array
) -> None:
    """Add a row to the block of a link, with its arms at the two knots."""
    x_x, x_y = firm_mass_x(line, firm)
    y_x, y_y = firm_mass_y(line, firm)
    x_turn, y_turn = firm_moment(line, early, firm)
    turn_x, turn_y = firm_lever(line, late, firm)
    weave[link, BESIDE] -= x_x
    weave[link, BESIDE + 1] -= x_y
    weave[link, BESIDE + 2] -= x_turn
    weave[link, BESIDE + 3] -= y_x
    weave[link, BESIDE + 4] -= y_y
    weave[link, BESIDE + 5] -= y_turn
    weave[link, BESIDE + 6] -= turn_x
    weave[link, BESIDE + 7] -= turn_y
    weave[link, BESIDE + 8] -= firm_inertia(early, late, firm)


def factor(n: int, web: Whole, weave: Array) -> bool:
    """Eliminate the knots of an island in turn; False where rounding leaves nothing of one."""
    for turn in range(web[n, I_KNOT], web[n + 1, I_KNOT]):
        knot, start, count = web[turn, T_KNOT], web[turn, T_FIRST], web[turn, T_COUNT]
        d = weave[knot]
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
            e = weave[web[k, TAPE]]
            for m in range(3):
                at = BESIDE + 3 * m
                u = e[at] * a
                v = (e[at + 1] - u * p) * b
                e[at], e[at + 1], e[at + 2] = u, v, (e[at + 2] - u * q - v * r) * c
            d = weave[web[web[k, TAPE], L_OTHER]]
            d[0] -= dot3(e, 0, e, 0)
            d[1] -= dot3(e, 1, e, 0)
            d[2] -= dot3(e, 1, e, 1)
            d[3] -= dot3(e, 2, e, 0)
            d[4] -= dot3(e, 2, e, 1)
            d[5] -= dot3(e, 2, e, 2)
        at = start + count
        for k in range(count):
            for m in range(k):
                one, other = web[start + k, TAPE], web[start + m, TAPE]
                link = web[at, TAPE]
                if web[link, L_ONE] == web[one, L_OTHER]:
                    one, other = other, one
                f, g, e = weave[one], weave[other], weave[link]
                for i in range(3):
                    for j in range(3):
                        e[BESIDE + 3 * i + j] -= dot3(f, i, g, j)
                at += 1
    return True


def dot3(one: Array, i: int, other: Array, j: int) -> float:
    """Multiply a row of the block of one link with a row of another's."""
    i, j = BESIDE + 3 * i, BESIDE + 3 * j
    return one[i] * other[j] + one[i + 1] * other[j + 1] + one[i + 2] * other[j + 2]


def substitute(n: int, web: Whole, weave: Array) -> None:
    """Solve the eliminated equations of an island for the change of its velocities."""
    for turn in range(web[n, I_KNOT], web[n + 1, I_KNOT]):
        start = web[turn, T_FIRST]
        d = weave[web[turn, T_KNOT]]
        x = d[CHANGE] * d[0]
        y = (d[CHANGE + 1] - d[1] * x) * d[2]
        z = (d[CHANGE + 2] - d[3] * x - d[4] * y) * d[5]
        d[CHANGE], d[CHANGE + 1], d[CHANGE + 2] = x, y, z
        for k in range(start, start + web[turn, T_COUNT]):
            e, d = weave[web[k, TAPE]], weave[web[web[k, TAPE], L_OTHER]]
            for m in range(3):
                at = BESIDE + 3 * m
                d[CHANGE + m] -= e[at] * x + e[at + 1] * y + e[at + 2] * z
    for turn in range(web[n + 1, I_KNOT] - 1, web[n, I_KNOT] - 1, -1):
        start = web[turn, T_FIRST]
        d = weave[web[turn, T_KNOT]]
        x, y, z = d[CHANGE], d[CHANGE + 1], d[CHANGE + 2]
        for k in range(start, start + web[turn, T_COUNT]):
            e, f = weave[web[k, TAPE]], weave[web[web[k, TAPE], L_OTHER]]
            for m in range(3):
                at, by = BESIDE + 3 * m, f[CHANGE + m]
                x -= e[at] * by
                y -= e[at + 1] * by
                z -= e[at + 2] * by
        z = z * d[5]
        y = (y - d[4] * z) * d[2]
        x = (x - d[1] * y - d[3] * z) * d[0]
        d[CHANGE], d[CHANGE + 1], d[CHANGE + 2] = x, y, z


def share_of(k: int, state: int, joint: int, weave: Array) -> float:
    """Return the share of a point in what friction does at a joint."""
    if state & BOTH == BOTH:
        return weave[joint, SHARE] if k == 0 else 1.0 - weave[joint, SHARE]
    return 1.0 if (state >> k) & 1 == 1 else 0.0
