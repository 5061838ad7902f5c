"""Spring: Spring and damper.

Generated from srs/models/spring.md
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.functions import Scalar, Vector, cos, largest, sin, sqrt


def spring_force(
    stiffness: Scalar,
    rest_length: Scalar,
    damping: Scalar,
    point_a: Vector,
    point_velocity_a: Vector,
    point_b: Vector,
    point_velocity_b: Vector,
) -> Vector:
    """Force of a spring and its damper on the end at body A (N).

    spring_force = tension*axis
        where span = point_b - point_a
        where distance = norm(span)
        where extension = distance - rest_length
        where axis = span/max(distance, 1e-150[m])
        where extension_rate = dot(point_velocity_b - point_velocity_a, axis)
        where tension = stiffness*extension + damping*extension_rate

    Args:
        stiffness: Force of a spring for each unit of extension, N/m
        rest_length: Distance at which a spring neither pulls nor pushes, m
        damping: Force of a spring's damper for each unit of the extension's rate, kg/s
        point_a: Place of a point of a body, or of the plane; of body A, m
        point_velocity_a: Velocity of the point of a body that sits at the end of an arm; of
            body A, m/s
        point_b: Place of a point of a body, or of the plane; of body B, m
        point_velocity_b: Velocity of the point of a body that sits at the end of an arm; of
            body B, m/s

    Source: IM7, srs/models/spring.md:56.
    """
    point_a_x, point_a_y = point_a
    point_velocity_a_x, point_velocity_a_y = point_velocity_a
    point_b_x, point_b_y = point_b
    point_velocity_b_x, point_velocity_b_y = point_velocity_b
    span_x, span_y = (point_b_x - point_a_x, point_b_y - point_a_y)
    distance = sqrt(span_x * span_x + span_y * span_y)
    extension = distance - rest_length
    axis_x, axis_y = (span_x / largest(distance, 1e-150), span_y / largest(distance, 1e-150))
    extension_rate = (point_velocity_b_x - point_velocity_a_x) * axis_x + (
        point_velocity_b_y - point_velocity_a_y
    ) * axis_y
    tension = stiffness * extension + damping * extension_rate
    return (tension * axis_x, tension * axis_y)


def spring_energy(
    stiffness: Scalar, rest_length: Scalar, point_a: Vector, point_b: Vector
) -> Scalar:
    """Energy that a spring holds (J).

    spring_energy = stiffness*extension**2/2
        where span = point_b - point_a
        where distance = norm(span)
        where extension = distance - rest_length

    Args:
        stiffness: Force of a spring for each unit of extension, N/m
        rest_length: Distance at which a spring neither pulls nor pushes, m
        point_a: Place of a point of a body, or of the plane; of body A, m
        point_b: Place of a point of a body, or of the plane; of body B, m

    Source: IM7, srs/models/spring.md:57.
    """
    point_a_x, point_a_y = point_a
    point_b_x, point_b_y = point_b
    span_x, span_y = (point_b_x - point_a_x, point_b_y - point_a_y)
    distance = sqrt(span_x * span_x + span_y * span_y)
    extension = distance - rest_length
    return stiffness * extension * extension / 2


def angular_frequency(stiffness: Scalar, mass: Scalar) -> Scalar:
    """Phase that an oscillation gains per unit of time (rad/s).

    angular_frequency = sqrt(stiffness/mass)

    Args:
        stiffness: Force of a spring for each unit of extension, N/m
        mass: Mass of a body, kg

    Source: IM7, srs/models/spring.md:58.
    """
    return sqrt(stiffness / mass)


def equilibrium(point: Vector, acceleration: Vector, angular_frequency: Scalar) -> Vector:
    """Place at which the forces on a body cancel (m).

    equilibrium = point + acceleration/angular_frequency**2

    Args:
        point: Place of a point of a body, or of the plane, m
        acceleration: Acceleration of the centre of mass, m/s^2
        angular_frequency: Phase that an oscillation gains per unit of time, rad/s

    Source: IM7, srs/models/spring.md:59.
    """
    point_x, point_y = point
    acceleration_x, acceleration_y = acceleration
    return (
        point_x + acceleration_x / (angular_frequency * angular_frequency),
        point_y + acceleration_y / (angular_frequency * angular_frequency),
    )


def position(
    equilibrium: Vector,
    position_start: Vector,
    velocity_start: Vector,
    angular_frequency: Scalar,
    time: Scalar,
) -> Vector:
    """Position of the centre of mass (m).

    position = equilibrium + (position_start - equilibrium)*cos(angular_frequency*time) +
    velocity_start*(sin(angular_frequency*time)/angular_frequency)

    Valid when one spring without rest length and damper ties the centre of mass to a point of
    the plane, and nothing else acts but gravity and a force, which do not change with time.

    Args:
        equilibrium: Place at which the forces on a body cancel, m
        position_start: Position of the centre of mass; at the start, m
        velocity_start: Velocity of the centre of mass; at the start, m/s
        angular_frequency: Phase that an oscillation gains per unit of time, rad/s
        time: Time since the start of the simulation, s

    Source: IM7, srs/models/spring.md:87.
    """
    equilibrium_x, equilibrium_y = equilibrium
    position_start_x, position_start_y = position_start
    velocity_start_x, velocity_start_y = velocity_start
    return (
        equilibrium_x
        + (position_start_x - equilibrium_x) * cos(angular_frequency * time)
        + velocity_start_x * sin(angular_frequency * time) / angular_frequency,
        equilibrium_y
        + (position_start_y - equilibrium_y) * cos(angular_frequency * time)
        + velocity_start_y * sin(angular_frequency * time) / angular_frequency,
    )


def velocity(
    equilibrium: Vector,
    position_start: Vector,
    velocity_start: Vector,
    angular_frequency: Scalar,
    time: Scalar,
) -> Vector:
    """Velocity of the centre of mass (m/s).

    velocity = velocity_start*cos(angular_frequency*time) + (equilibrium -
    position_start)*(angular_frequency*sin(angular_frequency*time))

    Valid when one spring without rest length and damper ties the centre of mass to a point of
    the plane, and nothing else acts but gravity and a force, which do not change with time.

    Args:
        equilibrium: Place at which the forces on a body cancel, m
        position_start: Position of the centre of mass; at the start, m
        velocity_start: Velocity of the centre of mass; at the start, m/s
        angular_frequency: Phase that an oscillation gains per unit of time, rad/s
        time: Time since the start of the simulation, s

    Source: IM7, srs/models/spring.md:90.
    """
    equilibrium_x, equilibrium_y = equilibrium
    position_start_x, position_start_y = position_start
    velocity_start_x, velocity_start_y = velocity_start
    return (
        velocity_start_x * cos(angular_frequency * time)
        + (equilibrium_x - position_start_x) * angular_frequency * sin(angular_frequency * time),
        velocity_start_y * cos(angular_frequency * time)
        + (equilibrium_y - position_start_y) * angular_frequency * sin(angular_frequency * time),
    )
