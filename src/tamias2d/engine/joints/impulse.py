"""The impulse of a row of a joint, as it acts on the bodies that the joint holds (DD57)."""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Bodies, Joints
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
    numbers[tb.J_PULL + r] += impulse
    numbers[tb.J_GIVEN + r] += impulse
    for end in range(tb.ENDS_OF_JOINT):
        if ends[tb.J_NODE + end] == tb.UNUSED:
            continue
        i, at = (
            joints.members[ends[tb.J_MEMBER + end], tb.JOINED_SLOT],
            tb.J_ROW + ROW * r + 1 + 3 * end,
        )
        slope, turning, to = (numbers[at], numbers[at + 1]), numbers[at + 2], tb.J_TOTAL + 3 * end
        numbers[to], numbers[to + 1] = momentum_later(
            (numbers[to], numbers[to + 1]), impulse, slope
        )
        numbers[to + 2] = angular_momentum_later(numbers[to + 2], impulse, turning)
        if ends[tb.J_NODE + end] >= 0:
            place = joints.places[ends[tb.J_MEMBER + end]]
            now, state = bodies.motion[i], bodies.substep_state[i]
            by_x, by_y = velocity_later((0.0, 0.0), impulse, slope, place[tb.SLOWED_INVERSE_MASS])
            turn = angular_velocity_later(0.0, impulse, turning, place[tb.HELD_INVERSE_INERTIA])
            now[tb.VX], now[tb.VY], now[tb.SPIN] = (
                now[tb.VX] + by_x,
                now[tb.VY] + by_y,
                now[tb.SPIN] + turn,
            )
            state[tb.SUBSTEP_START] += by_x
            state[tb.SUBSTEP_START + 1] += by_y
            state[tb.SUBSTEP_START + 2] += turn
