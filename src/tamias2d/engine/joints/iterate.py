"""The impulses of a mesh: a mechanism of so many loops that its factors would fill.

Conjugate gradients, preconditioned by a sweep through all rows and one back, from the impulses of
the last time. Cost: three visits to each joint in an iteration.
Source: Hestenes and Stiefel (1952); Axelsson (1972), the sweeps.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.linearise import FIRM, yield_of_row
from tamias2d.engine.tables import Joints
from tamias2d.generated.joint_rows import ROW
from tamias2d.generated.joint_step import angular_velocity_later, row_rate, velocity_later
from tamias2d.kernels.assembled import inlined

MOST_ITERATIONS_OF_MESH = 4  # in each substep; what is left is made up for in the next ones
MESH_ACCURACY = 1e-2  # of the errors of the rows, without the impulses of the last time


def iterate_mesh(n: int, joints: Joints) -> None:
    """Find the impulses of a mesh that take the errors of its rows away, nearly."""
    first, last = joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]
    clear_nodes(n, tb.CHANGE, joints)
    for j in range(first, last):
        for r in range(joints.joints[j, tb.J_ROWS]):
            give_to_nodes(j, r, joints.numbers[j, tb.J_IMPULSE + r], joints)
    whole = size = 0.0
    for j in range(first, last):
        numbers = joints.numbers[j]
        for r in range(joints.joints[j, tb.J_ROWS]):
            error = numbers[tb.J_ERROR + r]
            numbers[tb.J_RESIDUAL + r] = -error - change_of_rate(j, r, joints)
            numbers[tb.J_RESIDUAL + r] -= given_way(j, r, numbers[tb.J_IMPULSE + r], joints)
            numbers[tb.J_SEARCH + r] = 0.0
            whole += own_answer(j, r, error * error, joints)
    clear_nodes(n, tb.VELOCITY_START, joints)
    for k in range(MOST_ITERATIONS_OF_MESH):
        before, size = size, sweep_both_ways(n, joints)
        if not size > MESH_ACCURACY * MESH_ACCURACY * whole:
            return
        step_along(n, size, size / before if k > 0 else 0.0, joints)


@inlined
def given_way(j: int, r: int, impulse: float, joints: Joints) -> float:
    """Return by which rate, m/s, a row gives way to an impulse by itself: that of a spring does."""
    firm = joints.numbers[j, tb.J_FIRMNESS + r]
    return impulse / firm if joints.joints[j, tb.J_LAW] == tb.SPRING and firm > 0.0 else 0.0


def own_answer(j: int, r: int, rate: float, joints: Joints) -> float:
    """Return which impulse a row by itself gives against a rate, m/s."""
    ends, numbers = joints.joints[j], joints.numbers[j]
    firm = numbers[tb.J_FIRMNESS + r]
    if ends[tb.J_LAW] == tb.SPRING and firm > 0.0:
        return rate / (yield_of_row(r, ends, numbers, joints) + 1.0 / firm)
    return rate * firm / FIRM


def clear_nodes(n: int, column: int, joints: Joints) -> None:
    """Write zeros to three columns of the nodes of a mechanism."""
    for node in range(joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]):
        for k in range(3):
            joints.factors[node, column + k] = 0.0


def sweep_both_ways(n: int, joints: Joints) -> float:
    """Write what a sweep and one back make of the residual; return their product."""
    first, last = joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]
    clear_nodes(n, tb.CHANGE, joints)
    for j in range(first, last):
        numbers = joints.numbers[j]
        for r in range(joints.joints[j, tb.J_ROWS]):
            left = numbers[tb.J_RESIDUAL + r] - change_of_rate(j, r, joints)
            numbers[tb.J_TRIED + r] = own_answer(j, r, left, joints)
            give_to_nodes(j, r, numbers[tb.J_TRIED + r], joints)
    clear_nodes(n, tb.CHANGE, joints)
    product = 0.0
    for back in range(last - first):
        j = last - 1 - back
        numbers = joints.numbers[j]
        for more in range(joints.joints[j, tb.J_ROWS]):
            r = joints.joints[j, tb.J_ROWS] - 1 - more
            rate = change_of_rate(j, r, joints)
            numbers[tb.J_TRIED + r] -= own_answer(j, r, rate, joints)
            give_to_nodes(j, r, numbers[tb.J_TRIED + r], joints)
            product += numbers[tb.J_TRIED + r] * numbers[tb.J_RESIDUAL + r]
    return product


def step_along(n: int, size: float, kept: float, joints: Joints) -> None:
    """Take a step of conjugate gradients: what was tried, and a share of the last direction."""
    first, last = joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]
    for node in range(joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]):
        row = joints.factors[node]
        for k in range(3):
            row[tb.VELOCITY_START + k] = row[tb.CHANGE + k] + kept * row[tb.VELOCITY_START + k]
            row[tb.CHANGE + k] = row[tb.VELOCITY_START + k]
    curvature = 0.0
    for j in range(first, last):
        numbers = joints.numbers[j]
        for r in range(joints.joints[j, tb.J_ROWS]):
            numbers[tb.J_SEARCH + r] = numbers[tb.J_TRIED + r] + kept * numbers[tb.J_SEARCH + r]
            numbers[tb.J_TRIED + r] = change_of_rate(j, r, joints)
            numbers[tb.J_TRIED + r] += given_way(j, r, numbers[tb.J_SEARCH + r], joints)
            curvature += numbers[tb.J_SEARCH + r] * numbers[tb.J_TRIED + r]
    share = size / curvature if curvature > 0.0 else 0.0
    for j in range(first, last):
        numbers = joints.numbers[j]
        for r in range(joints.joints[j, tb.J_ROWS]):
            numbers[tb.J_IMPULSE + r] += share * numbers[tb.J_SEARCH + r]
            numbers[tb.J_RESIDUAL + r] -= share * numbers[tb.J_TRIED + r]


def change_of_rate(j: int, r: int, joints: Joints) -> float:
    """Return by how much the changes of velocity at its nodes change the rate of a row, m/s."""
    ends, numbers = joints.joints[j], joints.numbers[j]
    rate = 0.0
    for end in range(tb.ENDS_OF_JOINT):
        node, at = ends[tb.J_NODE + end], tb.J_ROW + ROW * r + 1 + 3 * end
        if node >= 0:
            change = joints.factors[node]
            slope, velocity = (
                (numbers[at], numbers[at + 1]),
                (change[tb.CHANGE], change[tb.CHANGE + 1]),
            )
            rate += row_rate(slope, numbers[at + 2], velocity, change[tb.CHANGE + 2])
    return rate


def give_to_nodes(j: int, r: int, impulse: float, joints: Joints) -> None:
    """Let the impulse of a row change the velocities at its nodes."""
    ends, numbers = joints.joints[j], joints.numbers[j]
    for end in range(tb.ENDS_OF_JOINT):
        node, at = ends[tb.J_NODE + end], tb.J_ROW + ROW * r + 1 + 3 * end
        if node >= 0:
            place = joints.places[node + 1]
            change, slope = joints.factors[node], (numbers[at], numbers[at + 1])
            change[tb.CHANGE], change[tb.CHANGE + 1] = velocity_later(
                (change[tb.CHANGE], change[tb.CHANGE + 1]),
                impulse,
                slope,
                place[tb.SLOWED_INVERSE_MASS],
            )
            change[tb.CHANGE + 2] = angular_velocity_later(
                change[tb.CHANGE + 2], impulse, numbers[at + 2], place[tb.HELD_INVERSE_INERTIA]
            )
