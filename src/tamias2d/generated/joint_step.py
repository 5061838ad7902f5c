"""Joint step: Row of a joint; Impulse of a row of a joint; Joint in a substep; Work of overlaps
that are pushed apart; Rows that yield; Motion to which a solution may lead; Impact of a
mechanism; Mass of a contact through joints; Spring of a joint in a substep; Bounded spring in a
substep; Energy of a mechanism.

Generated from srs/models/joint_step.md
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.functions import Scalar, Vector, largest, least, sqrt


def row_rate(
    slope: Vector, turning_slope: Scalar, velocity: Vector, angular_velocity: Scalar
) -> Scalar:
    """Rate of a row's value, or a body's part in it (m/s).

    row_rate = dot(slope, velocity) + turning_slope*angular_velocity

    Args:
        slope: How a row's value changes with the place of a body, 1
        turning_slope: How a row's value changes with the orientation of a body, m
        velocity: Velocity of the centre of mass, m/s
        angular_velocity: Rate of turning, positive counter-clockwise, rad/s

    Source: DD56, srs/models/joint_step.md:16.
    """
    slope_x, slope_y = slope
    velocity_x, velocity_y = velocity
    return slope_x * velocity_x + slope_y * velocity_y + turning_slope * angular_velocity


def row_yield(
    slope: Vector, turning_slope: Scalar, inverse_mass: Scalar, inverse_inertia: Scalar
) -> Scalar:
    """Change of a row's rate for one unit of its impulse, or a body's part in it (1/kg).

    row_yield = inverse_mass*dot(slope, slope) + inverse_inertia*turning_slope**2

    Args:
        slope: How a row's value changes with the place of a body, 1
        turning_slope: How a row's value changes with the orientation of a body, m
        inverse_mass: One over the mass, zero for a static body, 1/kg
        inverse_inertia: One over the inertia, zero for a body that cannot turn, 1/(kg*m^2)

    Source: DD56, srs/models/joint_step.md:17.
    """
    slope_x, slope_y = slope
    return (
        inverse_mass * (slope_x * slope_x + slope_y * slope_y)
        + inverse_inertia * turning_slope * turning_slope
    )


def row_error(row_value: Scalar, row_aim: Scalar, time_step: Scalar) -> Scalar:
    """Rate of a row beyond the one that brings it where it is to be (m/s).

    row_error = (row_value - row_aim)/time_step

    Args:
        row_value: Number of a joint's equation that is zero where it holds, m
        row_aim: Value that a row is to have at the end of a substep, m
        time_step: Length of one step of a stepped scheme, s

    Source: DD56, srs/models/joint_step.md:19.
    """
    return (row_value - row_aim) / time_step


def row_value_ahead(row_value: Scalar, row_rate: Scalar, time_step: Scalar) -> Scalar:
    """Value of a row after a substep at its rate (m).

    row_value_ahead = row_value + time_step*row_rate

    Args:
        row_value: Number of a joint's equation that is zero where it holds, m
        row_rate: Rate of a row's value, or a body's part in it, m/s
        time_step: Length of one step of a stepped scheme, s

    Source: DD56, srs/models/joint_step.md:20.
    """
    return row_value + time_step * row_rate


def slope_turned(slope_before: Vector, slope: Vector) -> Scalar:
    """Squared slope times the sine of the angle by which it turned (1).

    slope_turned = abs(cross(slope_before, slope))

    Args:
        slope_before: A slope as it was a substep before, 1
        slope: How a row's value changes with the place of a body, 1

    Source: DD56, srs/models/joint_step.md:21.
    """
    slope_before_x, slope_before_y = slope_before
    slope_x, slope_y = slope
    return abs(slope_before_x * slope_y - slope_before_y * slope_x)


def slope_squared(slope: Vector) -> Scalar:
    """Square of a slope (1).

    slope_squared = dot(slope, slope)

    Args:
        slope: How a row's value changes with the place of a body, 1

    Source: DD56, srs/models/joint_step.md:22.
    """
    slope_x, slope_y = slope
    return slope_x * slope_x + slope_y * slope_y


def firmness(firm_ratio: Scalar, row_yield: Scalar) -> Scalar:
    """Mass with which a firm contact resists the velocity that its row is not to have (kg).

    firmness = firm_ratio/row_yield

    Args:
        firm_ratio: Firmness of a joint's row, times its yield, 1
        row_yield: Change of a row's rate for one unit of its impulse, or a body's part in it,
            1/kg

    Source: DD57, srs/models/joint_step.md:53.
    """
    return firm_ratio / row_yield


def row_impulse(row_rate: Scalar, firmness: Scalar) -> Scalar:
    """Impulse of a row of a joint, for slopes of length one (N*s).

    row_impulse = -firmness*row_rate

    Args:
        row_rate: Rate of a row's value, or a body's part in it, m/s
        firmness: Mass with which a firm contact resists the velocity that its row is not to
            have, kg

    Source: DD57, srs/models/joint_step.md:54.
    """
    return (-firmness) * row_rate


def velocity_later(
    velocity: Vector, row_impulse: Scalar, slope: Vector, inverse_mass: Scalar
) -> Vector:
    """Velocity of the centre of mass; after the bodies have moved (m/s).

    velocity_later = velocity + inverse_mass*row_impulse*slope

    Args:
        velocity: Velocity of the centre of mass, m/s
        row_impulse: Impulse of a row of a joint, for slopes of length one, N*s
        slope: How a row's value changes with the place of a body, 1
        inverse_mass: One over the mass, zero for a static body, 1/kg

    Source: DD57, srs/models/joint_step.md:55.
    """
    velocity_x, velocity_y = velocity
    slope_x, slope_y = slope
    return (
        velocity_x + inverse_mass * row_impulse * slope_x,
        velocity_y + inverse_mass * row_impulse * slope_y,
    )


def angular_velocity_later(
    angular_velocity: Scalar, row_impulse: Scalar, turning_slope: Scalar, inverse_inertia: Scalar
) -> Scalar:
    """Rate of turning, positive counter-clockwise; after the bodies have moved (rad/s).

    angular_velocity_later = angular_velocity + inverse_inertia*row_impulse*turning_slope

    Args:
        angular_velocity: Rate of turning, positive counter-clockwise, rad/s
        row_impulse: Impulse of a row of a joint, for slopes of length one, N*s
        turning_slope: How a row's value changes with the orientation of a body, m
        inverse_inertia: One over the inertia, zero for a body that cannot turn, 1/(kg*m^2)

    Source: DD57, srs/models/joint_step.md:56.
    """
    return angular_velocity + inverse_inertia * row_impulse * turning_slope


def momentum_later(momentum: Vector, row_impulse: Scalar, slope: Vector) -> Vector:
    """Mass times velocity; after the bodies have moved (kg*m/s).

    momentum_later = momentum + row_impulse*slope

    Args:
        momentum: Mass times velocity, kg*m/s
        row_impulse: Impulse of a row of a joint, for slopes of length one, N*s
        slope: How a row's value changes with the place of a body, 1

    Source: DD57, srs/models/joint_step.md:58.
    """
    momentum_x, momentum_y = momentum
    slope_x, slope_y = slope
    return (momentum_x + row_impulse * slope_x, momentum_y + row_impulse * slope_y)


def angular_momentum_later(
    angular_momentum: Scalar, row_impulse: Scalar, turning_slope: Scalar
) -> Scalar:
    """Moment of momentum about the origin; after the bodies have moved (kg*m^2/s).

    angular_momentum_later = angular_momentum + row_impulse*turning_slope

    Args:
        angular_momentum: Moment of momentum about the origin, kg*m^2/s
        row_impulse: Impulse of a row of a joint, for slopes of length one, N*s
        turning_slope: How a row's value changes with the orientation of a body, m

    Source: DD57, srs/models/joint_step.md:59.
    """
    return angular_momentum + row_impulse * turning_slope


def coupled_mass(slope_a: Vector, slope_along: Scalar, firmness: Scalar) -> Vector:
    """Impulse along an axis at B for velocities of A, by a firm row (kg).

    coupled_mass = firmness*slope_along*slope_a

    Args:
        slope_a: How a row's value changes with the place of a body; of body A, 1
        slope_along: Part of a slope along one axis, 1
        firmness: Mass with which a firm contact resists the velocity that its row is not to
            have, kg

    Source: DD57, srs/models/joint_step.md:60.
    """
    slope_a_x, slope_a_y = slope_a
    return (firmness * slope_along * slope_a_x, firmness * slope_along * slope_a_y)


def coupled_moment(turning_slope_a: Scalar, slope_b: Vector, firmness: Scalar) -> Vector:
    """Impulse at B for the turning of A, by a firm row (kg*m).

    coupled_moment = firmness*turning_slope_a*slope_b

    Args:
        turning_slope_a: How a row's value changes with the orientation of a body; of body A, m
        slope_b: How a row's value changes with the place of a body; of body B, 1
        firmness: Mass with which a firm contact resists the velocity that its row is not to
            have, kg

    Source: DD57, srs/models/joint_step.md:61.
    """
    slope_b_x, slope_b_y = slope_b
    return (firmness * turning_slope_a * slope_b_x, firmness * turning_slope_a * slope_b_y)


def coupled_lever(slope_a: Vector, turning_slope_b: Scalar, firmness: Scalar) -> Vector:
    """Angular impulse at B for velocities of A, by a firm row (kg*m).

    coupled_lever = firmness*turning_slope_b*slope_a

    Args:
        slope_a: How a row's value changes with the place of a body; of body A, 1
        turning_slope_b: How a row's value changes with the orientation of a body; of body B, m
        firmness: Mass with which a firm contact resists the velocity that its row is not to
            have, kg

    Source: DD57, srs/models/joint_step.md:62.
    """
    slope_a_x, slope_a_y = slope_a
    return (firmness * turning_slope_b * slope_a_x, firmness * turning_slope_b * slope_a_y)


def coupled_inertia(turning_slope_a: Scalar, turning_slope_b: Scalar, firmness: Scalar) -> Scalar:
    """Angular impulse at B for the turning of A, by a firm row (kg*m^2).

    coupled_inertia = firmness*turning_slope_b*turning_slope_a

    Args:
        turning_slope_a: How a row's value changes with the orientation of a body; of body A, m
        turning_slope_b: How a row's value changes with the orientation of a body; of body B, m
        firmness: Mass with which a firm contact resists the velocity that its row is not to
            have, kg

    Source: DD57, srs/models/joint_step.md:63.
    """
    return firmness * turning_slope_b * turning_slope_a


def row_aim(row_value: Scalar, removed_share: Scalar) -> Scalar:
    """Value that a row is to have at the end of a substep (m).

    row_aim = (1 - removed_share)*row_value

    Args:
        row_value: Number of a joint's equation that is zero where it holds, m
        removed_share: Part of a row's value that a substep removes, 1

    Source: IM15, srs/models/joint_step.md:127.
    """
    return (1 - removed_share) * row_value


def drive_error(row_rate: Scalar, drive_rate: Scalar) -> Scalar:
    """Rate of a row beyond that of its motor (m/s).

    drive_error = row_rate - drive_rate

    Args:
        row_rate: Rate of a row's value, or a body's part in it, m/s
        drive_rate: Rate at which a motor, or the time in its equation, keeps a row, m/s

    Source: IM15, srs/models/joint_step.md:128.
    """
    return row_rate - drive_rate


def row_impulse_most(row_force_most: Scalar, time_step: Scalar) -> Scalar:
    """The most that a motor or a spring gives in a substep, for slopes of length one (N*s).

    row_impulse_most = time_step*row_force_most

    Args:
        row_force_most: The most that a motor or a spring exerts, for slopes of length one, N
        time_step: Length of one step of a stepped scheme, s

    Source: IM15, srs/models/joint_step.md:129.
    """
    return time_step * row_force_most


def struck_share(row_value_start: Scalar, row_value: Scalar) -> Scalar:
    """Part of a substep after which a limit is struck (1).

    struck_share = row_value_start/(row_value_start - row_value)

    Args:
        row_value_start: Number of a joint's equation that is zero where it holds; at the start,
            m
        row_value: Number of a joint's equation that is zero where it holds, m

    Source: IM15, srs/models/joint_step.md:130.
    """
    return row_value_start / (row_value_start - row_value)


def struck_rate(row_rate_start: Scalar, struck_share: Scalar, row_rate: Scalar) -> Scalar:
    """Rate of a row as its limit is struck (m/s).

    struck_rate = row_rate_start + struck_share*(row_rate - row_rate_start)

    Args:
        row_rate_start: Rate of a row's value, or a body's part in it; at the start, m/s
        struck_share: Part of a substep after which a limit is struck, 1
        row_rate: Rate of a row's value, or a body's part in it, m/s

    Source: IM15, srs/models/joint_step.md:131.
    """
    return row_rate_start + struck_share * (row_rate - row_rate_start)


def leaning(row_force: Scalar, row_bend: Scalar) -> Scalar:
    """By how much less a joint's pull turns a body that has turned by a radian (N*m).

    leaning = -row_force*row_bend

    Args:
        row_force: Force of a row of a joint, for slopes of length one, N
        row_bend: Second derivative of a row's value by the orientation of a body, m

    Source: IM15, srs/models/joint_step.md:132.
    """
    return (-row_force) * row_bend


def inertia_held(
    inertia: Scalar, leaning: Scalar, time_step: Scalar, inertia_factor_most: Scalar
) -> Scalar:
    """Moment of inertia about the centre of mass; held through a step (kg*m^2).

    inertia_held = min(max(inertia, time_step**2*leaning), inertia_factor_most*inertia)

    Args:
        inertia: Moment of inertia about the centre of mass, kg*m^2
        leaning: By how much less a joint's pull turns a body that has turned by a radian, N*m
        time_step: Length of one step of a stepped scheme, s
        inertia_factor_most: Most times its own inertia with which a body counts in joints, 1

    Source: IM15, srs/models/joint_step.md:133.
    """
    return least(largest(inertia, time_step * time_step * leaning), inertia_factor_most * inertia)


def half_decay(kick_decay: Scalar) -> Scalar:
    """Factor of the velocity by drag in half a substep (1).

    half_decay = sqrt(kick_decay)

    Args:
        kick_decay: Factor of the velocity by drag in a substep, 1

    Source: IM15, srs/models/joint_step.md:134.
    """
    return sqrt(kick_decay)


def half_gain(kick_gain: Scalar, half_decay: Scalar) -> Scalar:
    """Velocity that forces give in half a substep (m/s).

    half_gain = kick_gain/(1 + half_decay)

    Args:
        kick_gain: Velocity that forces give in a substep, m/s
        half_decay: Factor of the velocity by drag in half a substep, 1

    Source: IM15, srs/models/joint_step.md:135.
    """
    return kick_gain / (1 + half_decay)


def kick_velocity_later(kick_velocity: Scalar, half_decay: Scalar, half_gain: Scalar) -> Scalar:
    """Velocity along one axis; after the bodies have moved (m/s).

    kick_velocity_later = half_decay*kick_velocity + half_gain

    Args:
        kick_velocity: Velocity along one axis, m/s
        half_decay: Factor of the velocity by drag in half a substep, 1
        half_gain: Velocity that forces give in half a substep, m/s

    Source: IM15, srs/models/joint_step.md:136.
    """
    return half_decay * kick_velocity + half_gain


def kick_velocity_start(kick_velocity: Scalar, half_decay: Scalar, half_gain: Scalar) -> Scalar:
    """Velocity along one axis; at the start (m/s).

    kick_velocity_start = (kick_velocity - half_gain)/half_decay

    Args:
        kick_velocity: Velocity along one axis, m/s
        half_decay: Factor of the velocity by drag in half a substep, 1
        half_gain: Velocity that forces give in half a substep, m/s

    Source: IM15, srs/models/joint_step.md:137.
    """
    return (kick_velocity - half_gain) / half_decay


def slowed_mean(slowed_share: Scalar, half_decay: Scalar, substeps: Scalar) -> Scalar:
    """Part that drag leaves of changes of velocity by the impulses of a step, in the mean (1).

    slowed_mean = slowed_share*(1 + (2/(1 + half_decay) - 1)/substeps)

    Args:
        slowed_share: Part that drag leaves of a change of velocity by an impulse that acts
            evenly through a step, 1
        half_decay: Factor of the velocity by drag in half a substep, 1
        substeps: Number of the substeps of a step, 1

    Source: IM15, srs/models/joint_step.md:138.
    """
    return slowed_share * (1 + (2 / (1 + half_decay) - 1) / substeps)


def kept_way(kinetic_energy_start: Scalar, lift_work: Scalar, work: Scalar) -> Scalar:
    """Part of its way in a step that an island keeps (1).

    kept_way = min(-(kinetic_energy_start + lift_work)/work, 1)

    Args:
        kinetic_energy_start: Energy of motion, turning included; at the start, J
        lift_work: Energy that overlaps under the weight of a body store and give back, J
        work: Energy that gravity, forces and torques have given a body in a step, J

    Source: IM15, srs/models/joint_step.md:139.
    """
    return least((-(kinetic_energy_start + lift_work)) / work, 1)


def overlap_removed(separation: Scalar, separation_later: Scalar) -> Scalar:
    """By how much an overlap is less deep after a step, negative where it is deeper (m).

    overlap_removed = min(separation_later, 0[m]) - min(separation, 0[m])

    Args:
        separation: Distance between two bodies, negative where they overlap, m
        separation_later: Distance between two bodies, negative where they overlap; after the
            bodies have moved, m

    Source: DD106, srs/models/joint_step.md:253.
    """
    return least(separation_later, 0.0) - least(separation, 0.0)


def load_size(mass: Scalar, gravity: Vector, force: Vector) -> Scalar:
    """Size of the forces on a body without those of contacts and joints (N).

    load_size = norm(mass*gravity + force)

    Args:
        mass: Mass of a body, kg
        gravity: Gravitational acceleration, the same for all bodies, m/s^2
        force: Applied force on a body, without its weight, N

    Source: DD106, srs/models/joint_step.md:254.
    """
    gravity_x, gravity_y = gravity
    force_x, force_y = force
    return sqrt(
        (mass * gravity_x + force_x) * (mass * gravity_x + force_x)
        + (mass * gravity_y + force_y) * (mass * gravity_y + force_y)
    )


def impulse_way(accumulated_impulse: Scalar, overlap_removed: Scalar) -> Scalar:
    """Impulse of a contact times the way by which its overlap is less deep (N*s*m).

    impulse_way = accumulated_impulse*overlap_removed

    Args:
        accumulated_impulse: Impulse that a contact has given in a substep along its normal, N*s
        overlap_removed: By how much an overlap is less deep after a step, negative where it is
            deeper, m

    Source: DD106, srs/models/joint_step.md:255.
    """
    return accumulated_impulse * overlap_removed


def overlap_work(
    load_size: Scalar, accumulated_impulse: Scalar, impulse_way: Scalar, time_step: Scalar
) -> Scalar:
    """Energy that overlaps give a body as they are pushed apart (J).

    overlap_work = load_size*max(impulse_way, 0[N*s*m])/max(accumulated_impulse,
    load_size*time_step)

    Args:
        load_size: Size of the forces on a body without those of contacts and joints, N
        accumulated_impulse: Impulse that a contact has given in a substep along its normal, N*s
        impulse_way: Impulse of a contact times the way by which its overlap is less deep, N*s*m
        time_step: Length of one step of a stepped scheme, s

    Source: DD106, srs/models/joint_step.md:256.
    """
    return (
        load_size * largest(impulse_way, 0.0) / largest(accumulated_impulse, load_size * time_step)
    )


def spring_change(row_impulse: Scalar, row_yield: Scalar) -> Scalar:
    """Energy of the motion that an impulse gives a row by itself (J).

    spring_change = row_impulse**2*row_yield/2

    Args:
        row_impulse: Impulse of a row of a joint, for slopes of length one, N*s
        row_yield: Change of a row's rate for one unit of its impulse, or a body's part in it,
            1/kg

    Source: DD86, srs/models/joint_step.md:292.
    """
    return row_impulse * row_impulse * row_yield / 2


def change_most(
    mass: Scalar, rates_squared: Scalar, spring_change: Scalar, amplification: Scalar
) -> Scalar:
    """Energy that the motion may have which errors of rows give a mechanism (J).

    change_most = amplification**2*mass*rates_squared/2 + spring_change

    Args:
        mass: Mass of a body, kg
        rates_squared: Sum of the squares of the rates that rows have too much, as lengths,
            m^2/s^2
        spring_change: Energy of the motion that an impulse gives a row by itself, J
        amplification: How many times the rate that rows have too much is a likely change of
            velocity, 1

    Source: DD86, srs/models/joint_step.md:293.
    """
    return amplification * amplification * mass * rates_squared / 2 + spring_change


def firmness_most(mass: Scalar, row_arm: Scalar, amplification: Scalar) -> Scalar:
    """Firmness of a row that yields (kg).

    firmness_most = amplification**2*mass*row_arm**2

    Args:
        mass: Mass of a body, kg
        row_arm: At how many metres a row that is an angle counts as a length; 1 for a length, 1
        amplification: How many times the rate that rows have too much is a likely change of
            velocity, 1

    Source: DD86, srs/models/joint_step.md:294.
    """
    return amplification * amplification * mass * row_arm * row_arm


def closing_share(row_value: Scalar, closing_way: Scalar) -> Scalar:
    """Share of its value that a row that has yielded removes in a substep (1).

    closing_share = closing_way/abs(row_value)

    Args:
        row_value: Number of a joint's equation that is zero where it holds, m
        closing_way: Way by which a row that has yielded may close in a substep at most, m

    Source: DD86, srs/models/joint_step.md:295.
    """
    return closing_way / abs(row_value)


def motion_most(
    kinetic_energy: Scalar,
    mass: Scalar,
    rates_squared: Scalar,
    row_energy: Scalar,
    growth_ratio: Scalar,
) -> Scalar:
    """Energy of motion to which one solution of a mechanism may lead (J).

    motion_most = growth_ratio*kinetic_energy + mass*rates_squared/2 + row_energy

    Args:
        kinetic_energy: Energy of motion, turning included, J
        mass: Mass of a body, kg
        rates_squared: Sum of the squares of the rates that rows have too much, as lengths,
            m^2/s^2
        row_energy: Energy of a spring at a joint, J
        growth_ratio: By which ratio the energy of motion may grow by one solution, 1

    Source: DD98, srs/models/joint_step.md:351.
    """
    return growth_ratio * kinetic_energy + mass * rates_squared / 2 + row_energy


def impact_rate(row_velocity: Scalar, separation: Scalar, time_step: Scalar) -> Scalar:
    """Velocity of a contact in a substep beyond that which closes its gap, negative in an impact
    (m/s).

    impact_rate = row_velocity + max(separation, 0[m])/time_step

    Args:
        row_velocity: Velocity of B's point of contact seen from A's, along the line, m/s
        separation: Distance between two bodies, negative where they overlap, m
        time_step: Length of one step of a stepped scheme, s

    Source: DD107, srs/models/joint_step.md:394.
    """
    return row_velocity + largest(separation, 0.0) / time_step


def blow_velocity(
    accumulated_impulse: Scalar, inverse_mass_a: Scalar, inverse_mass_b: Scalar
) -> Scalar:
    """How fast an impulse lets the centres of two bodies part (m/s).

    blow_velocity = accumulated_impulse*(inverse_mass_a + inverse_mass_b)

    Args:
        accumulated_impulse: Impulse that a contact has given in a substep along its normal, N*s
        inverse_mass_a: One over the mass, zero for a static body; of body A, 1/kg
        inverse_mass_b: One over the mass, zero for a static body; of body B, 1/kg

    Source: DD107, srs/models/joint_step.md:395.
    """
    return accumulated_impulse * (inverse_mass_a + inverse_mass_b)


def lost_velocity(row_velocity: Scalar, row_velocity_before: Scalar, restitution: Scalar) -> Scalar:
    """What joints have taken of the velocity of a contact that restitution asks for (m/s).

    lost_velocity = -(row_velocity + restitution*row_velocity_before)

    Args:
        row_velocity: Velocity of B's point of contact seen from A's, along the line, m/s
        row_velocity_before: Velocity of B's point of contact seen from A's, along the line;
            just before the impact, m/s
        restitution: Coefficient of restitution, from 0 (the bodies stay together) to 1 (no
            energy is lost), 1

    Source: DD96, srs/models/joint_step.md:432.
    """
    return -(row_velocity + restitution * row_velocity_before)


def lost_share(row_mass: Scalar, lost_velocity: Scalar, applied_impulse: Scalar) -> Scalar:
    """Part that joints take of what an impulse changes in the velocity of a contact (1).

    lost_share = row_mass*lost_velocity/applied_impulse

    Args:
        row_mass: Impulse along the line for one unit of change of the row's velocity, kg
        lost_velocity: What joints have taken of the velocity of a contact that restitution asks
            for, m/s
        applied_impulse: Impulse that a row gives in one iteration, to B along the line, N*s

    Source: DD96, srs/models/joint_step.md:433.
    """
    return row_mass * lost_velocity / applied_impulse


def row_mass_joined(row_mass: Scalar, lost_share: Scalar) -> Scalar:
    """Impulse for one unit of change of a contact's velocity while joints hold (kg).

    row_mass_joined = row_mass/(1 - lost_share)

    Args:
        row_mass: Impulse along the line for one unit of change of the row's velocity, kg
        lost_share: Part that joints take of what an impulse changes in the velocity of a
            contact, 1

    Source: DD96, srs/models/joint_step.md:434.
    """
    return row_mass / (1 - lost_share)


def overshot_share(lost_velocity: Scalar, lost_velocity_before: Scalar) -> Scalar:
    """The same part where a turn overshoots, of the impulse of this turn (1).

    overshot_share = min(lost_velocity/lost_velocity_before, 0)

    Args:
        lost_velocity: What joints have taken of the velocity of a contact that restitution asks
            for, m/s
        lost_velocity_before: What joints had taken of it after the turn before, m/s

    Source: DD96, srs/models/joint_step.md:435.
    """
    return least(lost_velocity / lost_velocity_before, 0)


def implicit_share(
    row_stiffness: Scalar, row_damping: Scalar, row_yield: Scalar, time_step: Scalar
) -> Scalar:
    """Share of a substep's way after which a spring at a joint answers (1).

    implicit_share = (2 + unresolved)/(4 + unresolved)
        where unresolved = time_step*row_damping*row_yield + max(time_step**2*row_stiffness*row_yield - 1, 0)

    Args:
        row_stiffness: Force of a spring for a row's value, N/m
        row_damping: Force of a damper for a row's rate, kg/s
        row_yield: Change of a row's rate for one unit of its impulse, or a body's part in it,
            1/kg
        time_step: Length of one step of a stepped scheme, s

    Source: IM19, srs/models/joint_step.md:492.
    """
    unresolved = time_step * row_damping * row_yield + largest(
        time_step * time_step * row_stiffness * row_yield - 1, 0
    )
    return (2 + unresolved) / (4 + unresolved)


def spring_firmness(
    row_stiffness: Scalar, row_damping: Scalar, implicit_share: Scalar, time_step: Scalar
) -> Scalar:
    """Impulse that a spring gives in a substep against a rate (kg).

    spring_firmness = implicit_share*time_step*(row_damping +
    implicit_share*time_step*row_stiffness)

    Args:
        row_stiffness: Force of a spring for a row's value, N/m
        row_damping: Force of a damper for a row's rate, kg/s
        implicit_share: Share of a substep's way after which a spring at a joint answers, 1
        time_step: Length of one step of a stepped scheme, s

    Source: IM19, srs/models/joint_step.md:496.
    """
    return implicit_share * time_step * (row_damping + implicit_share * time_step * row_stiffness)


def spring_error(
    row_value: Scalar,
    row_value_start: Scalar,
    row_rate: Scalar,
    row_given: Scalar,
    row_stiffness: Scalar,
    row_damping: Scalar,
    implicit_share: Scalar,
    firmness: Scalar,
    time_step: Scalar,
) -> Scalar:
    """Rate of a row that its spring has not answered yet (m/s).

    spring_error = (row_given - implicit_share*time_step*row_force)/firmness
        where spring_value = (1 - implicit_share)*row_value_start + implicit_share*row_value
        where row_force = -row_stiffness*spring_value - row_damping*row_rate

    Args:
        row_value: Number of a joint's equation that is zero where it holds, m
        row_value_start: Number of a joint's equation that is zero where it holds; at the start,
            m
        row_rate: Rate of a row's value, or a body's part in it, m/s
        row_given: Impulse that a row has had in a substep so far, N*s
        row_stiffness: Force of a spring for a row's value, N/m
        row_damping: Force of a damper for a row's rate, kg/s
        implicit_share: Share of a substep's way after which a spring at a joint answers, 1
        firmness: Mass with which a firm contact resists the velocity that its row is not to
            have, kg
        time_step: Length of one step of a stepped scheme, s

    Source: IM19, srs/models/joint_step.md:498.
    """
    spring_value = (1 - implicit_share) * row_value_start + implicit_share * row_value
    row_force = (-row_stiffness) * spring_value - row_damping * row_rate
    return (row_given - implicit_share * time_step * row_force) / firmness


def left_impulse(row_given: Scalar, implicit_share: Scalar) -> Scalar:
    """Impulse that a spring at a joint gives where bodies have moved to (N*s).

    left_impulse = (1 - implicit_share)/implicit_share*row_given

    Args:
        row_given: Impulse that a row has had in a substep so far, N*s
        implicit_share: Share of a substep's way after which a spring at a joint answers, 1

    Source: IM19, srs/models/joint_step.md:499.
    """
    return (1 - implicit_share) / implicit_share * row_given


def whole_impulse(row_given: Scalar, implicit_share: Scalar) -> Scalar:
    """Impulse of a spring at a joint for all of a substep (N*s).

    whole_impulse = row_given/implicit_share

    Args:
        row_given: Impulse that a row has had in a substep so far, N*s
        implicit_share: Share of a substep's way after which a spring at a joint answers, 1

    Source: DD105, srs/models/joint_step.md:594.
    """
    return row_given / implicit_share


def impulse_room(row_impulse_most: Scalar, impulse_left: Scalar) -> Scalar:
    """The most that a spring gives beside that (N*s).

    impulse_room = row_impulse_most - min(impulse_left, row_impulse_most/2)

    Args:
        row_impulse_most: The most that a motor or a spring gives in a substep, for slopes of
            length one, N*s
        impulse_left: Size of what a spring at a joint had left of the substep before, N*s

    Source: DD105, srs/models/joint_step.md:595.
    """
    return row_impulse_most - least(impulse_left, row_impulse_most / 2)


def row_stiffness_softer(force_share: Scalar, row_stiffness: Scalar) -> Scalar:
    """Force of a spring for a row's value; of a spring that exerts its share (N/m).

    row_stiffness_softer = force_share*row_stiffness

    Args:
        force_share: Share of its force that a spring with a maximum exerts, 1
        row_stiffness: Force of a spring for a row's value, N/m

    Source: DD105, srs/models/joint_step.md:596.
    """
    return force_share * row_stiffness


def row_damping_softer(force_share: Scalar, row_damping: Scalar) -> Scalar:
    """Force of a damper for a row's rate; of a spring that exerts its share (kg/s).

    row_damping_softer = force_share*row_damping

    Args:
        force_share: Share of its force that a spring with a maximum exerts, 1
        row_damping: Force of a damper for a row's rate, kg/s

    Source: DD105, srs/models/joint_step.md:597.
    """
    return force_share * row_damping


def row_energy(row_stiffness: Scalar, row_value: Scalar) -> Scalar:
    """Energy of a spring at a joint (J).

    row_energy = row_stiffness*row_value**2/2

    Args:
        row_stiffness: Force of a spring for a row's value, N/m
        row_value: Number of a joint's equation that is zero where it holds, m

    Source: DD79, srs/models/joint_step.md:632.
    """
    return row_stiffness * row_value * row_value / 2


def drive_work(row_impulse: Scalar, drive_rate: Scalar) -> Scalar:
    """The most that a motor gives with its impulse (J).

    drive_work = row_impulse*drive_rate

    Args:
        row_impulse: Impulse of a row of a joint, for slopes of length one, N*s
        drive_rate: Rate at which a motor, or the time in its equation, keeps a row, m/s

    Source: DD79, srs/models/joint_step.md:633.
    """
    return row_impulse * drive_rate


def mechanism_energy_balance(
    kinetic_energy_start: Scalar,
    work: Scalar,
    row_energy_start: Scalar,
    row_energy: Scalar,
    energy_reserve: Scalar,
) -> Scalar:
    """Kinetic energy with which a step of a mechanism may end, or what it lacks (J).

    mechanism_energy_balance = kinetic_energy_start + work + row_energy_start - row_energy +
    energy_reserve

    Args:
        kinetic_energy_start: Energy of motion, turning included; at the start, J
        work: Energy that gravity, forces and torques have given a body in a step, J
        row_energy_start: Energy of a spring at a joint; at the start, J
        row_energy: Energy of a spring at a joint, J
        energy_reserve: What a mechanism may gain of what it has lost, or has too much where it
            is negative, J

    Source: DD79, srs/models/joint_step.md:634.
    """
    return kinetic_energy_start + work + row_energy_start - row_energy + energy_reserve


def energy_scale_later(
    energy_scale: Scalar, kinetic_energy: Scalar, row_energy: Scalar, scale_fade: Scalar
) -> Scalar:
    """The most of motion and springs that a mechanism has had lately; after the bodies have moved
    (J).

    energy_scale_later = max(scale_fade*energy_scale, kinetic_energy + row_energy)

    Args:
        energy_scale: The most of motion and springs that a mechanism has had lately, J
        kinetic_energy: Energy of motion, turning included, J
        row_energy: Energy of a spring at a joint, J
        scale_fade: Factor by which the scale of a mechanism's energy fades in a step, 1

    Source: DD79, srs/models/joint_step.md:636.
    """
    return largest(scale_fade * energy_scale, kinetic_energy + row_energy)


def energy_reserve_later(
    mechanism_energy_balance: Scalar,
    kinetic_energy: Scalar,
    energy_scale: Scalar,
    reserve_ratio: Scalar,
) -> Scalar:
    """What a mechanism may gain of what it has lost, or has too much where it is negative; after
    the bodies have moved (J).

    energy_reserve_later = min(mechanism_energy_balance - kinetic_energy,
    reserve_ratio*energy_scale)

    Args:
        mechanism_energy_balance: Kinetic energy with which a step of a mechanism may end, or
            what it lacks, J
        kinetic_energy: Energy of motion, turning included, J
        energy_scale: The most of motion and springs that a mechanism has had lately, J
        reserve_ratio: Reserve of a mechanism, of its scale at most, 1

    Source: DD79, srs/models/joint_step.md:638.
    """
    return least(mechanism_energy_balance - kinetic_energy, reserve_ratio * energy_scale)


def energy_regained(kinetic_energy: Scalar, kinetic_energy_start: Scalar, work: Scalar) -> Scalar:
    """What a mechanism has gained in a step of what it had lost (J).

    energy_regained = max(kinetic_energy - kinetic_energy_start - work, 0[J])

    Args:
        kinetic_energy: Energy of motion, turning included, J
        kinetic_energy_start: Energy of motion, turning included; at the start, J
        work: Energy that gravity, forces and torques have given a body in a step, J

    Source: DD79, srs/models/joint_step.md:640.
    """
    return largest(kinetic_energy - kinetic_energy_start - work, 0.0)


def way_kept(kinetic_energy_start: Scalar, work: Scalar, energy_reserve: Scalar) -> Scalar:
    """Share of its way for which a mechanism has the energy (1).

    way_kept = -(kinetic_energy_start + energy_reserve)/work

    Args:
        kinetic_energy_start: Energy of motion, turning included; at the start, J
        work: Energy that gravity, forces and torques have given a body in a step, J
        energy_reserve: What a mechanism may gain of what it has lost, or has too much where it
            is negative, J

    Source: DD79, srs/models/joint_step.md:641.
    """
    return (-(kinetic_energy_start + energy_reserve)) / work
