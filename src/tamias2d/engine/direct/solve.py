"""Tree-like islands solved directly: all contacts of one at once, instead of one after the other.

The impulse of a contact is the one that it has and what its velocity, times a large mass, adds.
With the velocities unknown this is a linear system over the bodies of the island; the active set is
tried, solved and corrected until it fits. Normal impulses that come out are never negative, tangent
impulses never more than friction allows; an island that does not fit is left to the substeps.

Cost: some factorizations of a nearly banded matrix. Source: Rockafellar (1976), proximal point;
George and Liu (1981), sparse elimination.
"""

from math import inf, sqrt

from tamias2d.engine import tables as tb
from tamias2d.engine.direct.active_set import (
    ALL_CHANGE,
    COARSE,
    FRICTION_STAYS,
    LOOSE,
    STATES_STAY,
    change_worst_friction,
    find_residual,
    guess_state,
    is_uneven,
)
from tamias2d.engine.direct.cholesky import factor, substitute
from tamias2d.engine.direct.contacts import (
    apply_contact,
    harden,
    note_gaps,
    open_contact,
    store_contact,
)
from tamias2d.engine.direct.matrix import assemble_matrix
from tamias2d.engine.direct.tree_energy import (
    STIFF,
    energy_without_contacts,
    gains_no_energy,
    note_velocities,
    restore_velocities,
)
from tamias2d.engine.tables import Bodies, Constraints, Direct
from tamias2d.generated.firm_contact import normal_impulse_share
from tamias2d.kernels.assembled import inlined

REMOVED = 0.2  # of an overlap, in a substep
CORRECTIONS = 12  # of the active set, at most
PATIENT_CORRECTIONS = 60  # likewise, of the second try
NEARLY = 1e-3  # of the largest difference of velocity: a point that parts more slowly may press
NOISE = 1e-5  # of the impulse that stops the heaviest body: less is what rounding has left
CONVERGED = 1e-10  # residual as a part of the impulses, squared
ACCEPTED = 1e-6  # the same: an island with more is not solved
WILD = 100.0  # impulses for each contact, in units of those that stop the island: not accepted

NOT_FACTORED, FACTORED, LEFT_TO_SUBSTEPS = 0, 1, -1  # status of an island


def prepare_trees(
    first: int, last: int, bodies: Bodies, constraints: Constraints, direct: Direct
) -> None:
    """Note the masses of the nodes of some islands, and the softness of their contacts."""
    sparse = direct.sparse
    for n in range(first, last):
        sparse[n, tb.I_STATUS] = NOT_FACTORED
        note_masses(n, bodies, direct)
        for contact in range(sparse[n, tb.I_CONTACT], sparse[n + 1, tb.I_CONTACT]):
            note_softness(contact, constraints, direct)


def note_masses(n: int, bodies: Bodies, direct: Direct) -> None:
    """Note the masses of the nodes of an island; 0 for a body that does not turn."""
    sparse, factors = direct.sparse, direct.factors
    heaviest = lightest = 0.0
    for node in range(sparse[n, tb.I_NODE], sparse[n + 1, tb.I_NODE]):
        properties = bodies.properties[sparse[node, tb.N_BODY]]
        inverse, inverse_inertia = properties[tb.INVERSE_MASS], properties[tb.INVERSE_INERTIA]
        mass = 1.0 / inverse if inverse > 0.0 else 0.0
        factors[node, tb.NODE_MASS] = mass
        factors[node, tb.NODE_INERTIA] = 1.0 / inverse_inertia if inverse_inertia > 0.0 else 0.0
        heaviest = max(heaviest, mass)
        lightest = min(lightest, mass) if lightest > 0.0 else mass
    factors[n, tb.LARGEST_MASS] = heaviest
    factors[n, tb.FIRM_MASS] = STIFF * sqrt(heaviest * lightest)


