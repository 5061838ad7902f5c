"""A net of hinges with many loops: its links, and the impulses that take their errors away.

Conjugate gradients, preconditioned by a sweep through all links and one back, whose work is also
the product with the matrix. They start from the impulses of the last time.

Cost: two visits to each link in an iteration.
Source: Hestenes and Stiefel (1952); Axelsson (1972), the sweeps; Eisenstat (1981), the product.
"""

from math import inf

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.iterate import MESH_ACCURACY
from tamias2d.engine.joints.linearise import move_members
from tamias2d.engine.tables import Bodies, Joints
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
from tamias2d.generated.joint_step import row_aim, row_error
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array, Vector

MOST_ITERATIONS_OF_NET = 20  # what is left is made up for in later substeps
LEFT_OPEN = 0.05  # of the gap that is looked at, in a substep
REMOVED_BY_NET = 0.05  # of a gap, in a substep of a whole step: of one not looked at, what is left


def begin_net(n: int, bodies: Bodies, joints: Joints) -> None:
    """Begin a part of a step: note how nodes yield, and the impulses of links to start from.

    How far links may be apart is that of the one that may least, and stands in the first; 0 if none
    is looked at.
    """
    for m in range(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1):
        node = joints.net_nodes[m]
        node[tb.N_INVERSE_MASS] = bodies.properties[
            joints.members[m, tb.JOINED_SLOT], tb.INVERSE_MASS
        ]
        node[tb.N_INVERSE_INERTIA] = joints.places[m, tb.HELD_INVERSE_INERTIA]
    least = inf
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        link, numbers = joints.links[j], joints.numbers[j]
        link[tb.L_WARM], link[tb.L_WARM + 1] = numbers[tb.J_WARM], numbers[tb.J_WARM + 1]
        least = min(least, numbers[tb.J_SLIGHT])
    joints.links[joints.mechanisms[n, tb.M_JOINT], tb.L_SLIGHT] = least if least < inf else 0.0


def linearise_net(n: int, bodies: Bodies, joints: Joints) -> None:
    """Write the links of a net where its bodies are."""
    first, last = joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1
    move_members(first, last, 0.0, bodies, joints)
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        write_link(j, joints)


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


def bring_net_to_aims(
    n: int, again: bool, length: float, substep: float, bodies: Bodies, joints: Joints
) -> None:
    """Change the velocities of a net so that a substep, s, brings its links nearly to their aims.

    These are parts of the gaps as they were just written; its length is as `aim_joints` says. What
    is left is made up for in the next substep.
    """
    first, last = joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1
    move_members(first, last, substep, bodies, joints)
    clear_net(n, joints)
    share = 0.5 if joints.mechanisms[n, tb.M_HALF] == 1 else 1.0
    warm, removed = 0.0 if again else share, REMOVED_BY_NET * length
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        link = joints.links[j]
        _, _, gap = arms_of_link(j, joints)
        link[tb.L_ERROR] = row_error(gap[0], row_aim(link[tb.L_GAP], removed), substep)
        link[tb.L_ERROR + 1] = row_error(gap[1], row_aim(link[tb.L_GAP + 1], removed), substep)
        start_link(j, warm, joints)
    solve_net(n, 0.0 if again else 1.0 / share, substep, bodies, joints)


def fit_net(n: int, warm: float, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Take the rates at which its links part from the velocities of a net, nearly.

    The impulses are about so many times those of the last substep, s.
    """
    told = joints.counts[tb.FIRST_KINEMATIC]
    note_motion(
        joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1, bodies, joints
    )
    note_motion(told, len(joints.members), bodies, joints)
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        link = joints.links[j]
        link[tb.L_ERROR], link[tb.L_ERROR + 1] = change_of_link(j, joints)
    clear_net(n, joints)
    clear_nodes_of_net(told, len(joints.members), joints)
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        start_link(j, warm, joints)
    solve_net(n, 0.0, substep, bodies, joints)


def note_motion(first: int, last: int, bodies: Bodies, joints: Joints) -> None:
    """Let the changes of some members be their velocities."""
    for m in range(first, last):
        node, now = joints.net_nodes[m], bodies.motion[joints.members[m, tb.JOINED_SLOT]]
        node[tb.N_CHANGE], node[tb.N_CHANGE + 1] = now[tb.VX], now[tb.VY]
        node[tb.N_CHANGE + 2] = now[tb.SPIN]


@inlined
def start_link(j: int, warm: float, joints: Joints) -> None:
    """Give the bodies of a link so many times its impulse in the last substep, to start from."""
    link = joints.links[j]
    impulse = (warm * link[tb.L_WARM], warm * link[tb.L_WARM + 1])
    link[tb.L_IMPULSE], link[tb.L_IMPULSE + 1] = impulse
    push_link(j, impulse, joints)


def solve_net(n: int, kept: float, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Give a net the impulses that take its errors away, nearly; keep so many times as much.

    It is enough if what is left parts no link by much in a substep, s.
    """
    first, last = joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]
    open_most = LEFT_OPEN * joints.links[first, tb.L_SLIGHT]
    parting = False
    for j in range(first, last):
        note_what_is_left(j, joints)
        parting |= parts_link(joints.links[j], tb.L_RATE, substep, open_most)
    if parting:
        iterate_net(n, substep, joints)
        push_links(n, joints)
    give_to_net(n, kept, bodies, joints)


