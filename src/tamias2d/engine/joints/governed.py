"""Limits that only push, and motors that give no more than they can (IM15).

Of each row it is chosen whether it holds; the mechanism is solved, and the choice looked at again.
Cost: for each choice that changes, a factorization. Source: an active set, as for contacts.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.impulse import apply_joint_impulse
from tamias2d.engine.tables import Bodies, Joints
from tamias2d.generated.joint_step import row_impulse_most, struck_rate, struck_share
from tamias2d.state import Array

HALF = 0.5  # of a substep: in the first one and after the last, where loads are kicks at both ends


def begin_rows(n: int, joints: Joints) -> None:
    """Let the limits of a mechanism be free as a part of a step begins, and its motors hold."""
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        law = joints.joints[j, tb.J_LAW]
        limits = (law == tb.LOWER_LIMIT) | (law == tb.UPPER_LIMIT)
        joints.joints[j, tb.J_STATE] = tb.FREE_ROW if limits else tb.HOLDS
        if limits:
            joints.numbers[j, tb.J_STRUCK] = joints.laws[j, tb.LAW_RATE] = 0.0


def begin_motors(n: int, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Let the motors of a mechanism that gave the most that they can do so again, to begin with."""
    if joints.mechanisms[n, tb.M_GOVERNED] == 0:
        return
    time = substep * share_of_loads(n, joints)
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        state = joints.joints[j, tb.J_STATE]
        if joints.joints[j, tb.J_LAW] == tb.MOTOR and state != tb.HOLDS:
            give_the_most(j, time, bodies, joints)


def end_motors(n: int, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Let the motors that give the most catch up as a part ends, as the other loads do."""
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        if joints.joints[j, tb.J_LAW] == tb.MOTOR:
            joints.numbers[j, tb.J_GIVEN] = 0.0
            if joints.joints[j, tb.J_STATE] != tb.HOLDS:
                give_the_most(j, HALF * substep, bodies, joints)


def give_the_most(j: int, time: float, bodies: Bodies, joints: Joints) -> None:
    """Let a motor give what it can at most in a time, s."""
    most = row_impulse_most(joints.laws[j, tb.LAW_MOST], time)
    forwards = joints.joints[j, tb.J_STATE] == tb.AT_MOST
    apply_joint_impulse(j, 0, most if forwards else -most, bodies, joints)


def share_of_loads(n: int, joints: Joints) -> float:
    """Return for which share of a substep loads act on a mechanism as it begins."""
    return HALF if joints.mechanisms[n, tb.M_HALF] == 1 else 1.0


def choose_rows(n: int, substep: float, bodies: Bodies, joints: Joints) -> bool:
    """Choose which limits and motors of a mechanism hold; return whether that changes any.

    Values and errors of the rows are those to which the substep leads.
    """
    changed = False
    time = substep * share_of_loads(n, joints)
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        law = joints.joints[j, tb.J_LAW]
        if law == tb.LOWER_LIMIT:
            changed = choose_limit(j, 1.0, bodies, joints) or changed
        elif law == tb.UPPER_LIMIT:
            changed = choose_limit(j, -1.0, bodies, joints) or changed
        elif law == tb.MOTOR:
            changed = choose_motor(j, time, bodies, joints) or changed
    return changed


def let_go_of_rows(n: int, substep: float, bodies: Bodies, joints: Joints) -> bool:
    """Let go of limits that pull, and of motors that give too much, as velocities fit their rows.

    Return whether there are any. Where nothing touches the mechanism motors have half a substep, s,
    left, and else what is left of the last one.
    """
    alone, changed = joints.mechanisms[n, tb.M_STATUS] != tb.IN_CONTACT, False
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        law = joints.joints[j, tb.J_LAW]
        if joints.joints[j, tb.J_STATE] != tb.HOLDS:
            continue
        if law == tb.MOTOR:
            time = HALF * substep if alone else substep
            changed = choose_motor(j, time, bodies, joints) or changed
        elif law == tb.LOWER_LIMIT:
            changed = choose_limit(j, 1.0, bodies, joints) or changed
        elif law == tb.UPPER_LIMIT:
            changed = choose_limit(j, -1.0, bodies, joints) or changed
    return changed


def choose_limit(j: int, sign: float, bodies: Bodies, joints: Joints) -> bool:
    """Let go of a limit that pulls, or hold one that would be passed; return whether it changes."""
    ends, numbers = joints.joints[j], joints.numbers[j]
    if ends[tb.J_STATE] != tb.HOLDS:
        passed = sign * numbers[tb.J_ROW] < sign * numbers[tb.J_AIM]
        ends[tb.J_STATE] = tb.HOLDS if passed else tb.FREE_ROW
        if passed and numbers[tb.J_STRUCK] == 0.0:
            note_struck(sign, numbers)
        return bool(passed)
    pulls = sign * numbers[tb.J_GIVEN] < 0.0
    if pulls:
        apply_joint_impulse(j, 0, -numbers[tb.J_GIVEN], bodies, joints)
        ends[tb.J_STATE] = tb.FREE_ROW
    return bool(pulls)


def note_struck(sign: float, numbers: Array) -> None:
    """Note at which rate a limit is struck for the first time in a part: its row without it."""
    before, after = numbers[tb.J_RATE_START], numbers[tb.J_RESIDUAL]
    free = sign * numbers[tb.J_VALUE_START] > 0.0
    share = struck_share(numbers[tb.J_VALUE_START], numbers[tb.J_ROW]) if free else 0.0
    numbers[tb.J_STRUCK] = struck_rate(before, share, after)


def choose_motor(j: int, time: float, bodies: Bodies, joints: Joints) -> bool:
    """Let a motor give the most that it can in a time, s, or less if that is too much.

    Return whether it changes.
    """
    ends, numbers = joints.joints[j], joints.numbers[j]
    given, most = numbers[tb.J_GIVEN], row_impulse_most(joints.laws[j, tb.LAW_MOST], time)
    if ends[tb.J_STATE] == tb.HOLDS:
        if abs(given) <= most:
            return False
        forwards = given > 0.0
        apply_joint_impulse(j, 0, (most if forwards else -most) - given, bodies, joints)
        ends[tb.J_STATE] = tb.AT_MOST if forwards else tb.AT_LEAST
        return True
    sign = 1.0 if ends[tb.J_STATE] == tb.AT_MOST else -1.0
    if sign * numbers[tb.J_ERROR] <= 0.0:
        return False
    ends[tb.J_STATE] = tb.HOLDS
    return True
