"""Translation: Translation of a body.

Generated from srs/models/translation.md
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.functions import Scalar, Vector


def acceleration(gravity: Vector, force: Vector, mass: Scalar) -> Vector:
    """Acceleration of the centre of mass (m/s^2).

    acceleration = gravity + force/mass

    Args:
        gravity: Gravitational acceleration, the same for all bodies, m/s^2
        force: Applied force on a body, without its weight, N
        mass: Mass of a body, kg

    Source: IM1, srs/models/translation.md:34.
    """
    gravity_x, gravity_y = gravity
    force_x, force_y = force
    return (gravity_x + force_x / mass, gravity_y + force_y / mass)


def position(
    position_start: Vector, velocity_start: Vector, acceleration: Vector, time: Scalar
) -> Vector:
    """Position of the centre of mass (m).

    position = position_start + velocity_start*time + acceleration*time**2/2

    Valid when force and gravity do not change with time.

    Args:
        position_start: Position of the centre of mass; at the start, m
        velocity_start: Velocity of the centre of mass; at the start, m/s
        acceleration: Acceleration of the centre of mass, m/s^2
        time: Time since the start of the simulation, s

    Source: IM1, srs/models/translation.md:46.
    """
    position_start_x, position_start_y = position_start
    velocity_start_x, velocity_start_y = velocity_start
    acceleration_x, acceleration_y = acceleration
    return (
        position_start_x + velocity_start_x * time + acceleration_x * time * time / 2,
        position_start_y + velocity_start_y * time + acceleration_y * time * time / 2,
    )


def velocity(velocity_start: Vector, acceleration: Vector, time: Scalar) -> Vector:
    """Velocity of the centre of mass (m/s).

    velocity = velocity_start + acceleration*time

    Valid when force and gravity do not change with time.

    Args:
        velocity_start: Velocity of the centre of mass; at the start, m/s
        acceleration: Acceleration of the centre of mass, m/s^2
        time: Time since the start of the simulation, s

    Source: IM1, srs/models/translation.md:47.
    """
    velocity_start_x, velocity_start_y = velocity_start
    acceleration_x, acceleration_y = acceleration
    return (velocity_start_x + acceleration_x * time, velocity_start_y + acceleration_y * time)
