"""The active set of a thin island: which of its contacts push, and which hold or slide.

Serves: the direct solver. Hides: that a contact changes its mind only where that matters, so that
rounding does not make it go to and fro.
"""

from tamias2d.engine.direct.cholesky import BOTH, HELD, LEFT, LOOSE, RIGHT, share_of
from tamias2d.engine.direct.contacts import add_to_nodes, row_speed
from tamias2d.engine.tables import (
    ASKED,
    BIAS,
    BODY_A,
    BODY_B,
    C_BLOCK,
    C_BUILT,
    C_LANE,
    C_STATE,
    CHANGE,
    FIRM,
    I_CONTACT,
    I_NODE,
    N_BODY,
    NODE_INERTIA,
    NODE_MASS,
    P_ARM_A,
    P_ARM_B,
    P_NORMAL,
    P_SIDE_A,
    P_SIDE_B,
    P_TANGENT,
    POINTS,
    R_FRICTION,
    R_NX,
    R_NY,
    SCALE,
    SHARED,
    SIZE,
    SPIN,
    START,
    VX,
    VY,
    Bodies,
    Constraints,
    Direct,
    Integers,
)
from tamias2d.generated.firm_contact import (
    angular_momentum_left,
    momentum_left,
    push_share,
    push_wanted,
    row_velocity_both,
    rub_most,
    rub_wanted,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

SLIGHT = 1e-7  # of the largest push: no reason to correct


def guess_state(
    joint: int, relaxing: bool, slow: float, constraints: Constraints, direct: Direct
) -> float:
    """Say what the points of a joint may do, unless that is known; return its larger push."""
    b, m = direct.sparse[joint, C_BLOCK], direct.sparse[joint, C_LANE]
    row = constraints.blocks[b]
    pushes = rubs = 0.0
    state = 0
    for k in range(constraints.lanes[b, POINTS]):
        at = SHARED + k * SIZE + m
        if row[at + P_NORMAL] > 0.0 or direct.factors[joint, ASKED + k] <= slow:
            state += 1 << k
        pushes, rubs = pushes + row[at + P_NORMAL], rubs + row[at + P_TANGENT]
    limit = rub_most(pushes, row[R_FRICTION + m])
    if state > 0 and row[R_FRICTION + m] > 0.0:
        slides = pushes > 0.0 and abs(rubs) >= limit
        state += HELD if not slides else LEFT if rubs < 0.0 else RIGHT
    if not relaxing:
        direct.sparse[joint, C_STATE] = state
    return pushes


def find_residual(
    n: int, first: bool, bodies: Bodies, constraints: Constraints, direct: Direct
) -> tuple[int, float]:
    """Find what is left of the equations of an island, and what its points do now.

    Returns how many joints differ from what was eliminated, and what is left as a part of the
    pushes, both squared.
    """
    for knot in range(direct.sparse[n, I_NODE], direct.sparse[n + 1, I_NODE]):
        i = direct.sparse[knot, N_BODY]
        mass, inertia = direct.factors[knot, NODE_MASS], direct.factors[knot, NODE_INERTIA]
        start, now = direct.factors[knot, START:], bodies.motion[i]
        direct.factors[knot, CHANGE], direct.factors[knot, CHANGE + 1] = momentum_left(
            mass, (start[0], start[1]), (now[VX], now[VY])
        )
        direct.factors[knot, CHANGE + 2] = angular_momentum_left(inertia, start[2], now[SPIN])
    slight = SLIGHT * direct.factors[n, SCALE]
    changed = 0
    for joint in range(direct.sparse[n, I_CONTACT], direct.sparse[n + 1, I_CONTACT]):
        ask_contact(joint, first, direct.factors[n, FIRM], slight, bodies, constraints, direct)
        changed += 1 if direct.sparse[joint, C_STATE] != direct.sparse[joint, C_BUILT] else 0
    return changed, largest_residual(n, direct.sparse, direct.factors)


@inlined
def largest_residual(n: int, sparse: Integers, factors: Array) -> float:
    """Return the largest momentum that a body has left, as a part of the pushes, squared.

    Angular momentum counts by what it is at the radius of gyration.
    """
    left = 0.0
    for knot in range(sparse[n, I_NODE], sparse[n + 1, I_NODE]):
        x, y, turn = factors[knot, CHANGE], factors[knot, CHANGE + 1], factors[knot, CHANGE + 2]
        mass, inertia = factors[knot, NODE_MASS], factors[knot, NODE_INERTIA]
        lever = inertia / mass if mass > 0.0 else 0.0
        left = max(left, x * x + y * y + (turn * turn / lever if lever > 0.0 else 0.0))
    scale = factors[n, SCALE] * factors[n, SCALE]
    return left / scale if scale > 0.0 else left


@inlined
def ask_contact(
    joint: int,
    first: bool,
    firm: float,
    slight: float,
    bodies: Bodies,
    constraints: Constraints,
    direct: Direct,
) -> None:
    """Ask a joint for its impulses, and add to its knots what is new in them."""
    pushes = ask_normal(joint, first, firm, slight, bodies, constraints, direct)
    ask_tangent(joint, first, firm, slight, pushes, bodies, constraints, direct)


@inlined
def ask_normal(
    joint: int,
    first: bool,
    firm: float,
    slight: float,
    bodies: Bodies,
    constraints: Constraints,
    direct: Direct,
) -> float:
    """Ask the points of a joint for their pushes, and which of them push; return the sum."""
    b, m = direct.sparse[joint, C_BLOCK], direct.sparse[joint, C_LANE]
    row = constraints.blocks[b]
    one, other = (
        bodies.motion[constraints.lanes[b, BODY_A + m]],
        bodies.motion[constraints.lanes[b, BODY_B + m]],
    )
    line = (row[R_NX + m], row[R_NY + m])
    state = direct.sparse[joint, C_STATE]
    now = 0
    pushes = 0.0
    for k in range(constraints.lanes[b, POINTS]):
        at = SHARED + k * SIZE
        before = row[at + P_NORMAL + m]
        speed = row_speed(m, at, row, one, other, P_ARM_A, P_ARM_B, line)
        push = push_wanted(before, speed, direct.factors[joint, BIAS + k], firm)
        pushing = (state >> k) & 1
        if not first:
            pushing = 1 if push > (-slight if pushing == 1 else slight) else 0
        push = push if pushing == 1 else 0.0
        now += pushing << k
        direct.factors[joint, ASKED + k] = push
        pushes += max(push, 0.0)
        add_to_nodes(
            joint, m, at, P_ARM_A, P_ARM_B, push - before, line, row, direct.sparse, direct.factors
        )
    direct.sparse[joint, C_STATE] = now + (state & RIGHT)
    return pushes


@inlined
def ask_tangent(
    joint: int,
    first: bool,
    firm: float,
    slight: float,
    pushes: float,
    bodies: Bodies,
    constraints: Constraints,
    direct: Direct,
) -> None:
    """Ask a joint for its rub, and what friction does there; its points take their shares."""
    b, m = direct.sparse[joint, C_BLOCK], direct.sparse[joint, C_LANE]
    row = constraints.blocks[b]
    one, other = (
        bodies.motion[constraints.lanes[b, BODY_A + m]],
        bodies.motion[constraints.lanes[b, BODY_B + m]],
    )
    tangent = (-row[R_NY + m], row[R_NX + m])
    state = direct.sparse[joint, C_STATE]
    last = SHARED + (constraints.lanes[b, POINTS] - 1) * SIZE
    side = row_velocity_both(
        row_speed(m, SHARED, row, one, other, P_SIDE_A, P_SIDE_B, tangent),
        row_speed(m, last, row, one, other, P_SIDE_A, P_SIDE_B, tangent),
        share_of(0, state, joint, direct.factors),
    )
    rubs = 0.0
    for k in range(constraints.lanes[b, POINTS]):
        rubs += row[SHARED + k * SIZE + P_TANGENT + m]
    wanted, most = rub_wanted(rubs, side, firm), rub_most(pushes, row[R_FRICTION + m])
    does = state & RIGHT
    if not first:
        does = friction_state(state, wanted, most, slight, row[R_FRICTION + m])
    rub = 0.0
    if does == HELD:
        rub = wanted
    elif does == LEFT:
        rub = -most
    elif does == RIGHT:
        rub = most
    for k in range(constraints.lanes[b, POINTS]):
        at = SHARED + k * SIZE
        part = share_of(k, state, joint, direct.factors)
        if does > HELD:
            push = max(direct.factors[joint, ASKED + k], 0.0)
            part = push_share(push, pushes) if pushes > 0.0 else 0.0
        direct.factors[joint, ASKED + 2 + k] = rub * part
        more = rub * part - row[at + P_TANGENT + m]
        add_to_nodes(
            joint, m, at, P_SIDE_A, P_SIDE_B, more, tangent, row, direct.sparse, direct.factors
        )
    direct.sparse[joint, C_STATE] = (state & BOTH) + does


def friction_state(state: int, wanted: float, most: float, slight: float, friction: float) -> int:
    """Return whether a joint holds, or where it slides to; it is slow to leave what it does."""
    if state & BOTH == 0 or not friction > 0.0:
        return LOOSE
    held = abs(wanted) < most + (slight if state & RIGHT == HELD else -slight)
    turned = state & RIGHT == (RIGHT if wanted < 0.0 else LEFT)
    return HELD if held or turned else LEFT if wanted < 0.0 else RIGHT
