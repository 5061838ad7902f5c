"""The impulses of a mechanism's joints: all of them at once (DD57, IM15).

What they do to velocities is what they are on both sides to the last bit, however well they are
known: momentum and angular momentum are those of the impulses.

Cost: a visit to each joint and a substitution for each iteration.
"""

from tamias2d.engine.direct.cholesky import substitute
from tamias2d.engine.joints.iterate import change_of_rate, iterate_mesh
from tamias2d.engine.joints.linearise import ENDS_OF_JOINT, place_members
from tamias2d.engine.tables import (
    CHANGE,
    HELD_INVERSE_INERTIA,
    I_NODE,
    INVERSE_MASS,
    J_AIM,
    J_ERROR,
    J_FIRMNESS,
    J_IMPULSE,
    J_KIND,
    J_MEMBER,
    J_NODE,
    J_PULL,
    J_ROW,
    J_ROWS,
    J_TOTAL,
    J_WARM,
    JOINED_SLOT,
    M_JOINT,
    M_MESHED,
    SPIN,
    SUBSTEP_START,
    VX,
    VY,
    Bodies,
    Joints,
)
from tamias2d.generated.joint_rows import ROW, joint_values
from tamias2d.generated.joint_step import (
    angular_momentum_later,
    angular_velocity_later,
    momentum_later,
    row_aim,
    row_error,
    row_impulse,
    row_rate,
    velocity_later,
)

REMOVED_BY_JOINTS = 0.2  # of the value of a row, in a substep of a whole step
MOST_ITERATIONS_OF_JOINTS = 5
SOLVED_RATE = 1e-4  # of the largest error of the first iteration: as good as solved


def aim_joints(n: int, length: float, joints: Joints) -> None:
    """Note to which values a substep brings the rows of a mechanism, which were just written.

    Its length is a share of that of a substep of a whole step: shorter ones remove less.
    """
    for j in range(joints.mechanisms[n, M_JOINT], joints.mechanisms[n + 1, M_JOINT]):
        numbers = joints.numbers[j]
        for r in range(joints.joints[j, J_ROWS]):
            numbers[J_AIM + r] = row_aim(numbers[J_ROW + ROW * r], REMOVED_BY_JOINTS * length)


