"""The lines along which bodies go through a step, and how they are bent.

Serves: flight. Hides: that a line is kept as where it would have begun, and how far it goes in all.
"""

from tamias2d.engine.tables import (
    ANGLE,
    DANGLE,
    DX,
    DY,
    INVERSE_INERTIA,
    INVERSE_MASS,
    Bodies,
    X,
    Y,
)
from tamias2d.generated.continuous_collision import (
    orientation_redirected,
    position_redirected,
    shift_redirected,
    span,
    turn_redirected,
)
from tamias2d.generated.soft_contact import (
    angular_velocity_a_kicked,
    angular_velocity_b_kicked,
    turning_arm,
    velocity_a_kicked,
    velocity_b_kicked,
)
from tamias2d.state import Array, Vector


def offset_at(i: int, j: int, now: float, pose: Array, motion: Array) -> Vector:
    """Return where the centre of j is from that of i at a fraction of the step, m."""
    return span(
        (pose[i, X], pose[i, Y]),
        (motion[i, DX], motion[i, DY]),
        (pose[j, X], pose[j, Y]),
        (motion[j, DX], motion[j, DY]),
        now,
    )


def redirect_both(
    i: int,
    j: int,
    now: float,
    amount: float,
    at_a: Vector,
    at_b: Vector,
    line: Vector,
    bodies: Bodies,
) -> None:
    """Bend the lines of both bodies as an impulse does, in N s times the time step, s."""
    none = (0.0, 0.0)
    by = velocity_a_kicked(none, amount, line, bodies.properties[i, INVERSE_MASS])
    turn = angular_velocity_a_kicked(
        0.0, amount, turning_arm(at_a, line), bodies.properties[i, INVERSE_INERTIA]
    )
    redirect_path(i, now, by, turn, bodies.pose, bodies.motion)
    by = velocity_b_kicked(none, amount, line, bodies.properties[j, INVERSE_MASS])
    turn = angular_velocity_b_kicked(
        0.0, amount, turning_arm(at_b, line), bodies.properties[j, INVERSE_INERTIA]
    )
    redirect_path(j, now, by, turn, bodies.pose, bodies.motion)


def redirect_path(i: int, now: float, by: Vector, turn: float, pose: Array, motion: Array) -> None:
    """Let a line go on from where it is now with another way over a whole step, m and rad.

    It is kept as where it would have begun, and how far it goes in all (GD14).
    """
    pose[i, X], pose[i, Y] = position_redirected((pose[i, X], pose[i, Y]), by, now)
    pose[i, ANGLE] = orientation_redirected(pose[i, ANGLE], turn, now)
    motion[i, DX], motion[i, DY] = shift_redirected((motion[i, DX], motion[i, DY]), by)
    motion[i, DANGLE] = turn_redirected(motion[i, DANGLE], turn)
