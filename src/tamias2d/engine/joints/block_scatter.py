"""What went through the hinges of blocks in a part of a step is scattered to their trees."""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.hinge_tree import store_hinge_impulses
from tamias2d.engine.joints.tree_lanes import keep_given_lanes
from tamias2d.engine.tables import Joints
from tamias2d.generated.joint_step import angular_momentum_later
from tamias2d.kernels.lanes import LANES
from tamias2d.state import Array


def store_blocks(joints: Joints) -> None:
    """Store what went through the hinges of blocks in a part, and how far apart they were."""
    for b in range(joints.counts[tb.TREE_BLOCKS]):
        first, last = joints.tree_blocks[b, tb.T_FIRST], joints.tree_blocks[b + 1, tb.T_FIRST]
        for r in range(first + 1, last):
            each = joints.block_lanes[b, tb.T_EACH : tb.T_EACH + LANES]
            keep_given_lanes(each, joints.tree_lanes[r])
        for m in range(LANES):
            n = joints.tree_blocks[b, tb.T_MECHANISM + m]
            if n < 0 or joints.mechanisms[n, tb.M_STATUS] == tb.ASLEEP:
                continue
            for r in range(first + 1, last):
                member = joints.sparse[n, tb.I_NODE] + r - first
                store_lane(m, joints.tree_lanes[r], joints.hinges[member])
            store_hinge_impulses(n, joints)
        joints.tree_blocks[b, tb.T_WRITTEN] = 1


def store_springs_of_blocks(joints: Joints) -> None:
    """Store how far the springs of blocks are stretched, and what they gave in a part."""
    for b in range(joints.counts[tb.TREE_BLOCKS]):
        first, last = joints.tree_blocks[b, tb.T_FIRST], joints.tree_blocks[b + 1, tb.T_FIRST]
        for m in range(LANES):
            n = joints.tree_blocks[b, tb.T_MECHANISM + m]
            if n < 0 or joints.mechanisms[n, tb.M_STATUS] == tb.ASLEEP:
                continue
            for r in range(first + 1, last):
                spring = joints.members[joints.sparse[n, tb.I_NODE] + r - first, tb.JOINED_SPRING]
                if spring >= 0:
                    store_spring(m, joints.tree_lanes[r], joints.numbers[spring])


def store_lane(m: int, row: Array, hinge: Array) -> None:
    """Let the row of a hinge have what its lane has."""
    hinge[tb.H_GIVEN] = hinge[tb.H_GIVEN + 1] = 0.0
    hinge[tb.H_PULL], hinge[tb.H_PULL + 1] = row[tb.T_PULL_X + m], row[tb.T_PULL_Y + m]
    hinge[tb.H_TURN], hinge[tb.H_FAR_TURN] = row[tb.T_TURN + m], row[tb.T_FAR_TURN + m]
    hinge[tb.H_APART], hinge[tb.H_APART + 1] = row[tb.T_APART_X + m], row[tb.T_APART_Y + m]


def store_spring(m: int, row: Array, numbers: Array) -> None:
    """Let the numbers of a spring have what its lane has."""
    pull, own = row[tb.T_LAW_PULL + m], row[tb.T_LAW_SIDE + m] > 0.0
    turning, far = row[tb.T_TURNING + m], row[tb.T_FAR_TURNING + m]
    numbers[tb.J_PULL], numbers[tb.J_LEFT] = pull, row[tb.T_LAW_LEFT + m]
    numbers[tb.J_ROW] = row[tb.T_LAW_START + m]
    to = tb.J_TOTAL + 2
    numbers[to] = angular_momentum_later(numbers[to], pull, far if own else turning)
    numbers[to + 3] = angular_momentum_later(numbers[to + 3], pull, turning if own else far)