def keep_positions(n: int, again: bool, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Change the velocities of a mechanism so that a substep, s, leads to what its rows aim at.

    Again, they have changed little. A mesh is solved once only: what is left of its rows is made
    up for in the next substep.
    """
    if joints.mechanisms[n, M_MESHED] == 1:
        find_position_errors(n, substep, bodies, joints)
        start_impulses(n, 0.0 if again else 1.0, joints)
        solve_joint_errors(n, bodies, joints)
        if not again:
            keep_impulses(n, joints)
        return
    first = before = 0.0
    for k in range(MOST_ITERATIONS_OF_JOINTS):
        size = find_position_errors(n, substep, bodies, joints)
        if k == 0:
            first = size
        elif not SOLVED_RATE * SOLVED_RATE * first < size < before:
            return
        if size == 0.0:
            return
        solve_joint_errors(n, bodies, joints)
        before = size


def keep_velocities(n: int, warm: float, bodies: Bodies, joints: Joints) -> None:
    """Take the rates of its rows from the velocities of a mechanism.

    Of a mesh, the impulses are about so many times those of the last substep.
    """
    start_impulses(n, warm, joints)
    for _ in range(1 if joints.mechanisms[n, M_MESHED] == 1 else 2):
        for j in range(joints.mechanisms[n, M_JOINT], joints.mechanisms[n + 1, M_JOINT]):
            for r in range(joints.joints[j, J_ROWS]):
                joints.numbers[j, J_ERROR + r] = rate_of_row(j, r, bodies, joints)
        solve_joint_errors(n, bodies, joints)


def start_impulses(n: int, share: float, joints: Joints) -> None:
    """Let a mesh start from a share of the impulses of the last substep."""
    for j in range(joints.mechanisms[n, M_JOINT], joints.mechanisms[n + 1, M_JOINT]):
        for r in range(joints.joints[j, J_ROWS]):
            joints.numbers[j, J_IMPULSE + r] = share * joints.numbers[j, J_WARM + r]


def keep_impulses(n: int, joints: Joints) -> None:
    """Keep the impulses of a mesh for the next substep."""
    for j in range(joints.mechanisms[n, M_JOINT], joints.mechanisms[n + 1, M_JOINT]):
        for r in range(joints.joints[j, J_ROWS]):
            joints.numbers[j, J_WARM + r] = joints.numbers[j, J_IMPULSE + r]


def find_position_errors(n: int, substep: float, bodies: Bodies, joints: Joints) -> float:
    """Write the rate that each row of a mechanism has too much; return a measure of all, J."""
    place_members(
        joints.sparse[n, I_NODE] + 1, joints.sparse[n + 1, I_NODE] + 1, substep, bodies, joints
    )
    size = 0.0
    for j in range(joints.mechanisms[n, M_JOINT], joints.mechanisms[n + 1, M_JOINT]):
        ends, numbers = joints.joints[j], joints.numbers[j]
        a, b, c = ends[J_MEMBER], ends[J_MEMBER + 1], ends[J_MEMBER + 2]
        place_a, place_b, place_c = joints.places[a], joints.places[b], joints.places[c]
        joint_values(ends[J_KIND], joints.given[j], place_a, place_b, place_c, numbers)
        for r in range(ends[J_ROWS]):
            error = row_error(numbers[J_ROW + ROW * r], numbers[J_AIM + r], substep)
            numbers[J_ERROR + r] = error
            size += numbers[J_FIRMNESS + r] * error * error
    return size


def rate_of_row(j: int, r: int, bodies: Bodies, joints: Joints) -> float:
    """Return the rate of a row of a joint, m/s."""
    ends, numbers = joints.joints[j], joints.numbers[j]
    rate = 0.0
    for end in range(ENDS_OF_JOINT):
        at, i = J_ROW + ROW * r + 1 + 3 * end, joints.members[ends[J_MEMBER + end], JOINED_SLOT]
        if ends[J_NODE + end] >= 0:
            now = bodies.motion[i]
            slope, velocity = (numbers[at], numbers[at + 1]), (now[VX], now[VY])
            rate += row_rate(slope, numbers[at + 2], velocity, now[SPIN])
    return rate


def solve_joint_errors(n: int, bodies: Bodies, joints: Joints) -> None:
    """Give a mechanism the impulses that take the errors of its rows away."""
    if joints.mechanisms[n, M_MESHED] == 1:
        iterate_mesh(n, bodies, joints)
    else:
        solve_directly(n, joints)
    for j in range(joints.mechanisms[n, M_JOINT], joints.mechanisms[n + 1, M_JOINT]):
        for r in range(joints.joints[j, J_ROWS]):
            apply_joint_impulse(j, r, joints.numbers[j, J_IMPULSE + r], bodies, joints)


def solve_directly(n: int, joints: Joints) -> None:
    """Find the impulses of a mechanism by its factored matrix."""
    factors = joints.factors
    for node in range(joints.sparse[n, I_NODE], joints.sparse[n + 1, I_NODE]):
        factors[node, CHANGE] = factors[node, CHANGE + 1] = factors[node, CHANGE + 2] = 0.0
    first, last = joints.mechanisms[n, M_JOINT], joints.mechanisms[n + 1, M_JOINT]
    for j in range(first, last):
        numbers = joints.numbers[j]
        for r in range(joints.joints[j, J_ROWS]):
            impulse = row_impulse(numbers[J_ERROR + r], numbers[J_FIRMNESS + r])
            add_to_ends(j, r, impulse, joints)
    substitute(n, joints.sparse, factors)
    for j in range(first, last):
        numbers = joints.numbers[j]
        for r in range(joints.joints[j, J_ROWS]):
            rate = numbers[J_ERROR + r] + change_of_rate(j, r, joints)
            numbers[J_IMPULSE + r] = row_impulse(rate, numbers[J_FIRMNESS + r])


def add_to_ends(j: int, r: int, impulse: float, joints: Joints) -> None:
    """Add the impulse of a row to the right-hand side at its nodes."""
    ends, numbers = joints.joints[j], joints.numbers[j]
    for end in range(ENDS_OF_JOINT):
        node, at = ends[J_NODE + end], J_ROW + ROW * r + 1 + 3 * end
        if node >= 0:
            change, slope = joints.factors[node], (numbers[at], numbers[at + 1])
            change[CHANGE], change[CHANGE + 1] = momentum_later(
                (change[CHANGE], change[CHANGE + 1]), impulse, slope
            )
            change[CHANGE + 2] = angular_momentum_later(
                change[CHANGE + 2], impulse, numbers[at + 2]
            )


def apply_joint_impulse(j: int, r: int, impulse: float, bodies: Bodies, joints: Joints) -> None:
    """Give the bodies of a joint the impulse of a row, and add it to those of the step.

    It is not what contacts have done, and so it also changes with what the substep began.
    """
    ends, numbers = joints.joints[j], joints.numbers[j]
    numbers[J_PULL + r] += impulse
    for end in range(ENDS_OF_JOINT):
        i, at = joints.members[ends[J_MEMBER + end], JOINED_SLOT], J_ROW + ROW * r + 1 + 3 * end
        slope, turning, to = (numbers[at], numbers[at + 1]), numbers[at + 2], J_TOTAL + 3 * end
        numbers[to], numbers[to + 1] = momentum_later(
            (numbers[to], numbers[to + 1]), impulse, slope
        )
        numbers[to + 2] = angular_momentum_later(numbers[to + 2], impulse, turning)
        if ends[J_NODE + end] >= 0:
            inverse_mass = bodies.properties[i, INVERSE_MASS]
            now, state = bodies.motion[i], bodies.substep_state[i]
            by_x, by_y = velocity_later((0.0, 0.0), impulse, slope, inverse_mass)
            held = joints.places[ends[J_MEMBER + end], HELD_INVERSE_INERTIA]
            turn = angular_velocity_later(0.0, impulse, turning, held)
            now[VX], now[VY], now[SPIN] = now[VX] + by_x, now[VY] + by_y, now[SPIN] + turn
            state[SUBSTEP_START] += by_x
            state[SUBSTEP_START + 1] += by_y
            state[SUBSTEP_START + 2] += turn
