"""Jointed bodies have no impacts in flight: these would tear their joints.

Whatever a jointed body meets in a step is foreseen, and solved together with its joints; and worlds
with joints take their steps whole.
"""

from tamias2d.engine.tables import (
    GOES_FAR,
    I_NODE,
    JOINED,
    JOINED_SLOT,
    MECHANISMS,
    START_NOTED,
    Bodies,
    World,
)
from tamias2d.kernels.assembled import inlined


def mark_joined(world: World) -> None:
    """Mark the bodies that joints hold, as a batch of steps begins."""
    joints, bodies = world.joints, world.bodies
    for i in range(len(bodies.properties)):
        bodies.properties[i, JOINED] = 0.0
    for n in range(joints.counts[MECHANISMS]):
        for m in range(joints.sparse[n, I_NODE] + 1, joints.sparse[n + 1, I_NODE] + 1):
            bodies.properties[joints.members[m, JOINED_SLOT], JOINED] = 1.0


def take_whole_steps(world: World) -> None:
    """Forget that bodies go far, or may, for which steps would be taken in parts."""
    control, joints = world.control, world.joints
    if joints.counts[MECHANISMS] > 0:
        control.counts[GOES_FAR] = control.counts[START_NOTED] = 0


@inlined
def unless_joined(found: bool, i: int, j: int, bodies: Bodies) -> bool:
    """Return whether something was found of two bodies that no joint holds."""
    return bool(found & (bodies.properties[i, JOINED] + bodies.properties[j, JOINED] == 0.0))
