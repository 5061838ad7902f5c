"""Mechanisms at rest: what keeps them from sleeping, and what wakes them (IM13)."""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.linearise import yield_of_row
from tamias2d.engine.joints.solve import rate_of_row
from tamias2d.engine.tables import Bodies, Islands, Joints
from tamias2d.engine.waking import SUPPORTED_AT_REST, SUPPORTED_IN_MOTION, wake_pair
from tamias2d.generated.joint_step import row_impulse_most

MOVING = 0.01  # of the rate that a motor gives its joint alone in a step: much may hang on it


def wake_tied(islands: Islands, joints: Joints) -> None:
    """Wake mechanisms that joints tie to a body which may wake others."""
    for n in range(joints.counts[tb.MECHANISMS]):
        i = joints.members[joints.sparse[n, tb.I_NODE] + 1, tb.JOINED_SLOT]
        for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
            for end in range(tb.ENDS_OF_JOINT):
                if joints.joints[j, tb.J_NODE + end] == tb.NOT_PUSHED:
                    by = joints.members[joints.joints[j, tb.J_MEMBER + end], tb.JOINED_SLOT]
                    wake_pair(i, by, islands.links)


def note_joined_support(time: float, bodies: Bodies, islands: Islands, joints: Joints) -> None:
    """Note that bodies which joints hold are supported by what these hold besides.

    So they are as a part of a step ends that took a time, s.
    """
    for n in range(joints.counts[tb.MECHANISMS]):
        timed = joints.mechanisms[n, tb.M_TIMED] == 1
        support = SUPPORTED_IN_MOTION if timed else SUPPORTED_AT_REST
        for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
            if motor_drives(j, time, bodies, joints):
                support = SUPPORTED_IN_MOTION
            for end in range(tb.ENDS_OF_JOINT):
                by = joints.members[joints.joints[j, tb.J_MEMBER + end], tb.JOINED_SLOT]
                tied = joints.joints[j, tb.J_NODE + end] == tb.NOT_PUSHED
                if tied and islands.links[by, tb.AWAKE] == 1:
                    support = SUPPORTED_IN_MOTION
        for m in range(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1):
            links = islands.links[joints.members[m, tb.JOINED_SLOT]]
            links[tb.SUPPORT_KIND] = max(links[tb.SUPPORT_KIND], support)


def motor_drives(j: int, time: float, bodies: Bodies, joints: Joints) -> bool:
    """Return whether a motor moves its joint, however slowly, in a time, s.

    One that gives all that it can does if the joint goes its way at a share of the rate that this
    gives it in that time: what is blocked only trembles.
    """
    ends, law, numbers = joints.joints[j], joints.laws[j], joints.numbers[j]
    if ends[tb.J_LAW] != tb.MOTOR or law[tb.LAW_RATE] == 0.0 or ends[tb.J_STATE] == tb.FREE_ROW:
        return False
    if ends[tb.J_STATE] == tb.HOLDS:
        return True
    forwards = 1.0 if ends[tb.J_STATE] == tb.AT_MOST else -1.0
    impulse = row_impulse_most(law[tb.LAW_MOST], time)
    moving = MOVING * impulse * yield_of_row(0, ends, numbers, joints)
    return forwards * rate_of_row(j, 0, bodies, joints) > moving
