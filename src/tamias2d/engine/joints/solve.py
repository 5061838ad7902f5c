"""The impulses of a mechanism's joints: all of them at once (DD57, IM15).

What they do to velocities is what they are on both sides to the last bit, however well they are
known: momentum and angular momentum are those of the impulses.

Cost: a visit to each joint and a substitution for each iteration.
"""

from math import inf

from tamias2d.engine import tables as tb
from tamias2d.engine.direct.cholesky import substitute
from tamias2d.engine.joints.acceptance import is_rejected, note_most_motion
from tamias2d.engine.joints.impulse import apply_joint_impulse
from tamias2d.engine.joints.iterate import change_of_rate, iterate_mesh
from tamias2d.engine.joints.linearise import (
    factor_mechanism,
    place_members,
    rows_where_placed,
    spring_now,
)
from tamias2d.engine.joints.opening import closing_rate, share_closed
from tamias2d.engine.joints.placed_rows import write_values
from tamias2d.engine.joints.yielding import (
    REMOVED_BY_JOINTS,
    REMOVED_YIELDING,
    energy_asked,
    gain_of_node,
    let_yield,
    may_yield,
    yields,
)
from tamias2d.engine.tables import Bodies, Joints
from tamias2d.generated.joint_rows import ROW
from tamias2d.generated.joint_step import (
    angular_momentum_later,
    drive_error,
    momentum_later,
    row_aim,
    row_error,
    row_impulse,
    row_rate,
    spring_error,
)

MOST_ITERATIONS_OF_JOINTS = 12  # two to three are usual
SLOWLY = 0.1  # by which share errors become less: else rows are found anew
SOLVED_RATE = 1e-7  # of the largest error of the first iteration: as good as solved


def aim_joints(n: int, length: float, substep: float, joints: Joints) -> None:
    """Note to which values a substep, s, brings the rows of a mechanism, which were just written.

    Its length is a share of that of a substep of a whole step: shorter ones remove less. A limit
    aims at nothing unless it is passed already. Of springs it is noted where they are.
    """
    way = closing_rate(n, joints) * substep
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        aim_joint(j, length, way, joints)


def aim_joint(j: int, length: float, way: float, joints: Joints) -> None:
    """Note to which values a substep brings the rows of a joint: by a way, m, at most.

    Its length is as above.
    """
    numbers, law = joints.numbers[j], joints.joints[j, tb.J_LAW]
    for r in range(joints.joints[j, tb.J_ROWS]):
        value = numbers[tb.J_ROW + ROW * r]
        if law == tb.LOWER_LIMIT:
            value = min(value, 0.0)
        elif law == tb.UPPER_LIMIT:
            value = max(value, 0.0)
        removed = 0.0 if law == tb.SPRING else REMOVED_BY_JOINTS * length
        if numbers[tb.J_FIRMEST] > 0.0:
            removed *= REMOVED_YIELDING
        removed = share_closed(value, removed, way / numbers[tb.J_ARM + r])
        numbers[tb.J_AIM + r] = row_aim(value, removed)
        numbers[tb.J_GIVEN + r] = -numbers[tb.J_LEFT] if law == tb.SPRING else 0.0


def bring_to_aims(
    n: int, again: bool, first: float, substep: float, bodies: Bodies, joints: Joints
) -> None:
    """Change the velocities of a mechanism so that a substep brings its rows where they are to be.

    The size of errors was so much at first, J, if that is known. A mesh is solved once only: what
    is left of its rows is made up for in the next substep.
    """
    if joints.mechanisms[n, tb.M_MESHED] == 1:
        find_position_errors(n, substep, bodies, joints)
        share = 0.5 if joints.mechanisms[n, tb.M_HALF] == 1 else 1.0
        start_impulses(n, 0.0 if again else share, joints)
        solve_joint_errors(n, substep, inf, bodies, joints)
        if not again:
            keep_impulses(n, share, joints)
        return
    before, most, turned, fitted = inf, 0.0, False, False
    for k in range(MOST_ITERATIONS_OF_JOINTS):
        size = find_position_errors(n, substep, bodies, joints)
        if k == 0:
            first, most = max(first, size), energy_asked_of_rows(n, substep, joints)
        if turned and not size < before:
            take_impulses_back(n, 1.0, bodies, joints)  # no solution is near
            return
        if size <= SOLVED_RATE * SOLVED_RATE * first:
            return
        turned = size > SLOWLY * before
        if turned:
            turn_rows(n, substep, joints)
        solve_joint_errors(n, substep, most, bodies, joints)
        before = size
        if is_rejected(n, 0.0, bodies, joints):
            take_impulses_back(n, 1.0, bodies, joints)
            if fitted or k > 0:
                return
            keep_velocities(n, 0.0, substep, bodies, joints)
            note_most_motion(n, substep, bodies, joints)
            before, fitted = inf, True
        if yields(n, joints):
            return


