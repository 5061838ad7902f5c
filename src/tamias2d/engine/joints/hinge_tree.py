"""The matrix of a tree of hinges: what hangs on each hinge, from the ends of the tree to its root.

Hinges do not yield. A second tie to what does not move is a firm row of the body that it ties.

Cost: cosine and sine and one division for each body. Source: Featherstone (2008), articulated
bodies.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.angle_laws import add_law, is_law
from tamias2d.engine.joints.hinged_yield import yield_at_hinge
from tamias2d.engine.joints.linearise import (
    firmness_by_law,
    move_members,
    rows_where_placed,
    turn_members,
    write_rows,
    yield_of_row,
)
from tamias2d.engine.tables import Bodies, Integers, Joints
from tamias2d.generated.hinge_tree import (
    angular_momentum_hinged,
    arm_met,
    hinge_arm,
    hinge_gap,
    hinge_inertia,
    hinge_lever,
    hinge_moment,
    hung_inertia,
    hung_mass,
    hung_moment,
    momentum_hinged,
    turned_share,
    turning_yield,
)
from tamias2d.generated.joint_rows import ROW
from tamias2d.generated.joint_step import (
    angular_velocity_later,
    coupled_inertia,
    coupled_mass,
    coupled_moment,
    velocity_later,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array, Vector

SLIGHT_TURN = 1e-4  # rad^2, of a body in a substep times that by impulses: of arms, what it leaves
OF_LOSS = 0.4  # the same for springs, of the share beyond a half, by which they lose energy


def linearise_tree(n: int, bodies: Bodies, joints: Joints) -> None:
    """Write the rows of a tree where its bodies are, and what hangs on its hinges.

    That is found later for a governed one, where its springs are known.
    """
    first, last = joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1
    place_tree(n, 0.0, bodies, joints)
    for m in range(first, last):
        row = joints.hinges[m]
        turn_hinge(m, joints)
        row[tb.H_APART] = max(row[tb.H_APART], abs(row[tb.H_GAP]))
        row[tb.H_APART + 1] = max(row[tb.H_APART + 1], abs(row[tb.H_GAP + 1]))
    for j in range(first_besides(n, joints), joints.mechanisms[n + 1, tb.M_JOINT]):
        write_rows(j, joints)
    if joints.mechanisms[n, tb.M_GOVERNED] == 0:
        hang_tree(n, 0.0, joints)


def turn_tree(n: int, substep: float, joints: Joints) -> None:
    """Let the rows of a tree be those where its members are placed, at the end of a substep, s."""
    for m in range(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1):
        turn_hinge(m, joints)
    for j in range(first_besides(n, joints), joints.mechanisms[n + 1, tb.M_JOINT]):
        rows_where_placed(j, joints)
    hang_tree(n, substep, joints)


def place_tree(n: int, ahead: float, bodies: Bodies, joints: Joints) -> None:
    """Write where the members of a tree are, or will be so many seconds ahead.

    Hinges read cosines and sines where these are found, and only other joints elsewhere.
    """
    first, last = joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1
    move_members(first, last, ahead, bodies, joints)
    if first_besides(n, joints) < joints.mechanisms[n + 1, tb.M_JOINT]:
        turn_members(first, last, joints)


def hang_tree(n: int, substep: float, joints: Joints) -> None:
    """Find what hangs on the hinges of a tree, with the rows besides them that hold.

    Springs count through a substep, s; not where that is 0 and velocities alone are looked at.
    """
    first, last = joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1
    joints.hinges[first, tb.H_SLIGHT] = SLIGHT_TURN
    for m in range(first, last):
        begin_node(m, joints)
    for j in range(first_besides(n, joints), joints.mechanisms[n + 1, tb.M_JOINT]):
        ends, numbers = joints.joints[j], joints.numbers[j]
        if substep == 0.0 and ends[tb.J_LAW] == tb.SPRING:
            numbers[tb.J_FIRMNESS] = 0.0
        elif is_law(j, joints):
            add_law(j, first, substep, joints)
        else:
            for r in range(ends[tb.J_ROWS]):
                yielding = yield_of_row(r, ends, numbers, joints)
                hinged = yield_of_tie(r, first, yielding, ends, numbers, joints)
                numbers[tb.J_FIRMNESS + r] = firmness_by_law(
                    yielding, hinged, numbers[tb.J_FIRMEST + r], j, substep, joints
                )
                add_tie(j, r, joints)
        if ends[tb.J_LAW] == tb.SPRING:
            slight = slight_turn(numbers[tb.J_SHARE])
            joints.hinges[first, tb.H_SLIGHT] = min(joints.hinges[first, tb.H_SLIGHT], slight)
    for m in range(last - 1, first, -1):
        hang(joints.hinges[m])
        add_to_node_above(joints.hinges[m], joints.hinges[joints.members[m, tb.JOINED_ABOVE]])
    hang(joints.hinges[first])


@inlined
def slight_turn(share: float) -> float:
    """Return how much turning is not looked at again where a spring answers after a share, rad^2.

    What gaps take or give then is little beside what the spring loses; where it loses nothing, none
    is slight.
    """
    return OF_LOSS * (share - 0.5)


def first_besides(n: int, joints: Joints) -> int:
    """Return the first joint of a tree that is not the hinge of a node."""
    root = joints.sparse[n, tb.I_NODE] + 1
    hinges = joints.sparse[n + 1, tb.I_NODE] + 1 - root
    if joints.members[root, tb.JOINED_HINGE] < 0:
        hinges -= 1
    return int(joints.mechanisms[n, tb.M_JOINT] + hinges)


@inlined
def arms_of_hinge(m: int, joints: Joints) -> tuple[Vector, Vector, Vector]:
    """Return the arms of a hinge, where bodies are placed, and by how much it is apart, m."""
    row, place, above = joints.hinges[m], joints.places[m], joints.members[m, tb.JOINED_ABOVE]
    place_above, cosines, sines = joints.places[above], joints.turns[1], joints.turns[2]
    anchor = (row[tb.H_ANCHOR], row[tb.H_ANCHOR + 1])
    far_anchor = (row[tb.H_FAR_ANCHOR], row[tb.H_FAR_ANCHOR + 1])
    arm = hinge_arm(anchor, cosines[m], sines[m])
    far = hinge_arm(far_anchor, cosines[above], sines[above])
    here, there = (
        (place[tb.PLACE_X], place[tb.PLACE_Y]),
        (place_above[tb.PLACE_X], place_above[tb.PLACE_Y]),
    )
    return arm, far, hinge_gap(here, arm, there, far)


@inlined
def turn_hinge(m: int, joints: Joints) -> None:
    """Write the hinge of a member where bodies are placed."""
    row = joints.hinges[m]
    keep_given(row)
    arm, far, gap = arms_of_hinge(m, joints)
    row[tb.H_ARM], row[tb.H_ARM + 1] = arm[0], arm[1]
    row[tb.H_FAR_ARM], row[tb.H_FAR_ARM + 1] = arm_met(far, gap)
    row[tb.H_GAP], row[tb.H_GAP + 1] = gap[0], gap[1]


@inlined
def keep_given(row: Array) -> None:
    """Add what went through a hinge since its row was written to what went through it before."""
    pull, given = (row[tb.H_PULL], row[tb.H_PULL + 1]), (row[tb.H_GIVEN], row[tb.H_GIVEN + 1])
    arm, far = (row[tb.H_ARM], row[tb.H_ARM + 1]), (row[tb.H_FAR_ARM], row[tb.H_FAR_ARM + 1])
    pull, turn, far_turn = gone_through(pull, row[tb.H_TURN], row[tb.H_FAR_TURN], given, arm, far)
    row[tb.H_PULL], row[tb.H_PULL + 1], row[tb.H_TURN], row[tb.H_FAR_TURN] = (
        pull[0],
        pull[1],
        turn,
        far_turn,
    )
    row[tb.H_GIVEN] = row[tb.H_GIVEN + 1] = 0.0


@inlined
def gone_through(
    pull: Vector, turn: float, far_turn: float, given: Vector, arm: Vector, far: Vector
) -> tuple[Vector, float, float]:
    """Return what has gone through a hinge, N s, and its moments about both bodies, N m s.

    That is what had, with their moments, and what was given since; arms are in m.
    """
    far_turn = angular_momentum_hinged(far_turn, far, (-given[0], -given[1]))
    return momentum_hinged(pull, given), angular_momentum_hinged(turn, arm, given), far_turn


@inlined
def begin_node(m: int, joints: Joints) -> None:
    """Let the node of a member be its body alone, as yet; no laws govern its hinge."""
    row = joints.hinges[m]
    mass, inertia = joints.factors[m - 1, tb.NODE_MASS], joints.factors[m - 1, tb.NODE_INERTIA]
    row[tb.H_NODE_MASS], row[tb.H_NODE_MASS + 1], row[tb.H_NODE_MASS + 2] = mass, 0.0, mass
    row[tb.H_NODE_MOMENT] = row[tb.H_NODE_MOMENT + 1] = 0.0
    row[tb.H_NODE_INERTIA] = inertia
    row[tb.H_YIELD] = 1.0 if inertia > 0.0 else 0.0
    row[tb.H_FIRM] = 0.0


def yield_of_tie(
    r: int,
    root: int,
    yielding: float,
    ends: Integers,
    numbers: Array,
    joints: Joints,
) -> float:
    """Return by how much a row yields, 1/kg, with the hinge of the body that it ties."""
    for end in range(tb.ENDS_OF_JOINT):
        if ends[tb.J_NODE + end] >= 0 and ends[tb.J_LAW] == tb.SPRING:
            m, at = ends[tb.J_MEMBER + end], tb.J_ROW + ROW * r + 1 + 3 * end
            inverse_mass = joints.places[m, tb.SLOWED_INVERSE_MASS]
            slope, held = (numbers[at], numbers[at + 1]), joints.places[m, tb.HELD_INVERSE_INERTIA]
            by = velocity_later((0.0, 0.0), 1.0, slope, inverse_mass)
            spin = angular_velocity_later(0.0, 1.0, numbers[at + 2], held)
            return yield_at_hinge(m, root, yielding, by, (spin, 0.0), joints)
    return yielding


def add_tie(j: int, r: int, joints: Joints) -> None:
    """Add a firm row to the node of the one body that it ties and that moves."""
    ends, numbers = joints.joints[j], joints.numbers[j]
    firm = numbers[tb.J_FIRMNESS + r]
    for end in range(tb.ENDS_OF_JOINT):
        if ends[tb.J_NODE + end] >= 0:
            row, at = joints.hinges[ends[tb.J_NODE + end] + 1], tb.J_ROW + ROW * r + 1 + 3 * end
            slope, turning = (numbers[at], numbers[at + 1]), numbers[at + 2]
            by_x, by_y = coupled_mass(slope, slope[0], firm), coupled_mass(slope, slope[1], firm)
            moment = coupled_moment(turning, slope, firm)
            row[tb.H_NODE_MASS] += by_x[0]
            row[tb.H_NODE_MASS + 1] += by_x[1]
            row[tb.H_NODE_MASS + 2] += by_y[1]
            row[tb.H_NODE_MOMENT] += moment[0]
            row[tb.H_NODE_MOMENT + 1] += moment[1]
            row[tb.H_NODE_INERTIA] += coupled_inertia(turning, turning, firm)


@inlined
def hang(row: Array) -> None:
    """Find what a node is for its hinge; a body turns, or does not."""
    mass_x = (row[tb.H_NODE_MASS], row[tb.H_NODE_MASS + 1])
    mass_y = (row[tb.H_NODE_MASS + 1], row[tb.H_NODE_MASS + 2])
    moment, arm = (
        (row[tb.H_NODE_MOMENT], row[tb.H_NODE_MOMENT + 1]),
        (row[tb.H_ARM], row[tb.H_ARM + 1]),
    )
    turned = hinge_moment(mass_x, mass_y, moment, arm)
    inertia = hinge_inertia(moment, row[tb.H_NODE_INERTIA], turned, arm)
    firm = row[tb.H_FIRM]
    yielding = turning_yield(inertia, firm) if row[tb.H_YIELD] > 0.0 else 0.0
    lever = hinge_lever(turned, yielding)
    hung_x, hung_y = hung_mass(mass_x, lever[0], turned), hung_mass(mass_y, lever[1], turned)
    row[tb.H_YIELD], row[tb.H_LEVER], row[tb.H_LEVER + 1] = yielding, lever[0], lever[1]
    row[tb.H_SHARE] = turned_share(firm, yielding)
    row[tb.H_MOMENT], row[tb.H_MOMENT + 1], row[tb.H_INERTIA] = turned[0], turned[1], inertia
    row[tb.H_MASS], row[tb.H_MASS + 1], row[tb.H_MASS + 2] = hung_x[0], hung_x[1], hung_y[1]


@inlined
def add_to_node_above(row: Array, above: Array) -> None:
    """Add what hangs on a hinge to the node above."""
    hung_x, hung_y = (row[tb.H_MASS], row[tb.H_MASS + 1]), (row[tb.H_MASS + 1], row[tb.H_MASS + 2])
    turned, far = (
        (row[tb.H_MOMENT], row[tb.H_MOMENT + 1]),
        (row[tb.H_FAR_ARM], row[tb.H_FAR_ARM + 1]),
    )
    share = row[tb.H_SHARE]
    passed = hung_moment(hung_x, hung_y, turned, share, far)
    above[tb.H_NODE_MASS] += hung_x[0]
    above[tb.H_NODE_MASS + 1] += hung_x[1]
    above[tb.H_NODE_MASS + 2] += hung_y[1]
    above[tb.H_NODE_MOMENT] += passed[0]
    above[tb.H_NODE_MOMENT + 1] += passed[1]
    above[tb.H_NODE_INERTIA] += hung_inertia(passed, turned, row[tb.H_INERTIA], share, far)


def store_hinge_impulses(n: int, joints: Joints) -> None:
    """Add what went through the hinges of a tree in a part, and how far apart they were."""
    for m in range(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1):
        row, j = joints.hinges[m], joints.members[m, tb.JOINED_HINGE]
        keep_given(row)
        if j >= 0:
            store_hinge(row, joints.numbers[j])
        for k in range(tb.H_PULL, tb.H_APART + 2):
            row[k] = 0.0


@inlined
def store_hinge(row: Array, numbers: Array) -> None:
    """Add what went through a hinge to the numbers of its joint."""
    side = row[tb.H_SIDE]
    own, other = (tb.J_TOTAL + 3, tb.J_TOTAL) if side > 0.0 else (tb.J_TOTAL, tb.J_TOTAL + 3)
    for k in range(2):
        numbers[tb.J_PULL + k] += side * row[tb.H_PULL + k]
        numbers[own + k] += row[tb.H_PULL + k]
        numbers[other + k] -= row[tb.H_PULL + k]
        numbers[tb.J_APART + k] = max(numbers[tb.J_APART + k], row[tb.H_APART + k])
    numbers[own + 2] += row[tb.H_TURN]
    numbers[other + 2] += row[tb.H_FAR_TURN]
