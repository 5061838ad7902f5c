"""The active set of a tree-like island: which points press, and where friction holds or slides.

A contact leaves its state only where that matters, by more than rounding, so that the iteration
does not go to and fro. Source: Rockafellar (1976), proximal point.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.direct.contacts import add_to_nodes, point_speed
from tamias2d.engine.tables import Bodies, Constraints, Direct, Integers
from tamias2d.generated.firm_contact import (
    accumulated_impulse_wanted,
    angular_momentum_left,
    momentum_left,
    normal_impulse_share,
    row_velocity_both,
    tangent_impulse_most,
    tangent_impulse_wanted,
)
from tamias2d.generated.soft_contact import surface_slip
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

SLIGHT = 1e-7  # of the largest impulse: no reason to leave a state
COARSE = 100.0  # times what counts as rounding, where the first try did not converge
SLIGHT_SPEED = 1e-5  # of the speed that it gives: rounding of a solution may close a gap so fast

# the state of a contact: a bit for each point that presses; with them, what friction does
BOTH = 3
LOOSE, HELD, LEFT, RIGHT = 0, 4, 8, 12  # nothing, hold, or slide to either side

INFINITE = 1e308
STATES_STAY, FRICTION_STAYS, ALL_CHANGE = 0, 1, 2  # choices


def guess_state(
    contact: int,
    anew: bool,
    slow: float,
    noise: float,
    constraints: Constraints,
    direct: Direct,
) -> float:
    """Guess the state of a contact, if it is not known; return its normal impulse.

    A point presses if it did, or if its velocity is off by no more than `slow`, m/s. Friction that
    slid goes on to, unless there was next to nothing, N s, that pressed: then it is by rounding.
    """
    b, m = direct.sparse[contact, tb.C_BLOCK], direct.sparse[contact, tb.C_LANE]
    row = constraints.blocks[b]
    normal = tangent = 0.0
    state = 0
    for k in range(constraints.lanes[b, tb.POINTS]):
        at = tb.SHARED + k * tb.POINT_SIZE + m
        if (
            row[at + tb.P_NORMAL_IMPULSE] > 0.0
            or direct.factors[contact, tb.SPEED_ERROR + k] <= slow
        ):
            state += 1 << k
        normal += row[at + tb.P_NORMAL_IMPULSE]
        tangent += row[at + tb.P_TANGENT_IMPULSE]
    limit = tangent_impulse_most(normal, row[tb.R_FRICTION + m])
    if state > 0 and row[tb.R_FRICTION + m] > 0.0:
        slides = normal > noise and abs(tangent) >= limit
        state += HELD if not slides else LEFT if tangent < 0.0 else RIGHT
    if anew:
        direct.sparse[contact, tb.C_STATE] = state
    return normal


def share_of(k: int, state: int, contact: int, factors: Array) -> float:
    """Return the share of a point in the friction of a contact."""
    if state & BOTH == BOTH:
        share = factors[contact, tb.FRICTION_SHARE]
        return share if k == 0 else 1.0 - share
    return 1.0 if (state >> k) & 1 == 1 else 0.0


def find_residual(
    n: int,
    choice: int,
    coarseness: float,
    bodies: Bodies,
    constraints: Constraints,
    direct: Direct,
) -> tuple[int, float]:
    """Propose impulses and states for an island; find the momentum that its nodes have left.

    Returns how many contacts have another state than in the matrix, and the largest residual as a
    part of the impulses, squared. By the choice all states stay, or only what friction does, or
    none. What is no reason to leave one is larger by the coarseness.
    """
    sparse, factors = direct.sparse, direct.factors
    for node in range(sparse[n, tb.I_NODE], sparse[n + 1, tb.I_NODE]):
        numbers, now = factors[node], bodies.motion[sparse[node, tb.N_BODY]]
        start = (numbers[tb.VELOCITY_START], numbers[tb.VELOCITY_START + 1])
        numbers[tb.CHANGE], numbers[tb.CHANGE + 1] = momentum_left(
            numbers[tb.NODE_MASS], start, (now[tb.VX], now[tb.VY])
        )
        numbers[tb.CHANGE + 2] = angular_momentum_left(
            numbers[tb.NODE_INERTIA], numbers[tb.VELOCITY_START + 2], now[tb.SPIN]
        )
    firm, scale = factors[n, tb.FIRM_MASS], coarseness * factors[n, tb.IMPULSE_SCALE]
    slight, closing = SLIGHT * scale, SLIGHT_SPEED * scale / factors[n, tb.LARGEST_MASS]
    changed = 0
    for contact in range(sparse[n, tb.I_CONTACT], sparse[n + 1, tb.I_CONTACT]):
        normal = propose_normal(
            contact, choice > STATES_STAY, firm, slight, closing, bodies, constraints, direct
        )
        propose_tangent(contact, choice, firm, slight, normal, bodies, constraints, direct)
        changed += 1 if sparse[contact, tb.C_STATE] != sparse[contact, tb.C_FACTORED] else 0
    return changed, largest_residual(n, sparse, factors)


@inlined
def largest_residual(n: int, sparse: Integers, factors: Array) -> float:
    """Return the largest momentum that a node has left, as a part of the impulses, squared.

    Angular momentum counts by what it is at the radius of gyration; what does not turn takes any,
    and none is left.
    """
    largest = 0.0
    for node in range(sparse[n, tb.I_NODE], sparse[n + 1, tb.I_NODE]):
        mass, inertia = factors[node, tb.NODE_MASS], factors[node, tb.NODE_INERTIA]
        if inertia == 0.0:
            factors[node, tb.CHANGE + 2] = 0.0
        x, y, turn = (
            factors[node, tb.CHANGE],
            factors[node, tb.CHANGE + 1],
            factors[node, tb.CHANGE + 2],
        )
        gyration = inertia / mass if mass > 0.0 else 0.0
        rim = turn * turn / gyration if gyration > 0.0 else 0.0
        largest = max(largest, x * x + y * y + rim)
    scale = factors[n, tb.IMPULSE_SCALE] * factors[n, tb.IMPULSE_SCALE]
    return largest / scale if scale > 0.0 else largest


@inlined
def propose_normal(
    contact: int,
    chooses: bool,
    firm: float,
    slight: float,
    closing: float,
    bodies: Bodies,
    constraints: Constraints,
    direct: Direct,
) -> float:
    """Propose the normal impulses of a contact, and which points press; return their sum, N s.

    One that does not press begins to where it closes faster than by rounding, `closing`, m/s.
    """
    sparse, factors = direct.sparse, direct.factors
    b, m, state = (
        sparse[contact, tb.C_BLOCK],
        sparse[contact, tb.C_LANE],
        sparse[contact, tb.C_STATE],
    )
    row, lane = constraints.blocks[b], constraints.lanes[b]
    one, other = bodies.motion[lane[tb.BODY_A + m]], bodies.motion[lane[tb.BODY_B + m]]
    normal = (row[tb.R_NX + m], row[tb.R_NY + m])
    now = 0
    total = 0.0
    for k in range(lane[tb.POINTS]):
        at = tb.SHARED + k * tb.POINT_SIZE + m
        before = row[at + tb.P_NORMAL_IMPULSE]
        arm_a, arm_b = row[at + tb.P_NORMAL_ARM_A], row[at + tb.P_NORMAL_ARM_B]
        speed = point_speed(one, other, arm_a, arm_b, normal)
        impulse = accumulated_impulse_wanted(before, speed, factors[contact, tb.BIAS + k], firm)
        presses = (state >> k) & 1
        if chooses:
            least = -slight if presses == 1 else max(slight, firm * closing)
            presses = 1 if impulse > least else 0
        impulse = impulse if presses == 1 else 0.0
        now += presses << k
        factors[contact, tb.NEW_NORMAL + k] = impulse
        total += max(impulse, 0.0)
        add_to_nodes(contact, impulse - before, arm_a, arm_b, normal, sparse, factors)
    sparse[contact, tb.C_STATE] = now + (state & RIGHT)
    return total


@inlined
def propose_tangent(
    contact: int,
    choice: int,
    firm: float,
    slight: float,
    normal: float,
    bodies: Bodies,
    constraints: Constraints,
    direct: Direct,
) -> None:
    """Propose the tangent impulses of a contact, and whether friction holds or slides.

    `normal` is the sum of its normal impulses, N s.
    """
    sparse, factors = direct.sparse, direct.factors
    b, m, state = (
        sparse[contact, tb.C_BLOCK],
        sparse[contact, tb.C_LANE],
        sparse[contact, tb.C_STATE],
    )
    row, points = constraints.blocks[b], constraints.lanes[b, tb.POINTS]
    tangent, friction = (-row[tb.R_NY + m], row[tb.R_NX + m]), row[tb.R_FRICTION + m]
    wanted = wanted_of_both(contact, firm, bodies, constraints, direct)
    limit = tangent_impulse_most(normal, friction)
    slides = state & RIGHT
    if choice == ALL_CHANGE:
        slides = friction_state(state, wanted, limit, slight, friction)
    elif choice == FRICTION_STAYS:
        slides = friction_kept(state, friction)
    total = 0.0
    if slides == HELD:
        total = wanted
    elif slides == LEFT:
        total = -limit
    elif slides == RIGHT:
        total = limit
    for k in range(points):
        at = tb.SHARED + k * tb.POINT_SIZE + m
        share = share_of(k, state, contact, factors)
        if slides > HELD:
            pressing = max(factors[contact, tb.NEW_NORMAL + k], 0.0)
            share = normal_impulse_share(pressing, normal) if normal > 0.0 else 0.0
        factors[contact, tb.NEW_TANGENT + k] = total * share
        more = total * share - row[at + tb.P_TANGENT_IMPULSE]
        arm_a, arm_b = row[at + tb.P_TANGENT_ARM_A], row[at + tb.P_TANGENT_ARM_B]
        add_to_nodes(contact, more, arm_a, arm_b, tangent, sparse, factors)
    sparse[contact, tb.C_STATE] = (state & BOTH) + slides


def wanted_of_both(
    contact: int, firm: float, bodies: Bodies, constraints: Constraints, direct: Direct
) -> float:
    """Return the tangent impulse with which a contact would not slip, N s."""
    b, m = direct.sparse[contact, tb.C_BLOCK], direct.sparse[contact, tb.C_LANE]
    row, before = constraints.blocks[b], 0.0
    for k in range(constraints.lanes[b, tb.POINTS]):
        before += row[tb.SHARED + k * tb.POINT_SIZE + tb.P_TANGENT_IMPULSE + m]
    speed = slip_of_both(contact, direct.sparse[contact, tb.C_STATE], bodies, constraints, direct)
    return tangent_impulse_wanted(before, speed, firm)


@inlined
def slip_of_both(
    contact: int, state: int, bodies: Bodies, constraints: Constraints, direct: Direct
) -> float:
    """Return at which speed a contact slips, m/s: that of its points by their shares."""
    b, m = direct.sparse[contact, tb.C_BLOCK], direct.sparse[contact, tb.C_LANE]
    row, lane = constraints.blocks[b], constraints.lanes[b]
    one, other = bodies.motion[lane[tb.BODY_A + m]], bodies.motion[lane[tb.BODY_B + m]]
    tangent, at = (-row[tb.R_NY + m], row[tb.R_NX + m]), tb.SHARED + m
    last = at + (lane[tb.POINTS] - 1) * tb.POINT_SIZE
    speed = row_velocity_both(
        point_speed(
            one, other, row[at + tb.P_TANGENT_ARM_A], row[at + tb.P_TANGENT_ARM_B], tangent
        ),
        point_speed(
            one, other, row[last + tb.P_TANGENT_ARM_A], row[last + tb.P_TANGENT_ARM_B], tangent
        ),
        share_of(0, state, contact, direct.factors),
    )
    return surface_slip(speed, row[tb.R_SURFACE_SPEED + m])


def friction_kept(state: int, friction: float) -> int:
    """Return what the friction of a contact goes on with: one that has begun to press holds."""
    if state & BOTH == 0 or not friction > 0.0:
        return LOOSE
    return max(state & RIGHT, HELD)


def friction_state(state: int, wanted: float, limit: float, slight: float, friction: float) -> int:
    """Return whether a contact holds, or where it slides to; it is slow to leave what it does."""
    if state & BOTH == 0 or not friction > 0.0:
        return LOOSE
    held = abs(wanted) < limit + (slight if state & RIGHT == HELD else -slight)
    reversed_sliding = state & RIGHT == (RIGHT if wanted < 0.0 else LEFT)
    return HELD if held or reversed_sliding else LEFT if wanted < 0.0 else RIGHT


def change_worst_friction(n: int, bodies: Bodies, constraints: Constraints, direct: Direct) -> bool:
    """Let a contact of an island slide that holds by most more than friction can; is there one?

    One that slides the other way by now holds, before all others slide.
    """
    sparse, factors = direct.sparse, direct.factors
    worst, which, to = 0.0, -1, LOOSE
    for contact in range(sparse[n, tb.I_CONTACT], sparse[n + 1, tb.I_CONTACT]):
        b, m = sparse[contact, tb.C_BLOCK], sparse[contact, tb.C_LANE]
        state, friction = sparse[contact, tb.C_STATE], constraints.blocks[b, tb.R_FRICTION + m]
        normal = 0.0
        for k in range(constraints.lanes[b, tb.POINTS]):
            normal += max(factors[contact, tb.NEW_NORMAL + k], 0.0)
        wanted = wanted_of_both(contact, factors[n, tb.FIRM_MASS], bodies, constraints, direct)
        slight = COARSE * SLIGHT * factors[n, tb.IMPULSE_SCALE]
        limit = tangent_impulse_most(normal, friction)
        chosen = friction_state(state, wanted, limit, slight, friction)
        share = abs(wanted) / (limit + slight) if chosen > HELD else INFINITE
        if chosen != state & RIGHT and share > worst:
            worst, which, to = share, contact, chosen
    if which >= 0:
        sparse[which, tb.C_STATE] = (sparse[which, tb.C_STATE] & BOTH) + to
    return which >= 0
