"""Friction: Impact with friction; Lasting contact with friction; Tangential acceleration of what
turns; Tangential acceleration of what rolls; Impulse of the bounces that are left; Creep of
bounces that stick; Bodies that move on in contact.

Generated from srs/models/friction.md
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.functions import Scalar, Vector, largest, power


def tangential_velocity(
    velocity_a: Vector,
    angular_velocity_a: Scalar,
    arm_a: Vector,
    velocity_b: Vector,
    angular_velocity_b: Scalar,
    arm_b: Vector,
    normal: Vector,
) -> Scalar:
    """Velocity of B's point of contact seen from A's, along the tangent; zero where the contact
    does not slide (m/s).

    tangential_velocity = dot(velocity_b + cross(angular_velocity_b, arm_b) - velocity_a -
    cross(angular_velocity_a, arm_a), perp(normal))

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

    Source: IM9, srs/models/friction.md:83.
    """
    velocity_a_x, velocity_a_y = velocity_a
    arm_a_x, arm_a_y = arm_a
    velocity_b_x, velocity_b_y = velocity_b
    arm_b_x, arm_b_y = arm_b
    normal_x, normal_y = normal
    return (
        velocity_b_x - angular_velocity_b * arm_b_y - velocity_a_x + angular_velocity_a * arm_a_y
    ) * (-normal_y) + (
        velocity_b_y + angular_velocity_b * arm_b_x - velocity_a_y - angular_velocity_a * arm_a_x
    ) * (normal_x)


def cross_coupling(
    inverse_inertia_a: Scalar,
    arm_a: Vector,
    inverse_inertia_b: Scalar,
    arm_b: Vector,
    normal: Vector,
) -> Scalar:
    """Change of the tangential velocity of a contact for one unit of impulse along its normal, and
    of its normal velocity for one along its tangent (1/kg).

    cross_coupling = inverse_inertia_a*cross(arm_a, normal)*cross(arm_a, perp(normal)) +
    inverse_inertia_b*cross(arm_b, normal)*cross(arm_b, perp(normal))

    Args:
        inverse_inertia_a: One over the inertia, zero for a body that cannot turn; of body A,
            1/(kg*m^2)
        arm_a: Lever arm, from the centre of mass to the point where something acts on a body;
            of body A, m
        inverse_inertia_b: One over the inertia, zero for a body that cannot turn; of body B,
            1/(kg*m^2)
        arm_b: Lever arm, from the centre of mass to the point where something acts on a body;
            of body B, m
        normal: Unit normal of a contact, from body A to body B, 1

    Source: IM9, srs/models/friction.md:86.
    """
    arm_a_x, arm_a_y = arm_a
    arm_b_x, arm_b_y = arm_b
    normal_x, normal_y = normal
    return inverse_inertia_a * (arm_a_x * normal_y - arm_a_y * normal_x) * (
        arm_a_x * (normal_x) - arm_a_y * (-normal_y)
    ) + inverse_inertia_b * (arm_b_x * normal_y - arm_b_y * normal_x) * (
        arm_b_x * (normal_x) - arm_b_y * (-normal_y)
    )


def inverse_sliding_mass(
    inverse_mass_a: Scalar,
    inverse_inertia_a: Scalar,
    arm_a: Vector,
    inverse_mass_b: Scalar,
    inverse_inertia_b: Scalar,
    arm_b: Vector,
    inverse_effective_mass: Scalar,
) -> Scalar:
    """Change of the tangential velocity for one unit of tangential impulse, while the normal
    impulse keeps the normal velocity as it is (1/kg).

    inverse_sliding_mass = ((inverse_mass_a + inverse_mass_b)*(inverse_mass_a + inverse_mass_b
    + inverse_inertia_a*dot(arm_a, arm_a) + inverse_inertia_b*dot(arm_b, arm_b)) +
    inverse_inertia_a*inverse_inertia_b*cross(arm_a, arm_b)**2)/inverse_effective_mass

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
        inverse_effective_mass: Change of the normal velocity for one unit of impulse, 1/kg

    Source: IM9, srs/models/friction.md:92.
    """
    arm_a_x, arm_a_y = arm_a
    arm_b_x, arm_b_y = arm_b
    return (
        (inverse_mass_a + inverse_mass_b)
        * (
            inverse_mass_a
            + inverse_mass_b
            + inverse_inertia_a * (arm_a_x * arm_a_x + arm_a_y * arm_a_y)
            + inverse_inertia_b * (arm_b_x * arm_b_x + arm_b_y * arm_b_y)
        )
        + inverse_inertia_a * inverse_inertia_b * power(arm_a_x * arm_b_y - arm_a_y * arm_b_x, 2)
    ) / inverse_effective_mass


def tangential_velocity_closest(
    tangential_velocity: Scalar,
    cross_coupling: Scalar,
    normal_velocity: Scalar,
    inverse_effective_mass: Scalar,
) -> Scalar:
    """Velocity of B's point of contact seen from A's, along the tangent; zero where the contact
    does not slide; when the bodies are closest (m/s).

    tangential_velocity_closest = tangential_velocity -
    cross_coupling*normal_velocity/inverse_effective_mass

    Args:
        tangential_velocity: Velocity of B's point of contact seen from A's, along the tangent;
            zero where the contact does not slide, m/s
        cross_coupling: Change of the tangential velocity of a contact for one unit of impulse
            along its normal, and of its normal velocity for one along its tangent, 1/kg
        normal_velocity: Rate at which the contact opens, along the normal; negative when the
            bodies approach, m/s
        inverse_effective_mass: Change of the normal velocity for one unit of impulse, 1/kg

    Source: IM9, srs/models/friction.md:97.
    """
    return tangential_velocity - cross_coupling * normal_velocity / inverse_effective_mass


def sticking_impulse(tangential_velocity_closest: Scalar, inverse_sliding_mass: Scalar) -> Scalar:
    """Tangential impulse that ends the sliding of a contact (N*s).

    sticking_impulse = -tangential_velocity_closest/inverse_sliding_mass

    Args:
        tangential_velocity_closest: Velocity of B's point of contact seen from A's, along the
            tangent; zero where the contact does not slide; when the bodies are closest, m/s
        inverse_sliding_mass: Change of the tangential velocity for one unit of tangential
            impulse, while the normal impulse keeps the normal velocity as it is, 1/kg

    Source: IM9, srs/models/friction.md:99.
    """
    return (-tangential_velocity_closest) / inverse_sliding_mass


def normal_change(
    cross_coupling: Scalar, sticking_impulse: Scalar, inverse_effective_mass: Scalar
) -> Scalar:
    """Change of the normal impulse that comes with the sticking impulse (N*s).

    normal_change = -cross_coupling*sticking_impulse/inverse_effective_mass

    Args:
        cross_coupling: Change of the tangential velocity of a contact for one unit of impulse
            along its normal, and of its normal velocity for one along its tangent, 1/kg
        sticking_impulse: Tangential impulse that ends the sliding of a contact, N*s
        inverse_effective_mass: Change of the normal velocity for one unit of impulse, 1/kg

    Source: IM9, srs/models/friction.md:100.
    """
    return (-cross_coupling) * sticking_impulse / inverse_effective_mass


def share(
    pair_friction: Scalar, impulse: Scalar, sticking_impulse: Scalar, normal_change: Scalar
) -> Scalar:
    """Part of the sticking impulse that friction can give, 1 where the contact sticks (1).

    share = impulse/max(abs(sticking_impulse)/pair_friction - normal_change, impulse)

    Args:
        pair_friction: The coefficient of friction that holds between two bodies, 1
        impulse: Size of the impulse of a contact along its normal, N*s
        sticking_impulse: Tangential impulse that ends the sliding of a contact, N*s
        normal_change: Change of the normal impulse that comes with the sticking impulse, N*s

    Source: IM9, srs/models/friction.md:101.
    """
    return impulse / largest(abs(sticking_impulse) / pair_friction - normal_change, impulse)


def normal_impulse(impulse: Scalar, share: Scalar, normal_change: Scalar) -> Scalar:
    """Impulse along the normal of a contact with friction (N*s).

    normal_impulse = impulse + share*normal_change

    Args:
        impulse: Size of the impulse of a contact along its normal, N*s
        share: Part of the sticking impulse that friction can give, 1 where the contact sticks,
            1
        normal_change: Change of the normal impulse that comes with the sticking impulse, N*s

    Source: IM9, srs/models/friction.md:103.
    """
    return impulse + share * normal_change


def tangential_impulse(share: Scalar, sticking_impulse: Scalar) -> Scalar:
    """Impulse of a contact on body B along its tangent (N*s).

    tangential_impulse = share*sticking_impulse

    Args:
        share: Part of the sticking impulse that friction can give, 1 where the contact sticks,
            1
        sticking_impulse: Tangential impulse that ends the sliding of a contact, N*s

    Source: IM9, srs/models/friction.md:104.
    """
    return share * sticking_impulse


def impulse_vector(normal_impulse: Scalar, tangential_impulse: Scalar, normal: Vector) -> Vector:
    """Integral of a force over the time in which it acts (N*s).

    impulse_vector = normal_impulse*normal + tangential_impulse*perp(normal)

    Args:
        normal_impulse: Impulse along the normal of a contact with friction, N*s
        tangential_impulse: Impulse of a contact on body B along its tangent, N*s
        normal: Unit normal of a contact, from body A to body B, 1

    Source: IM9, srs/models/friction.md:105.
    """
    normal_x, normal_y = normal
    return (
        normal_impulse * normal_x + tangential_impulse * (-normal_y),
        normal_impulse * normal_y + tangential_impulse * (normal_x),
    )


def velocity_a_after(velocity_a: Vector, inverse_mass_a: Scalar, impulse_vector: Vector) -> Vector:
    """Velocity of the centre of mass; of body A; just after the impact (m/s).

    velocity_a_after = velocity_a - inverse_mass_a*impulse_vector

    Args:
        velocity_a: Velocity of the centre of mass; of body A, m/s
        inverse_mass_a: One over the mass, zero for a static body; of body A, 1/kg
        impulse_vector: Integral of a force over the time in which it acts, N*s

    Source: IM9, srs/models/friction.md:106.
    """
    velocity_a_x, velocity_a_y = velocity_a
    impulse_vector_x, impulse_vector_y = impulse_vector
    return (
        velocity_a_x - inverse_mass_a * impulse_vector_x,
        velocity_a_y - inverse_mass_a * impulse_vector_y,
    )


def angular_velocity_a_after(
    angular_velocity_a: Scalar, inverse_inertia_a: Scalar, arm_a: Vector, impulse_vector: Vector
) -> Scalar:
    """Rate of turning, positive counter-clockwise; of body A; just after the impact (rad/s).

    angular_velocity_a_after = angular_velocity_a - inverse_inertia_a*cross(arm_a,
    impulse_vector)

    Args:
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        inverse_inertia_a: One over the inertia, zero for a body that cannot turn; of body A,
            1/(kg*m^2)
        arm_a: Lever arm, from the centre of mass to the point where something acts on a body;
            of body A, m
        impulse_vector: Integral of a force over the time in which it acts, N*s

    Source: IM9, srs/models/friction.md:107.
    """
    arm_a_x, arm_a_y = arm_a
    impulse_vector_x, impulse_vector_y = impulse_vector
    return angular_velocity_a - inverse_inertia_a * (
        arm_a_x * impulse_vector_y - arm_a_y * impulse_vector_x
    )


def velocity_b_after(velocity_b: Vector, inverse_mass_b: Scalar, impulse_vector: Vector) -> Vector:
    """Velocity of the centre of mass; of body B; just after the impact (m/s).

    velocity_b_after = velocity_b + inverse_mass_b*impulse_vector

    Args:
        velocity_b: Velocity of the centre of mass; of body B, m/s
        inverse_mass_b: One over the mass, zero for a static body; of body B, 1/kg
        impulse_vector: Integral of a force over the time in which it acts, N*s

    Source: IM9, srs/models/friction.md:109.
    """
    velocity_b_x, velocity_b_y = velocity_b
    impulse_vector_x, impulse_vector_y = impulse_vector
    return (
        velocity_b_x + inverse_mass_b * impulse_vector_x,
        velocity_b_y + inverse_mass_b * impulse_vector_y,
    )


def angular_velocity_b_after(
    angular_velocity_b: Scalar, inverse_inertia_b: Scalar, arm_b: Vector, impulse_vector: Vector
) -> Scalar:
    """Rate of turning, positive counter-clockwise; of body B; just after the impact (rad/s).

    angular_velocity_b_after = angular_velocity_b + inverse_inertia_b*cross(arm_b,
    impulse_vector)

    Args:
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s
        inverse_inertia_b: One over the inertia, zero for a body that cannot turn; of body B,
            1/(kg*m^2)
        arm_b: Lever arm, from the centre of mass to the point where something acts on a body;
            of body B, m
        impulse_vector: Integral of a force over the time in which it acts, N*s

    Source: IM9, srs/models/friction.md:110.
    """
    arm_b_x, arm_b_y = arm_b
    impulse_vector_x, impulse_vector_y = impulse_vector
    return angular_velocity_b + inverse_inertia_b * (
        arm_b_x * impulse_vector_y - arm_b_y * impulse_vector_x
    )


def tangential_acceleration(
    acceleration_a: Vector,
    angular_acceleration_a: Scalar,
    arm_a: Vector,
    acceleration_b: Vector,
    angular_acceleration_b: Scalar,
    arm_b: Vector,
    normal: Vector,
) -> Scalar:
    """Rate of change of the tangential velocity of a contact that lasts (m/s^2).

    tangential_acceleration = dot(acceleration_b + cross(angular_acceleration_b, arm_b) -
    acceleration_a - cross(angular_acceleration_a, arm_a), perp(normal))

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

    Source: GD8, srs/models/friction.md:325.
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
    ) * (-normal_y) + (
        acceleration_b_y
        + angular_acceleration_b * arm_b_x
        - acceleration_a_y
        - angular_acceleration_a * arm_a_x
    ) * (normal_x)


