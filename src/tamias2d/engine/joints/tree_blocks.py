"""Blocks of equal trees of hinges, each tree in a lane: the rows of their nodes.

Cost: for each node of a block about what four trees by themselves take.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.hinge_tree import SLIGHT_TURN
from tamias2d.engine.joints.spring_lanes import firm_lanes, note_angles_of_lanes
from tamias2d.engine.joints.tree_lanes import (
    all_lanes,
    begin_lanes,
    hang_lanes,
    keep_given_lanes,
    load_node,
    note_apart_lanes,
    place_lanes,
    turn_lanes,
)
from tamias2d.engine.tables import Bodies, Joints
from tamias2d.kernels.lanes import LANES


def write_blocks(bodies: Bodies, joints: Joints) -> None:
    """Write the hinges of blocks where their bodies are."""
    for b in range(joints.counts[tb.TREE_BLOCKS]):
        write_block(b, bodies, joints)


def write_block(b: int, bodies: Bodies, joints: Joints) -> None:
    """Write the hinges of a block where its bodies are, and what hangs on them.

    That is found later for a sprung one, where a substep is known.
    """
    first, last = joints.tree_blocks[b, tb.T_FIRST], joints.tree_blocks[b + 1, tb.T_FIRST]
    each, rows = joints.block_lanes[b, tb.T_EACH : tb.T_EACH + LANES], joints.tree_lanes
    for r in range(first, last):
        load_node(joints.tree_slots[r], bodies, rows[r])
        place_lanes(0.0, rows[r])
        if r > first:
            keep_given_lanes(each, rows[r])
            turn_lanes(each, rows[r], rows[joints.tree_above[r]])
            note_apart_lanes(rows[r])
    for r in range(first_sprung(b, joints), last):
        note_angles_of_lanes(rows[r], rows[joints.tree_above[r]])
    if joints.tree_blocks[b, tb.T_SPRUNG] == 0:
        hang_block(b, 0.0, joints)


def turn_block(b: int, joints: Joints) -> None:
    """Write the hinges of a block where its bodies are placed, in lanes that are solved again."""
    first, last = joints.tree_blocks[b, tb.T_FIRST], joints.tree_blocks[b + 1, tb.T_FIRST]
    again, rows = joints.block_lanes[b, tb.T_AGAIN : tb.T_AGAIN + LANES], joints.tree_lanes
    for r in range(first + 1, last):
        keep_given_lanes(again, rows[r])
        turn_lanes(again, rows[r], rows[joints.tree_above[r]])


def hang_block(b: int, substep: float, joints: Joints) -> None:
    """Find what hangs on the hinges of a block; springs count through a substep, s, as there."""
    first, last = joints.tree_blocks[b, tb.T_FIRST], joints.tree_blocks[b + 1, tb.T_FIRST]
    lanes = joints.tree_lanes
    all_lanes(tb.T_SLIGHT, SLIGHT_TURN, joints.block_lanes[b])
    for r in range(first, last):
        begin_lanes(lanes[r])
    for r in range(first_sprung(b, joints), last):
        firm_lanes(substep, joints.block_lanes[b], lanes[r], lanes[joints.tree_above[r]])
    for r in range(last - 1, first, -1):
        hang_lanes(lanes[r], lanes[joints.tree_above[r]])


def first_sprung(b: int, joints: Joints) -> int:
    """Return the first row of a block whose hinges may have springs; where there are none, its end.

    All after it may, too.
    """
    if joints.tree_blocks[b, tb.T_SPRUNG] == 1:
        return int(joints.tree_blocks[b, tb.T_FIRST] + 2)
    return int(joints.tree_blocks[b + 1, tb.T_FIRST])


def first_hinge(b: int, joints: Joints) -> int:
    """Return the first row of a block whose nodes hang on something: that of roots, or the next."""
    return int(
        joints.tree_blocks[b, tb.T_FIRST] + (1 if joints.tree_blocks[b, tb.T_TIED] == 1 else 2)
    )