def energy_asked_of_rows(n: int, substep: float, joints: Joints) -> float:
    """Return the most energy that the errors of a mechanism may give it, J: any, of a mesh."""
    first = joints.mechanisms[n, tb.M_JOINT]
    if joints.mechanisms[n, tb.M_MESHED] == 1 or not may_yield(n, first, joints):
        return inf
    return energy_asked(n, first, 0.0, substep, joints)


def take_impulses_back(n: int, share: float, bodies: Bodies, joints: Joints) -> None:
    """Take a share of the impulses of the last solution from a mechanism."""
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        for r in range(joints.joints[j, tb.J_ROWS]):
            back = -share * joints.numbers[j, tb.J_IMPULSE + r]
            apply_joint_impulse(j, r, back, bodies, joints)


def turn_rows(n: int, substep: float, joints: Joints) -> None:
    """Let the rows of a mechanism be those where its members are placed."""
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        rows_where_placed(j, joints)
    factor_mechanism(n, substep, joints)


def keep_velocities(n: int, warm: float, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Take the rates of its rows from the velocities of a mechanism.

    Of a mesh, the impulses are about so many times those of the last substep.
    """
    start_impulses(n, warm, joints)
    for _ in range(1 if joints.mechanisms[n, tb.M_MESHED] == 1 else 2):
        write_rates(n, bodies, joints)
        most = energy_asked_of_rows(n, substep, joints)
        solve_joint_errors(n, 0.0, most, bodies, joints)


def write_rates(n: int, bodies: Bodies, joints: Joints) -> None:
    """Write the rates of the rows of a mechanism as their errors."""
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        for r in range(joints.joints[j, tb.J_ROWS]):
            rate = rate_of_row(j, r, bodies, joints)
            joints.numbers[j, tb.J_ERROR + r] = drive_error(rate, joints.laws[j, tb.LAW_RATE])


def start_impulses(n: int, share: float, joints: Joints) -> None:
    """Let a mesh start from a share of the impulses of the last substep."""
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        for r in range(joints.joints[j, tb.J_ROWS]):
            numbers = joints.numbers[j]
            own = share if numbers[tb.J_FIRMNESS + r] > 0.0 else 0.0
            numbers[tb.J_IMPULSE + r] = own * numbers[tb.J_WARM + r]


def keep_impulses(n: int, share: float, joints: Joints) -> None:
    """Keep the impulses of a mesh for the next substep: they are such a share of a whole one's."""
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        for r in range(joints.joints[j, tb.J_ROWS]):
            joints.numbers[j, tb.J_WARM + r] = joints.numbers[j, tb.J_IMPULSE + r] / share


def find_position_errors(n: int, substep: float, bodies: Bodies, joints: Joints) -> float:
    """Write the rate that each row of a mechanism has too much; return a measure of all, J."""
    place_members(
        joints.sparse[n, tb.I_NODE] + 1,
        joints.sparse[n + 1, tb.I_NODE] + 1,
        substep,
        bodies,
        joints,
    )
    size = 0.0
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        size += errors_of_joint(j, substep, bodies, joints)
    return size


def errors_of_joint(j: int, substep: float, bodies: Bodies, joints: Joints) -> float:
    """Write the rates that the rows of a joint have too much; return a measure of them, J.

    Its values are those where its members are placed.
    """
    ends, numbers = joints.joints[j], joints.numbers[j]
    write_values(j, joints)
    size = 0.0
    for r in range(ends[tb.J_ROWS]):
        error = error_of_row(j, r, substep, bodies, joints)
        numbers[tb.J_ERROR + r] = error
        size += numbers[tb.J_FIRMNESS + r] * error * error
    return size


def error_of_row(j: int, r: int, substep: float, bodies: Bodies, joints: Joints) -> float:
    """Return the rate that a row of a joint has too much, whose value is that to which it leads."""
    numbers, law = joints.numbers[j], joints.laws[j]
    value, firm = numbers[tb.J_ROW + ROW * r], numbers[tb.J_FIRMNESS + r]
    if joints.joints[j, tb.J_LAW] < tb.MOTOR:
        return row_error(value, numbers[tb.J_AIM + r], substep)
    rate = rate_of_row(j, r, bodies, joints)
    if joints.joints[j, tb.J_LAW] == tb.MOTOR:
        return drive_error(rate, law[tb.LAW_RATE])
    stiffness, damping = spring_now(j, joints)
    start, given, share = numbers[tb.J_AIM + r], numbers[tb.J_GIVEN + r], numbers[tb.J_SHARE]
    if firm == 0.0:
        return 0.0
    return spring_error(value, start, rate, given, stiffness, damping, share, firm, substep)


def rate_of_row(j: int, r: int, bodies: Bodies, joints: Joints) -> float:
    """Return the rate of a row of a joint, m/s."""
    ends, numbers = joints.joints[j], joints.numbers[j]
    rate = 0.0
    for end in range(tb.ENDS_OF_JOINT):
        at, i = (
            tb.J_ROW + ROW * r + 1 + 3 * end,
            joints.members[ends[tb.J_MEMBER + end], tb.JOINED_SLOT],
        )
        if ends[tb.J_NODE + end] != tb.UNUSED:
            now = bodies.motion[i]
            slope, velocity = (numbers[at], numbers[at + 1]), (now[tb.VX], now[tb.VY])
            rate += row_rate(slope, numbers[at + 2], velocity, now[tb.SPIN])
    return rate


def solve_joint_errors(n: int, ahead: float, most: float, bodies: Bodies, joints: Joints) -> None:
    """Give a mechanism the impulses that take the errors of its rows away, or let these yield.

    They do where these would give it more than an energy, J. Springs count as `factor_mechanism`
    says.
    """
    if joints.mechanisms[n, tb.M_MESHED] == 1:
        iterate_mesh(n, joints)
    else:
        solve_directly(n, joints)
        if most < inf and not yields(n, joints) and not gain_of_rows(n, joints) <= most:
            let_yield(n, joints)
            factor_mechanism(n, ahead, joints)
            solve_directly(n, joints)
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        for r in range(joints.joints[j, tb.J_ROWS]):
            apply_joint_impulse(j, r, joints.numbers[j, tb.J_IMPULSE + r], bodies, joints)


def gain_of_rows(n: int, joints: Joints) -> float:
    """Return the energy of what the last solution of a mechanism changes, J."""
    gain = 0.0
    for node in range(joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]):
        gain += gain_of_node(joints.factors[node], tb.CHANGE, joints.factors[node])
    return gain


