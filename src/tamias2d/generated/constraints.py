"""Constraints: Revolute joint; Distance joint; Weld; Prismatic joint; Groove; Gear; Pulley;
Angle between two bodies; Travel along a line.

Generated from srs/models/joints.md
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.constraint_functions import ConstraintFunctions, Formula
from tamias2d.spec.functions import Scalar, Vector, cos, sin, sqrt


def revolute_constraint(
    anchor_a: Vector,
    anchor_b: Vector,
    position_a: Vector,
    orientation_a: Scalar,
    position_b: Vector,
    orientation_b: Scalar,
) -> tuple[Scalar, ...]:
    """Revolute joint: zero where it holds.

    x(span)
    y(span)
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where span = position_b + arm_b - position_a - arm_a

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        position_a: Position of the centre of mass; of body A, m
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        position_b: Position of the centre of mass; of body B, m
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad

    Source: revolute, srs/models/joints.md:227.
    """
    anchor_a_x, anchor_a_y = anchor_a
    anchor_b_x, anchor_b_y = anchor_b
    position_a_x, position_a_y = position_a
    position_b_x, position_b_y = position_b
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    return (
        span_x,
        span_y,
    )


def revolute_slopes_a(
    anchor_a: Vector,
    orientation_a: Scalar,
) -> tuple[Scalar, ...]:
    """Revolute joint: slopes by x, y and orientation of body A.

    -1
    0
    y(arm_a)
    0
    -1
    -x(arm_a)
        where arm_a = rotate(anchor_a, orientation_a)

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad

    Source: revolute, srs/models/joints.md:227.
    """
    anchor_a_x, anchor_a_y = anchor_a
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    return (
        -1,
        0,
        arm_a_y,
        0,
        -1,
        -arm_a_x,
    )


def revolute_slopes_b(
    anchor_b: Vector,
    orientation_b: Scalar,
) -> tuple[Scalar, ...]:
    """Revolute joint: slopes by x, y and orientation of body B.

    1
    0
    -y(arm_b)
    0
    1
    x(arm_b)
        where arm_b = rotate(anchor_b, orientation_b)

    Args:
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad

    Source: revolute, srs/models/joints.md:227.
    """
    anchor_b_x, anchor_b_y = anchor_b
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    return (
        1,
        0,
        -arm_b_y,
        0,
        1,
        arm_b_x,
    )


def revolute_rate(
    anchor_a: Vector,
    anchor_b: Vector,
    velocity_a: Vector,
    orientation_a: Scalar,
    angular_velocity_a: Scalar,
    velocity_b: Vector,
    orientation_b: Scalar,
    angular_velocity_b: Scalar,
) -> tuple[Scalar, ...]:
    """Revolute joint: rate of the constraint along the motion.

    x(span_rate)
    y(span_rate)
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where arm_a_rate = angular_velocity_a*perp(arm_a)
        where arm_b_rate = angular_velocity_b*perp(arm_b)
        where span_rate = velocity_b + arm_b_rate - velocity_a - arm_a_rate

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        velocity_a: Velocity of the centre of mass; of body A, m/s
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        velocity_b: Velocity of the centre of mass; of body B, m/s
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s

    Source: revolute, srs/models/joints.md:227.
    """
    anchor_a_x, anchor_a_y = anchor_a
    anchor_b_x, anchor_b_y = anchor_b
    velocity_a_x, velocity_a_y = velocity_a
    velocity_b_x, velocity_b_y = velocity_b
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    arm_a_rate_x, arm_a_rate_y = (angular_velocity_a * (-arm_a_y), angular_velocity_a * (arm_a_x))
    arm_b_rate_x, arm_b_rate_y = (angular_velocity_b * (-arm_b_y), angular_velocity_b * (arm_b_x))
    span_rate_x, span_rate_y = (
        velocity_b_x + arm_b_rate_x - velocity_a_x - arm_a_rate_x,
        velocity_b_y + arm_b_rate_y - velocity_a_y - arm_a_rate_y,
    )
    return (
        span_rate_x,
        span_rate_y,
    )


def revolute_convective(
    anchor_a: Vector,
    anchor_b: Vector,
    orientation_a: Scalar,
    angular_velocity_a: Scalar,
    orientation_b: Scalar,
    angular_velocity_b: Scalar,
) -> tuple[Scalar, ...]:
    """Revolute joint: second derivative of the constraint where no body is accelerated.

    x(span_rate_rate)
    y(span_rate_rate)
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where arm_a_rate = angular_velocity_a*perp(arm_a)
        where arm_b_rate = angular_velocity_b*perp(arm_b)
        where arm_a_rate_rate = angular_velocity_a*perp(arm_a_rate)
        where arm_b_rate_rate = angular_velocity_b*perp(arm_b_rate)
        where span_rate_rate = arm_b_rate_rate - arm_a_rate_rate

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s

    Source: revolute, srs/models/joints.md:227.
    """
    anchor_a_x, anchor_a_y = anchor_a
    anchor_b_x, anchor_b_y = anchor_b
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    arm_a_rate_x, arm_a_rate_y = (angular_velocity_a * (-arm_a_y), angular_velocity_a * (arm_a_x))
    arm_b_rate_x, arm_b_rate_y = (angular_velocity_b * (-arm_b_y), angular_velocity_b * (arm_b_x))
    arm_a_rate_rate_x, arm_a_rate_rate_y = (
        angular_velocity_a * (-arm_a_rate_y),
        angular_velocity_a * (arm_a_rate_x),
    )
    arm_b_rate_rate_x, arm_b_rate_rate_y = (
        angular_velocity_b * (-arm_b_rate_y),
        angular_velocity_b * (arm_b_rate_x),
    )
    span_rate_rate_x, span_rate_rate_y = (
        arm_b_rate_rate_x - arm_a_rate_rate_x,
        arm_b_rate_rate_y - arm_a_rate_rate_y,
    )
    return (
        span_rate_rate_x,
        span_rate_rate_y,
    )


def distance_constraint(
    anchor_a: Vector,
    anchor_b: Vector,
    joint_length: Scalar,
    position_a: Vector,
    orientation_a: Scalar,
    position_b: Vector,
    orientation_b: Scalar,
) -> tuple[Scalar, ...]:
    """Distance joint: zero where it holds.

    distance - joint_length
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where span = position_b + arm_b - position_a - arm_a
        where distance = norm(span)

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        joint_length: Length that a joint keeps, m
        position_a: Position of the centre of mass; of body A, m
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        position_b: Position of the centre of mass; of body B, m
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad

    Source: distance, srs/models/joints.md:241.
    """
    anchor_a_x, anchor_a_y = anchor_a
    anchor_b_x, anchor_b_y = anchor_b
    position_a_x, position_a_y = position_a
    position_b_x, position_b_y = position_b
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    distance = sqrt(span_x * span_x + span_y * span_y)
    return (distance - joint_length,)


def distance_slopes_a(
    anchor_a: Vector,
    anchor_b: Vector,
    position_a: Vector,
    orientation_a: Scalar,
    position_b: Vector,
    orientation_b: Scalar,
) -> tuple[Scalar, ...]:
    """Distance joint: slopes by x, y and orientation of body A.

    -x(span)/distance
    -y(span)/distance
    -dot(perp(arm_a), span)/distance
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where span = position_b + arm_b - position_a - arm_a
        where distance = norm(span)

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        position_a: Position of the centre of mass; of body A, m
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        position_b: Position of the centre of mass; of body B, m
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad

    Source: distance, srs/models/joints.md:241.
    """
    anchor_a_x, anchor_a_y = anchor_a
    anchor_b_x, anchor_b_y = anchor_b
    position_a_x, position_a_y = position_a
    position_b_x, position_b_y = position_b
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    distance = sqrt(span_x * span_x + span_y * span_y)
    return (
        (-span_x) / distance,
        (-span_y) / distance,
        (-((-arm_a_y) * span_x + (arm_a_x) * span_y)) / distance,
    )


def distance_slopes_b(
    anchor_a: Vector,
    anchor_b: Vector,
    position_a: Vector,
    orientation_a: Scalar,
    position_b: Vector,
    orientation_b: Scalar,
) -> tuple[Scalar, ...]:
    """Distance joint: slopes by x, y and orientation of body B.

    x(span)/distance
    y(span)/distance
    dot(span, perp(arm_b))/distance
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where span = position_b + arm_b - position_a - arm_a
        where distance = norm(span)

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        position_a: Position of the centre of mass; of body A, m
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        position_b: Position of the centre of mass; of body B, m
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad

    Source: distance, srs/models/joints.md:241.
    """
    anchor_a_x, anchor_a_y = anchor_a
    anchor_b_x, anchor_b_y = anchor_b
    position_a_x, position_a_y = position_a
    position_b_x, position_b_y = position_b
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    distance = sqrt(span_x * span_x + span_y * span_y)
    return (
        span_x / distance,
        span_y / distance,
        (span_x * (-arm_b_y) + span_y * (arm_b_x)) / distance,
    )


def distance_rate(
    anchor_a: Vector,
    anchor_b: Vector,
    position_a: Vector,
    velocity_a: Vector,
    orientation_a: Scalar,
    angular_velocity_a: Scalar,
    position_b: Vector,
    velocity_b: Vector,
    orientation_b: Scalar,
    angular_velocity_b: Scalar,
) -> tuple[Scalar, ...]:
    """Distance joint: rate of the constraint along the motion.

    distance_rate
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where span = position_b + arm_b - position_a - arm_a
        where distance = norm(span)
        where arm_a_rate = angular_velocity_a*perp(arm_a)
        where arm_b_rate = angular_velocity_b*perp(arm_b)
        where span_rate = velocity_b + arm_b_rate - velocity_a - arm_a_rate
        where distance_rate = dot(span, span_rate)/distance

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        position_a: Position of the centre of mass; of body A, m
        velocity_a: Velocity of the centre of mass; of body A, m/s
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        position_b: Position of the centre of mass; of body B, m
        velocity_b: Velocity of the centre of mass; of body B, m/s
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s

    Source: distance, srs/models/joints.md:241.
    """
    anchor_a_x, anchor_a_y = anchor_a
    anchor_b_x, anchor_b_y = anchor_b
    position_a_x, position_a_y = position_a
    velocity_a_x, velocity_a_y = velocity_a
    position_b_x, position_b_y = position_b
    velocity_b_x, velocity_b_y = velocity_b
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    distance = sqrt(span_x * span_x + span_y * span_y)
    arm_a_rate_x, arm_a_rate_y = (angular_velocity_a * (-arm_a_y), angular_velocity_a * (arm_a_x))
    arm_b_rate_x, arm_b_rate_y = (angular_velocity_b * (-arm_b_y), angular_velocity_b * (arm_b_x))
    span_rate_x, span_rate_y = (
        velocity_b_x + arm_b_rate_x - velocity_a_x - arm_a_rate_x,
        velocity_b_y + arm_b_rate_y - velocity_a_y - arm_a_rate_y,
    )
    distance_rate = (span_x * span_rate_x + span_y * span_rate_y) / distance
    return (distance_rate,)


def distance_convective(
    anchor_a: Vector,
    anchor_b: Vector,
    position_a: Vector,
    velocity_a: Vector,
    orientation_a: Scalar,
    angular_velocity_a: Scalar,
    position_b: Vector,
    velocity_b: Vector,
    orientation_b: Scalar,
    angular_velocity_b: Scalar,
) -> tuple[Scalar, ...]:
    """Distance joint: second derivative of the constraint where no body is accelerated.

    distance_rate_rate
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where span = position_b + arm_b - position_a - arm_a
        where distance = norm(span)
        where arm_a_rate = angular_velocity_a*perp(arm_a)
        where arm_b_rate = angular_velocity_b*perp(arm_b)
        where span_rate = velocity_b + arm_b_rate - velocity_a - arm_a_rate
        where distance_rate = dot(span, span_rate)/distance
        where arm_a_rate_rate = angular_velocity_a*perp(arm_a_rate)
        where arm_b_rate_rate = angular_velocity_b*perp(arm_b_rate)
        where span_rate_rate = arm_b_rate_rate - arm_a_rate_rate
        where distance_rate_rate = (dot(span_rate, span_rate) + dot(span,
            span_rate_rate))/distance - dot(span, span_rate)*distance_rate/distance**2

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        position_a: Position of the centre of mass; of body A, m
        velocity_a: Velocity of the centre of mass; of body A, m/s
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        position_b: Position of the centre of mass; of body B, m
        velocity_b: Velocity of the centre of mass; of body B, m/s
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s

    Source: distance, srs/models/joints.md:241.
    """
    anchor_a_x, anchor_a_y = anchor_a
    anchor_b_x, anchor_b_y = anchor_b
    position_a_x, position_a_y = position_a
    velocity_a_x, velocity_a_y = velocity_a
    position_b_x, position_b_y = position_b
    velocity_b_x, velocity_b_y = velocity_b
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    distance = sqrt(span_x * span_x + span_y * span_y)
    arm_a_rate_x, arm_a_rate_y = (angular_velocity_a * (-arm_a_y), angular_velocity_a * (arm_a_x))
    arm_b_rate_x, arm_b_rate_y = (angular_velocity_b * (-arm_b_y), angular_velocity_b * (arm_b_x))
    span_rate_x, span_rate_y = (
        velocity_b_x + arm_b_rate_x - velocity_a_x - arm_a_rate_x,
        velocity_b_y + arm_b_rate_y - velocity_a_y - arm_a_rate_y,
    )
    distance_rate = (span_x * span_rate_x + span_y * span_rate_y) / distance
    arm_a_rate_rate_x, arm_a_rate_rate_y = (
        angular_velocity_a * (-arm_a_rate_y),
        angular_velocity_a * (arm_a_rate_x),
    )
    arm_b_rate_rate_x, arm_b_rate_rate_y = (
        angular_velocity_b * (-arm_b_rate_y),
        angular_velocity_b * (arm_b_rate_x),
    )
    span_rate_rate_x, span_rate_rate_y = (
        arm_b_rate_rate_x - arm_a_rate_rate_x,
        arm_b_rate_rate_y - arm_a_rate_rate_y,
    )
    distance_rate_rate = (
        span_rate_x * span_rate_x
        + span_rate_y * span_rate_y
        + span_x * span_rate_rate_x
        + span_y * span_rate_rate_y
    ) / distance - (span_x * span_rate_x + span_y * span_rate_y) * distance_rate / (
        distance * distance
    )
    return (distance_rate_rate,)


def weld_constraint(
    anchor_a: Vector,
    anchor_b: Vector,
    joint_angle: Scalar,
    position_a: Vector,
    orientation_a: Scalar,
    position_b: Vector,
    orientation_b: Scalar,
) -> tuple[Scalar, ...]:
    """Weld: zero where it holds.

    x(span)
    y(span)
    orientation_b - orientation_a - joint_angle
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where span = position_b + arm_b - position_a - arm_a

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        joint_angle: Angle that a joint keeps between two bodies, rad
        position_a: Position of the centre of mass; of body A, m
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        position_b: Position of the centre of mass; of body B, m
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad

    Source: weld, srs/models/joints.md:258.
    """
    anchor_a_x, anchor_a_y = anchor_a
    anchor_b_x, anchor_b_y = anchor_b
    position_a_x, position_a_y = position_a
    position_b_x, position_b_y = position_b
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    return (
        span_x,
        span_y,
        orientation_b - orientation_a - joint_angle,
    )


def weld_slopes_a(
    anchor_a: Vector,
    orientation_a: Scalar,
) -> tuple[Scalar, ...]:
    """Weld: slopes by x, y and orientation of body A.

    -1
    0
    y(arm_a)
    0
    -1
    -x(arm_a)
    0
    0
    -1
        where arm_a = rotate(anchor_a, orientation_a)

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad

    Source: weld, srs/models/joints.md:258.
    """
    anchor_a_x, anchor_a_y = anchor_a
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    return (
        -1,
        0,
        arm_a_y,
        0,
        -1,
        -arm_a_x,
        0,
        0,
        -1,
    )


def weld_slopes_b(
    anchor_b: Vector,
    orientation_b: Scalar,
) -> tuple[Scalar, ...]:
    """Weld: slopes by x, y and orientation of body B.

    1
    0
    -y(arm_b)
    0
    1
    x(arm_b)
    0
    0
    1
        where arm_b = rotate(anchor_b, orientation_b)

    Args:
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad

    Source: weld, srs/models/joints.md:258.
    """
    anchor_b_x, anchor_b_y = anchor_b
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    return (
        1,
        0,
        -arm_b_y,
        0,
        1,
        arm_b_x,
        0,
        0,
        1,
    )


def weld_rate(
    anchor_a: Vector,
    anchor_b: Vector,
    velocity_a: Vector,
    orientation_a: Scalar,
    angular_velocity_a: Scalar,
    velocity_b: Vector,
    orientation_b: Scalar,
    angular_velocity_b: Scalar,
) -> tuple[Scalar, ...]:
    """Weld: rate of the constraint along the motion.

    x(span_rate)
    y(span_rate)
    angular_velocity_b - angular_velocity_a
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where arm_a_rate = angular_velocity_a*perp(arm_a)
        where arm_b_rate = angular_velocity_b*perp(arm_b)
        where span_rate = velocity_b + arm_b_rate - velocity_a - arm_a_rate

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        velocity_a: Velocity of the centre of mass; of body A, m/s
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        velocity_b: Velocity of the centre of mass; of body B, m/s
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s

    Source: weld, srs/models/joints.md:258.
    """
    anchor_a_x, anchor_a_y = anchor_a
    anchor_b_x, anchor_b_y = anchor_b
    velocity_a_x, velocity_a_y = velocity_a
    velocity_b_x, velocity_b_y = velocity_b
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    arm_a_rate_x, arm_a_rate_y = (angular_velocity_a * (-arm_a_y), angular_velocity_a * (arm_a_x))
    arm_b_rate_x, arm_b_rate_y = (angular_velocity_b * (-arm_b_y), angular_velocity_b * (arm_b_x))
    span_rate_x, span_rate_y = (
        velocity_b_x + arm_b_rate_x - velocity_a_x - arm_a_rate_x,
        velocity_b_y + arm_b_rate_y - velocity_a_y - arm_a_rate_y,
    )
    return (
        span_rate_x,
        span_rate_y,
        angular_velocity_b - angular_velocity_a,
    )


def weld_convective(
    anchor_a: Vector,
    anchor_b: Vector,
    orientation_a: Scalar,
    angular_velocity_a: Scalar,
    orientation_b: Scalar,
    angular_velocity_b: Scalar,
) -> tuple[Scalar, ...]:
    """Weld: second derivative of the constraint where no body is accelerated.

    x(span_rate_rate)
    y(span_rate_rate)
    0
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where arm_a_rate = angular_velocity_a*perp(arm_a)
        where arm_b_rate = angular_velocity_b*perp(arm_b)
        where arm_a_rate_rate = angular_velocity_a*perp(arm_a_rate)
        where arm_b_rate_rate = angular_velocity_b*perp(arm_b_rate)
        where span_rate_rate = arm_b_rate_rate - arm_a_rate_rate

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s

    Source: weld, srs/models/joints.md:258.
    """
    anchor_a_x, anchor_a_y = anchor_a
    anchor_b_x, anchor_b_y = anchor_b
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    arm_a_rate_x, arm_a_rate_y = (angular_velocity_a * (-arm_a_y), angular_velocity_a * (arm_a_x))
    arm_b_rate_x, arm_b_rate_y = (angular_velocity_b * (-arm_b_y), angular_velocity_b * (arm_b_x))
    arm_a_rate_rate_x, arm_a_rate_rate_y = (
        angular_velocity_a * (-arm_a_rate_y),
        angular_velocity_a * (arm_a_rate_x),
    )
    arm_b_rate_rate_x, arm_b_rate_rate_y = (
        angular_velocity_b * (-arm_b_rate_y),
        angular_velocity_b * (arm_b_rate_x),
    )
    span_rate_rate_x, span_rate_rate_y = (
        arm_b_rate_rate_x - arm_a_rate_rate_x,
        arm_b_rate_rate_y - arm_a_rate_rate_y,
    )
    return (
        span_rate_rate_x,
        span_rate_rate_y,
        0,
    )


def prismatic_constraint(
    anchor_a: Vector,
    guide_a: Vector,
    anchor_b: Vector,
    joint_angle: Scalar,
    position_a: Vector,
    orientation_a: Scalar,
    position_b: Vector,
    orientation_b: Scalar,
) -> tuple[Scalar, ...]:
    """Prismatic joint: zero where it holds.

    dot(perp(guide), span)
    orientation_b - orientation_a - joint_angle
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where guide = rotate(guide_a, orientation_a)
        where span = position_b + arm_b - position_a - arm_a

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        guide_a: Unit vector along which a joint lets a body slide; of body A, 1
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        joint_angle: Angle that a joint keeps between two bodies, rad
        position_a: Position of the centre of mass; of body A, m
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        position_b: Position of the centre of mass; of body B, m
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad

    Source: prismatic, srs/models/joints.md:271.
    """
    anchor_a_x, anchor_a_y = anchor_a
    guide_a_x, guide_a_y = guide_a
    anchor_b_x, anchor_b_y = anchor_b
    position_a_x, position_a_y = position_a
    position_b_x, position_b_y = position_b
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    guide_x, guide_y = (
        cos(orientation_a) * guide_a_x - sin(orientation_a) * guide_a_y,
        sin(orientation_a) * guide_a_x + cos(orientation_a) * guide_a_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    return (
        (-guide_y) * span_x + (guide_x) * span_y,
        orientation_b - orientation_a - joint_angle,
    )


def prismatic_slopes_a(
    anchor_a: Vector,
    guide_a: Vector,
    anchor_b: Vector,
    position_a: Vector,
    orientation_a: Scalar,
    position_b: Vector,
    orientation_b: Scalar,
) -> tuple[Scalar, ...]:
    """Prismatic joint: slopes by x, y and orientation of body A.

    y(guide)
    -x(guide)
    -dot(guide, span) - dot(arm_a, guide)
    0
    0
    -1
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where guide = rotate(guide_a, orientation_a)
        where span = position_b + arm_b - position_a - arm_a

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        guide_a: Unit vector along which a joint lets a body slide; of body A, 1
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        position_a: Position of the centre of mass; of body A, m
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        position_b: Position of the centre of mass; of body B, m
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad

    Source: prismatic, srs/models/joints.md:271.
    """
    anchor_a_x, anchor_a_y = anchor_a
    guide_a_x, guide_a_y = guide_a
    anchor_b_x, anchor_b_y = anchor_b
    position_a_x, position_a_y = position_a
    position_b_x, position_b_y = position_b
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    guide_x, guide_y = (
        cos(orientation_a) * guide_a_x - sin(orientation_a) * guide_a_y,
        sin(orientation_a) * guide_a_x + cos(orientation_a) * guide_a_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    return (
        guide_y,
        -guide_x,
        -(guide_x * span_x + guide_y * span_y) - (arm_a_x * guide_x + arm_a_y * guide_y),
        0,
        0,
        -1,
    )


def prismatic_slopes_b(
    guide_a: Vector,
    anchor_b: Vector,
    orientation_a: Scalar,
    orientation_b: Scalar,
) -> tuple[Scalar, ...]:
    """Prismatic joint: slopes by x, y and orientation of body B.

    -y(guide)
    x(guide)
    dot(guide, arm_b)
    0
    0
    1
        where arm_b = rotate(anchor_b, orientation_b)
        where guide = rotate(guide_a, orientation_a)

    Args:
        guide_a: Unit vector along which a joint lets a body slide; of body A, 1
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad

    Source: prismatic, srs/models/joints.md:271.
    """
    guide_a_x, guide_a_y = guide_a
    anchor_b_x, anchor_b_y = anchor_b
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    guide_x, guide_y = (
        cos(orientation_a) * guide_a_x - sin(orientation_a) * guide_a_y,
        sin(orientation_a) * guide_a_x + cos(orientation_a) * guide_a_y,
    )
    return (
        -guide_y,
        guide_x,
        guide_x * arm_b_x + guide_y * arm_b_y,
        0,
        0,
        1,
    )


def prismatic_rate(
    anchor_a: Vector,
    guide_a: Vector,
    anchor_b: Vector,
    position_a: Vector,
    velocity_a: Vector,
    orientation_a: Scalar,
    angular_velocity_a: Scalar,
    position_b: Vector,
    velocity_b: Vector,
    orientation_b: Scalar,
    angular_velocity_b: Scalar,
) -> tuple[Scalar, ...]:
    """Prismatic joint: rate of the constraint along the motion.

    dot(perp(guide_rate), span) + dot(perp(guide), span_rate)
    angular_velocity_b - angular_velocity_a
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where guide = rotate(guide_a, orientation_a)
        where span = position_b + arm_b - position_a - arm_a
        where arm_a_rate = angular_velocity_a*perp(arm_a)
        where arm_b_rate = angular_velocity_b*perp(arm_b)
        where guide_rate = angular_velocity_a*perp(guide)
        where span_rate = velocity_b + arm_b_rate - velocity_a - arm_a_rate

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        guide_a: Unit vector along which a joint lets a body slide; of body A, 1
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        position_a: Position of the centre of mass; of body A, m
        velocity_a: Velocity of the centre of mass; of body A, m/s
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        position_b: Position of the centre of mass; of body B, m
        velocity_b: Velocity of the centre of mass; of body B, m/s
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s

    Source: prismatic, srs/models/joints.md:271.
    """
    anchor_a_x, anchor_a_y = anchor_a
    guide_a_x, guide_a_y = guide_a
    anchor_b_x, anchor_b_y = anchor_b
    position_a_x, position_a_y = position_a
    velocity_a_x, velocity_a_y = velocity_a
    position_b_x, position_b_y = position_b
    velocity_b_x, velocity_b_y = velocity_b
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    guide_x, guide_y = (
        cos(orientation_a) * guide_a_x - sin(orientation_a) * guide_a_y,
        sin(orientation_a) * guide_a_x + cos(orientation_a) * guide_a_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    arm_a_rate_x, arm_a_rate_y = (angular_velocity_a * (-arm_a_y), angular_velocity_a * (arm_a_x))
    arm_b_rate_x, arm_b_rate_y = (angular_velocity_b * (-arm_b_y), angular_velocity_b * (arm_b_x))
    guide_rate_x, guide_rate_y = (angular_velocity_a * (-guide_y), angular_velocity_a * (guide_x))
    span_rate_x, span_rate_y = (
        velocity_b_x + arm_b_rate_x - velocity_a_x - arm_a_rate_x,
        velocity_b_y + arm_b_rate_y - velocity_a_y - arm_a_rate_y,
    )
    return (
        (-guide_rate_y) * span_x
        + (guide_rate_x) * span_y
        + (-guide_y) * span_rate_x
        + (guide_x) * span_rate_y,
        angular_velocity_b - angular_velocity_a,
    )


def prismatic_convective(
    anchor_a: Vector,
    guide_a: Vector,
    anchor_b: Vector,
    position_a: Vector,
    velocity_a: Vector,
    orientation_a: Scalar,
    angular_velocity_a: Scalar,
    position_b: Vector,
    velocity_b: Vector,
    orientation_b: Scalar,
    angular_velocity_b: Scalar,
) -> tuple[Scalar, ...]:
    """Prismatic joint: second derivative of the constraint where no body is accelerated.

    dot(perp(guide_rate_rate), span) + dot(perp(guide_rate), span_rate) +
        (dot(perp(guide_rate), span_rate) + dot(perp(guide), span_rate_rate))
    0
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where guide = rotate(guide_a, orientation_a)
        where span = position_b + arm_b - position_a - arm_a
        where arm_a_rate = angular_velocity_a*perp(arm_a)
        where arm_b_rate = angular_velocity_b*perp(arm_b)
        where guide_rate = angular_velocity_a*perp(guide)
        where span_rate = velocity_b + arm_b_rate - velocity_a - arm_a_rate
        where arm_a_rate_rate = angular_velocity_a*perp(arm_a_rate)
        where arm_b_rate_rate = angular_velocity_b*perp(arm_b_rate)
        where guide_rate_rate = angular_velocity_a*perp(guide_rate)
        where span_rate_rate = arm_b_rate_rate - arm_a_rate_rate

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        guide_a: Unit vector along which a joint lets a body slide; of body A, 1
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        position_a: Position of the centre of mass; of body A, m
        velocity_a: Velocity of the centre of mass; of body A, m/s
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        position_b: Position of the centre of mass; of body B, m
        velocity_b: Velocity of the centre of mass; of body B, m/s
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s

    Source: prismatic, srs/models/joints.md:271.
    """
    anchor_a_x, anchor_a_y = anchor_a
    guide_a_x, guide_a_y = guide_a
    anchor_b_x, anchor_b_y = anchor_b
    position_a_x, position_a_y = position_a
    velocity_a_x, velocity_a_y = velocity_a
    position_b_x, position_b_y = position_b
    velocity_b_x, velocity_b_y = velocity_b
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    guide_x, guide_y = (
        cos(orientation_a) * guide_a_x - sin(orientation_a) * guide_a_y,
        sin(orientation_a) * guide_a_x + cos(orientation_a) * guide_a_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    arm_a_rate_x, arm_a_rate_y = (angular_velocity_a * (-arm_a_y), angular_velocity_a * (arm_a_x))
    arm_b_rate_x, arm_b_rate_y = (angular_velocity_b * (-arm_b_y), angular_velocity_b * (arm_b_x))
    guide_rate_x, guide_rate_y = (angular_velocity_a * (-guide_y), angular_velocity_a * (guide_x))
    span_rate_x, span_rate_y = (
        velocity_b_x + arm_b_rate_x - velocity_a_x - arm_a_rate_x,
        velocity_b_y + arm_b_rate_y - velocity_a_y - arm_a_rate_y,
    )
    arm_a_rate_rate_x, arm_a_rate_rate_y = (
        angular_velocity_a * (-arm_a_rate_y),
        angular_velocity_a * (arm_a_rate_x),
    )
    arm_b_rate_rate_x, arm_b_rate_rate_y = (
        angular_velocity_b * (-arm_b_rate_y),
        angular_velocity_b * (arm_b_rate_x),
    )
    guide_rate_rate_x, guide_rate_rate_y = (
        angular_velocity_a * (-guide_rate_y),
        angular_velocity_a * (guide_rate_x),
    )
    span_rate_rate_x, span_rate_rate_y = (
        arm_b_rate_rate_x - arm_a_rate_rate_x,
        arm_b_rate_rate_y - arm_a_rate_rate_y,
    )
    return (
        (-guide_rate_rate_y) * span_x
        + (guide_rate_rate_x) * span_y
        + (-guide_rate_y) * span_rate_x
        + (guide_rate_x) * span_rate_y
        + (-guide_rate_y) * span_rate_x
        + (guide_rate_x) * span_rate_y
        + (-guide_y) * span_rate_rate_x
        + (guide_x) * span_rate_rate_y,
        0,
    )


def groove_constraint(
    anchor_a: Vector,
    guide_a: Vector,
    anchor_b: Vector,
    position_a: Vector,
    orientation_a: Scalar,
    position_b: Vector,
    orientation_b: Scalar,
) -> tuple[Scalar, ...]:
    """Groove: zero where it holds.

    dot(perp(guide), span)
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where guide = rotate(guide_a, orientation_a)
        where span = position_b + arm_b - position_a - arm_a

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        guide_a: Unit vector along which a joint lets a body slide; of body A, 1
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        position_a: Position of the centre of mass; of body A, m
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        position_b: Position of the centre of mass; of body B, m
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad

    Source: groove, srs/models/joints.md:288.
    """
    anchor_a_x, anchor_a_y = anchor_a
    guide_a_x, guide_a_y = guide_a
    anchor_b_x, anchor_b_y = anchor_b
    position_a_x, position_a_y = position_a
    position_b_x, position_b_y = position_b
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    guide_x, guide_y = (
        cos(orientation_a) * guide_a_x - sin(orientation_a) * guide_a_y,
        sin(orientation_a) * guide_a_x + cos(orientation_a) * guide_a_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    return ((-guide_y) * span_x + (guide_x) * span_y,)


def groove_slopes_a(
    anchor_a: Vector,
    guide_a: Vector,
    anchor_b: Vector,
    position_a: Vector,
    orientation_a: Scalar,
    position_b: Vector,
    orientation_b: Scalar,
) -> tuple[Scalar, ...]:
    """Groove: slopes by x, y and orientation of body A.

    y(guide)
    -x(guide)
    -dot(guide, span) - dot(arm_a, guide)
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where guide = rotate(guide_a, orientation_a)
        where span = position_b + arm_b - position_a - arm_a

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        guide_a: Unit vector along which a joint lets a body slide; of body A, 1
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        position_a: Position of the centre of mass; of body A, m
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        position_b: Position of the centre of mass; of body B, m
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad

    Source: groove, srs/models/joints.md:288.
    """
    anchor_a_x, anchor_a_y = anchor_a
    guide_a_x, guide_a_y = guide_a
    anchor_b_x, anchor_b_y = anchor_b
    position_a_x, position_a_y = position_a
    position_b_x, position_b_y = position_b
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    guide_x, guide_y = (
        cos(orientation_a) * guide_a_x - sin(orientation_a) * guide_a_y,
        sin(orientation_a) * guide_a_x + cos(orientation_a) * guide_a_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    return (
        guide_y,
        -guide_x,
        -(guide_x * span_x + guide_y * span_y) - (arm_a_x * guide_x + arm_a_y * guide_y),
    )


def groove_slopes_b(
    guide_a: Vector,
    anchor_b: Vector,
    orientation_a: Scalar,
    orientation_b: Scalar,
) -> tuple[Scalar, ...]:
    """Groove: slopes by x, y and orientation of body B.

    -y(guide)
    x(guide)
    dot(guide, arm_b)
        where arm_b = rotate(anchor_b, orientation_b)
        where guide = rotate(guide_a, orientation_a)

    Args:
        guide_a: Unit vector along which a joint lets a body slide; of body A, 1
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad

    Source: groove, srs/models/joints.md:288.
    """
    guide_a_x, guide_a_y = guide_a
    anchor_b_x, anchor_b_y = anchor_b
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    guide_x, guide_y = (
        cos(orientation_a) * guide_a_x - sin(orientation_a) * guide_a_y,
        sin(orientation_a) * guide_a_x + cos(orientation_a) * guide_a_y,
    )
    return (
        -guide_y,
        guide_x,
        guide_x * arm_b_x + guide_y * arm_b_y,
    )


def groove_rate(
    anchor_a: Vector,
    guide_a: Vector,
    anchor_b: Vector,
    position_a: Vector,
    velocity_a: Vector,
    orientation_a: Scalar,
    angular_velocity_a: Scalar,
    position_b: Vector,
    velocity_b: Vector,
    orientation_b: Scalar,
    angular_velocity_b: Scalar,
) -> tuple[Scalar, ...]:
    """Groove: rate of the constraint along the motion.

    dot(perp(guide_rate), span) + dot(perp(guide), span_rate)
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where guide = rotate(guide_a, orientation_a)
        where span = position_b + arm_b - position_a - arm_a
        where arm_a_rate = angular_velocity_a*perp(arm_a)
        where arm_b_rate = angular_velocity_b*perp(arm_b)
        where guide_rate = angular_velocity_a*perp(guide)
        where span_rate = velocity_b + arm_b_rate - velocity_a - arm_a_rate

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        guide_a: Unit vector along which a joint lets a body slide; of body A, 1
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        position_a: Position of the centre of mass; of body A, m
        velocity_a: Velocity of the centre of mass; of body A, m/s
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        position_b: Position of the centre of mass; of body B, m
        velocity_b: Velocity of the centre of mass; of body B, m/s
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s

    Source: groove, srs/models/joints.md:288.
    """
    anchor_a_x, anchor_a_y = anchor_a
    guide_a_x, guide_a_y = guide_a
    anchor_b_x, anchor_b_y = anchor_b
    position_a_x, position_a_y = position_a
    velocity_a_x, velocity_a_y = velocity_a
    position_b_x, position_b_y = position_b
    velocity_b_x, velocity_b_y = velocity_b
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    guide_x, guide_y = (
        cos(orientation_a) * guide_a_x - sin(orientation_a) * guide_a_y,
        sin(orientation_a) * guide_a_x + cos(orientation_a) * guide_a_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    arm_a_rate_x, arm_a_rate_y = (angular_velocity_a * (-arm_a_y), angular_velocity_a * (arm_a_x))
    arm_b_rate_x, arm_b_rate_y = (angular_velocity_b * (-arm_b_y), angular_velocity_b * (arm_b_x))
    guide_rate_x, guide_rate_y = (angular_velocity_a * (-guide_y), angular_velocity_a * (guide_x))
    span_rate_x, span_rate_y = (
        velocity_b_x + arm_b_rate_x - velocity_a_x - arm_a_rate_x,
        velocity_b_y + arm_b_rate_y - velocity_a_y - arm_a_rate_y,
    )
    return (
        (-guide_rate_y) * span_x
        + (guide_rate_x) * span_y
        + (-guide_y) * span_rate_x
        + (guide_x) * span_rate_y,
    )


def groove_convective(
    anchor_a: Vector,
    guide_a: Vector,
    anchor_b: Vector,
    position_a: Vector,
    velocity_a: Vector,
    orientation_a: Scalar,
    angular_velocity_a: Scalar,
    position_b: Vector,
    velocity_b: Vector,
    orientation_b: Scalar,
    angular_velocity_b: Scalar,
) -> tuple[Scalar, ...]:
    """Groove: second derivative of the constraint where no body is accelerated.

    dot(perp(guide_rate_rate), span) + dot(perp(guide_rate), span_rate) +
        (dot(perp(guide_rate), span_rate) + dot(perp(guide), span_rate_rate))
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where guide = rotate(guide_a, orientation_a)
        where span = position_b + arm_b - position_a - arm_a
        where arm_a_rate = angular_velocity_a*perp(arm_a)
        where arm_b_rate = angular_velocity_b*perp(arm_b)
        where guide_rate = angular_velocity_a*perp(guide)
        where span_rate = velocity_b + arm_b_rate - velocity_a - arm_a_rate
        where arm_a_rate_rate = angular_velocity_a*perp(arm_a_rate)
        where arm_b_rate_rate = angular_velocity_b*perp(arm_b_rate)
        where guide_rate_rate = angular_velocity_a*perp(guide_rate)
        where span_rate_rate = arm_b_rate_rate - arm_a_rate_rate

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        guide_a: Unit vector along which a joint lets a body slide; of body A, 1
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        position_a: Position of the centre of mass; of body A, m
        velocity_a: Velocity of the centre of mass; of body A, m/s
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        position_b: Position of the centre of mass; of body B, m
        velocity_b: Velocity of the centre of mass; of body B, m/s
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s

    Source: groove, srs/models/joints.md:288.
    """
    anchor_a_x, anchor_a_y = anchor_a
    guide_a_x, guide_a_y = guide_a
    anchor_b_x, anchor_b_y = anchor_b
    position_a_x, position_a_y = position_a
    velocity_a_x, velocity_a_y = velocity_a
    position_b_x, position_b_y = position_b
    velocity_b_x, velocity_b_y = velocity_b
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    guide_x, guide_y = (
        cos(orientation_a) * guide_a_x - sin(orientation_a) * guide_a_y,
        sin(orientation_a) * guide_a_x + cos(orientation_a) * guide_a_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    arm_a_rate_x, arm_a_rate_y = (angular_velocity_a * (-arm_a_y), angular_velocity_a * (arm_a_x))
    arm_b_rate_x, arm_b_rate_y = (angular_velocity_b * (-arm_b_y), angular_velocity_b * (arm_b_x))
    guide_rate_x, guide_rate_y = (angular_velocity_a * (-guide_y), angular_velocity_a * (guide_x))
    span_rate_x, span_rate_y = (
        velocity_b_x + arm_b_rate_x - velocity_a_x - arm_a_rate_x,
        velocity_b_y + arm_b_rate_y - velocity_a_y - arm_a_rate_y,
    )
    arm_a_rate_rate_x, arm_a_rate_rate_y = (
        angular_velocity_a * (-arm_a_rate_y),
        angular_velocity_a * (arm_a_rate_x),
    )
    arm_b_rate_rate_x, arm_b_rate_rate_y = (
        angular_velocity_b * (-arm_b_rate_y),
        angular_velocity_b * (arm_b_rate_x),
    )
    guide_rate_rate_x, guide_rate_rate_y = (
        angular_velocity_a * (-guide_rate_y),
        angular_velocity_a * (guide_rate_x),
    )
    span_rate_rate_x, span_rate_rate_y = (
        arm_b_rate_rate_x - arm_a_rate_rate_x,
        arm_b_rate_rate_y - arm_a_rate_rate_y,
    )
    return (
        (-guide_rate_rate_y) * span_x
        + (guide_rate_rate_x) * span_y
        + (-guide_rate_y) * span_rate_x
        + (guide_rate_x) * span_rate_y
        + (-guide_rate_y) * span_rate_x
        + (guide_rate_x) * span_rate_y
        + (-guide_y) * span_rate_rate_x
        + (guide_x) * span_rate_rate_y,
    )


def gear_constraint(
    gear_ratio: Scalar,
    joint_angle: Scalar,
    orientation_a: Scalar,
    orientation_b: Scalar,
    orientation_c: Scalar,
) -> tuple[Scalar, ...]:
    """Gear: zero where it holds.

    orientation_b - orientation_c - gear_ratio*(orientation_a - orientation_c) - joint_angle

    Args:
        gear_ratio: How often one side of a joint moves for once that the other does, 1
        joint_angle: Angle that a joint keeps between two bodies, rad
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad
        orientation_c: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of a third body, rad

    Source: gear, srs/models/joints.md:304.
    """
    return (
        orientation_b - orientation_c - gear_ratio * (orientation_a - orientation_c) - joint_angle,
    )


def gear_slopes_a(
    gear_ratio: Scalar,
) -> tuple[Scalar, ...]:
    """Gear: slopes by x, y and orientation of body A.

    0
    0
    -gear_ratio

    Args:
        gear_ratio: How often one side of a joint moves for once that the other does, 1

    Source: gear, srs/models/joints.md:304.
    """
    return (
        0,
        0,
        -gear_ratio,
    )


def gear_slopes_b() -> tuple[Scalar, ...]:
    """Gear: slopes by x, y and orientation of body B.

    0
    0
    1

    Source: gear, srs/models/joints.md:304.
    """
    return (
        0,
        0,
        1,
    )


def gear_slopes_c(
    gear_ratio: Scalar,
) -> tuple[Scalar, ...]:
    """Gear: slopes by x, y and orientation of body C.

    0
    0
    -1 + gear_ratio

    Args:
        gear_ratio: How often one side of a joint moves for once that the other does, 1

    Source: gear, srs/models/joints.md:304.
    """
    return (
        0,
        0,
        -1 + gear_ratio,
    )


def gear_rate(
    gear_ratio: Scalar,
    angular_velocity_a: Scalar,
    angular_velocity_b: Scalar,
    angular_velocity_c: Scalar,
) -> tuple[Scalar, ...]:
    """Gear: rate of the constraint along the motion.

    angular_velocity_b - angular_velocity_c - gear_ratio*(angular_velocity_a -
        angular_velocity_c)

    Args:
        gear_ratio: How often one side of a joint moves for once that the other does, 1
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s
        angular_velocity_c: Rate of turning, positive counter-clockwise; of a third body, rad/s

    Source: gear, srs/models/joints.md:304.
    """
    return (
        angular_velocity_b
        - angular_velocity_c
        - gear_ratio * (angular_velocity_a - angular_velocity_c),
    )


def gear_convective() -> tuple[Scalar, ...]:
    """Gear: second derivative of the constraint where no body is accelerated.

    0

    Source: gear, srs/models/joints.md:304.
    """
    return (0,)


def pulley_constraint(
    anchor_a: Vector,
    anchor_b: Vector,
    post_a: Vector,
    post_b: Vector,
    gear_ratio: Scalar,
    joint_length: Scalar,
    position_a: Vector,
    orientation_a: Scalar,
    position_b: Vector,
    orientation_b: Scalar,
    position_c: Vector,
    orientation_c: Scalar,
) -> tuple[Scalar, ...]:
    """Pulley: zero where it holds.

    distance_a + gear_ratio*distance_b - joint_length
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where arm_c_a = rotate(post_a, orientation_c)
        where arm_c_b = rotate(post_b, orientation_c)
        where span_a = position_a + arm_a - position_c - arm_c_a
        where span_b = position_b + arm_b - position_c - arm_c_b
        where distance_a = norm(span_a)
        where distance_b = norm(span_b)

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        post_a: Place of a wheel over which a rope runs, from the centre of mass of the body
            that carries it, in that body's own axes; of body A, m
        post_b: Place of a wheel over which a rope runs, from the centre of mass of the body
            that carries it, in that body's own axes; of body B, m
        gear_ratio: How often one side of a joint moves for once that the other does, 1
        joint_length: Length that a joint keeps, m
        position_a: Position of the centre of mass; of body A, m
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        position_b: Position of the centre of mass; of body B, m
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad
        position_c: Position of the centre of mass; of a third body, m
        orientation_c: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of a third body, rad

    Source: pulley, srs/models/joints.md:322.
    """
    anchor_a_x, anchor_a_y = anchor_a
    anchor_b_x, anchor_b_y = anchor_b
    post_a_x, post_a_y = post_a
    post_b_x, post_b_y = post_b
    position_a_x, position_a_y = position_a
    position_b_x, position_b_y = position_b
    position_c_x, position_c_y = position_c
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    arm_c_a_x, arm_c_a_y = (
        cos(orientation_c) * post_a_x - sin(orientation_c) * post_a_y,
        sin(orientation_c) * post_a_x + cos(orientation_c) * post_a_y,
    )
    arm_c_b_x, arm_c_b_y = (
        cos(orientation_c) * post_b_x - sin(orientation_c) * post_b_y,
        sin(orientation_c) * post_b_x + cos(orientation_c) * post_b_y,
    )
    span_a_x, span_a_y = (
        position_a_x + arm_a_x - position_c_x - arm_c_a_x,
        position_a_y + arm_a_y - position_c_y - arm_c_a_y,
    )
    span_b_x, span_b_y = (
        position_b_x + arm_b_x - position_c_x - arm_c_b_x,
        position_b_y + arm_b_y - position_c_y - arm_c_b_y,
    )
    distance_a = sqrt(span_a_x * span_a_x + span_a_y * span_a_y)
    distance_b = sqrt(span_b_x * span_b_x + span_b_y * span_b_y)
    return (distance_a + gear_ratio * distance_b - joint_length,)


def pulley_slopes_a(
    anchor_a: Vector,
    post_a: Vector,
    position_a: Vector,
    orientation_a: Scalar,
    position_c: Vector,
    orientation_c: Scalar,
) -> tuple[Scalar, ...]:
    """Pulley: slopes by x, y and orientation of body A.

    x(span_a)/distance_a
    y(span_a)/distance_a
    dot(span_a, perp(arm_a))/distance_a
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_c_a = rotate(post_a, orientation_c)
        where span_a = position_a + arm_a - position_c - arm_c_a
        where distance_a = norm(span_a)

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        post_a: Place of a wheel over which a rope runs, from the centre of mass of the body
            that carries it, in that body's own axes; of body A, m
        position_a: Position of the centre of mass; of body A, m
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        position_c: Position of the centre of mass; of a third body, m
        orientation_c: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of a third body, rad

    Source: pulley, srs/models/joints.md:322.
    """
    anchor_a_x, anchor_a_y = anchor_a
    post_a_x, post_a_y = post_a
    position_a_x, position_a_y = position_a
    position_c_x, position_c_y = position_c
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_c_a_x, arm_c_a_y = (
        cos(orientation_c) * post_a_x - sin(orientation_c) * post_a_y,
        sin(orientation_c) * post_a_x + cos(orientation_c) * post_a_y,
    )
    span_a_x, span_a_y = (
        position_a_x + arm_a_x - position_c_x - arm_c_a_x,
        position_a_y + arm_a_y - position_c_y - arm_c_a_y,
    )
    distance_a = sqrt(span_a_x * span_a_x + span_a_y * span_a_y)
    return (
        span_a_x / distance_a,
        span_a_y / distance_a,
        (span_a_x * (-arm_a_y) + span_a_y * (arm_a_x)) / distance_a,
    )


def pulley_slopes_b(
    anchor_b: Vector,
    post_b: Vector,
    gear_ratio: Scalar,
    position_b: Vector,
    orientation_b: Scalar,
    position_c: Vector,
    orientation_c: Scalar,
) -> tuple[Scalar, ...]:
    """Pulley: slopes by x, y and orientation of body B.

    gear_ratio*(x(span_b)/distance_b)
    gear_ratio*(y(span_b)/distance_b)
    gear_ratio*(dot(span_b, perp(arm_b))/distance_b)
        where arm_b = rotate(anchor_b, orientation_b)
        where arm_c_b = rotate(post_b, orientation_c)
        where span_b = position_b + arm_b - position_c - arm_c_b
        where distance_b = norm(span_b)

    Args:
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        post_b: Place of a wheel over which a rope runs, from the centre of mass of the body
            that carries it, in that body's own axes; of body B, m
        gear_ratio: How often one side of a joint moves for once that the other does, 1
        position_b: Position of the centre of mass; of body B, m
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad
        position_c: Position of the centre of mass; of a third body, m
        orientation_c: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of a third body, rad

    Source: pulley, srs/models/joints.md:322.
    """
    anchor_b_x, anchor_b_y = anchor_b
    post_b_x, post_b_y = post_b
    position_b_x, position_b_y = position_b
    position_c_x, position_c_y = position_c
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    arm_c_b_x, arm_c_b_y = (
        cos(orientation_c) * post_b_x - sin(orientation_c) * post_b_y,
        sin(orientation_c) * post_b_x + cos(orientation_c) * post_b_y,
    )
    span_b_x, span_b_y = (
        position_b_x + arm_b_x - position_c_x - arm_c_b_x,
        position_b_y + arm_b_y - position_c_y - arm_c_b_y,
    )
    distance_b = sqrt(span_b_x * span_b_x + span_b_y * span_b_y)
    return (
        gear_ratio * span_b_x / distance_b,
        gear_ratio * span_b_y / distance_b,
        gear_ratio * (span_b_x * (-arm_b_y) + span_b_y * (arm_b_x)) / distance_b,
    )


def pulley_slopes_c(
    anchor_a: Vector,
    anchor_b: Vector,
    post_a: Vector,
    post_b: Vector,
    gear_ratio: Scalar,
    position_a: Vector,
    orientation_a: Scalar,
    position_b: Vector,
    orientation_b: Scalar,
    position_c: Vector,
    orientation_c: Scalar,
) -> tuple[Scalar, ...]:
    """Pulley: slopes by x, y and orientation of body C.

    -x(span_a)/distance_a + gear_ratio*(-x(span_b)/distance_b)
    -y(span_a)/distance_a + gear_ratio*(-y(span_b)/distance_b)
    -dot(perp(arm_c_a), span_a)/distance_a + gear_ratio*(-dot(perp(arm_c_b),
        span_b)/distance_b)
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where arm_c_a = rotate(post_a, orientation_c)
        where arm_c_b = rotate(post_b, orientation_c)
        where span_a = position_a + arm_a - position_c - arm_c_a
        where span_b = position_b + arm_b - position_c - arm_c_b
        where distance_a = norm(span_a)
        where distance_b = norm(span_b)

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        post_a: Place of a wheel over which a rope runs, from the centre of mass of the body
            that carries it, in that body's own axes; of body A, m
        post_b: Place of a wheel over which a rope runs, from the centre of mass of the body
            that carries it, in that body's own axes; of body B, m
        gear_ratio: How often one side of a joint moves for once that the other does, 1
        position_a: Position of the centre of mass; of body A, m
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        position_b: Position of the centre of mass; of body B, m
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad
        position_c: Position of the centre of mass; of a third body, m
        orientation_c: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of a third body, rad

    Source: pulley, srs/models/joints.md:322.
    """
    anchor_a_x, anchor_a_y = anchor_a
    anchor_b_x, anchor_b_y = anchor_b
    post_a_x, post_a_y = post_a
    post_b_x, post_b_y = post_b
    position_a_x, position_a_y = position_a
    position_b_x, position_b_y = position_b
    position_c_x, position_c_y = position_c
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    arm_c_a_x, arm_c_a_y = (
        cos(orientation_c) * post_a_x - sin(orientation_c) * post_a_y,
        sin(orientation_c) * post_a_x + cos(orientation_c) * post_a_y,
    )
    arm_c_b_x, arm_c_b_y = (
        cos(orientation_c) * post_b_x - sin(orientation_c) * post_b_y,
        sin(orientation_c) * post_b_x + cos(orientation_c) * post_b_y,
    )
    span_a_x, span_a_y = (
        position_a_x + arm_a_x - position_c_x - arm_c_a_x,
        position_a_y + arm_a_y - position_c_y - arm_c_a_y,
    )
    span_b_x, span_b_y = (
        position_b_x + arm_b_x - position_c_x - arm_c_b_x,
        position_b_y + arm_b_y - position_c_y - arm_c_b_y,
    )
    distance_a = sqrt(span_a_x * span_a_x + span_a_y * span_a_y)
    distance_b = sqrt(span_b_x * span_b_x + span_b_y * span_b_y)
    return (
        (-span_a_x) / distance_a + gear_ratio * (-span_b_x) / distance_b,
        (-span_a_y) / distance_a + gear_ratio * (-span_b_y) / distance_b,
        (-((-arm_c_a_y) * span_a_x + (arm_c_a_x) * span_a_y)) / distance_a
        + gear_ratio * (-((-arm_c_b_y) * span_b_x + (arm_c_b_x) * span_b_y)) / distance_b,
    )


def pulley_rate(
    anchor_a: Vector,
    anchor_b: Vector,
    post_a: Vector,
    post_b: Vector,
    gear_ratio: Scalar,
    position_a: Vector,
    velocity_a: Vector,
    orientation_a: Scalar,
    angular_velocity_a: Scalar,
    position_b: Vector,
    velocity_b: Vector,
    orientation_b: Scalar,
    angular_velocity_b: Scalar,
    position_c: Vector,
    velocity_c: Vector,
    orientation_c: Scalar,
    angular_velocity_c: Scalar,
) -> tuple[Scalar, ...]:
    """Pulley: rate of the constraint along the motion.

    distance_a_rate + gear_ratio*distance_b_rate
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where arm_c_a = rotate(post_a, orientation_c)
        where arm_c_b = rotate(post_b, orientation_c)
        where span_a = position_a + arm_a - position_c - arm_c_a
        where span_b = position_b + arm_b - position_c - arm_c_b
        where distance_a = norm(span_a)
        where distance_b = norm(span_b)
        where arm_a_rate = angular_velocity_a*perp(arm_a)
        where arm_b_rate = angular_velocity_b*perp(arm_b)
        where arm_c_a_rate = angular_velocity_c*perp(arm_c_a)
        where arm_c_b_rate = angular_velocity_c*perp(arm_c_b)
        where span_a_rate = velocity_a + arm_a_rate - velocity_c - arm_c_a_rate
        where span_b_rate = velocity_b + arm_b_rate - velocity_c - arm_c_b_rate
        where distance_a_rate = dot(span_a, span_a_rate)/distance_a
        where distance_b_rate = dot(span_b, span_b_rate)/distance_b

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        post_a: Place of a wheel over which a rope runs, from the centre of mass of the body
            that carries it, in that body's own axes; of body A, m
        post_b: Place of a wheel over which a rope runs, from the centre of mass of the body
            that carries it, in that body's own axes; of body B, m
        gear_ratio: How often one side of a joint moves for once that the other does, 1
        position_a: Position of the centre of mass; of body A, m
        velocity_a: Velocity of the centre of mass; of body A, m/s
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        position_b: Position of the centre of mass; of body B, m
        velocity_b: Velocity of the centre of mass; of body B, m/s
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s
        position_c: Position of the centre of mass; of a third body, m
        velocity_c: Velocity of the centre of mass; of a third body, m/s
        orientation_c: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of a third body, rad
        angular_velocity_c: Rate of turning, positive counter-clockwise; of a third body, rad/s

    Source: pulley, srs/models/joints.md:322.
    """
    anchor_a_x, anchor_a_y = anchor_a
    anchor_b_x, anchor_b_y = anchor_b
    post_a_x, post_a_y = post_a
    post_b_x, post_b_y = post_b
    position_a_x, position_a_y = position_a
    velocity_a_x, velocity_a_y = velocity_a
    position_b_x, position_b_y = position_b
    velocity_b_x, velocity_b_y = velocity_b
    position_c_x, position_c_y = position_c
    velocity_c_x, velocity_c_y = velocity_c
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    arm_c_a_x, arm_c_a_y = (
        cos(orientation_c) * post_a_x - sin(orientation_c) * post_a_y,
        sin(orientation_c) * post_a_x + cos(orientation_c) * post_a_y,
    )
    arm_c_b_x, arm_c_b_y = (
        cos(orientation_c) * post_b_x - sin(orientation_c) * post_b_y,
        sin(orientation_c) * post_b_x + cos(orientation_c) * post_b_y,
    )
    span_a_x, span_a_y = (
        position_a_x + arm_a_x - position_c_x - arm_c_a_x,
        position_a_y + arm_a_y - position_c_y - arm_c_a_y,
    )
    span_b_x, span_b_y = (
        position_b_x + arm_b_x - position_c_x - arm_c_b_x,
        position_b_y + arm_b_y - position_c_y - arm_c_b_y,
    )
    distance_a = sqrt(span_a_x * span_a_x + span_a_y * span_a_y)
    distance_b = sqrt(span_b_x * span_b_x + span_b_y * span_b_y)
    arm_a_rate_x, arm_a_rate_y = (angular_velocity_a * (-arm_a_y), angular_velocity_a * (arm_a_x))
    arm_b_rate_x, arm_b_rate_y = (angular_velocity_b * (-arm_b_y), angular_velocity_b * (arm_b_x))
    arm_c_a_rate_x, arm_c_a_rate_y = (
        angular_velocity_c * (-arm_c_a_y),
        angular_velocity_c * (arm_c_a_x),
    )
    arm_c_b_rate_x, arm_c_b_rate_y = (
        angular_velocity_c * (-arm_c_b_y),
        angular_velocity_c * (arm_c_b_x),
    )
    span_a_rate_x, span_a_rate_y = (
        velocity_a_x + arm_a_rate_x - velocity_c_x - arm_c_a_rate_x,
        velocity_a_y + arm_a_rate_y - velocity_c_y - arm_c_a_rate_y,
    )
    span_b_rate_x, span_b_rate_y = (
        velocity_b_x + arm_b_rate_x - velocity_c_x - arm_c_b_rate_x,
        velocity_b_y + arm_b_rate_y - velocity_c_y - arm_c_b_rate_y,
    )
    distance_a_rate = (span_a_x * span_a_rate_x + span_a_y * span_a_rate_y) / distance_a
    distance_b_rate = (span_b_x * span_b_rate_x + span_b_y * span_b_rate_y) / distance_b
    return (distance_a_rate + gear_ratio * distance_b_rate,)


def pulley_convective(
    anchor_a: Vector,
    anchor_b: Vector,
    post_a: Vector,
    post_b: Vector,
    gear_ratio: Scalar,
    position_a: Vector,
    velocity_a: Vector,
    orientation_a: Scalar,
    angular_velocity_a: Scalar,
    position_b: Vector,
    velocity_b: Vector,
    orientation_b: Scalar,
    angular_velocity_b: Scalar,
    position_c: Vector,
    velocity_c: Vector,
    orientation_c: Scalar,
    angular_velocity_c: Scalar,
) -> tuple[Scalar, ...]:
    """Pulley: second derivative of the constraint where no body is accelerated.

    distance_a_rate_rate + gear_ratio*distance_b_rate_rate
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where arm_c_a = rotate(post_a, orientation_c)
        where arm_c_b = rotate(post_b, orientation_c)
        where span_a = position_a + arm_a - position_c - arm_c_a
        where span_b = position_b + arm_b - position_c - arm_c_b
        where distance_a = norm(span_a)
        where distance_b = norm(span_b)
        where arm_a_rate = angular_velocity_a*perp(arm_a)
        where arm_b_rate = angular_velocity_b*perp(arm_b)
        where arm_c_a_rate = angular_velocity_c*perp(arm_c_a)
        where arm_c_b_rate = angular_velocity_c*perp(arm_c_b)
        where span_a_rate = velocity_a + arm_a_rate - velocity_c - arm_c_a_rate
        where span_b_rate = velocity_b + arm_b_rate - velocity_c - arm_c_b_rate
        where distance_a_rate = dot(span_a, span_a_rate)/distance_a
        where distance_b_rate = dot(span_b, span_b_rate)/distance_b
        where arm_a_rate_rate = angular_velocity_a*perp(arm_a_rate)
        where arm_b_rate_rate = angular_velocity_b*perp(arm_b_rate)
        where arm_c_a_rate_rate = angular_velocity_c*perp(arm_c_a_rate)
        where arm_c_b_rate_rate = angular_velocity_c*perp(arm_c_b_rate)
        where span_a_rate_rate = arm_a_rate_rate - arm_c_a_rate_rate
        where span_b_rate_rate = arm_b_rate_rate - arm_c_b_rate_rate
        where distance_a_rate_rate = (dot(span_a_rate, span_a_rate) + dot(span_a,
            span_a_rate_rate))/distance_a - dot(span_a,
            span_a_rate)*distance_a_rate/distance_a**2
        where distance_b_rate_rate = (dot(span_b_rate, span_b_rate) + dot(span_b,
            span_b_rate_rate))/distance_b - dot(span_b,
            span_b_rate)*distance_b_rate/distance_b**2

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        post_a: Place of a wheel over which a rope runs, from the centre of mass of the body
            that carries it, in that body's own axes; of body A, m
        post_b: Place of a wheel over which a rope runs, from the centre of mass of the body
            that carries it, in that body's own axes; of body B, m
        gear_ratio: How often one side of a joint moves for once that the other does, 1
        position_a: Position of the centre of mass; of body A, m
        velocity_a: Velocity of the centre of mass; of body A, m/s
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        position_b: Position of the centre of mass; of body B, m
        velocity_b: Velocity of the centre of mass; of body B, m/s
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s
        position_c: Position of the centre of mass; of a third body, m
        velocity_c: Velocity of the centre of mass; of a third body, m/s
        orientation_c: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of a third body, rad
        angular_velocity_c: Rate of turning, positive counter-clockwise; of a third body, rad/s

    Source: pulley, srs/models/joints.md:322.
    """
    anchor_a_x, anchor_a_y = anchor_a
    anchor_b_x, anchor_b_y = anchor_b
    post_a_x, post_a_y = post_a
    post_b_x, post_b_y = post_b
    position_a_x, position_a_y = position_a
    velocity_a_x, velocity_a_y = velocity_a
    position_b_x, position_b_y = position_b
    velocity_b_x, velocity_b_y = velocity_b
    position_c_x, position_c_y = position_c
    velocity_c_x, velocity_c_y = velocity_c
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    arm_c_a_x, arm_c_a_y = (
        cos(orientation_c) * post_a_x - sin(orientation_c) * post_a_y,
        sin(orientation_c) * post_a_x + cos(orientation_c) * post_a_y,
    )
    arm_c_b_x, arm_c_b_y = (
        cos(orientation_c) * post_b_x - sin(orientation_c) * post_b_y,
        sin(orientation_c) * post_b_x + cos(orientation_c) * post_b_y,
    )
    span_a_x, span_a_y = (
        position_a_x + arm_a_x - position_c_x - arm_c_a_x,
        position_a_y + arm_a_y - position_c_y - arm_c_a_y,
    )
    span_b_x, span_b_y = (
        position_b_x + arm_b_x - position_c_x - arm_c_b_x,
        position_b_y + arm_b_y - position_c_y - arm_c_b_y,
    )
    distance_a = sqrt(span_a_x * span_a_x + span_a_y * span_a_y)
    distance_b = sqrt(span_b_x * span_b_x + span_b_y * span_b_y)
    arm_a_rate_x, arm_a_rate_y = (angular_velocity_a * (-arm_a_y), angular_velocity_a * (arm_a_x))
    arm_b_rate_x, arm_b_rate_y = (angular_velocity_b * (-arm_b_y), angular_velocity_b * (arm_b_x))
    arm_c_a_rate_x, arm_c_a_rate_y = (
        angular_velocity_c * (-arm_c_a_y),
        angular_velocity_c * (arm_c_a_x),
    )
    arm_c_b_rate_x, arm_c_b_rate_y = (
        angular_velocity_c * (-arm_c_b_y),
        angular_velocity_c * (arm_c_b_x),
    )
    span_a_rate_x, span_a_rate_y = (
        velocity_a_x + arm_a_rate_x - velocity_c_x - arm_c_a_rate_x,
        velocity_a_y + arm_a_rate_y - velocity_c_y - arm_c_a_rate_y,
    )
    span_b_rate_x, span_b_rate_y = (
        velocity_b_x + arm_b_rate_x - velocity_c_x - arm_c_b_rate_x,
        velocity_b_y + arm_b_rate_y - velocity_c_y - arm_c_b_rate_y,
    )
    distance_a_rate = (span_a_x * span_a_rate_x + span_a_y * span_a_rate_y) / distance_a
    distance_b_rate = (span_b_x * span_b_rate_x + span_b_y * span_b_rate_y) / distance_b
    arm_a_rate_rate_x, arm_a_rate_rate_y = (
        angular_velocity_a * (-arm_a_rate_y),
        angular_velocity_a * (arm_a_rate_x),
    )
    arm_b_rate_rate_x, arm_b_rate_rate_y = (
        angular_velocity_b * (-arm_b_rate_y),
        angular_velocity_b * (arm_b_rate_x),
    )
    arm_c_a_rate_rate_x, arm_c_a_rate_rate_y = (
        angular_velocity_c * (-arm_c_a_rate_y),
        angular_velocity_c * (arm_c_a_rate_x),
    )
    arm_c_b_rate_rate_x, arm_c_b_rate_rate_y = (
        angular_velocity_c * (-arm_c_b_rate_y),
        angular_velocity_c * (arm_c_b_rate_x),
    )
    span_a_rate_rate_x, span_a_rate_rate_y = (
        arm_a_rate_rate_x - arm_c_a_rate_rate_x,
        arm_a_rate_rate_y - arm_c_a_rate_rate_y,
    )
    span_b_rate_rate_x, span_b_rate_rate_y = (
        arm_b_rate_rate_x - arm_c_b_rate_rate_x,
        arm_b_rate_rate_y - arm_c_b_rate_rate_y,
    )
    distance_a_rate_rate = (
        span_a_rate_x * span_a_rate_x
        + span_a_rate_y * span_a_rate_y
        + span_a_x * span_a_rate_rate_x
        + span_a_y * span_a_rate_rate_y
    ) / distance_a - (span_a_x * span_a_rate_x + span_a_y * span_a_rate_y) * distance_a_rate / (
        distance_a * distance_a
    )
    distance_b_rate_rate = (
        span_b_rate_x * span_b_rate_x
        + span_b_rate_y * span_b_rate_y
        + span_b_x * span_b_rate_rate_x
        + span_b_y * span_b_rate_rate_y
    ) / distance_b - (span_b_x * span_b_rate_x + span_b_y * span_b_rate_y) * distance_b_rate / (
        distance_b * distance_b
    )
    return (distance_a_rate_rate + gear_ratio * distance_b_rate_rate,)


def angle_constraint(
    joint_angle: Scalar,
    orientation_a: Scalar,
    orientation_b: Scalar,
) -> tuple[Scalar, ...]:
    """Angle between two bodies: zero where it holds.

    orientation_b - orientation_a - joint_angle

    Args:
        joint_angle: Angle that a joint keeps between two bodies, rad
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad

    Source: angle, srs/models/joints.md:354.
    """
    return (orientation_b - orientation_a - joint_angle,)


def angle_slopes_a() -> tuple[Scalar, ...]:
    """Angle between two bodies: slopes by x, y and orientation of body A.

    0
    0
    -1

    Source: angle, srs/models/joints.md:354.
    """
    return (
        0,
        0,
        -1,
    )


def angle_slopes_b() -> tuple[Scalar, ...]:
    """Angle between two bodies: slopes by x, y and orientation of body B.

    0
    0
    1

    Source: angle, srs/models/joints.md:354.
    """
    return (
        0,
        0,
        1,
    )


def angle_rate(
    angular_velocity_a: Scalar,
    angular_velocity_b: Scalar,
) -> tuple[Scalar, ...]:
    """Angle between two bodies: rate of the constraint along the motion.

    angular_velocity_b - angular_velocity_a

    Args:
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s

    Source: angle, srs/models/joints.md:354.
    """
    return (angular_velocity_b - angular_velocity_a,)


def angle_convective() -> tuple[Scalar, ...]:
    """Angle between two bodies: second derivative of the constraint where no body is accelerated.

    0

    Source: angle, srs/models/joints.md:354.
    """
    return (0,)


def travel_constraint(
    anchor_a: Vector,
    guide_a: Vector,
    anchor_b: Vector,
    joint_travel: Scalar,
    position_a: Vector,
    orientation_a: Scalar,
    position_b: Vector,
    orientation_b: Scalar,
) -> tuple[Scalar, ...]:
    """Travel along a line: zero where it holds.

    dot(guide, span) - joint_travel
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where guide = rotate(guide_a, orientation_a)
        where span = position_b + arm_b - position_a - arm_a

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        guide_a: Unit vector along which a joint lets a body slide; of body A, 1
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        joint_travel: How far a body is along the line on which a joint lets it slide, m
        position_a: Position of the centre of mass; of body A, m
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        position_b: Position of the centre of mass; of body B, m
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad

    Source: travel, srs/models/joints.md:364.
    """
    anchor_a_x, anchor_a_y = anchor_a
    guide_a_x, guide_a_y = guide_a
    anchor_b_x, anchor_b_y = anchor_b
    position_a_x, position_a_y = position_a
    position_b_x, position_b_y = position_b
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    guide_x, guide_y = (
        cos(orientation_a) * guide_a_x - sin(orientation_a) * guide_a_y,
        sin(orientation_a) * guide_a_x + cos(orientation_a) * guide_a_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    return (guide_x * span_x + guide_y * span_y - joint_travel,)


def travel_slopes_a(
    anchor_a: Vector,
    guide_a: Vector,
    anchor_b: Vector,
    position_a: Vector,
    orientation_a: Scalar,
    position_b: Vector,
    orientation_b: Scalar,
) -> tuple[Scalar, ...]:
    """Travel along a line: slopes by x, y and orientation of body A.

    -x(guide)
    -y(guide)
    dot(perp(guide), span) - dot(perp(arm_a), guide)
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where guide = rotate(guide_a, orientation_a)
        where span = position_b + arm_b - position_a - arm_a

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        guide_a: Unit vector along which a joint lets a body slide; of body A, 1
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        position_a: Position of the centre of mass; of body A, m
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        position_b: Position of the centre of mass; of body B, m
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad

    Source: travel, srs/models/joints.md:364.
    """
    anchor_a_x, anchor_a_y = anchor_a
    guide_a_x, guide_a_y = guide_a
    anchor_b_x, anchor_b_y = anchor_b
    position_a_x, position_a_y = position_a
    position_b_x, position_b_y = position_b
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    guide_x, guide_y = (
        cos(orientation_a) * guide_a_x - sin(orientation_a) * guide_a_y,
        sin(orientation_a) * guide_a_x + cos(orientation_a) * guide_a_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    return (
        -guide_x,
        -guide_y,
        (-guide_y) * span_x + (guide_x) * span_y - ((-arm_a_y) * guide_x + (arm_a_x) * guide_y),
    )


def travel_slopes_b(
    guide_a: Vector,
    anchor_b: Vector,
    orientation_a: Scalar,
    orientation_b: Scalar,
) -> tuple[Scalar, ...]:
    """Travel along a line: slopes by x, y and orientation of body B.

    x(guide)
    y(guide)
    dot(guide, perp(arm_b))
        where arm_b = rotate(anchor_b, orientation_b)
        where guide = rotate(guide_a, orientation_a)

    Args:
        guide_a: Unit vector along which a joint lets a body slide; of body A, 1
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad

    Source: travel, srs/models/joints.md:364.
    """
    guide_a_x, guide_a_y = guide_a
    anchor_b_x, anchor_b_y = anchor_b
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    guide_x, guide_y = (
        cos(orientation_a) * guide_a_x - sin(orientation_a) * guide_a_y,
        sin(orientation_a) * guide_a_x + cos(orientation_a) * guide_a_y,
    )
    return (
        guide_x,
        guide_y,
        guide_x * (-arm_b_y) + guide_y * (arm_b_x),
    )


def travel_rate(
    anchor_a: Vector,
    guide_a: Vector,
    anchor_b: Vector,
    position_a: Vector,
    velocity_a: Vector,
    orientation_a: Scalar,
    angular_velocity_a: Scalar,
    position_b: Vector,
    velocity_b: Vector,
    orientation_b: Scalar,
    angular_velocity_b: Scalar,
) -> tuple[Scalar, ...]:
    """Travel along a line: rate of the constraint along the motion.

    dot(guide_rate, span) + dot(guide, span_rate)
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where guide = rotate(guide_a, orientation_a)
        where span = position_b + arm_b - position_a - arm_a
        where arm_a_rate = angular_velocity_a*perp(arm_a)
        where arm_b_rate = angular_velocity_b*perp(arm_b)
        where guide_rate = angular_velocity_a*perp(guide)
        where span_rate = velocity_b + arm_b_rate - velocity_a - arm_a_rate

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        guide_a: Unit vector along which a joint lets a body slide; of body A, 1
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        position_a: Position of the centre of mass; of body A, m
        velocity_a: Velocity of the centre of mass; of body A, m/s
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        position_b: Position of the centre of mass; of body B, m
        velocity_b: Velocity of the centre of mass; of body B, m/s
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s

    Source: travel, srs/models/joints.md:364.
    """
    anchor_a_x, anchor_a_y = anchor_a
    guide_a_x, guide_a_y = guide_a
    anchor_b_x, anchor_b_y = anchor_b
    position_a_x, position_a_y = position_a
    velocity_a_x, velocity_a_y = velocity_a
    position_b_x, position_b_y = position_b
    velocity_b_x, velocity_b_y = velocity_b
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    guide_x, guide_y = (
        cos(orientation_a) * guide_a_x - sin(orientation_a) * guide_a_y,
        sin(orientation_a) * guide_a_x + cos(orientation_a) * guide_a_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    arm_a_rate_x, arm_a_rate_y = (angular_velocity_a * (-arm_a_y), angular_velocity_a * (arm_a_x))
    arm_b_rate_x, arm_b_rate_y = (angular_velocity_b * (-arm_b_y), angular_velocity_b * (arm_b_x))
    guide_rate_x, guide_rate_y = (angular_velocity_a * (-guide_y), angular_velocity_a * (guide_x))
    span_rate_x, span_rate_y = (
        velocity_b_x + arm_b_rate_x - velocity_a_x - arm_a_rate_x,
        velocity_b_y + arm_b_rate_y - velocity_a_y - arm_a_rate_y,
    )
    return (
        guide_rate_x * span_x
        + guide_rate_y * span_y
        + guide_x * span_rate_x
        + guide_y * span_rate_y,
    )


def travel_convective(
    anchor_a: Vector,
    guide_a: Vector,
    anchor_b: Vector,
    position_a: Vector,
    velocity_a: Vector,
    orientation_a: Scalar,
    angular_velocity_a: Scalar,
    position_b: Vector,
    velocity_b: Vector,
    orientation_b: Scalar,
    angular_velocity_b: Scalar,
) -> tuple[Scalar, ...]:
    """Travel along a line: second derivative of the constraint where no body is accelerated.

    dot(guide_rate_rate, span) + dot(guide_rate, span_rate) + (dot(guide_rate, span_rate) +
        dot(guide, span_rate_rate))
        where arm_a = rotate(anchor_a, orientation_a)
        where arm_b = rotate(anchor_b, orientation_b)
        where guide = rotate(guide_a, orientation_a)
        where span = position_b + arm_b - position_a - arm_a
        where arm_a_rate = angular_velocity_a*perp(arm_a)
        where arm_b_rate = angular_velocity_b*perp(arm_b)
        where guide_rate = angular_velocity_a*perp(guide)
        where span_rate = velocity_b + arm_b_rate - velocity_a - arm_a_rate
        where arm_a_rate_rate = angular_velocity_a*perp(arm_a_rate)
        where arm_b_rate_rate = angular_velocity_b*perp(arm_b_rate)
        where guide_rate_rate = angular_velocity_a*perp(guide_rate)
        where span_rate_rate = arm_b_rate_rate - arm_a_rate_rate

    Args:
        anchor_a: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body A, m
        guide_a: Unit vector along which a joint lets a body slide; of body A, 1
        anchor_b: Place at which a joint holds a body, from its centre of mass, in the body's
            own axes; of body B, m
        position_a: Position of the centre of mass; of body A, m
        velocity_a: Velocity of the centre of mass; of body A, m/s
        orientation_a: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body A, rad
        angular_velocity_a: Rate of turning, positive counter-clockwise; of body A, rad/s
        position_b: Position of the centre of mass; of body B, m
        velocity_b: Velocity of the centre of mass; of body B, m/s
        orientation_b: Angle by which the body is turned counter-clockwise from its drawn
            position, unbounded; of body B, rad
        angular_velocity_b: Rate of turning, positive counter-clockwise; of body B, rad/s

    Source: travel, srs/models/joints.md:364.
    """
    anchor_a_x, anchor_a_y = anchor_a
    guide_a_x, guide_a_y = guide_a
    anchor_b_x, anchor_b_y = anchor_b
    position_a_x, position_a_y = position_a
    velocity_a_x, velocity_a_y = velocity_a
    position_b_x, position_b_y = position_b
    velocity_b_x, velocity_b_y = velocity_b
    arm_a_x, arm_a_y = (
        cos(orientation_a) * anchor_a_x - sin(orientation_a) * anchor_a_y,
        sin(orientation_a) * anchor_a_x + cos(orientation_a) * anchor_a_y,
    )
    arm_b_x, arm_b_y = (
        cos(orientation_b) * anchor_b_x - sin(orientation_b) * anchor_b_y,
        sin(orientation_b) * anchor_b_x + cos(orientation_b) * anchor_b_y,
    )
    guide_x, guide_y = (
        cos(orientation_a) * guide_a_x - sin(orientation_a) * guide_a_y,
        sin(orientation_a) * guide_a_x + cos(orientation_a) * guide_a_y,
    )
    span_x, span_y = (
        position_b_x + arm_b_x - position_a_x - arm_a_x,
        position_b_y + arm_b_y - position_a_y - arm_a_y,
    )
    arm_a_rate_x, arm_a_rate_y = (angular_velocity_a * (-arm_a_y), angular_velocity_a * (arm_a_x))
    arm_b_rate_x, arm_b_rate_y = (angular_velocity_b * (-arm_b_y), angular_velocity_b * (arm_b_x))
    guide_rate_x, guide_rate_y = (angular_velocity_a * (-guide_y), angular_velocity_a * (guide_x))
    span_rate_x, span_rate_y = (
        velocity_b_x + arm_b_rate_x - velocity_a_x - arm_a_rate_x,
        velocity_b_y + arm_b_rate_y - velocity_a_y - arm_a_rate_y,
    )
    arm_a_rate_rate_x, arm_a_rate_rate_y = (
        angular_velocity_a * (-arm_a_rate_y),
        angular_velocity_a * (arm_a_rate_x),
    )
    arm_b_rate_rate_x, arm_b_rate_rate_y = (
        angular_velocity_b * (-arm_b_rate_y),
        angular_velocity_b * (arm_b_rate_x),
    )
    guide_rate_rate_x, guide_rate_rate_y = (
        angular_velocity_a * (-guide_rate_y),
        angular_velocity_a * (guide_rate_x),
    )
    span_rate_rate_x, span_rate_rate_y = (
        arm_b_rate_rate_x - arm_a_rate_rate_x,
        arm_b_rate_rate_y - arm_a_rate_rate_y,
    )
    return (
        guide_rate_rate_x * span_x
        + guide_rate_rate_y * span_y
        + guide_rate_x * span_rate_x
        + guide_rate_y * span_rate_y
        + guide_rate_x * span_rate_x
        + guide_rate_y * span_rate_y
        + guide_x * span_rate_rate_x
        + guide_y * span_rate_rate_y,
    )


CONSTRAINTS: dict[str, ConstraintFunctions] = {
    "revolute": ConstraintFunctions(
        name="revolute",
        parameters=(
            "anchor_a",
            "anchor_b",
        ),
        bodies=(
            "a",
            "b",
        ),
        units=(
            "m",
            "m",
        ),
        constraint=Formula(
            revolute_constraint,
            (
                "anchor_a",
                "anchor_b",
                "position_a",
                "orientation_a",
                "position_b",
                "orientation_b",
            ),
        ),
        slopes={
            "a": Formula(
                revolute_slopes_a,
                (
                    "anchor_a",
                    "orientation_a",
                ),
            ),
            "b": Formula(
                revolute_slopes_b,
                (
                    "anchor_b",
                    "orientation_b",
                ),
            ),
        },
        rate=Formula(
            revolute_rate,
            (
                "anchor_a",
                "anchor_b",
                "velocity_a",
                "orientation_a",
                "angular_velocity_a",
                "velocity_b",
                "orientation_b",
                "angular_velocity_b",
            ),
        ),
        convective=Formula(
            revolute_convective,
            (
                "anchor_a",
                "anchor_b",
                "orientation_a",
                "angular_velocity_a",
                "orientation_b",
                "angular_velocity_b",
            ),
        ),
    ),
    "distance": ConstraintFunctions(
        name="distance",
        parameters=(
            "anchor_a",
            "anchor_b",
            "joint_length",
        ),
        bodies=(
            "a",
            "b",
        ),
        units=("m",),
        constraint=Formula(
            distance_constraint,
            (
                "anchor_a",
                "anchor_b",
                "joint_length",
                "position_a",
                "orientation_a",
                "position_b",
                "orientation_b",
            ),
        ),
        slopes={
            "a": Formula(
                distance_slopes_a,
                (
                    "anchor_a",
                    "anchor_b",
                    "position_a",
                    "orientation_a",
                    "position_b",
                    "orientation_b",
                ),
            ),
            "b": Formula(
                distance_slopes_b,
                (
                    "anchor_a",
                    "anchor_b",
                    "position_a",
                    "orientation_a",
                    "position_b",
                    "orientation_b",
                ),
            ),
        },
        rate=Formula(
            distance_rate,
            (
                "anchor_a",
                "anchor_b",
                "position_a",
                "velocity_a",
                "orientation_a",
                "angular_velocity_a",
                "position_b",
                "velocity_b",
                "orientation_b",
                "angular_velocity_b",
            ),
        ),
        convective=Formula(
            distance_convective,
            (
                "anchor_a",
                "anchor_b",
                "position_a",
                "velocity_a",
                "orientation_a",
                "angular_velocity_a",
                "position_b",
                "velocity_b",
                "orientation_b",
                "angular_velocity_b",
            ),
        ),
    ),
    "weld": ConstraintFunctions(
        name="weld",
        parameters=(
            "anchor_a",
            "anchor_b",
            "joint_angle",
        ),
        bodies=(
            "a",
            "b",
        ),
        units=(
            "m",
            "m",
            "1",
        ),
        constraint=Formula(
            weld_constraint,
            (
                "anchor_a",
                "anchor_b",
                "joint_angle",
                "position_a",
                "orientation_a",
                "position_b",
                "orientation_b",
            ),
        ),
        slopes={
            "a": Formula(
                weld_slopes_a,
                (
                    "anchor_a",
                    "orientation_a",
                ),
            ),
            "b": Formula(
                weld_slopes_b,
                (
                    "anchor_b",
                    "orientation_b",
                ),
            ),
        },
        rate=Formula(
            weld_rate,
            (
                "anchor_a",
                "anchor_b",
                "velocity_a",
                "orientation_a",
                "angular_velocity_a",
                "velocity_b",
                "orientation_b",
                "angular_velocity_b",
            ),
        ),
        convective=Formula(
            weld_convective,
            (
                "anchor_a",
                "anchor_b",
                "orientation_a",
                "angular_velocity_a",
                "orientation_b",
                "angular_velocity_b",
            ),
        ),
    ),
    "prismatic": ConstraintFunctions(
        name="prismatic",
        parameters=(
            "anchor_a",
            "guide_a",
            "anchor_b",
            "joint_angle",
        ),
        bodies=(
            "a",
            "b",
        ),
        units=(
            "m",
            "1",
        ),
        constraint=Formula(
            prismatic_constraint,
            (
                "anchor_a",
                "guide_a",
                "anchor_b",
                "joint_angle",
                "position_a",
                "orientation_a",
                "position_b",
                "orientation_b",
            ),
        ),
        slopes={
            "a": Formula(
                prismatic_slopes_a,
                (
                    "anchor_a",
                    "guide_a",
                    "anchor_b",
                    "position_a",
                    "orientation_a",
                    "position_b",
                    "orientation_b",
                ),
            ),
            "b": Formula(
                prismatic_slopes_b,
                (
                    "guide_a",
                    "anchor_b",
                    "orientation_a",
                    "orientation_b",
                ),
            ),
        },
        rate=Formula(
            prismatic_rate,
            (
                "anchor_a",
                "guide_a",
                "anchor_b",
                "position_a",
                "velocity_a",
                "orientation_a",
                "angular_velocity_a",
                "position_b",
                "velocity_b",
                "orientation_b",
                "angular_velocity_b",
            ),
        ),
        convective=Formula(
            prismatic_convective,
            (
                "anchor_a",
                "guide_a",
                "anchor_b",
                "position_a",
                "velocity_a",
                "orientation_a",
                "angular_velocity_a",
                "position_b",
                "velocity_b",
                "orientation_b",
                "angular_velocity_b",
            ),
        ),
    ),
    "groove": ConstraintFunctions(
        name="groove",
        parameters=(
            "anchor_a",
            "guide_a",
            "anchor_b",
        ),
        bodies=(
            "a",
            "b",
        ),
        units=("m",),
        constraint=Formula(
            groove_constraint,
            (
                "anchor_a",
                "guide_a",
                "anchor_b",
                "position_a",
                "orientation_a",
                "position_b",
                "orientation_b",
            ),
        ),
        slopes={
            "a": Formula(
                groove_slopes_a,
                (
                    "anchor_a",
                    "guide_a",
                    "anchor_b",
                    "position_a",
                    "orientation_a",
                    "position_b",
                    "orientation_b",
                ),
            ),
            "b": Formula(
                groove_slopes_b,
                (
                    "guide_a",
                    "anchor_b",
                    "orientation_a",
                    "orientation_b",
                ),
            ),
        },
        rate=Formula(
            groove_rate,
            (
                "anchor_a",
                "guide_a",
                "anchor_b",
                "position_a",
                "velocity_a",
                "orientation_a",
                "angular_velocity_a",
                "position_b",
                "velocity_b",
                "orientation_b",
                "angular_velocity_b",
            ),
        ),
        convective=Formula(
            groove_convective,
            (
                "anchor_a",
                "guide_a",
                "anchor_b",
                "position_a",
                "velocity_a",
                "orientation_a",
                "angular_velocity_a",
                "position_b",
                "velocity_b",
                "orientation_b",
                "angular_velocity_b",
            ),
        ),
    ),
    "gear": ConstraintFunctions(
        name="gear",
        parameters=(
            "gear_ratio",
            "joint_angle",
        ),
        bodies=(
            "a",
            "b",
            "c",
        ),
        units=("1",),
        constraint=Formula(
            gear_constraint,
            (
                "gear_ratio",
                "joint_angle",
                "orientation_a",
                "orientation_b",
                "orientation_c",
            ),
        ),
        slopes={
            "a": Formula(gear_slopes_a, ("gear_ratio",)),
            "b": Formula(gear_slopes_b, ()),
            "c": Formula(gear_slopes_c, ("gear_ratio",)),
        },
        rate=Formula(
            gear_rate,
            (
                "gear_ratio",
                "angular_velocity_a",
                "angular_velocity_b",
                "angular_velocity_c",
            ),
        ),
        convective=Formula(gear_convective, ()),
    ),
    "pulley": ConstraintFunctions(
        name="pulley",
        parameters=(
            "anchor_a",
            "anchor_b",
            "post_a",
            "post_b",
            "gear_ratio",
            "joint_length",
        ),
        bodies=(
            "a",
            "b",
            "c",
        ),
        units=("m",),
        constraint=Formula(
            pulley_constraint,
            (
                "anchor_a",
                "anchor_b",
                "post_a",
                "post_b",
                "gear_ratio",
                "joint_length",
                "position_a",
                "orientation_a",
                "position_b",
                "orientation_b",
                "position_c",
                "orientation_c",
            ),
        ),
        slopes={
            "a": Formula(
                pulley_slopes_a,
                (
                    "anchor_a",
                    "post_a",
                    "position_a",
                    "orientation_a",
                    "position_c",
                    "orientation_c",
                ),
            ),
            "b": Formula(
                pulley_slopes_b,
                (
                    "anchor_b",
                    "post_b",
                    "gear_ratio",
                    "position_b",
                    "orientation_b",
                    "position_c",
                    "orientation_c",
                ),
            ),
            "c": Formula(
                pulley_slopes_c,
                (
                    "anchor_a",
                    "anchor_b",
                    "post_a",
                    "post_b",
                    "gear_ratio",
                    "position_a",
                    "orientation_a",
                    "position_b",
                    "orientation_b",
                    "position_c",
                    "orientation_c",
                ),
            ),
        },
        rate=Formula(
            pulley_rate,
            (
                "anchor_a",
                "anchor_b",
                "post_a",
                "post_b",
                "gear_ratio",
                "position_a",
                "velocity_a",
                "orientation_a",
                "angular_velocity_a",
                "position_b",
                "velocity_b",
                "orientation_b",
                "angular_velocity_b",
                "position_c",
                "velocity_c",
                "orientation_c",
                "angular_velocity_c",
            ),
        ),
        convective=Formula(
            pulley_convective,
            (
                "anchor_a",
                "anchor_b",
                "post_a",
                "post_b",
                "gear_ratio",
                "position_a",
                "velocity_a",
                "orientation_a",
                "angular_velocity_a",
                "position_b",
                "velocity_b",
                "orientation_b",
                "angular_velocity_b",
                "position_c",
                "velocity_c",
                "orientation_c",
                "angular_velocity_c",
            ),
        ),
    ),
    "angle": ConstraintFunctions(
        name="angle",
        parameters=("joint_angle",),
        bodies=(
            "a",
            "b",
        ),
        units=("1",),
        constraint=Formula(
            angle_constraint,
            (
                "joint_angle",
                "orientation_a",
                "orientation_b",
            ),
        ),
        slopes={"a": Formula(angle_slopes_a, ()), "b": Formula(angle_slopes_b, ())},
        rate=Formula(
            angle_rate,
            (
                "angular_velocity_a",
                "angular_velocity_b",
            ),
        ),
        convective=Formula(angle_convective, ()),
    ),
    "travel": ConstraintFunctions(
        name="travel",
        parameters=(
            "anchor_a",
            "guide_a",
            "anchor_b",
            "joint_travel",
        ),
        bodies=(
            "a",
            "b",
        ),
        units=("m",),
        constraint=Formula(
            travel_constraint,
            (
                "anchor_a",
                "guide_a",
                "anchor_b",
                "joint_travel",
                "position_a",
                "orientation_a",
                "position_b",
                "orientation_b",
            ),
        ),
        slopes={
            "a": Formula(
                travel_slopes_a,
                (
                    "anchor_a",
                    "guide_a",
                    "anchor_b",
                    "position_a",
                    "orientation_a",
                    "position_b",
                    "orientation_b",
                ),
            ),
            "b": Formula(
                travel_slopes_b,
                (
                    "guide_a",
                    "anchor_b",
                    "orientation_a",
                    "orientation_b",
                ),
            ),
        },
        rate=Formula(
            travel_rate,
            (
                "anchor_a",
                "guide_a",
                "anchor_b",
                "position_a",
                "velocity_a",
                "orientation_a",
                "angular_velocity_a",
                "position_b",
                "velocity_b",
                "orientation_b",
                "angular_velocity_b",
            ),
        ),
        convective=Formula(
            travel_convective,
            (
                "anchor_a",
                "guide_a",
                "anchor_b",
                "position_a",
                "velocity_a",
                "orientation_a",
                "angular_velocity_a",
                "position_b",
                "velocity_b",
                "orientation_b",
                "angular_velocity_b",
            ),
        ),
    ),
}