def friction_force(sense: Scalar, pair_friction: Scalar, contact_force: Scalar) -> Scalar:
    """Force of friction on body B along the tangent (N).

    friction_force = -sense*pair_friction*contact_force

    Args:
        sense: Sense in which a contact slides, 1 along its tangent, -1 against it, 0 where it
            sticks, 1
        pair_friction: The coefficient of friction that holds between two bodies, 1
        contact_force: Size of the force of a resting contact along its normal, N

    Source: GD8, srs/models/friction.md:331.
    """
    return (-sense) * pair_friction * contact_force


def tangential_acceleration_turning(
    tangential_acceleration: Scalar,
    angular_velocity_a: Scalar,
    arm_a: Vector,
    angular_velocity_b: Scalar,
    arm_b: Vector,
    tangent: Vector,
) -> Scalar:
    """Rate of change of the tangential velocity of a contact that lasts; with what turning adds
    (m/s^2).

    tangential_acceleration_turning = tangential_acceleration + turning_part
        where turning_part = angular_velocity_a**2*dot(tangent, arm_a) - angular_velocity_b**2*dot(tangent, arm_b)

    Args:
        tangential_acceleration: Rate of change of the tangential velocity of a contact that
            lasts, m/s^2
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        arm_a: Lever arm, from the centre of mass to the point where something acts on a body;
            of body A, m
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s
        arm_b: Lever arm, from the centre of mass to the point where something acts on a body;
            of body B, m
        tangent: Unit tangent of a contact, the normal turned left by a quarter turn, 1

    Source: GD16, srs/models/friction.md:385.
    """
    arm_a_x, arm_a_y = arm_a
    arm_b_x, arm_b_y = arm_b
    tangent_x, tangent_y = tangent
    turning_part = angular_velocity_a * angular_velocity_a * (
        tangent_x * arm_a_x + tangent_y * arm_a_y
    ) - angular_velocity_b * angular_velocity_b * (tangent_x * arm_b_x + tangent_y * arm_b_y)
    return tangential_acceleration + turning_part


