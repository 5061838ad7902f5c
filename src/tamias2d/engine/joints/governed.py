"""Limits that only push, and motors that give no more than they can (IM15).

Of each row it is chosen whether it holds; the mechanism is solved, and the choice looked at again.
Cost: for each choice that changes, a factorization. Source: an active set, as for contacts.
"""

from math import inf

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.impulse import apply_joint_impulse
from tamias2d.engine.joints.placement import UNTIL_BACK
from tamias2d.engine.tables import Bodies, Integers, Joints
from tamias2d.generated.joint_step import row_impulse_most, struck_rate, struck_share
from tamias2d.kernels.assembled import inlined

HALF = 0.5  # of a substep: in the first one and after the last, where loads are kicks at both ends


def is_limit(law: int) -> bool:
    """Return whether a row with such a law limits a value."""
    return law == tb.LOWER_LIMIT or law == tb.UPPER_LIMIT


def begin_rows(n: int, joints: Joints) -> None:
    """Let the limits of a mechanism be free as a part of a step begins, and its motors hold."""
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        law = joints.joints[j, tb.J_LAW]
        limits = is_limit(law)
        joints.joints[j, tb.J_STATE] = tb.FREE_ROW if limits else tb.HOLDS
        if limits:
            joints.numbers[j, tb.J_STRUCK] = joints.laws[j, tb.LAW_RATE] = 0.0


