"""Soft contact: Row of a contact; Kick along a row; Soft contact; Overlap at rest; Preload of a
contact; Extent of what is thin; Fall of the other end; Firmness that feeds no wave; Frequency
under a load; Shift through a substep; Separation of a contact that moves; What is left of a
gap; Slowest impact; Velocity of an impact; Slip on surfaces that run; Soft step of a contact.

Generated from srs/models/soft_contact.md
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.functions import Scalar, Vector, largest, least, sqrt


def turning_arm(arm: Vector, line: Vector) -> Scalar:
    """Part of an arm across the line, by which an impulse along it turns a body (m).

    turning_arm = cross(arm, line)

    Args:
        arm: Lever arm, from the centre of mass to the point where something acts on a body, m
        line: Unit vector along which a row of a contact acts, its normal or tangent, 1

    Source: DD26, srs/models/soft_contact.md:28.
    """
    arm_x, arm_y = arm
    line_x, line_y = line
    return arm_x * line_y - arm_y * line_x


def row_velocity(
    velocity_a: Vector,
    angular_velocity_a: Scalar,
    turning_arm_a: Scalar,
    velocity_b: Vector,
    angular_velocity_b: Scalar,
    turning_arm_b: Scalar,
    line: Vector,
) -> Scalar:
    """Velocity of B's point of contact seen from A's, along the line (m/s).

    row_velocity = dot(velocity_b - velocity_a, line) + angular_velocity_b*turning_arm_b -
    angular_velocity_a*turning_arm_a

    Args:
        velocity_a: Velocity of the centre of mass; of body A, m/s
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        turning_arm_a: Part of an arm across the line, by which an impulse along it turns a
            body; of body A, m
        velocity_b: Velocity of the centre of mass; of body B, m/s
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s
        turning_arm_b: Part of an arm across the line, by which an impulse along it turns a
            body; of body B, m
        line: Unit vector along which a row of a contact acts, its normal or tangent, 1

    Source: DD26, srs/models/soft_contact.md:29.
    """
    velocity_a_x, velocity_a_y = velocity_a
    velocity_b_x, velocity_b_y = velocity_b
    line_x, line_y = line
    return (
        (velocity_b_x - velocity_a_x) * line_x
        + (velocity_b_y - velocity_a_y) * line_y
        + angular_velocity_b * turning_arm_b
        - angular_velocity_a * turning_arm_a
    )


def row_mass(
    inverse_mass_a: Scalar,
    inverse_inertia_a: Scalar,
    turning_arm_a: Scalar,
    inverse_mass_b: Scalar,
    inverse_inertia_b: Scalar,
    turning_arm_b: Scalar,
) -> Scalar:
    """Impulse along the line for one unit of change of the row's velocity (kg).

    row_mass = 1/(inverse_mass_a + inverse_inertia_a*turning_arm_a**2 + inverse_mass_b +
    inverse_inertia_b*turning_arm_b**2)

    Args:
        inverse_mass_a: One over the mass, zero for a static body; of body A, 1/kg
        inverse_inertia_a: One over the inertia, zero for a body that cannot turn; of body A,
            1/(kg*m^2)
        turning_arm_a: Part of an arm across the line, by which an impulse along it turns a
            body; of body A, m
        inverse_mass_b: One over the mass, zero for a static body; of body B, 1/kg
        inverse_inertia_b: One over the inertia, zero for a body that cannot turn; of body B,
            1/(kg*m^2)
        turning_arm_b: Part of an arm across the line, by which an impulse along it turns a
            body; of body B, m

    Source: DD26, srs/models/soft_contact.md:32.
    """
    return 1 / (
        inverse_mass_a
        + inverse_inertia_a * turning_arm_a * turning_arm_a
        + inverse_mass_b
        + inverse_inertia_b * turning_arm_b * turning_arm_b
    )


def velocity_a_after(
    velocity_a: Vector, applied_impulse: Scalar, line: Vector, inverse_mass_a: Scalar
) -> Vector:
    """Velocity of the centre of mass; of body A; just after the impact (m/s).

    velocity_a_after = velocity_a - applied_impulse*inverse_mass_a*line

    Args:
        velocity_a: Velocity of the centre of mass; of body A, m/s
        applied_impulse: Impulse that a row gives in one iteration, to B along the line, N*s
        line: Unit vector along which a row of a contact acts, its normal or tangent, 1
        inverse_mass_a: One over the mass, zero for a static body; of body A, 1/kg

    Source: DD27, srs/models/soft_contact.md:100.
    """
    velocity_a_x, velocity_a_y = velocity_a
    line_x, line_y = line
    return (
        velocity_a_x - applied_impulse * inverse_mass_a * line_x,
        velocity_a_y - applied_impulse * inverse_mass_a * line_y,
    )


def angular_velocity_a_after(
    angular_velocity_a: Scalar,
    applied_impulse: Scalar,
    turning_arm_a: Scalar,
    inverse_inertia_a: Scalar,
) -> Scalar:
    """Rate of turning, positive counter-clockwise; of body A; just after the impact (rad/s).

    angular_velocity_a_after = angular_velocity_a -
    applied_impulse*inverse_inertia_a*turning_arm_a

    Args:
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        applied_impulse: Impulse that a row gives in one iteration, to B along the line, N*s
        turning_arm_a: Part of an arm across the line, by which an impulse along it turns a
            body; of body A, m
        inverse_inertia_a: One over the inertia, zero for a body that cannot turn; of body A,
            1/(kg*m^2)

    Source: DD27, srs/models/soft_contact.md:101.
    """
    return angular_velocity_a - applied_impulse * inverse_inertia_a * turning_arm_a


def velocity_b_after(
    velocity_b: Vector, applied_impulse: Scalar, line: Vector, inverse_mass_b: Scalar
) -> Vector:
    """Velocity of the centre of mass; of body B; just after the impact (m/s).

    velocity_b_after = velocity_b + applied_impulse*inverse_mass_b*line

    Args:
        velocity_b: Velocity of the centre of mass; of body B, m/s
        applied_impulse: Impulse that a row gives in one iteration, to B along the line, N*s
        line: Unit vector along which a row of a contact acts, its normal or tangent, 1
        inverse_mass_b: One over the mass, zero for a static body; of body B, 1/kg

    Source: DD27, srs/models/soft_contact.md:103.
    """
    velocity_b_x, velocity_b_y = velocity_b
    line_x, line_y = line
    return (
        velocity_b_x + applied_impulse * inverse_mass_b * line_x,
        velocity_b_y + applied_impulse * inverse_mass_b * line_y,
    )


def angular_velocity_b_after(
    angular_velocity_b: Scalar,
    applied_impulse: Scalar,
    turning_arm_b: Scalar,
    inverse_inertia_b: Scalar,
) -> Scalar:
    """Rate of turning, positive counter-clockwise; of body B; just after the impact (rad/s).

    angular_velocity_b_after = angular_velocity_b +
    applied_impulse*inverse_inertia_b*turning_arm_b

    Args:
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s
        applied_impulse: Impulse that a row gives in one iteration, to B along the line, N*s
        turning_arm_b: Part of an arm across the line, by which an impulse along it turns a
            body; of body B, m
        inverse_inertia_b: One over the inertia, zero for a body that cannot turn; of body B,
            1/(kg*m^2)

    Source: DD27, srs/models/soft_contact.md:104.
    """
    return angular_velocity_b + applied_impulse * inverse_inertia_b * turning_arm_b


def bias_rate(angular_frequency: Scalar, damping_ratio: Scalar, time_step: Scalar) -> Scalar:
    """Share of an overlap that a soft contact removes per unit of time (1/s).

    bias_rate = angular_frequency/(2*damping_ratio + time_step*angular_frequency)

    Args:
        angular_frequency: Phase that an oscillation gains per unit of time, rad/s
        damping_ratio: Damping over that at which an oscillation just ends, 1 where it does, 1
        time_step: Length of one step of a stepped scheme, s

    Source: GD9, srs/models/soft_contact.md:197.
    """
    return angular_frequency / (2 * damping_ratio + time_step * angular_frequency)


def mass_share(angular_frequency: Scalar, damping_ratio: Scalar, time_step: Scalar) -> Scalar:
    """Part of a row's mass that a soft contact acts with (1).

    mass_share = time_step*angular_frequency*(2*damping_ratio +
    time_step*angular_frequency)/(1 + time_step*angular_frequency*(2*damping_ratio +
    time_step*angular_frequency))

    Args:
        angular_frequency: Phase that an oscillation gains per unit of time, rad/s
        damping_ratio: Damping over that at which an oscillation just ends, 1 where it does, 1
        time_step: Length of one step of a stepped scheme, s

    Source: GD9, srs/models/soft_contact.md:199.
    """
    return (
        time_step
        * angular_frequency
        * (2 * damping_ratio + time_step * angular_frequency)
        / (1 + time_step * angular_frequency * (2 * damping_ratio + time_step * angular_frequency))
    )


def impulse_share(angular_frequency: Scalar, damping_ratio: Scalar, time_step: Scalar) -> Scalar:
    """Part of its impulse that a soft contact gives back in an iteration (1).

    impulse_share = 1/(1 + time_step*angular_frequency*(2*damping_ratio +
    time_step*angular_frequency))

    Args:
        angular_frequency: Phase that an oscillation gains per unit of time, rad/s
        damping_ratio: Damping over that at which an oscillation just ends, 1 where it does, 1
        time_step: Length of one step of a stepped scheme, s

    Source: GD9, srs/models/soft_contact.md:203.
    """
    return 1 / (
        1 + time_step * angular_frequency * (2 * damping_ratio + time_step * angular_frequency)
    )


def separation_rest(
    accumulated_impulse: Scalar, row_mass: Scalar, angular_frequency: Scalar, time_step: Scalar
) -> Scalar:
    """Distance between two bodies, negative where they overlap; at rest (m).

    separation_rest = -accumulated_impulse/(time_step*row_mass*angular_frequency**2)

    Args:
        accumulated_impulse: Impulse that a contact has given in a substep along its normal, N*s
        row_mass: Impulse along the line for one unit of change of the row's velocity, kg
        angular_frequency: Phase that an oscillation gains per unit of time, rad/s
        time_step: Length of one step of a stepped scheme, s

    Source: DD28, srs/models/soft_contact.md:308.
    """
    return (-accumulated_impulse) / (time_step * row_mass * angular_frequency * angular_frequency)


def preload_later(
    preload: Scalar,
    separation: Scalar,
    preload_share: Scalar,
    gap_share: Scalar,
    overlap_allowed: Scalar,
    preload_largest: Scalar,
) -> Scalar:
    """Preload after a step (m).

    preload_later = min(max(preload - gap_share*max(separation, 0) -
    preload_share*min(separation + overlap_allowed, 0), 0), preload_largest)

    Args:
        preload: Overlap at which a spring without preload would give as much, m
        separation: Distance between two bodies, negative where they overlap, m
        preload_share: Part of a step's overlap by which the preload grows, 1
        gap_share: Part of a step's gap by which the preload shrinks, 1
        overlap_allowed: Overlap that no preload is learned for, m
        preload_largest: What a preload may grow to, m

    Source: DD39, srs/models/soft_contact.md:369.
    """
    return least(
        largest(
            preload
            - gap_share * largest(separation, 0)
            - preload_share * least(separation + overlap_allowed, 0),
            0,
        ),
        preload_largest,
    )


def extent_thin(
    extent: Scalar, half_width: Scalar, width_multiple: Scalar, thinnest_share: Scalar
) -> Scalar:
    """Extent of a pair in which a body may be thin (m).

    extent_thin = min(extent, max(width_multiple*half_width, thinnest_share*extent))

    Args:
        extent: How far a body reaches from its centre of mass; of two bodies, the smaller one
            does, m
        half_width: Half of a body's least width, m
        width_multiple: How many half widths an extent counts at most, 1
        thinnest_share: Part of its extent that a body counts at least, however thin it is, 1

    Source: DD77, srs/models/soft_contact.md:432.
    """
    return least(extent, largest(width_multiple * half_width, thinnest_share * extent))


def corner_fall(gravity: Vector, time_step: Scalar) -> Scalar:
    """How far the other end of a body falls in a step that stands on one corner (m).

    corner_fall = 2*norm(gravity)*time_step**2

    Args:
        gravity: Gravitational acceleration, the same for all bodies, m/s^2
        time_step: Length of one step of a stepped scheme, s

    Source: DD72, srs/models/soft_contact.md:456.
    """
    gravity_x, gravity_y = gravity
    return 2 * sqrt(gravity_x * gravity_x + gravity_y * gravity_y) * time_step * time_step


def angular_frequency_even(time_step: Scalar) -> Scalar:
    """Phase that an oscillation gains per unit of time; at which a contact is as firm at rest as
    in a fast motion (rad/s).

    angular_frequency_even = 1/time_step

    Args:
        time_step: Length of one step of a stepped scheme, s

    Source: DD76, srs/models/soft_contact.md:484.
    """
    return 1 / time_step


def angular_frequency_loaded(
    angular_frequency: Scalar,
    accumulated_impulse: Scalar,
    inverse_mass_a: Scalar,
    inverse_mass_b: Scalar,
    time_step: Scalar,
    overlap_share: Scalar,
    extent: Scalar,
    firmest: Scalar,
) -> Scalar:
    """Phase that an oscillation gains per unit of time; under a load (rad/s).

    angular_frequency_loaded = max(angular_frequency, min(angular_frequency_wanted,
    firmest*angular_frequency))
        where angular_frequency_wanted = sqrt(accumulated_impulse*(inverse_mass_a + inverse_mass_b)/(time_step*overlap_share*extent))

    Args:
        angular_frequency: Phase that an oscillation gains per unit of time, rad/s
        accumulated_impulse: Impulse that a contact has given in a substep along its normal, N*s
        inverse_mass_a: One over the mass, zero for a static body; of body A, 1/kg
        inverse_mass_b: One over the mass, zero for a static body; of body B, 1/kg
        time_step: Length of one step of a stepped scheme, s
        overlap_share: Overlap with which a loaded contact should rest, as a part of the smaller
            body's extent, 1
        extent: How far a body reaches from its centre of mass; of two bodies, the smaller one
            does, m
        firmest: Frequency of a contact under a load, at most, over that without one, 1

    Source: DD42, srs/models/soft_contact.md:522.
    """
    angular_frequency_wanted = sqrt(
        accumulated_impulse
        * (inverse_mass_a + inverse_mass_b)
        / (time_step * overlap_share * extent)
    )
    return largest(angular_frequency, least(angular_frequency_wanted, firmest * angular_frequency))


def shift_later(shift: Vector, velocity: Vector, time_step: Scalar) -> Vector:
    """How far the centre of mass has moved since the step began; after the bodies have moved (m).

    shift_later = shift + time_step*velocity

    Args:
        shift: How far the centre of mass has moved since the step began, m
        velocity: Velocity of the centre of mass, m/s
        time_step: Length of one step of a stepped scheme, s

    Source: DD43, srs/models/soft_contact.md:574.
    """
    shift_x, shift_y = shift
    velocity_x, velocity_y = velocity
    return (shift_x + time_step * velocity_x, shift_y + time_step * velocity_y)


def turn_later(turn: Scalar, angular_velocity: Scalar, time_step: Scalar) -> Scalar:
    """How far a body has turned since the step began; after the bodies have moved (rad).

    turn_later = turn + time_step*angular_velocity

    Args:
        turn: How far a body has turned since the step began, rad
        angular_velocity: Rate of turning, positive counter-clockwise, rad/s
        time_step: Length of one step of a stepped scheme, s

    Source: DD43, srs/models/soft_contact.md:575.
    """
    return turn + time_step * angular_velocity


def bend(arm: Vector, line: Vector) -> Scalar:
    """Part of an arm along the line, as far as it turns with its body (m).

    bend = dot(arm, line)

    Args:
        arm: Lever arm, from the centre of mass to the point where something acts on a body, m
        line: Unit vector along which a row of a contact acts, its normal or tangent, 1

    Source: DD29, srs/models/soft_contact.md:598.
    """
    arm_x, arm_y = arm
    line_x, line_y = line
    return arm_x * line_x + arm_y * line_y


def separation_later(
    separation: Scalar,
    shift_a: Vector,
    turn_a: Scalar,
    turning_arm_a: Scalar,
    bend_a: Scalar,
    shift_b: Vector,
    turn_b: Scalar,
    turning_arm_b: Scalar,
    bend_b: Scalar,
    line: Vector,
) -> Scalar:
    """Distance between two bodies, negative where they overlap; after the bodies have moved (m).

    separation_later = separation + dot(shift_b - shift_a, line) + turn_b*turning_arm_b -
    turn_a*turning_arm_a - (turn_b**2*bend_b - turn_a**2*bend_a)/2

    Args:
        separation: Distance between two bodies, negative where they overlap, m
        shift_a: How far the centre of mass has moved since the step began; of body A, m
        turn_a: How far a body has turned since the step began; of body A, rad
        turning_arm_a: Part of an arm across the line, by which an impulse along it turns a
            body; of body A, m
        bend_a: Part of an arm along the line, as far as it turns with its body; of body A, m
        shift_b: How far the centre of mass has moved since the step began; of body B, m
        turn_b: How far a body has turned since the step began; of body B, rad
        turning_arm_b: Part of an arm across the line, by which an impulse along it turns a
            body; of body B, m
        bend_b: Part of an arm along the line, as far as it turns with its body; of body B, m
        line: Unit vector along which a row of a contact acts, its normal or tangent, 1

    Source: DD29, srs/models/soft_contact.md:599.
    """
    shift_a_x, shift_a_y = shift_a
    shift_b_x, shift_b_y = shift_b
    line_x, line_y = line
    return (
        separation
        + (shift_b_x - shift_a_x) * line_x
        + (shift_b_y - shift_a_y) * line_y
        + turn_b * turning_arm_b
        - turn_a * turning_arm_a
        - (turn_b * turn_b * bend_b - turn_a * turn_a * bend_a) / 2
    )


def bias_velocity_later(separation: Scalar, row_velocity: Scalar, time_step: Scalar) -> Scalar:
    """Velocity with which a row is asked to close, negative to open it; after the bodies have
    moved (m/s).

    bias_velocity_later = max(separation/time_step + row_velocity, 0)

    Args:
        separation: Distance between two bodies, negative where they overlap, m
        row_velocity: Velocity of B's point of contact seen from A's, along the line, m/s
        time_step: Length of one step of a stepped scheme, s

    Source: DD31, srs/models/soft_contact.md:667.
    """
    return largest(separation / time_step + row_velocity, 0)


def separation(bias_velocity_later: Scalar, row_velocity: Scalar, time_step: Scalar) -> Scalar:
    """Distance between two bodies, negative where they overlap (m).

    separation = time_step*(bias_velocity_later - row_velocity)

    Args:
        bias_velocity_later: Velocity with which a row is asked to close, negative to open it;
            after the bodies have moved, m/s
        row_velocity: Velocity of B's point of contact seen from A's, along the line, m/s
        time_step: Length of one step of a stepped scheme, s

    Source: DD31, srs/models/soft_contact.md:668.
    """
    return time_step * (bias_velocity_later - row_velocity)


def slowest_impact(
    gravity: Vector,
    accumulated_impulse: Scalar,
    row_mass: Scalar,
    substeps: Scalar,
    time_step: Scalar,
) -> Scalar:
    """Velocity of an approach up to which a contact does not rebound (m/s).

    slowest_impact = 2*max(time_step*sqrt(dot(gravity, gravity)),
    substeps*accumulated_impulse/row_mass)

    Args:
        gravity: Gravitational acceleration, the same for all bodies, m/s^2
        accumulated_impulse: Impulse that a contact has given in a substep along its normal, N*s
        row_mass: Impulse along the line for one unit of change of the row's velocity, kg
        substeps: Number of the substeps of a step, 1
        time_step: Length of one step of a stepped scheme, s

    Source: DD93, srs/models/soft_contact.md:713.
    """
    gravity_x, gravity_y = gravity
    return 2 * largest(
        time_step * sqrt(gravity_x * gravity_x + gravity_y * gravity_y),
        substeps * accumulated_impulse / row_mass,
    )


def row_acceleration(
    row_velocity: Scalar, row_velocity_driven: Scalar, time_step: Scalar
) -> Scalar:
    """Acceleration of a row by forces (m/s^2).

    row_acceleration = (row_velocity_driven - row_velocity)/time_step

    Args:
        row_velocity: Velocity of B's point of contact seen from A's, along the line, m/s
        row_velocity_driven: Velocity of a row after a substep in which forces act and contacts
            do not, m/s
        time_step: Length of one step of a stepped scheme, s

    Source: DD102, srs/models/soft_contact.md:750.
    """
    return (row_velocity_driven - row_velocity) / time_step


def impact_velocity(row_velocity: Scalar, row_acceleration: Scalar, separation: Scalar) -> Scalar:
    """Velocity along the normal with which a gap closes (m/s).

    impact_velocity = -sqrt(max(row_velocity**2 - 2*row_acceleration*max(separation, 0[m]),
    0[m^2/s^2]))

    Args:
        row_velocity: Velocity of B's point of contact seen from A's, along the line, m/s
        row_acceleration: Acceleration of a row by forces, m/s^2
        separation: Distance between two bodies, negative where they overlap, m

    Source: DD102, srs/models/soft_contact.md:751.
    """
    return -sqrt(
        largest(row_velocity * row_velocity - 2 * row_acceleration * largest(separation, 0.0), 0.0)
    )


def surface_speed_both(surface_speed_a: Scalar, surface_speed_b: Scalar) -> Scalar:
    """Speed at which the surfaces of two bodies run along the tangent of their contact, in sum
    (m/s).

    surface_speed_both = surface_speed_a + surface_speed_b

    Args:
        surface_speed_a: Speed at which the surface of a body runs along itself, counter-
            clockwise around the body; of body A, m/s
        surface_speed_b: Speed at which the surface of a body runs along itself, counter-
            clockwise around the body; of body B, m/s

    Source: DD97, srs/models/soft_contact.md:788.
    """
    return surface_speed_a + surface_speed_b


def surface_slip(tangential_velocity: Scalar, surface_speed_both: Scalar) -> Scalar:
    """Velocity of B's surface seen from A's at a contact, along the tangent (m/s).

    surface_slip = tangential_velocity - surface_speed_both

    Args:
        tangential_velocity: Velocity of B's point of contact seen from A's, along the tangent;
            zero where the contact does not slide, m/s
        surface_speed_both: Speed at which the surfaces of two bodies run along the tangent of
            their contact, in sum, m/s

    Source: DD97, srs/models/soft_contact.md:789.
    """
    return tangential_velocity - surface_speed_both


def bias_velocity_least(removal_share: Scalar, extent: Scalar, time_step: Scalar) -> Scalar:
    """Velocity with which a row is asked to close, negative to open it; the least that there can
    be (m/s).

    bias_velocity_least = -removal_share*extent/time_step

    Args:
        removal_share: How far an overlap is removed in a substep at most, as a part of the
            smaller body's extent, 1
        extent: How far a body reaches from its centre of mass; of two bodies, the smaller one
            does, m
        time_step: Length of one step of a stepped scheme, s

    Source: IM10, srs/models/soft_contact.md:831.
    """
    return (-removal_share) * extent / time_step


def bias_velocity(
    separation: Scalar, bias_rate: Scalar, bias_velocity_least: Scalar, time_step: Scalar
) -> Scalar:
    """Velocity with which a row is asked to close, negative to open it (m/s).

    bias_velocity = max(max(separation, 0)/time_step + bias_rate*min(separation, 0),
    bias_velocity_least)

    Args:
        separation: Distance between two bodies, negative where they overlap, m
        bias_rate: Share of an overlap that a soft contact removes per unit of time, 1/s
        bias_velocity_least: Velocity with which a row is asked to close, negative to open it;
            the least that there can be, m/s
        time_step: Length of one step of a stepped scheme, s

    Source: IM10, srs/models/soft_contact.md:832.
    """
    return largest(
        largest(separation, 0) / time_step + bias_rate * least(separation, 0), bias_velocity_least
    )


def soft_normal_impulse(
    accumulated_impulse: Scalar,
    row_velocity: Scalar,
    bias_velocity: Scalar,
    row_mass: Scalar,
    mass_share: Scalar,
    impulse_share: Scalar,
) -> Scalar:
    """Accumulated impulse after an iteration of a soft contact (N*s).

    soft_normal_impulse = max(accumulated_impulse - row_mass*mass_share*(row_velocity +
    bias_velocity) - impulse_share*accumulated_impulse, 0)

    Args:
        accumulated_impulse: Impulse that a contact has given in a substep along its normal, N*s
        row_velocity: Velocity of B's point of contact seen from A's, along the line, m/s
        bias_velocity: Velocity with which a row is asked to close, negative to open it, m/s
        row_mass: Impulse along the line for one unit of change of the row's velocity, kg
        mass_share: Part of a row's mass that a soft contact acts with, 1
        impulse_share: Part of its impulse that a soft contact gives back in an iteration, 1

    Source: IM10, srs/models/soft_contact.md:835.
    """
    return largest(
        accumulated_impulse
        - row_mass * mass_share * (row_velocity + bias_velocity)
        - impulse_share * accumulated_impulse,
        0,
    )


def limited_tangent_impulse(
    tangent_impulse: Scalar,
    row_velocity: Scalar,
    row_mass: Scalar,
    friction: Scalar,
    accumulated_impulse: Scalar,
) -> Scalar:
    """Tangent impulse after an iteration, held within what friction can give (N*s).

    limited_tangent_impulse = max(min(tangent_impulse - row_mass*row_velocity,
    friction*accumulated_impulse), -friction*accumulated_impulse)

    Args:
        tangent_impulse: Impulse that a contact has given in a substep along its tangent, N*s
        row_velocity: Velocity of B's point of contact seen from A's, along the line, m/s
        row_mass: Impulse along the line for one unit of change of the row's velocity, kg
        friction: Coefficient of dry friction: how much of the normal force the surface can hold
            along itself, 1
        accumulated_impulse: Impulse that a contact has given in a substep along its normal, N*s

    Source: IM10, srs/models/soft_contact.md:839.
    """
    return largest(
        least(tangent_impulse - row_mass * row_velocity, friction * accumulated_impulse),
        (-friction) * accumulated_impulse,
    )


def restitution_impulse(
    accumulated_impulse: Scalar,
    row_velocity: Scalar,
    row_velocity_before: Scalar,
    restitution: Scalar,
    row_mass: Scalar,
) -> Scalar:
    """Accumulated impulse after restitution (N*s).

    restitution_impulse = max(accumulated_impulse - row_mass*(row_velocity +
    restitution*row_velocity_before), 0)

    Args:
        accumulated_impulse: Impulse that a contact has given in a substep along its normal, N*s
        row_velocity: Velocity of B's point of contact seen from A's, along the line, m/s
        row_velocity_before: Velocity of B's point of contact seen from A's, along the line;
            just before the impact, m/s
        restitution: Coefficient of restitution, from 0 (the bodies stay together) to 1 (no
            energy is lost), 1
        row_mass: Impulse along the line for one unit of change of the row's velocity, kg

    Source: IM10, srs/models/soft_contact.md:842.
    """
    return largest(
        accumulated_impulse - row_mass * (row_velocity + restitution * row_velocity_before), 0
    )
