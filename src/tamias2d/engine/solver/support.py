"""The reference motion of islands: that of their support, or of their centre of mass.

The energy of an island is measured as seen from its support, which may give any; an island whose
supports move against each other has no bound. A free island is seen from its centre of mass as that
moved when the step began: there, gravity does no work that contacts could take for theirs.
"""

from tamias2d.engine.solver.energy import UNLIMITED
from tamias2d.engine.tables import (
    ACTIVE,
    DX,
    DYNAMIC,
    ENERGY_START,
    FREE_OF_CONTACTS,
    GRAVITY_X,
    GRAVITY_Y,
    I_NODE,
    INVERSE_MASS,
    ISLAND_MASS,
    J_MEMBER,
    J_NODE,
    JOINED_SLOT,
    KEPT_WAY,
    LIFT_WORK,
    M_DRIVEN,
    M_JOINT,
    M_STATUS,
    MECHANISMS,
    MOMENTUM_X,
    MOMENTUM_Y,
    PART_SUBSTEPS,
    REFERENCE,
    ROOT,
    SPIN,
    STANDS_STILL,
    STEP_START,
    SUBSTEP,
    SUPPORT,
    TOUCHING,
    VX,
    VY,
    WORK,
    Bodies,
    Constraints,
    Control,
    Islands,
    Joints,
    Touching,
    X,
    Y,
)
from tamias2d.generated.definitions import momentum, point_velocity
from tamias2d.generated.island_energy import lift_work, velocity_island
from tamias2d.generated.joint_step import kept_way, kinetic_energy_most
from tamias2d.state import Array, Vector

ALIKE = 1e-9  # of their sizes: differences of velocities that are none

FREE, SUPPORTED_BY_ONE, SUPPORTED_BY_MORE = 0.0, 1.0, 2.0  # motions that support an island


def find_references(
    bodies: Bodies, touching: Touching, constraints: Constraints, islands: Islands
) -> None:
    """Write the reference motion of each island at its root."""
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        if is_root(i, bodies, islands):
            row = islands.energy[i]
            row[SUPPORT] = FREE
            row[ISLAND_MASS] = row[MOMENTUM_X] = row[MOMENTUM_Y] = 0.0
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        if bodies.kind[i] == DYNAMIC:
            row, state = islands.energy[islands.links[i, ROOT]], bodies.substep_state[i]
            mass = 1.0 / bodies.properties[i, INVERSE_MASS]
            x, y = momentum(mass, (state[STEP_START], state[STEP_START + 1]))
            row[MOMENTUM_X] += x
            row[MOMENTUM_Y] += y
            row[ISLAND_MASS] += mass
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        if is_root(i, bodies, islands):
            row = islands.energy[i]
            whole = (row[MOMENTUM_X], row[MOMENTUM_Y])
            row[REFERENCE], row[REFERENCE + 1] = velocity_island(whole, row[ISLAND_MASS])
            row[REFERENCE + 2] = 0.0
    for k in range(touching.counts[TOUCHING]):
        i, j = touching.body_a[k], touching.body_b[k]
        if bodies.kind[i] != DYNAMIC:
            i, j = j, i
        if bodies.kind[j] != DYNAMIC:
            support_island(j, islands.links[i, ROOT], bodies, islands)


def is_root(i: int, bodies: Bodies, islands: Islands) -> bool:
    """Return whether a body is the root of an island."""
    return bool(bodies.kind[i] == DYNAMIC and islands.links[i, ROOT] == i)


def support_island(j: int, root: int, bodies: Bodies, islands: Islands) -> None:
    """Let an island be seen from a body that does not move freely."""
    row, motion, spin = islands.energy[root], bodies.motion[j], bodies.motion[j, SPIN]
    x, y = bodies.pose[root, X] - bodies.pose[j, X], bodies.pose[root, Y] - bodies.pose[j, Y]
    by_x, by_y = point_velocity((motion[VX], motion[VY]), spin, (x, y))
    if row[SUPPORT] == FREE:
        row[SUPPORT] = SUPPORTED_BY_ONE
        row[REFERENCE], row[REFERENCE + 1], row[REFERENCE + 2] = by_x, by_y, spin
    apart = abs(row[REFERENCE] - by_x) + abs(row[REFERENCE + 1] - by_y)
    speed = abs(by_x) + abs(by_y) + abs(motion[VX]) + abs(motion[VY])
    if apart > ALIKE * speed or abs(row[REFERENCE + 2] - spin) > ALIKE * abs(spin):
        row[SUPPORT] = SUPPORTED_BY_MORE


