"""How fast motors drive and what they put in (GD22), and which limits joints reach (GD21)."""

import numpy as np

from tamias2d.generated.definitions import mean_row_force, motor_power
from tamias2d.simulator.joint_columns import JointColumns
from tamias2d.spec.constraint import ENDS
from tamias2d.state import Array, IntArray


def drives_of(
    joints: JointColumns, impulses: Array, pose: Array, velocity: Array, time_step: float
) -> tuple[Array, Array]:
    """Return the speeds (j,) of motors now, rad/s or m/s, and their powers (j,), W.

    A power is what a motor gave on average in the last step, of so many s, times its speed now. The
    impulses (r, 3, 3) are those of all rows on A, B and C, N s, N s and N m s; bodies have poses
    and velocities (n + 1, 3), the plane the last ones.
    """
    speed, power = np.zeros(len(joints.names)), np.zeros(len(joints.names))
    for measure, rows in joints.driven:
        values = measure.values(pose, velocity)
        functions, shape = measure.functions, (len(rows),)
        (rate,) = functions.rate(values)
        slopes = np.zeros((len(rows), len(ENDS), 3))
        for k, end in enumerate(ENDS):
            if end in functions.slopes:
                parts = functions.slopes[end](values)
                slopes[:, k] = np.transpose([np.broadcast_to(part, shape) for part in parts])
        size = np.sum(slopes * slopes, axis=(1, 2))
        given = np.sum(slopes * impulses[rows], axis=(1, 2))
        speed[measure.number] = rate
        of_motors = np.divide(given, size, out=np.zeros(shape), where=size > 0.0)
        np.add.at(power, measure.number, motor_power(mean_row_force(of_motors, time_step), rate))
    return speed, power


def limits_reached(joints: JointColumns, pushed: Array) -> IntArray:
    """Return which limits (j,) pushed in a step: -1 for the lower, 1 for the upper one, else 0.

    What each row gave as a limit is known (r,), N s or N m s.
    """
    reached = np.zeros(len(joints.names), dtype=np.int64)
    row, joint, side = joints.limits
    pushes = pushed[row] > 0.0
    reached[joint[pushes]] = side[pushes]
    return reached
