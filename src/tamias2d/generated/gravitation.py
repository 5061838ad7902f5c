"""Gravitation: Attraction between bodies.

Generated from srs/models/gravitation.md
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.functions import Scalar, Vector, sqrt


def attraction(
    gravitational_constant: Scalar,
    mass_a: Scalar,
    mass_b: Scalar,
    position_a: Vector,
    position_b: Vector,
) -> Vector:
    """Gravitational force on body A, towards body B (N).

    attraction = gravitational_constant*mass_a*mass_b*span/distance**3
        where span = position_b - position_a
        where distance = norm(span)

    Args:
        gravitational_constant: Constant of gravitation, m^3/(kg*s^2)
        mass_a: Mass of a body; of body A, kg
        mass_b: Mass of a body; of body B, kg
        position_a: Position of the centre of mass; of body A, m
        position_b: Position of the centre of mass; of body B, m

    Source: IM5, srs/models/gravitation.md:25.
    """
    position_a_x, position_a_y = position_a
    position_b_x, position_b_y = position_b
    span_x, span_y = (position_b_x - position_a_x, position_b_y - position_a_y)
    distance = sqrt(span_x * span_x + span_y * span_y)
    return (
        gravitational_constant * mass_a * mass_b * span_x / (distance * distance * distance),
        gravitational_constant * mass_a * mass_b * span_y / (distance * distance * distance),
    )


def gravitational_energy(
    gravitational_constant: Scalar,
    mass_a: Scalar,
    mass_b: Scalar,
    position_a: Vector,
    position_b: Vector,
) -> Scalar:
    """Energy of two bodies that attract each other, zero when far apart (J).

    gravitational_energy = -gravitational_constant*mass_a*mass_b/distance
        where span = position_b - position_a
        where distance = norm(span)

    Args:
        gravitational_constant: Constant of gravitation, m^3/(kg*s^2)
        mass_a: Mass of a body; of body A, kg
        mass_b: Mass of a body; of body B, kg
        position_a: Position of the centre of mass; of body A, m
        position_b: Position of the centre of mass; of body B, m

    Source: IM5, srs/models/gravitation.md:26.
    """
    position_a_x, position_a_y = position_a
    position_b_x, position_b_y = position_b
    span_x, span_y = (position_b_x - position_a_x, position_b_y - position_a_y)
    distance = sqrt(span_x * span_x + span_y * span_y)
    return (-gravitational_constant) * mass_a * mass_b / distance
