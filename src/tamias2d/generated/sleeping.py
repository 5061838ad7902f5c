"""Sleeping: Quiet body; Sleep of an island.

Generated from srs/models/sleeping.md
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.functions import Scalar, Truth, Vector, largest


def quiet_square(quiet_share: Scalar, extent: Scalar, gravity_size: Scalar) -> Scalar:
    """Square of the velocity up to which a body is quiet (m^2/s^2).

    quiet_square = quiet_share**2*extent*gravity_size

    Args:
        quiet_share: Velocity of a quiet body over that of a fall through half its extent, 1
        extent: How far a body reaches from its centre of mass; of two bodies, the smaller one
            does, m
        gravity_size: Size of gravity, along both axes together, m/s^2

    Source: DD50, srs/models/sleeping.md:23.
    """
    return quiet_share * quiet_share * extent * gravity_size


def quiet(
    velocity: Vector,
    angular_velocity: Scalar,
    shift: Vector,
    turn: Scalar,
    extent: Scalar,
    quiet_square: Scalar,
    time_step: Scalar,
) -> Truth:
    """Whether a body is quiet, true or false (1).

    quiet = motion_square <= quiet_square and displacement_square <= quiet_square*time_step**2
        where rim_velocity = angular_velocity*extent
        where motion_square = dot(velocity, velocity) + rim_velocity**2
        where rim_displacement = turn*extent
        where displacement_square = dot(shift, shift) + rim_displacement**2

    Args:
        velocity: Velocity of the centre of mass, m/s
        angular_velocity: Rate of turning, positive counter-clockwise, rad/s
        shift: How far the centre of mass has moved since the step began, m
        turn: How far a body has turned since the step began, rad
        extent: How far a body reaches from its centre of mass; of two bodies, the smaller one
            does, m
        quiet_square: Square of the velocity up to which a body is quiet, m^2/s^2
        time_step: Length of one step of a stepped scheme, s

    Source: DD50, srs/models/sleeping.md:24.
    """
    velocity_x, velocity_y = velocity
    shift_x, shift_y = shift
    rim_velocity = angular_velocity * extent
    motion_square = velocity_x * velocity_x + velocity_y * velocity_y + rim_velocity * rim_velocity
    rim_displacement = turn * extent
    displacement_square = (
        shift_x * shift_x + shift_y * shift_y + rim_displacement * rim_displacement
    )
    return (motion_square <= quiet_square) & (
        displacement_square <= quiet_square * time_step * time_step
    )


def kinetic_energy_most(
    mass: Scalar, inertia: Scalar, extent: Scalar, quiet_square: Scalar
) -> Scalar:
    """Energy of motion, turning included; the most that there may be (J).

    kinetic_energy_most = max(mass, inertia/extent**2)*quiet_square/2

    Args:
        mass: Mass of a body, kg
        inertia: Moment of inertia about the centre of mass, kg*m^2
        extent: How far a body reaches from its centre of mass; of two bodies, the smaller one
            does, m
        quiet_square: Square of the velocity up to which a body is quiet, m^2/s^2

    Source: IM13, srs/models/sleeping.md:69.
    """
    return largest(mass, inertia / (extent * extent)) * quiet_square / 2