def push_links(n: int, joints: Joints) -> None:
    """Let the impulses of its links, and nothing else, change the velocities of a net."""
    clear_net(n, joints)
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        push_link(j, (joints.links[j, tb.L_IMPULSE], joints.links[j, tb.L_IMPULSE + 1]), joints)


def iterate_net(n: int, substep: float, joints: Joints) -> None:
    """Add to the impulses of a net what is left, nearly, beside the size of all its errors."""
    first, last = joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]
    whole = 0.0
    for j in range(first, last):
        whole += weigh_link(j, joints)
    clear_net(n, joints)
    size, before = sweep_from_left(first, last, joints), 0.0
    for _ in range(MOST_ITERATIONS_OF_NET):
        solved = not size > MESH_ACCURACY * MESH_ACCURACY * whole
        if solved or not parts_links(first, last, substep, joints):
            return
        clear_net(n, joints)
        sweep_back(first, last, size / before if before > 0.0 else 0.0, joints)
        clear_net(n, joints)
        curvature = sweep_on(first, last, joints)
        before, size = size, go_along(first, last, size, curvature, joints)


def parts_links(first: int, last: int, substep: float, joints: Joints) -> bool:
    """Return whether what is left of their errors parts links by much in a substep, s."""
    open_most = LEFT_OPEN * joints.links[first, tb.L_SLIGHT]
    parting = False
    for j in range(first, last):
        parting |= parts_link(joints.links[j], tb.L_MADE, substep, open_most)
    return parting


@inlined
def parts_link(link: Array, rate: int, substep: float, most: float) -> bool:
    """Return whether the rate of a link in a column parts it by more than so much in a substep."""
    return bool(substep * max(abs(link[rate]), abs(link[rate + 1])) > most)


def clear_net(n: int, joints: Joints) -> None:
    """Write zeros to the changes of the nodes of a net."""
    clear_nodes_of_net(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1, joints)


def clear_nodes_of_net(first: int, last: int, joints: Joints) -> None:
    """Write zeros to the changes of some members."""
    for m in range(first, last):
        node = joints.net_nodes[m]
        node[tb.N_CHANGE] = node[tb.N_CHANGE + 1] = node[tb.N_CHANGE + 2] = 0.0


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


def sweep_from_left(first: int, last: int, joints: Joints) -> float:
    """Sweep through the links with the rates that they are yet to get; return the size, J."""
    size = 0.0
    for j in range(first, last):
        link = joints.links[j]
        by = change_of_link(j, joints)
        left = impulse_for(link, (link[tb.L_RATE] - by[0], link[tb.L_RATE + 1] - by[1]))
        push_link(j, left, joints)
        link[tb.L_LEFT], link[tb.L_LEFT + 1] = left
        link[tb.L_SEARCH] = link[tb.L_SEARCH + 1] = 0.0
        size += size_of_left(link, left)
    return size


@inlined
def size_of_left(link: Array, left: Vector) -> float:
    """Return the size of what a sweep made, J; write it as a rate where the direction looks."""
    rows = (link[tb.L_YIELD], link[tb.L_YIELD + 1]), (link[tb.L_YIELD + 1], link[tb.L_YIELD + 2])
    answer = link_answer(left, rows[0], rows[1])
    link[tb.L_MADE], link[tb.L_MADE + 1] = answer
    return left[0] * answer[0] + left[1] * answer[1]