def note_softness(contact: int, constraints: Constraints, direct: Direct) -> None:
    """Note the softness of a contact, and the share of its first point in friction."""
    b, m = direct.sparse[contact, tb.C_BLOCK], direct.sparse[contact, tb.C_LANE]
    row, numbers = constraints.blocks[b], direct.factors[contact]
    numbers[tb.SOFTNESS], numbers[tb.SOFTNESS + 1] = (
        row[tb.R_BIAS_RATE + m],
        row[tb.R_MASS_SHARE + m],
    )
    numbers[tb.SOFTNESS + 2] = row[tb.R_IMPULSE_SHARE + m]
    first = row[tb.FIRST_POINT + tb.P_NORMAL_IMPULSE + m]
    total = first + row[tb.SECOND_POINT + tb.P_NORMAL_IMPULSE + m]
    both = constraints.lanes[b, tb.POINTS] == 2 and total > 0.0
    numbers[tb.FRICTION_SHARE] = normal_impulse_share(first, total) if both else 0.5


def solve_trees(
    relaxing: bool,
    first: int,
    last: int,
    substep: float,
    bodies: Bodies,
    constraints: Constraints,
    direct: Direct,
) -> None:
    """Solve some islands: with the velocity that removes overlap, or relaxing it."""
    for n in range(first, last):
        if direct.sparse[n, tb.I_STATUS] != LEFT_TO_SUBSTEPS:
            solve_tree(n, relaxing, substep, bodies, constraints, direct)


@inlined
def solve_tree(
    n: int, relaxing: bool, substep: float, bodies: Bodies, constraints: Constraints, direct: Direct
) -> None:
    """Solve an island, or leave it to the substeps from now on."""
    rate = REMOVED / substep
    contacts = range(direct.sparse[n, tb.I_CONTACT], direct.sparse[n + 1, tb.I_CONTACT])
    apart = open_contacts(
        n, relaxing, 0.0 if relaxing else 1.0, substep, bodies, constraints, direct
    )
    pressed = any_presses(n, constraints, direct)
    uneven = is_uneven(n, direct.factors)
    solved = True
    if pressed:
        note_velocities(n, bodies, direct)
        before = energy_without_contacts(n, constraints, direct)
        residual = iterate_tree(n, bodies, constraints, direct)
        restore_velocities(n, bodies, direct)
        if residual > ACCEPTED and not uneven:
            open_contacts(n, relaxing, COARSE, substep, bodies, constraints, direct)
            residual = iterate_patiently(n, bodies, constraints, direct)
            restore_velocities(n, bodies, direct)
        solved = residual <= ACCEPTED
        solved = solved and accept_impulses(n, before, apart, bodies, constraints, direct)
    for contact in contacts:
        if not pressed:
            direct.sparse[contact, tb.C_STATE] = LOOSE
        elif solved:
            store_contact(contact, constraints, direct)
        harden(contact, solved, rate, constraints, direct)
    if not solved:
        direct.sparse[n, tb.I_STATUS] = LEFT_TO_SUBSTEPS
        if uneven:
            direct.counts[tb.UNSOLVED] = direct.sparse[direct.sparse[n, tb.I_NODE], tb.N_BODY] + 1
    elif relaxing:
        for contact in contacts:
            note_gaps(contact, substep, bodies, constraints, direct)


def open_contacts(
    n: int,
    relaxing: bool,
    coarseness: float,
    substep: float,
    bodies: Bodies,
    constraints: Constraints,
    direct: Direct,
) -> float:
    """Write biases and the scale of impulses of an island, and guess its states.

    They are known where the coarseness, by which what counts as rounding is larger, is 0. Returns
    the sum of the velocities, m/s, at which overlaps are pushed apart.
    """
    contacts = range(direct.sparse[n, tb.I_CONTACT], direct.sparse[n + 1, tb.I_CONTACT])
    fastest = apart = largest = 0.0
    for contact in contacts:
        speed, bias = open_contact(
            contact, relaxing, substep, REMOVED / substep, bodies, constraints, direct
        )
        fastest, apart = max(fastest, speed), apart - bias
    stopping = direct.factors[n, tb.LARGEST_MASS] * fastest
    for contact in contacts:
        noise = 0.0 if is_uneven(n, direct.factors) else NOISE * stopping
        noise = noise if coarseness <= 1.0 else inf
        impulse = guess_state(
            contact, coarseness > 0.0, NEARLY * fastest, noise, constraints, direct
        )
        largest = max(largest, impulse)
    direct.factors[n, tb.IMPULSE_SCALE] = largest + stopping
    return apart


