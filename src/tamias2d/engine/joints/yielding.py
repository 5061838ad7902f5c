"""Joints that cannot hold yield: damped least squares where no solution is near (DD86).

A chain that is pulled straight, or a mechanism in a dead centre, answers a small error with an
immense motion, which does not lead there. Where a solution gives more energy than is likely, the
rows of its mechanism are no firmer than makes it so, and stay apart by what they cannot remove,
until none is far apart.

Cost: for each solution of a mechanism with loops or limits, a visit to each of its nodes and rows.
Source: Levenberg (1944); Nakamura and Hanafusa (1986), for mechanisms.
"""

from math import inf

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.governed import is_limit
from tamias2d.engine.joints.hinge_tree import first_besides
from tamias2d.engine.joints.linearise import apart_by_law, yield_of_row
from tamias2d.engine.joints.opening import (
    closing_rate,
    fastest_drive,
    note_opened,
    rate_driven,
)
from tamias2d.engine.tables import Bodies, Control, Joints
from tamias2d.generated.definitions import kinetic_energy
from tamias2d.generated.joint_step import (
    change_most,
    firmness_most,
    row_impulse,
    spring_change,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array

AMPLIFICATION = 4.0  # of the rates that rows have too much: a lever of 1:4 is no dead centre
YIELDING = 1.0  # of them, by rows that yield: a mass is moved by half of what is asked for
NEAR_ENOUGH = 64.0  # times as far apart as is told: rows hold again, for they are to carry loads
REMOVED_BY_JOINTS = 0.2  # of the value of a row, in a substep of a whole step
REMOVED_YIELDING = 0.2  # of that, while rows yield: some tenths of a second, and no burst


def yields(n: int, joints: Joints) -> bool:
    """Return whether the rows of a mechanism yield."""
    return bool(joints.numbers[joints.mechanisms[n, tb.M_JOINT], tb.J_FIRMEST] > 0.0)


def may_yield(n: int, first: int, joints: Joints) -> bool:
    """Return whether some joint of a mechanism, from a first one on, holds, and is no spring."""
    for j in range(first, joints.mechanisms[n + 1, tb.M_JOINT]):
        if joints.joints[j, tb.J_LAW] != tb.SPRING and is_firm(j, joints):
            return True
    return False


@inlined
def is_firm(j: int, joints: Joints) -> bool:
    """Return whether a row of a joint is firm: one of a limit is not where that does not hold."""
    firm = 0.0
    for r in range(joints.joints[j, tb.J_ROWS]):
        firm = max(firm, joints.numbers[j, tb.J_FIRMNESS + r])
    return firm > 0.0


def let_yield(n: int, joints: Joints) -> None:
    """Let the rows of a mechanism yield from now on."""
    mass = mass_of_mechanism(n, joints)
    note_opened(joints.numbers[joints.mechanisms[n, tb.M_JOINT]])
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        numbers = joints.numbers[j]
        for k in range(3):
            numbers[tb.J_FIRMEST + k] = firmness_most(mass, numbers[tb.J_ARM + k], YIELDING)


def mass_of_mechanism(n: int, joints: Joints) -> float:
    """Return the mass of the bodies of a mechanism, kg."""
    mass = 0.0
    for node in range(joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]):
        mass += joints.factors[node, tb.NODE_MASS]
    return mass


def hold_again(n: int, joints: Joints) -> None:
    """Let the rows of a mechanism hold again if none is far apart."""
    first, last = joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]
    for j in range(first, last):
        for r in range(joints.joints[j, tb.J_ROWS]):
            apart = apart_by_law(r, joints.joints[j], joints.numbers[j])
            if apart > NEAR_ENOUGH * joints.numbers[j, tb.J_SLIGHT + r]:
                return
    for j in range(first, last):
        for k in range(3):
            joints.numbers[j, tb.J_FIRMEST + k] = 0.0


