"""Which mechanisms take part in a step: those that are awake, and what touches these."""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.placement import place_moved, pull_after_moved
from tamias2d.engine.solver.slabs import list_all
from tamias2d.engine.springs.substep import activate
from tamias2d.engine.tables import Islands, Joints, World

OUTWEIGHS = 25.0  # times its own mass, for each substep: what hangs on a body is too heavy for it


def clear_of_joints(clear: bool, world: World) -> bool:
    """Return whether bodies that have no contacts may go ballistically: not with joints."""
    return clear and world.joints.counts[tb.JOINTS] == 0


def hold_tied(islands: Islands, joints: Joints) -> None:
    """Mark the islands of mechanisms that are tied to what nothing pushes."""
    for n in range(joints.counts[tb.MECHANISMS]):
        if joints.mechanisms[n, tb.M_TIED] == 1:
            i = joints.members[joints.sparse[n, tb.I_NODE] + 1, tb.JOINED_SLOT]
            islands.held[islands.links[i, tb.ROOT]] = 1


def note_mechanisms(world: World) -> None:
    """Place the members of mechanisms, and note which of these are awake."""
    joints = world.joints
    if joints.counts[tb.JOINTS] == 0:
        return
    world.control.counts[tb.IMPACTS] = 0
    began = world.control.counts[tb.TICK] + world.control.counts[tb.RETAKEN] > 0
    if joints.counts[tb.PLACED] == 1 and not began:
        pull_after_moved(world.bodies, joints)
    place_moved(joints.counts[tb.PLACED] == 0, world.bodies, joints)
    joints.counts[tb.PLACED] = 1
    for n in range(joints.counts[tb.MECHANISMS]):
        asleep = is_asleep(n, world.islands, joints)
        if asleep != (joints.mechanisms[n, tb.M_STATUS] == tb.ASLEEP):
            joints.mechanisms[n, tb.M_STATUS] = tb.ASLEEP if asleep else tb.FREE_OF_CONTACTS
            world.touching.counts[tb.ARRANGED] = 0


def is_asleep(n: int, islands: Islands, joints: Joints) -> bool:
    """Return whether a mechanism sleeps; its bodies do so together."""
    first = joints.sparse[n, tb.I_NODE]
    return bool(islands.links[joints.members[first + 1, tb.JOINED_SLOT], tb.SLEEP_ID] > 0)


def activate_joined(world: World) -> None:
    """Make the bodies of mechanisms active, and note which mechanisms contacts touch.

    Those with springs, motors and limits are solved as those that are touched, but once only.
    """
    joints, bodies = world.joints, world.bodies
    awake = touched_ones = 0
    for n in range(joints.counts[tb.MECHANISMS]):
        if joints.mechanisms[n, tb.M_STATUS] != tb.ASLEEP:
            first, last = joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]
            touched = 0
            for m in range(first + 1, last + 1):
                touched += bodies.moved[joints.members[m, tb.JOINED_SLOT]]
            joints.mechanisms[n, tb.M_TOUCHED] = 1 if touched > 0 else 0
            alone = (
                tb.GOVERNED_ALONE
                if joints.mechanisms[n, tb.M_GOVERNED] == 1
                else tb.FREE_OF_CONTACTS
            )
            joints.mechanisms[n, tb.M_STATUS] = tb.IN_CONTACT if touched > 0 else alone
            awake += 1
            touched_ones += joints.mechanisms[n, tb.M_STATUS] != tb.FREE_OF_CONTACTS
            if touched > 0:
                note_outweighed(n, world)
    joints.counts[tb.MECHANISMS_AWAKE], joints.counts[tb.MECHANISMS_TOUCHED] = awake, touched_ones
    for n in range(joints.counts[tb.MECHANISMS]):
        if joints.mechanisms[n, tb.M_STATUS] != tb.ASLEEP:
            for m in range(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1):
                activate(
                    joints.members[m, tb.JOINED_SLOT], bodies, world.touching, world.constraints
                )
    for m in range(joints.counts[tb.FIRST_KINEMATIC], len(joints.members) if awake > 0 else 0):
        activate(joints.members[m, tb.JOINED_SLOT], bodies, world.touching, world.constraints)


def note_outweighed(n: int, world: World) -> None:
    """Note a body that contacts touch, and on which too much hangs by joints for the substeps.

    What it bears comes to it through the joints once in each of them.
    """
    control, bodies, joints = world.control, world.bodies, world.joints
    first, last = joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1
    total = 0.0
    for m in range(first, last):
        total += 1.0 / bodies.properties[joints.members[m, tb.JOINED_SLOT], tb.INVERSE_MASS]
    most = OUTWEIGHS * control.counts[tb.PART_SUBSTEPS]
    for m in range(first, last):
        i = joints.members[m, tb.JOINED_SLOT]
        heavy = total * bodies.properties[i, tb.INVERSE_MASS] > most
        if heavy and bodies.moved[i] > 0 and control.counts[tb.OUTWEIGHED] == 0:
            control.counts[tb.OUTWEIGHED] = i + 1
            control.counts[tb.LIMITS] += 1


def join_slabs(tree_count: int, world: World) -> None:
    """Make one slab of all where mechanisms are awake: they reach from any slab to any other."""
    constraints = world.constraints
    if world.joints.counts[tb.MECHANISMS_AWAKE] > 0 and constraints.counts[tb.SLABS] > 1:
        constraints.counts[tb.SLABS] = 1
        constraints.slabs[1, tb.S_TREE] = tree_count
        list_all(world.bodies, world.touching, constraints)
