"""Hinge tree: Articulated-body inertia; Impulse through a hinge.

Generated from srs/models/hinge_tree.md
by `python -m tools.generate`. Edit the chapter, not this file.
"""

from tamias2d.spec.functions import Scalar, Vector, power


def point_yield_x(inverse_mass: Scalar, inverse_inertia: Scalar, hinge_arm: Vector) -> Vector:
    """Change of the velocity of a body's point along x for impulses there (1/kg).

    point_yield_x = vector(inverse_mass + inverse_inertia*y(hinge_arm)**2,
    -inverse_inertia*x(hinge_arm)*y(hinge_arm))

    Args:
        inverse_mass: One over the mass, zero for a static body, 1/kg
        inverse_inertia: One over the inertia, zero for a body that cannot turn, 1/(kg*m^2)
        hinge_arm: From the centre of mass of a body to the hinge on which it hangs, m

    Source: DD70, srs/models/hinge_tree.md:43.
    """
    hinge_arm_x, hinge_arm_y = hinge_arm
    return (
        inverse_mass + inverse_inertia * power(hinge_arm_y, 2),
        (-inverse_inertia) * hinge_arm_x * hinge_arm_y,
    )


def point_yield_y(inverse_mass: Scalar, inverse_inertia: Scalar, hinge_arm: Vector) -> Vector:
    """Change of the velocity of a body's point along y for impulses there (1/kg).

    point_yield_y = vector(-inverse_inertia*x(hinge_arm)*y(hinge_arm), inverse_mass +
    inverse_inertia*x(hinge_arm)**2)

    Args:
        inverse_mass: One over the mass, zero for a static body, 1/kg
        inverse_inertia: One over the inertia, zero for a body that cannot turn, 1/(kg*m^2)
        hinge_arm: From the centre of mass of a body to the hinge on which it hangs, m

    Source: DD70, srs/models/hinge_tree.md:46.
    """
    hinge_arm_x, hinge_arm_y = hinge_arm
    return (
        (-inverse_inertia) * hinge_arm_x * hinge_arm_y,
        inverse_mass + inverse_inertia * power(hinge_arm_x, 2),
    )


def link_mass_x(link_yield_x: Vector, link_yield_y: Vector) -> Vector:
    """Impulse of a link along x for its rates (kg).

    link_mass_x = vector(y(link_yield_y), -y(link_yield_x))/(x(link_yield_x)*y(link_yield_y) -
    y(link_yield_x)*x(link_yield_y))

    Args:
        link_yield_x: Change of the rate of a link along x for its impulses, 1/kg
        link_yield_y: Change of the rate of a link along y for its impulses, 1/kg

    Source: DD70, srs/models/hinge_tree.md:49.
    """
    link_yield_x_x, link_yield_x_y = link_yield_x
    link_yield_y_x, link_yield_y_y = link_yield_y
    return (
        link_yield_y_y / (link_yield_x_x * link_yield_y_y - link_yield_x_y * link_yield_y_x),
        (-link_yield_x_y) / (link_yield_x_x * link_yield_y_y - link_yield_x_y * link_yield_y_x),
    )


def link_mass_y(link_yield_x: Vector, link_yield_y: Vector) -> Vector:
    """Impulse of a link along y for its rates (kg).

    link_mass_y = vector(-x(link_yield_y), x(link_yield_x))/(x(link_yield_x)*y(link_yield_y) -
    y(link_yield_x)*x(link_yield_y))

    Args:
        link_yield_x: Change of the rate of a link along x for its impulses, 1/kg
        link_yield_y: Change of the rate of a link along y for its impulses, 1/kg

    Source: DD70, srs/models/hinge_tree.md:52.
    """
    link_yield_x_x, link_yield_x_y = link_yield_x
    link_yield_y_x, link_yield_y_y = link_yield_y
    return (
        (-link_yield_y_x) / (link_yield_x_x * link_yield_y_y - link_yield_x_y * link_yield_y_x),
        link_yield_x_x / (link_yield_x_x * link_yield_y_y - link_yield_x_y * link_yield_y_x),
    )


