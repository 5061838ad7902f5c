"""Quadratic step: Quadratic drag through half a step.

Generated from srs/models/spring_step.md
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.functions import Scalar, Vector, sqrt


def velocity_later(
    velocity: Vector, quadratic_drag: Scalar, inverse_mass: Scalar, time_step: Scalar
) -> Vector:
    """Velocity of the centre of mass; after the bodies have moved (m/s).

    velocity_later = velocity/(1 + quadratic_drag*inverse_mass*norm(velocity)*time_step/2)

    Args:
        velocity: Velocity of the centre of mass, m/s
        quadratic_drag: Coefficient of the drag that grows with the square of the speed, kg/m
        inverse_mass: One over the mass, zero for a static body, 1/kg
        time_step: Length of one step of a stepped scheme, s

    Source: DD55, srs/models/spring_step.md:447.
    """
    velocity_x, velocity_y = velocity
    return (
        velocity_x
        / (
            1
            + quadratic_drag
            * inverse_mass
            * sqrt(velocity_x * velocity_x + velocity_y * velocity_y)
            * time_step
            / 2
        ),
        velocity_y
        / (
            1
            + quadratic_drag
            * inverse_mass
            * sqrt(velocity_x * velocity_x + velocity_y * velocity_y)
            * time_step
            / 2
        ),
    )
