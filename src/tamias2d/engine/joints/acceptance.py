"""Which solutions are accepted: near a singular pose places ask for any motion (DD98).

Where links that are held at both ends come straight, or a mechanism comes to a dead centre, the
small ways by which arms turn in a substep can be made up for by an immense motion only. What a
solution gives is then taken back, and velocities fit rows first, which gives no energy.

Cost: for each solution of a mechanism that may yield, a visit to each of its nodes.
"""

from math import inf

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.hinge_tree import first_besides
from tamias2d.engine.joints.linearise import apart_by_law
from tamias2d.engine.joints.yielding import (
    REMOVED_BY_JOINTS,
    gain_of_node,
    mass_of_mechanism,
)
from tamias2d.engine.tables import Bodies, Joints
from tamias2d.generated.joint_step import motion_most

GROWTH = 1.25  # of the energy of motion by one solution: what turns far in a substep gains some
TURNED_IN_VAIN = 0.25  # rad^2, of a body in a substep times that by impulses: rows mean nothing


def note_most_motion(n: int, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Note to how much motion a solution of a mechanism may lead in a substep, s, J."""
    whole = joints.numbers[joints.mechanisms[n, tb.M_JOINT]]
    whole[tb.J_MOST] = inf
    if may_be_rejected(n, joints):
        motion, mass = motion_of_mechanism(n, bodies, joints), mass_of_mechanism(n, joints)
        rates = rates_closing(n, REMOVED_BY_JOINTS / substep, joints)
        whole[tb.J_MOST] = motion_most(motion, mass, rates, whole[tb.J_ENERGY], GROWTH)


def may_be_rejected(n: int, joints: Joints) -> bool:
    """Return whether contacts touch a mechanism that may yield, and nothing gives it any energy.

    One that was driven apart closes as it yields.
    """
    own = joints.mechanisms[n]
    driven = own[tb.M_CARRIED] + own[tb.M_TIMED] + own[tb.M_TURNED_BY_MOTOR] > 0
    whole = joints.numbers[own[tb.M_JOINT]]
    pulled = whole[tb.J_PULLED] + whole[tb.J_OPENED] > 0.0
    if driven or pulled or own[tb.M_MESHED] == 1 or own[tb.M_TOUCHED] == 0:
        return False
    for j in range(first_besides_tree(n, joints), joints.mechanisms[n + 1, tb.M_JOINT]):
        if joints.joints[j, tb.J_LAW] != tb.SPRING:
            return True
    return False


def first_besides_tree(n: int, joints: Joints) -> int:
    """Return the first joint of a mechanism whose rows may yield: no hinge of a tree does."""
    hinged = joints.mechanisms[n, tb.M_HINGED] == 1
    return first_besides(n, joints) if hinged else int(joints.mechanisms[n, tb.M_JOINT])


def rates_closing(n: int, removed: float, joints: Joints) -> float:
    """Return the squares, m^2/s^2, of the rates at which rows close, by such a share a second.

    One that is apart by less than is told counts as that far apart.
    """
    rates, slight = 0.0, inf
    if joints.mechanisms[n, tb.M_HINGED] == 1:
        for m in range(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1):
            row, hinged = joints.hinges[m], joints.members[m, tb.JOINED_HINGE] >= 0
            gap = row[tb.H_GAP] * row[tb.H_GAP] + row[tb.H_GAP + 1] * row[tb.H_GAP + 1]
            rates += removed * removed * gap if hinged else 0.0
    for j in range(first_besides_tree(n, joints), joints.mechanisms[n + 1, tb.M_JOINT]):
        ends, numbers = joints.joints[j], joints.numbers[j]
        for r in range(ends[tb.J_ROWS] if ends[tb.J_LAW] < tb.MOTOR else 0):
            arm = numbers[tb.J_ARM + r]
            rate = removed * arm * apart_by_law(r, ends, numbers)
            rates += rate * rate
            slight = min(slight, removed * arm * numbers[tb.J_SLIGHT + r])
    return rates + slight * slight if slight < inf else rates


def motion_of_mechanism(n: int, bodies: Bodies, joints: Joints) -> float:
    """Return the kinetic energy of a mechanism, J, by the inertias that it has in its joints."""
    energy = 0.0
    for node in range(joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]):
        now = bodies.motion[joints.sparse[node, tb.N_BODY]]
        energy += gain_of_node(now, tb.VX, joints.factors[node])
    return energy


def is_rejected(n: int, turned: float, bodies: Bodies, joints: Joints) -> bool:
    """Return whether the last solution of a mechanism has led to more motion than is likely.

    It has turned a body, and by impulses, by such a product of angles, rad^2, at most.
    """
    most = joints.numbers[joints.mechanisms[n, tb.M_JOINT], tb.J_MOST]
    if most == inf:
        return False
    return turned > TURNED_IN_VAIN or not motion_of_mechanism(n, bodies, joints) <= most
