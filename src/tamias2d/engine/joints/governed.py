"""Limits that only push, and motors that give no more than they can (IM15).

Of each row it is chosen whether it holds; the mechanism is solved, and the choice looked at again.
Cost: for each choice that changes, a factorization. Source: an active set, as for contacts.
"""

from tamias2d.engine.joints.impulse import apply_joint_impulse
from tamias2d.engine.tables import (
    AT_LEAST,
    AT_MOST,
    FREE_ROW,
    HOLDS,
    J_AIM,
    J_ERROR,
    J_GIVEN,
    J_LAW,
    J_ROW,
    J_STATE,
    LAW_MOST,
    LOWER_LIMIT,
    M_GOVERNED,
    M_JOINT,
    MOTOR,
    UPPER_LIMIT,
    Bodies,
    Joints,
)
from tamias2d.generated.joint_step import row_impulse_most


def begin_rows(n: int, joints: Joints) -> None:
    """Let the limits of a mechanism be free as a part of a step begins, and its motors hold."""
    for j in range(joints.mechanisms[n, M_JOINT], joints.mechanisms[n + 1, M_JOINT]):
        law = joints.joints[j, J_LAW]
        limits = (law == LOWER_LIMIT) | (law == UPPER_LIMIT)
        joints.joints[j, J_STATE] = FREE_ROW if limits else HOLDS


def begin_motors(n: int, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Let the motors of a mechanism that gave the most that they can do so again, to begin with."""
    if joints.mechanisms[n, M_GOVERNED] == 0:
        return
    for j in range(joints.mechanisms[n, M_JOINT], joints.mechanisms[n + 1, M_JOINT]):
        state = joints.joints[j, J_STATE]
        if joints.joints[j, J_LAW] == MOTOR and state != HOLDS:
            most = row_impulse_most(joints.laws[j, LAW_MOST], substep)
            apply_joint_impulse(j, 0, most if state == AT_MOST else -most, bodies, joints)


def choose_rows(n: int, substep: float, bodies: Bodies, joints: Joints) -> bool:
    """Choose which limits and motors of a mechanism hold; return whether that changes any.

    Values and errors of the rows are those to which the substep leads.
    """
    changed = False
    for j in range(joints.mechanisms[n, M_JOINT], joints.mechanisms[n + 1, M_JOINT]):
        law = joints.joints[j, J_LAW]
        if law == LOWER_LIMIT:
            changed = choose_limit(j, 1.0, bodies, joints) or changed
        elif law == UPPER_LIMIT:
            changed = choose_limit(j, -1.0, bodies, joints) or changed
        elif law == MOTOR:
            changed = choose_motor(j, substep, bodies, joints) or changed
    return changed


def choose_limit(j: int, sign: float, bodies: Bodies, joints: Joints) -> bool:
    """Let go of a limit that pulls, or hold one that would be passed; return whether it changes."""
    ends, numbers = joints.joints[j], joints.numbers[j]
    if ends[J_STATE] != HOLDS:
        passed = sign * numbers[J_ROW] < sign * numbers[J_AIM]
        ends[J_STATE] = HOLDS if passed else FREE_ROW
        return bool(passed)
    pulls = sign * numbers[J_GIVEN] < 0.0
    if pulls:
        apply_joint_impulse(j, 0, -numbers[J_GIVEN], bodies, joints)
        ends[J_STATE] = FREE_ROW
    return bool(pulls)


def choose_motor(j: int, substep: float, bodies: Bodies, joints: Joints) -> bool:
    """Let a motor give the most that it can, or less where that is too much; return likewise."""
    ends, numbers = joints.joints[j], joints.numbers[j]
    given, most = numbers[J_GIVEN], row_impulse_most(joints.laws[j, LAW_MOST], substep)
    if ends[J_STATE] == HOLDS:
        if abs(given) <= most:
            return False
        forwards = given > 0.0
        apply_joint_impulse(j, 0, (most if forwards else -most) - given, bodies, joints)
        ends[J_STATE] = AT_MOST if forwards else AT_LEAST
        return True
    sign = 1.0 if ends[J_STATE] == AT_MOST else -1.0
    if sign * numbers[J_ERROR] <= 0.0:
        return False
    ends[J_STATE] = HOLDS
    return True
