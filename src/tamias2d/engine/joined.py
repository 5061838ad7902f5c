"""Bodies that joints hold firmly have no impacts in flight: these would tear their joints.

Whatever such a body meets in a step is foreseen, and solved together with its joints. Joints that
only rub hold nothing together.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Bodies, World
from tamias2d.kernels.assembled import inlined


def mark_joined(world: World) -> None:
    """Mark the bodies of joints by their members, as a batch of steps begins.

    Where all joints of a mechanism only rub, they have the negative.
    """
    joints, bodies = world.joints, world.bodies
    for i in range(len(bodies.properties)):
        bodies.properties[i, tb.JOINED] = 0.0
    for n in range(joints.counts[tb.MECHANISMS]):
        sign = 1.0 if joints.mechanisms[n, tb.M_FIRM] == 1 else -1.0
        for m in range(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1):
            bodies.properties[joints.members[m, tb.JOINED_SLOT], tb.JOINED] = sign * m
            joints.members[m, tb.JOINED_MECHANISM] = n


@inlined
def unless_joined(found: bool, i: int, j: int, bodies: Bodies) -> bool:
    """Return whether something was found of two bodies that no joint holds firmly."""
    return bool(found & (not (is_held(i, bodies) or is_held(j, bodies))))


@inlined
def or_joined(found: bool, i: int, bodies: Bodies) -> bool:
    """Return whether something was found of a body, or it has joints."""
    return bool(found | (bodies.properties[i, tb.JOINED] != 0.0))


@inlined
def is_held(i: int, bodies: Bodies) -> bool:
    """Return whether joints hold a body firmly."""
    return bool(bodies.properties[i, tb.JOINED] > 0.0)
