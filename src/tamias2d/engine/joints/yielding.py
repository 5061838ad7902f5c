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

AMPLIFIED = 4.0  # times the rate that its rows have too much: the fastest that all may get


def yields(n: int, joints: Joints) -> bool:
    """Return whether the rows of a mechanism yield."""
    return bool(joints.numbers[joints.mechanisms[n, tb.M_JOINT], tb.J_YIELDS] > 0.0)


def let_yield(n: int, joints: Joints) -> None:
    """Let the rows of a mechanism yield."""
    whole = least = 0.0
    least = inf
    for node in range(joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]):
        whole += joints.factors[node, tb.NODE_MASS]
        least = min(least, joints.factors[node, tb.NODE_MASS])
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        joints.numbers[j, tb.J_YIELDS] = AMPLIFIED * AMPLIFIED * whole / least


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


def energy_to_ask(
    first: int, last: int, mass: float, rates: float, substep: float, bodies: Bodies, joints: Joints
) -> float:
    """Return the most energy, J, that a solution may give."""
    slight, sprung = inf, 0.0
    for j in range(first, last):
        ends, numbers = joints.joints[j], joints.numbers[j]
        for r in range(ends[tb.J_ROWS]):
            slight = min(slight, numbers[tb.J_SLIGHT + r] * numbers[tb.J_ARM + r])
            if numbers[tb.J_FIRMNESS + r] > 0.0:
                if ends[tb.J_LAW] == tb.SPRING:
                    impulse = numbers[tb.J_FIRMNESS + r] * numbers[tb.J_ERROR + r]
                    sprung += impulse * impulse * yield_of_row(r, ends, numbers, bodies, joints)
                else:
                    rate = numbers[tb.J_ARM + r] * numbers[tb.J_ERROR + r]
                    rates += rate * rate
    slight /= substep
    return AMPLIFIED * AMPLIFIED * (mass * (rates + slight * slight) + sprung) / 2


def mass_and_gain(first: int, last: int, column: int, of: object, joints: Joints) -> tuple[float, float]:
    """Return the mass of some nodes, kg, and the energy of what a solution changes, J."""
    mass = energy = 0.0
    for node in range(first, last):
        f, row, at = joints.factors[node], of, column
        mass += f[tb.NODE_MASS]
        energy += kinetic_energy(f[tb.NODE_MASS], (row[node, at], row[node, at + 1]), f[tb.NODE_INERTIA], row[node, at + 2])
    return mass, energy


def throws_rows(n: int, substep: float, bodies: Bodies, joints: Joints) -> bool:
    """Return whether the last solution of a mechanism throws it, which is found directly."""
    mass, gain = mass_and_gain(joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE], tb.CHANGE, joints.factors, joints)
    most = energy_to_ask(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT], mass, 0.0, substep, bodies, joints)
    return not gain <= most


def throws_tree(n: int, besides: int, substep: float, bodies: Bodies, joints: Joints) -> bool:
    """Return whether the last solution of a tree throws it."""
    first, last = joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]
    mass, gain = mass_and_gain(first, last, tb.H_CHANGE, joints.hinges[1:], joints)
    rates = 0.0
    for m in range(first + 1, last + 1):
        row = joints.hinges[m]
        if joints.members[m, tb.JOINED_HINGE] >= 0:
            rates += row[tb.H_ERROR] * row[tb.H_ERROR] + row[tb.H_ERROR + 1] * row[tb.H_ERROR + 1]
    most = energy_to_ask(besides, joints.mechanisms[n + 1, tb.M_JOINT], mass, rates, substep, bodies, joints)
    return not gain <= most