def solve_directly(n: int, joints: Joints) -> None:
    """Find the impulses of a mechanism by its factored matrix."""
    factors = joints.factors
    for node in range(joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]):
        factors[node, tb.CHANGE] = factors[node, tb.CHANGE + 1] = factors[node, tb.CHANGE + 2] = 0.0
    first, last = joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]
    for j in range(first, last):
        numbers = joints.numbers[j]
        for r in range(joints.joints[j, tb.J_ROWS]):
            impulse = row_impulse(numbers[tb.J_ERROR + r], numbers[tb.J_FIRMNESS + r])
            add_to_ends(j, r, impulse, joints)
    substitute(n, joints.sparse, factors)
    for j in range(first, last):
        numbers = joints.numbers[j]
        for r in range(joints.joints[j, tb.J_ROWS]):
            rate = numbers[tb.J_ERROR + r] + change_of_rate(j, r, joints)
            numbers[tb.J_IMPULSE + r] = row_impulse(rate, numbers[tb.J_FIRMNESS + r])


def add_to_ends(j: int, r: int, impulse: float, joints: Joints) -> None:
    """Add the impulse of a row to the right-hand side at its nodes."""
    ends, numbers = joints.joints[j], joints.numbers[j]
    for end in range(tb.ENDS_OF_JOINT):
        node, at = ends[tb.J_NODE + end], tb.J_ROW + ROW * r + 1 + 3 * end
        if node >= 0:
            change, slope = joints.factors[node], (numbers[at], numbers[at + 1])
            change[tb.CHANGE], change[tb.CHANGE + 1] = momentum_later(
                (change[tb.CHANGE], change[tb.CHANGE + 1]), impulse, slope
            )
            change[tb.CHANGE + 2] = angular_momentum_later(
                change[tb.CHANGE + 2], impulse, numbers[at + 2]
            )