def link_impulse(link_rate: Vector, link_mass_x: Vector, link_mass_y: Vector) -> Vector:
    """Impulse of a link by itself (N*s).

    link_impulse = x(link_rate)*link_mass_x + y(link_rate)*link_mass_y

    Args:
        link_rate: Rate that a link is to get by an impulse, m/s
        link_mass_x: Impulse of a link along x for its rates, kg
        link_mass_y: Impulse of a link along y for its rates, kg

    Source: DD70, srs/models/hinge_tree.md:55.
    """
    link_rate_x, link_rate_y = link_rate
    link_mass_x_x, link_mass_x_y = link_mass_x
    link_mass_y_x, link_mass_y_y = link_mass_y
    return (
        link_rate_x * link_mass_x_x + link_rate_y * link_mass_y_x,
        link_rate_x * link_mass_x_y + link_rate_y * link_mass_y_y,
    )


def link_answer(link_impulse: Vector, link_yield_x: Vector, link_yield_y: Vector) -> Vector:
    """Change of the rate of a link by its own impulse (m/s).

    link_answer = x(link_impulse)*link_yield_x + y(link_impulse)*link_yield_y

    Args:
        link_impulse: Impulse of a link by itself, N*s
        link_yield_x: Change of the rate of a link along x for its impulses, 1/kg
        link_yield_y: Change of the rate of a link along y for its impulses, 1/kg

    Source: DD70, srs/models/hinge_tree.md:57.
    """
    link_impulse_x, link_impulse_y = link_impulse
    link_yield_x_x, link_yield_x_y = link_yield_x
    link_yield_y_x, link_yield_y_y = link_yield_y
    return (
        link_impulse_x * link_yield_x_x + link_impulse_y * link_yield_y_x,
        link_impulse_x * link_yield_x_y + link_impulse_y * link_yield_y_y,
    )


def hinged_yield(
    row_yield: Scalar, link_rate: Vector, link_impulse: Vector, row_impulse: Scalar
) -> Scalar:
    """Yield of a row with the hinge on which its body hangs (1/kg).

    hinged_yield = row_yield - dot(link_rate, link_impulse)/row_impulse**2

    Args:
        row_yield: Change of a row's rate for one unit of its impulse, or a body's part in it,
            1/kg
        link_rate: Rate that a link is to get by an impulse, m/s
        link_impulse: Impulse of a link by itself, N*s
        row_impulse: Impulse of a row of a joint, for slopes of length one, N*s

    Source: DD70, srs/models/hinge_tree.md:59.
    """
    link_rate_x, link_rate_y = link_rate
    link_impulse_x, link_impulse_y = link_impulse
    return row_yield - (link_rate_x * link_impulse_x + link_rate_y * link_impulse_y) / (
        row_impulse * row_impulse
    )


def hinge_arm(anchor: Vector, orientation_cosine: Scalar, orientation_sine: Scalar) -> Vector:
    """From the centre of mass of a body to the hinge on which it hangs (m).

    hinge_arm = orientation_cosine*anchor + orientation_sine*perp(anchor)

    Args:
        anchor: Place at which a joint holds a body, from its centre of mass, in the body's own
            axes, m
        orientation_cosine: Cosine of the orientation, 1
        orientation_sine: Sine of the orientation, 1

    Source: DD70, srs/models/hinge_tree.md:25.
    """
    anchor_x, anchor_y = anchor
    return (
        orientation_cosine * anchor_x + orientation_sine * (-anchor_y),
        orientation_cosine * anchor_y + orientation_sine * (anchor_x),
    )


