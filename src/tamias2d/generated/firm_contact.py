"""Firm contact: Firm contact; Friction of two contacts of a pair; Mass of a firm row; Balance of
momenta; Energy beside momentum; Energy that a support gives.

Generated from srs/models/firm_contact.md
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.functions import Scalar, Vector, largest, least


def accumulated_impulse_wanted(
    accumulated_impulse: Scalar, row_velocity_after: Scalar, bias_velocity: Scalar, firmness: Scalar
) -> Scalar:
    """Impulse that a contact has given in a substep along its normal; before it is limited (N*s).

    accumulated_impulse_wanted = accumulated_impulse - firmness*(row_velocity_after +
    bias_velocity)

    Args:
        accumulated_impulse: Impulse that a contact has given in a substep along its normal, N*s
        row_velocity_after: Velocity of B's point of contact seen from A's, along the line; just
            after the impact, m/s
        bias_velocity: Velocity with which a row is asked to close, negative to open it, m/s
        firmness: Mass with which a firm contact resists the velocity that its row is not to
            have, kg

    Source: GD12, srs/models/firm_contact.md:34.
    """
    return accumulated_impulse - firmness * (row_velocity_after + bias_velocity)


def tangent_impulse_wanted(
    tangent_impulse: Scalar, row_velocity_after: Scalar, firmness: Scalar
) -> Scalar:
    """Impulse that a contact has given in a substep along its tangent; before it is limited (N*s).

    tangent_impulse_wanted = tangent_impulse - firmness*row_velocity_after

    Args:
        tangent_impulse: Impulse that a contact has given in a substep along its tangent, N*s
        row_velocity_after: Velocity of B's point of contact seen from A's, along the line; just
            after the impact, m/s
        firmness: Mass with which a firm contact resists the velocity that its row is not to
            have, kg

    Source: GD12, srs/models/firm_contact.md:36.
    """
    return tangent_impulse - firmness * row_velocity_after


def normal_impulse_share(
    accumulated_impulse_first: Scalar, accumulated_impulse_both: Scalar
) -> Scalar:
    """Part of the normal impulse of two contacts that is that of the first (1).

    normal_impulse_share = accumulated_impulse_first/accumulated_impulse_both

    Args:
        accumulated_impulse_first: Impulse that a contact has given in a substep along its
            normal; of the first of two contacts, N*s
        accumulated_impulse_both: Impulse that a contact has given in a substep along its
            normal; of two contacts together, N*s

    Source: DD32, srs/models/firm_contact.md:94.
    """
    return accumulated_impulse_first / accumulated_impulse_both


def turning_arm_both(
    turning_arm_first: Scalar, turning_arm_second: Scalar, normal_impulse_share: Scalar
) -> Scalar:
    """Part of an arm across the line, by which an impulse along it turns a body; of two contacts
    together (m).

    turning_arm_both = normal_impulse_share*turning_arm_first + (1 -
    normal_impulse_share)*turning_arm_second

    Args:
        turning_arm_first: Part of an arm across the line, by which an impulse along it turns a
            body; of the first of two contacts, m
        turning_arm_second: Part of an arm across the line, by which an impulse along it turns a
            body; of the second of two contacts, m
        normal_impulse_share: Part of the normal impulse of two contacts that is that of the
            first, 1

    Source: DD32, srs/models/firm_contact.md:95.
    """
    return (
        normal_impulse_share * turning_arm_first + (1 - normal_impulse_share) * turning_arm_second
    )


def row_velocity_both(
    row_velocity_first: Scalar, row_velocity_second: Scalar, normal_impulse_share: Scalar
) -> Scalar:
    """Velocity of B's point of contact seen from A's, along the line; of two contacts together
    (m/s).

    row_velocity_both = normal_impulse_share*row_velocity_first + (1 -
    normal_impulse_share)*row_velocity_second

    Args:
        row_velocity_first: Velocity of B's point of contact seen from A's, along the line; of
            the first of two contacts, m/s
        row_velocity_second: Velocity of B's point of contact seen from A's, along the line; of
            the second of two contacts, m/s
        normal_impulse_share: Part of the normal impulse of two contacts that is that of the
            first, 1

    Source: DD32, srs/models/firm_contact.md:98.
    """
    return (
        normal_impulse_share * row_velocity_first + (1 - normal_impulse_share) * row_velocity_second
    )


def tangent_impulse_most(accumulated_impulse: Scalar, friction: Scalar) -> Scalar:
    """Impulse that a contact has given in a substep along its tangent; the most that there may be
    (N*s).

    tangent_impulse_most = friction*accumulated_impulse

    Args:
        accumulated_impulse: Impulse that a contact has given in a substep along its normal, N*s
        friction: Coefficient of dry friction: how much of the normal force the surface can hold
            along itself, 1

    Source: DD32, srs/models/firm_contact.md:101.
    """
    return friction * accumulated_impulse


def limited_tangent_impulse(tangent_impulse_wanted: Scalar, tangent_impulse_most: Scalar) -> Scalar:
    """Tangent impulse after an iteration, held within what friction can give (N*s).

    limited_tangent_impulse = max(min(tangent_impulse_wanted, tangent_impulse_most),
    -tangent_impulse_most)

    Args:
        tangent_impulse_wanted: Impulse that a contact has given in a substep along its tangent;
            before it is limited, N*s
        tangent_impulse_most: Impulse that a contact has given in a substep along its tangent;
            the most that there may be, N*s

    Source: DD32, srs/models/firm_contact.md:102.
    """
    return largest(least(tangent_impulse_wanted, tangent_impulse_most), -tangent_impulse_most)


def firm_mass_x(line: Vector, firmness: Scalar) -> Vector:
    """Momentum along the x axis that a firm row takes, for one unit of velocity of a body along
    each axis (kg).

    firm_mass_x = firmness*x(line)*line

    Args:
        line: Unit vector along which a row of a contact acts, its normal or tangent, 1
        firmness: Mass with which a firm contact resists the velocity that its row is not to
            have, kg

    Source: DD33, srs/models/firm_contact.md:183.
    """
    line_x, line_y = line
    return (firmness * line_x * line_x, firmness * line_x * line_y)


def firm_mass_y(line: Vector, firmness: Scalar) -> Vector:
    """Momentum along the y axis that a firm row takes, for one unit of velocity of a body along
    each axis (kg).

    firm_mass_y = firmness*y(line)*line

    Args:
        line: Unit vector along which a row of a contact acts, its normal or tangent, 1
        firmness: Mass with which a firm contact resists the velocity that its row is not to
            have, kg

    Source: DD33, srs/models/firm_contact.md:184.
    """
    line_x, line_y = line
    return (firmness * line_y * line_x, firmness * line_y * line_y)


def firm_moment(line: Vector, turning_arm_a: Scalar, firmness: Scalar) -> Vector:
    """Momentum that a firm row takes, for one unit of angular velocity of a body (kg*m).

    firm_moment = firmness*line*turning_arm_a

    Args:
        line: Unit vector along which a row of a contact acts, its normal or tangent, 1
        turning_arm_a: Part of an arm across the line, by which an impulse along it turns a
            body; of body A, m
        firmness: Mass with which a firm contact resists the velocity that its row is not to
            have, kg

    Source: DD33, srs/models/firm_contact.md:185.
    """
    line_x, line_y = line
    return (firmness * line_x * turning_arm_a, firmness * line_y * turning_arm_a)


def firm_lever(line: Vector, turning_arm_b: Scalar, firmness: Scalar) -> Vector:
    """Angular momentum that a firm row takes, for one unit of velocity of a body along each axis
    (kg*m).

    firm_lever = firmness*turning_arm_b*line

    Args:
        line: Unit vector along which a row of a contact acts, its normal or tangent, 1
        turning_arm_b: Part of an arm across the line, by which an impulse along it turns a
            body; of body B, m
        firmness: Mass with which a firm contact resists the velocity that its row is not to
            have, kg

    Source: DD33, srs/models/firm_contact.md:186.
    """
    line_x, line_y = line
    return (firmness * turning_arm_b * line_x, firmness * turning_arm_b * line_y)


def firm_inertia(turning_arm_a: Scalar, turning_arm_b: Scalar, firmness: Scalar) -> Scalar:
    """Angular momentum that a firm row takes, for one unit of angular velocity of a body (kg*m^2).

    firm_inertia = firmness*turning_arm_b*turning_arm_a

    Args:
        turning_arm_a: Part of an arm across the line, by which an impulse along it turns a
            body; of body A, m
        turning_arm_b: Part of an arm across the line, by which an impulse along it turns a
            body; of body B, m
        firmness: Mass with which a firm contact resists the velocity that its row is not to
            have, kg

    Source: DD33, srs/models/firm_contact.md:187.
    """
    return firmness * turning_arm_b * turning_arm_a


def momentum_left(mass: Scalar, velocity_start: Vector, velocity: Vector) -> Vector:
    """Mass times velocity; what is left, to be made up for (kg*m/s).

    momentum_left = mass*(velocity_start - velocity)

    Args:
        mass: Mass of a body, kg
        velocity_start: Velocity of the centre of mass; at the start, m/s
        velocity: Velocity of the centre of mass, m/s

    Source: DD34, srs/models/firm_contact.md:238.
    """
    velocity_start_x, velocity_start_y = velocity_start
    velocity_x, velocity_y = velocity
    return (mass * (velocity_start_x - velocity_x), mass * (velocity_start_y - velocity_y))


def angular_momentum_left(
    inertia: Scalar, angular_velocity_start: Scalar, angular_velocity: Scalar
) -> Scalar:
    """Moment of momentum about the origin; what is left, to be made up for (kg*m^2/s).

    angular_momentum_left = inertia*(angular_velocity_start - angular_velocity)

    Args:
        inertia: Moment of inertia about the centre of mass, kg*m^2
        angular_velocity_start: Rate of turning, positive counter-clockwise; at the start, rad/s
        angular_velocity: Rate of turning, positive counter-clockwise, rad/s

    Source: DD34, srs/models/firm_contact.md:239.
    """
    return inertia * (angular_velocity_start - angular_velocity)


def momentum_a_after(momentum_a: Vector, applied_impulse: Scalar, line: Vector) -> Vector:
    """Mass times velocity; of body A; just after the impact (kg*m/s).

    momentum_a_after = momentum_a - applied_impulse*line

    Args:
        momentum_a: Mass times velocity; of body A, kg*m/s
        applied_impulse: Impulse that a row gives in one iteration, to B along the line, N*s
        line: Unit vector along which a row of a contact acts, its normal or tangent, 1

    Source: DD34, srs/models/firm_contact.md:240.
    """
    momentum_a_x, momentum_a_y = momentum_a
    line_x, line_y = line
    return (momentum_a_x - applied_impulse * line_x, momentum_a_y - applied_impulse * line_y)


def angular_momentum_a_after(
    angular_momentum_a: Scalar, applied_impulse: Scalar, turning_arm_a: Scalar
) -> Scalar:
    """Moment of momentum about the origin; of body A; just after the impact (kg*m^2/s).

    angular_momentum_a_after = angular_momentum_a - applied_impulse*turning_arm_a

    Args:
        angular_momentum_a: Moment of momentum about the origin; of body A, kg*m^2/s
        applied_impulse: Impulse that a row gives in one iteration, to B along the line, N*s
        turning_arm_a: Part of an arm across the line, by which an impulse along it turns a
            body; of body A, m

    Source: DD34, srs/models/firm_contact.md:241.
    """
    return angular_momentum_a - applied_impulse * turning_arm_a


def momentum_b_after(momentum_b: Vector, applied_impulse: Scalar, line: Vector) -> Vector:
    """Mass times velocity; of body B; just after the impact (kg*m/s).

    momentum_b_after = momentum_b + applied_impulse*line

    Args:
        momentum_b: Mass times velocity; of body B, kg*m/s
        applied_impulse: Impulse that a row gives in one iteration, to B along the line, N*s
        line: Unit vector along which a row of a contact acts, its normal or tangent, 1

    Source: DD34, srs/models/firm_contact.md:242.
    """
    momentum_b_x, momentum_b_y = momentum_b
    line_x, line_y = line
    return (momentum_b_x + applied_impulse * line_x, momentum_b_y + applied_impulse * line_y)


def angular_momentum_b_after(
    angular_momentum_b: Scalar, applied_impulse: Scalar, turning_arm_b: Scalar
) -> Scalar:
    """Moment of momentum about the origin; of body B; just after the impact (kg*m^2/s).

    angular_momentum_b_after = angular_momentum_b + applied_impulse*turning_arm_b

    Args:
        angular_momentum_b: Moment of momentum about the origin; of body B, kg*m^2/s
        applied_impulse: Impulse that a row gives in one iteration, to B along the line, N*s
        turning_arm_b: Part of an arm across the line, by which an impulse along it turns a
            body; of body B, m

    Source: DD34, srs/models/firm_contact.md:243.
    """
    return angular_momentum_b + applied_impulse * turning_arm_b


def linear_energy(mass: Scalar, velocity: Vector) -> Scalar:
    """Kinetic energy of the path of the centre of mass (J).

    linear_energy = mass*dot(velocity, velocity)/2

    Args:
        mass: Mass of a body, kg
        velocity: Velocity of the centre of mass, m/s

    Source: DD35, srs/models/firm_contact.md:266.
    """
    velocity_x, velocity_y = velocity
    return mass * (velocity_x * velocity_x + velocity_y * velocity_y) / 2


def turning_energy(inertia: Scalar, angular_velocity: Scalar) -> Scalar:
    """Kinetic energy of turning (J).

    turning_energy = inertia*angular_velocity**2/2

    Args:
        inertia: Moment of inertia about the centre of mass, kg*m^2
        angular_velocity: Rate of turning, positive counter-clockwise, rad/s

    Source: DD35, srs/models/firm_contact.md:267.
    """
    return inertia * angular_velocity * angular_velocity / 2


def linear_energy_start(momentum: Vector, mass: Scalar) -> Scalar:
    """Kinetic energy of the path of the centre of mass; at the start (J).

    linear_energy_start = dot(momentum, momentum)/(2*mass)

    Args:
        momentum: Mass times velocity, kg*m/s
        mass: Mass of a body, kg

    Source: DD35, srs/models/firm_contact.md:268.
    """
    momentum_x, momentum_y = momentum
    return (momentum_x * momentum_x + momentum_y * momentum_y) / (2 * mass)


def turning_energy_start(angular_momentum: Scalar, inertia: Scalar) -> Scalar:
    """Kinetic energy of turning; at the start (J).

    turning_energy_start = angular_momentum**2/(2*inertia)

    Args:
        angular_momentum: Moment of momentum about the origin, kg*m^2/s
        inertia: Moment of inertia about the centre of mass, kg*m^2

    Source: DD35, srs/models/firm_contact.md:269.
    """
    return angular_momentum * angular_momentum / (2 * inertia)


def bias_energy(mass: Scalar, bias_velocity: Scalar) -> Scalar:
    """Kinetic energy that comes with a velocity which removes overlap (J).

    bias_energy = mass*bias_velocity**2/2

    Args:
        mass: Mass of a body, kg
        bias_velocity: Velocity with which a row is asked to close, negative to open it, m/s

    Source: DD35, srs/models/firm_contact.md:270.
    """
    return mass * bias_velocity * bias_velocity / 2


def support_energy(
    accumulated_impulse: Scalar, tangent_impulse: Scalar, support_rate: Scalar, support_slip: Scalar
) -> Scalar:
    """Energy that a support gives by the impulses of a contact (J).

    support_energy = -(accumulated_impulse*support_rate + tangent_impulse*support_slip)

    Args:
        accumulated_impulse: Impulse that a contact has given in a substep along its normal, N*s
        tangent_impulse: Impulse that a contact has given in a substep along its tangent, N*s
        support_rate: Normal velocity of a contact by the motion of its support alone, m/s
        support_slip: Tangential velocity of a contact by the motion of its support alone, m/s

    Source: DD104, srs/models/firm_contact.md:305.
    """
    return -(accumulated_impulse * support_rate + tangent_impulse * support_slip)
