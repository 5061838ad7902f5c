"""Rotation: Rotation of a body.

Generated from srs/models/rotation.md
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.functions import Scalar


def angular_acceleration(torque: Scalar, inertia: Scalar) -> Scalar:
    """Rate of change of the angular velocity (rad/s^2).

    angular_acceleration = torque/inertia

    Args:
        torque: Applied torque about the centre of mass, positive counter-clockwise, N*m
        inertia: Moment of inertia about the centre of mass, kg*m^2

    Source: IM2, srs/models/rotation.md:37.
    """
    return torque / inertia


def orientation(
    orientation_start: Scalar,
    angular_velocity_start: Scalar,
    angular_acceleration: Scalar,
    time: Scalar,
) -> Scalar:
    """Angle by which the body is turned counter-clockwise from its drawn position, unbounded
    (rad).

    orientation = orientation_start + angular_velocity_start*time +
    angular_acceleration*time**2/2

    Valid when the torque does not change with time.

    Args:
        orientation_start: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; at the start, rad
        angular_velocity_start: Rate of turning, positive counter-clockwise; at the start, rad/s
        angular_acceleration: Rate of change of the angular velocity, rad/s^2
        time: Time since the start of the simulation, s

    Source: IM2, srs/models/rotation.md:49.
    """
    return (
        orientation_start + angular_velocity_start * time + angular_acceleration * time * time / 2
    )


def angular_velocity(
    angular_velocity_start: Scalar, angular_acceleration: Scalar, time: Scalar
) -> Scalar:
    """Rate of turning, positive counter-clockwise (rad/s).

    angular_velocity = angular_velocity_start + angular_acceleration*time

    Valid when the torque does not change with time.

    Args:
        angular_velocity_start: Rate of turning, positive counter-clockwise; at the start, rad/s
        angular_acceleration: Rate of change of the angular velocity, rad/s^2
        time: Time since the start of the simulation, s

    Source: IM2, srs/models/rotation.md:52.
    """
    return angular_velocity_start + angular_acceleration * time