def hinge_gap(
    position: Vector, hinge_arm: Vector, position_above: Vector, arm_above: Vector
) -> Vector:
    """By how much a hinge is apart (m).

    hinge_gap = position + hinge_arm - position_above - arm_above

    Args:
        position: Position of the centre of mass, m
        hinge_arm: From the centre of mass of a body to the hinge on which it hangs, m
        position_above: Position of the body above a hinge, m
        arm_above: From the centre of mass of the body above a hinge to the hinge, m

    Source: DD70, srs/models/hinge_tree.md:26.
    """
    position_x, position_y = position
    hinge_arm_x, hinge_arm_y = hinge_arm
    position_above_x, position_above_y = position_above
    arm_above_x, arm_above_y = arm_above
    return (
        position_x + hinge_arm_x - position_above_x - arm_above_x,
        position_y + hinge_arm_y - position_above_y - arm_above_y,
    )


def arm_met(arm_above: Vector, hinge_gap: Vector) -> Vector:
    """From the body above to the point of a hinge where impulses meet (m).

    arm_met = arm_above + hinge_gap

    Args:
        arm_above: From the centre of mass of the body above a hinge to the hinge, m
        hinge_gap: By how much a hinge is apart, m

    Source: DD70, srs/models/hinge_tree.md:27.
    """
    arm_above_x, arm_above_y = arm_above
    hinge_gap_x, hinge_gap_y = hinge_gap
    return (arm_above_x + hinge_gap_x, arm_above_y + hinge_gap_y)


def hinge_moment(
    node_mass_x: Vector, node_mass_y: Vector, node_moment: Vector, hinge_arm: Vector
) -> Vector:
    """Momentum of a node for its turning about its hinge (kg*m).

    hinge_moment = node_moment + y(hinge_arm)*node_mass_x - x(hinge_arm)*node_mass_y

    Args:
        node_mass_x: Momentum along x of a node for its velocities, kg
        node_mass_y: Momentum along y of a node for its velocities, kg
        node_moment: Momentum of a node for its turning about its centre of mass, kg*m
        hinge_arm: From the centre of mass of a body to the hinge on which it hangs, m

    Source: DD70, srs/models/hinge_tree.md:28.
    """
    node_mass_x_x, node_mass_x_y = node_mass_x
    node_mass_y_x, node_mass_y_y = node_mass_y
    node_moment_x, node_moment_y = node_moment
    hinge_arm_x, hinge_arm_y = hinge_arm
    return (
        node_moment_x + hinge_arm_y * node_mass_x_x - hinge_arm_x * node_mass_y_x,
        node_moment_y + hinge_arm_y * node_mass_x_y - hinge_arm_x * node_mass_y_y,
    )


def hinge_inertia(
    node_moment: Vector, node_inertia: Scalar, hinge_moment: Vector, hinge_arm: Vector
) -> Scalar:
    """Angular momentum of a node about its hinge for its turning there (kg*m^2).

    hinge_inertia = node_inertia + y(hinge_arm)*(x(node_moment) + x(hinge_moment)) -
    x(hinge_arm)*(y(node_moment) + y(hinge_moment))

    Args:
        node_moment: Momentum of a node for its turning about its centre of mass, kg*m
        node_inertia: Angular momentum of a node for its turning about its centre of mass,
            kg*m^2
        hinge_moment: Momentum of a node for its turning about its hinge, kg*m
        hinge_arm: From the centre of mass of a body to the hinge on which it hangs, m

    Source: DD70, srs/models/hinge_tree.md:30.
    """
    node_moment_x, node_moment_y = node_moment
    hinge_moment_x, hinge_moment_y = hinge_moment
    hinge_arm_x, hinge_arm_y = hinge_arm
    return (
        node_inertia
        + hinge_arm_y * (node_moment_x + hinge_moment_x)
        - hinge_arm_x * (node_moment_y + hinge_moment_y)
    )


def turning_yield(hinge_inertia: Scalar, turning_firmness: Scalar) -> Scalar:
    """Change of the rate of turning for one unit of angular momentum at a hinge (1/(kg*m^2)).

    turning_yield = 1/(hinge_inertia + turning_firmness)

    Args:
        hinge_inertia: Angular momentum of a node about its hinge for its turning there, kg*m^2
        turning_firmness: Firmness with which laws of a hinge answer the turning of its bodies,
            kg*m^2

    Source: DD70, srs/models/hinge_tree.md:33.
    """
    return 1 / (hinge_inertia + turning_firmness)