def reach_change(
    angular_velocity: Scalar,
    bearing_corner: Vector,
    normal: Vector,
    normal_turning: Scalar,
    tangent: Vector,
) -> Scalar:
    """Rate at which a point of contact gets farther from the centre of a body along the normal
    (m/s).

    reach_change = angular_velocity*cross(bearing_corner, normal) +
    normal_turning*dot(bearing_corner, tangent)

    Args:
        angular_velocity: Rate of turning, positive counter-clockwise, rad/s
        bearing_corner: From the centre of a body to the corner with which it touches; zero
            where a side or the rim of a disc touches, m
        normal: Unit normal of a contact, from body A to body B, 1
        normal_turning: Rate at which the normal of a contact turns, rad/s
        tangent: Unit tangent of a contact, the normal turned left by a quarter turn, 1

    Source: DD69, srs/models/friction.md:433.
    """
    bearing_corner_x, bearing_corner_y = bearing_corner
    normal_x, normal_y = normal
    tangent_x, tangent_y = tangent
    return angular_velocity * (
        bearing_corner_x * normal_y - bearing_corner_y * normal_x
    ) + normal_turning * (bearing_corner_x * tangent_x + bearing_corner_y * tangent_y)


def tangential_acceleration_rolling(
    tangential_acceleration: Scalar,
    normal_turning: Scalar,
    velocity_a: Vector,
    velocity_b: Vector,
    normal: Vector,
    angular_velocity_a: Scalar,
    reach_change_a: Scalar,
    angular_velocity_b: Scalar,
    reach_change_b: Scalar,
) -> Scalar:
    """Rate of change of the tangential velocity of a contact that lasts; of a contact that rolls
    (m/s^2).

    tangential_acceleration_rolling = tangential_acceleration - normal_turning*dot(velocity_b
    - velocity_a, normal) + angular_velocity_b*reach_change_b -
    angular_velocity_a*reach_change_a

    Args:
        tangential_acceleration: Rate of change of the tangential velocity of a contact that
            lasts, m/s^2
        normal_turning: Rate at which the normal of a contact turns, rad/s
        velocity_a: Velocity of the centre of mass; of body A, m/s
        velocity_b: Velocity of the centre of mass; of body B, m/s
        normal: Unit normal of a contact, from body A to body B, 1
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        reach_change_a: Rate at which a point of contact gets farther from the centre of a body
            along the normal; of body A, m/s
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s
        reach_change_b: Rate at which a point of contact gets farther from the centre of a body
            along the normal; of body B, m/s

    Source: DD69, srs/models/friction.md:436.
    """
    velocity_a_x, velocity_a_y = velocity_a
    velocity_b_x, velocity_b_y = velocity_b
    normal_x, normal_y = normal
    return (
        tangential_acceleration
        - normal_turning
        * ((velocity_b_x - velocity_a_x) * normal_x + (velocity_b_y - velocity_a_y) * normal_y)
        + angular_velocity_b * reach_change_b
        - angular_velocity_a * reach_change_a
    )


