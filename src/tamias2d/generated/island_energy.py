"""Island energy: Work in a step; Motion seen from a support; Drag seen from a support; Body that
nothing turns; Motion of an island as one body; Share of a bounce; Bound on the energy of an
island; Dissipation of excess energy; Energy for a lift; Lift beyond motion; Work of a support;
Angular momentum that contacts give; Angular momentum of a free island.

Generated from srs/models/island_energy.md
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.functions import Scalar, Vector, largest, least, power, sqrt


def work(
    mass: Scalar, gravity: Vector, force: Vector, torque: Scalar, shift: Vector, turn: Scalar
) -> Scalar:
    """Energy that gravity, forces and torques have given a body in a step (J).

    work = dot(mass*gravity + force, shift) + torque*turn

    Args:
        mass: Mass of a body, kg
        gravity: Gravitational acceleration, the same for all bodies, m/s^2
        force: Applied force on a body, without its weight, N
        torque: Applied torque about the centre of mass, positive counter-clockwise, N*m
        shift: How far the centre of mass has moved since the step began, m
        turn: How far a body has turned since the step began, rad

    Source: DD36, srs/models/island_energy.md:19.
    """
    gravity_x, gravity_y = gravity
    force_x, force_y = force
    shift_x, shift_y = shift
    return (
        (mass * gravity_x + force_x) * shift_x
        + (mass * gravity_y + force_y) * shift_y
        + torque * turn
    )


def lift_work(mass: Scalar, gravity: Vector, force: Vector, time_step: Scalar) -> Scalar:
    """Energy that overlaps under the weight of a body store and give back (J).

    lift_work = dot(mass*gravity + force, mass*gravity + force)*time_step**2/(2*mass)

    Args:
        mass: Mass of a body, kg
        gravity: Gravitational acceleration, the same for all bodies, m/s^2
        force: Applied force on a body, without its weight, N
        time_step: Length of one step of a stepped scheme, s

    Source: DD36, srs/models/island_energy.md:20.
    """
    gravity_x, gravity_y = gravity
    force_x, force_y = force
    return (
        (
            (mass * gravity_x + force_x) * (mass * gravity_x + force_x)
            + (mass * gravity_y + force_y) * (mass * gravity_y + force_y)
        )
        * time_step
        * time_step
        / (2 * mass)
    )


def velocity_seen(velocity: Vector, velocity_support: Vector) -> Vector:
    """Velocity of the centre of mass; seen from what an island leans on (m/s).

    velocity_seen = velocity - velocity_support

    Args:
        velocity: Velocity of the centre of mass, m/s
        velocity_support: Velocity of the centre of mass; of what an island leans on, at the
            body, m/s

    Source: DD37, srs/models/island_energy.md:51.
    """
    velocity_x, velocity_y = velocity
    velocity_support_x, velocity_support_y = velocity_support
    return (velocity_x - velocity_support_x, velocity_y - velocity_support_y)


def angular_velocity_seen(angular_velocity: Scalar, angular_velocity_support: Scalar) -> Scalar:
    """Rate of turning, positive counter-clockwise; seen from what an island leans on (rad/s).

    angular_velocity_seen = angular_velocity - angular_velocity_support

    Args:
        angular_velocity: Rate of turning, positive counter-clockwise, rad/s
        angular_velocity_support: Rate of turning, positive counter-clockwise; of what an island
            leans on, at the body, rad/s

    Source: DD37, srs/models/island_energy.md:52.
    """
    return angular_velocity - angular_velocity_support


def shift_seen(shift: Vector, velocity_support: Vector, time_step: Scalar) -> Vector:
    """How far the centre of mass has moved since the step began; seen from what an island leans on
    (m).

    shift_seen = shift - time_step*velocity_support

    Args:
        shift: How far the centre of mass has moved since the step began, m
        velocity_support: Velocity of the centre of mass; of what an island leans on, at the
            body, m/s
        time_step: Length of one step of a stepped scheme, s

    Source: DD37, srs/models/island_energy.md:53.
    """
    shift_x, shift_y = shift
    velocity_support_x, velocity_support_y = velocity_support
    return (shift_x - time_step * velocity_support_x, shift_y - time_step * velocity_support_y)


def turn_seen(turn: Scalar, angular_velocity_support: Scalar, time_step: Scalar) -> Scalar:
    """How far a body has turned since the step began; seen from what an island leans on (rad).

    turn_seen = turn - time_step*angular_velocity_support

    Args:
        turn: How far a body has turned since the step began, rad
        angular_velocity_support: Rate of turning, positive counter-clockwise; of what an island
            leans on, at the body, rad/s
        time_step: Length of one step of a stepped scheme, s

    Source: DD37, srs/models/island_energy.md:54.
    """
    return turn - time_step * angular_velocity_support


def drag_rate(propagator_decay: Scalar, propagator_gain: Scalar) -> Scalar:
    """Share of its velocity that a body loses to linear drag per unit of time (1/s).

    drag_rate = (1 - propagator_decay)/propagator_gain

    Args:
        propagator_decay: Part of a velocity that drag leaves after a step, 1
        propagator_gain: Velocity after a step for one unit of acceleration, s

    Source: DD109, srs/models/island_energy.md:75.
    """
    return (1 - propagator_decay) / propagator_gain


def force_seen(force: Vector, mass: Scalar, drag_rate: Scalar, velocity_support: Vector) -> Vector:
    """Applied force on a body, without its weight; seen from what an island leans on (N).

    force_seen = force - mass*drag_rate*velocity_support

    Args:
        force: Applied force on a body, without its weight, N
        mass: Mass of a body, kg
        drag_rate: Share of its velocity that a body loses to linear drag per unit of time, 1/s
        velocity_support: Velocity of the centre of mass; of what an island leans on, at the
            body, m/s

    Source: DD109, srs/models/island_energy.md:76.
    """
    force_x, force_y = force
    velocity_support_x, velocity_support_y = velocity_support
    return (
        force_x - mass * drag_rate * velocity_support_x,
        force_y - mass * drag_rate * velocity_support_y,
    )


def torque_seen(
    torque: Scalar, inertia: Scalar, angular_drag_rate: Scalar, angular_velocity_support: Scalar
) -> Scalar:
    """Applied torque about the centre of mass, positive counter-clockwise; seen from what an
    island leans on (N*m).

    torque_seen = torque - inertia*angular_drag_rate*angular_velocity_support

    Args:
        torque: Applied torque about the centre of mass, positive counter-clockwise, N*m
        inertia: Moment of inertia about the centre of mass, kg*m^2
        angular_drag_rate: Share of its angular velocity that a body loses to angular drag per
            unit of time, 1/s
        angular_velocity_support: Rate of turning, positive counter-clockwise; of what an island
            leans on, at the body, rad/s

    Source: DD109, srs/models/island_energy.md:77.
    """
    return torque - inertia * angular_drag_rate * angular_velocity_support


def contact_arm(bend: Scalar, turning_arm: Scalar, normal: Vector, tangent: Vector) -> Vector:
    """Lever arm from the centre of mass of a body to a contact (m).

    contact_arm = bend*normal - turning_arm*tangent

    Args:
        bend: Part of an arm along the line, as far as it turns with its body, m
        turning_arm: Part of an arm across the line, by which an impulse along it turns a body,
            m
        normal: Unit normal of a contact, from body A to body B, 1
        tangent: Unit tangent of a contact, the normal turned left by a quarter turn, 1

    Source: DD108, srs/models/island_energy.md:113.
    """
    normal_x, normal_y = normal
    tangent_x, tangent_y = tangent
    return (bend * normal_x - turning_arm * tangent_x, bend * normal_y - turning_arm * tangent_y)


def impulse_moment(
    total_impulse: Scalar, turning_arm: Scalar, tangential_impulse: Scalar, bend: Scalar
) -> Scalar:
    """Moment of the impulses of one contact about the centre of mass of a body (kg*m^2/s).

    impulse_moment = total_impulse*turning_arm + tangential_impulse*bend

    Args:
        total_impulse: Impulse that a contact has given in a step along its normal, N*s
        turning_arm: Part of an arm across the line, by which an impulse along it turns a body,
            m
        tangential_impulse: Impulse of a contact on body B along its tangent, N*s
        bend: Part of an arm along the line, as far as it turns with its body, m

    Source: DD108, srs/models/island_energy.md:114.
    """
    return total_impulse * turning_arm + tangential_impulse * bend


def pressed_arm(pressed_moment: Vector, total_impulse: Scalar) -> Vector:
    """Lever arm to where the contacts of a body press it in the mean (m).

    pressed_arm = pressed_moment/total_impulse

    Args:
        pressed_moment: Sum over the contacts of a body of their arms times their impulses along
            the normal, N*s*m
        total_impulse: Impulse that a contact has given in a step along its normal, N*s

    Source: DD108, srs/models/island_energy.md:115.
    """
    pressed_moment_x, pressed_moment_y = pressed_moment
    return (pressed_moment_x / total_impulse, pressed_moment_y / total_impulse)


def holding_work(
    angular_velocity_support: Scalar,
    angular_impulse: Scalar,
    pressed_arm: Vector,
    impulse_vector: Vector,
) -> Scalar:
    """Energy that the torque which keeps a body from turning has given it in a step, seen from its
    support (J).

    holding_work = angular_velocity_support*(angular_impulse - cross(pressed_arm,
    impulse_vector))

    Args:
        angular_velocity_support: Rate of turning, positive counter-clockwise; of what an island
            leans on, at the body, rad/s
        angular_impulse: Moment that the impulses on a body have about its centre of mass,
            kg*m^2/s
        pressed_arm: Lever arm to where the contacts of a body press it in the mean, m
        impulse_vector: Integral of a force over the time in which it acts, N*s

    Source: DD108, srs/models/island_energy.md:116.
    """
    pressed_arm_x, pressed_arm_y = pressed_arm
    impulse_vector_x, impulse_vector_y = impulse_vector
    return angular_velocity_support * (
        angular_impulse - (pressed_arm_x * impulse_vector_y - pressed_arm_y * impulse_vector_x)
    )


def mass_moment(mass: Scalar, position: Vector) -> Vector:
    """Mass times position (kg*m).

    mass_moment = mass*position

    Args:
        mass: Mass of a body, kg
        position: Position of the centre of mass, m

    Source: DD38, srs/models/island_energy.md:170.
    """
    position_x, position_y = position
    return (mass * position_x, mass * position_y)


def inertia_origin(mass: Scalar, position: Vector, inertia: Scalar) -> Scalar:
    """Moment of inertia about the centre of mass; about the origin (kg*m^2).

    inertia_origin = inertia + mass*dot(position, position)

    Args:
        mass: Mass of a body, kg
        position: Position of the centre of mass, m
        inertia: Moment of inertia about the centre of mass, kg*m^2

    Source: DD38, srs/models/island_energy.md:171.
    """
    position_x, position_y = position
    return inertia + mass * (position_x * position_x + position_y * position_y)


def position_island(mass_moment: Vector, mass: Scalar) -> Vector:
    """Position of the centre of mass; of an island as one body (m).

    position_island = mass_moment/mass

    Args:
        mass_moment: Mass times position, kg*m
        mass: Mass of a body, kg

    Source: DD38, srs/models/island_energy.md:172.
    """
    mass_moment_x, mass_moment_y = mass_moment
    return (mass_moment_x / mass, mass_moment_y / mass)


def velocity_island(momentum: Vector, mass: Scalar) -> Vector:
    """Velocity of the centre of mass; of an island as one body (m/s).

    velocity_island = momentum/mass

    Args:
        momentum: Mass times velocity, kg*m/s
        mass: Mass of a body, kg

    Source: DD38, srs/models/island_energy.md:173.
    """
    momentum_x, momentum_y = momentum
    return (momentum_x / mass, momentum_y / mass)


def inertia_island(inertia_origin: Scalar, mass: Scalar, position_island: Vector) -> Scalar:
    """Moment of inertia about the centre of mass; of an island as one body (kg*m^2).

    inertia_island = inertia_origin - mass*dot(position_island, position_island)

    Args:
        inertia_origin: Moment of inertia about the centre of mass; about the origin, kg*m^2
        mass: Mass of a body, kg
        position_island: Position of the centre of mass; of an island as one body, m

    Source: DD38, srs/models/island_energy.md:174.
    """
    position_island_x, position_island_y = position_island
    return inertia_origin - mass * (
        position_island_x * position_island_x + position_island_y * position_island_y
    )


def angular_velocity_island(
    angular_momentum: Scalar,
    mass: Scalar,
    position_island: Vector,
    velocity_island: Vector,
    inertia_island: Scalar,
) -> Scalar:
    """Rate of turning, positive counter-clockwise; of an island as one body (rad/s).

    angular_velocity_island = (angular_momentum - mass*cross(position_island,
    velocity_island))/inertia_island

    Args:
        angular_momentum: Moment of momentum about the origin, kg*m^2/s
        mass: Mass of a body, kg
        position_island: Position of the centre of mass; of an island as one body, m
        velocity_island: Velocity of the centre of mass; of an island as one body, m/s
        inertia_island: Moment of inertia about the centre of mass; of an island as one body,
            kg*m^2

    Source: DD38, srs/models/island_energy.md:175.
    """
    position_island_x, position_island_y = position_island
    velocity_island_x, velocity_island_y = velocity_island
    return (
        angular_momentum
        - mass * (position_island_x * velocity_island_y - position_island_y * velocity_island_x)
    ) / inertia_island


def kinetic_energy_kept(
    kinetic_energy_before: Scalar,
    kinetic_energy_after: Scalar,
    change_energy: Scalar,
    kept_share: Scalar,
) -> Scalar:
    """Energy of motion, turning included; with the share of the bounce that is kept (J).

    kinetic_energy_kept = (1 - kept_share)*kinetic_energy_before +
    kept_share*kinetic_energy_after - kept_share*(1 - kept_share)*change_energy

    Args:
        kinetic_energy_before: Energy of motion, turning included; just before the impact, J
        kinetic_energy_after: Energy of motion, turning included; just after the impact, J
        change_energy: Kinetic energy that bodies would have with a change of velocities alone,
            J
        kept_share: Part of its bounce that an island keeps, 1

    Source: GD13, srs/models/island_energy.md:230.
    """
    return (
        (1 - kept_share) * kinetic_energy_before
        + kept_share * kinetic_energy_after
        - kept_share * (1 - kept_share) * change_energy
    )


def velocity_kept(velocity_before: Vector, velocity_after: Vector, kept_share: Scalar) -> Vector:
    """Velocity of the centre of mass; with the share of the bounce that is kept (m/s).

    velocity_kept = velocity_before + kept_share*(velocity_after - velocity_before)

    Args:
        velocity_before: Velocity of the centre of mass; just before the impact, m/s
        velocity_after: Velocity of the centre of mass; just after the impact, m/s
        kept_share: Part of its bounce that an island keeps, 1

    Source: GD13, srs/models/island_energy.md:233.
    """
    velocity_before_x, velocity_before_y = velocity_before
    velocity_after_x, velocity_after_y = velocity_after
    return (
        velocity_before_x + kept_share * (velocity_after_x - velocity_before_x),
        velocity_before_y + kept_share * (velocity_after_y - velocity_before_y),
    )


def angular_velocity_kept(
    angular_velocity_before: Scalar, angular_velocity_after: Scalar, kept_share: Scalar
) -> Scalar:
    """Rate of turning, positive counter-clockwise; with the share of the bounce that is kept
    (rad/s).

    angular_velocity_kept = angular_velocity_before + kept_share*(angular_velocity_after -
    angular_velocity_before)

    Args:
        angular_velocity_before: Rate of turning, positive counter-clockwise; just before the
            impact, rad/s
        angular_velocity_after: Rate of turning, positive counter-clockwise; just after the
            impact, rad/s
        kept_share: Part of its bounce that an island keeps, 1

    Source: GD13, srs/models/island_energy.md:234.
    """
    return angular_velocity_before + kept_share * (angular_velocity_after - angular_velocity_before)


def accumulated_impulse_kept(
    accumulated_impulse: Scalar, applied_impulse: Scalar, kept_share: Scalar
) -> Scalar:
    """Impulse that a contact has given in a substep along its normal; with the share of the bounce
    that is kept (N*s).

    accumulated_impulse_kept = accumulated_impulse - (1 - kept_share)*applied_impulse

    Args:
        accumulated_impulse: Impulse that a contact has given in a substep along its normal, N*s
        applied_impulse: Impulse that a row gives in one iteration, to B along the line, N*s
        kept_share: Part of its bounce that an island keeps, 1

    Source: GD13, srs/models/island_energy.md:237.
    """
    return accumulated_impulse - (1 - kept_share) * applied_impulse


def kept_share_rising(energy_room: Scalar, energy_rise: Scalar, change_energy: Scalar) -> Scalar:
    """Part of its bounce that an island keeps; where energy rises from the first (1).

    kept_share_rising = min(2*energy_room/(energy_slope + energy_root), 1)
        where energy_slope = energy_rise - change_energy
        where energy_root = sqrt(energy_slope**2 + 4*change_energy*energy_room)

    Args:
        energy_room: What a change of velocities may add to the kinetic energy, J
        energy_rise: What all of a change of velocities adds to the kinetic energy, J
        change_energy: Kinetic energy that bodies would have with a change of velocities alone,
            J

    Source: GD13, srs/models/island_energy.md:241.
    """
    energy_slope = energy_rise - change_energy
    energy_root = sqrt(energy_slope * energy_slope + 4 * change_energy * energy_room)
    return least(2 * energy_room / (energy_slope + energy_root), 1)


def kept_share_falling(energy_room: Scalar, energy_rise: Scalar, change_energy: Scalar) -> Scalar:
    """Part of its bounce that an island keeps; where energy does not rise at first (1).

    kept_share_falling = min((energy_root - energy_slope)/(2*change_energy), 1)
        where energy_slope = energy_rise - change_energy
        where energy_root = sqrt(energy_slope**2 + 4*change_energy*energy_room)

    Args:
        energy_room: What a change of velocities may add to the kinetic energy, J
        energy_rise: What all of a change of velocities adds to the kinetic energy, J
        change_energy: Kinetic energy that bodies would have with a change of velocities alone,
            J

    Source: GD13, srs/models/island_energy.md:242.
    """
    energy_slope = energy_rise - change_energy
    energy_root = sqrt(energy_slope * energy_slope + 4 * change_energy * energy_room)
    return least((energy_root - energy_slope) / (2 * change_energy), 1)


def kinetic_energy_most(kinetic_energy_start: Scalar, work: Scalar) -> Scalar:
    """Energy of motion, turning included; the most that there may be (J).

    kinetic_energy_most = max(kinetic_energy_start + work, 0[J])

    Args:
        kinetic_energy_start: Energy of motion, turning included; at the start, J
        work: Energy that gravity, forces and torques have given a body in a step, J

    Source: IM11, srs/models/island_energy.md:335.
    """
    return largest(kinetic_energy_start + work, 0.0)


def damped_share(
    kinetic_energy: Scalar, kinetic_energy_most: Scalar, kinetic_energy_least: Scalar
) -> Scalar:
    """Part that an island keeps of what differs in its velocities from its motion as one (1).

    damped_share = min(sqrt((kinetic_energy_most - kinetic_energy_least)/(kinetic_energy -
    kinetic_energy_least)), 1)

    Args:
        kinetic_energy: Energy of motion, turning included, J
        kinetic_energy_most: Energy of motion, turning included; the most that there may be, J
        kinetic_energy_least: Energy of motion, turning included; the least that there can be, J

    Source: IM11, srs/models/island_energy.md:336.
    """
    return least(
        sqrt(
            (kinetic_energy_most - kinetic_energy_least) / (kinetic_energy - kinetic_energy_least)
        ),
        1,
    )


def velocity_damped(velocity: Vector, velocity_island: Vector, damped_share: Scalar) -> Vector:
    """Velocity of the centre of mass; nearer to the motion as one (m/s).

    velocity_damped = velocity_island + damped_share*(velocity - velocity_island)

    Args:
        velocity: Velocity of the centre of mass, m/s
        velocity_island: Velocity of the centre of mass; of an island as one body, m/s
        damped_share: Part that an island keeps of what differs in its velocities from its
            motion as one, 1

    Source: IM11, srs/models/island_energy.md:339.
    """
    velocity_x, velocity_y = velocity
    velocity_island_x, velocity_island_y = velocity_island
    return (
        velocity_island_x + damped_share * (velocity_x - velocity_island_x),
        velocity_island_y + damped_share * (velocity_y - velocity_island_y),
    )


def angular_velocity_damped(
    angular_velocity: Scalar, angular_velocity_island: Scalar, damped_share: Scalar
) -> Scalar:
    """Rate of turning, positive counter-clockwise; nearer to the motion as one (rad/s).

    angular_velocity_damped = angular_velocity_island + damped_share*(angular_velocity -
    angular_velocity_island)

    Args:
        angular_velocity: Rate of turning, positive counter-clockwise, rad/s
        angular_velocity_island: Rate of turning, positive counter-clockwise; of an island as
            one body, rad/s
        damped_share: Part that an island keeps of what differs in its velocities from its
            motion as one, 1

    Source: IM11, srs/models/island_energy.md:340.
    """
    return angular_velocity_island + damped_share * (angular_velocity - angular_velocity_island)


def given_product(
    mass: Scalar,
    velocity: Vector,
    velocity_given: Vector,
    inertia: Scalar,
    angular_velocity: Scalar,
    angular_velocity_given: Scalar,
) -> Scalar:
    """Product of the motion of bodies and of what contacts gave them, weighted by their masses and
    inertias (J).

    given_product = mass*dot(velocity, velocity_given) +
    inertia*angular_velocity*angular_velocity_given

    Args:
        mass: Mass of a body, kg
        velocity: Velocity of the centre of mass, m/s
        velocity_given: What contacts have changed in the velocity of a body in all substeps,
            m/s
        inertia: Moment of inertia about the centre of mass, kg*m^2
        angular_velocity: Rate of turning, positive counter-clockwise, rad/s
        angular_velocity_given: What contacts have changed in the angular velocity of a body in
            all substeps, rad/s

    Source: DD88, srs/models/island_energy.md:423.
    """
    velocity_x, velocity_y = velocity
    velocity_given_x, velocity_given_y = velocity_given
    return (
        mass * (velocity_x * velocity_given_x + velocity_y * velocity_given_y)
        + inertia * angular_velocity * angular_velocity_given
    )


def energy_along_given(given_product: Scalar, change_energy: Scalar) -> Scalar:
    """Energy of the motion of bodies along what contacts gave them (J).

    energy_along_given = given_product**2/(4*change_energy)

    Args:
        given_product: Product of the motion of bodies and of what contacts gave them, weighted
            by their masses and inertias, J
        change_energy: Kinetic energy that bodies would have with a change of velocities alone,
            J

    Source: DD88, srs/models/island_energy.md:426.
    """
    return given_product * given_product / (4 * change_energy)


def energy_along_given_left(
    energy_along_given: Scalar,
    energy_surplus: Scalar,
    energy_given: Scalar,
    energy_given_all: Scalar,
) -> Scalar:
    """Energy of that motion less what is dissipated for the island (J).

    energy_along_given_left = max(energy_along_given -
    energy_surplus*energy_given/energy_given_all, 0[J])

    Args:
        energy_along_given: Energy of the motion of bodies along what contacts gave them, J
        energy_surplus: Energy that contacts have given an island in all, beyond what it may
            have, J
        energy_given: Energy that contacts have given a body in a step, negative if they took
            it, J
        energy_given_all: Energy that contacts have given those bodies of an island that got
            some, J

    Source: DD88, srs/models/island_energy.md:427.
    """
    return largest(energy_along_given - energy_surplus * energy_given / energy_given_all, 0.0)


def velocity_reduced(
    velocity: Vector,
    velocity_given: Vector,
    damped_share: Scalar,
    given_product: Scalar,
    change_energy: Scalar,
) -> Vector:
    """Velocity of a body less what is dissipated for its island (m/s).

    velocity_reduced = velocity - (1 -
    damped_share)*given_product/(2*change_energy)*velocity_given

    Args:
        velocity: Velocity of the centre of mass, m/s
        velocity_given: What contacts have changed in the velocity of a body in all substeps,
            m/s
        damped_share: Part that an island keeps of what differs in its velocities from its
            motion as one, 1
        given_product: Product of the motion of bodies and of what contacts gave them, weighted
            by their masses and inertias, J
        change_energy: Kinetic energy that bodies would have with a change of velocities alone,
            J

    Source: DD88, srs/models/island_energy.md:429.
    """
    velocity_x, velocity_y = velocity
    velocity_given_x, velocity_given_y = velocity_given
    return (
        velocity_x - (1 - damped_share) * given_product / (2 * change_energy) * velocity_given_x,
        velocity_y - (1 - damped_share) * given_product / (2 * change_energy) * velocity_given_y,
    )


def angular_velocity_reduced(
    angular_velocity: Scalar,
    angular_velocity_given: Scalar,
    damped_share: Scalar,
    given_product: Scalar,
    change_energy: Scalar,
) -> Scalar:
    """Angular velocity of a body less what is dissipated for its island (rad/s).

    angular_velocity_reduced = angular_velocity - (1 -
    damped_share)*given_product/(2*change_energy)*angular_velocity_given

    Args:
        angular_velocity: Rate of turning, positive counter-clockwise, rad/s
        angular_velocity_given: What contacts have changed in the angular velocity of a body in
            all substeps, rad/s
        damped_share: Part that an island keeps of what differs in its velocities from its
            motion as one, 1
        given_product: Product of the motion of bodies and of what contacts gave them, weighted
            by their masses and inertias, J
        change_energy: Kinetic energy that bodies would have with a change of velocities alone,
            J

    Source: DD88, srs/models/island_energy.md:431.
    """
    return (
        angular_velocity
        - (1 - damped_share) * given_product / (2 * change_energy) * angular_velocity_given
    )


def energy_given(kinetic_energy: Scalar, kinetic_energy_start: Scalar, work: Scalar) -> Scalar:
    """Energy that contacts have given a body in a step, negative if they took it (J).

    energy_given = kinetic_energy - kinetic_energy_start - work

    Args:
        kinetic_energy: Energy of motion, turning included, J
        kinetic_energy_start: Energy of motion, turning included; at the start, J
        work: Energy that gravity, forces and torques have given a body in a step, J

    Source: DD87, srs/models/island_energy.md:480.
    """
    return kinetic_energy - kinetic_energy_start - work


def rising_energy(mass: Scalar, velocity: Vector, acceleration: Vector) -> Scalar:
    """Energy of the motion of a body along the acceleration that forces give it (J).

    rising_energy = mass*dot(velocity, acceleration)**2/(2*dot(acceleration, acceleration))

    Args:
        mass: Mass of a body, kg
        velocity: Velocity of the centre of mass, m/s
        acceleration: Acceleration of the centre of mass, m/s^2

    Source: DD87, srs/models/island_energy.md:481.
    """
    velocity_x, velocity_y = velocity
    acceleration_x, acceleration_y = acceleration
    return (
        mass
        * power(velocity_x * acceleration_x + velocity_y * acceleration_y, 2)
        / (2 * (acceleration_x * acceleration_x + acceleration_y * acceleration_y))
    )


def rising_energy_left(
    rising_energy: Scalar, energy_surplus: Scalar, energy_given: Scalar, energy_given_all: Scalar
) -> Scalar:
    """Energy of that motion less what is dissipated for what is lifted (J).

    rising_energy_left = max(rising_energy - energy_surplus*energy_given/energy_given_all,
    0[J])

    Args:
        rising_energy: Energy of the motion of a body along the acceleration that forces give
            it, J
        energy_surplus: Energy that contacts have given an island in all, beyond what it may
            have, J
        energy_given: Energy that contacts have given a body in a step, negative if they took
            it, J
        energy_given_all: Energy that contacts have given those bodies of an island that got
            some, J

    Source: DD87, srs/models/island_energy.md:483.
    """
    return largest(rising_energy - energy_surplus * energy_given / energy_given_all, 0.0)


def velocity_rising_reduced(velocity: Vector, acceleration: Vector, damped_share: Scalar) -> Vector:
    """Velocity of a body less what is dissipated for what is lifted (m/s).

    velocity_rising_reduced = velocity - (1 - damped_share)*dot(velocity,
    acceleration)/dot(acceleration, acceleration)*acceleration

    Args:
        velocity: Velocity of the centre of mass, m/s
        acceleration: Acceleration of the centre of mass, m/s^2
        damped_share: Part that an island keeps of what differs in its velocities from its
            motion as one, 1

    Source: DD87, srs/models/island_energy.md:485.
    """
    velocity_x, velocity_y = velocity
    acceleration_x, acceleration_y = acceleration
    return (
        velocity_x
        - (1 - damped_share)
        * (velocity_x * acceleration_x + velocity_y * acceleration_y)
        / (acceleration_x * acceleration_x + acceleration_y * acceleration_y)
        * acceleration_x,
        velocity_y
        - (1 - damped_share)
        * (velocity_x * acceleration_x + velocity_y * acceleration_y)
        / (acceleration_x * acceleration_x + acceleration_y * acceleration_y)
        * acceleration_y,
    )


def lift_beyond_motion(energy_given: Scalar, kinetic_energy: Scalar) -> Scalar:
    """Energy that lifting a body in a step took beyond the kinetic energy that it had (J).

    lift_beyond_motion = max(energy_given - kinetic_energy, 0[J])

    Args:
        energy_given: Energy that contacts have given a body in a step, negative if they took
            it, J
        kinetic_energy: Energy of motion, turning included, J

    Source: DD89, srs/models/island_energy.md:516.
    """
    return largest(energy_given - kinetic_energy, 0.0)


def support_work(
    total_impulse: Scalar, friction: Scalar, support_rate: Scalar, support_slip: Scalar
) -> Scalar:
    """Energy that a support may have given by a contact in a step, at most (J).

    support_work = total_impulse*(max(-support_rate, 0[m/s]) + friction*abs(support_slip))

    Args:
        total_impulse: Impulse that a contact has given in a step along its normal, N*s
        friction: Coefficient of dry friction: how much of the normal force the surface can hold
            along itself, 1
        support_rate: Normal velocity of a contact by the motion of its support alone, m/s
        support_slip: Tangential velocity of a contact by the motion of its support alone, m/s

    Source: DD90, srs/models/island_energy.md:546.
    """
    return total_impulse * (largest(-support_rate, 0.0) + friction * abs(support_slip))


def moment_ahead_moved(
    moment_ahead: Scalar, velocity: Vector, velocity_change: Vector, time_step: Scalar
) -> Scalar:
    """Moment of the changes that contacts make in the velocity of a body about where its centre of
    mass was as the step began; as a body moves on in a substep (m^2/s).

    moment_ahead_moved = moment_ahead - time_step*cross(velocity, velocity_change)

    Args:
        moment_ahead: Moment of the changes that contacts make in the velocity of a body about
            where its centre of mass was as the step began, m^2/s
        velocity: Velocity of the centre of mass, m/s
        velocity_change: What contacts have changed in the velocity of a body in a substep, m/s
        time_step: Length of one step of a stepped scheme, s

    Source: DD66, srs/models/island_energy.md:603.
    """
    velocity_x, velocity_y = velocity
    velocity_change_x, velocity_change_y = velocity_change
    return moment_ahead - time_step * (
        velocity_x * velocity_change_y - velocity_y * velocity_change_x
    )


def moment_ahead_later(moment_ahead: Scalar, shift: Vector, velocity_change: Vector) -> Scalar:
    """Moment of the changes that contacts make in the velocity of a body about where its centre of
    mass was as the step began; after the bodies have moved (m^2/s).

    moment_ahead_later = moment_ahead + cross(shift, velocity_change)

    Args:
        moment_ahead: Moment of the changes that contacts make in the velocity of a body about
            where its centre of mass was as the step began, m^2/s
        shift: How far the centre of mass has moved since the step began, m
        velocity_change: What contacts have changed in the velocity of a body in a substep, m/s

    Source: DD66, srs/models/island_energy.md:604.
    """
    shift_x, shift_y = shift
    velocity_change_x, velocity_change_y = velocity_change
    return moment_ahead + shift_x * velocity_change_y - shift_y * velocity_change_x


def angular_momentum_given(
    mass: Scalar,
    position: Vector,
    velocity_given: Vector,
    moment_ahead: Scalar,
    inertia: Scalar,
    angular_velocity_given: Scalar,
) -> Scalar:
    """Angular momentum about the origin that contacts have given (kg*m^2/s).

    angular_momentum_given = mass*(cross(position, velocity_given) + moment_ahead) +
    inertia*angular_velocity_given

    Args:
        mass: Mass of a body, kg
        position: Position of the centre of mass, m
        velocity_given: What contacts have changed in the velocity of a body in all substeps,
            m/s
        moment_ahead: Moment of the changes that contacts make in the velocity of a body about
            where its centre of mass was as the step began, m^2/s
        inertia: Moment of inertia about the centre of mass, kg*m^2
        angular_velocity_given: What contacts have changed in the angular velocity of a body in
            all substeps, rad/s

    Source: DD66, srs/models/island_energy.md:605.
    """
    position_x, position_y = position
    velocity_given_x, velocity_given_y = velocity_given
    return (
        mass * (position_x * velocity_given_y - position_y * velocity_given_x + moment_ahead)
        + inertia * angular_velocity_given
    )


def angular_velocity_island_returned(
    angular_velocity_island: Scalar, angular_momentum_given: Scalar, inertia_island: Scalar
) -> Scalar:
    """Rate of turning, positive counter-clockwise; of an island as one body; with the angular
    momentum that the island had (rad/s).

    angular_velocity_island_returned = angular_velocity_island -
    angular_momentum_given/inertia_island

    Args:
        angular_velocity_island: Rate of turning, positive counter-clockwise; of an island as
            one body, rad/s
        angular_momentum_given: Angular momentum about the origin that contacts have given,
            kg*m^2/s
        inertia_island: Moment of inertia about the centre of mass; of an island as one body,
            kg*m^2

    Source: IM17, srs/models/island_energy.md:672.
    """
    return angular_velocity_island - angular_momentum_given / inertia_island


def returned_share(
    kinetic_energy: Scalar,
    kinetic_energy_least: Scalar,
    kinetic_energy_least_returned: Scalar,
    share_largest: Scalar,
) -> Scalar:
    """Factor of what differs in the velocities of an island from its motion as one, where that
    gets back its angular momentum (1).

    returned_share = min(sqrt(max(kinetic_energy - kinetic_energy_least_returned,
    0)/(kinetic_energy - kinetic_energy_least)), share_largest)

    Args:
        kinetic_energy: Energy of motion, turning included, J
        kinetic_energy_least: Energy of motion, turning included; the least that there can be, J
        kinetic_energy_least_returned: Energy of motion, turning included; the least that there
            can be; with the angular momentum that the island had, J
        share_largest: The largest factor by which motion that is left may grow, 1

    Source: IM17, srs/models/island_energy.md:674.
    """
    return least(
        sqrt(
            largest(kinetic_energy - kinetic_energy_least_returned, 0)
            / (kinetic_energy - kinetic_energy_least)
        ),
        share_largest,
    )


def velocity_returned(
    velocity: Vector,
    velocity_island: Vector,
    velocity_island_returned: Vector,
    returned_share: Scalar,
) -> Vector:
    """Velocity of the centre of mass; with the angular momentum that the island had (m/s).

    velocity_returned = velocity_island_returned + returned_share*(velocity - velocity_island)

    Args:
        velocity: Velocity of the centre of mass, m/s
        velocity_island: Velocity of the centre of mass; of an island as one body, m/s
        velocity_island_returned: Velocity of the centre of mass; of an island as one body; with
            the angular momentum that the island had, m/s
        returned_share: Factor of what differs in the velocities of an island from its motion as
            one, where that gets back its angular momentum, 1

    Source: IM17, srs/models/island_energy.md:677.
    """
    velocity_x, velocity_y = velocity
    velocity_island_x, velocity_island_y = velocity_island
    velocity_island_returned_x, velocity_island_returned_y = velocity_island_returned
    return (
        velocity_island_returned_x + returned_share * (velocity_x - velocity_island_x),
        velocity_island_returned_y + returned_share * (velocity_y - velocity_island_y),
    )


def angular_velocity_returned(
    angular_velocity: Scalar,
    angular_velocity_island: Scalar,
    angular_velocity_island_returned: Scalar,
    returned_share: Scalar,
) -> Scalar:
    """Rate of turning, positive counter-clockwise; with the angular momentum that the island had
    (rad/s).

    angular_velocity_returned = angular_velocity_island_returned +
    returned_share*(angular_velocity - angular_velocity_island)

    Args:
        angular_velocity: Rate of turning, positive counter-clockwise, rad/s
        angular_velocity_island: Rate of turning, positive counter-clockwise; of an island as
            one body, rad/s
        angular_velocity_island_returned: Rate of turning, positive counter-clockwise; of an
            island as one body; with the angular momentum that the island had, rad/s
        returned_share: Factor of what differs in the velocities of an island from its motion as
            one, where that gets back its angular momentum, 1

    Source: IM17, srs/models/island_energy.md:679.
    """
    return angular_velocity_island_returned + returned_share * (
        angular_velocity - angular_velocity_island
    )
