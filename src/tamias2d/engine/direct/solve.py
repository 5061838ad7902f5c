"""Thin islands solved at once: all their contacts together, instead of one after the other.

Serves: a step. Hides: the active set and the elimination.

Every contact is asked for the push that it has and what its velocity, times a large mass, would
add. With the velocities unknown this is a linear system over the bodies of the island; which
contacts push, and which hold by friction, is tried, solved and corrected until it fits. Pushes that
come out are never negative and rubs never too large, and what does not fit is left as it was.

Source: Rockafellar (1976), proximal point; George and Liu (1981), elimination of sparse systems.
"""

from math import sqrt

from tamias2d.engine.direct.active_set import find_residual, guess_state
from tamias2d.engine.direct.cholesky import assemble_matrix, factor, substitute
from tamias2d.engine.direct.contacts import (
    add_to_nodes,
    apply_contact,
    harden,
    note_gaps,
    open_contact,
    store_contact,
)
from tamias2d.engine.tables import (
    C_BLOCK,
    C_LANE,
    CHANGE,
    FIRM,
    HEAVIEST,
    I_CONTACT,
    I_FACTORED,
    I_NODE,
    INVERSE_INERTIA,
    INVERSE_MASS,
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
    R_BIAS,
    R_KEEP,
    R_NX,
    R_NY,
    R_SHARE,
    SCALE,
    SHARE,
    SHARED,
    SIZE,
    SOFT,
    SPIN,
    START,
    VX,
    VY,
    Bodies,
    Constraints,
    Direct,
)
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

STIFF = 1e9  # of a contact, in masses between the heaviest and the lightest of its island
REMOVED = 0.2  # of an overlap, removed in a substep
CORRECTIONS = 12  # corrections of what pushes and what holds
NEARLY = 1e-3  # of the fastest point: what is slower to part may push
CLOSE_ENOUGH = 1e-10  # what may be left of the equations, as a part of the pushes, both squared
STILL_GOOD = 1e-6  # more than this is not taken
WILD = 100.0  # nor pushes so many times what there is to stop, for each contact
LIVELY = 1.0 + 1e-9  # nor what gives the bodies more energy, but for rounding
LEFT_ALONE = -1


def prepare_trees(
    first: int, last: int, bodies: Bodies, constraints: Constraints, direct: Direct
) -> None:
    """Note the masses of the knots of some islands, and how soft their joints are."""
    for n in range(first, last):
        heaviest = lightest = 0.0
        for knot in range(direct.sparse[n, I_NODE], direct.sparse[n + 1, I_NODE]):
            i = direct.sparse[knot, N_BODY]
            mass, inertia = (
                bodies.properties[i, INVERSE_MASS],
                bodies.properties[i, INVERSE_INERTIA],
            )
            direct.factors[knot, NODE_MASS] = 1.0 / mass if mass > 0.0 else 0.0
            direct.factors[knot, NODE_INERTIA] = 1.0 / inertia if inertia > 0.0 else 0.0
            mass = direct.factors[knot, NODE_MASS]
            heaviest = max(heaviest, mass)
            lightest = min(lightest, mass) if lightest > 0.0 else mass
        direct.factors[n, HEAVIEST] = heaviest
        direct.factors[n, FIRM] = STIFF * sqrt(heaviest * lightest)
        direct.sparse[n, I_FACTORED] = 0
        for joint in range(direct.sparse[n, I_CONTACT], direct.sparse[n + 1, I_CONTACT]):
            row, m = constraints.blocks[direct.sparse[joint, C_BLOCK]], direct.sparse[joint, C_LANE]
            direct.factors[joint, SOFT], direct.factors[joint, SOFT + 1] = (
                row[R_BIAS + m],
                row[R_SHARE + m],
            )
            direct.factors[joint, SOFT + 2] = row[R_KEEP + m]
            first, second = row[SHARED + P_NORMAL + m], row[SHARED + SIZE + P_NORMAL + m]
            both = (
                constraints.lanes[direct.sparse[joint, C_BLOCK], POINTS] == 2
                and first + second > 0.0
            )
            direct.factors[joint, SHARE] = push_share(first, first + second) if both else 0.5


def solve_trees(
    relaxing: bool,
    first: int,
    last: int,
    substep: float,
    bodies: Bodies,
    constraints: Constraints,
    direct: Direct,
) -> None:
    """Solve some thin islands, with the speed that removes overlap, or to take that out again."""
    for n in range(first, last):
        if direct.sparse[n, I_FACTORED] != LEFT_ALONE:
            solve_tree(n, relaxing, substep, bodies, constraints, direct)


@inlined
def solve_tree(
    n: int, relaxing: bool, substep: float, bodies: Bodies, constraints: Constraints, direct: Direct
) -> None:
    """Solve an island and keep what is found, or leave it to the sweeps from now on."""
    rate = REMOVED / substep
    joints = range(direct.sparse[n, I_CONTACT], direct.sparse[n + 1, I_CONTACT])
    fastest = apart = largest = 0.0
    for joint in joints:
        speed, bias = open_contact(joint, relaxing, substep, rate, bodies, constraints, direct)
        fastest, apart = max(fastest, speed), apart - bias
    for joint in joints:
        largest = max(largest, guess_state(joint, relaxing, NEARLY * fastest, constraints, direct))
    direct.factors[n, SCALE] = largest + direct.factors[n, HEAVIEST] * fastest
    before = note_velocities(n, bodies, constraints, direct)
    left = iterate_tree(n, bodies, constraints, direct)
    restore_velocities(n, bodies, direct)
    good = left <= STILL_GOOD and accept_impulses(n, before, apart, bodies, constraints, direct)
    for joint in joints:
        if good:
            store_contact(joint, constraints, direct)
        harden(joint, good, rate, constraints, direct)
    if not good:
        direct.sparse[n, I_FACTORED] = LEFT_ALONE
    elif relaxing:
        for joint in joints:
            note_gaps(joint, substep, bodies, constraints, direct)


