"""What joints do in each stage of a step; each of these functions is called by one of the stages.

They are left out of the compiled engine for scenes without joints, and so a call is a statement by
itself. A mechanism that no contact touches is taken through the step by itself, with forces at both
ends of each substep; one that is touched is solved before and after the contacts (IM15).
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.acceptance import may_be_rejected, note_most_motion
from tamias2d.engine.joints.block_gather import begin_blocks
from tamias2d.engine.joints.block_left import give_left_of_blocks, note_left_of_blocks
from tamias2d.engine.joints.block_scatter import store_blocks, store_springs_of_blocks
from tamias2d.engine.joints.block_solve import aim_blocks, bring_blocks_to_aims, fit_blocks
from tamias2d.engine.joints.bounce import bounce_limits, note_limits
from tamias2d.engine.joints.energy import (
    bound_mechanism,
    energy_of_mechanism,
    note_drive_of,
    note_energy_of_springs,
    rise_of_yielding,
)
from tamias2d.engine.joints.governed import begin_motors, begin_rows, end_motors
from tamias2d.engine.joints.half_kick import kick_half
from tamias2d.engine.joints.hinge_net import begin_net
from tamias2d.engine.joints.left_impulses import give_left, note_left
from tamias2d.engine.joints.linearise import note_node_masses, place_members
from tamias2d.engine.joints.mechanism import (
    aim_mechanism,
    bring_to_end,
    fit,
    store_mechanism,
    write_mechanism,
)
from tamias2d.engine.joints.moments import note_after_joints, note_before_joints
from tamias2d.engine.joints.opening import forget_opened
from tamias2d.engine.joints.step_impulses import begin_impulses
from tamias2d.engine.joints.tree_blocks import write_blocks
from tamias2d.engine.joints.yielding import hold_again, yields
from tamias2d.engine.tables import Bodies, Control, Joints, World

TICKS = 1 << tb.MOST_LEVEL  # of a step


def begin_joints(substep: float, world: World) -> None:
    """Begin a step; free of contacts, velocities go back by half a substep.

    Rows are found anew unless the last step has left them as they are to be.
    """
    joints, bodies = world.joints, world.bodies
    if joints.counts[tb.MECHANISMS_AWAKE] == 0:
        return
    begin_clock(world.control, joints)
    for n in range(joints.counts[tb.MECHANISMS]):
        if joints.mechanisms[n, tb.M_STATUS] != tb.ASLEEP:
            if joints.mechanisms[n, tb.M_TIMED] == 1:
                joints.mechanisms[n, tb.M_WRITTEN] = 0
            if note_node_masses(n, substep, bodies, joints):
                joints.mechanisms[n, tb.M_WRITTEN] = 0
            if joints.mechanisms[n, tb.M_GOVERNED] == 1:
                begin_rows(n, joints)
            begin_impulses(n, world.control.progress[tb.IMPULSE_RATIO], joints)
            if joints.mechanisms[n, tb.M_HINGED] == 1 and joints.mechanisms[n, tb.M_MESHED] == 1:
                begin_net(n, joints)
            if joints.mechanisms[n, tb.M_IN_BLOCK] == 0 and joints.mechanisms[n, tb.M_WRITTEN] == 0:
                write_mechanism(n, bodies, joints)
            note_limits(n, bodies, joints)
            joints.mechanisms[n, tb.M_HALF] = joints.mechanisms[n, tb.M_STATUS] != tb.IN_CONTACT
            if joints.mechanisms[n, tb.M_HALF] == 1:
                kick_half(n, False, bodies, joints)
    begin_blocks(bodies, joints)
    for n in range(joints.counts[tb.MECHANISMS]):
        joints.mechanisms[n, tb.M_WRITTEN] = 0
        if joints.mechanisms[n, tb.M_STATUS] != tb.ASLEEP:
            note_energy_of_springs(n, joints)


def begin_clock(control: Control, joints: Joints) -> None:
    """Note the instant at which a part begins, s: equations may change with time."""
    ticks = control.counts[tb.STEPS_TAKEN] * TICKS + control.counts[tb.TICK]
    joints.clock[tb.CLOCK_NOW] = ticks / TICKS * control.settings[tb.TIME_STEP]
    joints.clock[tb.CLOCK_AHEAD] = 0.0


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
                note_drive_of(n, substep, control, bodies, joints, world.islands)
                aim_mechanism(n, length, substep, joints)
                begin_motors(n, substep, bodies, joints)
            before, yielded = -1.0, yields(n, joints)
            if yielded or may_be_rejected(n, joints):
                before = energy_of_mechanism(n, bodies, joints, world.islands)
            note_most_motion(n, substep, bodies, joints)
            bring_to_end(n, again, length, substep, bodies, joints)
            if before >= 0.0 and (yielded or yields(n, joints)):
                rise_of_yielding(n, before, control, bodies, joints, world.islands)
            joints.mechanisms[n, tb.M_HALF] = 0
    note_after_joints(least, tb.IN_CONTACT, world)


def relax_joints(world: World) -> None:
    """Find the rows of mechanisms where bodies are; what springs have left is noted."""
    joints, bodies = world.joints, world.bodies
    if joints.counts[tb.MECHANISMS_AWAKE] == 0:
        return
    joints.clock[tb.CLOCK_NOW] += world.control.settings[tb.SUBSTEP]
    write_blocks(bodies, joints)
    note_left_of_blocks(joints)
    for n in range(joints.counts[tb.MECHANISMS]):
        alone = joints.mechanisms[n, tb.M_IN_BLOCK] == 0
        if alone and joints.mechanisms[n, tb.M_STATUS] != tb.ASLEEP:
            yielded = yields(n, joints)
            write_mechanism(n, bodies, joints)
            if yielded:
                hold_again(n, joints)
            if yielded and not yields(n, joints):
                write_mechanism(n, bodies, joints)
            forget_opened(n, joints)
            if joints.mechanisms[n, tb.M_GOVERNED] == 1:
                note_left(n, joints)
                note_limits(n, bodies, joints)


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
            end_motors(n, world.control.settings[tb.SUBSTEP], world.bodies, joints)
    note_before_joints(tb.GOVERNED_ALONE, tb.IN_CONTACT, world)
    for n in range(joints.counts[tb.MECHANISMS]):
        alone = joints.mechanisms[n, tb.M_IN_BLOCK] == 0
        if alone and joints.mechanisms[n, tb.M_STATUS] == tb.GOVERNED_ALONE:
            give_left(n, world.bodies, joints)
        if alone and joints.mechanisms[n, tb.M_STATUS] >= tb.GOVERNED_ALONE:
            bounce_limits(n, world.bodies, joints)
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
    store_springs_of_blocks(joints)
    for n in range(joints.counts[tb.MECHANISMS]):
        alone = joints.mechanisms[n, tb.M_IN_BLOCK] == 0
        status = joints.mechanisms[n, tb.M_STATUS]
        if status == tb.FREE_OF_CONTACTS and alone:
            fit(n, 0.5, world.control.settings[tb.SUBSTEP], bodies, joints)
    note_after_joints(tb.FREE_OF_CONTACTS, tb.FREE_OF_CONTACTS, world)
    for n in range(joints.counts[tb.MECHANISMS]):
        status = joints.mechanisms[n, tb.M_STATUS]
        if status != tb.ASLEEP and status != tb.IN_CONTACT:
            bound_mechanism(n, world.control, bodies, joints, world.islands, energy)
        awake = joints.mechanisms[n, tb.M_STATUS] != tb.ASLEEP
        joints.mechanisms[n, tb.M_WRITTEN] = 1 if awake else 0


def store_joints(world: World) -> None:
    """Store what went through hinges in a part, when contacts have rebounded, too."""
    joints = world.joints
    if joints.counts[tb.MECHANISMS_AWAKE] == 0:
        return
    store_blocks(joints)
    for n in range(joints.counts[tb.MECHANISMS]):
        alone = joints.mechanisms[n, tb.M_IN_BLOCK] == 0
        if alone and joints.mechanisms[n, tb.M_STATUS] != tb.ASLEEP:
            store_mechanism(n, joints)
