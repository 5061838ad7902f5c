"""The line along which a body goes in a step, and how it is bent within the step.

Serves: flights. Hides: that a line is kept as where it would have begun, and how far it goes.
"""

from tamias2d.generated.soft_contact import (
    angular_velocity_a_kicked,
    angular_velocity_b_kicked,
    turning_arm,
    velocity_a_kicked,
    velocity_b_kicked,
)
from tamias2d.state import Array, Vector
from tamias2d.stepped.layout import (
    DTURN,
    DX,
    DY,
    INVERSE_INERTIA,
    INVERSE_MASS,
    TURN,
    X,
    Y,
)


def bend(
    i: int,
    j: int,
    now: float,
    amount: float,
    at_a: Vector,
    at_b: Vector,
    line: Vector,
    pose: Array,
    motion: Array,
    body: Array,
) -> None:
    """Bend the lines of both bodies as an impulse does, in N s times the time step, s."""
    none = (0.0, 0.0)
    by = velocity_a_kicked(none, amount, line, body[i, INVERSE_MASS])
    turn = angular_velocity_a_kicked(0.0, amount, turning_arm(at_a, line), body[i, INVERSE_INERTIA])
    bend_line(i, now, by, turn, pose, motion)
    by = velocity_b_kicked(none, amount, line, body[j, INVERSE_MASS])
    turn = angular_velocity_b_kicked(0.0, amount, turning_arm(at_b, line), body[j, INVERSE_INERTIA])
    bend_line(j, now, by, turn, pose, motion)


def bend_line(i: int, now: float, by: Vector, turn: float, pose: Array, motion: Array) -> None:
    """Let a line go on from where it is now with another way over a whole step, m and rad.

    It is kept as where it would have begun, and how far it goes in all.
    """
    pose[i, X] -= now * by[0]
    pose[i, Y] -= now * by[1]
    pose[i, TURN] -= now * turn
    motion[i, DX] += by[0]
    motion[i, DY] += by[1]
    motion[i, DTURN] += turn


def stop(i: int, now: float, pose: Array, motion: Array) -> None:
    """Let a body stay where it is at a fraction of the step; it keeps its velocity."""
    bend_line(i, now, (-motion[i, DX], -motion[i, DY]), -motion[i, DTURN], pose, motion)


def go_along(i: int, j: int, now: float, pose: Array, motion: Array) -> None:
    """Let a body j go on as if it were a part of i, as far as a line can do that.

    The line leads on the inside of the arc on which it would go; it keeps its velocity.
    """
    x = pose[j, X] - pose[i, X] + now * (motion[j, DX] - motion[i, DX])
    y = pose[j, Y] - pose[i, Y] + now * (motion[j, DY] - motion[i, DY])
    turn = motion[i, DTURN]
    inwards = turn * turn * (1.0 - now)
    by = (
        motion[i, DX] - turn * y - inwards * x - motion[j, DX],
        motion[i, DY] + turn * x - inwards * y - motion[j, DY],
    )
    bend_line(j, now, by, turn - motion[j, DTURN], pose, motion)