def begin_motors(n: int, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Let the motors of a mechanism that gave the most that they can do so again, to begin with."""
    if joints.mechanisms[n, tb.M_GOVERNED] == 0:
        return
    time = time_of_loads(n, substep, joints)
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        if gives_the_most(joints.joints[j]):
            give_the_most(j, time, bodies, joints)


def end_motors(n: int, substep: float, bodies: Bodies, joints: Joints) -> None:
    """Let the motors that give the most catch up as a part ends, as the other loads do."""
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        if joints.joints[j, tb.J_LAW] == tb.MOTOR:
            joints.numbers[j, tb.J_GIVEN] = 0.0
            if gives_the_most(joints.joints[j]):
                give_the_most(j, HALF * substep, bodies, joints)


@inlined
def gives_the_most(ends: Integers) -> bool:
    """Return whether a row is that of a motor which gives what it can."""
    return bool((ends[tb.J_LAW] == tb.MOTOR) & (ends[tb.J_STATE] > tb.FREE_ROW))


def give_the_most(j: int, time: float, bodies: Bodies, joints: Joints) -> None:
    """Let a motor give what it can at most in a time, s."""
    most = row_impulse_most(joints.laws[j, tb.LAW_MOST], time)
    forwards = joints.joints[j, tb.J_STATE] == tb.AT_MOST
    apply_joint_impulse(j, 0, most if forwards else -most, bodies, joints)


def time_of_loads(n: int, substep: float, joints: Joints) -> float:
    """Return for how long loads act on a mechanism as a substep, s, begins, s."""
    return substep * (HALF if joints.mechanisms[n, tb.M_HALF] == 1 else 1.0)


def choose_rows(n: int, time: float, bodies: Bodies, joints: Joints) -> tuple[bool, bool]:
    """Choose which limits hold, and which motors, in a time, s.

    Return whether that changes any, and whether one was let go: what it gave tears the others then.
    Values and errors of the rows are those to which the substep leads.
    """
    changed = torn = False
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        if is_to_change(n, j, time, joints):
            torn = torn or joints.joints[j, tb.J_STATE] == tb.HOLDS
            change_row(n, j, time, bodies, joints)
            changed = True
    return changed, torn


def hold_rows(n: int, time: float, bodies: Bodies, joints: Joints) -> bool:
    """Let limits hold that would be passed, and motors that would be too fast, as `choose_rows`."""
    changed = False
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        if joints.joints[j, tb.J_STATE] != tb.HOLDS and is_to_change(n, j, time, joints):
            change_row(n, j, time, bodies, joints)
            changed = True
    return changed


def let_go_of_rows(n: int, time: float, bodies: Bodies, joints: Joints) -> bool:
    """Let go of limits that pull, and of motors that give more than they can in a time, s.

    Return whether there are any.
    """
    changed = False
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        if joints.joints[j, tb.J_STATE] == tb.HOLDS and is_to_change(n, j, time, joints):
            change_row(n, j, time, bodies, joints)
            changed = True
    return changed


def time_at_end(n: int, substep: float, joints: Joints) -> float:
    """Return the time, s, that motors have left as the velocities of a mechanism fit its rows.

    Where nothing touches it that is half a substep, s, and else what is left of the last one.
    """
    return substep * (HALF if joints.mechanisms[n, tb.M_STATUS] != tb.IN_CONTACT else 1.0)


def nearest_bound(n: int, time: float, joints: Joints) -> tuple[float, int]:
    """Return the share of the last solution after which a row has given what it can in a time, s.

    Its joint comes with it; that is all of the solution, and -1, if none gives more.
    """
    nearest, which = 1.0, -1
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        if joints.joints[j, tb.J_STATE] == tb.HOLDS and is_to_change(n, j, time, joints):
            given = joints.numbers[j, tb.J_GIVEN]
            bound = bound_of(n, j, given, time, joints)
            before = given - joints.numbers[j, tb.J_IMPULSE]
            share = max(struck_share(before - bound, given - bound), 0.0)
            if which < 0 or share < nearest:
                nearest, which = share, j
    return nearest, which


def bound_of(n: int, j: int, given: float, time: float, joints: Joints) -> float:
    """Return the bound of what a limit or a motor gives in a time, s, that it has gone beyond."""
    if joints.joints[j, tb.J_LAW] != tb.MOTOR:
        return given - given_by_limit(n, j, joints)
    most = row_impulse_most(joints.laws[j, tb.LAW_MOST], time)
    return most if given > 0.0 else -most


def is_to_change(n: int, j: int, time: float, joints: Joints) -> bool:
    """Return whether a limit or a motor, which has a time, s, is to change whether it holds.

    That is a limit that pulls, or one that would be passed, and a motor that gives more than it
    can, or would go beyond its speed by the most that it can. A limit on which a motor without a
    maximum leans holds both ways, for that gives whatever it takes, and the motor lets go.
    """
    ends, numbers = joints.joints[j], joints.numbers[j]
    law, holds, given = ends[tb.J_LAW], ends[tb.J_STATE] == tb.HOLDS, numbers[tb.J_GIVEN]
    if law == tb.MOTOR:
        if ends[tb.J_STATE] == tb.FREE_ROW:
            return False
        if holds:
            return bool(abs(given) > row_impulse_most(joints.laws[j, tb.LAW_MOST], time))
        sign = 1.0 if ends[tb.J_STATE] == tb.AT_MOST else -1.0
        return bool(sign * numbers[tb.J_ERROR] > 0.0)
    if not is_limit(law):
        return False
    sign = 1.0 if law == tb.LOWER_LIMIT else -1.0
    if holds:
        return bool(sign * given_by_limit(n, j, joints) < 0.0 and not is_leant_on(j, joints))
    return bool(sign * numbers[tb.J_ROW] < sign * numbers[tb.J_AIM])


def given_by_limit(n: int, j: int, joints: Joints) -> float:
    """Return what counts of the impulse of a limit, N s, which only pushes: that of a substep.

    It is that of the part where the limit brings back what is beyond it: what it gave for that it
    takes again, and so leaves no speed of it, and is told as what bodies got (GD21).
    """
    return float(joints.numbers[j, tb.J_PULL if brings_back(n, j, joints) else tb.J_GIVEN])


def brings_back(n: int, j: int, joints: Joints) -> bool:
    """Return whether a limit brings back what it has jumped past, or what is far beyond it.

    It does not while it takes that along.
    """
    pulled = joints.numbers[joints.mechanisms[n, tb.M_JOINT], tb.J_PULLED]
    aim, least = joints.numbers[j, tb.J_AIM], joints.numbers[j, tb.J_SLIGHT]
    beyond = -aim if joints.joints[j, tb.J_LAW] == tb.LOWER_LIMIT else aim
    return bool((pulled == UNTIL_BACK and beyond > 0.0) or (pulled == 0.0 and beyond > least))


def change_row(n: int, j: int, time: float, bodies: Bodies, joints: Joints) -> None:
    """Let a limit or a motor hold, or let it go: a motor then gives the most in a time, s."""
    ends, numbers = joints.joints[j], joints.numbers[j]
    motor, given = ends[tb.J_LAW] == tb.MOTOR, numbers[tb.J_GIVEN]
    if ends[tb.J_STATE] != tb.HOLDS:
        ends[tb.J_STATE] = tb.HOLDS
        if not motor:
            if numbers[tb.J_STRUCK] == 0.0:
                note_struck(n, j, joints)
            let_go_of_leaning(j, bodies, joints)
        return
    ends[tb.J_STATE] = tb.FREE_ROW
    if motor:
        ends[tb.J_STATE] = tb.AT_MOST if given > 0.0 else tb.AT_LEAST
    apply_joint_impulse(j, 0, bound_of(n, j, given, time, joints) - given, bodies, joints)


def leaning_motor(j: int, joints: Joints) -> int:
    """Return the motor without a maximum that drives a row towards a limit of it, or -1.

    It comes after the limits of its bodies.
    """
    ends = joints.joints[j]
    sign = 1.0 if ends[tb.J_LAW] == tb.LOWER_LIMIT else -1.0
    for k in range(j + 1, joints.counts[tb.JOINTS]):
        other, law = joints.joints[k], joints.laws[k]
        for end in range(tb.ENDS_OF_JOINT):
            if other[tb.J_MEMBER + end] != ends[tb.J_MEMBER + end]:
                return -1
        unlimited = other[tb.J_LAW] == tb.MOTOR and law[tb.LAW_MOST] == inf
        if unlimited and sign * law[tb.LAW_RATE] < 0.0 and measures_the_same(j, k, joints):
            return k
    return -1


def measures_the_same(j: int, k: int, joints: Joints) -> bool:
    """Return whether two rows of the same bodies measure one freedom: only from where differs."""
    if joints.joints[j, tb.J_KIND] != joints.joints[k, tb.J_KIND]:
        return False
    differ = 0
    for n in range(len(joints.given[j])):
        differ += joints.given[j, n] != joints.given[k, n]
    return differ <= 1


def is_leant_on(j: int, joints: Joints) -> bool:
    """Return whether a motor has let go because it leans on a limit, which holds it."""
    motor = leaning_motor(j, joints)
    return bool(motor >= 0 and joints.joints[motor, tb.J_STATE] == tb.FREE_ROW)


def let_go_of_leaning(j: int, bodies: Bodies, joints: Joints) -> None:
    """Let the motor go that would give any impulse against a limit, which holds from now on."""
    motor = leaning_motor(j, joints)
    if motor >= 0:
        joints.joints[motor, tb.J_STATE] = tb.FREE_ROW
        apply_joint_impulse(motor, 0, -joints.numbers[motor, tb.J_GIVEN], bodies, joints)


def note_struck(n: int, j: int, joints: Joints) -> None:
    """Note at which rate a limit is struck for the first time in a part: its row without it."""
    numbers = joints.numbers[j]
    sign = 1.0 if joints.joints[j, tb.J_LAW] == tb.LOWER_LIMIT else -1.0
    start, end = numbers[tb.J_RATE_START], numbers[tb.J_RESIDUAL]
    share, free = 0.0, sign * numbers[tb.J_VALUE_START] > 0.0
    if free:
        share = struck_share(numbers[tb.J_VALUE_START], numbers[tb.J_ROW])
        start, end = rates_at_ends(n, start, end, joints)
    numbers[tb.J_STRUCK] = struck_rate(start, share, end)


def rates_at_ends(n: int, before: float, after: float, joints: Joints) -> tuple[float, float]:
    """Return the rates with which a substep begins and ends, of a row that had some before.

    Where nothing touches a mechanism, its velocities are those in the middle of substeps.
    """
    if joints.mechanisms[n, tb.M_STATUS] == tb.IN_CONTACT:
        return before, after
    if joints.mechanisms[n, tb.M_HALF] == 1:
        return before, struck_rate(before, 1.0 / HALF, after)
    return struck_rate(before, HALF, after), struck_rate(before, 1.0 + HALF, after)