def turned_share(turning_firmness: Scalar, turning_yield: Scalar) -> Scalar:
    """Share of the turning of the body above that laws pass on to a node (1).

    turned_share = turning_firmness*turning_yield

    Args:
        turning_firmness: Firmness with which laws of a hinge answer the turning of its bodies,
            kg*m^2
        turning_yield: Change of the rate of turning for one unit of angular momentum at a
            hinge, 1/(kg*m^2)

    Source: DD70, srs/models/hinge_tree.md:34.
    """
    return turning_firmness * turning_yield


def hinge_lever(hinge_moment: Vector, turning_yield: Scalar) -> Vector:
    """Turning of a node for the velocity of its hinge, with the other sign (1/m).

    hinge_lever = turning_yield*hinge_moment

    Args:
        hinge_moment: Momentum of a node for its turning about its hinge, kg*m
        turning_yield: Change of the rate of turning for one unit of angular momentum at a
            hinge, 1/(kg*m^2)

    Source: DD70, srs/models/hinge_tree.md:35.
    """
    hinge_moment_x, hinge_moment_y = hinge_moment
    return (turning_yield * hinge_moment_x, turning_yield * hinge_moment_y)


def hung_mass(node_mass: Vector, lever_along: Scalar, hinge_moment: Vector) -> Vector:
    """Impulse along one axis that a hinge takes for velocities of its point (kg).

    hung_mass = node_mass - lever_along*hinge_moment

    Args:
        node_mass: Momentum along one axis of a node for its velocities, kg
        lever_along: Lever of a hinge along one axis, 1/m
        hinge_moment: Momentum of a node for its turning about its hinge, kg*m

    Source: DD70, srs/models/hinge_tree.md:36.
    """
    node_mass_x, node_mass_y = node_mass
    hinge_moment_x, hinge_moment_y = hinge_moment
    return (node_mass_x - lever_along * hinge_moment_x, node_mass_y - lever_along * hinge_moment_y)


def hung_moment(
    hung_mass_x: Vector,
    hung_mass_y: Vector,
    hinge_moment: Vector,
    turned_share: Scalar,
    arm_above: Vector,
) -> Vector:
    """Impulse that a hinge takes for the turning of the body above (kg*m).

    hung_moment = x(arm_above)*hung_mass_y - y(arm_above)*hung_mass_x +
    turned_share*hinge_moment

    Args:
        hung_mass_x: Impulse along x that a hinge takes for velocities of its point, kg
        hung_mass_y: Impulse along y that a hinge takes for velocities of its point, kg
        hinge_moment: Momentum of a node for its turning about its hinge, kg*m
        turned_share: Share of the turning of the body above that laws pass on to a node, 1
        arm_above: From the centre of mass of the body above a hinge to the hinge, m

    Source: DD70, srs/models/hinge_tree.md:37.
    """
    hung_mass_x_x, hung_mass_x_y = hung_mass_x
    hung_mass_y_x, hung_mass_y_y = hung_mass_y
    hinge_moment_x, hinge_moment_y = hinge_moment
    arm_above_x, arm_above_y = arm_above
    return (
        arm_above_x * hung_mass_y_x - arm_above_y * hung_mass_x_x + turned_share * hinge_moment_x,
        arm_above_x * hung_mass_y_y - arm_above_y * hung_mass_x_y + turned_share * hinge_moment_y,
    )


