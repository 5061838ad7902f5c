"""The active set of a thin island: which of its contacts push, and which hold or slide.

Serves: the direct solver. Hides: that a contact changes its mind only where that matters, so that
rounding does not make it go to and fro.
"""

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
from tamias2d.stepped.elimination import (
    ASKED,
    BIAS,
    BOTH,
    CHANGE,
    FIRM,
    HELD,
    INERTIA,
    LEFT,
    LOOSE,
    MASS,
    RIGHT,
    SCALE,
    START,
    share_of,
)
from tamias2d.stepped.joints import (
    load_knots,
    speed_of,
)
from tamias2d.stepped.layout import (
    SPIN,
    VX,
    VY,
    Whole,
)
from tamias2d.stepped.rows import (
    BODY_A,
    BODY_B,
    P_ARM_A,
    P_ARM_B,
    P_PUSH,
    P_RUB,
    P_SIDE_A,
    P_SIDE_B,
    POINTS,
    R_FRICTION,
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
    J_STATE,
    K_BODY,
)

SLIGHT = 1e-7  # of the largest push: no reason to correct


def guess(
    joint: int,
    relaxing: bool,
    slow: float,
    rows: Array,
    lanes: Whole,
    web: Whole,
    weave: Array,
) -> float:
    """Say what the points of a joint may do, unless that is known; return its larger push."""
    b, m = web[joint, J_BLOCK], web[joint, J_LANE]
    row = rows[b]
    pushes = rubs = 0.0
    state = 0
    for k in range(lanes[b, POINTS]):
        at = SHARED + k * SIZE + m
        if row[at + P_PUSH] > 0.0 or weave[joint, ASKED + k] <= slow:
            state += 1 << k
        pushes, rubs = pushes + row[at + P_PUSH], rubs + row[at + P_RUB]
    limit = rub_most(pushes, row[R_FRICTION + m])
    if state > 0 and row[R_FRICTION + m] > 0.0:
        slides = pushes > 0.0 and abs(rubs) >= limit
        state += HELD if not slides else LEFT if rubs < 0.0 else RIGHT
    if not relaxing:
        web[joint, J_STATE] = state
    return pushes


def balance(
    n: int,
    first: bool,
    rows: Array,
    lanes: Whole,
    motion: Array,
    web: Whole,
    weave: Array,
) -> tuple[int, float]:
    """Find what is left of the equations of an island, and what its points do now.

    Returns how many joints differ from what was eliminated, and what is left as a part of the
    pushes, both squared.
    """
    for knot in range(web[n, I_KNOT], web[n + 1, I_KNOT]):
        i = web[knot, K_BODY]
        mass, inertia = weave[knot, MASS], weave[knot, INERTIA]
        start, now = weave[knot, START:], motion[i]
        weave[knot, CHANGE], weave[knot, CHANGE + 1] = momentum_left(
            mass, (start[0], start[1]), (now[VX], now[VY])
        )
        weave[knot, CHANGE + 2] = angular_momentum_left(inertia, start[2], now[SPIN])
    slight = SLIGHT * weave[n, SCALE]
    changed = 0
    for joint in range(web[n, I_JOINT], web[n + 1, I_JOINT]):
        ask(joint, first, weave[n, FIRM], slight, rows, lanes, motion, web, weave)
        changed += 1 if web[joint, J_STATE] != web[joint, J_BUILT] else 0
    return changed, left_over(n, web, weave)


@inlined
def left_over(n: int, web: Whole, weave: Array) -> float:
    """Return the largest momentum that a body has left, as a part of the pushes, squared.

    Angular momentum counts by what it is at the radius of gyration.
    """
    left = 0.0
    for knot in range(web[n, I_KNOT], web[n + 1, I_KNOT]):
        x, y, turn = weave[knot, CHANGE], weave[knot, CHANGE + 1], weave[knot, CHANGE + 2]
        mass, inertia = weave[knot, MASS], weave[knot, INERTIA]
        lever = inertia / mass if mass > 0.0 else 0.0
        left = max(left, x * x + y * y + (turn * turn / lever if lever > 0.0 else 0.0))
    scale = weave[n, SCALE] * weave[n, SCALE]
    return left / scale if scale > 0.0 else left


