"""The impulses of a tree of hinges: those that take the errors of its hinges away (DD71).

Cost: two visits to each body for a solution, and cosine and sine where positions are looked at.
Source: Featherstone (2008), articulated bodies.
"""

from math import inf

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.acceptance import is_rejected, note_most_motion
from tamias2d.engine.joints.angle_laws import (
    add_law_bias,
    error_of_law,
    impulse_of_law,
    is_law,
    turn_by_law,
)
from tamias2d.engine.joints.hinge_tree import (
    arms_of_hinge,
    first_besides,
    hang_tree,
    place_tree,
    turn_tree,
)
from tamias2d.engine.joints.impulse import apply_joint_impulse
from tamias2d.engine.joints.opening import closing_rate
from tamias2d.engine.joints.solve import (
    MOST_ITERATIONS_OF_JOINTS,
    SLOWLY,
    SOLVED_RATE,
    aim_joint,
    errors_of_joint,
    rate_of_row,
)
from tamias2d.engine.joints.yielding import (
    REMOVED_BY_JOINTS,
    energy_asked,
    gain_of_node,
    let_yield,
    may_yield,
    yields,
)
from tamias2d.engine.tables import Bodies, Joints
from tamias2d.generated.definitions import point_velocity
from tamias2d.generated.hinge_tree import (
    angular_momentum_passed,
    angular_velocity_hinged,
    change,
    hinge_change,
    hinge_impulse,
    momentum_hung,
    momentum_passed,
    root_change,
    spin_change,
    turn_bias,
    velocity_hinged,
)
from tamias2d.generated.joint_rows import ROW
from tamias2d.generated.joint_step import (
    angular_momentum_later,
    drive_error,
    momentum_later,
    row_aim,
    row_error,
    row_impulse,
    row_rate,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array, Vector


def aim_tree(n: int, length: float, substep: float, joints: Joints) -> None:
    """Note to which gaps a substep, s, brings the hinges of a tree, as `aim_joints` does.

    They are the gaps as they were just written.
    """
    for m in range(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1):
        row = joints.hinges[m]
        row[tb.H_AIM] = row_aim(row[tb.H_GAP], REMOVED_BY_JOINTS * length)
        row[tb.H_AIM + 1] = row_aim(row[tb.H_GAP + 1], REMOVED_BY_JOINTS * length)
    way = closing_rate(n, joints) * substep
    for j in range(first_besides(n, joints), joints.mechanisms[n + 1, tb.M_JOINT]):
        aim_joint(j, length, way, joints)


def bring_tree_to_aims(
    n: int, first: float, substep: float, bodies: Bodies, joints: Joints
) -> None:
    """Change the velocities of a tree so that a substep, s, brings its hinges where they are to be.

    Arms turn meanwhile; where that matters, it is done again, and with the arms of the end where
    errors do not become much less. Their size was so much at first, m^2/s^2, if that is known.
    """
    before, most, turned, fitted = inf, 0.0, False, False
    root = joints.sparse[n, tb.I_NODE] + 1
    for k in range(MOST_ITERATIONS_OF_JOINTS):
        size = find_gap_errors(n, substep, bodies, joints)
        if k == 0:
            first, most = max(first, size), energy_asked_of_tree(n, substep, joints)
        if turned and not size < before:
            take_solution_back(n, 1.0, bodies, joints)  # no solution is near
            return
        if size <= SOLVED_RATE * SOLVED_RATE * first:
            return
        turned = size > SLOWLY * before
        if turned:
            turn_tree(n, substep, joints)
        before = size
        largest = substep * substep * answer_tree(n, substep, most, bodies, joints)
        if is_rejected(n, largest, bodies, joints):
            take_solution_back(n, 1.0, bodies, joints)
            if fitted or k > 0:
                return
            fit_tree(n, substep, bodies, joints)
            note_most_motion(n, substep, bodies, joints)
            before, fitted = inf, True
        elif not largest > joints.hinges[root, tb.H_SLIGHT]:
            return
        if yields(n, joints):
            return


def take_solution_back(n: int, share: float, bodies: Bodies, joints: Joints) -> None:
    """Take a share of the last solution from the motion of a tree."""
    first, last = joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1
    for m in range(first, last):
        row = joints.hinges[m]
        back = (-share * row[tb.H_IMPULSE], -share * row[tb.H_IMPULSE + 1])
        push_through(m, first, back, bodies, joints)
    for j in range(first_besides(n, joints), joints.mechanisms[n + 1, tb.M_JOINT]):
        if is_law(j, joints):
            turn_by_law(j, -share * joints.numbers[j, tb.J_IMPULSE], bodies, joints)
            continue
        for r in range(joints.joints[j, tb.J_ROWS]):
            back_by = -share * joints.numbers[j, tb.J_IMPULSE + r]
            apply_joint_impulse(j, r, back_by, bodies, joints)


def answer_tree(n: int, ahead: float, most: float, bodies: Bodies, joints: Joints) -> float:
    """Give a tree the impulses that take its errors away, or yield where it would be thrown.

    It is if they give it more than an energy, J. Springs count as `hang_tree` says.
    """
    largest = solve_hinges(n, bodies, joints)
    if most < inf and not yields(n, joints) and not gain_of_tree(n, joints) <= most:
        take_solution_back(n, 1.0, bodies, joints)
        let_yield(n, joints)
        hang_tree(n, ahead, joints)
        for m in range(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1):
            row = joints.hinges[m]
            begin_errors(row, row[tb.H_ERROR], row[tb.H_ERROR + 1])
        return solve_hinges(n, bodies, joints)
    return largest


def energy_asked_of_tree(n: int, substep: float, joints: Joints) -> float:
    """Return the most energy that the errors of a tree may give it, J: any where none is firm."""
    besides, rates = first_besides(n, joints), 0.0
    if not may_yield(n, besides, joints):
        return inf
    for m in range(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1):
        row = joints.hinges[m]
        rates += row[tb.H_ERROR] * row[tb.H_ERROR] + row[tb.H_ERROR + 1] * row[tb.H_ERROR + 1]
    return energy_asked(n, besides, rates, substep, joints)


def gain_of_tree(n: int, joints: Joints) -> float:
    """Return the energy of what the last solution of a tree changes, J."""
    gain = 0.0
    for node in range(joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]):
        gain += gain_of_node(joints.hinges[node + 1], tb.H_CHANGE, joints.factors[node])
    return gain


