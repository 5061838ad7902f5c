"""What springs of joints have left to give where bodies have moved to in a substep (IM19).

Cost: a visit to each joint of a mechanism.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.angle_laws import is_law, turn_by_law
from tamias2d.engine.joints.impulse import apply_joint_impulse
from tamias2d.engine.tables import Bodies, Joints
from tamias2d.generated.joint_step import left_impulse


def note_left(n: int, joints: Joints) -> None:
    """Note what the springs of a mechanism have left: the next substep gives it with its own."""
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        if joints.joints[j, tb.J_LAW] == tb.SPRING:
            numbers, firm = joints.numbers[j], joints.numbers[j, tb.J_FIRMNESS]
            left = left_impulse(numbers[tb.J_GIVEN], numbers[tb.J_SHARE]) if firm > 0.0 else 0.0
            numbers[tb.J_LEFT] = left


def give_left(n: int, bodies: Bodies, joints: Joints) -> None:
    """Let the springs of a mechanism give what they have left as a step ends."""
    tree = joints.mechanisms[n, tb.M_HINGED] == 1
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        numbers = joints.numbers[j]
        if joints.joints[j, tb.J_LAW] == tb.SPRING and numbers[tb.J_FIRMNESS] > 0.0:
            if tree and is_law(j, joints):
                turn_by_law(j, numbers[tb.J_LEFT], bodies, joints)
            else:
                apply_joint_impulse(j, 0, numbers[tb.J_LEFT], bodies, joints)
            numbers[tb.J_LEFT] = 0.0
