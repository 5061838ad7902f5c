"""Spring step: Spring through a step; Matrix of a network; Energy of a network that bounced;
Spring in a substep; Pace of a network in a substep; Forces at both ends of a step; Critical
step of a force.

Generated from srs/models/spring_step.md
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.functions import Scalar, Vector, largest, least, sqrt


def tension_held(
    stiffness: Scalar, rest_length: Scalar, distance: Scalar, distance_later: Scalar
) -> Scalar:
    """Pull of a spring and its damper, negative where it pushes; held through a step (N).

    tension_held = stiffness*((distance + distance_later)/2 - rest_length)

    Args:
        stiffness: Force of a spring for each unit of extension, N/m
        rest_length: Distance at which a spring neither pulls nor pushes, m
        distance: Distance between two places, m
        distance_later: Distance between two places; after the bodies have moved, m

    Source: IM14, srs/models/spring_step.md:44.
    """
    return stiffness * ((distance + distance_later) / 2 - rest_length)


def spring_force_held(
    tension_held: Scalar,
    damping: Scalar,
    span: Vector,
    span_later: Vector,
    distance: Scalar,
    distance_later: Scalar,
    axis: Vector,
    time_step: Scalar,
) -> Vector:
    """Force of a spring and its damper on the end at body A; held through a step (N).

    spring_force_held = tension_held*(span + span_later)/max(distance + distance_later,
    1e-150[m]) + damping*velocity_along*axis
        where velocity_along = dot(span_later - span, axis)/time_step

    Args:
        tension_held: Pull of a spring and its damper, negative where it pushes; held through a
            step, N
        damping: Force of a spring's damper for each unit of the extension's rate, kg/s
        span: Vector from one place to another, m
        span_later: Vector from one place to another; after the bodies have moved, m
        distance: Distance between two places, m
        distance_later: Distance between two places; after the bodies have moved, m
        axis: Unit vector from one end of a spring to the other, 1
        time_step: Length of one step of a stepped scheme, s

    Source: IM14, srs/models/spring_step.md:45.
    """
    span_x, span_y = span
    span_later_x, span_later_y = span_later
    axis_x, axis_y = axis
    velocity_along = (
        (span_later_x - span_x) * axis_x + (span_later_y - span_y) * axis_y
    ) / time_step
    return (
        tension_held * (span_x + span_later_x) / largest(distance + distance_later, 1e-150)
        + damping * velocity_along * axis_x,
        tension_held * (span_y + span_later_y) / largest(distance + distance_later, 1e-150)
        + damping * velocity_along * axis_y,
    )


def damping_held(damping: Scalar, stiffness: Scalar, row_mass: Scalar, time_step: Scalar) -> Scalar:
    """Force of a spring's damper for each unit of the extension's rate; held through a step
    (kg/s).

    damping_held = damping*(1 + time_step**2*stiffness/(4*row_mass))/sqrt(1 + damping_step**2)
        where damping_step = time_step*damping/(2*row_mass)

    Args:
        damping: Force of a spring's damper for each unit of the extension's rate, kg/s
        stiffness: Force of a spring for each unit of extension, N/m
        row_mass: Impulse along the line for one unit of change of the row's velocity, kg
        time_step: Length of one step of a stepped scheme, s

    Source: IM14, srs/models/spring_step.md:48.
    """
    damping_step = time_step * damping / (2 * row_mass)
    return (
        damping
        * (1 + time_step * time_step * stiffness / (4 * row_mass))
        / sqrt(1 + damping_step * damping_step)
    )


def arm_held(arm: Vector, half_turn: Scalar, half_turn_sine: Scalar) -> Vector:
    """Lever arm, from the centre of mass to the point where something acts on a body; held through
    a step (m).

    arm_held = half_turn_sine/half_turn*arm

    Args:
        arm: Lever arm, from the centre of mass to the point where something acts on a body, m
        half_turn: Half of the angle by which a body turns in a step, rad
        half_turn_sine: Sine of half of the angle by which a body turns in a step, 1

    Source: IM14, srs/models/spring_step.md:51.
    """
    arm_x, arm_y = arm
    return (half_turn_sine / half_turn * arm_x, half_turn_sine / half_turn * arm_y)


def way_resistance(mass: Scalar, propagator_lift: Scalar) -> Scalar:
    """Force by which a body resists that its way in a step is longer, over that (N/m).

    way_resistance = mass/propagator_lift

    Args:
        mass: Mass of a body, kg
        propagator_lift: Displacement in a step for one unit of acceleration, s^2

    Source: DD113, srs/models/spring_step.md:134.
    """
    return mass / propagator_lift


def turning_resistance(inertia: Scalar, propagator_lift: Scalar) -> Scalar:
    """Torque by which a body resists that it turns more in a step, over that (N*m/rad).

    turning_resistance = inertia/propagator_lift

    Args:
        inertia: Moment of inertia about the centre of mass, kg*m^2
        propagator_lift: Displacement in a step for one unit of acceleration, s^2

    Source: DD113, srs/models/spring_step.md:135.
    """
    return inertia / propagator_lift


def coordinate_missing(
    coordinate_resistance: Scalar,
    coordinate_displacement_free: Scalar,
    coordinate_displacement: Scalar,
    coordinate_pull: Scalar,
) -> Scalar:
    """What the pull of springs along one axis is more than a body resists (N).

    coordinate_missing = coordinate_resistance*(coordinate_displacement_free -
    coordinate_displacement) + coordinate_pull

    Args:
        coordinate_resistance: Force by which a body resists a longer way along one axis, over
            that, N/m
        coordinate_displacement_free: How far a body goes along one axis in a step; without
            springs, m
        coordinate_displacement: How far a body goes along one axis in a step, m
        coordinate_pull: Pull of all springs of a body along one axis, N

    Source: DD113, srs/models/spring_step.md:136.
    """
    return (
        coordinate_resistance * (coordinate_displacement_free - coordinate_displacement)
        + coordinate_pull
    )


def change_along(stiffness: Scalar, damping_held: Scalar, time_step: Scalar) -> Scalar:
    """Change of a held spring's force along its axis, over that of the way of its ends (N/m).

    change_along = stiffness/2 + damping_held/time_step

    Args:
        stiffness: Force of a spring for each unit of extension, N/m
        damping_held: Force of a spring's damper for each unit of the extension's rate; held
            through a step, kg/s
        time_step: Length of one step of a stepped scheme, s

    Source: DD113, srs/models/spring_step.md:139.
    """
    return stiffness / 2 + damping_held / time_step


def change_across(tension_held: Scalar, distance: Scalar, distance_later: Scalar) -> Scalar:
    """Change of a held spring's force across its axis, over that of the way of its ends (N/m).

    change_across = max(tension_held, 0[N])/max(distance + distance_later, 1e-150[m])

    Args:
        tension_held: Pull of a spring and its damper, negative where it pushes; held through a
            step, N
        distance: Distance between two places, m
        distance_later: Distance between two places; after the bodies have moved, m

    Source: DD113, srs/models/spring_step.md:140.
    """
    return largest(tension_held, 0.0) / largest(distance + distance_later, 1e-150)


def change_leaning(arm: Vector, spring_force_held: Vector) -> Scalar:
    """Change of a held force's torque on its arm, over that of the turn of its body (N*m).

    change_leaning = max(dot(arm, spring_force_held), 0[N*m])/2

    Args:
        arm: Lever arm, from the centre of mass to the point where something acts on a body, m
        spring_force_held: Force of a spring and its damper on the end at body A; held through a
            step, N

    Source: DD113, srs/models/spring_step.md:142.
    """
    arm_x, arm_y = arm
    spring_force_held_x, spring_force_held_y = spring_force_held
    return largest(arm_x * spring_force_held_x + arm_y * spring_force_held_y, 0.0) / 2


def spring_gain(tension_held: Scalar, distance: Scalar, distance_later: Scalar) -> Scalar:
    """Energy that a spring has gained in a step, negative if it lost it (J).

    spring_gain = tension_held*(distance_later - distance)

    Args:
        tension_held: Pull of a spring and its damper, negative where it pushes; held through a
            step, N
        distance: Distance between two places, m
        distance_later: Distance between two places; after the bodies have moved, m

    Source: DD91, srs/models/spring_step.md:184.
    """
    return tension_held * (distance_later - distance)


def energy_defect(held_work: Scalar, springs_gain: Scalar) -> Scalar:
    """Energy that the bodies of a network got beyond what its springs have lost, negative if they
    got less (J).

    energy_defect = held_work + springs_gain

    Args:
        held_work: Work of the forces that were held for the springs of a network, in a step, J
        springs_gain: Energy that all springs of a network have gained in a step, J

    Source: DD91, srs/models/spring_step.md:185.
    """
    return held_work + springs_gain


def balanced_share(
    kinetic_energy: Scalar,
    kinetic_energy_least: Scalar,
    energy_defect: Scalar,
    share_largest: Scalar,
) -> Scalar:
    """Factor by which the motion of a network is scaled, so that its energy is right (1).

    balanced_share = min(sqrt(max(kinetic_energy - kinetic_energy_least - energy_defect,
    0[J])/(kinetic_energy - kinetic_energy_least)), share_largest)

    Args:
        kinetic_energy: Energy of motion, turning included, J
        kinetic_energy_least: Energy of motion, turning included; the least that there can be, J
        energy_defect: Energy that the bodies of a network got beyond what its springs have
            lost, negative if they got less, J
        share_largest: The largest factor by which motion that is left may grow, 1

    Source: DD91, srs/models/spring_step.md:186.
    """
    return least(
        sqrt(
            largest(kinetic_energy - kinetic_energy_least - energy_defect, 0.0)
            / (kinetic_energy - kinetic_energy_least)
        ),
        share_largest,
    )


def spring_impulse(
    stiffness: Scalar, rest_length: Scalar, distance: Scalar, axis: Vector, time_step: Scalar
) -> Vector:
    """Impulse of a spring in a substep on the end at body A, at rest (N*s).

    spring_impulse = time_step*stiffness*extension*axis
        where extension = distance - rest_length

    Args:
        stiffness: Force of a spring for each unit of extension, N/m
        rest_length: Distance at which a spring neither pulls nor pushes, m
        distance: Distance between two places, m
        axis: Unit vector from one end of a spring to the other, 1
        time_step: Length of one step of a stepped scheme, s

    Source: DD52, srs/models/spring_step.md:231.
    """
    axis_x, axis_y = axis
    extension = distance - rest_length
    return (time_step * stiffness * extension * axis_x, time_step * stiffness * extension * axis_y)


def resistance_along(stiffness: Scalar, damping: Scalar, time_step: Scalar) -> Scalar:
    """Impulse by which a spring resists a velocity along its axis, over it (kg).

    resistance_along = time_step**2*stiffness + time_step*damping

    Args:
        stiffness: Force of a spring for each unit of extension, N/m
        damping: Force of a spring's damper for each unit of the extension's rate, kg/s
        time_step: Length of one step of a stepped scheme, s

    Source: DD52, srs/models/spring_step.md:232.
    """
    return time_step * time_step * stiffness + time_step * damping


def resistance_across(
    stiffness: Scalar, rest_length: Scalar, distance: Scalar, time_step: Scalar
) -> Scalar:
    """Impulse by which a spring resists a velocity across its axis, over it (kg).

    resistance_across = time_step**2*max(stiffness*extension, 0[N])/max(distance, 1e-150[m])
        where extension = distance - rest_length

    Args:
        stiffness: Force of a spring for each unit of extension, N/m
        rest_length: Distance at which a spring neither pulls nor pushes, m
        distance: Distance between two places, m
        time_step: Length of one step of a stepped scheme, s

    Source: DD52, srs/models/spring_step.md:233.
    """
    extension = distance - rest_length
    return time_step * time_step * largest(stiffness * extension, 0.0) / largest(distance, 1e-150)


def resisting_impulse(
    resistance_along: Scalar, resistance_across: Scalar, axis: Vector, end_velocity: Vector
) -> Vector:
    """Impulse on the end at body A by which a spring resists velocities (N*s).

    resisting_impulse = resistance_along*velocity_along*axis + resistance_across*(end_velocity
    - velocity_along*axis)
        where velocity_along = dot(end_velocity, axis)

    Args:
        resistance_along: Impulse by which a spring resists a velocity along its axis, over it,
            kg
        resistance_across: Impulse by which a spring resists a velocity across its axis, over
            it, kg
        axis: Unit vector from one end of a spring to the other, 1
        end_velocity: Velocity of a spring's end B as seen from its end A, m/s

    Source: DD52, srs/models/spring_step.md:237.
    """
    axis_x, axis_y = axis
    end_velocity_x, end_velocity_y = end_velocity
    velocity_along = end_velocity_x * axis_x + end_velocity_y * axis_y
    return (
        resistance_along * velocity_along * axis_x
        + resistance_across * (end_velocity_x - velocity_along * axis_x),
        resistance_along * velocity_along * axis_y
        + resistance_across * (end_velocity_y - velocity_along * axis_y),
    )


def leaning_resistance(arm: Vector, spring_impulse: Vector, time_step: Scalar) -> Scalar:
    """Angular impulse by which a spring resists that its end turns, over the turning (kg*m^2).

    leaning_resistance = time_step*max(dot(arm, spring_impulse), 0[N*s*m])

    Args:
        arm: Lever arm, from the centre of mass to the point where something acts on a body, m
        spring_impulse: Impulse of a spring in a substep on the end at body A, at rest, N*s
        time_step: Length of one step of a stepped scheme, s

    Source: DD52, srs/models/spring_step.md:240.
    """
    arm_x, arm_y = arm
    spring_impulse_x, spring_impulse_y = spring_impulse
    return time_step * largest(arm_x * spring_impulse_x + arm_y * spring_impulse_y, 0.0)


def end_yield(arm: Vector, inverse_mass: Scalar, inverse_inertia: Scalar) -> Scalar:
    """Velocity that an end of a spring gets for one unit of impulse, at most (1/kg).

    end_yield = inverse_mass + dot(arm, arm)*inverse_inertia

    Args:
        arm: Lever arm, from the centre of mass to the point where something acts on a body, m
        inverse_mass: One over the mass, zero for a static body, 1/kg
        inverse_inertia: One over the inertia, zero for a body that cannot turn, 1/(kg*m^2)

    Source: DD114, srs/models/spring_step.md:277.
    """
    arm_x, arm_y = arm
    return inverse_mass + (arm_x * arm_x + arm_y * arm_y) * inverse_inertia


def end_pace(
    resistance_along: Scalar,
    end_yield: Scalar,
    tension_held: Scalar,
    arm: Vector,
    inverse_inertia: Scalar,
    time_step: Scalar,
) -> Scalar:
    """What an end of a spring adds to the bound of the pace of its body (1).

    end_pace = 2*resistance_along*end_yield +
    time_step**2*abs(tension_held)*norm(arm)*inverse_inertia

    Args:
        resistance_along: Impulse by which a spring resists a velocity along its axis, over it,
            kg
        end_yield: Velocity that an end of a spring gets for one unit of impulse, at most, 1/kg
        tension_held: Pull of a spring and its damper, negative where it pushes; held through a
            step, N
        arm: Lever arm, from the centre of mass to the point where something acts on a body, m
        inverse_inertia: One over the inertia, zero for a body that cannot turn, 1/(kg*m^2)
        time_step: Length of one step of a stepped scheme, s

    Source: DD114, srs/models/spring_step.md:278.
    """
    arm_x, arm_y = arm
    return (
        2 * resistance_along * end_yield
        + time_step
        * time_step
        * abs(tension_held)
        * sqrt(arm_x * arm_x + arm_y * arm_y)
        * inverse_inertia
    )


def early_share(early_share_a: Scalar, early_share_b: Scalar) -> Scalar:
    """Share of half a step by which a force acts before the middle of the step, on the mean (1).

    early_share = (early_share_a + early_share_b)/2

    Args:
        early_share_a: Share of half a step by which a force acts before the middle of the step,
            on the mean; of body A, 1
        early_share_b: Share of half a step by which a force acts before the middle of the step,
            on the mean; of body B, 1

    Source: DD53, srs/models/spring_step.md:306.
    """
    return (early_share_a + early_share_b) / 2


def early_share_whole(early_share_start: Scalar, part_share: Scalar, early_share: Scalar) -> Scalar:
    """Share of half a step by which a force acts before the middle of the step, on the mean; of
    the step so far (1).

    early_share_whole = early_share_start + part_share**2*early_share

    Args:
        early_share_start: Share of half a step by which a force acts before the middle of the
            step, on the mean; at the start, 1
        part_share: Length of a part of a step, as a share of the step, 1
        early_share: Share of half a step by which a force acts before the middle of the step,
            on the mean, 1

    Source: DD53, srs/models/spring_step.md:307.
    """
    return early_share_start + part_share * part_share * early_share


def velocity_later(
    velocity: Vector,
    inverse_mass: Scalar,
    force: Vector,
    force_later: Vector,
    time_step: Scalar,
    early_share: Scalar,
) -> Vector:
    """Velocity of the centre of mass; after the bodies have moved (m/s).

    velocity_later = velocity + (1 - early_share)*time_step/2*inverse_mass*(force_later -
    force)

    Args:
        velocity: Velocity of the centre of mass, m/s
        inverse_mass: One over the mass, zero for a static body, 1/kg
        force: Applied force on a body, without its weight, N
        force_later: Applied force on a body, without its weight; after the bodies have moved, N
        time_step: Length of one step of a stepped scheme, s
        early_share: Share of half a step by which a force acts before the middle of the step,
            on the mean, 1

    Source: DD53, srs/models/spring_step.md:308.
    """
    velocity_x, velocity_y = velocity
    force_x, force_y = force
    force_later_x, force_later_y = force_later
    return (
        velocity_x + (1 - early_share) * time_step / 2 * inverse_mass * (force_later_x - force_x),
        velocity_y + (1 - early_share) * time_step / 2 * inverse_mass * (force_later_y - force_y),
    )


def angular_velocity_later(
    angular_velocity: Scalar,
    inverse_inertia: Scalar,
    torque: Scalar,
    torque_later: Scalar,
    time_step: Scalar,
    early_share: Scalar,
) -> Scalar:
    """Rate of turning, positive counter-clockwise; after the bodies have moved (rad/s).

    angular_velocity_later = angular_velocity + (1 -
    early_share)*time_step/2*inverse_inertia*(torque_later - torque)

    Args:
        angular_velocity: Rate of turning, positive counter-clockwise, rad/s
        inverse_inertia: One over the inertia, zero for a body that cannot turn, 1/(kg*m^2)
        torque: Applied torque about the centre of mass, positive counter-clockwise, N*m
        torque_later: Applied torque about the centre of mass, positive counter-clockwise; after
            the bodies have moved, N*m
        time_step: Length of one step of a stepped scheme, s
        early_share: Share of half a step by which a force acts before the middle of the step,
            on the mean, 1

    Source: DD53, srs/models/spring_step.md:311.
    """
    return angular_velocity + (1 - early_share) * time_step / 2 * inverse_inertia * (
        torque_later - torque
    )


def critical_step(
    inverse_mass: Scalar, force: Vector, force_later: Vector, shift: Vector
) -> Scalar:
    """Step from which on kicks and drifts let an oscillation grow (s).

    critical_step = 2*sqrt(norm(shift)/max(inverse_mass*norm(force_later - force),
    1e-150[m/s^2]))

    Args:
        inverse_mass: One over the mass, zero for a static body, 1/kg
        force: Applied force on a body, without its weight, N
        force_later: Applied force on a body, without its weight; after the bodies have moved, N
        shift: How far the centre of mass has moved since the step began, m

    Source: DD54, srs/models/spring_step.md:415.
    """
    force_x, force_y = force
    force_later_x, force_later_y = force_later
    shift_x, shift_y = shift
    return 2 * sqrt(
        sqrt(shift_x * shift_x + shift_y * shift_y)
        / largest(
            inverse_mass
            * sqrt(
                (force_later_x - force_x) * (force_later_x - force_x)
                + (force_later_y - force_y) * (force_later_y - force_y)
            ),
            1e-150,
        )
    )


def critical_step_turning(
    inverse_inertia: Scalar, torque: Scalar, torque_later: Scalar, turn: Scalar
) -> Scalar:
    """Step from which on kicks and drifts let an oscillation grow; with what turning adds (s).

    critical_step_turning = 2*sqrt(abs(turn)/max(inverse_inertia*abs(torque_later - torque),
    1e-150[rad/s^2]))

    Args:
        inverse_inertia: One over the inertia, zero for a body that cannot turn, 1/(kg*m^2)
        torque: Applied torque about the centre of mass, positive counter-clockwise, N*m
        torque_later: Applied torque about the centre of mass, positive counter-clockwise; after
            the bodies have moved, N*m
        turn: How far a body has turned since the step began, rad

    Source: DD54, srs/models/spring_step.md:418.
    """
    return 2 * sqrt(abs(turn) / largest(inverse_inertia * abs(torque_later - torque), 1e-150))
