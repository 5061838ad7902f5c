"""Positions of a tree of hinges with limits and motors: as of other mechanisms (IM15).

Cost: for each choice that changes, two visits more to each body, and a solution.
"""

from math import inf

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.bounded_springs import (
    begin_bounded,
    bound_springs,
    soften_springs,
)
from tamias2d.engine.joints.choices import (
    MOST_CHOICES,
    MOST_STEPS,
    MOST_TRIALS,
    begin_offsets_of_joint,
    note_offsets_of_joint,
    predict_joint,
)
from tamias2d.engine.joints.governed import (
    change_row,
    choose_rows,
    hold_rows,
    let_go_of_rows,
    nearest_bound,
    time_of_loads,
)
from tamias2d.engine.joints.hinge_solve import (
    answer_tree,
    begin_errors,
    bring_tree_to_aims,
    energy_asked_of_tree,
    find_gap_errors,
    firm_errors,
    rates_of_hinge,
    solve_hinges,
    take_solution_back,
)
from tamias2d.engine.joints.hinge_tree import first_besides, hang_tree
from tamias2d.engine.tables import Bodies, Joints
from tamias2d.generated.joint_step import row_error, row_value_ahead


def keep_tree_positions(
    n: int, again: bool, substep: float, bodies: Bodies, joints: Joints
) -> None:
    """Change the velocities of a tree so that a substep, s, leads to what its rows aim at.

    Again, they have changed little. Limits push only, and motors give no more than they can.
    """
    if joints.mechanisms[n, tb.M_CHOOSING] == 1:
        begin_bounded(n, again, bodies, joints)
    if joints.mechanisms[n, tb.M_GOVERNED] == 1 and not again:
        hang_tree(n, substep, joints)
    if joints.mechanisms[n, tb.M_CHOOSING] == 0:
        bring_tree_to_aims(n, 0.0, substep, bodies, joints)
        return
    time = time_of_loads(n, substep, joints)
    if not again:
        begin_offsets_of_tree(n, joints)
    for k in range(MOST_CHOICES):
        first = choose_by_slopes_of_tree(n, substep, bodies, joints)
        bring_tree_to_aims(n, first, substep, bodies, joints)
        find_gap_errors(n, substep, bodies, joints)
        note_offsets_of_tree(n, substep, bodies, joints)
        if k + 1 < MOST_CHOICES:
            softened = soften_springs(n, substep, joints)
            if choose_rows(n, time, bodies, joints)[0] or softened:
                hang_tree(n, substep, joints)
                continue
        bound_springs(n, substep, bodies, joints)
        return


def choose_by_slopes_of_tree(n: int, substep: float, bodies: Bodies, joints: Joints) -> float:
    """Choose which rows of a tree hold as if its arms did not turn, as `choose_by_slopes`.

    Return the sum of the squares of their errors at first, m^2/s^2.
    """
    first, time = predict_tree(n, substep, bodies, joints), time_of_loads(n, substep, joints)
    most = energy_asked_of_tree(n, substep, joints)
    for _ in range(MOST_TRIALS):
        answer_tree(n, substep, most, bodies, joints)
        predict_tree(n, substep, bodies, joints)
        softened = soften_springs(n, substep, joints)
        changed, torn = choose_rows(n, time, bodies, joints)
        if not changed and not softened:
            return first
        hang_tree(n, substep, joints)
        predict_tree(n, substep, bodies, joints)
        most = inf if torn else energy_asked_of_tree(n, substep, joints)
    choose_one_by_one_of_tree(n, substep, bodies, joints)
    return first


def choose_one_by_one_of_tree(n: int, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Choose the same as `choose_one_by_one`."""
    time = time_of_loads(n, substep, joints)
    let_go_of_rows(n, time, bodies, joints)
    for _ in range(MOST_STEPS):
        hang_tree(n, substep, joints)
        predict_tree(n, substep, bodies, joints)
        solve_hinges(n, bodies, joints)
        share, which = nearest_bound(n, time, joints)
        if which >= 0:
            take_solution_back(n, 1.0 - share, bodies, joints)
            change_row(n, which, time, bodies, joints)
        else:
            predict_tree(n, substep, bodies, joints)
            if not hold_rows(n, time, bodies, joints):
                return


def begin_offsets_of_tree(n: int, joints: Joints) -> None:
    """Note that without their rates the rows of a tree, just written, stay where they are."""
    for m in range(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1):
        row = joints.hinges[m]
        row[tb.H_OFFSET], row[tb.H_OFFSET + 1] = row[tb.H_GAP], row[tb.H_GAP + 1]
    for j in range(first_besides(n, joints), joints.mechanisms[n + 1, tb.M_JOINT]):
        begin_offsets_of_joint(j, joints)


def note_offsets_of_tree(n: int, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Note where a substep leads the rows of a tree, whose errors were just written."""
    for m in range(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1):
        row = joints.hinges[m]
        rate_x, rate_y = rates_of_hinge(m, bodies, joints)
        gap_x = row_value_ahead(row[tb.H_AIM], row[tb.H_ERROR], substep)
        gap_y = row_value_ahead(row[tb.H_AIM + 1], row[tb.H_ERROR + 1], substep)
        row[tb.H_OFFSET] = row_value_ahead(gap_x, rate_x, -substep)
        row[tb.H_OFFSET + 1] = row_value_ahead(gap_y, rate_y, -substep)
    for j in range(first_besides(n, joints), joints.mechanisms[n + 1, tb.M_JOINT]):
        note_offsets_of_joint(j, substep, bodies, joints)


def predict_tree(n: int, substep: float, bodies: Bodies, joints: Joints) -> float:
    """Write the errors of the rows of a tree, whose arms do not turn in a substep, s.

    Return the sum of the squares of those that are firm, m^2/s^2.
    """
    first, last = joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1
    size = 0.0
    if joints.members[first, tb.JOINED_HINGE] < 0:
        begin_errors(joints.hinges[first], 0.0, 0.0)
        first += 1
    for m in range(first, last):
        row = joints.hinges[m]
        rate_x, rate_y = rates_of_hinge(m, bodies, joints)
        gap_x = row_value_ahead(row[tb.H_OFFSET], rate_x, substep)
        gap_y = row_value_ahead(row[tb.H_OFFSET + 1], rate_y, substep)
        error_x = row_error(gap_x, row[tb.H_AIM], substep)
        error_y = row_error(gap_y, row[tb.H_AIM + 1], substep)
        begin_errors(row, error_x, error_y)
        size += error_x * error_x + error_y * error_y
    for j in range(first_besides(n, joints), joints.mechanisms[n + 1, tb.M_JOINT]):
        predict_joint(j, substep, bodies, joints)
        size += firm_errors(j, joints)
    return size
