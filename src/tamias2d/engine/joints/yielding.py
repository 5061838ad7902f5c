"""Joints that cannot hold yield: damped least squares where rows have no solution near (DD87).

A chain that is pulled straight, or a mechanism in a dead centre, answers a small error with an
immense motion, which leads nowhere. Where the motion that a solution gives has more energy than all
of the mechanism at a few times the rates that its rows have too much, the rows yield: they share
what they cannot remove, and stay apart by the rest until they hold again.

Cost: a visit to each node and row of a mechanism with loops or limits, for each solution.
Source: Levenberg (1944); Nakamura and Hanafusa (1986), for mechanisms.
"""

from math import inf

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.linearise import yield_of_row
from tamias2d.engine.tables import Bodies, Joints
from tamias2d.generated.definitions import kinetic_energy
from tamias2d.generated.joint_rows import ROW
from tamias2d.generated.joint_step import row_rate
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

REMOVED_BY_JOINTS = 0.2  # of the value of a row, in a substep of a whole step
REMOVED_YIELDING = 0.1  # of that, while rows yield
AMPLIFIED = 4.0  # times the rate that its rows have too much: the fastest that all may get


def yields(n: int, joints: Joints) -> bool:
    """Return whether the rows of a mechanism yield."""
    return bool(joints.numbers[joints.mechanisms[n, tb.M_JOINT], tb.J_YIELDS] > 0.0)


def let_yield(n: int, joints: Joints) -> None:
    """Let the rows of a mechanism yield."""
    whole = 0.0
    for node in range(joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]):
        whole += joints.factors[node, tb.NODE_MASS]
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        joints.numbers[j, tb.J_YIELDS] = AMPLIFIED * AMPLIFIED * whole


def hold_again(n: int, joints: Joints) -> None:
    """Let the rows of a mechanism hold again if none that is to be kept is far apart."""
    first, last = joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]
    for j in range(first, last):
        numbers = joints.numbers[j]
        for r in range(joints.joints[j, tb.J_ROWS] if joints.joints[j, tb.J_LAW] == tb.KEPT else 0):
            if abs(numbers[tb.J_ROW + ROW * r]) > numbers[tb.J_SLIGHT + r]:
                return
        law, value = joints.joints[j, tb.J_LAW], numbers[tb.J_ROW]
        if law == tb.LOWER_LIMIT and value < -numbers[tb.J_SLIGHT]:
            return
        if law == tb.UPPER_LIMIT and value > numbers[tb.J_SLIGHT]:
            return
    for j in range(first, last):
        joints.numbers[j, tb.J_YIELDS] = 0.0


def energy_asked(
    n: int, first: int, rates: float, substep: float, bodies: Bodies, joints: Joints
) -> float:
    """Return the most energy, J, that the errors of a mechanism may give it.

    Those of its joints from a first one on are looked at, and squared rates of others, m^2/s^2.
    """
    mass = sprung = 0.0
    for node in range(joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]):
        mass += joints.factors[node, tb.NODE_MASS]
    for j in range(first, joints.mechanisms[n + 1, tb.M_JOINT]):
        ends, numbers = joints.joints[j], joints.numbers[j]
        for r in range(ends[tb.J_ROWS]):
            if numbers[tb.J_FIRMNESS + r] > 0.0:
                if ends[tb.J_LAW] == tb.SPRING:
                    impulse = numbers[tb.J_FIRMNESS + r] * numbers[tb.J_ERROR + r]
                    sprung += impulse * impulse * yield_of_row(r, ends, numbers, bodies, joints)
                else:
                    rate = numbers[tb.J_ARM + r] * numbers[tb.J_ERROR + r]
                    rates += rate * rate
    rates += slight_rates(first, n, substep, joints)
    return (AMPLIFIED * AMPLIFIED * mass * rates + sprung) / 2


def slight_rates(first: int, n: int, substep: float, joints: Joints) -> float:
    """Return the square of the least rate, m/s, that parts rows far enough to be told."""
    slight = inf
    for j in range(first, joints.mechanisms[n + 1, tb.M_JOINT]):
        numbers = joints.numbers[j]
        for r in range(joints.joints[j, tb.J_ROWS]):
            slight = min(slight, numbers[tb.J_SLIGHT + r] * numbers[tb.J_ARM + r])
    return (slight / substep) * (slight / substep)


@inlined
def gain_of_node(change: Array, column: int, node: Array) -> float:
    """Return the energy of a change of the velocities of a node, J."""
    by = (change[column], change[column + 1])
    return kinetic_energy(node[tb.NODE_MASS], by, node[tb.NODE_INERTIA], change[column + 2])


def energy_driven(n: int, seen_from: Array, substep: float, bodies: Bodies, joints: Joints) -> float:
    """Return the most energy, J, that what ties a mechanism may give it while its rows yield.

    It is seen from the reference of the row of its island.
    """
    base = (seen_from[tb.REFERENCE], seen_from[tb.REFERENCE + 1])
    mass, rates = 0.0, seen_from[tb.DRIVEN_RATE] * seen_from[tb.DRIVEN_RATE]
    first = joints.mechanisms[n, tb.M_JOINT]
    for node in range(joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]):
        mass += joints.factors[node, tb.NODE_MASS]
        hinged = joints.mechanisms[n, tb.M_HINGED] == 1 and joints.mechanisms[n, tb.M_MESHED] == 0
        if hinged and joints.members[node + 1, tb.JOINED_HINGE] >= 0:
            row, first = joints.hinges[node + 1], first + 1
            gap = max(abs(row[tb.H_GAP]), abs(row[tb.H_GAP + 1]))
            rates += (REMOVED_BY_JOINTS * gap / substep) * (REMOVED_BY_JOINTS * gap / substep)
    for j in range(first, joints.mechanisms[n + 1, tb.M_JOINT]):
        ends, numbers = joints.joints[j], joints.numbers[j]
        for r in range(ends[tb.J_ROWS] if ends[tb.J_LAW] < tb.MOTOR else 0):
            removed = REMOVED_BY_JOINTS * REMOVED_YIELDING / substep
            rate = removed * abs(numbers[tb.J_ROW + ROW * r])
            for end in range(tb.ENDS_OF_JOINT):
                if ends[tb.J_NODE + end] == tb.NOT_PUSHED:
                    at = tb.J_ROW + ROW * r + 1 + 3 * end
                    now = bodies.motion[joints.members[ends[tb.J_MEMBER + end], tb.JOINED_SLOT]]
                    seen = (now[tb.VX] - base[0], now[tb.VY] - base[1])
                    slope = (numbers[at], numbers[at + 1])
                    rate += abs(row_rate(slope, numbers[at + 2], seen, now[tb.SPIN]))
            rates += numbers[tb.J_ARM + r] * numbers[tb.J_ARM + r] * rate * rate
    rates += slight_rates(joints.mechanisms[n, tb.M_JOINT], n, substep, joints)
    return AMPLIFIED * AMPLIFIED * mass * rates / 2
