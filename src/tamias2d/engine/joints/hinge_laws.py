"""Positions of a tree of hinges with limits and motors: as of other mechanisms (IM15).

Cost: for each choice that changes, a visit more to each body, and a solution.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.governed import choose_rows
from tamias2d.engine.joints.hinge_solve import (
    answer_tree,
    begin_errors,
    bring_tree_to_aims,
    energy_asked_of_tree,
    find_gap_errors,
    rates_of_hinge,
)
from tamias2d.engine.joints.hinge_tree import first_besides, hang_tree
from tamias2d.engine.joints.solve import MOST_CHOICES, rate_of_row
from tamias2d.engine.tables import Bodies, Joints


def keep_tree_positions(
    n: int, again: bool, substep: float, bodies: Bodies, joints: Joints
) -> None:
    """Change the velocities of a tree so that a substep, s, leads to what its rows aim at.

    Again, they have changed little. Limits push only, and motors give no more than they can.
    """
    governed = joints.mechanisms[n, tb.M_GOVERNED] == 1
    if governed and not again:
        hang_tree(n, substep, bodies, joints)
    bring_tree_to_aims(n, substep, bodies, joints)
    for _ in range(MOST_CHOICES if joints.mechanisms[n, tb.M_CHOOSING] == 1 else 0):
        find_gap_errors(n, substep, bodies, joints)
        note_tree_rates(n, bodies, joints)
        if not choose_rows(n, substep, bodies, joints):
            return
        hang_tree(n, substep, bodies, joints)
        return_tree_to_rates(n, substep, bodies, joints)
        bring_tree_to_aims(n, substep, bodies, joints)


def note_tree_rates(n: int, bodies: Bodies, joints: Joints) -> None:
    """Note the rates of all rows of a tree."""
    for m in range(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1):
        row = joints.hinges[m]
        row[tb.H_NOTED], row[tb.H_NOTED + 1] = rates_of_hinge(m, bodies, joints)
    for j in range(first_besides(n, joints), joints.mechanisms[n + 1, tb.M_JOINT]):
        for r in range(joints.joints[j, tb.J_ROWS]):
            joints.numbers[j, tb.J_RESIDUAL + r] = rate_of_row(j, r, bodies, joints)


def return_tree_to_rates(n: int, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Let the rows of a tree that hold have the rates again that were noted."""
    for m in range(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1):
        row = joints.hinges[m]
        rate_x, rate_y = rates_of_hinge(m, bodies, joints)
        begin_errors(row, rate_x - row[tb.H_NOTED], rate_y - row[tb.H_NOTED + 1])
    for j in range(first_besides(n, joints), joints.mechanisms[n + 1, tb.M_JOINT]):
        for r in range(joints.joints[j, tb.J_ROWS]):
            rate = rate_of_row(j, r, bodies, joints)
            joints.numbers[j, tb.J_ERROR + r] = rate - joints.numbers[j, tb.J_RESIDUAL + r]
    answer_tree(n, substep, energy_asked_of_tree(n, substep, bodies, joints), bodies, joints)