def hung_inertia(
    hung_moment: Vector,
    hinge_moment: Vector,
    hinge_inertia: Scalar,
    turned_share: Scalar,
    arm_above: Vector,
) -> Scalar:
    """Angular impulse that a hinge takes for the turning of the body above (kg*m^2).

    hung_inertia = cross(arm_above, hung_moment) + turned_share*(hinge_inertia +
    cross(arm_above, hinge_moment))

    Args:
        hung_moment: Impulse that a hinge takes for the turning of the body above, kg*m
        hinge_moment: Momentum of a node for its turning about its hinge, kg*m
        hinge_inertia: Angular momentum of a node about its hinge for its turning there, kg*m^2
        turned_share: Share of the turning of the body above that laws pass on to a node, 1
        arm_above: From the centre of mass of the body above a hinge to the hinge, m

    Source: DD70, srs/models/hinge_tree.md:40.
    """
    hung_moment_x, hung_moment_y = hung_moment
    hinge_moment_x, hinge_moment_y = hinge_moment
    arm_above_x, arm_above_y = arm_above
    return (
        arm_above_x * hung_moment_y
        - arm_above_y * hung_moment_x
        + turned_share
        * (hinge_inertia + arm_above_x * hinge_moment_y - arm_above_y * hinge_moment_x)
    )


def law_impulse(turning_firmness: Scalar, turning_error: Scalar) -> Scalar:
    """Angular impulse that laws of a hinge ask for (kg*m^2/s).

    law_impulse = turning_firmness*turning_error

    Args:
        turning_firmness: Firmness with which laws of a hinge answer the turning of its bodies,
            kg*m^2
        turning_error: Rate of turning that laws of a hinge have not answered yet, rad/s

    Source: DD71, srs/models/hinge_tree.md:99.
    """
    return turning_firmness * turning_error


def turn_bias(
    angular_momentum_bias: Scalar, momentum_bias: Vector, hinge_arm: Vector, law_impulse: Scalar
) -> Scalar:
    """Bias angular impulse of a node about its hinge, with its laws (kg*m^2/s).

    turn_bias = angular_momentum_bias - cross(hinge_arm, momentum_bias) + law_impulse

    Args:
        angular_momentum_bias: Bias angular impulse of a node, about its centre of mass,
            kg*m^2/s
        momentum_bias: Bias impulse of a node, kg*m/s
        hinge_arm: From the centre of mass of a body to the hinge on which it hangs, m
        law_impulse: Angular impulse that laws of a hinge ask for, kg*m^2/s

    Source: DD71, srs/models/hinge_tree.md:100.
    """
    momentum_bias_x, momentum_bias_y = momentum_bias
    hinge_arm_x, hinge_arm_y = hinge_arm
    return (
        angular_momentum_bias
        - (hinge_arm_x * momentum_bias_y - hinge_arm_y * momentum_bias_x)
        + law_impulse
    )


def momentum_hung(momentum_bias: Vector, turn_bias: Scalar, hinge_lever: Vector) -> Vector:
    """Impulse through a hinge whose point does not change its velocity (kg*m/s).

    momentum_hung = momentum_bias - turn_bias*hinge_lever

    Args:
        momentum_bias: Bias impulse of a node, kg*m/s
        turn_bias: Bias angular impulse of a node about its hinge, with its laws, kg*m^2/s
        hinge_lever: Turning of a node for the velocity of its hinge, with the other sign, 1/m

    Source: DD71, srs/models/hinge_tree.md:102.
    """
    momentum_bias_x, momentum_bias_y = momentum_bias
    hinge_lever_x, hinge_lever_y = hinge_lever
    return (
        momentum_bias_x - turn_bias * hinge_lever_x,
        momentum_bias_y - turn_bias * hinge_lever_y,
    )


def momentum_passed(
    momentum_hung: Vector, hinge_error: Vector, hung_mass_x: Vector, hung_mass_y: Vector
) -> Vector:
    """Bias impulse that a node passes to the body above (kg*m/s).

    momentum_passed = momentum_hung - x(hinge_error)*hung_mass_x - y(hinge_error)*hung_mass_y

    Args:
        momentum_hung: Impulse through a hinge whose point does not change its velocity, kg*m/s
        hinge_error: Rate at which a hinge parts, beyond the one wanted, m/s
        hung_mass_x: Impulse along x that a hinge takes for velocities of its point, kg
        hung_mass_y: Impulse along y that a hinge takes for velocities of its point, kg

    Source: DD71, srs/models/hinge_tree.md:103.
    """
    momentum_hung_x, momentum_hung_y = momentum_hung
    hinge_error_x, hinge_error_y = hinge_error
    hung_mass_x_x, hung_mass_x_y = hung_mass_x
    hung_mass_y_x, hung_mass_y_y = hung_mass_y
    return (
        momentum_hung_x - hinge_error_x * hung_mass_x_x - hinge_error_y * hung_mass_y_x,
        momentum_hung_y - hinge_error_x * hung_mass_x_y - hinge_error_y * hung_mass_y_y,
    )


