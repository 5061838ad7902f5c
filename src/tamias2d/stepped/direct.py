"""Thin islands solved at once: all their contacts together, instead of one after the other.

Serves: a step. Hides: the active set and the elimination.

Every contact is asked for the push that it has and what its velocity, times a large mass, would
add. With the velocities unknown this is a linear system over the bodies of the island; which
contacts push, and which hold by friction, is tried, solved and corrected until it fits. Pushes that
come out are never negative and rubs never too large, and what does not fit is left as it was.

Source: Rockafellar (1976), proximal point; George and Liu (1981), elimination of sparse systems.
"""

from math import sqrt

from tamias2d.generated.definitions import angular_momentum_own, momentum
from tamias2d.generated.firm_contact import (
    bias_energy,
    linear_energy,
    linear_energy_start,
    push_share,
    turning_energy,
    turning_energy_start,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array
from tamias2d.stepped.active_set import (
    balance,
    guess,
)
from tamias2d.stepped.elimination import (
    CHANGE,
    FIRM,
    HEAVIEST,
    INERTIA,
    MASS,
    SCALE,
    SHARE,
    SOFT,
    START,
    assemble,
    factor,
    substitute,
)
from tamias2d.stepped.joints import (
    apply_joint,
    harden,
    keep_joint,
    leave_room,
    load_knots,
    open_joint,
)
from tamias2d.stepped.layout import (
    INVERSE_INERTIA,
    INVERSE_MASS,
    SPIN,
    VX,
    VY,
    Whole,
)
from tamias2d.stepped.rows import (
    P_ARM_A,
    P_ARM_B,
    P_PUSH,
    P_RUB,
    P_SIDE_A,
    P_SIDE_B,
    POINTS,
    R_BIAS,
    R_KEEP,
    R_NX,
    R_NY,
    R_SHARE,
    SHARED,
    SIZE,
)
from tamias2d.stepped.thin import (
    I_FRESH,
    I_JOINT,
    I_KNOT,
    J_BLOCK,
    J_LANE,
    K_BODY,
)

STIFF = 1e9  # of a contact, in masses between the heaviest and the lightest of its island
REMOVED = 0.2  # of an overlap, removed in a substep
CORRECTIONS = 12  # corrections of what pushes and what holds
NEARLY = 1e-3  # of the fastest point: what is slower to part may push
CLOSE_ENOUGH = 1e-10  # what may be left of the equations, as a part of the pushes, both squared
STILL_GOOD = 1e-6  # more than this is not taken
WILD = 100.0  # nor pushes so many times what there is to stop, for each contact
LIVELY = 1.0 + 1e-9  # nor what gives the bodies more energy, but for rounding
LEFT_ALONE = -1


def ready(
    first: int, last: int, body: Array, rows: Array, lanes: Whole, web: Whole, weave: Array
) -> None:
    """Note the masses of the knots of some islands, and how soft their joints are."""
    for n in range(first, last):
        heaviest = lightest = 0.0
        for knot in range(web[n, I_KNOT], web[n + 1, I_KNOT]):
            i = web[knot, K_BODY]
            mass, inertia = body[i, INVERSE_MASS], body[i, INVERSE_INERTIA]
            weave[knot, MASS] = 1.0 / mass if mass > 0.0 else 0.0
            weave[knot, INERTIA] = 1.0 / inertia if inertia > 0.0 else 0.0
            mass = weave[knot, MASS]
            heaviest = max(heaviest, mass)
            lightest = min(lightest, mass) if lightest > 0.0 else mass
        weave[n, HEAVIEST] = heaviest
        weave[n, FIRM] = STIFF * sqrt(heaviest * lightest)
        web[n, I_FRESH] = 0
        for joint in range(web[n, I_JOINT], web[n + 1, I_JOINT]):
            row, m = rows[web[joint, J_BLOCK]], web[joint, J_LANE]
            weave[joint, SOFT], weave[joint, SOFT + 1] = row[R_BIAS + m], row[R_SHARE + m]
            weave[joint, SOFT + 2] = row[R_KEEP + m]
            first, second = row[SHARED + P_PUSH + m], row[SHARED + SIZE + P_PUSH + m]
            both = lanes[web[joint, J_BLOCK], POINTS] == 2 and first + second > 0.0
            weave[joint, SHARE] = push_share(first, first + second) if both else 0.5


def settle_islands(
    relaxing: bool,
    first: int,
    last: int,
    substep: float,
    rows: Array,
    lanes: Whole,
    motion: Array,
    web: Whole,
    weave: Array,
) -> None:
    """Solve some thin islands, with the speed that removes overlap, or to take that out again."""
    for n in range(first, last):
        if web[n, I_FRESH] != LEFT_ALONE:
            settle_island(n, relaxing, substep, rows, lanes, motion, web, weave)


@inlined
def settle_island(
    n: int,
    relaxing: bool,
    substep: float,
    rows: Array,
    lanes: Whole,
    motion: Array,
    web: Whole,
    weave: Array,
) -> None:
    """Solve an island and keep what is found, or leave it to the sweeps from now on."""
    rate = REMOVED / substep
    joints = range(web[n, I_JOINT], web[n + 1, I_JOINT])
    fastest = apart = largest = 0.0
    for joint in joints:
        speed, bias = open_joint(joint, relaxing, substep, rate, rows, lanes, motion, web, weave)
        fastest, apart = max(fastest, speed), apart - bias
    for joint in joints:
        largest = max(largest, guess(joint, relaxing, NEARLY * fastest, rows, lanes, web, weave))
    weave[n, SCALE] = largest + weave[n, HEAVIEST] * fastest
    before = set_out(n, rows, lanes, motion, web, weave)
    left = solve_island(n, rows, lanes, motion, web, weave)
    go_back(n, motion, web, weave)
    good = left <= STILL_GOOD and can_be_given(n, before, apart, rows, lanes, motion, web, weave)
    for joint in joints:
        if good:
            keep_joint(joint, rows, lanes, web, weave)
        harden(joint, good, rate, rows, web, weave)
    if not good:
        web[n, I_FRESH] = LEFT_ALONE
    elif relaxing:
        for joint in joints:
            leave_room(joint, substep, rows, lanes, motion, web, weave)


@inlined
def can_be_given(
    n: int,
    before: float,
    apart: float,
    rows: Array,
    lanes: Whole,
    motion: Array,
    web: Whole,
    weave: Array,
) -> bool:
    """Let the impulses that were found act; take them back and return no if they are wild."""
    most = 0.0
    for joint in range(web[n, I_JOINT], web[n + 1, I_JOINT]):
        most = max(most, apply_joint(joint, rows, lanes, motion, web, weave))
    count = web[n + 1, I_JOINT] - web[n, I_JOINT]
    good = most <= WILD * count * weave[n, SCALE]
    good = good and not_livelier(n, before, apart, motion, web, weave)
    if not good:
        go_back(n, motion, web, weave)
    return good


def go_back(n: int, motion: Array, web: Whole, weave: Array) -> None:
    """Give the bodies of an island the velocities that were noted."""
    for knot in range(web[n, I_KNOT], web[n + 1, I_KNOT]):
        for k in range(3):
            motion[web[knot, K_BODY], k] = weave[knot, START + k]


def set_out(n: int, rows: Array, lanes: Whole, motion: Array, web: Whole, weave: Array) -> float:
    """Note the velocities of an island; return its energy without its contacts, J."""
    for knot in range(web[n, I_KNOT], web[n + 1, I_KNOT]):
        for k in range(3):
            weave[knot, START + k] = motion[web[knot, K_BODY], k]
            weave[knot, CHANGE + k] = 0.0
    for joint in range(web[n, I_JOINT], web[n + 1, I_JOINT]):
        b, m = web[joint, J_BLOCK], web[joint, J_LANE]
        row = rows[b]
        line, tangent = (row[R_NX + m], row[R_NY + m]), (-row[R_NY + m], row[R_NX + m])
        for k in range(lanes[b, POINTS]):
            at = SHARED + k * SIZE
            push, rub = row[at + P_PUSH + m], row[at + P_RUB + m]
            load_knots(joint, m, at, P_ARM_A, P_ARM_B, -push, line, row, web, weave)
            load_knots(joint, m, at, P_SIDE_A, P_SIDE_B, -rub, tangent, row, web, weave)
    energy = 0.0
    for knot in range(web[n, I_KNOT], web[n + 1, I_KNOT]):
        mass, inertia, start = weave[knot, MASS], weave[knot, INERTIA], weave[knot, START:]
        x, y = momentum(mass, (start[0], start[1]))
        x, y = x + weave[knot, CHANGE], y + weave[knot, CHANGE + 1]
        turn = angular_momentum_own(inertia, start[2]) + weave[knot, CHANGE + 2]
        energy += linear_energy_start((x, y), mass) if mass > 0.0 else 0.0
        energy += turning_energy_start(turn, inertia) if inertia > 0.0 else 0.0
    return energy


def not_livelier(
    n: int, before: float, apart: float, motion: Array, web: Whole, weave: Array
) -> bool:
    """Return whether contacts have taken energy, but for what removes overlap at a speed, m/s."""
    energy = mass = 0.0
    for knot in range(web[n, I_KNOT], web[n + 1, I_KNOT]):
        now = motion[web[knot, K_BODY]]
        energy += linear_energy(weave[knot, MASS], (now[VX], now[VY]))
        energy += turning_energy(weave[knot, INERTIA], now[SPIN])
        mass += weave[knot, MASS]
    return energy <= before * LIVELY + bias_energy(mass, apart)


def solve_island(
    n: int, rows: Array, lanes: Whole, motion: Array, web: Whole, weave: Array
) -> float:
    """Find the velocities and pushes of an island; return what is left, as a part of the pushes."""
    changed, left = balance(n, True, rows, lanes, motion, web, weave)
    for _ in range(CORRECTIONS):
        if changed > 0 or web[n, I_FRESH] == 0:
            assemble(n, rows, lanes, web, weave)
            web[n, I_FRESH] = 0
            if not factor(n, web, weave):
                return 1.0
            web[n, I_FRESH] = 1
        substitute(n, web, weave)
        for knot in range(web[n, I_KNOT], web[n + 1, I_KNOT]):
            for k in range(3):
                motion[web[knot, K_BODY], k] += weave[knot, CHANGE + k]
        changed, left = balance(n, False, rows, lanes, motion, web, weave)
        if left <= CLOSE_ENOUGH:
            return left
    return left