def settling_impulse(normal_velocity_after: Scalar, inverse_pressed_mass: Scalar) -> Scalar:
    """Impulse along the normal by which the bounces that are left give more than a contact that
    rests for the same time (N*s).

    settling_impulse = -normal_velocity_after/inverse_pressed_mass

    Args:
        normal_velocity_after: Rate at which the contact opens, along the normal; negative when
            the bodies approach; just after the impact, m/s
        inverse_pressed_mass: Change of the normal acceleration for one unit of normal force,
            with the friction that it brings about, 1/kg

    Source: DD75, srs/models/friction.md:550.
    """
    return (-normal_velocity_after) / inverse_pressed_mass


def creep(
    normal_velocity_after: Scalar,
    normal_acceleration: Scalar,
    tangential_acceleration: Scalar,
    restitution: Scalar,
) -> Scalar:
    """Way along the tangent in the bounces that are left, at each of which a contact sticks (m).

    creep = 2*normal_velocity_after**2*tangential_acceleration/(normal_acceleration**2*(1 -
    restitution**2))

    Args:
        normal_velocity_after: Rate at which the contact opens, along the normal; negative when
            the bodies approach; just after the impact, m/s
        normal_acceleration: Rate of change of the normal velocity of a contact that rests,
            m/s^2
        tangential_acceleration: Rate of change of the tangential velocity of a contact that
            lasts, m/s^2
        restitution: Coefficient of restitution, from 0 (the bodies stay together) to 1 (no
            energy is lost), 1

    Source: DD78, srs/models/friction.md:598.
    """
    return (
        2
        * normal_velocity_after
        * normal_velocity_after
        * tangential_acceleration
        / (normal_acceleration * normal_acceleration * (1 - restitution * restitution))
    )


def friction_force_most(contact_force: Scalar, pair_friction: Scalar) -> Scalar:
    """Force of friction on body B along the tangent; the most that there may be (N).

    friction_force_most = pair_friction*contact_force

    Args:
        contact_force: Size of the force of a resting contact along its normal, N
        pair_friction: The coefficient of friction that holds between two bodies, 1

    Source: IM18, srs/models/friction.md:651.
    """
    return pair_friction * contact_force