def angular_momentum_passed(
    momentum_passed: Vector,
    turn_bias: Scalar,
    hinge_error: Vector,
    hinge_moment: Vector,
    turned_share: Scalar,
    arm_above: Vector,
    law_impulse: Scalar,
) -> Scalar:
    """Bias angular impulse that a node passes to the body above (kg*m^2/s).

    angular_momentum_passed = cross(arm_above, momentum_passed) + turned_share*(turn_bias -
    dot(hinge_moment, hinge_error)) - law_impulse

    Args:
        momentum_passed: Bias impulse that a node passes to the body above, kg*m/s
        turn_bias: Bias angular impulse of a node about its hinge, with its laws, kg*m^2/s
        hinge_error: Rate at which a hinge parts, beyond the one wanted, m/s
        hinge_moment: Momentum of a node for its turning about its hinge, kg*m
        turned_share: Share of the turning of the body above that laws pass on to a node, 1
        arm_above: From the centre of mass of the body above a hinge to the hinge, m
        law_impulse: Angular impulse that laws of a hinge ask for, kg*m^2/s

    Source: DD71, srs/models/hinge_tree.md:105.
    """
    momentum_passed_x, momentum_passed_y = momentum_passed
    hinge_error_x, hinge_error_y = hinge_error
    hinge_moment_x, hinge_moment_y = hinge_moment
    arm_above_x, arm_above_y = arm_above
    return (
        arm_above_x * momentum_passed_y
        - arm_above_y * momentum_passed_x
        + turned_share
        * (turn_bias - (hinge_moment_x * hinge_error_x + hinge_moment_y * hinge_error_y))
        - law_impulse
    )


def hinge_change(
    change_above: Vector, spin_change_above: Scalar, arm_above: Vector, hinge_error: Vector
) -> Vector:
    """Change of the velocity of a node at its hinge (m/s).

    hinge_change = change_above + cross(spin_change_above, arm_above) - hinge_error

    Args:
        change_above: Change of the velocity of the body above, m/s
        spin_change_above: Change of the rate of turning of the body above, rad/s
        arm_above: From the centre of mass of the body above a hinge to the hinge, m
        hinge_error: Rate at which a hinge parts, beyond the one wanted, m/s

    Source: DD71, srs/models/hinge_tree.md:108.
    """
    change_above_x, change_above_y = change_above
    arm_above_x, arm_above_y = arm_above
    hinge_error_x, hinge_error_y = hinge_error
    return (
        change_above_x - spin_change_above * arm_above_y - hinge_error_x,
        change_above_y + spin_change_above * arm_above_x - hinge_error_y,
    )


def root_change(momentum_hung: Vector, hung_mass_x: Vector, hung_mass_y: Vector) -> Vector:
    """Change of the velocity of a root that nothing ties (m/s).

    root_change = vector(-(x(momentum_hung) + y(hung_mass_x)*root_change_y)/x(hung_mass_x),
    root_change_y)
        where root_change_y = (y(hung_mass_x)*x(momentum_hung) - x(hung_mass_x)*y(momentum_hung))/(x(hung_mass_x)*y(hung_mass_y) - y(hung_mass_x)*x(hung_mass_y))

    Args:
        momentum_hung: Impulse through a hinge whose point does not change its velocity, kg*m/s
        hung_mass_x: Impulse along x that a hinge takes for velocities of its point, kg
        hung_mass_y: Impulse along y that a hinge takes for velocities of its point, kg

    Source: DD71, srs/models/hinge_tree.md:113.
    """
    momentum_hung_x, momentum_hung_y = momentum_hung
    hung_mass_x_x, hung_mass_x_y = hung_mass_x
    hung_mass_y_x, hung_mass_y_y = hung_mass_y
    root_change_y = (hung_mass_x_y * momentum_hung_x - hung_mass_x_x * momentum_hung_y) / (
        hung_mass_x_x * hung_mass_y_y - hung_mass_x_y * hung_mass_y_x
    )
    return ((-(momentum_hung_x + hung_mass_x_y * root_change_y)) / hung_mass_x_x, root_change_y)


