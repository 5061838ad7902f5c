"""By how much loads act before the middle of a step, where they vary (DD53). Cost: some visits.

Each substep begins with its kick; bodies in closed form get theirs all along.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import World
from tamias2d.generated.spring_step import early_share_whole


def add_early(world: World) -> None:
    """Add up by which share of half a step loads have acted before its middle, part by part."""
    control = world.control
    early = world.bodies.early
    note_early_joined(world)
    length = control.progress[tb.PART_TIME] / control.settings[tb.TIME_STEP]
    for i in range(len(early)):
        before = 0.0 if control.counts[tb.TICK] == 0 else early[i, tb.SHARE_OF_STEP]
        early[i, tb.SHARE_OF_STEP] = early_share_whole(before, length, early[i, tb.SHARE_OF_PART])


def note_early_joined(world: World) -> None:
    """Note that mechanisms which nothing touches take half a kick at both ends of a part."""
    joints = world.joints
    early = world.bodies.early
    for n in range(joints.counts[tb.MECHANISMS]):
        if joints.mechanisms[n, tb.M_STATUS] != tb.IN_CONTACT:
            for m in range(joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1):
                early[joints.members[m, tb.JOINED_SLOT], tb.SHARE_OF_PART] = 0.0
