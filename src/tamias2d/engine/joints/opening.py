"""How fast what ties a mechanism opens its rows, and they close again (DD86).

A share of what is apart, closed in each substep, is a rate that grows as substeps shrink, and would
throw what hangs on it. So rows that have yielded close no faster than they were opened, or than
loads would open them.

Cost: where something ties a mechanism that moves, a visit to each of its rows in a substep.
"""

from math import inf, sqrt

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.linearise import apart_by_law
from tamias2d.engine.tables import Bodies, Control, Integers, Joints
from tamias2d.generated.definitions import acceleration
from tamias2d.generated.joint_rows import ROW
from tamias2d.generated.joint_step import closing_share, row_rate
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array, Vector

LOADS = 16.0  # times what they accelerate by in a substep: a taut chain bears as many weights


def note_drive(
    n: int, seen: Array, substep: float, control: Control, bodies: Bodies, joints: Joints
) -> None:
    """Note the rate at which what ties a mechanism parts its rows in a substep, s: any by hand.

    They are seen from the reference motion that stands in the row of an island.
    """
    whole = joints.numbers[joints.mechanisms[n, tb.M_JOINT]]
    base = (seen[tb.REFERENCE], seen[tb.REFERENCE + 1])
    rates = seen[tb.DRIVEN_RATE] * seen[tb.DRIVEN_RATE]
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        for r in range(joints.joints[j, tb.J_ROWS]):
            rate = joints.numbers[j, tb.J_ARM + r] * rate_driven(j, r, base, bodies, joints)
            rates += rate * rate
    whole[tb.J_DRIVEN] = inf if whole[tb.J_PULLED] > 0.0 else sqrt(rates)
    if whole[tb.J_FIRMEST] > 0.0 and whole[tb.J_DRIVEN] > 0.0:
        note_opened(whole)
    if whole[tb.J_OPENED] > 0.0:
        loaded = LOADS * substep * largest_load(n, control, bodies, joints)
        whole[tb.J_OPENED] = max(whole[tb.J_OPENED], loaded)


def note_opened(whole: Array) -> None:
    """Note at which rate a mechanism is opened that yields, if that is faster than before."""
    whole[tb.J_OPENED] = max(whole[tb.J_OPENED], whole[tb.J_DRIVEN])


def largest_load(n: int, control: Control, bodies: Bodies, joints: Joints) -> float:
    """Return the largest acceleration, m/s^2, that loads give a body of a mechanism."""
    gravity = (control.settings[tb.GRAVITY_X], control.settings[tb.GRAVITY_Y])
    largest = 0.0
    for node in range(joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]):
        i = joints.sparse[node, tb.N_BODY]
        load, inverse_mass = bodies.load[i], bodies.properties[i, tb.INVERSE_MASS]
        x, y = acceleration(gravity, (load[0], load[1]), inverse_mass)
        largest = max(largest, x * x + y * y)
    return sqrt(largest)


def rate_driven(j: int, r: int, base: Vector, bodies: Bodies, joints: Joints) -> float:
    """Return at which rate a row of a joint is driven, m/s, as seen from a velocity; no motor."""
    if joints.joints[j, tb.J_LAW] >= tb.MOTOR:
        return 0.0
    rate = rate_of_supports(r, joints.joints[j], joints.numbers[j], base, bodies, joints)
    return rate + abs(joints.laws[j, tb.LAW_RATE])


def rate_of_supports(
    r: int, ends: Integers, numbers: Array, base: Vector, bodies: Bodies, joints: Joints
) -> float:
    """Return the rate that what nothing pushes gives a row, m/s, as seen from a velocity."""
    rate = 0.0
    for end in range(tb.ENDS_OF_JOINT):
        if ends[tb.J_NODE + end] == tb.NOT_PUSHED:
            at = tb.J_ROW + ROW * r + 1 + 3 * end
            now = bodies.motion[joints.members[ends[tb.J_MEMBER + end], tb.JOINED_SLOT]]
            velocity = (now[tb.VX] - base[0], now[tb.VY] - base[1])
            slope = (numbers[at], numbers[at + 1])
            rate += abs(row_rate(slope, numbers[at + 2], velocity, now[tb.SPIN]))
    return rate


def fastest_drive(n: int, joints: Joints) -> float:
    """Return the fastest, m/s, that what ties a mechanism moves, or has since it yielded.

    That is any where nothing that ties it moves.
    """
    whole = joints.numbers[joints.mechanisms[n, tb.M_JOINT]]
    rate = max(whole[tb.J_DRIVEN], whole[tb.J_OPENED])
    return float(rate) if rate > 0.0 else inf


def closing_rate(n: int, joints: Joints) -> float:
    """Return the fastest, m/s, at which rows of a mechanism may close: any where none yielded."""
    opened = joints.numbers[joints.mechanisms[n, tb.M_JOINT], tb.J_OPENED]
    return float(opened) if opened > 0.0 else inf


@inlined
def share_closed(value: float, removed: float, way: float) -> float:
    """Return which share of the value of a row a substep removes: by a way, m, at most."""
    return closing_share(value, way) if removed * abs(value) > way else removed


def forget_opened(n: int, joints: Joints) -> None:
    """Forget how fast a mechanism was opened, once none of its rows is apart by what is told."""
    whole = joints.numbers[joints.mechanisms[n, tb.M_JOINT]]
    if whole[tb.J_OPENED] == 0.0 or whole[tb.J_FIRMEST] > 0.0:
        return
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        for r in range(joints.joints[j, tb.J_ROWS]):
            apart = apart_by_law(r, joints.joints[j], joints.numbers[j])
            if apart > joints.numbers[j, tb.J_SLIGHT + r]:
                return
    whole[tb.J_OPENED] = 0.0