def any_presses(n: int, constraints: Constraints, direct: Direct) -> bool:
    """Return whether a contact of an island has an impulse, or closes faster than it should."""
    for contact in range(direct.sparse[n, tb.I_CONTACT], direct.sparse[n + 1, tb.I_CONTACT]):
        b, m = direct.sparse[contact, tb.C_BLOCK], direct.sparse[contact, tb.C_LANE]
        row, error = constraints.blocks[b], direct.factors[contact]
        for k in range(constraints.lanes[b, tb.POINTS]):
            at = tb.SHARED + k * tb.POINT_SIZE + m
            pushed = abs(row[at + tb.P_NORMAL_IMPULSE]) + abs(row[at + tb.P_TANGENT_IMPULSE])
            if pushed > 0.0 or error[tb.SPEED_ERROR + k] < 0.0:
                return True
    return False


def iterate_tree(n: int, bodies: Bodies, constraints: Constraints, direct: Direct) -> float:
    """Find velocities, impulses and active set of an island; return the residual that is left."""
    changed, residual = find_residual(n, STATES_STAY, 1.0, bodies, constraints, direct)
    for _ in range(CORRECTIONS):
        if not correct_velocities(n, changed > 0, bodies, constraints, direct):
            return 1.0
        changed, residual = find_residual(n, ALL_CHANGE, 1.0, bodies, constraints, direct)
        if residual <= CONVERGED:
            return residual
    return residual


def iterate_patiently(n: int, bodies: Bodies, constraints: Constraints, direct: Direct) -> float:
    """Do the same, but change what presses only where all else fits, and then what slides.

    All contacts hold at first, and slide one after the other. Where much slides at once, or normal
    impulses are next to nothing, the active set would change to and fro. One that does not fit in
    the end is not accepted, however small the residual.
    """
    changed, residual = find_residual(n, STATES_STAY, COARSE, bodies, constraints, direct)
    for _ in range(PATIENT_CORRECTIONS):
        if not correct_velocities(n, changed > 0, bodies, constraints, direct):
            return 1.0
        before = residual
        changed, residual = find_residual(n, STATES_STAY, COARSE, bodies, constraints, direct)
        if residual > ACCEPTED:
            continue
        fits = residual <= CONVERGED or residual > 0.5 * before  # which is all that rounding allows
        changed, residual = find_residual(n, FRICTION_STAYS, COARSE, bodies, constraints, direct)
        if changed == 0 and change_worst_friction(n, bodies, constraints, direct):
            changed, residual = find_residual(n, STATES_STAY, COARSE, bodies, constraints, direct)
        elif changed == 0 and fits:
            return residual
    return 1.0


@inlined
def correct_velocities(
    n: int, changed: bool, bodies: Bodies, constraints: Constraints, direct: Direct
) -> bool:
    """Solve for the momentum that the nodes of an island have left; return whether that is done.

    Its matrix is factored if the active set has changed.
    """
    sparse, factors = direct.sparse, direct.factors
    if changed or sparse[n, tb.I_STATUS] == NOT_FACTORED:
        assemble_matrix(n, constraints, direct)
        sparse[n, tb.I_STATUS] = NOT_FACTORED
        if not factor(n, sparse, factors):
            return False
        sparse[n, tb.I_STATUS] = FACTORED
    substitute(n, sparse, factors)
    for node in range(sparse[n, tb.I_NODE], sparse[n + 1, tb.I_NODE]):
        for k in range(3):
            bodies.motion[sparse[node, tb.N_BODY], k] += factors[node, tb.CHANGE + k]
    return True


@inlined
def accept_impulses(
    n: int, before: float, apart: float, bodies: Bodies, constraints: Constraints, direct: Direct
) -> bool:
    """Apply the impulses of an island; take them back and return False if they are wild."""
    first, last = direct.sparse[n, tb.I_CONTACT], direct.sparse[n + 1, tb.I_CONTACT]
    largest, shares = 0.0, not is_uneven(n, direct.factors)  # what rounding decided is to be told
    for contact in range(first, last):
        largest = max(largest, apply_contact(contact, shares, bodies, constraints, direct))
    accepted = largest <= WILD * (last - first) * direct.factors[n, tb.IMPULSE_SCALE]
    accepted = accepted and gains_no_energy(n, before, apart, bodies, constraints, direct)
    if not accepted:
        restore_velocities(n, bodies, direct)
    return accepted
