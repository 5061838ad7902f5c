"""Trees are gathered into the lanes of their blocks as a part of a step begins."""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.tree_blocks import first_sprung, write_block
from tamias2d.engine.joints.tree_lanes import all_lanes
from tamias2d.engine.tables import Bodies, Joints
from tamias2d.kernels.lanes import LANES
from tamias2d.state import Array


def begin_blocks(bodies: Bodies, joints: Joints) -> None:
    """Begin a part of a step: note where the bodies of blocks are, and what they weigh."""
    for b in range(joints.counts[tb.TREE_BLOCKS]):
        first, last = joints.tree_blocks[b, tb.T_FIRST], joints.tree_blocks[b + 1, tb.T_FIRST]
        all_lanes(tb.T_EACH, 1.0, joints.block_lanes[b])
        written = joints.tree_blocks[b, tb.T_WRITTEN] == 1
        for m in range(LANES):
            n = joints.tree_blocks[b, tb.T_MECHANISM + m]
            awake = n >= 0 and joints.mechanisms[n, tb.M_STATUS] != tb.ASLEEP
            for r in range(first, last):
                same = begin_lane(m, r, awake, n, r - first, bodies, joints)
                written = written and same
                if awake and r > first + 1:
                    begin_spring(
                        m, joints.sparse[n, tb.I_NODE] + r - first, joints.tree_lanes[r], joints
                    )
        if not written:
            write_block(b, bodies, joints)
        joints.tree_blocks[b, tb.T_WRITTEN] = 0
        if joints.tree_blocks[b, tb.T_SPRUNG] == 1:
            store_angles(b, joints)


def begin_lane(m: int, r: int, awake: bool, n: int, k: int, bodies: Bodies, joints: Joints) -> bool:
    """Note a body in a lane of a row: of the trees that are awake; others have idle ones.

    Body 0 is what the root hangs on. Return whether it is where the lane was placed, as heavy.
    """
    row = joints.tree_lanes[r]
    i = len(bodies.kind) - 1
    mass, inertia = row[tb.T_MASS + m], row[tb.T_INERTIA + m]
    row[tb.T_MASS + m] = row[tb.T_INERTIA + m] = 1.0
    row[tb.T_INVERSE_MASS + m] = row[tb.T_HELD_INVERSE_INERTIA + m] = 0.0
    if awake and k == 0:
        i = joints.members[
            joints.members[joints.sparse[n, tb.I_NODE] + 1, tb.JOINED_ABOVE], tb.JOINED_SLOT
        ]
    elif awake:
        member = joints.sparse[n, tb.I_NODE] + k
        i = joints.members[member, tb.JOINED_SLOT]
        row[tb.T_MASS + m] = joints.factors[member - 1, tb.NODE_MASS]
        row[tb.T_INERTIA + m] = joints.factors[member - 1, tb.NODE_INERTIA]
        row[tb.T_INVERSE_MASS + m] = joints.places[member, tb.SLOWED_INVERSE_MASS]
        row[tb.T_HELD_INVERSE_INERTIA + m] = joints.places[member, tb.HELD_INVERSE_INERTIA]
    joints.tree_slots[r, m] = i
    pose = bodies.pose[i]
    row[tb.T_POSE_X + m], row[tb.T_POSE_Y + m] = pose[tb.X], pose[tb.Y]
    row[tb.T_POSE_ANGLE + m] = pose[tb.ANGLE]
    row[tb.T_STIFFNESS + m] = row[tb.T_DAMPING + m] = row[tb.T_LAW_SIDE + m] = row[
        tb.T_LAW_LEFT + m
    ] = 0.0
    for c in range(tb.T_GIVEN_X, tb.T_LAW_PULL + LANES, LANES):
        row[c + m] = 0.0
    same = (row[tb.T_MASS + m] == mass) & (row[tb.T_INERTIA + m] == inertia)
    same = same & (row[tb.T_X + m] == pose[tb.X]) & (row[tb.T_Y + m] == pose[tb.Y])
    return bool(same & (row[tb.T_ANGLE + m] == pose[tb.ANGLE]))


def begin_spring(m: int, member: int, row: Array, joints: Joints) -> None:
    """Note the spring of the hinge on which a member hangs, in a lane of its row."""
    j = joints.members[member, tb.JOINED_SPRING]
    if j >= 0:
        row[tb.T_JOINT_ANGLE + m] = joints.given[j, 0]
        row[tb.T_STIFFNESS + m] = joints.laws[j, tb.LAW_STIFFNESS]
        row[tb.T_DAMPING + m] = joints.laws[j, tb.LAW_DAMPING]
        row[tb.T_LAW_ARM + m] = joints.numbers[j, tb.J_ARM]
        row[tb.T_LAW_SIDE + m] = 1.0 if joints.joints[j, tb.J_MEMBER + 1] == member else -1.0
        row[tb.T_LAW_LEFT + m] = joints.numbers[j, tb.J_LEFT]


def store_angles(b: int, joints: Joints) -> None:
    """Let the rows of the springs of a block have the angles that were noted."""
    first = joints.tree_blocks[b, tb.T_FIRST]
    for m in range(LANES):
        n = joints.tree_blocks[b, tb.T_MECHANISM + m]
        if n >= 0 and joints.mechanisms[n, tb.M_STATUS] != tb.ASLEEP:
            for r in range(first_sprung(b, joints), joints.tree_blocks[b + 1, tb.T_FIRST]):
                j = joints.members[joints.sparse[n, tb.I_NODE] + r - first, tb.JOINED_SPRING]
                if j >= 0:
                    joints.numbers[j, tb.J_ROW] = joints.tree_lanes[r, tb.T_LAW_START + m]
