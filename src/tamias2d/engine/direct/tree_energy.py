"""The energy of a tree-like island before and after it is solved: contacts must not add any."""

from tamias2d.engine.direct.contacts import add_to_nodes
from tamias2d.engine.tables import (
    C_BLOCK,
    C_LANE,
    CHANGE,
    FIRM_MASS,
    I_CONTACT,
    I_NODE,
    IMPULSE_SCALE,
    N_BODY,
    NODE_INERTIA,
    NODE_MASS,
    P_NORMAL_ARM_A,
    P_NORMAL_ARM_B,
    P_NORMAL_IMPULSE,
    P_TANGENT_ARM_A,
    P_TANGENT_ARM_B,
    P_TANGENT_IMPULSE,
    POINT_SIZE,
    POINTS,
    R_NX,
    R_NY,
    SHARED,
    SPIN,
    VELOCITY_START,
    VX,
    VY,
    Bodies,
    Constraints,
    Direct,
    Integers,
)
from tamias2d.generated.definitions import angular_momentum_own, momentum
from tamias2d.generated.firm_contact import (
    bias_energy,
    linear_energy,
    linear_energy_start,
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
    for node in range(direct.sparse[n, I_NODE], direct.sparse[n + 1, I_NODE]):
        for k in range(3):
            motion = bodies.motion[direct.sparse[node, N_BODY]]
            direct.factors[node, VELOCITY_START + k] = motion[k]


def restore_velocities(n: int, bodies: Bodies, direct: Direct) -> None:
    """Give the bodies of an island the velocities that were noted."""
    for node in range(direct.sparse[n, I_NODE], direct.sparse[n + 1, I_NODE]):
        for k in range(3):
            motion = bodies.motion[direct.sparse[node, N_BODY]]
            motion[k] = direct.factors[node, VELOCITY_START + k]


def energy_without_contacts(n: int, constraints: Constraints, direct: Direct) -> float:
    """Return the kinetic energy of an island, J, if its contacts had no impulses."""
    sparse, factors = direct.sparse, direct.factors
    for node in range(sparse[n, I_NODE], sparse[n + 1, I_NODE]):
        for k in range(3):
            factors[node, CHANGE + k] = 0.0
    for contact in range(sparse[n, I_CONTACT], sparse[n + 1, I_CONTACT]):
        take_impulses(contact, constraints, sparse, factors)
    energy = 0.0
    for node in range(sparse[n, I_NODE], sparse[n + 1, I_NODE]):
        numbers = factors[node]
        mass, inertia = numbers[NODE_MASS], numbers[NODE_INERTIA]
        x, y = momentum(mass, (numbers[VELOCITY_START], numbers[VELOCITY_START + 1]))
        x, y = x + numbers[CHANGE], y + numbers[CHANGE + 1]
        spinning = angular_momentum_own(inertia, numbers[VELOCITY_START + 2]) + numbers[CHANGE + 2]
        energy += linear_energy_start((x, y), mass) if mass > 0.0 else 0.0
        energy += turning_energy_start(spinning, inertia) if inertia > 0.0 else 0.0
    return energy


@inlined
def take_impulses(contact: int, constraints: Constraints, sparse: Integers, factors: Array) -> None:
    """Take the impulses of a contact from the momenta of its nodes."""
    b, m = sparse[contact, C_BLOCK], sparse[contact, C_LANE]
    row = constraints.blocks[b]
    normal, tangent = (row[R_NX + m], row[R_NY + m]), (-row[R_NY + m], row[R_NX + m])
    for k in range(constraints.lanes[b, POINTS]):
        at = SHARED + k * POINT_SIZE + m
        impulse, arm_a, arm_b = (
            -row[at + P_NORMAL_IMPULSE],
            row[at + P_NORMAL_ARM_A],
            row[at + P_NORMAL_ARM_B],
        )
        add_to_nodes(contact, impulse, arm_a, arm_b, normal, sparse, factors)
        impulse, arm_a, arm_b = (
            -row[at + P_TANGENT_IMPULSE],
            row[at + P_TANGENT_ARM_A],
            row[at + P_TANGENT_ARM_B],
        )
        add_to_nodes(contact, impulse, arm_a, arm_b, tangent, sparse, factors)


def gains_no_energy(n: int, before: float, apart: float, bodies: Bodies, direct: Direct) -> bool:
    """Return whether contacts take energy, except for removing overlap at a velocity, m/s."""
    energy = mass = 0.0
    for node in range(direct.sparse[n, I_NODE], direct.sparse[n + 1, I_NODE]):
        now, numbers = bodies.motion[direct.sparse[node, N_BODY]], direct.factors[node]
        energy += linear_energy(numbers[NODE_MASS], (now[VX], now[VY]))
        energy += turning_energy(numbers[NODE_INERTIA], now[SPIN])
        mass += numbers[NODE_MASS]
    mean_mass = direct.factors[n, FIRM_MASS] / STIFF
    left = UNSOLVED_ENERGY * linear_energy_start((direct.factors[n, IMPULSE_SCALE], 0.0), mean_mass)
    return energy <= before * LIVELY + left + bias_energy(mass, apart)
