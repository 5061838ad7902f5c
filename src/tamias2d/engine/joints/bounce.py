"""Limits that bounce: a row that strikes one leaves it as the step ends (IM15).

Cost: where there are limits that bounce, a visit to each of these in a substep.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.governed import is_leant_on, is_limit
from tamias2d.engine.joints.solve import rate_of_row
from tamias2d.engine.tables import Bodies, Joints
from tamias2d.generated.definitions import normal_velocity_after


def note_limits(n: int, bodies: Bodies, joints: Joints) -> None:
    """Note where the limits of a mechanism are as a substep begins, and at which rates."""
    if joints.mechanisms[n, tb.M_BOUNCING] == 0:
        return
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        if joints.laws[j, tb.LAW_RESTITUTION] > 0.0:
            numbers = joints.numbers[j]
            numbers[tb.J_VALUE_START] = numbers[tb.J_ROW]
            numbers[tb.J_RATE_START] = rate_of_row(j, 0, bodies, joints)


def bounce_limits(n: int, bodies: Bodies, joints: Joints) -> None:
    """Let rows leave the limits that they struck in a part, as it ends.

    One that leaves faster by itself, as a spring has pushed it since, is left alone; one on which a
    motor without a maximum leans stays there.
    """
    if joints.mechanisms[n, tb.M_BOUNCING] == 0:
        return
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        restitution, struck = joints.laws[j, tb.LAW_RESTITUTION], joints.numbers[j, tb.J_STRUCK]
        if restitution > 0.0 and struck != 0.0 and not is_leant_on(j, joints):
            rate = normal_velocity_after(restitution, struck)
            sign = -1.0 if struck > 0.0 else 1.0
            if sign * rate_of_row(j, 0, bodies, joints) < sign * rate:
                joints.joints[j, tb.J_STATE] = tb.HOLDS
                joints.laws[j, tb.LAW_RATE] = rate


def strikes(n: int, joints: Joints) -> bool:
    """Return whether a mechanism strikes a limit in a part: one that has not pushed before."""
    if joints.mechanisms[n, tb.M_GOVERNED] == 0:
        return False
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        pushes = joints.numbers[j, tb.J_PULL] != 0.0 and joints.numbers[j, tb.J_PUSHED] == 0.0
        if pushes and is_limit(joints.joints[j, tb.J_LAW]):
            return True
    return False
