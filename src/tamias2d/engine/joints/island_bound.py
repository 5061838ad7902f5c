"""What joints may give and take of the energy of islands: what ties a mechanism, and its weight.

The energy of an island is seen from what supports it, joints included. One that goes against the
forces on it loses as much (IM15); one that is driven may give any, or what is likely (DD86).
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.energy.step_energy import UNLIMITED
from tamias2d.engine.energy.support import SUPPORTED_BY_MORE, SUPPORTED_BY_ONE, support_island
from tamias2d.engine.joints.acting import acts, note_tied
from tamias2d.engine.joints.bounded_springs import energy_of_spring
from tamias2d.engine.joints.overlap_work import add_overlap_work
from tamias2d.engine.joints.yielding import energy_driven, yields
from tamias2d.engine.tables import Bodies, Constraints, Control, Islands, Joints, Touching
from tamias2d.generated.island_energy import kinetic_energy_most, lift_work
from tamias2d.generated.joint_step import drive_work, kept_way, load_size
from tamias2d.state import Array


def support_joined(bodies: Bodies, islands: Islands, joints: Joints) -> None:
    """Let the islands of mechanisms that are tied to what nothing pushes be seen from there."""
    for n in range(joints.counts[tb.MECHANISMS]):
        support_mechanism(n, root_of_mechanism(n, islands, joints), bodies, islands, joints)


def support_mechanism(n: int, root: int, bodies: Bodies, islands: Islands, joints: Joints) -> None:
    """Let the island at a root be seen from what ties a mechanism of it."""
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        for end in range(tb.ENDS_OF_JOINT):
            if joints.joints[j, tb.J_NODE + end] == tb.NOT_PUSHED:
                support = joints.members[joints.joints[j, tb.J_MEMBER + end], tb.JOINED_SLOT]
                support_island(support, root, bodies, islands)
        q = joints.joints[j, tb.J_EQUATION]
        if q >= 0 and joints.equations[q, tb.Q_BOUND] == 1:
            support_island(joints.members[0, tb.JOINED_SLOT], root, bodies, islands)


def is_likely(n: int, row: Array, joints: Joints) -> bool:
    """Return whether what ties a mechanism may give its island what is likely, and no more.

    That is so where it is driven and its rows yield, and where contacts hold it against what
    carries it.
    """
    carried = joints.mechanisms[n, tb.M_CARRIED] == 1
    powered = joints.mechanisms[n, tb.M_DRIVEN] + joints.mechanisms[n, tb.M_TURNED_BY_MOTOR] > 0
    held = carried and row[tb.SUPPORT] == SUPPORTED_BY_MORE and not powered
    driven = carried or powered or may_get_any(n, row, joints)
    free = joints.mechanisms[n, tb.M_STATUS] == tb.FREE_OF_CONTACTS
    return not free and (held or (driven and yields(n, joints)))


def may_get_any(n: int, row: Array, joints: Joints) -> bool:
    """Return whether what ties a mechanism may give it any energy: it turns, or was moved by hand.

    So may things that move against each other.
    """
    return is_moved(n, row, joints) or bool(row[tb.SUPPORT] == SUPPORTED_BY_MORE)


def is_moved(n: int, row: Array, joints: Joints) -> bool:
    """Return whether what ties a mechanism turns, changes with time, or was moved by hand."""
    turns = (row[tb.SUPPORT] == SUPPORTED_BY_ONE) & (row[tb.REFERENCE + 2] != 0.0)
    pulled = joints.numbers[joints.mechanisms[n, tb.M_JOINT], tb.J_PULLED] > 0.0
    return bool(turns | pulled | (joints.mechanisms[n, tb.M_TIMED] == 1))


def work_of_motors(n: int, joints: Joints) -> float:
    """Return the most that the motors of a mechanism have given in a part, J."""
    given = 0.0
    if joints.mechanisms[n, tb.M_TURNED_BY_MOTOR] == 0:
        return given
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        if joints.joints[j, tb.J_LAW] == tb.MOTOR:
            given += drive_work(joints.numbers[j, tb.J_PULL], joints.laws[j, tb.LAW_RATE])
    return given


def energy_of_springs(n: int, joints: Joints) -> float:
    """Return the energy of the springs of a mechanism, J, at the values that their rows have."""
    energy = 0.0
    if joints.mechanisms[n, tb.M_GOVERNED] == 0:
        return energy
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        if joints.joints[j, tb.J_LAW] == tb.SPRING:
            energy += energy_of_spring(j, joints)
    return energy


def work_of_springs(n: int, joints: Joints) -> float:
    """Return what the springs of a mechanism have given in a part, and what it may gain, J."""
    if joints.mechanisms[n, tb.M_STATUS] != tb.IN_CONTACT or joints.mechanisms[n, tb.M_DRIVEN] == 0:
        return 0.0
    numbers = joints.numbers[joints.mechanisms[n, tb.M_JOINT]]
    return float(numbers[tb.J_ENERGY] - energy_of_springs(n, joints) + numbers[tb.J_RESERVE])


def bound_joined(
    control: Control,
    bodies: Bodies,
    touching: Touching,
    constraints: Constraints,
    islands: Islands,
    joints: Joints,
) -> None:
    """Bound the energy of islands of mechanisms by what they do against gravity and forces (IM15).

    Joints and contacts that are solved in turns would otherwise lift them for nothing, again and
    again. One that has not the energy for its way, with what overlaps may give back, keeps a part
    of it. One that is driven may give any energy, and one that no contact touches has its own
    bound; what carries one that yields, or that contacts hold, gives what is likely (DD86).
    """
    if joints.counts[tb.MECHANISMS] == 0:
        return
    note_tied(bodies, touching, constraints, islands, joints)
    sum_masses_and_lift_work(control, bodies, touching, constraints, islands)
    for n in range(joints.counts[tb.MECHANISMS]):
        row = islands.energy[root_of_mechanism(n, islands, joints)]
        if is_likely(n, row, joints) and acts(n, joints):
            likely = energy_driven(n, row[tb.ISLAND_MASS], row, control, bodies, joints)
            row[tb.DRIVEN_ENERGY] = max(row[tb.DRIVEN_ENERGY], likely)
    for n in range(joints.counts[tb.MECHANISMS]):
        row = islands.energy[root_of_mechanism(n, islands, joints)]
        row[tb.WORK] += work_of_motors(n, joints) + work_of_springs(n, joints)
    add_overlap_work(control.progress[tb.PART_TIME], bodies, constraints, islands)
    for n in range(joints.counts[tb.MECHANISMS]):
        if acts(n, joints):
            bound_for_mechanism(n, islands.energy[root_of_mechanism(n, islands, joints)], joints)
    for n in range(joints.counts[tb.MECHANISMS]):
        row = islands.energy[root_of_mechanism(n, islands, joints)]
        if row[tb.DRIVEN_ENERGY] > 0.0 and row[tb.SUPPORT] == SUPPORTED_BY_MORE:
            row[tb.SUPPORT] = SUPPORTED_BY_ONE
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        row = islands.energy[islands.links[i, tb.ROOT]]
        if bodies.kind[i] == tb.DYNAMIC and row[tb.KEPT_WAY] < 1.0 and row[tb.WORK] == 0.0:
            for m in range(3):
                bodies.motion[i, tb.DX + m] *= row[tb.KEPT_WAY]


def root_of_mechanism(n: int, islands: Islands, joints: Joints) -> int:
    """Return the root of the island of a mechanism."""
    i = joints.members[joints.sparse[n, tb.I_NODE] + 1, tb.JOINED_SLOT]
    return int(islands.links[i, tb.ROOT])


def bound_for_mechanism(n: int, row: Array, joints: Joints) -> None:
    """Note what the island of a mechanism may have for it, and loses: in whatever order they come.

    What is likely for one of its mechanisms is so for all of the island, unless another gives any.
    """
    turned = joints.mechanisms[n, tb.M_TURNED_BY_MOTOR] == 1
    status, powered = joints.mechanisms[n, tb.M_STATUS], joints.mechanisms[n, tb.M_TIMED] == 1
    free = status == tb.FREE_OF_CONTACTS or status == tb.GOVERNED_ALONE
    if row[tb.DRIVEN_ENERGY] > 0.0:
        most = row[tb.ENERGY_START] + max(row[tb.WORK], 0.0)
        row[tb.ENERGY_START], row[tb.WORK] = max(most, row[tb.DRIVEN_ENERGY]), 0.0
        if not is_likely(n, row, joints) and (powered or turned or is_moved(n, row, joints)):
            row[tb.WORK] = UNLIMITED
    elif free or powered or may_get_any(n, row, joints):
        row[tb.WORK] = UNLIMITED
    elif row[tb.WORK] + row[tb.LIFT_BEYOND_MOTION] < 0.0:
        work = row[tb.WORK] + row[tb.LIFT_BEYOND_MOTION]
        least = kept_way(row[tb.ENERGY_START], row[tb.LIFT_WORK], work)
        row[tb.KEPT_WAY] = least if rests_on_ground(row) and not turned else 1.0
        row[tb.ENERGY_START] = kinetic_energy_most(row[tb.ENERGY_START], work)
        row[tb.WORK] = 0.0


def sum_masses_and_lift_work(
    control: Control,
    bodies: Bodies,
    touching: Touching,
    constraints: Constraints,
    islands: Islands,
) -> None:
    """Add up masses, and what the overlaps of each island may give back, J; let it keep its way."""
    gravity = (control.settings[tb.GRAVITY_X], control.settings[tb.GRAVITY_Y])
    for k in range(constraints.counts[tb.ACTIVE]):
        row = islands.energy[touching.active[k]]
        row[tb.KEPT_WAY], row[tb.LIFT_WORK], row[tb.DRIVEN_ENERGY] = 1.0, 0.0, 0.0
        row[tb.ISLAND_MASS] = row[tb.ISLAND_LOAD] = 0.0
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        if bodies.kind[i] == tb.DYNAMIC:
            load, mass = bodies.load[i], 1.0 / bodies.properties[i, tb.INVERSE_MASS]
            of_substep = lift_work(mass, gravity, (load[0], load[1]), control.settings[tb.SUBSTEP])
            substeps = control.counts[tb.PART_SUBSTEPS]
            row = islands.energy[islands.links[i, tb.ROOT]]
            row[tb.LIFT_WORK] += substeps * of_substep
            row[tb.ISLAND_MASS] += mass
            row[tb.ISLAND_LOAD] += load_size(mass, gravity, (load[0], load[1]))


def rests_on_ground(row: Array) -> bool:
    """Return whether an island is seen from a support that stands still."""
    moves = abs(row[tb.REFERENCE]) + abs(row[tb.REFERENCE + 1]) + abs(row[tb.REFERENCE + 2])
    return bool(row[tb.SUPPORT] == SUPPORTED_BY_ONE and moves == 0.0)