def spin_change(
    spin_change_above: Scalar,
    turned_share: Scalar,
    hinge_change: Vector,
    hinge_lever: Vector,
    turn_bias: Scalar,
    turning_yield: Scalar,
) -> Scalar:
    """Change of the rate of turning of a body by its hinges (rad/s).

    spin_change = turned_share*spin_change_above - dot(hinge_lever, hinge_change) -
    turning_yield*turn_bias

    Args:
        spin_change_above: Change of the rate of turning of the body above, rad/s
        turned_share: Share of the turning of the body above that laws pass on to a node, 1
        hinge_change: Change of the velocity of a node at its hinge, m/s
        hinge_lever: Turning of a node for the velocity of its hinge, with the other sign, 1/m
        turn_bias: Bias angular impulse of a node about its hinge, with its laws, kg*m^2/s
        turning_yield: Change of the rate of turning for one unit of angular momentum at a
            hinge, 1/(kg*m^2)

    Source: DD71, srs/models/hinge_tree.md:116.
    """
    hinge_change_x, hinge_change_y = hinge_change
    hinge_lever_x, hinge_lever_y = hinge_lever
    return (
        turned_share * spin_change_above
        - (hinge_lever_x * hinge_change_x + hinge_lever_y * hinge_change_y)
        - turning_yield * turn_bias
    )


def change(hinge_change: Vector, spin_change: Scalar, hinge_arm: Vector) -> Vector:
    """Change of the velocity of a body by its hinges (m/s).

    change = hinge_change - cross(spin_change, hinge_arm)

    Args:
        hinge_change: Change of the velocity of a node at its hinge, m/s
        spin_change: Change of the rate of turning of a body by its hinges, rad/s
        hinge_arm: From the centre of mass of a body to the hinge on which it hangs, m

    Source: DD71, srs/models/hinge_tree.md:119.
    """
    hinge_change_x, hinge_change_y = hinge_change
    hinge_arm_x, hinge_arm_y = hinge_arm
    return (hinge_change_x + spin_change * hinge_arm_y, hinge_change_y - spin_change * hinge_arm_x)


def hinge_impulse(
    hinge_change: Vector,
    spin_change_above: Scalar,
    hung_mass_x: Vector,
    hung_mass_y: Vector,
    hinge_moment: Vector,
    turned_share: Scalar,
    momentum_hung: Vector,
) -> Vector:
    """Impulse through a hinge on the body that hangs on it (N*s).

    hinge_impulse = x(hinge_change)*hung_mass_x + y(hinge_change)*hung_mass_y +
    turned_share*spin_change_above*hinge_moment + momentum_hung

    Args:
        hinge_change: Change of the velocity of a node at its hinge, m/s
        spin_change_above: Change of the rate of turning of the body above, rad/s
        hung_mass_x: Impulse along x that a hinge takes for velocities of its point, kg
        hung_mass_y: Impulse along y that a hinge takes for velocities of its point, kg
        hinge_moment: Momentum of a node for its turning about its hinge, kg*m
        turned_share: Share of the turning of the body above that laws pass on to a node, 1
        momentum_hung: Impulse through a hinge whose point does not change its velocity, kg*m/s

    Source: DD71, srs/models/hinge_tree.md:120.
    """
    hinge_change_x, hinge_change_y = hinge_change
    hung_mass_x_x, hung_mass_x_y = hung_mass_x
    hung_mass_y_x, hung_mass_y_y = hung_mass_y
    hinge_moment_x, hinge_moment_y = hinge_moment
    momentum_hung_x, momentum_hung_y = momentum_hung
    return (
        hinge_change_x * hung_mass_x_x
        + hinge_change_y * hung_mass_y_x
        + turned_share * spin_change_above * hinge_moment_x
        + momentum_hung_x,
        hinge_change_x * hung_mass_x_y
        + hinge_change_y * hung_mass_y_y
        + turned_share * spin_change_above * hinge_moment_y
        + momentum_hung_y,
    )


