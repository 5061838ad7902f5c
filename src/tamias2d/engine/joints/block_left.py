"""What the springs of blocks have left to give, as `left_impulses` has it for one tree."""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.block_solve import has_status, store_block, turn_by_springs
from tamias2d.engine.joints.spring_lanes import note_left_of_lanes, take_left_of_lanes
from tamias2d.engine.joints.tree_blocks import first_sprung
from tamias2d.engine.joints.tree_lanes import load_node
from tamias2d.engine.tables import Bodies, Joints
from tamias2d.kernels.lanes import LANES


def give_left_of_blocks(bodies: Bodies, joints: Joints) -> None:
    """Let the springs of blocks that nothing touches give what they have left as a step ends."""
    rows = joints.tree_lanes
    for b in range(joints.counts[tb.TREE_BLOCKS]):
        sprung = joints.tree_blocks[b, tb.T_SPRUNG] == 1
        if sprung and has_status(b, tb.GOVERNED_ALONE, tb.GOVERNED_ALONE, joints):
            first, last = joints.tree_blocks[b, tb.T_FIRST], joints.tree_blocks[b + 1, tb.T_FIRST]
            given = joints.block_lanes[b, tb.T_ACTIVE : tb.T_ACTIVE + LANES]
            for r in range(first, last):
                load_node(joints.tree_slots[r], bodies, rows[r])
            for r in range(first_sprung(b, joints), last):
                take_left_of_lanes(given, rows[r])
            turn_by_springs(b, tb.T_ACTIVE, 1.0, joints)
            store_block(b, bodies, joints)


def note_left_of_blocks(joints: Joints) -> None:
    """Note what the springs of blocks have left, as `note_left` does."""
    for b in range(joints.counts[tb.TREE_BLOCKS]):
        sprung = joints.tree_blocks[b, tb.T_SPRUNG] == 1
        if sprung and has_status(b, tb.GOVERNED_ALONE, tb.IN_CONTACT, joints):
            active = joints.block_lanes[b, tb.T_ACTIVE : tb.T_ACTIVE + LANES]
            for r in range(first_sprung(b, joints), joints.tree_blocks[b + 1, tb.T_FIRST]):
                note_left_of_lanes(active, joints.tree_lanes[r])
