"""Rest: Resting contact; Second derivative of a gap; Time until bouncing ends.

Generated from srs/models/rest.md
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.functions import Scalar, Vector


def normal_acceleration(
    acceleration_a: Vector,
    angular_acceleration_a: Scalar,
    arm_a: Vector,
    acceleration_b: Vector,
    angular_acceleration_b: Scalar,
    arm_b: Vector,
    normal: Vector,
) -> Scalar:
    """Rate of change of the normal velocity of a contact that rests (m/s^2).

    normal_acceleration = dot(acceleration_b + cross(angular_acceleration_b, arm_b) -
    acceleration_a - cross(angular_acceleration_a, arm_a), normal)

    Args:
        acceleration_a: Acceleration of the centre of mass; of body A, m/s^2
        angular_acceleration_a: Rate of change of the angular velocity; of body A, rad/s^2
        arm_a: Lever arm, from the centre of mass to the point where something acts on a body;
            of body A, m
        acceleration_b: Acceleration of the centre of mass; of body B, m/s^2
        angular_acceleration_b: Rate of change of the angular velocity; of body B, rad/s^2
        arm_b: Lever arm, from the centre of mass to the point where something acts on a body;
            of body B, m
        normal: Unit normal of a contact, from body A to body B, 1

    Source: GD3, srs/models/rest.md:25.
    """
    acceleration_a_x, acceleration_a_y = acceleration_a
    arm_a_x, arm_a_y = arm_a
    acceleration_b_x, acceleration_b_y = acceleration_b
    arm_b_x, arm_b_y = arm_b
    normal_x, normal_y = normal
    return (
        acceleration_b_x
        - angular_acceleration_b * arm_b_y
        - acceleration_a_x
        + angular_acceleration_a * arm_a_y
    ) * normal_x + (
        acceleration_b_y
        + angular_acceleration_b * arm_b_x
        - acceleration_a_y
        - angular_acceleration_a * arm_a_x
    ) * normal_y


def gap_acceleration_side(
    normal_acceleration: Scalar,
    angular_velocity_a: Scalar,
    angular_velocity_b: Scalar,
    arm_b: Vector,
    normal: Vector,
    slip: Scalar,
    distance: Scalar,
) -> Scalar:
    """Second derivative of a gap; before a side of body A (m/s^2).

    gap_acceleration_side = normal_acceleration + turning_part_side
        where turning_part_side = 2*angular_velocity_a*slip - angular_velocity_a**2*distance - angular_velocity_b**2*dot(normal, arm_b)

    Args:
        normal_acceleration: Rate of change of the normal velocity of a contact that rests,
            m/s^2
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s
        arm_b: Lever arm, from the centre of mass to the point where something acts on a body;
            of body B, m
        normal: Unit normal of a contact, from body A to body B, 1
        slip: Velocity at which a corner of B moves along a side of A, or past a corner of it,
            m/s
        distance: Distance between two places, m

    Source: GD15, srs/models/rest.md:69.
    """
    arm_b_x, arm_b_y = arm_b
    normal_x, normal_y = normal
    turning_part_side = (
        2 * angular_velocity_a * slip
        - angular_velocity_a * angular_velocity_a * distance
        - angular_velocity_b * angular_velocity_b * (normal_x * arm_b_x + normal_y * arm_b_y)
    )
    return normal_acceleration + turning_part_side


def gap_acceleration_corner(
    normal_acceleration: Scalar,
    angular_velocity_a: Scalar,
    arm_a: Vector,
    angular_velocity_b: Scalar,
    arm_b: Vector,
    normal: Vector,
    slip: Scalar,
    distance: Scalar,
) -> Scalar:
    """Second derivative of a gap; before a corner of body A (m/s^2).

    gap_acceleration_corner = normal_acceleration + turning_part_corner
        where turning_part_corner = slip**2/distance - angular_velocity_b**2*dot(normal, arm_b) + angular_velocity_a**2*dot(normal, arm_a)

    Args:
        normal_acceleration: Rate of change of the normal velocity of a contact that rests,
            m/s^2
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        arm_a: Lever arm, from the centre of mass to the point where something acts on a body;
            of body A, m
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s
        arm_b: Lever arm, from the centre of mass to the point where something acts on a body;
            of body B, m
        normal: Unit normal of a contact, from body A to body B, 1
        slip: Velocity at which a corner of B moves along a side of A, or past a corner of it,
            m/s
        distance: Distance between two places, m

    Source: GD15, srs/models/rest.md:70.
    """
    arm_a_x, arm_a_y = arm_a
    arm_b_x, arm_b_y = arm_b
    normal_x, normal_y = normal
    turning_part_corner = (
        slip * slip / distance
        - angular_velocity_b * angular_velocity_b * (normal_x * arm_b_x + normal_y * arm_b_y)
        + angular_velocity_a * angular_velocity_a * (normal_x * arm_a_x + normal_y * arm_a_y)
    )
    return normal_acceleration + turning_part_corner


def time_to_rest(
    normal_velocity_after: Scalar, normal_acceleration: Scalar, restitution: Scalar
) -> Scalar:
    """Time from an impact until the bounces that follow have ended (s).

    time_to_rest = -2*normal_velocity_after/(normal_acceleration*(1 - restitution))

    Args:
        normal_velocity_after: Rate at which the contact opens, along the normal; negative when
            the bodies approach; just after the impact, m/s
        normal_acceleration: Rate of change of the normal velocity of a contact that rests,
            m/s^2
        restitution: Coefficient of restitution, from 0 (the bodies stay together) to 1 (no
            energy is lost), 1

    Source: GD5, srs/models/rest.md:173.
    """
    return (-2) * normal_velocity_after / (normal_acceleration * (1 - restitution))


def bounce_height(normal_velocity_after: Scalar, normal_acceleration: Scalar) -> Scalar:
    """How far a contact opens in a bounce (m).

    bounce_height = -normal_velocity_after**2/(2*normal_acceleration)

    Args:
        normal_velocity_after: Rate at which the contact opens, along the normal; negative when
            the bodies approach; just after the impact, m/s
        normal_acceleration: Rate of change of the normal velocity of a contact that rests,
            m/s^2

    Source: GD5, srs/models/rest.md:175.
    """
    return (-normal_velocity_after * normal_velocity_after) / (2 * normal_acceleration)
