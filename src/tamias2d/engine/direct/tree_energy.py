"""The energy of a tree-like island before and after it is solved: contacts must not add any."""

from tamias2d.engine import tables as tb
from tamias2d.engine.direct.contacts import add_to_nodes
from tamias2d.engine.solver.lane import normal_speed, slip_at, velocities_of_one
from tamias2d.engine.tables import Bodies, Constraints, Direct, Integers
from tamias2d.generated.definitions import angular_momentum_own, momentum
from tamias2d.generated.firm_contact import (
    bias_energy,
    linear_energy,
    linear_energy_start,
    support_energy,
    turning_energy,
    turning_energy_start,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

STIFF = 1e9  # firm mass, in means of the largest and the smallest mass of the island
LIVELY = 1.0 + 1e-9  # of the energy, that rounding may make of it
UNSOLVED_ENERGY = 1e-10  # of that of the impulses: what their rounding leaves to bodies at rest


def note_velocities(n: int, bodies: Bodies, direct: Direct) -> None:
    """Note the velocities of the bodies of an island."""
    for node in range(direct.sparse[n, tb.I_NODE], direct.sparse[n + 1, tb.I_NODE]):
        for k in range(3):
            motion = bodies.motion[direct.sparse[node, tb.N_BODY]]
            direct.factors[node, tb.VELOCITY_START + k] = motion[k]


def restore_velocities(n: int, bodies: Bodies, direct: Direct) -> None:
    """Give the bodies of an island the velocities that were noted."""
    for node in range(direct.sparse[n, tb.I_NODE], direct.sparse[n + 1, tb.I_NODE]):
        for k in range(3):
            motion = bodies.motion[direct.sparse[node, tb.N_BODY]]
            motion[k] = direct.factors[node, tb.VELOCITY_START + k]


def energy_without_contacts(n: int, constraints: Constraints, direct: Direct) -> float:
    """Return the kinetic energy of an island, J, if its contacts had no impulses."""
    sparse, factors = direct.sparse, direct.factors
    for node in range(sparse[n, tb.I_NODE], sparse[n + 1, tb.I_NODE]):
        for k in range(3):
            factors[node, tb.CHANGE + k] = 0.0
    for contact in range(sparse[n, tb.I_CONTACT], sparse[n + 1, tb.I_CONTACT]):
        take_impulses(contact, constraints, sparse, factors)
    energy = 0.0
    for node in range(sparse[n, tb.I_NODE], sparse[n + 1, tb.I_NODE]):
        numbers = factors[node]
        mass, inertia = numbers[tb.NODE_MASS], numbers[tb.NODE_INERTIA]
        x, y = momentum(mass, (numbers[tb.VELOCITY_START], numbers[tb.VELOCITY_START + 1]))
        x, y = x + numbers[tb.CHANGE], y + numbers[tb.CHANGE + 1]
        spinning = (
            angular_momentum_own(inertia, numbers[tb.VELOCITY_START + 2]) + numbers[tb.CHANGE + 2]
        )
        energy += linear_energy_start((x, y), mass) if mass > 0.0 else 0.0
        energy += turning_energy_start(spinning, inertia) if inertia > 0.0 else 0.0
    return energy


@inlined
def take_impulses(contact: int, constraints: Constraints, sparse: Integers, factors: Array) -> None:
    """Take the impulses of a contact from the momenta of its nodes."""
    b, m = sparse[contact, tb.C_BLOCK], sparse[contact, tb.C_LANE]
    row = constraints.blocks[b]
    normal, tangent = (row[tb.R_NX + m], row[tb.R_NY + m]), (-row[tb.R_NY + m], row[tb.R_NX + m])
    for k in range(constraints.lanes[b, tb.POINTS]):
        at = tb.SHARED + k * tb.POINT_SIZE + m
        impulse, arm_a, arm_b = (
            -row[at + tb.P_NORMAL_IMPULSE],
            row[at + tb.P_NORMAL_ARM_A],
            row[at + tb.P_NORMAL_ARM_B],
        )
        add_to_nodes(contact, impulse, arm_a, arm_b, normal, sparse, factors)
        impulse, arm_a, arm_b = (
            -row[at + tb.P_TANGENT_IMPULSE],
            row[at + tb.P_TANGENT_ARM_A],
            row[at + tb.P_TANGENT_ARM_B],
        )
        add_to_nodes(contact, impulse, arm_a, arm_b, tangent, sparse, factors)


def energy_of_support(n: int, bodies: Bodies, constraints: Constraints, direct: Direct) -> float:
    """Return what the support of an island gives by the impulses that were found, J (DD104)."""
    sparse, total = direct.sparse, 0.0
    for contact in range(sparse[n, tb.I_CONTACT], sparse[n + 1, tb.I_CONTACT]):
        is_a, is_b = sparse[contact, tb.C_NODE_A] < 0, sparse[contact, tb.C_NODE_B] < 0
        if is_a or is_b:
            total += energy_of_contact(contact, is_a, bodies, constraints, direct)
    return total


def energy_of_contact(
    contact: int, is_a: bool, bodies: Bodies, constraints: Constraints, direct: Direct
) -> float:
    """Return what one of the bodies of a contact, A or B, gives, J."""
    b, m = direct.sparse[contact, tb.C_BLOCK], direct.sparse[contact, tb.C_LANE]
    row, lane, total = constraints.blocks[b], constraints.lanes[b], 0.0
    support = bodies.motion[lane[(tb.BODY_A if is_a else tb.BODY_B) + m]]
    alone = velocities_of_one(support, is_a)
    for k in range(lane[tb.POINTS]):
        at = tb.SHARED + k * tb.POINT_SIZE
        total += support_energy(
            direct.factors[contact, tb.NEW_NORMAL + k],
            direct.factors[contact, tb.NEW_TANGENT + k],
            normal_speed(m, at, alone, row),
            slip_at(m, at, alone, row),
        )
    return total


def gains_no_energy(
    n: int,
    before: float,
    apart: float,
    bodies: Bodies,
    constraints: Constraints,
    direct: Direct,
) -> bool:
    """Return whether contacts take energy, beside what their support gives.

    They may remove overlap at a velocity, m/s.
    """
    energy = mass = 0.0
    for node in range(direct.sparse[n, tb.I_NODE], direct.sparse[n + 1, tb.I_NODE]):
        now, numbers = bodies.motion[direct.sparse[node, tb.N_BODY]], direct.factors[node]
        energy += linear_energy(numbers[tb.NODE_MASS], (now[tb.VX], now[tb.VY]))
        energy += turning_energy(numbers[tb.NODE_INERTIA], now[tb.SPIN])
        mass += numbers[tb.NODE_MASS]
    mean_mass = direct.factors[n, tb.FIRM_MASS] / STIFF
    left = UNSOLVED_ENERGY * linear_energy_start(
        (direct.factors[n, tb.IMPULSE_SCALE], 0.0), mean_mass
    )
    given = energy_of_support(n, bodies, constraints, direct) + bias_energy(mass, apart)
    return energy <= before * LIVELY + left + given
