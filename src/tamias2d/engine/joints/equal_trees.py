"""Which trees of hinges are equal, so that they are solved side by side.

Cost: a visit to each body, once as joints come or go.
"""

from collections.abc import Sequence

from tamias2d.engine.joints.hinges import HingeTree
from tamias2d.engine.joints.joint_row import JointRow
from tamias2d.engine.store import Store
from tamias2d.engine.tables import (
    H_ANCHOR,
    H_FAR_ANCHOR,
    I_NODE,
    M_IN_BLOCK,
    T_ANCHOR_X,
    T_ANCHOR_Y,
    T_FAR_ANCHOR_X,
    T_FAR_ANCHOR_Y,
    T_FIRST,
    T_MECHANISM,
    T_TIED,
    TREE_BLOCKS,
)
from tamias2d.kernels.lanes import LANES

FEWEST_TREES = 8  # of a block: fewer take no longer by themselves

Shape = tuple[int, ...]
"""Of each body of a tree the place of the one on which it hangs; -1 of what does not move, and -2
of a root on nothing."""


def equal_trees(
    trees: Sequence[HingeTree | None], rows: Sequence[JointRow]
) -> list[tuple[Shape, list[int]]]:
    """Return blocks: what their trees are like, and the numbers of these."""
    found: dict[Shape, list[int]] = {}
    for n, tree in enumerate(trees):
        shape = _shape(tree, rows) if tree else None
        if shape:
            found.setdefault(shape, []).append(n)
    blocks = [
        (shape, own[k : k + LANES])
        for shape, own in found.items()
        for k in range(0, len(own), LANES)
    ]
    return [block for block in blocks if len(block[1]) >= FEWEST_TREES]


def _shape(tree: HingeTree, rows: Sequence[JointRow]) -> Shape | None:
    """Return what a tree is like; None if more than the hinges of its bodies hold it."""
    if len(tree.joints) > sum(hinge is not None for hinge in tree.hinges):
        return None
    place = {body: k for k, body in enumerate(tree.bodies)}
    shape = []
    for body, hinge in zip(tree.bodies, tree.hinges, strict=True):
        if hinge is None:
            shape.append(-2)
            continue
        (above,) = {end for end in rows[hinge].ends[:2] if end != body}
        shape.append(-1 if above is None else place.get(above, -1))
    return tuple(shape)


def write_blocks_of(store: Store, blocks: Sequence[tuple[Shape, list[int]]]) -> None:
    """Write the blocks of a store; the members of its trees are written."""
    joints = store.world.joints
    joints.counts[TREE_BLOCKS] = len(blocks)
    joints.mechanisms[:, M_IN_BLOCK] = 0
    joints.tree_blocks[:, T_MECHANISM : T_MECHANISM + LANES] = -1
    joints.block_lanes[:] = joints.tree_lanes[:] = 0.0
    first = 0
    for b, (shape, trees) in enumerate(blocks):
        joints.tree_blocks[b, [T_FIRST, T_TIED]] = first, shape[0] == -1
        joints.tree_blocks[b, T_MECHANISM : T_MECHANISM + len(trees)] = trees
        joints.mechanisms[trees, M_IN_BLOCK] = 1
        joints.tree_above[first] = first
        joints.tree_above[first + 1 : first + 1 + len(shape)] = [
            first + 1 + max(above, -1) for above in shape
        ]
        for lane, n in enumerate(trees):
            root = joints.sparse[n, I_NODE] + 1
            hinges = joints.hinges[root : root + len(shape)]
            own = joints.tree_lanes[first + 1 : first + 1 + len(shape)]
            own[:, [T_ANCHOR_X + lane, T_ANCHOR_Y + lane]] = hinges[:, H_ANCHOR : H_ANCHOR + 2]
            far = hinges[:, H_FAR_ANCHOR : H_FAR_ANCHOR + 2]
            own[:, [T_FAR_ANCHOR_X + lane, T_FAR_ANCHOR_Y + lane]] = far
        first += 1 + len(shape)
    joints.tree_blocks[len(blocks), T_FIRST] = first


def rows_of(blocks: Sequence[tuple[Shape, list[int]]]) -> int:
    """Return how many rows the nodes of blocks have, with those of what they hang on."""
    return sum(1 + len(shape) for shape, _ in blocks)
