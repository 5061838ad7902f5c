"""A link of a net of hinges: where it is, how it yields, what its impulse does (DD57, DD71)."""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Joints
from tamias2d.generated.definitions import point_velocity
from tamias2d.generated.hinge_tree import (
    angular_momentum_hinged,
    angular_velocity_hinged,
    arm_met,
    hinge_arm,
    hinge_gap,
    link_answer,
    link_impulse,
    link_mass_x,
    link_mass_y,
    momentum_hinged,
    point_yield_x,
    point_yield_y,
    velocity_hinged,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array, Vector


@inlined
def arms_of_link(j: int, joints: Joints) -> tuple[Vector, Vector, Vector]:
    """Return the arms of a link at A and B, where these are placed, and by how much it is apart."""
    given, ends = joints.given[j], joints.joints[j]
    m, k, cosines, sines = (
        ends[tb.J_MEMBER],
        ends[tb.J_MEMBER + 1],
        joints.turns[1],
        joints.turns[2],
    )
    a, b = joints.places[m], joints.places[k]
    arm_a = hinge_arm((given[0], given[1]), cosines[m], sines[m])
    arm_b = hinge_arm((given[2], given[3]), cosines[k], sines[k])
    at_a, at_b = (a[tb.PLACE_X], a[tb.PLACE_Y]), (b[tb.PLACE_X], b[tb.PLACE_Y])
    return arm_a, arm_b, hinge_gap(at_b, arm_b, at_a, arm_a)


@inlined
def write_link(j: int, joints: Joints) -> None:
    """Write a link where its bodies are placed, and note by how much it is apart."""
    link = joints.links[j]
    add_given(link)
    arm_a, arm_b, gap = arms_of_link(j, joints)
    arm_a = arm_met(arm_a, gap)
    link[tb.L_ARM_A], link[tb.L_ARM_A + 1] = arm_a
    link[tb.L_ARM_B], link[tb.L_ARM_B + 1] = arm_b
    link[tb.L_GAP], link[tb.L_GAP + 1] = gap
    link[tb.L_APART] = max(link[tb.L_APART], abs(gap[0]))
    link[tb.L_APART + 1] = max(link[tb.L_APART + 1], abs(gap[1]))


@inlined
def add_given(link: Array) -> None:
    """Add what went through a link since its row was written to what went through it before."""
    given, away = (
        (link[tb.L_GIVEN], link[tb.L_GIVEN + 1]),
        (-link[tb.L_GIVEN], -link[tb.L_GIVEN + 1]),
    )
    arm_a, arm_b = (
        (link[tb.L_ARM_A], link[tb.L_ARM_A + 1]),
        (link[tb.L_ARM_B], link[tb.L_ARM_B + 1]),
    )
    link[tb.L_PULL], link[tb.L_PULL + 1] = momentum_hinged(
        (link[tb.L_PULL], link[tb.L_PULL + 1]), given
    )
    link[tb.L_TURN_A] = angular_momentum_hinged(link[tb.L_TURN_A], arm_a, away)
    link[tb.L_TURN_B] = angular_momentum_hinged(link[tb.L_TURN_B], arm_b, given)
    link[tb.L_GIVEN] = link[tb.L_GIVEN + 1] = 0.0


@inlined
def change_of_link(j: int, joints: Joints) -> Vector:
    """Return by how much the changes of its bodies' velocities change the rates of a link, m/s."""
    link, ends = joints.links[j], joints.joints[j]
    a, b = joints.net_nodes[ends[tb.J_MEMBER]], joints.net_nodes[ends[tb.J_MEMBER + 1]]
    arm_a, arm_b = (
        (link[tb.L_ARM_A], link[tb.L_ARM_A + 1]),
        (link[tb.L_ARM_B], link[tb.L_ARM_B + 1]),
    )
    at_a = point_velocity((a[tb.N_CHANGE], a[tb.N_CHANGE + 1]), a[tb.N_CHANGE + 2], arm_a)
    at_b = point_velocity((b[tb.N_CHANGE], b[tb.N_CHANGE + 1]), b[tb.N_CHANGE + 2], arm_b)
    return at_b[0] - at_a[0], at_b[1] - at_a[1]


@inlined
def push_link(j: int, impulse: Vector, joints: Joints) -> None:
    """Let the impulse of a link change the velocities of its bodies."""
    link, ends = joints.links[j], joints.joints[j]
    arm_a, arm_b = (
        (link[tb.L_ARM_A], link[tb.L_ARM_A + 1]),
        (link[tb.L_ARM_B], link[tb.L_ARM_B + 1]),
    )
    push_node(joints.net_nodes[ends[tb.J_MEMBER]], arm_a, (-impulse[0], -impulse[1]))
    push_node(joints.net_nodes[ends[tb.J_MEMBER + 1]], arm_b, impulse)


@inlined
def push_node(node: Array, arm: Vector, impulse: Vector) -> None:
    """Let an impulse at an arm change the velocities of a node."""
    by = (node[tb.N_CHANGE], node[tb.N_CHANGE + 1])
    node[tb.N_CHANGE], node[tb.N_CHANGE + 1] = velocity_hinged(by, impulse, node[tb.N_INVERSE_MASS])
    node[tb.N_CHANGE + 2] = angular_velocity_hinged(
        node[tb.N_CHANGE + 2], arm, impulse, node[tb.N_INVERSE_INERTIA]
    )


@inlined
def impulse_for(link: Array, rate: Vector) -> Vector:
    """Return the impulse that gives a link, by itself, a rate."""
    mass_x, mass_y = (
        (link[tb.L_MASS], link[tb.L_MASS + 1]),
        (link[tb.L_MASS + 1], link[tb.L_MASS + 2]),
    )
    return link_impulse(rate, mass_x, mass_y)


@inlined
def note_what_is_left(j: int, joints: Joints) -> None:
    """Write the rates that a link is yet to get."""
    link = joints.links[j]
    by = change_of_link(j, joints)
    link[tb.L_RATE] = -link[tb.L_ERROR] - by[0]
    link[tb.L_RATE + 1] = -link[tb.L_ERROR + 1] - by[1]


@inlined
def weigh_link(j: int, joints: Joints) -> float:
    """Write how a link yields and its mass by itself; return the size of its error, J."""
    link, ends = joints.links[j], joints.joints[j]
    arm_a, arm_b = (
        (link[tb.L_ARM_A], link[tb.L_ARM_A + 1]),
        (link[tb.L_ARM_B], link[tb.L_ARM_B + 1]),
    )
    a, b = joints.net_nodes[ends[tb.J_MEMBER]], joints.net_nodes[ends[tb.J_MEMBER + 1]]
    ax = point_yield_x(a[tb.N_INVERSE_MASS], a[tb.N_INVERSE_INERTIA], arm_a)
    ay = point_yield_y(a[tb.N_INVERSE_MASS], a[tb.N_INVERSE_INERTIA], arm_a)
    bx = point_yield_x(b[tb.N_INVERSE_MASS], b[tb.N_INVERSE_INERTIA], arm_b)
    by = point_yield_y(b[tb.N_INVERSE_MASS], b[tb.N_INVERSE_INERTIA], arm_b)
    yield_x, yield_y = (ax[0] + bx[0], ax[1] + bx[1]), (ay[0] + by[0], ay[1] + by[1])
    link[tb.L_YIELD], link[tb.L_YIELD + 1], link[tb.L_YIELD + 2] = (
        yield_x[0],
        yield_x[1],
        yield_y[1],
    )
    mass_x, mass_y = link_mass_x(yield_x, yield_y), link_mass_y(yield_x, yield_y)
    link[tb.L_MASS], link[tb.L_MASS + 1], link[tb.L_MASS + 2] = mass_x[0], mass_x[1], mass_y[1]
    error = (link[tb.L_ERROR], link[tb.L_ERROR + 1])
    impulse = impulse_for(link, error)
    return error[0] * impulse[0] + error[1] * impulse[1]


@inlined
def size_of_left(link: Array, left: Vector) -> float:
    """Return the size of what a sweep made, J; write it as a rate where the direction looks."""
    rows = (link[tb.L_YIELD], link[tb.L_YIELD + 1]), (link[tb.L_YIELD + 1], link[tb.L_YIELD + 2])
    answer = link_answer(left, rows[0], rows[1])
    link[tb.L_MADE], link[tb.L_MADE + 1] = answer
    return left[0] * answer[0] + left[1] * answer[1]


@inlined
def parts_link(link: Array, rate: int, substep: float, most: float) -> bool:
    """Return whether the rate of a link in a column parts it by more than so much in a substep."""
    return bool(substep * max(abs(link[rate]), abs(link[rate + 1])) > most)
