"""Which mechanisms may reach a limit in a part of a step; others go as if without limits (IM15).

Cost: the rows of all limits of mechanisms that are awake, once in a part.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.governed import is_limit
from tamias2d.engine.joints.placed_rows import write_slopes
from tamias2d.engine.joints.solve import rate_of_row
from tamias2d.engine.tables import Bodies, Joints

WAYS = 2.0  # of a part at the rate of a row, within which it may reach its limit
SLIGHT_WAYS = 16.0  # beyond that: times what is told, some hundredths of the size of a joint


def is_near_limits(n: int, time: float, bodies: Bodies, joints: Joints) -> bool:
    """Return whether a mechanism may reach a limit within a time, s, or has a motor in a loop.

    What a motor is tried with, which may be more than it can give, tears a loop apart.
    """
    if joints.mechanisms[n, tb.M_CHOOSING] == 0:
        return False
    for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
        law = joints.joints[j, tb.J_LAW]
        if law == tb.MOTOR and joints.mechanisms[n, tb.M_HINGED] == 0:
            return True
        if is_limit(law) and is_near_limit(j, time, bodies, joints):
            return True
    return False


def is_near_limit(j: int, time: float, bodies: Bodies, joints: Joints) -> bool:
    """Return whether a row may reach its limit within a time, s."""
    write_slopes(j, joints)
    numbers = joints.numbers[j]
    sign = 1.0 if joints.joints[j, tb.J_LAW] == tb.LOWER_LIMIT else -1.0
    way = WAYS * time * abs(rate_of_row(j, 0, bodies, joints))
    return bool(sign * numbers[tb.J_ROW] <= way + SLIGHT_WAYS * numbers[tb.J_SLIGHT])