def support_joined(bodies: Bodies, islands: Islands, joints: Joints) -> None:
    """Let the islands of mechanisms that are tied to what stands still be seen from there."""
    for n in range(joints.counts[MECHANISMS]):
        root = islands.links[joints.members[joints.sparse[n, I_NODE] + 1, JOINED_SLOT], ROOT]
        for j in range(joints.mechanisms[n, M_JOINT], joints.mechanisms[n + 1, M_JOINT]):
            for end in range(3):
                if joints.joints[j, J_NODE + end] == STANDS_STILL:
                    support = joints.members[joints.joints[j, J_MEMBER + end], JOINED_SLOT]
                    support_island(support, root, bodies, islands)


def charge_joined(
    control: Control,
    bodies: Bodies,
    touching: Touching,
    constraints: Constraints,
    islands: Islands,
    joints: Joints,
) -> None:
    """Charge the islands of mechanisms for what they do against gravity and forces (IM15).

    Joints and contacts that are solved in turns would otherwise lift them for nothing, again and
    again. One that has not the energy for its way, with what overlaps may give back, keeps a part
    of it. One that is driven may give any energy, and one that no contact touches has its own
    bound.
    """
    if joints.counts[MECHANISMS] == 0:
        return
    sum_lift_work(control, bodies, touching, constraints, islands)
    for n in range(joints.counts[MECHANISMS]):
        root = islands.links[joints.members[joints.sparse[n, I_NODE] + 1, JOINED_SLOT], ROOT]
        row = islands.energy[root]
        bounded = joints.mechanisms[n, M_STATUS] == FREE_OF_CONTACTS
        if bounded or joints.mechanisms[n, M_DRIVEN] == 1:
            row[WORK] = UNLIMITED
        elif row[WORK] < 0.0:
            least = kept_way(row[ENERGY_START], row[LIFT_WORK], row[WORK])
            row[KEPT_WAY] = least if rests_on_ground(row) else 1.0
            row[ENERGY_START] = kinetic_energy_most(row[ENERGY_START], row[WORK])
            row[WORK] = 0.0
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        row = islands.energy[islands.links[i, ROOT]]
        if bodies.kind[i] == DYNAMIC and row[KEPT_WAY] < 1.0 and row[WORK] == 0.0:
            for m in range(3):
                bodies.motion[i, DX + m] *= row[KEPT_WAY]


def sum_lift_work(
    control: Control,
    bodies: Bodies,
    touching: Touching,
    constraints: Constraints,
    islands: Islands,
) -> None:
    """Add up what the overlaps of each island may give back, J; let it keep its way at first."""
    gravity = (control.settings[GRAVITY_X], control.settings[GRAVITY_Y])
    for k in range(constraints.counts[ACTIVE]):
        row = islands.energy[touching.active[k]]
        row[KEPT_WAY], row[LIFT_WORK] = 1.0, 0.0
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        if bodies.kind[i] == DYNAMIC:
            load, mass = bodies.load[i], 1.0 / bodies.properties[i, INVERSE_MASS]
            of_substep = lift_work(mass, gravity, (load[0], load[1]), control.settings[SUBSTEP])
            substeps = control.counts[PART_SUBSTEPS]
            islands.energy[islands.links[i, ROOT], LIFT_WORK] += substeps * of_substep


def rests_on_ground(row: Array) -> bool:
    """Return whether an island is seen from a support that stands still."""
    moves = abs(row[REFERENCE]) + abs(row[REFERENCE + 1]) + abs(row[REFERENCE + 2])
    return bool(row[SUPPORT] == SUPPORTED_BY_ONE and moves == 0.0)


def reference_at(i: int, bodies: Bodies, islands: Islands) -> tuple[Vector, float]:
    """Return the velocity, at a body, and the spin of the reference motion of its island."""
    root = islands.links[i, ROOT]
    row = islands.energy[root]
    x, y = bodies.pose[i, X] - bodies.pose[root, X], bodies.pose[i, Y] - bodies.pose[root, Y]
    spin = row[REFERENCE + 2]
    return point_velocity((row[REFERENCE], row[REFERENCE + 1]), spin, (x, y)), spin
