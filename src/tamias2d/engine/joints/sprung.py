"""Mechanisms with springs in the groups whose energy is put right (DD91)."""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.energy import energy_of_springs
from tamias2d.engine.joints.island_charge import is_moved, support_mechanism, work_of_motors
from tamias2d.engine.solver.support import SUPPORTED_BY_MORE
from tamias2d.engine.tables import Integers, Joints, World


def or_sprung(found: bool, world: World) -> bool:
    """Return whether something was found, or joints have springs."""
    joints = world.joints
    for n in range(joints.counts[tb.MECHANISMS]):
        found = found or is_sprung(n, joints)
    return found


def is_sprung(n: int, joints: Joints) -> bool:
    """Return whether a mechanism is awake and has springs, or what changes with time."""
    awake = joints.mechanisms[n, tb.M_STATUS] != tb.ASLEEP
    return bool(awake and joints.mechanisms[n, tb.M_DRIVEN] == 1)


def group_of_mechanism(n: int, group: Integers, joints: Joints) -> int:
    """Return the root of the group of a mechanism."""
    return int(group[joints.sparse[joints.sparse[n, tb.I_NODE], tb.N_BODY]])


def join_mechanisms(world: World) -> None:
    """Make one group of the bodies of each mechanism, and of all that touches them."""
    joints, springs = world.joints, world.springs
    group = springs.group
    for n in range(joints.counts[tb.MECHANISMS]):
        first, last = joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]
        one = joints.sparse[first, tb.N_BODY]
        for node in range(first + 1, last):
            i, j = one, joints.sparse[node, tb.N_BODY]
            while group[i] != i:
                i = group[i]
            while group[j] != j:
                j = group[j]
            group[max(i, j)] = min(i, j)


def mark_sprung_mechanisms(world: World) -> None:
    """Note which groups have mechanisms with springs, and what ties these.

    What ties a mechanism may give it any energy if it turns, or was moved by hand.
    """
    bodies, joints, islands = world.bodies, world.joints, world.islands
    for n in range(joints.counts[tb.MECHANISMS]):
        root = group_of_mechanism(n, world.springs.group, joints)
        row = islands.energy[root]
        support_mechanism(n, root, bodies, islands, joints)
        if is_sprung(n, joints):
            row[tb.SPRUNG] = 1.0
        if is_moved(n, row, joints):
            row[tb.SUPPORT] = SUPPORTED_BY_MORE


def add_gains_of_mechanisms(world: World) -> None:
    """Add what springs of mechanisms have gained to that of groups, less what motors gave, J."""
    joints = world.joints
    for n in range(joints.counts[tb.MECHANISMS]):
        if joints.mechanisms[n, tb.M_STATUS] != tb.ASLEEP:
            row = world.islands.energy[group_of_mechanism(n, world.springs.group, joints)]
            before = joints.numbers[joints.mechanisms[n, tb.M_JOINT], tb.J_ENERGY]
            row[tb.SPRING_GAIN] += energy_of_springs(n, joints) - before
            row[tb.WORK] += work_of_motors(n, joints)
