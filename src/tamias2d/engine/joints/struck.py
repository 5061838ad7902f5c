"""How the joints of struck mechanisms answer impulses: linearly, and at once (DD107).

Springs and motors with a maximum give nothing in an instant, and limits hold that did. No rows
yield: rates can be taken away without giving energy.
"""

from math import inf

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.block_solve import fit_block, has_status
from tamias2d.engine.joints.hinge_solve import solve_hinges, write_rates_of_tree
from tamias2d.engine.joints.hinge_tree import hang_tree
from tamias2d.engine.joints.linearise import factor_mechanism
from tamias2d.engine.joints.moments import note_after_joints, note_before_joints
from tamias2d.engine.joints.solve import solve_joint_errors, start_impulses, write_rates
from tamias2d.engine.joints.tree_blocks import hang_block
from tamias2d.engine.tables import Joints, World


def begin_struck(joints: Joints) -> None:
    """Let go of the motors of struck mechanisms that have a maximum, and of springs."""
    for n in range(joints.counts[tb.MECHANISMS]):
        if is_governed_and_struck(n, joints):
            for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
                ends = joints.joints[j]
                ends[tb.J_STATE_BEFORE] = ends[tb.J_STATE]
                if ends[tb.J_LAW] == tb.MOTOR and joints.laws[j, tb.LAW_MOST] < inf:
                    ends[tb.J_STATE] = tb.FREE_ROW
            if joints.mechanisms[n, tb.M_HINGED] == 1:
                hang_tree(n, 0.0, joints)
            else:
                factor_mechanism(n, 0.0, joints)
    for b in range(joints.counts[tb.TREE_BLOCKS]):
        if joints.tree_blocks[b, tb.T_SPRUNG] == 1 and has_status(b, tb.STRUCK, tb.STRUCK, joints):
            hang_block(b, 0.0, joints)


def end_struck(joints: Joints) -> None:
    """Let mechanisms that were struck go on as ones in contact, and their motors as before.

    Springs and motors are found anew as the substep is solved.
    """
    for n in range(joints.counts[tb.MECHANISMS]):
        if is_governed_and_struck(n, joints):
            for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
                joints.joints[j, tb.J_STATE] = joints.joints[j, tb.J_STATE_BEFORE]
        if joints.mechanisms[n, tb.M_STATUS] == tb.STRUCK:
            joints.mechanisms[n, tb.M_STATUS] = tb.IN_CONTACT


def is_governed_and_struck(n: int, joints: Joints) -> bool:
    """Return whether a mechanism that is struck has limits, motors or springs, and is no lane's."""
    struck = joints.mechanisms[n, tb.M_STATUS] == tb.STRUCK
    governed = joints.mechanisms[n, tb.M_GOVERNED] == 1 and joints.mechanisms[n, tb.M_IN_BLOCK] == 0
    return bool(struck and governed)


def fit_struck(world: World) -> None:
    """Take the rates of their rows from the velocities of struck mechanisms."""
    bodies, joints = world.bodies, world.joints
    note_before_joints(tb.STRUCK, tb.STRUCK, world)
    for b in range(joints.counts[tb.TREE_BLOCKS]):
        if has_status(b, tb.STRUCK, tb.STRUCK, joints):
            fit_block(b, bodies, joints)
    for n in range(joints.counts[tb.MECHANISMS]):
        alone = joints.mechanisms[n, tb.M_IN_BLOCK] == 0
        if alone and joints.mechanisms[n, tb.M_STATUS] == tb.STRUCK:
            if joints.mechanisms[n, tb.M_HINGED] == 1:
                write_rates_of_tree(n, bodies, joints)
                solve_hinges(n, bodies, joints)
            else:
                start_impulses(n, 0.0, joints)
                write_rates(n, bodies, joints)
                solve_joint_errors(n, 0.0, inf, bodies, joints)
    note_after_joints(tb.STRUCK, tb.STRUCK, world)