def sweep_back(first: int, last: int, kept: float, joints: Joints) -> None:
    """Turn the direction to what is left, keep a share of the last one, and sweep back with it."""
    for back in range(last - first):
        j = last - 1 - back
        link = joints.links[j]
        search = (
            link[tb.L_MADE] + kept * link[tb.L_SEARCH],
            link[tb.L_MADE + 1] + kept * link[tb.L_SEARCH + 1],
        )
        link[tb.L_SEARCH], link[tb.L_SEARCH + 1] = search
        by = change_of_link(j, joints)
        tried = impulse_for(link, (search[0] - by[0], search[1] - by[1]))
        push_link(j, tried, joints)
        link[tb.L_TRIED], link[tb.L_TRIED + 1] = tried
        link[tb.L_RATE], link[tb.L_RATE + 1] = by


def sweep_on(first: int, last: int, joints: Joints) -> float:
    """Sweep through the links with what those after them do; return the curvature, J."""
    curvature = 0.0
    for j in range(first, last):
        link = joints.links[j]
        by = change_of_link(j, joints)
        more = impulse_for(link, (link[tb.L_RATE] - by[0], link[tb.L_RATE + 1] - by[1]))
        push_link(j, more, joints)
        made = (link[tb.L_TRIED] + more[0], link[tb.L_TRIED + 1] + more[1])
        link[tb.L_MADE], link[tb.L_MADE + 1] = made
        curvature += link[tb.L_SEARCH] * made[0] + link[tb.L_SEARCH + 1] * made[1]
    return curvature


def go_along(first: int, last: int, size: float, curvature: float, joints: Joints) -> float:
    """Take a step of conjugate gradients; return the size of what is left, J."""
    share = size / curvature if curvature > 0.0 else 0.0
    new = 0.0
    for j in range(first, last):
        link = joints.links[j]
        link[tb.L_IMPULSE] += share * link[tb.L_TRIED]
        link[tb.L_IMPULSE + 1] += share * link[tb.L_TRIED + 1]
        left = (
            link[tb.L_LEFT] - share * link[tb.L_MADE],
            link[tb.L_LEFT + 1] - share * link[tb.L_MADE + 1],
        )
        link[tb.L_LEFT], link[tb.L_LEFT + 1] = left
        new += size_of_left(link, left)
    return new


def give_to_net(n: int, kept: float, bodies: Bodies, joints: Joints) -> None:
    """Give bodies the changes of the nodes of a net, and note the impulses of its links.

    So many times as much is kept for the next substep, if that is anything.
    """
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        link = joints.links[j]
        impulse = (link[tb.L_IMPULSE], link[tb.L_IMPULSE + 1])
        link[tb.L_GIVEN] += impulse[0]
        link[tb.L_GIVEN + 1] += impulse[1]
        if kept > 0.0:
            link[tb.L_WARM], link[tb.L_WARM + 1] = kept * impulse[0], kept * impulse[1]
    for m in range(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1):
        i, node = joints.members[m, tb.JOINED_SLOT], joints.net_nodes[m]
        now, state = bodies.motion[i], bodies.substep_state[i]
        for k in range(3):
            now[tb.VX + k] += node[tb.N_CHANGE + k]
            state[tb.SUBSTEP_START + k] += node[tb.N_CHANGE + k]


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


def store_links(n: int, joints: Joints) -> None:
    """Store what went through the links of a net in a part, and how far apart they were."""
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        link, numbers = joints.links[j], joints.numbers[j]
        add_given(link)
        for k in range(2):
            numbers[tb.J_PULL + k] += link[tb.L_PULL + k]
            numbers[tb.J_TOTAL + k] -= link[tb.L_PULL + k]
            numbers[tb.J_TOTAL + 3 + k] += link[tb.L_PULL + k]
            numbers[tb.J_APART + k] = max(numbers[tb.J_APART + k], link[tb.L_APART + k])
            numbers[tb.J_WARM + k] = link[tb.L_WARM + k]
        numbers[tb.J_TOTAL + 2] += link[tb.L_TURN_A]
        numbers[tb.J_TOTAL + 5] += link[tb.L_TURN_B]
        for k in range(tb.L_PULL, tb.L_SLIGHT):
            link[k] = 0.0