@inlined
def ask(
    joint: int,
    first: bool,
    firm: float,
    slight: float,
    rows: Array,
    lanes: Whole,
    motion: Array,
    web: Whole,
    weave: Array,
) -> None:
    """Ask a joint for its impulses, and add to its knots what is new in them."""
    pushes = ask_pushes(joint, first, firm, slight, rows, lanes, motion, web, weave)
    ask_rubs(joint, first, firm, slight, pushes, rows, lanes, motion, web, weave)


@inlined
def ask_pushes(
    joint: int,
    first: bool,
    firm: float,
    slight: float,
    rows: Array,
    lanes: Whole,
    motion: Array,
    web: Whole,
    weave: Array,
) -> float:
    """Ask the points of a joint for their pushes, and which of them push; return the sum."""
    b, m = web[joint, J_BLOCK], web[joint, J_LANE]
    row = rows[b]
    one, other = motion[lanes[b, BODY_A + m]], motion[lanes[b, BODY_B + m]]
    line = (row[R_NX + m], row[R_NY + m])
    state = web[joint, J_STATE]
    now = 0
    pushes = 0.0
    for k in range(lanes[b, POINTS]):
        at = SHARED + k * SIZE
        before = row[at + P_PUSH + m]
        speed = speed_of(m, at, row, one, other, P_ARM_A, P_ARM_B, line)
        push = push_wanted(before, speed, weave[joint, BIAS + k], firm)
        pushing = (state >> k) & 1
        if not first:
            pushing = 1 if push > (-slight if pushing == 1 else slight) else 0
        push = push if pushing == 1 else 0.0
        now += pushing << k
        weave[joint, ASKED + k] = push
        pushes += max(push, 0.0)
        load_knots(joint, m, at, P_ARM_A, P_ARM_B, push - before, line, row, web, weave)
    web[joint, J_STATE] = now + (state & RIGHT)
    return pushes


@inlined
def ask_rubs(
    joint: int,
    first: bool,
    firm: float,
    slight: float,
    pushes: float,
    rows: Array,
    lanes: Whole,
    motion: Array,
    web: Whole,
    weave: Array,
) -> None:
    """Ask a joint for its rub, and what friction does there; its points take their shares."""
    b, m = web[joint, J_BLOCK], web[joint, J_LANE]
    row = rows[b]
    one, other = motion[lanes[b, BODY_A + m]], motion[lanes[b, BODY_B + m]]
    tangent = (-row[R_NY + m], row[R_NX + m])
    state = web[joint, J_STATE]
    last = SHARED + (lanes[b, POINTS] - 1) * SIZE
    side = row_velocity_both(
        speed_of(m, SHARED, row, one, other, P_SIDE_A, P_SIDE_B, tangent),
        speed_of(m, last, row, one, other, P_SIDE_A, P_SIDE_B, tangent),
        share_of(0, state, joint, weave),
    )
    rubs = 0.0
    for k in range(lanes[b, POINTS]):
        rubs += row[SHARED + k * SIZE + P_RUB + m]
    wanted, most = rub_wanted(rubs, side, firm), rub_most(pushes, row[R_FRICTION + m])
    does = state & RIGHT
    if not first:
        does = what_friction_does(state, wanted, most, slight, row[R_FRICTION + m])
    rub = 0.0
    if does == HELD:
        rub = wanted
    elif does == LEFT:
        rub = -most
    elif does == RIGHT:
        rub = most
    for k in range(lanes[b, POINTS]):
        at = SHARED + k * SIZE
        part = share_of(k, state, joint, weave)
        if does > HELD:
            push = max(weave[joint, ASKED + k], 0.0)
            part = push_share(push, pushes) if pushes > 0.0 else 0.0
        weave[joint, ASKED + 2 + k] = rub * part
        more = rub * part - row[at + P_RUB + m]
        load_knots(joint, m, at, P_SIDE_A, P_SIDE_B, more, tangent, row, web, weave)
    web[joint, J_STATE] = (state & BOTH) + does


def what_friction_does(
    state: int, wanted: float, most: float, slight: float, friction: float
) -> int:
    """Return whether a joint holds, or where it slides to; it is slow to leave what it does."""
    if state & BOTH == 0 or not friction > 0.0:
        return LOOSE
    held = abs(wanted) < most + (slight if state & RIGHT == HELD else -slight)
    turned = state & RIGHT == (RIGHT if wanted < 0.0 else LEFT)
    return HELD if held or turned else LEFT if wanted < 0.0 else RIGHT
