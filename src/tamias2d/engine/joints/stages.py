"""What joints do in each stage of a step; each of these functions is called by one of the stages.

They are left out of the compiled engine for scenes without joints, and so a call is a statement by
itself. A mechanism that no contact touches is taken through the step by itself, with forces at both
ends of each substep; one that is touched is solved before and after the contacts (IM15).
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.energy import bound_mechanism, note_energy_of_springs
from tamias2d.engine.joints.governed import begin_motors, begin_rows
from tamias2d.engine.joints.hinge_laws import keep_tree_positions
from tamias2d.engine.joints.hinge_net import (
    begin_net,
    bring_net_to_aims,
    fit_net,
    linearise_net,
    store_links,
)
from tamias2d.engine.joints.hinge_solve import aim_tree, fit_tree
from tamias2d.engine.joints.hinge_tree import hang_tree, linearise_tree, store_hinge_impulses
from tamias2d.engine.joints.left_impulses import give_left, note_left
from tamias2d.engine.joints.linearise import (
    factor_mechanism,
    linearise,
    note_node_masses,
    place_members,
    turn_members,
)
from tamias2d.engine.joints.moments import note_after_joints, note_before_joints
from tamias2d.engine.joints.solve import aim_joints, keep_positions, keep_velocities
from tamias2d.engine.joints.tree_blocks import (
    aim_blocks,
    begin_blocks,
    bring_blocks_to_aims,
    fit_blocks,
    give_left_of_blocks,
    note_left_of_blocks,
    store_blocks,
    write_blocks,
)
from tamias2d.engine.solver.energy import UNLIMITED
from tamias2d.engine.solver.slabs import list_all
from tamias2d.engine.springs.substep import activate
from tamias2d.engine.tables import Bodies, Islands, Joints, World
from tamias2d.generated.joint_step import (
    half_decay,
    half_gain,
    kick_velocity_later,
    kick_velocity_start,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

PULLED = 100.0  # substeps: of what is moved by hand a joint that follows lets 2e-10 be left by then


def clear_of_joints(clear: bool, world: World) -> bool:
    """Return whether bodies that have no contacts may go ballistically: not with joints."""
    return clear and world.joints.counts[tb.JOINTS] == 0


def note_places(world: World) -> None:
    """Note which slots the members of mechanisms have, as a batch of steps begins."""
    joints = world.joints
    if joints.counts[tb.JOINTS] == 0:
        return
    joints.members[0, tb.JOINED_SLOT] = len(world.bodies.kind) - 1  # the plane is the idle body
    for m in range(1, len(joints.members)):
        joints.members[m, tb.JOINED_SLOT] = world.state.slot_of_body[
            joints.members[m, tb.JOINED_BODY]
        ]


def hold_tied(islands: Islands, joints: Joints) -> None:
    """Mark the islands of mechanisms that are tied to what nothing pushes."""
    for n in range(joints.counts[tb.MECHANISMS]):
        if joints.mechanisms[n, tb.M_TIED] == 1:
            i = joints.members[joints.sparse[n, tb.I_NODE] + 1, tb.JOINED_SLOT]
            islands.energy[islands.links[i, tb.ROOT], tb.IS_HELD] = 1.0


def note_mechanisms(world: World) -> None:
    """Place the members of mechanisms, and note which of these are awake, before arranging."""
    joints = world.joints
    if joints.counts[tb.JOINTS] == 0:
        return
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


def place_moved(anew: bool, bodies: Bodies, joints: Joints) -> None:
    """Place all members anew, or where one is not where it was; rows of such have to be new."""
    last = joints.sparse[joints.counts[tb.MECHANISMS], tb.I_NODE] + 1
    anew = anew or have_moved(0, 1, bodies, joints)
    anew = anew or have_moved(last, len(joints.members), bodies, joints)
    moved = anew
    for n in range(joints.counts[tb.MECHANISMS]):
        first, last = joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1
        if anew or have_moved(first, last, bodies, joints):
            joints.mechanisms[n, tb.M_WRITTEN], moved = 0, True
    if moved:
        place_members(0, len(joints.members), 0.0, bodies, joints)
    else:
        turn_members(0, len(joints.members), joints)


def pull_after_moved(bodies: Bodies, joints: Joints) -> None:
    """Note which mechanisms follow what they are tied to, as it was moved by hand since a step."""
    last = joints.sparse[joints.counts[tb.MECHANISMS], tb.I_NODE] + 1
    if not have_moved(last, len(joints.members), bodies, joints):
        return
    for n in range(joints.counts[tb.MECHANISMS]):
        for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
            for end in range(tb.ENDS_OF_JOINT):
                m = joints.joints[j, tb.J_MEMBER + end]
                tied = joints.joints[j, tb.J_NODE + end] == tb.NOT_PUSHED
                if tied and have_moved(m, m + 1, bodies, joints):
                    joints.numbers[joints.mechanisms[n, tb.M_JOINT], tb.J_PULLED] = PULLED


def have_moved(first: int, last: int, bodies: Bodies, joints: Joints) -> bool:
    """Return whether members are not where they were placed last."""
    moved = False
    for m in range(first, last):
        pose, place = bodies.pose[joints.members[m, tb.JOINED_SLOT]], joints.places[m]
        same = (place[tb.PLACE_X] == pose[tb.X]) & (place[tb.PLACE_Y] == pose[tb.Y])
        moved = moved | (not (same & (place[tb.PLACE_ANGLE] == pose[tb.ANGLE])))
    return bool(moved)


def is_asleep(n: int, islands: Islands, joints: Joints) -> bool:
    """Return whether a mechanism sleeps; its bodies do so together."""
    first = joints.sparse[n, tb.I_NODE]
    return bool(islands.links[joints.members[first + 1, tb.JOINED_SLOT], tb.SLEEP_ID] > 0)


def activate_joined(world: World) -> None:
    """Make the bodies of mechanisms active, and note which mechanisms contacts touch.

    Those with springs are solved as those that are touched, but once only; limits and motors are
    chosen twice, too.
    """
    joints, bodies = world.joints, world.bodies
    awake = touched_ones = 0
    for n in range(joints.counts[tb.MECHANISMS]):
        if joints.mechanisms[n, tb.M_STATUS] != tb.ASLEEP:
            first, last = joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]
            touched = 0
            for m in range(first + 1, last + 1):
                touched += bodies.moved[joints.members[m, tb.JOINED_SLOT]]
            touched += joints.mechanisms[n, tb.M_CHOOSING]
            alone = (
                tb.GOVERNED_ALONE
                if joints.mechanisms[n, tb.M_GOVERNED] == 1
                else tb.FREE_OF_CONTACTS
            )
            joints.mechanisms[n, tb.M_STATUS] = tb.IN_CONTACT if touched > 0 else alone
            awake += 1
            touched_ones += joints.mechanisms[n, tb.M_STATUS] != tb.FREE_OF_CONTACTS
    joints.counts[tb.MECHANISMS_AWAKE], joints.counts[tb.MECHANISMS_TOUCHED] = awake, touched_ones
    for n in range(joints.counts[tb.MECHANISMS]):
        if joints.mechanisms[n, tb.M_STATUS] != tb.ASLEEP:
            for m in range(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1):
                activate(
                    joints.members[m, tb.JOINED_SLOT], bodies, world.touching, world.constraints
                )
    for m in range(joints.counts[tb.FIRST_KINEMATIC], len(joints.members) if awake > 0 else 0):
        activate(joints.members[m, tb.JOINED_SLOT], bodies, world.touching, world.constraints)


def join_slabs(tree_count: int, world: World) -> None:
    """Make one slab of all where mechanisms are awake: they reach from any slab to any other."""
    constraints = world.constraints
    if world.joints.counts[tb.MECHANISMS_AWAKE] > 0 and constraints.counts[tb.SLABS] > 1:
        constraints.counts[tb.SLABS] = 1
        constraints.slabs[1, tb.S_TREE] = tree_count
        list_all(world.bodies, world.touching, constraints)


def begin_joints(substep: float, world: World) -> None:
    """Begin a step; free of contacts, velocities go back by half a substep.

    Rows are found anew unless the last step has left them as they are to be.
    """
    joints, bodies = world.joints, world.bodies
    if joints.counts[tb.MECHANISMS_AWAKE] == 0:
        return
    for n in range(joints.counts[tb.MECHANISMS]):
        if joints.mechanisms[n, tb.M_STATUS] != tb.ASLEEP:
            if note_node_masses(n, substep, bodies, joints):
                joints.mechanisms[n, tb.M_WRITTEN] = 0
            if joints.mechanisms[n, tb.M_GOVERNED] == 1:
                begin_rows(n, joints)
            begin_impulses(n, world.control.progress[tb.IMPULSE_RATIO], joints)
            if joints.mechanisms[n, tb.M_HINGED] == 1 and joints.mechanisms[n, tb.M_MESHED] == 1:
                begin_net(n, bodies, joints)
            if joints.mechanisms[n, tb.M_IN_BLOCK] == 0 and joints.mechanisms[n, tb.M_WRITTEN] == 0:
                write_mechanism(n, bodies, joints)
            joints.mechanisms[n, tb.M_HALF] = joints.mechanisms[n, tb.M_STATUS] != tb.IN_CONTACT
            if joints.mechanisms[n, tb.M_HALF] == 1:
                kick_half(n, False, bodies, joints)
    begin_blocks(bodies, joints)
    for n in range(joints.counts[tb.MECHANISMS]):
        joints.mechanisms[n, tb.M_WRITTEN] = 0
        if joints.mechanisms[n, tb.M_STATUS] != tb.ASLEEP:
            note_energy_of_springs(n, joints)


def write_mechanism(n: int, bodies: Bodies, joints: Joints) -> None:
    """Write the rows of a mechanism where its bodies are, and its matrix."""
    hinged, meshed = joints.mechanisms[n, tb.M_HINGED] == 1, joints.mechanisms[n, tb.M_MESHED] == 1
    if hinged and meshed:
        linearise_net(n, bodies, joints)
    elif hinged:
        linearise_tree(n, bodies, joints)
    else:
        linearise(n, bodies, joints)


def begin_impulses(n: int, ratio: float, joints: Joints) -> None:
    """Begin to add up the impulses of a part; those of a mesh count for a substep of this one."""
    whole = joints.numbers[joints.mechanisms[n, tb.M_JOINT]]
    whole[tb.J_MOMENT] = whole[tb.J_GAIN] = 0.0
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        for k in range(tb.J_TOTAL, tb.J_GIVEN + 3):
            joints.numbers[j, k] = 0.0
        for k in range(tb.J_WARM, tb.J_WARM + 3):
            joints.numbers[j, k] *= ratio
        joints.numbers[j, tb.J_LEFT] = joints.numbers[j, tb.J_LEFT_BEFORE]


def keep_joint_impulses(world: World) -> None:
    """Add the impulses of a part that was taken to those of the step, and note the forces."""
    joints = world.joints
    known = found_to_tell(joints)
    time = world.control.progress[tb.PART_TIME]
    kept = 0.0 if world.control.counts[tb.TICK] == 0 else 1.0
    substeps = world.control.counts[tb.PART_SUBSTEPS]
    for n in range(joints.counts[tb.MECHANISMS]):
        if joints.mechanisms[n, tb.M_STATUS] != tb.ASLEEP:
            first = joints.numbers[joints.mechanisms[n, tb.M_JOINT]]
            first[tb.J_PULLED] = max(first[tb.J_PULLED] - substeps, 0.0)
            for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
                numbers = joints.numbers[j]
                for k in range(9):
                    before = kept * numbers[tb.J_STEP_TOTAL + k]
                    numbers[tb.J_STEP_TOTAL + k] = before + numbers[tb.J_TOTAL + k]
                numbers[tb.J_LEFT_BEFORE] = numbers[tb.J_LEFT]
                numbers[tb.J_RESERVE] = numbers[tb.J_RESERVE_LATER]
                numbers[tb.J_MOTION] = numbers[tb.J_MOTION_LATER]
                numbers[tb.J_SCALE] = numbers[tb.J_SCALE_LATER]
                for k in range(3):
                    numbers[tb.J_FORCE + k] = numbers[tb.J_PULL + k] / time
                    if numbers[tb.J_APART + k] > numbers[tb.J_SLIGHT + k]:
                        joints.counts[tb.JOINTS_APART] = 1
                if numbers[tb.J_TURNED] > 0.0:
                    joints.counts[tb.JOINTS_TURNED] = 1
                if numbers[tb.J_GAIN] > 0.0:
                    joints.counts[tb.JOINTS_GAINED] = 1
                    numbers[tb.J_GAINED] = 1.0
    if found_to_tell(joints) > known:
        world.control.counts[tb.LIMITS] += 1


def found_to_tell(joints: Joints) -> int:
    """Return how many kinds of things were found to tell of joints."""
    counts = joints.counts
    return int(counts[tb.JOINTS_APART] + counts[tb.JOINTS_TURNED] + counts[tb.JOINTS_GAINED])


def solve_joints(again: bool, substep: float, world: World) -> None:
    """Let joints hold at the end of a substep; again, after contacts were visited."""
    joints, bodies = world.joints, world.bodies
    if joints.counts[tb.MECHANISMS_AWAKE] == 0:
        return
    control = world.control
    if not again and joints.counts[tb.FIRST_KINEMATIC] < len(joints.members):
        first, last = joints.counts[tb.FIRST_KINEMATIC], len(joints.members)
        place_members(first, last, substep, bodies, joints)
    length = min(substep * control.counts[tb.SUBSTEPS] / control.settings[tb.TIME_STEP], 1.0)
    if not again:
        aim_blocks(length, joints)
    least = tb.IN_CONTACT if again else tb.FREE_OF_CONTACTS
    note_before_joints(least, tb.IN_CONTACT, world)
    bring_blocks_to_aims(least, again, substep, bodies, joints)
    for n in range(joints.counts[tb.MECHANISMS]):
        status = joints.mechanisms[n, tb.M_STATUS]
        if joints.mechanisms[n, tb.M_IN_BLOCK] == 1:
            continue
        if status == tb.IN_CONTACT or (status != tb.ASLEEP and not again):
            if not again:
                aim_mechanism(n, length, joints)
                begin_motors(n, substep, bodies, joints)
            bring_to_end(n, again, length, substep, bodies, joints)
            joints.mechanisms[n, tb.M_HALF] = 0
    note_after_joints(least, tb.IN_CONTACT, world)


def aim_mechanism(n: int, length: float, joints: Joints) -> None:
    """Note to which values a substep brings the rows of a mechanism, as `aim_joints` does.

    A net needs no note.
    """
    hinged, meshed = joints.mechanisms[n, tb.M_HINGED] == 1, joints.mechanisms[n, tb.M_MESHED] == 1
    if hinged and not meshed:
        aim_tree(n, length, joints)
    elif not hinged:
        aim_joints(n, length, joints)


def bring_to_end(
    n: int, again: bool, length: float, substep: float, bodies: Bodies, joints: Joints
) -> None:
    """Change the velocities of a mechanism so that a substep leads to what its rows aim at."""
    hinged, meshed = joints.mechanisms[n, tb.M_HINGED] == 1, joints.mechanisms[n, tb.M_MESHED] == 1
    if hinged and meshed:
        bring_net_to_aims(n, again, length, substep, bodies, joints)
    elif hinged:
        keep_tree_positions(n, again, substep, bodies, joints)
    else:
        keep_positions(n, again, substep, bodies, joints)


def relax_joints(world: World) -> None:
    """Find the rows of mechanisms where bodies are; what springs have left is noted."""
    joints, bodies = world.joints, world.bodies
    if joints.counts[tb.MECHANISMS_AWAKE] == 0:
        return
    write_blocks(bodies, joints)
    note_left_of_blocks(joints)
    for n in range(joints.counts[tb.MECHANISMS]):
        alone = joints.mechanisms[n, tb.M_IN_BLOCK] == 0
        if alone and joints.mechanisms[n, tb.M_STATUS] != tb.ASLEEP:
            write_mechanism(n, bodies, joints)
            if joints.mechanisms[n, tb.M_GOVERNED] == 1:
                note_left(n, joints)


def fit_touched(world: World) -> None:
    """Let the velocities of touched and of governed mechanisms fit their rows as a step ends.

    Nothing is lost in the substeps before: what they do not fit, the next solution takes away.
    Those that no contact touches catch up with forces first, and with their springs.
    """
    joints = world.joints
    if joints.counts[tb.MECHANISMS_AWAKE] == 0:
        return
    for n in range(joints.counts[tb.MECHANISMS]):
        if joints.mechanisms[n, tb.M_STATUS] == tb.GOVERNED_ALONE:
            kick_half(n, True, world.bodies, joints)
    note_before_joints(tb.GOVERNED_ALONE, tb.IN_CONTACT, world)
    for n in range(joints.counts[tb.MECHANISMS]):
        alone = joints.mechanisms[n, tb.M_IN_BLOCK] == 0
        if alone and joints.mechanisms[n, tb.M_STATUS] == tb.GOVERNED_ALONE:
            give_left(n, world.bodies, joints)
    give_left_of_blocks(world.bodies, joints)
    fit_velocities(
        tb.GOVERNED_ALONE, world.control.settings[tb.SUBSTEP], world.bodies, world.joints
    )
    note_after_joints(tb.GOVERNED_ALONE, tb.IN_CONTACT, world)


def fit_velocities(least: int, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Take the rates of their rows from the velocities of mechanisms with at least a status."""
    fit_blocks(least, tb.IN_CONTACT, bodies, joints)
    for n in range(joints.counts[tb.MECHANISMS]):
        alone = joints.mechanisms[n, tb.M_IN_BLOCK] == 0
        if alone and joints.mechanisms[n, tb.M_STATUS] >= least:
            fit(n, 0.0, substep, bodies, joints)


