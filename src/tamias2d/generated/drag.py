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

    Source: IM6, srs/models/drag.md:37.
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

    Source: IM6, srs/models/drag.md:38.
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

    Source: IM6, srs/models/drag.md:39.
    """
    return linear_drag / mass


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

    Valid when the drag is linear, and gravity and the applied force, which together give the
    acceleration, do not change with time.

    Args:
        position_start: Position of the centre of mass; at the start, m
        velocity_start: Velocity of the centre of mass; at the start, m/s
        acceleration: Acceleration of the centre of mass, m/s^2
        drag_rate: Share of its velocity that a body loses to linear drag per unit of time, 1/s
        time: Time since the start of the simulation, s

    Source: IM6, srs/models/drag.md:61.
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

    Valid when the drag is linear, and gravity and the applied force, which together give the
    acceleration, do not change with time.

    Args:
        velocity_start: Velocity of the centre of mass; at the start, m/s
        acceleration: Acceleration of the centre of mass, m/s^2
        drag_rate: Share of its velocity that a body loses to linear drag per unit of time, 1/s
        time: Time since the start of the simulation, s

    Source: IM6, srs/models/drag.md:64.
    """
    velocity_start_x, velocity_start_y = velocity_start
    acceleration_x, acceleration_y = acceleration
    return (
        velocity_start_x * exp((-drag_rate) * time)
        + acceleration_x * time * phi1((-drag_rate) * time),
        velocity_start_y * exp((-drag_rate) * time)
        + acceleration_y * time * phi1((-drag_rate) * time),
    )
