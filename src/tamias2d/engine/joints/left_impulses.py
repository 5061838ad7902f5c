"""What springs of joints have left to give where bodies have moved to in a substep (IM19).

Cost: a visit to each joint of a mechanism.
"""

from tamias2d.engine.joints.angle_laws import is_law, turn_by_law
from tamias2d.engine.joints.impulse import apply_joint_impulse
from tamias2d.engine.tables import (
    J_FIRMNESS,
    J_GIVEN,
    J_LAW,
    J_SHARE,
    M_HINGED,
    M_JOINT,
    SPRING,
    Bodies,
    Joints,
)
from tamias2d.generated.joint_step import left_impulse


def give_left(n: int, bodies: Bodies, joints: Joints) -> None:
    """Let the springs of a mechanism that was just written give what they have left."""
    tree = joints.mechanisms[n, M_HINGED] == 1
    for j in range(joints.mechanisms[n, M_JOINT], joints.mechanisms[n + 1, M_JOINT]):
        numbers = joints.numbers[j]
        if joints.joints[j, J_LAW] == SPRING and numbers[J_FIRMNESS] > 0.0:
            impulse = left_impulse(numbers[J_GIVEN], numbers[J_SHARE])
            if tree and is_law(j, joints):
                turn_by_law(j, impulse, bodies, joints)
            else:
                apply_joint_impulse(j, 0, impulse, bodies, joints)
