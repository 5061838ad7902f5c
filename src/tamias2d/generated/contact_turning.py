"""Contact turning: Contact that turns in a step.

Generated from srs/models/spring_step.md
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.functions import Scalar, Vector


def impulse_late_later(impulse_late: Scalar, step_share: Scalar, normal_impulse: Scalar) -> Scalar:
    """Sum of the impulses of a contact in a step, each times the share of the step that was over;
    after the bodies have moved (N*s).

    impulse_late_later = impulse_late + step_share*normal_impulse

    Args:
        impulse_late: Sum of the impulses of a contact in a step, each times the share of the
            step that was over, N*s
        step_share: Share of a step that is over, 1
        normal_impulse: Impulse along the normal of a contact with friction, N*s

    Source: DD84, srs/models/spring_step.md:373.
    """
    return impulse_late + step_share * normal_impulse


def impulse_turned(impulse_late: Scalar, normal: Vector, normal_later: Vector) -> Vector:
    """What the impulses of a contact in a step change as its normal turns (N*s).

    impulse_turned = impulse_late*(normal_later - normal)

    Args:
        impulse_late: Sum of the impulses of a contact in a step, each times the share of the
            step that was over, N*s
        normal: Unit normal of a contact, from body A to body B, 1
        normal_later: Unit normal of a contact, from body A to body B; after the bodies have
            moved, 1

    Source: DD84, srs/models/spring_step.md:374.
    """
    normal_x, normal_y = normal
    normal_later_x, normal_later_y = normal_later
    return (impulse_late * (normal_later_x - normal_x), impulse_late * (normal_later_y - normal_y))


def velocity_a_after(velocity_a: Vector, inverse_mass_a: Scalar, impulse_turned: Vector) -> Vector:
    """Velocity of the centre of mass; of body A; just after the impact (m/s).

    velocity_a_after = velocity_a - inverse_mass_a*impulse_turned

    Args:
        velocity_a: Velocity of the centre of mass; of body A, m/s
        inverse_mass_a: One over the mass, zero for a static body; of body A, 1/kg
        impulse_turned: What the impulses of a contact in a step change as its normal turns, N*s

    Source: DD84, srs/models/spring_step.md:375.
    """
    velocity_a_x, velocity_a_y = velocity_a
    impulse_turned_x, impulse_turned_y = impulse_turned
    return (
        velocity_a_x - inverse_mass_a * impulse_turned_x,
        velocity_a_y - inverse_mass_a * impulse_turned_y,
    )


def velocity_b_after(velocity_b: Vector, inverse_mass_b: Scalar, impulse_turned: Vector) -> Vector:
    """Velocity of the centre of mass; of body B; just after the impact (m/s).

    velocity_b_after = velocity_b + inverse_mass_b*impulse_turned

    Args:
        velocity_b: Velocity of the centre of mass; of body B, m/s
        inverse_mass_b: One over the mass, zero for a static body; of body B, 1/kg
        impulse_turned: What the impulses of a contact in a step change as its normal turns, N*s

    Source: DD84, srs/models/spring_step.md:376.
    """
    velocity_b_x, velocity_b_y = velocity_b
    impulse_turned_x, impulse_turned_y = impulse_turned
    return (
        velocity_b_x + inverse_mass_b * impulse_turned_x,
        velocity_b_y + inverse_mass_b * impulse_turned_y,
    )
