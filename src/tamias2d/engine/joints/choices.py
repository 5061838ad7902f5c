"""Positions of mechanisms with limits and motors: first which of these hold, then where to (IM15).

Springs that have a maximum are as soft as that asks for.

A limit that is tried in vain, or a motor that would have to give more than it can, leads to places
that mean nothing. So rows are chosen as if their slopes did not change, and bodies are placed by
what was chosen.

Cost: for each choice that changes, a visit to each row, a factorization and a solution.
Source: block principal pivoting, Judice and Pires (1994); one by one, a primal active set.
"""

from math import inf

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.bounded_springs import (
    begin_bounded,
    bound_springs,
    soften_springs,
)
from tamias2d.engine.joints.governed import (
    change_row,
    choose_rows,
    hold_rows,
    let_go_of_rows,
    nearest_bound,
    time_of_loads,
)
from tamias2d.engine.joints.linearise import factor_mechanism
from tamias2d.engine.joints.solve import (
    bring_to_aims,
    energy_asked_of_rows,
    error_of_row,
    find_position_errors,
    rate_of_row,
    solve_joint_errors,
    start_impulses,
    take_impulses_back,
)
from tamias2d.engine.tables import Bodies, Joints
from tamias2d.generated.joint_rows import ROW
from tamias2d.generated.joint_step import row_value_ahead

MOST_CHOICES = 4  # of the limits that hold and of the motors that give the most, by places
MOST_TRIALS = 8  # of the same, by slopes, all at once
MOST_STEPS = 256  # of the same, one by one


def keep_positions(n: int, again: bool, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Change the velocities of a mechanism so that a substep, s, leads to what its rows aim at.

    Again, they have changed little. Limits push only, and motors give no more than they can.
    """
    if joints.mechanisms[n, tb.M_CHOOSING] == 1:
        begin_bounded(n, again, bodies, joints)
    if joints.mechanisms[n, tb.M_GOVERNED] == 1 and not again:
        factor_mechanism(n, substep, joints)
    meshed = joints.mechanisms[n, tb.M_MESHED] == 1
    if meshed or joints.mechanisms[n, tb.M_CHOOSING] == 0:
        bring_to_aims(n, again, 0.0, substep, bodies, joints)
    if joints.mechanisms[n, tb.M_CHOOSING] == 0:
        return
    time = time_of_loads(n, substep, joints)
    if not again:
        begin_offsets(n, joints)
    for k in range(MOST_CHOICES):
        if k > 0 or not meshed:
            first = choose_by_slopes(n, substep, bodies, joints)
            bring_to_aims(n, True, first, substep, bodies, joints)
        find_position_errors(n, substep, bodies, joints)
        note_offsets(n, substep, bodies, joints)
        if k + 1 < MOST_CHOICES:
            softened = soften_springs(n, substep, joints)
            if choose_rows(n, time, bodies, joints)[0] or softened:
                factor_mechanism(n, substep, joints)
                continue
        bound_springs(n, substep, bodies, joints)
        return


def choose_by_slopes(n: int, substep: float, bodies: Bodies, joints: Joints) -> float:
    """Choose which rows of a mechanism hold as if their slopes did not change in a substep, s.

    All that are to change do at once, a few times; then they do one by one. Return a measure of
    their errors at first, J.
    """
    first, time = predict(n, substep, bodies, joints), time_of_loads(n, substep, joints)
    most = energy_asked_of_rows(n, substep, joints)
    for _ in range(MOST_TRIALS):
        start_impulses(n, 0.0, joints)
        solve_joint_errors(n, substep, most, bodies, joints)
        predict(n, substep, bodies, joints)
        softened = soften_springs(n, substep, joints)
        changed, torn = choose_rows(n, time, bodies, joints)
        if not changed and not softened:
            return first
        factor_mechanism(n, substep, joints)
        predict(n, substep, bodies, joints)
        most = inf if torn else energy_asked_of_rows(n, substep, joints)
    choose_one_by_one(n, substep, bodies, joints)
    return first


def choose_one_by_one(n: int, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Choose the same, by solutions that end where a row has given what it can."""
    time = time_of_loads(n, substep, joints)
    let_go_of_rows(n, time, bodies, joints)
    for _ in range(MOST_STEPS):
        factor_mechanism(n, substep, joints)
        predict(n, substep, bodies, joints)
        start_impulses(n, 0.0, joints)
        solve_joint_errors(n, substep, inf, bodies, joints)
        share, which = nearest_bound(n, time, joints)
        if which >= 0:
            take_impulses_back(n, 1.0 - share, bodies, joints)
            change_row(n, which, time, bodies, joints)
        else:
            predict(n, substep, bodies, joints)
            if not hold_rows(n, time, bodies, joints):
                return


def begin_offsets(n: int, joints: Joints) -> None:
    """Note that without their rates the rows of a mechanism, just written, stay where they are."""
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        begin_offsets_of_joint(j, joints)


def begin_offsets_of_joint(j: int, joints: Joints) -> None:
    """Note the values of the rows of a joint where bodies are."""
    numbers = joints.numbers[j]
    for r in range(joints.joints[j, tb.J_ROWS]):
        numbers[tb.J_OFFSET + r] = numbers[tb.J_ROW + ROW * r]


def note_offsets(n: int, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Note where a substep leads the rows of a mechanism, whose values were just written."""
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        note_offsets_of_joint(j, substep, bodies, joints)


def note_offsets_of_joint(j: int, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Note where a substep, s, would lead the rows of a joint without their rates, and these."""
    numbers = joints.numbers[j]
    for r in range(joints.joints[j, tb.J_ROWS]):
        rate = rate_of_row(j, r, bodies, joints)
        numbers[tb.J_RESIDUAL + r] = rate
        numbers[tb.J_OFFSET + r] = row_value_ahead(numbers[tb.J_ROW + ROW * r], rate, -substep)


def predict(n: int, substep: float, bodies: Bodies, joints: Joints) -> float:
    """Write the errors of the rows of a mechanism, whose slopes do not change in a substep, s.

    Return a measure of them, J.
    """
    size = 0.0
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        predict_joint(j, substep, bodies, joints)
        numbers = joints.numbers[j]
        for r in range(joints.joints[j, tb.J_ROWS]):
            error = numbers[tb.J_ERROR + r]
            size += numbers[tb.J_FIRMNESS + r] * error * error
    return size


def predict_joint(j: int, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Write the values to which a substep, s, leads the rows of a joint, their rates and errors."""
    numbers = joints.numbers[j]
    for r in range(joints.joints[j, tb.J_ROWS]):
        rate = rate_of_row(j, r, bodies, joints)
        numbers[tb.J_RESIDUAL + r] = rate
        numbers[tb.J_ROW + ROW * r] = row_value_ahead(numbers[tb.J_OFFSET + r], rate, substep)
        numbers[tb.J_ERROR + r] = error_of_row(j, r, substep, bodies, joints)