def fit(n: int, warm: float, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Take the rates of its rows from the velocities of a mechanism; `warm` is for meshes.

    What is left in a net parts it little in a substep, s. Springs do not count.
    """
    hinged, meshed = joints.mechanisms[n, tb.M_HINGED] == 1, joints.mechanisms[n, tb.M_MESHED] == 1
    governed = joints.mechanisms[n, tb.M_GOVERNED] == 1
    if hinged and meshed:
        fit_net(n, warm, substep, bodies, joints)
    elif hinged:
        if governed:
            hang_tree(n, 0.0, bodies, joints)
        fit_tree(n, bodies, joints)
    else:
        if governed:
            factor_mechanism(n, 0.0, bodies, joints)
        keep_velocities(n, warm, bodies, joints)


def end_joints(world: World) -> None:
    """End a step: let the velocities of mechanisms that are free of contacts catch up, and fit."""
    joints, bodies = world.joints, world.bodies
    energy = world.constraints.energy
    if joints.counts[tb.MECHANISMS_AWAKE] == 0:
        return
    for n in range(joints.counts[tb.MECHANISMS]):
        if joints.mechanisms[n, tb.M_STATUS] == tb.FREE_OF_CONTACTS:
            kick_half(n, True, bodies, joints)
    note_before_joints(tb.FREE_OF_CONTACTS, tb.FREE_OF_CONTACTS, world)
    fit_blocks(tb.FREE_OF_CONTACTS, tb.FREE_OF_CONTACTS, bodies, joints)
    store_blocks(joints)
    for n in range(joints.counts[tb.MECHANISMS]):
        alone = joints.mechanisms[n, tb.M_IN_BLOCK] == 0
        status = joints.mechanisms[n, tb.M_STATUS]
        if status == tb.FREE_OF_CONTACTS and alone:
            fit(n, 0.5, world.control.settings[tb.SUBSTEP], bodies, joints)
    note_after_joints(tb.FREE_OF_CONTACTS, tb.FREE_OF_CONTACTS, world)
    for n in range(joints.counts[tb.MECHANISMS]):
        alone = joints.mechanisms[n, tb.M_IN_BLOCK] == 0
        status = joints.mechanisms[n, tb.M_STATUS]
        if status != tb.ASLEEP and status != tb.IN_CONTACT:
            bound_mechanism(n, world.control, bodies, joints, world.islands, energy)
        awake = joints.mechanisms[n, tb.M_STATUS] != tb.ASLEEP
        joints.mechanisms[n, tb.M_WRITTEN] = 1 if awake else 0
        if alone and awake and joints.mechanisms[n, tb.M_HINGED] == 1:
            if joints.mechanisms[n, tb.M_MESHED] == 1:
                store_links(n, joints)
            else:
                store_hinge_impulses(n, joints)


def past_untouched(first: int, last: int, world: World) -> int:
    """Return from which of some active bodies on energies are summed: none where nothing touches.

    Mechanisms have bounded their own then.
    """
    alone = world.touching.counts[tb.TOUCHING] + world.springs.counts[tb.NETWORKS_TOUCHED] == 0
    if not alone or world.joints.counts[tb.MECHANISMS_TOUCHED] > 0:
        return first
    for k in range(first, last):
        flight = world.bodies.flight[world.touching.active_by_slab[k]]
        flight[tb.FORCE_GAIN] = flight[tb.FORCE_GAIN + 1] = flight[tb.FORCE_GAIN + 2] = 0.0
    return last


def look_at_touched(world: World) -> None:
    """Let the energy of each island be looked at if contacts touch mechanisms, not their sum."""
    energy = world.constraints.energy
    if (
        world.joints.counts[tb.MECHANISMS_AWAKE] > 0
        and world.joints.counts[tb.MECHANISMS_TOUCHED] > 0
    ):
        energy[tb.TOTAL_ENERGY_NOW] = 2.0 * UNLIMITED


def kick_half(n: int, ahead: bool, bodies: Bodies, joints: Joints) -> None:
    """Take the velocities of a mechanism half a substep ahead of the forces, or behind them."""
    for node in range(joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]):
        i = joints.sparse[node, tb.N_BODY]
        now, state = bodies.motion[i], bodies.substep_state[i]
        drag, turning = state[tb.DRAG_FACTOR], state[tb.DRAG_FACTOR + 2]
        if drag == 1.0 and turning == 1.0:  # without roots and quotients
            kick_body(ahead, 1.0, 1.0, now, state)
        else:
            kick_body(ahead, half_decay(drag), half_decay(turning), now, state)


@inlined
def kick_body(ahead: bool, decay: float, turning_decay: float, now: Array, state: Array) -> None:
    """Take a body's velocities half a substep ahead, or behind, with their factors by drag."""
    for k in range(3):
        factor = turning_decay if k == 2 else decay
        gain = half_gain(state[tb.INCREMENT + k], factor)
        later = kick_velocity_later(now[k], factor, gain)
        now[k] = later if ahead else kick_velocity_start(now[k], factor, gain)
        state[tb.SUBSTEP_START + k] = now[k]
