"""Continuous collision: Line of a body through a step; Bend of a path through a step; Bound of
motion; Bound of closing; Passing of two circles; Conservative advancement; Reach of two
circles; Least second derivative of a gap; Gap of two shapes that turn; Way that bodies share;
Way along another body.

Generated from srs/models/continuous_collision.md
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.functions import Scalar, Vector, largest, least, sqrt


def position_later(position: Vector, shift: Vector, fraction: Scalar) -> Vector:
    """Position of the centre of mass; after the bodies have moved (m).

    position_later = position + fraction*shift

    Args:
        position: Position of the centre of mass, m
        shift: How far the centre of mass has moved since the step began, m
        fraction: Part of a step that has passed, 1

    Source: GD14, srs/models/continuous_collision.md:29.
    """
    position_x, position_y = position
    shift_x, shift_y = shift
    return (position_x + fraction * shift_x, position_y + fraction * shift_y)


def span(
    position_a: Vector, shift_a: Vector, position_b: Vector, shift_b: Vector, fraction: Scalar
) -> Vector:
    """Vector from one place to another (m).

    span = position_b - position_a + fraction*(shift_b - shift_a)

    Args:
        position_a: Position of the centre of mass; of body A, m
        shift_a: How far the centre of mass has moved since the step began; of body A, m
        position_b: Position of the centre of mass; of body B, m
        shift_b: How far the centre of mass has moved since the step began; of body B, m
        fraction: Part of a step that has passed, 1

    Source: GD14, srs/models/continuous_collision.md:30.
    """
    position_a_x, position_a_y = position_a
    shift_a_x, shift_a_y = shift_a
    position_b_x, position_b_y = position_b
    shift_b_x, shift_b_y = shift_b
    return (
        position_b_x - position_a_x + fraction * (shift_b_x - shift_a_x),
        position_b_y - position_a_y + fraction * (shift_b_y - shift_a_y),
    )


def position_redirected(position: Vector, shift_change: Vector, fraction: Scalar) -> Vector:
    """Position of the centre of mass; after the line has been redirected (m).

    position_redirected = position - fraction*shift_change

    Args:
        position: Position of the centre of mass, m
        shift_change: How far the centre of mass has moved since the step began; by which it
            changes, m
        fraction: Part of a step that has passed, 1

    Source: GD14, srs/models/continuous_collision.md:31.
    """
    position_x, position_y = position
    shift_change_x, shift_change_y = shift_change
    return (position_x - fraction * shift_change_x, position_y - fraction * shift_change_y)


def orientation_redirected(orientation: Scalar, turn_change: Scalar, fraction: Scalar) -> Scalar:
    """Angle by which the body is turned counter-clockwise from its drawn position, unbounded;
    after the line has been redirected (rad).

    orientation_redirected = orientation - fraction*turn_change

    Args:
        orientation: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded, rad
        turn_change: How far a body has turned since the step began; by which it changes, rad
        fraction: Part of a step that has passed, 1

    Source: GD14, srs/models/continuous_collision.md:32.
    """
    return orientation - fraction * turn_change


def shift_redirected(shift: Vector, shift_change: Vector) -> Vector:
    """How far the centre of mass has moved since the step began; after the line has been
    redirected (m).

    shift_redirected = shift + shift_change

    Args:
        shift: How far the centre of mass has moved since the step began, m
        shift_change: How far the centre of mass has moved since the step began; by which it
            changes, m

    Source: GD14, srs/models/continuous_collision.md:33.
    """
    shift_x, shift_y = shift
    shift_change_x, shift_change_y = shift_change
    return (shift_x + shift_change_x, shift_y + shift_change_y)


def turn_redirected(turn: Scalar, turn_change: Scalar) -> Scalar:
    """How far a body has turned since the step began; after the line has been redirected (rad).

    turn_redirected = turn + turn_change

    Args:
        turn: How far a body has turned since the step began, rad
        turn_change: How far a body has turned since the step began; by which it changes, rad

    Source: GD14, srs/models/continuous_collision.md:34.
    """
    return turn + turn_change


def coordinate_bend(
    coordinate_velocity_gain: Scalar, time_step: Scalar, fraction: Scalar
) -> Scalar:
    """How far a body is beside the chord of its path, along one axis (m).

    coordinate_bend = -coordinate_velocity_gain*time_step*fraction*(1 - fraction)/2

    Args:
        coordinate_velocity_gain: What an acceleration adds to a velocity along one axis in a
            step, m/s
        time_step: Length of one step of a stepped scheme, s
        fraction: Part of a step that has passed, 1

    Source: DD61, srs/models/continuous_collision.md:72.
    """
    return (-coordinate_velocity_gain) * time_step * fraction * (1 - fraction) / 2


def coordinate_rest_gain(
    coordinate_velocity_gain: Scalar, time_step: Scalar, fraction: Scalar
) -> Scalar:
    """What the chord of the rest of a step goes farther than that of the whole step, along one
    axis, if it were followed through a whole step (m).

    coordinate_rest_gain = coordinate_velocity_gain*time_step*fraction/2

    Args:
        coordinate_velocity_gain: What an acceleration adds to a velocity along one axis in a
            step, m/s
        time_step: Length of one step of a stepped scheme, s
        fraction: Part of a step that has passed, 1

    Source: DD61, srs/models/continuous_collision.md:74.
    """
    return coordinate_velocity_gain * time_step * fraction / 2


def coordinate_velocity_instant(
    coordinate_velocity_later: Scalar, rest_share: Scalar, coordinate_velocity_gain: Scalar
) -> Scalar:
    """Velocity along one axis; at an instant within a step (m/s).

    coordinate_velocity_instant = coordinate_velocity_later -
    rest_share*coordinate_velocity_gain

    Args:
        coordinate_velocity_later: Velocity along one axis after a step, m/s
        rest_share: Part of a step that is left, 1
        coordinate_velocity_gain: What an acceleration adds to a velocity along one axis in a
            step, m/s

    Source: DD61, srs/models/continuous_collision.md:75.
    """
    return coordinate_velocity_later - rest_share * coordinate_velocity_gain


def motion_bound(shift: Vector, turn: Scalar, extent: Scalar) -> Scalar:
    """How far any point of a body goes in a step, at most (m).

    motion_bound = abs(x(shift)) + abs(y(shift)) + abs(turn)*extent

    Args:
        shift: How far the centre of mass has moved since the step began, m
        turn: How far a body has turned since the step began, rad
        extent: How far a body reaches from its centre of mass; of two bodies, the smaller one
            does, m

    Source: DD44, srs/models/continuous_collision.md:117.
    """
    shift_x, shift_y = shift
    return abs(shift_x) + abs(shift_y) + abs(turn) * extent


def distance_bound(
    distance: Scalar, extent: Scalar, fraction: Scalar, motion_bound: Scalar
) -> Scalar:
    """Distance that two bodies may get to within a step, at most (m).

    distance_bound = distance + extent + fraction*motion_bound

    Args:
        distance: Distance between two places, m
        extent: How far a body reaches from its centre of mass; of two bodies, the smaller one
            does, m
        fraction: Part of a step that has passed, 1
        motion_bound: How far any point of a body goes in a step, at most, m

    Source: DD44, srs/models/continuous_collision.md:118.
    """
    return distance + extent + fraction * motion_bound


def closing_bound(
    separation_change: Scalar,
    turn_a: Scalar,
    extent_a: Scalar,
    turn_b: Scalar,
    extent_b: Scalar,
    width: Scalar,
    distance: Scalar,
) -> Scalar:
    """How far any points of two bodies come together in a step, at most (m).

    closing_bound = max(0, -separation_change) + abs(turn_b - turn_a)*width + (abs(turn_a) +
    abs(turn_b))*distance + (turn_a**2*extent_a + turn_b**2*extent_b)/2

    Args:
        separation_change: Distance between two bodies, negative where they overlap; by which it
            changes, m
        turn_a: How far a body has turned since the step began; of body A, rad
        extent_a: How far a body reaches from its centre of mass; of two bodies, the smaller one
            does; of body A, m
        turn_b: How far a body has turned since the step began; of body B, rad
        extent_b: How far a body reaches from its centre of mass; of two bodies, the smaller one
            does; of body B, m
        width: Extent of a box along its own x axis, m
        distance: Distance between two places, m

    Source: DD63, srs/models/continuous_collision.md:138.
    """
    return (
        largest(0, -separation_change)
        + abs(turn_b - turn_a) * width
        + (abs(turn_a) + abs(turn_b)) * distance
        + (turn_a * turn_a * extent_a + turn_b * turn_b * extent_b) / 2
    )


def miss_distance(span: Vector, shift: Vector) -> Scalar:
    """Distance at which one of two centres passes the other (m).

    miss_distance = cross(span, shift)/norm(shift)

    Args:
        span: Vector from one place to another, m
        shift: How far the centre of mass has moved since the step began, m

    Source: DD45, srs/models/continuous_collision.md:170.
    """
    span_x, span_y = span
    shift_x, shift_y = shift
    return (span_x * shift_y - span_y * shift_x) / sqrt(shift_x * shift_x + shift_y * shift_y)


def fraction_closest(span: Vector, shift: Vector) -> Scalar:
    """Part of a step that has passed; when the bodies are closest (1).

    fraction_closest = -dot(span, shift)/dot(shift, shift)

    Args:
        span: Vector from one place to another, m
        shift: How far the centre of mass has moved since the step began, m

    Source: DD45, srs/models/continuous_collision.md:171.
    """
    span_x, span_y = span
    shift_x, shift_y = shift
    return (-(span_x * shift_x + span_y * shift_y)) / (shift_x * shift_x + shift_y * shift_y)


def half_interval(extent: Scalar, miss_distance: Scalar, shift: Vector) -> Scalar:
    """Half of the part of a step for which two circles overlap (1).

    half_interval = sqrt(extent**2 - miss_distance**2)/norm(shift)

    Args:
        extent: How far a body reaches from its centre of mass; of two bodies, the smaller one
            does, m
        miss_distance: Distance at which one of two centres passes the other, m
        shift: How far the centre of mass has moved since the step began, m

    Source: DD45, srs/models/continuous_collision.md:172.
    """
    shift_x, shift_y = shift
    return sqrt(extent * extent - miss_distance * miss_distance) / sqrt(
        shift_x * shift_x + shift_y * shift_y
    )


def discriminant(
    separation: Scalar, separation_rate: Scalar, gap_acceleration_least: Scalar
) -> Scalar:
    """What has to be positive for a gap to close (m^2/s^2).

    discriminant = separation_rate**2 - 2*gap_acceleration_least*separation

    Args:
        separation: Distance between two bodies, negative where they overlap, m
        separation_rate: Rate of change of a gap, m/s
        gap_acceleration_least: Second derivative of a gap; the least that there can be, m/s^2

    Source: DD46, srs/models/continuous_collision.md:212.
    """
    return separation_rate * separation_rate - 2 * gap_acceleration_least * separation


def advance_opening(
    separation_rate: Scalar, gap_acceleration_least: Scalar, discriminant: Scalar
) -> Scalar:
    """Time for which two bodies cannot meet; of a gap that opens at first (s).

    advance_opening = (separation_rate + sqrt(discriminant))/(-gap_acceleration_least)

    Args:
        separation_rate: Rate of change of a gap, m/s
        gap_acceleration_least: Second derivative of a gap; the least that there can be, m/s^2
        discriminant: What has to be positive for a gap to close, m^2/s^2

    Source: DD46, srs/models/continuous_collision.md:213.
    """
    return (separation_rate + sqrt(discriminant)) / (-gap_acceleration_least)


def advance_closing(separation: Scalar, separation_rate: Scalar, discriminant: Scalar) -> Scalar:
    """Time for which two bodies cannot meet; of a gap that closes (s).

    advance_closing = 2*separation/(sqrt(discriminant) - separation_rate)

    Args:
        separation: Distance between two bodies, negative where they overlap, m
        separation_rate: Rate of change of a gap, m/s
        discriminant: What has to be positive for a gap to close, m^2/s^2

    Source: DD46, srs/models/continuous_collision.md:215.
    """
    return 2 * separation / (sqrt(discriminant) - separation_rate)


def reach_gap(span: Vector, extent: Scalar) -> Scalar:
    """Square of the distance of two centres less that of how far both reach (m^2).

    reach_gap = dot(span, span) - extent**2

    Args:
        span: Vector from one place to another, m
        extent: How far a body reaches from its centre of mass; of two bodies, the smaller one
            does, m

    Source: DD80, srs/models/continuous_collision.md:243.
    """
    span_x, span_y = span
    return span_x * span_x + span_y * span_y - extent * extent


def reach_gap_rate(span: Vector, span_rate: Vector) -> Scalar:
    """Rate of change of that difference (m^2/s).

    reach_gap_rate = 2*dot(span, span_rate)

    Args:
        span: Vector from one place to another, m
        span_rate: Rate of change of the vector from one place to another, m/s

    Source: DD80, srs/models/continuous_collision.md:244.
    """
    span_x, span_y = span
    span_rate_x, span_rate_y = span_rate
    return 2 * (span_x * span_rate_x + span_y * span_rate_y)


def reach_gap_acceleration(span_rate: Vector) -> Scalar:
    """Second derivative of that difference (m^2/s^2).

    reach_gap_acceleration = 2*dot(span_rate, span_rate)

    Args:
        span_rate: Rate of change of the vector from one place to another, m/s

    Source: DD80, srs/models/continuous_collision.md:245.
    """
    span_rate_x, span_rate_y = span_rate
    return 2 * (span_rate_x * span_rate_x + span_rate_y * span_rate_y)


def circling(angular_speed: Scalar, angular_acceleration: Scalar) -> Scalar:
    """Acceleration of a point of a body that turns, at most, for one unit of its distance from the
    centre (1/s^2).

    circling = angular_speed**2 + angular_acceleration

    Args:
        angular_speed: Size of the angular velocity, at most, rad/s
        angular_acceleration: Rate of change of the angular velocity, rad/s^2

    Source: DD47, srs/models/continuous_collision.md:270.
    """
    return angular_speed * angular_speed + angular_acceleration


def centre_acceleration_least(
    acceleration_a: Vector, acceleration_b: Vector, normal: Vector, deviation: Scalar
) -> Scalar:
    """Second derivative of the distance of two centres along a normal; the least that there can be
    (m/s^2).

    centre_acceleration_least = dot(acceleration_b - acceleration_a, normal) - deviation

    Args:
        acceleration_a: Acceleration of the centre of mass; of body A, m/s^2
        acceleration_b: Acceleration of the centre of mass; of body B, m/s^2
        normal: Unit normal of a contact, from body A to body B, 1
        deviation: How far the relative acceleration is from the given one, at most, m/s^2

    Source: DD47, srs/models/continuous_collision.md:271.
    """
    acceleration_a_x, acceleration_a_y = acceleration_a
    acceleration_b_x, acceleration_b_y = acceleration_b
    normal_x, normal_y = normal
    return (
        (acceleration_b_x - acceleration_a_x) * normal_x
        + (acceleration_b_y - acceleration_a_y) * normal_y
        - deviation
    )


def centre_acceleration_turning(
    circling: Scalar,
    distance: Scalar,
    angular_speed: Scalar,
    speed: Scalar,
    centre_acceleration_least: Scalar,
    turn: Scalar,
    acceleration_size: Scalar,
) -> Scalar:
    """Second derivative of the distance of two centres along a normal; with what turning adds
    (m/s^2).

    centre_acceleration_turning = centre_acceleration_least - turn*acceleration_size -
    circling*distance - 2*angular_speed*speed

    Args:
        circling: Acceleration of a point of a body that turns, at most, for one unit of its
            distance from the centre, 1/s^2
        distance: Distance between two places, m
        angular_speed: Size of the angular velocity, at most, rad/s
        speed: Size of the velocity, m/s
        centre_acceleration_least: Second derivative of the distance of two centres along a
            normal; the least that there can be, m/s^2
        turn: How far a body has turned since the step began, rad
        acceleration_size: Size of the relative acceleration of two bodies, at most, m/s^2

    Source: DD47, srs/models/continuous_collision.md:273.
    """
    return (
        centre_acceleration_least
        - turn * acceleration_size
        - circling * distance
        - 2 * angular_speed * speed
    )


def gap_acceleration_least(
    centre_acceleration_least: Scalar,
    extent_a: Scalar,
    circling_a: Scalar,
    extent_b: Scalar,
    circling_b: Scalar,
) -> Scalar:
    """Second derivative of a gap; the least that there can be (m/s^2).

    gap_acceleration_least = centre_acceleration_least - extent_a*circling_a -
    extent_b*circling_b

    Args:
        centre_acceleration_least: Second derivative of the distance of two centres along a
            normal; the least that there can be, m/s^2
        extent_a: How far a body reaches from its centre of mass; of two bodies, the smaller one
            does; of body A, m
        circling_a: Acceleration of a point of a body that turns, at most, for one unit of its
            distance from the centre; of body A, 1/s^2
        extent_b: How far a body reaches from its centre of mass; of two bodies, the smaller one
            does; of body B, m
        circling_b: Acceleration of a point of a body that turns, at most, for one unit of its
            distance from the centre; of body B, 1/s^2

    Source: DD47, srs/models/continuous_collision.md:276.
    """
    return centre_acceleration_least - extent_a * circling_a - extent_b * circling_b


def normal_turned(normal: Vector, turn: Scalar, fraction: Scalar) -> Vector:
    """Unit normal of a contact, from body A to body B; turned back by the angle of its body (1).

    normal_turned = normal - cross(fraction*turn, normal)

    Args:
        normal: Unit normal of a contact, from body A to body B, 1
        turn: How far a body has turned since the step began, rad
        fraction: Part of a step that has passed, 1

    Source: DD48, srs/models/continuous_collision.md:315.
    """
    normal_x, normal_y = normal
    return (normal_x + fraction * turn * normal_y, normal_y - fraction * turn * normal_x)


def gap_change(shift: Vector, normal: Vector, turn: Scalar, span: Vector) -> Scalar:
    """Change of a gap in a whole step, if it went on as it does (m).

    gap_change = dot(shift, normal) + turn*cross(normal, span)

    Args:
        shift: How far the centre of mass has moved since the step began, m
        normal: Unit normal of a contact, from body A to body B, 1
        turn: How far a body has turned since the step began, rad
        span: Vector from one place to another, m

    Source: DD48, srs/models/continuous_collision.md:316.
    """
    shift_x, shift_y = shift
    normal_x, normal_y = normal
    span_x, span_y = span
    return shift_x * normal_x + shift_y * normal_y + turn * (normal_x * span_y - normal_y * span_x)


def arc_bend(turn: Scalar, extent: Scalar) -> Scalar:
    """Second derivative of a gap from corners that circle, with time in steps (m).

    arc_bend = turn**2*extent

    Args:
        turn: How far a body has turned since the step began, rad
        extent: How far a body reaches from its centre of mass; of two bodies, the smaller one
            does, m

    Source: DD48, srs/models/continuous_collision.md:317.
    """
    return turn * turn * extent


def separation_least(
    base_gap: Scalar,
    corner_gap_a: Scalar,
    corner_gap_b: Scalar,
    gap_change: Scalar,
    arc_bend: Scalar,
    fraction: Scalar,
) -> Scalar:
    """Distance between two bodies, negative where they overlap; the least that there can be (m).

    separation_least = base_gap + corner_gap_a + corner_gap_b + fraction*(gap_change -
    fraction*arc_bend/2)

    Args:
        base_gap: Gap of two centres along a normal, less the radii, m
        corner_gap_a: How far the nearest corner of a body is from its centre along a normal,
            less than zero where it is nearer to the other body; of body A, m
        corner_gap_b: How far the nearest corner of a body is from its centre along a normal,
            less than zero where it is nearer to the other body; of body B, m
        gap_change: Change of a gap in a whole step, if it went on as it does, m
        arc_bend: Second derivative of a gap from corners that circle, with time in steps, m
        fraction: Part of a step that has passed, 1

    Source: DD48, srs/models/continuous_collision.md:318.
    """
    return (
        base_gap + corner_gap_a + corner_gap_b + fraction * (gap_change - fraction * arc_bend / 2)
    )


def shift_shared(mass_a: Scalar, shift_a: Vector, mass_b: Scalar, shift_b: Vector) -> Vector:
    """How far the centre of mass has moved since the step began; of bodies that go on together
    (m).

    shift_shared = (mass_a*shift_a + mass_b*shift_b)/(mass_a + mass_b)

    Args:
        mass_a: Mass of a body; of body A, kg
        shift_a: How far the centre of mass has moved since the step began; of body A, m
        mass_b: Mass of a body; of body B, kg
        shift_b: How far the centre of mass has moved since the step began; of body B, m

    Source: DD62, srs/models/continuous_collision.md:526.
    """
    shift_a_x, shift_a_y = shift_a
    shift_b_x, shift_b_y = shift_b
    return (
        (mass_a * shift_a_x + mass_b * shift_b_x) / (mass_a + mass_b),
        (mass_a * shift_a_y + mass_b * shift_b_y) / (mass_a + mass_b),
    )


def inward_share(turn: Scalar, fraction: Scalar, arc: Scalar) -> Scalar:
    """Part of its distance by which a carried body comes nearer to its carrier (1).

    inward_share = abs(turn)*min(abs(turn)*(1 - fraction), arc/2)

    Args:
        turn: How far a body has turned since the step began, rad
        fraction: Part of a step that has passed, 1
        arc: Angle by which a wall turns before a body that it carries meets it again, rad

    Source: DD49, srs/models/continuous_collision.md:541.
    """
    return abs(turn) * least(abs(turn) * (1 - fraction), arc / 2)


def shift_carried(shift: Vector, turn: Scalar, span: Vector, inward_share: Scalar) -> Vector:
    """How far the centre of mass has moved since the step began; along another body (m).

    shift_carried = shift + cross(turn, span) - inward_share*span

    Args:
        shift: How far the centre of mass has moved since the step began, m
        turn: How far a body has turned since the step began, rad
        span: Vector from one place to another, m
        inward_share: Part of its distance by which a carried body comes nearer to its carrier,
            1

    Source: DD49, srs/models/continuous_collision.md:542.
    """
    shift_x, shift_y = shift
    span_x, span_y = span
    return (
        shift_x - turn * span_y - inward_share * span_x,
        shift_y + turn * span_x - inward_share * span_y,
    )