@inlined
def accept_impulses(
    n: int, before: float, apart: float, bodies: Bodies, constraints: Constraints, direct: Direct
) -> bool:
    """Let the impulses that were found act; take them back and return no if they are wild."""
    most = 0.0
    for joint in range(direct.sparse[n, I_CONTACT], direct.sparse[n + 1, I_CONTACT]):
        most = max(most, apply_contact(joint, bodies, constraints, direct))
    count = direct.sparse[n + 1, I_CONTACT] - direct.sparse[n, I_CONTACT]
    good = most <= WILD * count * direct.factors[n, SCALE]
    good = good and gains_no_energy(n, before, apart, bodies, direct)
    if not good:
        restore_velocities(n, bodies, direct)
    return good


def restore_velocities(n: int, bodies: Bodies, direct: Direct) -> None:
    """Give the bodies of an island the velocities that were noted."""
    for knot in range(direct.sparse[n, I_NODE], direct.sparse[n + 1, I_NODE]):
        for k in range(3):
            bodies.motion[direct.sparse[knot, N_BODY], k] = direct.factors[knot, START + k]


def note_velocities(n: int, bodies: Bodies, constraints: Constraints, direct: Direct) -> float:
    """Note the velocities of an island; return its energy without its contacts, J."""
    for knot in range(direct.sparse[n, I_NODE], direct.sparse[n + 1, I_NODE]):
        for k in range(3):
            direct.factors[knot, START + k] = bodies.motion[direct.sparse[knot, N_BODY], k]
            direct.factors[knot, CHANGE + k] = 0.0
    for joint in range(direct.sparse[n, I_CONTACT], direct.sparse[n + 1, I_CONTACT]):
        b, m = direct.sparse[joint, C_BLOCK], direct.sparse[joint, C_LANE]
        row = constraints.blocks[b]
        line, tangent = (row[R_NX + m], row[R_NY + m]), (-row[R_NY + m], row[R_NX + m])
        for k in range(constraints.lanes[b, POINTS]):
            at = SHARED + k * SIZE
            push, rub = row[at + P_NORMAL + m], row[at + P_TANGENT + m]
            add_to_nodes(
                joint, m, at, P_ARM_A, P_ARM_B, -push, line, row, direct.sparse, direct.factors
            )
            add_to_nodes(
                joint, m, at, P_SIDE_A, P_SIDE_B, -rub, tangent, row, direct.sparse, direct.factors
            )
    energy = 0.0
    for knot in range(direct.sparse[n, I_NODE], direct.sparse[n + 1, I_NODE]):
        mass, inertia, start = (
            direct.factors[knot, NODE_MASS],
            direct.factors[knot, NODE_INERTIA],
            direct.factors[knot, START:],
        )
        x, y = momentum(mass, (start[0], start[1]))
        x, y = x + direct.factors[knot, CHANGE], y + direct.factors[knot, CHANGE + 1]
        turn = angular_momentum_own(inertia, start[2]) + direct.factors[knot, CHANGE + 2]
        energy += linear_energy_start((x, y), mass) if mass > 0.0 else 0.0
        energy += turning_energy_start(turn, inertia) if inertia > 0.0 else 0.0
    return energy


def gains_no_energy(n: int, before: float, apart: float, bodies: Bodies, direct: Direct) -> bool:
    """Return whether contacts have taken energy, but for what removes overlap at a speed, m/s."""
    energy = mass = 0.0
    for knot in range(direct.sparse[n, I_NODE], direct.sparse[n + 1, I_NODE]):
        now = bodies.motion[direct.sparse[knot, N_BODY]]
        energy += linear_energy(direct.factors[knot, NODE_MASS], (now[VX], now[VY]))
        energy += turning_energy(direct.factors[knot, NODE_INERTIA], now[SPIN])
        mass += direct.factors[knot, NODE_MASS]
    return energy <= before * LIVELY + bias_energy(mass, apart)


def iterate_tree(n: int, bodies: Bodies, constraints: Constraints, direct: Direct) -> float:
    """Find the velocities and pushes of an island; return what is left, as a part of the pushes."""
    changed, left = find_residual(n, True, bodies, constraints, direct)
    for _ in range(CORRECTIONS):
        if changed > 0 or direct.sparse[n, I_FACTORED] == 0:
            assemble_matrix(n, constraints, direct)
            direct.sparse[n, I_FACTORED] = 0
            if not factor(n, direct.sparse, direct.factors):
                return 1.0
            direct.sparse[n, I_FACTORED] = 1
        substitute(n, direct.sparse, direct.factors)
        for knot in range(direct.sparse[n, I_NODE], direct.sparse[n + 1, I_NODE]):
            for k in range(3):
                bodies.motion[direct.sparse[knot, N_BODY], k] += direct.factors[knot, CHANGE + k]
        changed, left = find_residual(n, False, bodies, constraints, direct)
        if left <= CLOSE_ENOUGH:
            return left
    return left