def fit_tree(n: int, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Take the rates of its rows from the velocities of a tree."""
    write_rates_of_tree(n, bodies, joints)
    answer_tree(n, 0.0, energy_asked_of_tree(n, substep, joints), bodies, joints)


def write_rates_of_tree(n: int, bodies: Bodies, joints: Joints) -> None:
    """Write the rates of the rows of a tree as their errors."""
    for m in range(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1):
        rate_x, rate_y = rates_of_hinge(m, bodies, joints)
        begin_errors(joints.hinges[m], rate_x, rate_y)
    for j in range(first_besides(n, joints), joints.mechanisms[n + 1, tb.M_JOINT]):
        for r in range(joints.joints[j, tb.J_ROWS]):
            if joints.numbers[j, tb.J_FIRMNESS + r] > 0.0:
                rate = rate_of_row(j, r, bodies, joints)
                wanted = joints.laws[j, tb.LAW_RATE]
                joints.numbers[j, tb.J_ERROR + r] = drive_error(rate, wanted)


@inlined
def rates_of_hinge(m: int, bodies: Bodies, joints: Joints) -> Vector:
    """Return the rates at which a hinge parts, m/s."""
    row, now = joints.hinges[m], bodies.motion[joints.members[m, tb.JOINED_SLOT]]
    above = bodies.motion[joints.members[joints.members[m, tb.JOINED_ABOVE], tb.JOINED_SLOT]]
    arm, far = (row[tb.H_ARM], row[tb.H_ARM + 1]), (row[tb.H_FAR_ARM], row[tb.H_FAR_ARM + 1])
    here = point_velocity((now[tb.VX], now[tb.VY]), now[tb.SPIN], arm)
    there = point_velocity((above[tb.VX], above[tb.VY]), above[tb.SPIN], far)
    return here[0] - there[0], here[1] - there[1]


def find_gap_errors(n: int, substep: float, bodies: Bodies, joints: Joints) -> float:
    """Write the rates that hinges have too much to get to their aims; return their squares' sum."""
    first, last = joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1
    place_tree(n, substep, bodies, joints)
    size = 0.0
    if joints.members[first, tb.JOINED_HINGE] < 0:
        begin_errors(joints.hinges[first], 0.0, 0.0)
        first += 1
    for m in range(first, last):
        row = joints.hinges[m]
        _, _, gap = arms_of_hinge(m, joints)
        error_x = row_error(gap[0], row[tb.H_AIM], substep)
        error_y = row_error(gap[1], row[tb.H_AIM + 1], substep)
        begin_errors(row, error_x, error_y)
        size += error_x * error_x + error_y * error_y
    for j in range(first_besides(n, joints), joints.mechanisms[n + 1, tb.M_JOINT]):
        if is_law(j, joints):
            error_of_law(j, substep, bodies, joints)
        else:
            errors_of_joint(j, substep, bodies, joints)
        size += firm_errors(j, joints)
    return size


def firm_errors(j: int, joints: Joints) -> float:
    """Return the sum of the squares of the errors of the firm rows of a joint, m^2/s^2.

    A rate of turning counts at the arm of its row.
    """
    numbers, size = joints.numbers[j], 0.0
    for r in range(joints.joints[j, tb.J_ROWS]):
        if numbers[tb.J_FIRMNESS + r] > 0.0:
            error = numbers[tb.J_ARM + r] * numbers[tb.J_ERROR + r]
            size += error * error
    return size


@inlined
def begin_errors(row: Array, error_x: float, error_y: float) -> None:
    """Write the error of a hinge; its node has no bias yet."""
    row[tb.H_ERROR], row[tb.H_ERROR + 1] = error_x, error_y
    row[tb.H_BIAS] = row[tb.H_BIAS + 1] = row[tb.H_BIAS + 2] = row[tb.H_LAW] = 0.0


def solve_hinges(n: int, bodies: Bodies, joints: Joints) -> float:
    """Give a tree the impulses that take its errors away.

    Returns the largest product of what they change the spin of a body by and what it then is, at
    most, 1/s^2.
    """
    first, last = joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1
    besides, end = first_besides(n, joints), joints.mechanisms[n + 1, tb.M_JOINT]
    for j in range(besides, end):
        for r in range(joints.joints[j, tb.J_ROWS]):
            if joints.numbers[j, tb.J_FIRMNESS + r] == 0.0:  # it does not hold
                continue
            if is_law(j, joints):
                add_law_bias(j, joints)
            else:
                add_tie_bias(j, r, joints)
    hinges, members = joints.hinges, joints.members
    for m in range(last - 1, first, -1):
        bias_at_hinge(hinges[m])
        pass_up(hinges[m], hinges[members[m, tb.JOINED_ABOVE]])
    bias_at_hinge(hinges[first])
    if members[first, tb.JOINED_HINGE] < 0:
        let_go(hinges[first])
    largest = 0.0
    for m in range(first, last):
        impulse = pass_down(m, hinges[members[m, tb.JOINED_ABOVE]], joints)
        row, spin = hinges[m], bodies.motion[members[m, tb.JOINED_SLOT], tb.SPIN]
        change_of_spin = abs(row[tb.H_CHANGE + 2])
        largest = max(largest, change_of_spin * (abs(spin) + change_of_spin))
        row[tb.H_IMPULSE], row[tb.H_IMPULSE + 1] = impulse[0], impulse[1]
        push_through(m, first, impulse, bodies, joints)
    for j in range(besides, end):
        for r in range(joints.joints[j, tb.J_ROWS]):
            joints.numbers[j, tb.J_IMPULSE + r] = 0.0
            if joints.numbers[j, tb.J_FIRMNESS + r] == 0.0:
                continue
            if is_law(j, joints):
                joints.numbers[j, tb.J_IMPULSE] = impulse_of_law(j, joints)
                turn_by_law(j, joints.numbers[j, tb.J_IMPULSE], bodies, joints)
            else:
                joints.numbers[j, tb.J_IMPULSE + r] = impulse_of_tie(j, r, joints)
                apply_joint_impulse(j, r, joints.numbers[j, tb.J_IMPULSE + r], bodies, joints)
    return largest


@inlined
def bias_at_hinge(row: Array) -> None:
    """Find the bias of a node at its hinge."""
    bias, arm = (row[tb.H_BIAS], row[tb.H_BIAS + 1]), (row[tb.H_ARM], row[tb.H_ARM + 1])
    turning = turn_bias(row[tb.H_BIAS + 2], bias, arm, row[tb.H_LAW])
    hung = momentum_hung(bias, turning, (row[tb.H_LEVER], row[tb.H_LEVER + 1]))
    row[tb.H_BIAS], row[tb.H_BIAS + 1], row[tb.H_BIAS + 2] = hung[0], hung[1], turning


@inlined
def pass_up(row: Array, above: Array) -> None:
    """Add the bias of a node, and what the error of its hinge asks for, to the node above."""
    hung, error = (row[tb.H_BIAS], row[tb.H_BIAS + 1]), (row[tb.H_ERROR], row[tb.H_ERROR + 1])
    far, turned = (
        (row[tb.H_FAR_ARM], row[tb.H_FAR_ARM + 1]),
        (row[tb.H_MOMENT], row[tb.H_MOMENT + 1]),
    )
    mass_x, mass_y = (row[tb.H_MASS], row[tb.H_MASS + 1]), (row[tb.H_MASS + 1], row[tb.H_MASS + 2])
    passed = momentum_passed(hung, error, mass_x, mass_y)
    turning = angular_momentum_passed(
        passed, row[tb.H_BIAS + 2], error, turned, row[tb.H_SHARE], far, row[tb.H_LAW]
    )
    above[tb.H_BIAS] += passed[0]
    above[tb.H_BIAS + 1] += passed[1]
    above[tb.H_BIAS + 2] += turning


@inlined
def let_go(row: Array) -> None:
    """Let the root of a tree that nothing ties move so that no impulse goes through its hinge."""
    mass_x, mass_y = (row[tb.H_MASS], row[tb.H_MASS + 1]), (row[tb.H_MASS + 1], row[tb.H_MASS + 2])
    by_x, by_y = root_change((row[tb.H_BIAS], row[tb.H_BIAS + 1]), mass_x, mass_y)
    row[tb.H_ERROR], row[tb.H_ERROR + 1] = -by_x, -by_y


@inlined
def pass_down(m: int, above: Array, joints: Joints) -> Vector:
    """Find how the velocities of a body change; return the impulse through its hinge."""
    row = joints.hinges[m]
    by, spin_above = (above[tb.H_CHANGE], above[tb.H_CHANGE + 1]), above[tb.H_CHANGE + 2]
    far, error = (row[tb.H_FAR_ARM], row[tb.H_FAR_ARM + 1]), (row[tb.H_ERROR], row[tb.H_ERROR + 1])
    at_hinge = hinge_change(by, spin_above, far, error)
    lever, arm = (row[tb.H_LEVER], row[tb.H_LEVER + 1]), (row[tb.H_ARM], row[tb.H_ARM + 1])
    share = row[tb.H_SHARE]
    turn = spin_change(spin_above, share, at_hinge, lever, row[tb.H_BIAS + 2], row[tb.H_YIELD])
    own = change(at_hinge, turn, arm)
    row[tb.H_CHANGE], row[tb.H_CHANGE + 1], row[tb.H_CHANGE + 2] = own[0], own[1], turn
    mass_x, mass_y = (row[tb.H_MASS], row[tb.H_MASS + 1]), (row[tb.H_MASS + 1], row[tb.H_MASS + 2])
    hung, turned = (row[tb.H_BIAS], row[tb.H_BIAS + 1]), (row[tb.H_MOMENT], row[tb.H_MOMENT + 1])
    return hinge_impulse(at_hinge, spin_above, mass_x, mass_y, turned, share, hung)


@inlined
def push_through(m: int, first: int, impulse: Vector, bodies: Bodies, joints: Joints) -> None:
    """Give a member of a tree and the one above it the impulse through its hinge."""
    row = joints.hinges[m]
    if joints.members[m, tb.JOINED_HINGE] >= 0:
        row[tb.H_GIVEN] += impulse[0]
        row[tb.H_GIVEN + 1] += impulse[1]
        push_hinged(m, (row[tb.H_ARM], row[tb.H_ARM + 1]), impulse, bodies, joints)
    if m > first:
        away, far = (-impulse[0], -impulse[1]), (row[tb.H_FAR_ARM], row[tb.H_FAR_ARM + 1])
        push_hinged(joints.members[m, tb.JOINED_ABOVE], far, away, bodies, joints)


@inlined
def push_hinged(m: int, arm: Vector, impulse: Vector, bodies: Bodies, joints: Joints) -> None:
    """Give a member an impulse at its hinge, which is not what contacts have done."""
    i = joints.members[m, tb.JOINED_SLOT]
    now, state = bodies.motion[i], bodies.substep_state[i]
    held = joints.places[m, tb.HELD_INVERSE_INERTIA]
    by_x, by_y = velocity_hinged((0.0, 0.0), impulse, joints.places[m, tb.SLOWED_INVERSE_MASS])
    turn = angular_velocity_hinged(0.0, arm, impulse, held)
    now[tb.VX], now[tb.VY], now[tb.SPIN] = now[tb.VX] + by_x, now[tb.VY] + by_y, now[tb.SPIN] + turn
    state[tb.SUBSTEP_START] += by_x
    state[tb.SUBSTEP_START + 1] += by_y
    state[tb.SUBSTEP_START + 2] += turn


def add_tie_bias(j: int, r: int, joints: Joints) -> None:
    """Add what the error of a firm row asks for to the bias of the node of a tied body."""
    ends, numbers = joints.joints[j], joints.numbers[j]
    asked = -row_impulse(numbers[tb.J_ERROR + r], numbers[tb.J_FIRMNESS + r])
    for end in range(tb.ENDS_OF_JOINT):
        if ends[tb.J_NODE + end] >= 0:
            row, at = joints.hinges[ends[tb.J_NODE + end] + 1], tb.J_ROW + ROW * r + 1 + 3 * end
            slope, bias = (numbers[at], numbers[at + 1]), (row[tb.H_BIAS], row[tb.H_BIAS + 1])
            row[tb.H_BIAS], row[tb.H_BIAS + 1] = momentum_later(bias, asked, slope)
            row[tb.H_BIAS + 2] = angular_momentum_later(row[tb.H_BIAS + 2], asked, numbers[at + 2])


def impulse_of_tie(j: int, r: int, joints: Joints) -> float:
    """Return the impulse of a firm row, N s."""
    ends, numbers = joints.joints[j], joints.numbers[j]
    rate = numbers[tb.J_ERROR + r]
    for end in range(tb.ENDS_OF_JOINT):
        if ends[tb.J_NODE + end] >= 0:
            row, at = joints.hinges[ends[tb.J_NODE + end] + 1], tb.J_ROW + ROW * r + 1 + 3 * end
            slope, by = (numbers[at], numbers[at + 1]), (row[tb.H_CHANGE], row[tb.H_CHANGE + 1])
            rate += row_rate(slope, numbers[at + 2], by, row[tb.H_CHANGE + 2])
    return row_impulse(rate, numbers[tb.J_FIRMNESS + r])
