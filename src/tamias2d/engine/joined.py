"""Jointed bodies have no impacts in flight: these would tear their joints.

Whatever a jointed body meets in a step is foreseen, and solved together with its joints.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Bodies, World
from tamias2d.kernels.assembled import inlined


def mark_joined(world: World) -> None:
    """Mark the bodies that joints hold by their members, as a batch of steps begins."""
    joints, bodies = world.joints, world.bodies
    for i in range(len(bodies.properties)):
        bodies.properties[i, tb.JOINED] = 0.0
    for n in range(joints.counts[tb.MECHANISMS]):
        for m in range(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1):
            bodies.properties[joints.members[m, tb.JOINED_SLOT], tb.JOINED] = float(m)
            joints.members[m, tb.JOINED_MECHANISM] = n


@inlined
def unless_joined(found: bool, i: int, j: int, bodies: Bodies) -> bool:
    """Return whether something was found of two bodies that no joint holds."""
    return bool(found & (bodies.properties[i, tb.JOINED] + bodies.properties[j, tb.JOINED] == 0.0))


@inlined
def or_joined(found: bool, i: int, bodies: Bodies) -> bool:
    """Return whether something was found of a body, or joints hold it."""
    return bool(found | (bodies.properties[i, tb.JOINED] > 0.0))
