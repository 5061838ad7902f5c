"""The matrix of a network of springs, times a vector, and the solution of its equations.

A network is what springs connect through bodies that move freely. Its matrix is what resists a
change of the coordinates of its members: their masses, and each spring along and across its axis.
It is symmetric and positive definite, and is never written down.

Cost: a visit to each member and spring in each iteration. Source: Hestenes and Stiefel (1952).
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Springs
from tamias2d.generated.definitions import point_velocity, torque
from tamias2d.generated.spring_step import resisting_impulse
from tamias2d.state import Array, Vector

MOST_ITERATIONS = 4  # times the coordinates of a network, and twenty: rounding costs some


def solve_network(n: int, accuracy: float, springs: Springs) -> None:
    """Solve the equations of a network for its residual, to an accuracy relative to it.

    The solution is in SOLUTION; conjugate gradients, preconditioned by the diagonal.
    """
    first, last = springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]
    members = springs.members
    size = 0.0
    for k in range(first, last):
        row = members[k]
        for c in range(3):
            row[tb.SOLUTION + c] = 0.0
            row[tb.SEARCH + c] = preconditioned(c, row)
            size += row[tb.SEARCH + c] * row[tb.RESIDUAL + c]
    enough = accuracy * accuracy * size
    for _ in range(MOST_ITERATIONS * 3 * (last - first) + 20):
        if not size > enough:
            return
        multiply(n, tb.SEARCH, springs)
        curvature = 0.0
        for k in range(first, last):
            for c in range(3):
                curvature += members[k, tb.SEARCH + c] * members[k, tb.PRODUCT + c]
        if not curvature > 0.0:
            return
        share, before, size = size / curvature, size, 0.0
        for k in range(first, last):
            row = members[k]
            for c in range(3):
                row[tb.SOLUTION + c] += share * row[tb.SEARCH + c]
                row[tb.RESIDUAL + c] -= share * row[tb.PRODUCT + c]
                size += preconditioned(c, row) * row[tb.RESIDUAL + c]
        for k in range(first, last):
            row = members[k]
            for c in range(3):
                row[tb.SEARCH + c] = preconditioned(c, row) + size / before * row[tb.SEARCH + c]


def preconditioned(c: int, row: Array) -> float:
    """Return a coordinate of a member's residual over the diagonal; 0 where it cannot move."""
    if row[tb.RESISTANCE + c] == 0.0:
        return 0.0
    return float(row[tb.RESIDUAL + c] / row[tb.MATRIX_DIAGONAL + c])


def multiply(n: int, column: int, springs: Springs) -> None:
    """Write the matrix of a network times a vector, given by its column, to PRODUCT."""
    members = springs.members
    for k in range(springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]):
        row = members[k]
        for c in range(3):
            row[tb.PRODUCT + c] = row[tb.RESISTANCE + c] * row[column + c]
        row[tb.PRODUCT + 2] += row[tb.STIFFENING] * row[column + 2]
    for s in range(springs.networks[n, tb.N_SPRING], springs.networks[n + 1, tb.N_SPRING]):
        resist(s, column, tb.PRODUCT, -1.0, springs)


def resist(s: int, column: int, to: int, sign: float, springs: Springs) -> None:
    """Add what a spring does against velocities, given by their column, to another column."""
    spring, members = springs.springs[s], springs.members
    a, b = springs.ends[s, tb.MEMBER_A], springs.ends[s, tb.MEMBER_B]
    x, y = end_velocity(a, column, (spring[tb.ARM_A], spring[tb.ARM_A + 1]), members)
    velocity = (-x, -y)
    if b >= 0:
        x, y = end_velocity(b, column, (spring[tb.ARM_B], spring[tb.ARM_B + 1]), members)
        velocity = (x + velocity[0], y + velocity[1])
    axis = (spring[tb.AXIS_X], spring[tb.AXIS_Y])
    x, y = resisting_impulse(spring[tb.ALONG], spring[tb.ACROSS], axis, velocity)
    pull_ends(s, (sign * x, sign * y), to, springs)


def pull_ends(s: int, force: Vector, to: int, springs: Springs) -> None:
    """Add a force on end A of a spring, and the opposite one on B, to a column of their bodies."""
    spring, members = springs.springs[s], springs.members
    a, b = springs.ends[s, tb.MEMBER_A], springs.ends[s, tb.MEMBER_B]
    x, y = force
    members[a, to] += x
    members[a, to + 1] += y
    members[a, to + 2] += torque((spring[tb.ARM_A], spring[tb.ARM_A + 1]), (x, y))
    if b >= 0:
        members[b, to] -= x
        members[b, to + 1] -= y
        members[b, to + 2] -= torque((spring[tb.ARM_B], spring[tb.ARM_B + 1]), (x, y))


def end_velocity(k: int, column: int, arm: Vector, members: Array) -> Vector:
    """Return the velocity of a point of a member; 0 of what cannot move stands in the column."""
    row = members[k]
    x, y = point_velocity((row[column], row[column + 1]), row[column + 2], arm)
    return x, y


def write_diagonal(n: int, springs: Springs) -> None:
    """Write the diagonal of the matrix of a network."""
    members = springs.members
    for k in range(springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]):
        row = members[k]
        for c in range(3):
            row[tb.MATRIX_DIAGONAL + c] = row[tb.RESISTANCE + c]
        row[tb.MATRIX_DIAGONAL + 2] += row[tb.STIFFENING]
    for s in range(springs.networks[n, tb.N_SPRING], springs.networks[n + 1, tb.N_SPRING]):
        spring = springs.springs[s]
        resist_at_end(
            s, springs.ends[s, tb.MEMBER_A], spring[tb.ARM_A], spring[tb.ARM_A + 1], springs
        )
        if springs.ends[s, tb.MEMBER_B] >= 0:
            resist_at_end(
                s, springs.ends[s, tb.MEMBER_B], spring[tb.ARM_B], spring[tb.ARM_B + 1], springs
            )


def resist_at_end(s: int, k: int, arm_x: float, arm_y: float, springs: Springs) -> None:
    """Add what a spring resists at one of its ends to the diagonal of the body there."""
    spring, row = springs.springs[s], springs.members[k]
    axis = (spring[tb.AXIS_X], spring[tb.AXIS_Y])
    along, across = spring[tb.ALONG], spring[tb.ACROSS]
    row[tb.MATRIX_DIAGONAL] += resisting_impulse(along, across, axis, (1.0, 0.0))[0]
    row[tb.MATRIX_DIAGONAL + 1] += resisting_impulse(along, across, axis, (0.0, 1.0))[1]
    turning = point_velocity((0.0, 0.0), 1.0, (arm_x, arm_y))
    row[tb.MATRIX_DIAGONAL + 2] += torque(
        (arm_x, arm_y), resisting_impulse(along, across, axis, turning)
    )
