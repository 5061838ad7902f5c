"""Drag: Drag.

Generated from srs/models/drag.md
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.functions import Scalar, Vector, exp, phi1, phi2, sqrt


def linear_drag_force(linear_drag: Scalar, velocity: Vector) -> Vector:
    """Force of linear drag on a body (N).

    linear_drag_force = -linear_drag*velocity

    Args:
        linear_drag: Coefficient of the drag that grows with the speed, kg/s
        velocity: Velocity of the centre of mass, m/s

    Source: IM6, srs/models/drag.md:46.
    """
    velocity_x, velocity_y = velocity
    return ((-linear_drag) * velocity_x, (-linear_drag) * velocity_y)


def quadratic_drag_force(quadratic_drag: Scalar, velocity: Vector) -> Vector:
    """Force of quadratic drag on a body (N).

    quadratic_drag_force = -quadratic_drag*speed*velocity
        where speed = norm(velocity)

    Args:
        quadratic_drag: Coefficient of the drag that grows with the square of the speed, kg/m
        velocity: Velocity of the centre of mass, m/s

    Source: IM6, srs/models/drag.md:47.
    """
    velocity_x, velocity_y = velocity
    speed = sqrt(velocity_x * velocity_x + velocity_y * velocity_y)
    return ((-quadratic_drag) * speed * velocity_x, (-quadratic_drag) * speed * velocity_y)


def drag_rate(linear_drag: Scalar, mass: Scalar) -> Scalar:
    """Share of its velocity that a body loses to linear drag per unit of time (1/s).

    drag_rate = linear_drag/mass

    Args:
        linear_drag: Coefficient of the drag that grows with the speed, kg/s
        mass: Mass of a body, kg

    Source: IM6, srs/models/drag.md:48.
    """
    return linear_drag / mass


def angular_drag_torque(angular_drag: Scalar, angular_velocity: Scalar) -> Scalar:
    """Torque of angular drag on a body (N*m).

    angular_drag_torque = -angular_drag*angular_velocity

    Args:
        angular_drag: Coefficient of the drag that grows with the angular velocity, kg*m^2/s
        angular_velocity: Rate of turning, positive counter-clockwise, rad/s

    Source: IM6, srs/models/drag.md:49.
    """
    return (-angular_drag) * angular_velocity


def angular_drag_rate(angular_drag: Scalar, inertia: Scalar) -> Scalar:
    """Share of its angular velocity that a body loses to angular drag per unit of time (1/s).

    angular_drag_rate = angular_drag/inertia

    Args:
        angular_drag: Coefficient of the drag that grows with the angular velocity, kg*m^2/s
        inertia: Moment of inertia about the centre of mass, kg*m^2

    Source: IM6, srs/models/drag.md:50.
    """
    return angular_drag / inertia


def position(
    position_start: Vector,
    velocity_start: Vector,
    acceleration: Vector,
    drag_rate: Scalar,
    time: Scalar,
) -> Vector:
    """Position of the centre of mass (m).

    position = position_start + velocity_start*time*phi1(-drag_rate*time) +
    acceleration*time**2*phi2(-drag_rate*time)

    Valid when the drag is linear, and gravity, the applied force and the applied torque, which
    give the accelerations, do not change with time.

    Args:
        position_start: Position of the centre of mass; at the start, m
        velocity_start: Velocity of the centre of mass; at the start, m/s
        acceleration: Acceleration of the centre of mass, m/s^2
        drag_rate: Share of its velocity that a body loses to linear drag per unit of time, 1/s
        time: Time since the start of the simulation, s

    Source: IM6, srs/models/drag.md:95.
    """
    position_start_x, position_start_y = position_start
    velocity_start_x, velocity_start_y = velocity_start
    acceleration_x, acceleration_y = acceleration
    return (
        position_start_x
        + velocity_start_x * time * phi1((-drag_rate) * time)
        + acceleration_x * time * time * phi2((-drag_rate) * time),
        position_start_y
        + velocity_start_y * time * phi1((-drag_rate) * time)
        + acceleration_y * time * time * phi2((-drag_rate) * time),
    )


def velocity(
    velocity_start: Vector, acceleration: Vector, drag_rate: Scalar, time: Scalar
) -> Vector:
    """Velocity of the centre of mass (m/s).

    velocity = velocity_start*exp(-drag_rate*time) + acceleration*time*phi1(-drag_rate*time)

    Valid when the drag is linear, and gravity, the applied force and the applied torque, which
    give the accelerations, do not change with time.

    Args:
        velocity_start: Velocity of the centre of mass; at the start, m/s
        acceleration: Acceleration of the centre of mass, m/s^2
        drag_rate: Share of its velocity that a body loses to linear drag per unit of time, 1/s
        time: Time since the start of the simulation, s

    Source: IM6, srs/models/drag.md:98.
    """
    velocity_start_x, velocity_start_y = velocity_start
    acceleration_x, acceleration_y = acceleration
    return (
        velocity_start_x * exp((-drag_rate) * time)
        + acceleration_x * time * phi1((-drag_rate) * time),
        velocity_start_y * exp((-drag_rate) * time)
        + acceleration_y * time * phi1((-drag_rate) * time),
    )


def orientation(
    orientation_start: Scalar,
    angular_velocity_start: Scalar,
    angular_acceleration: Scalar,
    angular_drag_rate: Scalar,
    time: Scalar,
) -> Scalar:
    """Angle by which the body is turned counter-clockwise from its drawn position, unbounded
    (rad).

    orientation = orientation_start +
    angular_velocity_start*time*phi1(-angular_drag_rate*time) +
    angular_acceleration*time**2*phi2(-angular_drag_rate*time)

    Valid when the drag is linear, and gravity, the applied force and the applied torque, which
    give the accelerations, do not change with time.

    Args:
        orientation_start: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; at the start, rad
        angular_velocity_start: Rate of turning, positive counter-clockwise; at the start, rad/s
        angular_acceleration: Rate of change of the angular velocity, rad/s^2
        angular_drag_rate: Share of its angular velocity that a body loses to angular drag per
            unit of time, 1/s
        time: Time since the start of the simulation, s

    Source: IM6, srs/models/drag.md:101.
    """
    return (
        orientation_start
        + angular_velocity_start * time * phi1((-angular_drag_rate) * time)
        + angular_acceleration * time * time * phi2((-angular_drag_rate) * time)
    )


def angular_velocity(
    angular_velocity_start: Scalar,
    angular_acceleration: Scalar,
    angular_drag_rate: Scalar,
    time: Scalar,
) -> Scalar:
    """Rate of turning, positive counter-clockwise (rad/s).

    angular_velocity = angular_velocity_start*exp(-angular_drag_rate*time) +
    angular_acceleration*time*phi1(-angular_drag_rate*time)

    Valid when the drag is linear, and gravity, the applied force and the applied torque, which
    give the accelerations, do not change with time.

    Args:
        angular_velocity_start: Rate of turning, positive counter-clockwise; at the start, rad/s
        angular_acceleration: Rate of change of the angular velocity, rad/s^2
        angular_drag_rate: Share of its angular velocity that a body loses to angular drag per
            unit of time, 1/s
        time: Time since the start of the simulation, s

    Source: IM6, srs/models/drag.md:105.
    """
    return angular_velocity_start * exp(
        (-angular_drag_rate) * time
    ) + angular_acceleration * time * phi1((-angular_drag_rate) * time)