def velocity_hinged(velocity: Vector, hinge_impulse: Vector, inverse_mass: Scalar) -> Vector:
    """Velocity after the impulse of a hinge (m/s).

    velocity_hinged = velocity + inverse_mass*hinge_impulse

    Args:
        velocity: Velocity of the centre of mass, m/s
        hinge_impulse: Impulse through a hinge on the body that hangs on it, N*s
        inverse_mass: One over the mass, zero for a static body, 1/kg

    Source: DD71, srs/models/hinge_tree.md:123.
    """
    velocity_x, velocity_y = velocity
    hinge_impulse_x, hinge_impulse_y = hinge_impulse
    return (
        velocity_x + inverse_mass * hinge_impulse_x,
        velocity_y + inverse_mass * hinge_impulse_y,
    )


def angular_velocity_hinged(
    angular_velocity: Scalar, hinge_arm: Vector, hinge_impulse: Vector, inverse_inertia: Scalar
) -> Scalar:
    """Rate of turning after the impulse of a hinge (rad/s).

    angular_velocity_hinged = angular_velocity + inverse_inertia*cross(hinge_arm,
    hinge_impulse)

    Args:
        angular_velocity: Rate of turning, positive counter-clockwise, rad/s
        hinge_arm: From the centre of mass of a body to the hinge on which it hangs, m
        hinge_impulse: Impulse through a hinge on the body that hangs on it, N*s
        inverse_inertia: One over the inertia, zero for a body that cannot turn, 1/(kg*m^2)

    Source: DD71, srs/models/hinge_tree.md:124.
    """
    hinge_arm_x, hinge_arm_y = hinge_arm
    hinge_impulse_x, hinge_impulse_y = hinge_impulse
    return angular_velocity + inverse_inertia * (
        hinge_arm_x * hinge_impulse_y - hinge_arm_y * hinge_impulse_x
    )


def momentum_hinged(momentum: Vector, hinge_impulse: Vector) -> Vector:
    """Momentum after the impulse of a hinge (kg*m/s).

    momentum_hinged = momentum + hinge_impulse

    Args:
        momentum: Mass times velocity, kg*m/s
        hinge_impulse: Impulse through a hinge on the body that hangs on it, N*s

    Source: DD71, srs/models/hinge_tree.md:126.
    """
    momentum_x, momentum_y = momentum
    hinge_impulse_x, hinge_impulse_y = hinge_impulse
    return (momentum_x + hinge_impulse_x, momentum_y + hinge_impulse_y)


def angular_momentum_hinged(
    angular_momentum: Scalar, hinge_arm: Vector, hinge_impulse: Vector
) -> Scalar:
    """Angular momentum after the impulse of a hinge (kg*m^2/s).

    angular_momentum_hinged = angular_momentum + cross(hinge_arm, hinge_impulse)

    Args:
        angular_momentum: Moment of momentum about the origin, kg*m^2/s
        hinge_arm: From the centre of mass of a body to the hinge on which it hangs, m
        hinge_impulse: Impulse through a hinge on the body that hangs on it, N*s

    Source: DD71, srs/models/hinge_tree.md:127.
    """
    hinge_arm_x, hinge_arm_y = hinge_arm
    hinge_impulse_x, hinge_impulse_y = hinge_impulse
    return angular_momentum + hinge_arm_x * hinge_impulse_y - hinge_arm_y * hinge_impulse_x
