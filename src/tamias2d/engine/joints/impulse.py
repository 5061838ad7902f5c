"""The impulse of a row of a joint, as it acts on the bodies that the joint holds (DD57)."""

from tamias2d.engine.joints.linearise import ENDS_OF_JOINT
from tamias2d.engine.tables import (
    HELD_INVERSE_INERTIA,
    INVERSE_MASS,
    J_GIVEN,
    J_MEMBER,
    J_NODE,
    J_PULL,
    J_ROW,
    J_TOTAL,
    JOINED_SLOT,
    SPIN,
    SUBSTEP_START,
    UNUSED,
    VX,
    VY,
    Bodies,
    Joints,
)
from tamias2d.generated.joint_rows import ROW
from tamias2d.generated.joint_step import (
    angular_momentum_later,
    angular_velocity_later,
    momentum_later,
    velocity_later,
)


def apply_joint_impulse(j: int, r: int, impulse: float, bodies: Bodies, joints: Joints) -> None:
    """Give the bodies of a joint the impulse of a row, and add it to those of the step.

    It is not what contacts have done, and so it also changes with what the substep began.
    """
    ends, numbers = joints.joints[j], joints.numbers[j]
    numbers[J_PULL + r] += impulse
    numbers[J_GIVEN + r] += impulse
    for end in range(ENDS_OF_JOINT):
        if ends[J_NODE + end] == UNUSED:
            continue
        i, at = joints.members[ends[J_MEMBER + end], JOINED_SLOT], J_ROW + ROW * r + 1 + 3 * end
        slope, turning, to = (numbers[at], numbers[at + 1]), numbers[at + 2], J_TOTAL + 3 * end
        numbers[to], numbers[to + 1] = momentum_later(
            (numbers[to], numbers[to + 1]), impulse, slope
        )
        numbers[to + 2] = angular_momentum_later(numbers[to + 2], impulse, turning)
        if ends[J_NODE + end] >= 0:
            inverse_mass = bodies.properties[i, INVERSE_MASS]
            now, state = bodies.motion[i], bodies.substep_state[i]
            by_x, by_y = velocity_later((0.0, 0.0), impulse, slope, inverse_mass)
            held = joints.places[ends[J_MEMBER + end], HELD_INVERSE_INERTIA]
            turn = angular_velocity_later(0.0, impulse, turning, held)
            now[VX], now[VY], now[SPIN] = now[VX] + by_x, now[VY] + by_y, now[SPIN] + turn
            state[SUBSTEP_START] += by_x
            state[SUBSTEP_START + 1] += by_y
            state[SUBSTEP_START + 2] += turn