def energy_asked(n: int, first: int, rates: float, substep: float, joints: Joints) -> float:
    """Return the most energy, J, that the errors of a mechanism are likely to give it.

    Those of its joints from a first one on are looked at; the squares of others add up to so much,
    m^2/s^2. A limit that bounces may give any.
    """
    sprung = 0.0
    for j in range(first, joints.mechanisms[n + 1, tb.M_JOINT]):
        ends, numbers = joints.joints[j], joints.numbers[j]
        if is_limit(ends[tb.J_LAW]) and joints.laws[j, tb.LAW_RATE] != 0.0:
            return inf
        for r in range(ends[tb.J_ROWS]):
            firm, error = numbers[tb.J_FIRMNESS + r], numbers[tb.J_ERROR + r]
            if firm > 0.0 and ends[tb.J_LAW] >= tb.MOTOR:  # a motor may ask for any as it starts
                yielding = yield_of_row(r, ends, numbers, joints)
                sprung += spring_change(row_impulse(error, firm), yielding)
            elif firm > 0.0:
                rates += numbers[tb.J_ARM + r] * error * (numbers[tb.J_ARM + r] * error)
    rates += slight_rates(n, first, substep, joints)
    return change_most(mass_of_mechanism(n, joints), rates, sprung, AMPLIFICATION)


def slight_rates(n: int, first: int, substep: float, joints: Joints) -> float:
    """Return the square of the least rate, m/s, that parts a row by as much as is told.

    It grows as substeps shrink, and is no faster than what ties a mechanism that moves.
    """
    slight = inf
    for j in range(first, joints.mechanisms[n + 1, tb.M_JOINT]):
        numbers = joints.numbers[j]
        for r in range(joints.joints[j, tb.J_ROWS]):
            slight = min(slight, numbers[tb.J_SLIGHT + r] * numbers[tb.J_ARM + r])
    rate = min(slight / substep, fastest_drive(n, joints))
    return rate * rate


@inlined
def gain_of_node(change: Array, column: int, node: Array) -> float:
    """Return the energy of a change of the velocities of a node, J."""
    by = (change[column], change[column + 1])
    return kinetic_energy(node[tb.NODE_MASS], by, node[tb.NODE_INERTIA], change[column + 2])


def energy_driven(
    n: int, mass: float, seen: Array, control: Control, bodies: Bodies, joints: Joints
) -> float:
    """Return the most energy, J, that what ties a mechanism is likely to give it.

    The mass, kg, is that of all bodies that get it. They are seen from the reference motion that
    stands in the row of an island.
    """
    substep = control.settings[tb.TIME_STEP] / control.counts[tb.SUBSTEPS]  # of a whole step
    removed = REMOVED_BY_JOINTS * REMOVED_YIELDING / substep if yields(n, joints) else 0.0
    closing = closing_rate(n, joints)
    rates, first = seen[tb.DRIVEN_RATE] * seen[tb.DRIVEN_RATE], joints.mechanisms[n, tb.M_JOINT]
    if joints.mechanisms[n, tb.M_HINGED] == 1 and joints.mechanisms[n, tb.M_MESHED] == 0:
        first = first_besides(n, joints)
        for m in range(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1):
            row, hinged = joints.hinges[m], joints.members[m, tb.JOINED_HINGE] >= 0
            gap = max(abs(row[tb.H_GAP]), abs(row[tb.H_GAP + 1])) if hinged else 0.0
            rate = min(removed * gap, closing)
            rates += rate * rate
    base = (seen[tb.REFERENCE], seen[tb.REFERENCE + 1])
    for j in range(first, joints.mechanisms[n + 1, tb.M_JOINT]):
        ends, numbers = joints.joints[j], joints.numbers[j]
        for r in range(ends[tb.J_ROWS] if ends[tb.J_LAW] < tb.MOTOR else 0):
            arm = numbers[tb.J_ARM + r]
            rate = min(arm * removed * apart_by_law(r, ends, numbers), closing)
            rate += arm * rate_driven(j, r, base, bodies, joints)
            rates += rate * rate
    return change_most(mass, rates, 0.0, AMPLIFICATION)
