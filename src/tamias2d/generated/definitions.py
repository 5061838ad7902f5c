"""Definitions: Velocity of a point of a body; Torque; Inertia of uniform shapes; Area and inertia
of a capsule; Bodies of several parts; Inertia in proportion to the mass; Radius of gyration;
Acceleration by inverse mass; Reaction by its acceleration; Flow through a step; Impulse against
drag; Momentum; Coefficient of restitution; Restitution of a pair; Contact of two vertices;
Tangential velocity of a contact; Friction of a pair; Kinetic energy; Potential energy; Energy
lost in an impact; Share that no world has shown; What a joint is said to exert; Motor of a
joint; Spring along a joint; Spring about a joint; Bounded spring of a joint; Breaking of a
joint.

Generated from srs/definitions.md and srs/models/joints.md
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.functions import Scalar, Vector, largest, least, log, phi1, pi, sqrt, total


def point_velocity(velocity: Vector, angular_velocity: Scalar, arm: Vector) -> Vector:
    """Velocity of the point of a body that sits at the end of an arm (m/s).

    point_velocity = velocity + cross(angular_velocity, arm)

    Args:
        velocity: Velocity of the centre of mass, m/s
        angular_velocity: Rate of turning, positive counter-clockwise, rad/s
        arm: Lever arm, from the centre of mass to the point where something acts on a body, m

    Source: DD9, srs/definitions.md:73.
    """
    velocity_x, velocity_y = velocity
    arm_x, arm_y = arm
    return (velocity_x - angular_velocity * arm_y, velocity_y + angular_velocity * arm_x)


def torque(arm: Vector, force: Vector) -> Scalar:
    """Applied torque about the centre of mass, positive counter-clockwise (N*m).

    torque = cross(arm, force)

    Args:
        arm: Lever arm, from the centre of mass to the point where something acts on a body, m
        force: Applied force on a body, without its weight, N

    Source: DD13, srs/definitions.md:90.
    """
    arm_x, arm_y = arm
    force_x, force_y = force
    return arm_x * force_y - arm_y * force_x


def inertia_disc(mass: Scalar, radius: Scalar) -> Scalar:
    """Moment of inertia about the centre of mass; of a uniform disc (kg*m^2).

    inertia_disc = mass*radius**2/2

    Args:
        mass: Mass of a body, kg
        radius: Radius of a disc, or of the round ends of a capsule, m

    Source: DD18, srs/definitions.md:118.
    """
    return mass * radius * radius / 2


def inertia_box(mass: Scalar, width: Scalar, height: Scalar) -> Scalar:
    """Moment of inertia about the centre of mass; of a uniform box (kg*m^2).

    inertia_box = mass*(width**2 + height**2)/12

    Args:
        mass: Mass of a body, kg
        width: Extent of a box along its own x axis, m
        height: Extent of a box along its own y axis, m

    Source: DD18, srs/definitions.md:119.
    """
    return mass * (width * width + height * height) / 12


def inertia_polygon(mass: Scalar, vertex_i: Vector, vertex_j: Vector) -> Scalar:
    """Moment of inertia about the centre of mass; of a uniform polygon (kg*m^2).

    inertia_polygon = mass*sum(cross(vertex_i, vertex_j)*(dot(vertex_i, vertex_i) +
    dot(vertex_i, vertex_j) + dot(vertex_j, vertex_j)))/(6*sum(cross(vertex_i, vertex_j)))

    Args:
        mass: Mass of a body, kg
        vertex_i: Corner of a polygon; corners are counted counter-clockwise; of each particle,
            body or vertex in turn, m
        vertex_j: Corner of a polygon; corners are counted counter-clockwise; of the one after
            it, m

    Source: DD18, srs/definitions.md:120.
    """
    vertex_i_x, vertex_i_y = vertex_i
    vertex_j_x, vertex_j_y = vertex_j
    return (
        mass
        * total(
            (vertex_i_x * vertex_j_y - vertex_i_y * vertex_j_x)
            * (
                vertex_i_x * vertex_i_x
                + vertex_i_y * vertex_i_y
                + vertex_i_x * vertex_j_x
                + vertex_i_y * vertex_j_y
                + vertex_j_x * vertex_j_x
                + vertex_j_y * vertex_j_y
            )
        )
        / (6 * total(vertex_i_x * vertex_j_y - vertex_i_y * vertex_j_x))
    )


def area_polygon(vertex_i: Vector, vertex_j: Vector) -> Scalar:
    """Area of a shape; of a uniform polygon (m^2).

    area_polygon = sum(cross(vertex_i, vertex_j))/2

    Args:
        vertex_i: Corner of a polygon; corners are counted counter-clockwise; of each particle,
            body or vertex in turn, m
        vertex_j: Corner of a polygon; corners are counted counter-clockwise; of the one after
            it, m

    Source: DD18, srs/definitions.md:124.
    """
    vertex_i_x, vertex_i_y = vertex_i
    vertex_j_x, vertex_j_y = vertex_j
    return total(vertex_i_x * vertex_j_y - vertex_i_y * vertex_j_x) / 2


def centroid_polygon(vertex_i: Vector, vertex_j: Vector) -> Vector:
    """Centre of a shape's area; of a uniform polygon (m).

    centroid_polygon = sum((vertex_i + vertex_j)*cross(vertex_i,
    vertex_j))/(3*sum(cross(vertex_i, vertex_j)))

    Args:
        vertex_i: Corner of a polygon; corners are counted counter-clockwise; of each particle,
            body or vertex in turn, m
        vertex_j: Corner of a polygon; corners are counted counter-clockwise; of the one after
            it, m

    Source: DD18, srs/definitions.md:125.
    """
    vertex_i_x, vertex_i_y = vertex_i
    vertex_j_x, vertex_j_y = vertex_j
    return (
        total((vertex_i_x + vertex_j_x) * (vertex_i_x * vertex_j_y - vertex_i_y * vertex_j_x))
        / (3 * total(vertex_i_x * vertex_j_y - vertex_i_y * vertex_j_x)),
        total((vertex_i_y + vertex_j_y) * (vertex_i_x * vertex_j_y - vertex_i_y * vertex_j_x))
        / (3 * total(vertex_i_x * vertex_j_y - vertex_i_y * vertex_j_x)),
    )


def area_disc(radius: Scalar) -> Scalar:
    """Area of a shape; of a uniform disc (m^2).

    area_disc = pi*radius**2

    Args:
        radius: Radius of a disc, or of the round ends of a capsule, m

    Source: DD24, srs/definitions.md:152.
    """
    return pi * radius * radius


def area_box(width: Scalar, height: Scalar) -> Scalar:
    """Area of a shape; of a uniform box (m^2).

    area_box = width*height

    Args:
        width: Extent of a box along its own x axis, m
        height: Extent of a box along its own y axis, m

    Source: DD24, srs/definitions.md:153.
    """
    return width * height


def area_capsule(length: Scalar, radius: Scalar) -> Scalar:
    """Area of a shape; of a uniform capsule (m^2).

    area_capsule = 2*radius*length + pi*radius**2

    Args:
        length: Distance between the middles of a capsule's round ends, or between the ends of a
            segment, m
        radius: Radius of a disc, or of the round ends of a capsule, m

    Source: DD24, srs/definitions.md:154.
    """
    return 2 * radius * length + pi * radius * radius


def inertia_segment(mass: Scalar, length: Scalar) -> Scalar:
    """Moment of inertia about the centre of mass; of a uniform segment (kg*m^2).

    inertia_segment = mass*length**2/12

    Args:
        mass: Mass of a body, kg
        length: Distance between the middles of a capsule's round ends, or between the ends of a
            segment, m

    Source: DD24, srs/definitions.md:155.
    """
    return mass * length * length / 12


def inertia_capsule(mass: Scalar, length: Scalar, radius: Scalar) -> Scalar:
    """Moment of inertia about the centre of mass; of a uniform capsule (kg*m^2).

    inertia_capsule = mass*(length**3/6 + 2*radius**2*length + pi*radius*(radius**2/2 +
    length**2/4))/(2*length + pi*radius)

    Args:
        mass: Mass of a body, kg
        length: Distance between the middles of a capsule's round ends, or between the ends of a
            segment, m
        radius: Radius of a disc, or of the round ends of a capsule, m

    Source: DD24, srs/definitions.md:156.
    """
    return (
        mass
        * (
            length * length * length / 6
            + 2 * radius * radius * length
            + pi * radius * (radius * radius / 2 + length * length / 4)
        )
        / (2 * length + pi * radius)
    )


def position_compound(area_i: Scalar, position_i: Vector) -> Vector:
    """Position of the centre of mass; of a body of several parts (m).

    position_compound = sum(area_i*position_i)/sum(area_i)

    Args:
        area_i: Area of a shape; of each particle, body or vertex in turn, m^2
        position_i: Position of the centre of mass; of each particle, body or vertex in turn, m

    Source: DD25, srs/definitions.md:196.
    """
    position_i_x, position_i_y = position_i
    return (
        total(area_i * position_i_x) / total(area_i),
        total(area_i * position_i_y) / total(area_i),
    )


def inertia_compound(inertia_i: Scalar, mass_i: Scalar, arm_i: Vector) -> Scalar:
    """Moment of inertia about the centre of mass; of a body of several parts (kg*m^2).

    inertia_compound = sum(inertia_i + mass_i*dot(arm_i, arm_i))

    Args:
        inertia_i: Moment of inertia about the centre of mass; of each particle, body or vertex
            in turn, kg*m^2
        mass_i: Mass of a body; of each particle, body or vertex in turn, kg
        arm_i: Lever arm, from the centre of mass to the point where something acts on a body;
            of each particle, body or vertex in turn, m

    Source: DD25, srs/definitions.md:197.
    """
    arm_i_x, arm_i_y = arm_i
    return total(inertia_i + mass_i * (arm_i_x * arm_i_x + arm_i_y * arm_i_y))


def inertia_later(inertia: Scalar, mass: Scalar, mass_later: Scalar) -> Scalar:
    """Moment of inertia about the centre of mass; after the bodies have moved (kg*m^2).

    inertia_later = inertia*mass_later/mass

    Args:
        inertia: Moment of inertia about the centre of mass, kg*m^2
        mass: Mass of a body, kg
        mass_later: Mass of a body; after the bodies have moved, kg

    Source: DD92, srs/definitions.md:221.
    """
    return inertia * mass_later / mass


def gyration_radius(inverse_mass: Scalar, inverse_inertia: Scalar) -> Scalar:
    """Radius of gyration, how far from its centre the mass of a body is (m).

    gyration_radius = sqrt(inverse_mass/inverse_inertia)

    Args:
        inverse_mass: One over the mass, zero for a static body, 1/kg
        inverse_inertia: One over the inertia, zero for a body that cannot turn, 1/(kg*m^2)

    Source: DD95, srs/definitions.md:234.
    """
    return sqrt(inverse_mass / inverse_inertia)


def acceleration(gravity: Vector, force: Vector, inverse_mass: Scalar) -> Vector:
    """Acceleration of the centre of mass (m/s^2).

    acceleration = gravity + inverse_mass*force

    Args:
        gravity: Gravitational acceleration, the same for all bodies, m/s^2
        force: Applied force on a body, without its weight, N
        inverse_mass: One over the mass, zero for a static body, 1/kg

    Source: DD30, srs/definitions.md:260.
    """
    gravity_x, gravity_y = gravity
    force_x, force_y = force
    return (gravity_x + inverse_mass * force_x, gravity_y + inverse_mass * force_y)


def angular_acceleration(torque: Scalar, inverse_inertia: Scalar) -> Scalar:
    """Rate of change of the angular velocity (rad/s^2).

    angular_acceleration = inverse_inertia*torque

    Args:
        torque: Applied torque about the centre of mass, positive counter-clockwise, N*m
        inverse_inertia: One over the inertia, zero for a body that cannot turn, 1/(kg*m^2)

    Source: DD30, srs/definitions.md:261.
    """
    return inverse_inertia * torque


def reaction_force(
    acceleration_constrained: Vector, acceleration: Vector, inverse_mass: Scalar
) -> Vector:
    """Force by which what holds a body changes its acceleration (N).

    reaction_force = (acceleration_constrained - acceleration)/inverse_mass

    Args:
        acceleration_constrained: Acceleration of the centre of mass; with what holds the body,
            m/s^2
        acceleration: Acceleration of the centre of mass, m/s^2
        inverse_mass: One over the mass, zero for a static body, 1/kg

    Source: DD111, srs/definitions.md:286.
    """
    acceleration_constrained_x, acceleration_constrained_y = acceleration_constrained
    acceleration_x, acceleration_y = acceleration
    return (
        (acceleration_constrained_x - acceleration_x) / inverse_mass,
        (acceleration_constrained_y - acceleration_y) / inverse_mass,
    )


def reaction_torque(
    angular_acceleration_constrained: Scalar, angular_acceleration: Scalar, inverse_inertia: Scalar
) -> Scalar:
    """Torque about the centre of mass by which what holds a body changes its turning (N*m).

    reaction_torque = (angular_acceleration_constrained -
    angular_acceleration)/inverse_inertia

    Args:
        angular_acceleration_constrained: Rate of change of the angular velocity; with what
            holds the body, rad/s^2
        angular_acceleration: Rate of change of the angular velocity, rad/s^2
        inverse_inertia: One over the inertia, zero for a body that cannot turn, 1/(kg*m^2)

    Source: DD111, srs/definitions.md:287.
    """
    return (angular_acceleration_constrained - angular_acceleration) / inverse_inertia


def coordinate_velocity_gain(propagator_gain: Scalar, coordinate_acceleration: Scalar) -> Scalar:
    """What an acceleration adds to a velocity along one axis in a step (m/s).

    coordinate_velocity_gain = propagator_gain*coordinate_acceleration

    Args:
        propagator_gain: Velocity after a step for one unit of acceleration, s
        coordinate_acceleration: Acceleration along one axis, of gravity and applied forces,
            m/s^2

    Source: DD41, srs/definitions.md:326.
    """
    return propagator_gain * coordinate_acceleration


def coordinate_velocity_later(
    propagator_decay: Scalar, coordinate_velocity: Scalar, coordinate_velocity_gain: Scalar
) -> Scalar:
    """Velocity along one axis after a step (m/s).

    coordinate_velocity_later = propagator_decay*coordinate_velocity +
    coordinate_velocity_gain

    Args:
        propagator_decay: Part of a velocity that drag leaves after a step, 1
        coordinate_velocity: Velocity along one axis, m/s
        coordinate_velocity_gain: What an acceleration adds to a velocity along one axis in a
            step, m/s

    Source: DD41, srs/definitions.md:327.
    """
    return propagator_decay * coordinate_velocity + coordinate_velocity_gain


def coordinate_displacement(
    propagator_gain: Scalar,
    propagator_lift: Scalar,
    coordinate_velocity: Scalar,
    coordinate_acceleration: Scalar,
) -> Scalar:
    """How far a body goes along one axis in a step (m).

    coordinate_displacement = propagator_gain*coordinate_velocity +
    propagator_lift*coordinate_acceleration

    Args:
        propagator_gain: Velocity after a step for one unit of acceleration, s
        propagator_lift: Displacement in a step for one unit of acceleration, s^2
        coordinate_velocity: Velocity along one axis, m/s
        coordinate_acceleration: Acceleration along one axis, of gravity and applied forces,
            m/s^2

    Source: DD41, srs/definitions.md:329.
    """
    return propagator_gain * coordinate_velocity + propagator_lift * coordinate_acceleration


def slowed_share(propagator_gain: Scalar, time_step: Scalar) -> Scalar:
    """Part that drag leaves of a change of velocity by an impulse that acts evenly through a step
    (1).

    slowed_share = propagator_gain/time_step

    Args:
        propagator_gain: Velocity after a step for one unit of acceleration, s
        time_step: Length of one step of a stepped scheme, s

    Source: DD110, srs/definitions.md:379.
    """
    return propagator_gain / time_step


def inverse_mass_slowed(slowed_share: Scalar, inverse_mass: Scalar) -> Scalar:
    """One over the mass, zero for a static body; as drag leaves it of what acts evenly through a
    step (1/kg).

    inverse_mass_slowed = slowed_share*inverse_mass

    Args:
        slowed_share: Part that drag leaves of a change of velocity by an impulse that acts
            evenly through a step, 1
        inverse_mass: One over the mass, zero for a static body, 1/kg

    Source: DD110, srs/definitions.md:380.
    """
    return slowed_share * inverse_mass


def inverse_inertia_slowed(slowed_share: Scalar, inverse_inertia: Scalar) -> Scalar:
    """One over the inertia, zero for a body that cannot turn; as drag leaves it of what acts
    evenly through a step (1/(kg*m^2)).

    inverse_inertia_slowed = slowed_share*inverse_inertia

    Args:
        slowed_share: Part that drag leaves of a change of velocity by an impulse that acts
            evenly through a step, 1
        inverse_inertia: One over the inertia, zero for a body that cannot turn, 1/(kg*m^2)

    Source: DD110, srs/definitions.md:381.
    """
    return slowed_share * inverse_inertia


def coordinate_velocity_slowed(
    coordinate_velocity: Scalar, slowed_share: Scalar, coordinate_velocity_given: Scalar
) -> Scalar:
    """Velocity along one axis; as drag leaves it of what acts evenly through a step (m/s).

    coordinate_velocity_slowed = coordinate_velocity - (1 -
    slowed_share)*coordinate_velocity_given

    Args:
        coordinate_velocity: Velocity along one axis, m/s
        slowed_share: Part that drag leaves of a change of velocity by an impulse that acts
            evenly through a step, 1
        coordinate_velocity_given: What impulses add to a velocity along one axis in a step
            without drag, m/s

    Source: DD110, srs/definitions.md:382.
    """
    return coordinate_velocity - (1 - slowed_share) * coordinate_velocity_given


def momentum(mass: Scalar, velocity: Vector) -> Vector:
    """Mass times velocity (kg*m/s).

    momentum = mass*velocity

    Args:
        mass: Mass of a body, kg
        velocity: Velocity of the centre of mass, m/s

    Source: DD21, srs/definitions.md:478.
    """
    velocity_x, velocity_y = velocity
    return (mass * velocity_x, mass * velocity_y)


def angular_momentum_own(inertia: Scalar, angular_velocity: Scalar) -> Scalar:
    """Moment of momentum about the origin; about the body's own centre of mass (kg*m^2/s).

    angular_momentum_own = inertia*angular_velocity

    Args:
        inertia: Moment of inertia about the centre of mass, kg*m^2
        angular_velocity: Rate of turning, positive counter-clockwise, rad/s

    Source: DD21, srs/definitions.md:479.
    """
    return inertia * angular_velocity


def angular_momentum(
    mass: Scalar, position: Vector, velocity: Vector, inertia: Scalar, angular_velocity: Scalar
) -> Scalar:
    """Moment of momentum about the origin (kg*m^2/s).

    angular_momentum = mass*cross(position, velocity) + angular_momentum_own
        where angular_momentum_own = inertia*angular_velocity

    Args:
        mass: Mass of a body, kg
        position: Position of the centre of mass, m
        velocity: Velocity of the centre of mass, m/s
        inertia: Moment of inertia about the centre of mass, kg*m^2
        angular_velocity: Rate of turning, positive counter-clockwise, rad/s

    Source: DD21, srs/definitions.md:480.
    """
    position_x, position_y = position
    velocity_x, velocity_y = velocity
    angular_momentum_own = inertia * angular_velocity
    return mass * (position_x * velocity_y - position_y * velocity_x) + angular_momentum_own


def normal_velocity_after(restitution: Scalar, normal_velocity_before: Scalar) -> Scalar:
    """Rate at which the contact opens, along the normal; negative when the bodies approach; just
    after the impact (m/s).

    normal_velocity_after = -restitution*normal_velocity_before

    Args:
        restitution: Coefficient of restitution, from 0 (the bodies stay together) to 1 (no
            energy is lost), 1
        normal_velocity_before: Rate at which the contact opens, along the normal; negative when
            the bodies approach; just before the impact, m/s

    Source: DD12, srs/definitions.md:560.
    """
    return (-restitution) * normal_velocity_before


def pair_restitution(restitution_a: Scalar, restitution_b: Scalar) -> Scalar:
    """The coefficient of restitution that holds between two bodies (1).

    pair_restitution = min(restitution_a, restitution_b)

    Args:
        restitution_a: Coefficient of restitution, from 0 (the bodies stay together) to 1 (no
            energy is lost); of body A, 1
        restitution_b: Coefficient of restitution, from 0 (the bodies stay together) to 1 (no
            energy is lost); of body B, 1

    Source: DD17, srs/definitions.md:582.
    """
    return least(restitution_a, restitution_b)


def normal(point_velocity_a: Vector, point_velocity_b: Vector) -> Vector:
    """Unit normal of a contact, from body A to body B (1).

    normal = (point_velocity_a - point_velocity_b)/norm(point_velocity_a - point_velocity_b)

    Args:
        point_velocity_a: Velocity of the point of a body that sits at the end of an arm; of
            body A, m/s
        point_velocity_b: Velocity of the point of a body that sits at the end of an arm; of
            body B, m/s

    Source: GD11, srs/definitions.md:615.
    """
    point_velocity_a_x, point_velocity_a_y = point_velocity_a
    point_velocity_b_x, point_velocity_b_y = point_velocity_b
    return (
        (point_velocity_a_x - point_velocity_b_x)
        / sqrt(
            (point_velocity_a_x - point_velocity_b_x) * (point_velocity_a_x - point_velocity_b_x)
            + (point_velocity_a_y - point_velocity_b_y) * (point_velocity_a_y - point_velocity_b_y)
        ),
        (point_velocity_a_y - point_velocity_b_y)
        / sqrt(
            (point_velocity_a_x - point_velocity_b_x) * (point_velocity_a_x - point_velocity_b_x)
            + (point_velocity_a_y - point_velocity_b_y) * (point_velocity_a_y - point_velocity_b_y)
        ),
    )


def tangent(normal: Vector) -> Vector:
    """Unit tangent of a contact, the normal turned left by a quarter turn (1).

    tangent = perp(normal)

    Args:
        normal: Unit normal of a contact, from body A to body B, 1

    Source: DD22, srs/definitions.md:641.
    """
    normal_x, normal_y = normal
    return (-normal_y, normal_x)


def pair_friction(friction_a: Scalar, friction_b: Scalar) -> Scalar:
    """The coefficient of friction that holds between two bodies (1).

    pair_friction = sqrt(friction_a*friction_b)

    Args:
        friction_a: Coefficient of dry friction: how much of the normal force the surface can
            hold along itself; of body A, 1
        friction_b: Coefficient of dry friction: how much of the normal force the surface can
            hold along itself; of body B, 1

    Source: DD23, srs/definitions.md:656.
    """
    return sqrt(friction_a * friction_b)


def kinetic_energy(
    mass: Scalar, velocity: Vector, inertia: Scalar, angular_velocity: Scalar
) -> Scalar:
    """Energy of motion, turning included (J).

    kinetic_energy = mass*dot(velocity, velocity)/2 + inertia*angular_velocity**2/2

    Args:
        mass: Mass of a body, kg
        velocity: Velocity of the centre of mass, m/s
        inertia: Moment of inertia about the centre of mass, kg*m^2
        angular_velocity: Rate of turning, positive counter-clockwise, rad/s

    Source: DD15, srs/definitions.md:674.
    """
    velocity_x, velocity_y = velocity
    return (
        mass * (velocity_x * velocity_x + velocity_y * velocity_y) / 2
        + inertia * angular_velocity * angular_velocity / 2
    )


def potential_energy(mass: Scalar, gravity: Vector, position: Vector) -> Scalar:
    """Energy of a body in the gravity field, zero at the origin (J).

    potential_energy = -mass*dot(gravity, position)

    Args:
        mass: Mass of a body, kg
        gravity: Gravitational acceleration, the same for all bodies, m/s^2
        position: Position of the centre of mass, m

    Source: DD16, srs/definitions.md:707.
    """
    gravity_x, gravity_y = gravity
    position_x, position_y = position
    return (-mass) * (gravity_x * position_x + gravity_y * position_y)


def energy_loss(restitution: Scalar, impulse: Scalar, normal_velocity: Scalar) -> Scalar:
    """Energy that an impact takes from two bodies (J).

    energy_loss = -(1 - restitution)*impulse*normal_velocity/2

    Args:
        restitution: Coefficient of restitution, from 0 (the bodies stay together) to 1 (no
            energy is lost), 1
        impulse: Size of the impulse of a contact along its normal, N*s
        normal_velocity: Rate at which the contact opens, along the normal; negative when the
            bodies approach, m/s

    Source: DD60, srs/definitions.md:724.
    """
    return (-(1 - restitution)) * impulse * normal_velocity / 2


def unseen_share(confidence: Scalar, worlds: Scalar) -> Scalar:
    """Share of all worlds that may have what no world has shown (1).

    unseen_share = -log(1 - confidence)/worlds*phi1(log(1 - confidence)/worlds)

    Args:
        confidence: Chance with which what is said of all worlds holds, 1
        worlds: Number of worlds that were drawn, 1

    Source: DD115, srs/definitions.md:756.
    """
    return (-log(1 - confidence)) / worlds * phi1(log(1 - confidence) / worlds)


def total_order_most(
    unseen_share: Scalar, quantity_range: Scalar, quantity_variance: Scalar
) -> Scalar:
    """Index of total order that what varies may have, at most (1).

    total_order_most = min(unseen_share*quantity_range**2/(2*quantity_variance), 1)

    Args:
        unseen_share: Share of all worlds that may have what no world has shown, 1
        quantity_range: What a quantity differs by among all worlds, 1
        quantity_variance: Variance of a quantity, 1

    Source: DD115, srs/definitions.md:758.
    """
    return least(unseen_share * quantity_range * quantity_range / (2 * quantity_variance), 1)


def anchor_torque(torque: Scalar, arm: Vector, force: Vector) -> Scalar:
    """Torque of a reaction about the anchor of its joint (N*m).

    anchor_torque = torque - cross(arm, force)

    Args:
        torque: Applied torque about the centre of mass, positive counter-clockwise, N*m
        arm: Lever arm, from the centre of mass to the point where something acts on a body, m
        force: Applied force on a body, without its weight, N

    Source: DD112, srs/models/joints.md:75.
    """
    arm_x, arm_y = arm
    force_x, force_y = force
    return torque - (arm_x * force_y - arm_y * force_x)


def mean_force(impulse_vector: Vector, time_step: Scalar) -> Vector:
    """Mean of a force over a step (N).

    mean_force = impulse_vector/time_step

    Args:
        impulse_vector: Integral of a force over the time in which it acts, N*s
        time_step: Length of one step of a stepped scheme, s

    Source: DD112, srs/models/joints.md:76.
    """
    impulse_vector_x, impulse_vector_y = impulse_vector
    return (impulse_vector_x / time_step, impulse_vector_y / time_step)


def mean_torque(angular_impulse: Scalar, time_step: Scalar) -> Scalar:
    """Mean of a torque over a step (N*m).

    mean_torque = angular_impulse/time_step

    Args:
        angular_impulse: Moment that the impulses on a body have about its centre of mass,
            kg*m^2/s
        time_step: Length of one step of a stepped scheme, s

    Source: DD112, srs/models/joints.md:77.
    """
    return angular_impulse / time_step


def mean_row_force(row_impulse: Scalar, time_step: Scalar) -> Scalar:
    """Mean over a step of the force of a row of a joint (N).

    mean_row_force = row_impulse/time_step

    Args:
        row_impulse: Impulse of a row of a joint, for slopes of length one, N*s
        time_step: Length of one step of a stepped scheme, s

    Source: DD112, srs/models/joints.md:78.
    """
    return row_impulse / time_step


def motor_power(row_force: Scalar, row_rate: Scalar) -> Scalar:
    """Power of a motor (J/s).

    motor_power = row_force*row_rate

    Args:
        row_force: Force of a row of a joint, for slopes of length one, N
        row_rate: Rate of a row's value, or a body's part in it, m/s

    Source: GD22, srs/models/joints.md:413.
    """
    return row_force * row_rate


def joint_spring_force(
    joint_stiffness: Scalar, stretch: Scalar, damping: Scalar, stretch_rate: Scalar
) -> Scalar:
    """Force of a joint's spring and damper, by which its stretch grows (N).

    joint_spring_force = -joint_stiffness*stretch - damping*stretch_rate

    Args:
        joint_stiffness: Force of a joint's spring for each unit of its stretch, N/m
        stretch: How far a joint is beyond the place at which its spring is at rest, m
        damping: Force of a spring's damper for each unit of the extension's rate, kg/s
        stretch_rate: Rate of a joint's stretch, m/s

    Source: DD64, srs/models/joints.md:437.
    """
    return (-joint_stiffness) * stretch - damping * stretch_rate


def joint_spring_energy(joint_stiffness: Scalar, stretch: Scalar) -> Scalar:
    """Energy in a joint's spring that is stretched (J).

    joint_spring_energy = joint_stiffness*stretch**2/2

    Args:
        joint_stiffness: Force of a joint's spring for each unit of its stretch, N/m
        stretch: How far a joint is beyond the place at which its spring is at rest, m

    Source: DD64, srs/models/joints.md:438.
    """
    return joint_stiffness * stretch * stretch / 2


def joint_spring_torque(
    rotary_stiffness: Scalar, twist: Scalar, rotary_damping: Scalar, twist_rate: Scalar
) -> Scalar:
    """Torque of a joint's spring and damper, by which its twist grows (N*m).

    joint_spring_torque = -rotary_stiffness*twist - rotary_damping*twist_rate

    Args:
        rotary_stiffness: Torque of a joint's spring for each unit of its twist, N*m/rad
        twist: How far a joint is turned beyond the angle at which its spring is at rest, rad
        rotary_damping: Torque of a joint's damper for each unit of the twist's rate, N*m*s/rad
        twist_rate: Rate of a joint's twist, rad/s

    Source: DD65, srs/models/joints.md:452.
    """
    return (-rotary_stiffness) * twist - rotary_damping * twist_rate


def rotary_spring_energy(rotary_stiffness: Scalar, twist: Scalar) -> Scalar:
    """Energy in a joint's spring that is twisted (J).

    rotary_spring_energy = rotary_stiffness*twist**2/2

    Args:
        rotary_stiffness: Torque of a joint's spring for each unit of its twist, N*m/rad
        twist: How far a joint is turned beyond the angle at which its spring is at rest, rad

    Source: DD65, srs/models/joints.md:453.
    """
    return rotary_stiffness * twist * twist / 2


def joint_pull(pull_along: Scalar, pull_across: Scalar) -> Scalar:
    """Size of the force of a joint's springs and dampers without their maximum (N).

    joint_pull = sqrt(pull_along**2 + pull_across**2)

    Args:
        pull_along: Force of the first of them without their maximum, N
        pull_across: Force of a target's other one likewise, N

    Source: DD103, srs/models/joints.md:474.
    """
    return sqrt(pull_along * pull_along + pull_across * pull_across)


def force_share(joint_force_most: Scalar, joint_pull: Scalar) -> Scalar:
    """Share of its force that a spring with a maximum exerts (1).

    force_share = joint_force_most/max(joint_pull, joint_force_most)

    Args:
        joint_force_most: Largest force of a motor or a spring, or that a joint bears, N
        joint_pull: Size of the force of a joint's springs and dampers without their maximum, N

    Source: DD103, srs/models/joints.md:475.
    """
    return joint_force_most / largest(joint_pull, joint_force_most)


def torque_share(joint_torque_most: Scalar, joint_twisting: Scalar) -> Scalar:
    """Share of its torque that a spring with a maximum exerts (1).

    torque_share = joint_torque_most/max(joint_twisting, joint_torque_most)

    Args:
        joint_torque_most: Largest torque of a motor or a spring, or that a joint bears, N*m
        joint_twisting: Size of the torque of a joint's spring and damper without its maximum,
            N*m

    Source: DD103, srs/models/joints.md:476.
    """
    return joint_torque_most / largest(joint_twisting, joint_torque_most)


def bounded_spring_energy(force_share: Scalar, joint_spring_energy: Scalar) -> Scalar:
    """Energy in a joint's spring with a maximum that is stretched (J).

    bounded_spring_energy = force_share*(2 - force_share)*joint_spring_energy

    Args:
        force_share: Share of its force that a spring with a maximum exerts, 1
        joint_spring_energy: Energy in a joint's spring that is stretched, J

    Source: DD103, srs/models/joints.md:477.
    """
    return force_share * (2 - force_share) * joint_spring_energy


def bounded_rotary_energy(torque_share: Scalar, rotary_spring_energy: Scalar) -> Scalar:
    """Energy in a joint's spring with a maximum that is twisted (J).

    bounded_rotary_energy = torque_share*(2 - torque_share)*rotary_spring_energy

    Args:
        torque_share: Share of its torque that a spring with a maximum exerts, 1
        rotary_spring_energy: Energy in a joint's spring that is twisted, J

    Source: DD103, srs/models/joints.md:478.
    """
    return torque_share * (2 - torque_share) * rotary_spring_energy


def force_load(reaction_force: Vector, joint_force_most: Scalar) -> Scalar:
    """Force of a reaction, as a share of the largest that the joint bears (1).

    force_load = norm(reaction_force)/joint_force_most

    Args:
        reaction_force: Force by which what holds a body changes its acceleration, N
        joint_force_most: Largest force of a motor or a spring, or that a joint bears, N

    Source: GD23, srs/models/joints.md:509.
    """
    reaction_force_x, reaction_force_y = reaction_force
    return (
        sqrt(reaction_force_x * reaction_force_x + reaction_force_y * reaction_force_y)
        / joint_force_most
    )


def torque_load(anchor_torque: Scalar, joint_torque_most: Scalar) -> Scalar:
    """Torque of a reaction, as a share of the largest that the joint bears (1).

    torque_load = abs(anchor_torque)/joint_torque_most

    Args:
        anchor_torque: Torque of a reaction about the anchor of its joint, N*m
        joint_torque_most: Largest torque of a motor or a spring, or that a joint bears, N*m

    Source: GD23, srs/models/joints.md:510.
    """
    return abs(anchor_torque) / joint_torque_most
