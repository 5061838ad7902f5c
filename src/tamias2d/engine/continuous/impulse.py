"""Impulses between two bodies in flight, along a line through a point."""

from typing import NamedTuple

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.trajectory import redirect_path
from tamias2d.engine.tables import Bodies
from tamias2d.generated.continuous_collision import coordinate_velocity_instant
from tamias2d.generated.soft_contact import (
    angular_velocity_a_after,
    angular_velocity_b_after,
    row_mass,
    row_velocity,
    turning_arm,
    velocity_a_after,
    velocity_b_after,
)
from tamias2d.kernels.assembled import inlined
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
        velocity_at(i, left, motion, flight),
        coordinate_velocity_instant(motion[i, tb.SPIN], left, flight[i, tb.FORCE_GAIN + 2]),
        turning_arm(line.at_a, line.direction),
        velocity_at(j, left, motion, flight),
        coordinate_velocity_instant(motion[j, tb.SPIN], left, flight[j, tb.FORCE_GAIN + 2]),
        turning_arm(line.at_b, line.direction),
        line.direction,
    )


@inlined
def velocity_at(i: int, left: float, motion: Array, flight: Array) -> Vector:
    """Return the velocity of a body when a share of the step is left, m/s (DD61)."""
    return (
        coordinate_velocity_instant(motion[i, tb.VX], left, flight[i, tb.FORCE_GAIN]),
        coordinate_velocity_instant(motion[i, tb.VY], left, flight[i, tb.FORCE_GAIN + 1]),
    )


def path_speed_along(line: ImpulseLine, time_step: float, motion: Array) -> float:
    """Return the same of the paths on which the bodies go, m/s."""
    i, j = line.a, line.b
    by_step = row_velocity(
        (motion[i, tb.DX], motion[i, tb.DY]),
        motion[i, tb.DANGLE],
        turning_arm(line.at_a, line.direction),
        (motion[j, tb.DX], motion[j, tb.DY]),
        motion[j, tb.DANGLE],
        turning_arm(line.at_b, line.direction),
        line.direction,
    )
    return by_step / time_step


def mass_along(line: ImpulseLine, properties: Array) -> float:
    """Return the effective mass of two bodies along a line, kg."""
    return row_mass(
        properties[line.a, tb.INVERSE_MASS],
        properties[line.a, tb.INVERSE_INERTIA],
        turning_arm(line.at_a, line.direction),
        properties[line.b, tb.INVERSE_MASS],
        properties[line.b, tb.INVERSE_INERTIA],
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
    motion[i, tb.VX], motion[i, tb.VY] = velocity_a_after(
        (motion[i, tb.VX], motion[i, tb.VY]), amount, direction, properties[i, tb.INVERSE_MASS]
    )
    motion[i, tb.SPIN] = angular_velocity_a_after(
        motion[i, tb.SPIN], amount, arm_a, properties[i, tb.INVERSE_INERTIA]
    )
    motion[j, tb.VX], motion[j, tb.VY] = velocity_b_after(
        (motion[j, tb.VX], motion[j, tb.VY]), amount, direction, properties[j, tb.INVERSE_MASS]
    )
    motion[j, tb.SPIN] = angular_velocity_b_after(
        motion[j, tb.SPIN], amount, arm_b, properties[j, tb.INVERSE_INERTIA]
    )


def change_paths(line: ImpulseLine, now: float, amount: float, bodies: Bodies) -> None:
    """Redirect the paths of both bodies as an impulse does, in N s times the time step, s."""
    i, j, direction, none = line.a, line.b, line.direction, (0.0, 0.0)
    arm_a, arm_b = turning_arm(line.at_a, direction), turning_arm(line.at_b, direction)
    by = velocity_a_after(none, amount, direction, bodies.properties[i, tb.INVERSE_MASS])
    turn = angular_velocity_a_after(0.0, amount, arm_a, bodies.properties[i, tb.INVERSE_INERTIA])
    redirect_path(i, now, by, turn, bodies.pose, bodies.motion)
    by = velocity_b_after(none, amount, direction, bodies.properties[j, tb.INVERSE_MASS])
    turn = angular_velocity_b_after(0.0, amount, arm_b, bodies.properties[j, tb.INVERSE_INERTIA])
    redirect_path(j, now, by, turn, bodies.pose, bodies.motion)
