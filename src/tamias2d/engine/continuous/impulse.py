"""Impulses between two bodies in flight, along a line through a point."""

from typing import NamedTuple

from tamias2d.engine.continuous.trajectory import redirect_path
from tamias2d.engine.tables import (
    DANGLE,
    DX,
    DY,
    FORCE_GAIN,
    INVERSE_INERTIA,
    INVERSE_MASS,
    SPIN,
    VX,
    VY,
    Bodies,
)
from tamias2d.generated.soft_contact import (
    angular_velocity_a_after,
    angular_velocity_b_after,
    row_mass,
    row_velocity,
    turning_arm,
    velocity_a_after,
    velocity_b_after,
)
from tamias2d.state import Array, Vector


class ImpulseLine(NamedTuple):
    """The line along which two bodies push each other: one row of the Jacobian."""

    a: int  # bodies
    b: int
    at_a: Vector  # the point from the centre of A, m
    at_b: Vector
    direction: Vector  # from A to B


def speed_along(line: ImpulseLine, left: float, motion: Array, flight: Array) -> float:
    """Return the velocity of B's point against A's along a line, m/s.

    `left` is the share of the step for which forces have not acted yet.
    """
    i, j = line.a, line.b
    return row_velocity(
        (
            motion[i, VX] - left * flight[i, FORCE_GAIN],
            motion[i, VY] - left * flight[i, FORCE_GAIN + 1],
        ),
        motion[i, SPIN] - left * flight[i, FORCE_GAIN + 2],
        turning_arm(line.at_a, line.direction),
        (
            motion[j, VX] - left * flight[j, FORCE_GAIN],
            motion[j, VY] - left * flight[j, FORCE_GAIN + 1],
        ),
        motion[j, SPIN] - left * flight[j, FORCE_GAIN + 2],
        turning_arm(line.at_b, line.direction),
        line.direction,
    )


def path_speed_along(line: ImpulseLine, time_step: float, motion: Array) -> float:
    """Return the same of the paths on which the bodies go, m/s."""
    i, j = line.a, line.b
    by_step = row_velocity(
        (motion[i, DX], motion[i, DY]),
        motion[i, DANGLE],
        turning_arm(line.at_a, line.direction),
        (motion[j, DX], motion[j, DY]),
        motion[j, DANGLE],
        turning_arm(line.at_b, line.direction),
        line.direction,
    )
    return by_step / time_step


def mass_along(line: ImpulseLine, properties: Array) -> float:
    """Return the effective mass of two bodies along a line, kg."""
    return row_mass(
        properties[line.a, INVERSE_MASS],
        properties[line.a, INVERSE_INERTIA],
        turning_arm(line.at_a, line.direction),
        properties[line.b, INVERSE_MASS],
        properties[line.b, INVERSE_INERTIA],
        turning_arm(line.at_b, line.direction),
    )


def change_velocities_and_paths(
    line: ImpulseLine, now: float, time_step: float, amount: float, bodies: Bodies
) -> None:
    """Apply an impulse, N s, to the velocities of both bodies, and to their paths from now on."""
    change_velocities(line, amount, bodies.motion, bodies.properties)
    change_paths(line, now, amount * time_step, bodies)


def change_velocities(line: ImpulseLine, amount: float, motion: Array, properties: Array) -> None:
    """Apply an impulse, N s, to the velocities of both bodies."""
    i, j, direction = line.a, line.b, line.direction
    arm_a, arm_b = turning_arm(line.at_a, direction), turning_arm(line.at_b, direction)
    motion[i, VX], motion[i, VY] = velocity_a_after(
        (motion[i, VX], motion[i, VY]), amount, direction, properties[i, INVERSE_MASS]
    )
    motion[i, SPIN] = angular_velocity_a_after(
        motion[i, SPIN], amount, arm_a, properties[i, INVERSE_INERTIA]
    )
    motion[j, VX], motion[j, VY] = velocity_b_after(
        (motion[j, VX], motion[j, VY]), amount, direction, properties[j, INVERSE_MASS]
    )
    motion[j, SPIN] = angular_velocity_b_after(
        motion[j, SPIN], amount, arm_b, properties[j, INVERSE_INERTIA]
    )


def change_paths(line: ImpulseLine, now: float, amount: float, bodies: Bodies) -> None:
    """Redirect the paths of both bodies as an impulse does, in N s times the time step, s."""
    i, j, direction, none = line.a, line.b, line.direction, (0.0, 0.0)
    arm_a, arm_b = turning_arm(line.at_a, direction), turning_arm(line.at_b, direction)
    by = velocity_a_after(none, amount, direction, bodies.properties[i, INVERSE_MASS])
    turn = angular_velocity_a_after(0.0, amount, arm_a, bodies.properties[i, INVERSE_INERTIA])
    redirect_path(i, now, by, turn, bodies.pose, bodies.motion)
    by = velocity_b_after(none, amount, direction, bodies.properties[j, INVERSE_MASS])
    turn = angular_velocity_b_after(0.0, amount, arm_b, bodies.properties[j, INVERSE_INERTIA])
    redirect_path(j, now, by, turn, bodies.pose, bodies.motion)
