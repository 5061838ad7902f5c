"""Impact: Impact of two bodies.

Generated from srs/models/impact.md
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.functions import Scalar, Vector, power


def normal_velocity(
    velocity_a: Vector,
    angular_velocity_a: Scalar,
    arm_a: Vector,
    velocity_b: Vector,
    angular_velocity_b: Scalar,
    arm_b: Vector,
    normal: Vector,
) -> Scalar:
    """Rate at which the contact opens, along the normal; negative when the bodies approach (m/s).

    normal_velocity = dot(velocity_b + cross(angular_velocity_b, arm_b) - velocity_a -
    cross(angular_velocity_a, arm_a), normal)

    Args:
        velocity_a: Velocity of the centre of mass; of body A, m/s
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        arm_a: Lever arm, from the centre of mass to the point where something acts on a body;
            of body A, m
        velocity_b: Velocity of the centre of mass; of body B, m/s
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s
        arm_b: Lever arm, from the centre of mass to the point where something acts on a body;
            of body B, m
        normal: Unit normal of a contact, from body A to body B, 1

    Source: IM3, srs/models/impact.md:51.
    """
    velocity_a_x, velocity_a_y = velocity_a
    arm_a_x, arm_a_y = arm_a
    velocity_b_x, velocity_b_y = velocity_b
    arm_b_x, arm_b_y = arm_b
    normal_x, normal_y = normal
    return (
        velocity_b_x - angular_velocity_b * arm_b_y - velocity_a_x + angular_velocity_a * arm_a_y
    ) * normal_x + (
        velocity_b_y + angular_velocity_b * arm_b_x - velocity_a_y - angular_velocity_a * arm_a_x
    ) * normal_y


def coupling(
    inverse_mass: Scalar,
    inverse_inertia: Scalar,
    arm_first: Vector,
    normal_first: Vector,
    arm_second: Vector,
    normal_second: Vector,
) -> Scalar:
    """Share of one body in the normal velocity at one contact for one unit of impulse at another
    (1/kg).

    coupling = inverse_mass*dot(normal_first, normal_second) +
    inverse_inertia*cross(arm_first, normal_first)*cross(arm_second, normal_second)

    Args:
        inverse_mass: One over the mass, zero for a static body, 1/kg
        inverse_inertia: One over the inertia, zero for a body that cannot turn, 1/(kg*m^2)
        arm_first: Lever arm, from the centre of mass to the point where something acts on a
            body; of the first of two contacts, m
        normal_first: Unit normal of a contact, from body A to body B; of the first of two
            contacts, 1
        arm_second: Lever arm, from the centre of mass to the point where something acts on a
            body; of the second of two contacts, m
        normal_second: Unit normal of a contact, from body A to body B; of the second of two
            contacts, 1

    Source: IM3, srs/models/impact.md:54.
    """
    arm_first_x, arm_first_y = arm_first
    normal_first_x, normal_first_y = normal_first
    arm_second_x, arm_second_y = arm_second
    normal_second_x, normal_second_y = normal_second
    return inverse_mass * (
        normal_first_x * normal_second_x + normal_first_y * normal_second_y
    ) + inverse_inertia * (arm_first_x * normal_first_y - arm_first_y * normal_first_x) * (
        arm_second_x * normal_second_y - arm_second_y * normal_second_x
    )


def inverse_effective_mass(
    inverse_mass_a: Scalar,
    inverse_inertia_a: Scalar,
    arm_a: Vector,
    inverse_mass_b: Scalar,
    inverse_inertia_b: Scalar,
    arm_b: Vector,
    normal: Vector,
) -> Scalar:
    """Change of the normal velocity for one unit of impulse (1/kg).

    inverse_effective_mass = inverse_mass_a + inverse_inertia_a*cross(arm_a, normal)**2 +
    inverse_mass_b + inverse_inertia_b*cross(arm_b, normal)**2

    Args:
        inverse_mass_a: One over the mass, zero for a static body; of body A, 1/kg
        inverse_inertia_a: One over the inertia, zero for a body that cannot turn; of body A,
            1/(kg*m^2)
        arm_a: Lever arm, from the centre of mass to the point where something acts on a body;
            of body A, m
        inverse_mass_b: One over the mass, zero for a static body; of body B, 1/kg
        inverse_inertia_b: One over the inertia, zero for a body that cannot turn; of body B,
            1/(kg*m^2)
        arm_b: Lever arm, from the centre of mass to the point where something acts on a body;
            of body B, m
        normal: Unit normal of a contact, from body A to body B, 1

    Source: IM3, srs/models/impact.md:58.
    """
    arm_a_x, arm_a_y = arm_a
    arm_b_x, arm_b_y = arm_b
    normal_x, normal_y = normal
    return (
        inverse_mass_a
        + inverse_inertia_a * power(arm_a_x * normal_y - arm_a_y * normal_x, 2)
        + inverse_mass_b
        + inverse_inertia_b * power(arm_b_x * normal_y - arm_b_y * normal_x, 2)
    )


def impulse(restitution: Scalar, normal_velocity: Scalar, inverse_effective_mass: Scalar) -> Scalar:
    """Size of the impulse of a contact along its normal (N*s).

    impulse = -(1 + restitution)*normal_velocity/inverse_effective_mass

    Args:
        restitution: Coefficient of restitution, from 0 (the bodies stay together) to 1 (no
            energy is lost), 1
        normal_velocity: Rate at which the contact opens, along the normal; negative when the
            bodies approach, m/s
        inverse_effective_mass: Change of the normal velocity for one unit of impulse, 1/kg

    Source: IM3, srs/models/impact.md:61.
    """
    return (-(1 + restitution)) * normal_velocity / inverse_effective_mass


def velocity_a_after(
    velocity_a: Vector, impulse: Scalar, normal: Vector, inverse_mass_a: Scalar
) -> Vector:
    """Velocity of the centre of mass; of body A; just after the impact (m/s).

    velocity_a_after = velocity_a - impulse*inverse_mass_a*normal

    Args:
        velocity_a: Velocity of the centre of mass; of body A, m/s
        impulse: Size of the impulse of a contact along its normal, N*s
        normal: Unit normal of a contact, from body A to body B, 1
        inverse_mass_a: One over the mass, zero for a static body; of body A, 1/kg

    Source: IM3, srs/models/impact.md:62.
    """
    velocity_a_x, velocity_a_y = velocity_a
    normal_x, normal_y = normal
    return (
        velocity_a_x - impulse * inverse_mass_a * normal_x,
        velocity_a_y - impulse * inverse_mass_a * normal_y,
    )


def angular_velocity_a_after(
    angular_velocity_a: Scalar,
    impulse: Scalar,
    arm_a: Vector,
    normal: Vector,
    inverse_inertia_a: Scalar,
) -> Scalar:
    """Rate of turning, positive counter-clockwise; of body A; just after the impact (rad/s).

    angular_velocity_a_after = angular_velocity_a - impulse*inverse_inertia_a*cross(arm_a,
    normal)

    Args:
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        impulse: Size of the impulse of a contact along its normal, N*s
        arm_a: Lever arm, from the centre of mass to the point where something acts on a body;
            of body A, m
        normal: Unit normal of a contact, from body A to body B, 1
        inverse_inertia_a: One over the inertia, zero for a body that cannot turn; of body A,
            1/(kg*m^2)

    Source: IM3, srs/models/impact.md:63.
    """
    arm_a_x, arm_a_y = arm_a
    normal_x, normal_y = normal
    return angular_velocity_a - impulse * inverse_inertia_a * (
        arm_a_x * normal_y - arm_a_y * normal_x
    )


def velocity_b_after(
    velocity_b: Vector, impulse: Scalar, normal: Vector, inverse_mass_b: Scalar
) -> Vector:
    """Velocity of the centre of mass; of body B; just after the impact (m/s).

    velocity_b_after = velocity_b + impulse*inverse_mass_b*normal

    Args:
        velocity_b: Velocity of the centre of mass; of body B, m/s
        impulse: Size of the impulse of a contact along its normal, N*s
        normal: Unit normal of a contact, from body A to body B, 1
        inverse_mass_b: One over the mass, zero for a static body; of body B, 1/kg

    Source: IM3, srs/models/impact.md:65.
    """
    velocity_b_x, velocity_b_y = velocity_b
    normal_x, normal_y = normal
    return (
        velocity_b_x + impulse * inverse_mass_b * normal_x,
        velocity_b_y + impulse * inverse_mass_b * normal_y,
    )


def angular_velocity_b_after(
    angular_velocity_b: Scalar,
    impulse: Scalar,
    arm_b: Vector,
    normal: Vector,
    inverse_inertia_b: Scalar,
) -> Scalar:
    """Rate of turning, positive counter-clockwise; of body B; just after the impact (rad/s).

    angular_velocity_b_after = angular_velocity_b + impulse*inverse_inertia_b*cross(arm_b,
    normal)

    Args:
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s
        impulse: Size of the impulse of a contact along its normal, N*s
        arm_b: Lever arm, from the centre of mass to the point where something acts on a body;
            of body B, m
        normal: Unit normal of a contact, from body A to body B, 1
        inverse_inertia_b: One over the inertia, zero for a body that cannot turn; of body B,
            1/(kg*m^2)

    Source: IM3, srs/models/impact.md:66.
    """
    arm_b_x, arm_b_y = arm_b
    normal_x, normal_y = normal
    return angular_velocity_b + impulse * inverse_inertia_b * (
        arm_b_x * normal_y - arm_b_y * normal_x
    )
