"""Which trees of hinges are equal, so that they are solved side by side.

Cost: a visit to each body, once as joints come or go.
"""

from collections.abc import Sequence
from typing import NamedTuple

from tamias2d.engine import tables as tb
from tamias2d.engine.arrays.store import Store
from tamias2d.engine.joints.angle_laws import hung_by_law
from tamias2d.engine.joints.hinge_tree import first_besides
from tamias2d.engine.joints.hinges import HingeTree
from tamias2d.engine.joints.joint_row import JointRow
from tamias2d.kernels.lanes import LANES

FEWEST_TREES = 8  # of a block: fewer take no longer by themselves


class Shape(NamedTuple):
    """What equal trees have in common."""

    above: tuple[int, ...]
    """Of each body the place of the one on which it hangs; -1 of what does not move, and -2 of a
    root on nothing."""
    sprung: bool
    """Whether springs govern the angles of hinges."""


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
    """Return what a tree is like; None if more holds it than the hinges of its bodies.

    The angle of each of these may have one spring, without a maximum.
    """
    springs = [rows[k] for k in tree.joints[sum(hinge is not None for hinge in tree.hinges) :]]
    angles = {frozenset(spring.ends[:2]) for spring in springs}
    inside = all(angle <= set(tree.bodies) for angle in angles)
    alike = all(row.law == tb.SPRING and not row.bounded for row in springs)
    if not inside or len(angles) < len(springs) or not alike:
        return None
    place = {body: k for k, body in enumerate(tree.bodies)}
    found = []
    for body, hinge in zip(tree.bodies, tree.hinges, strict=True):
        if hinge is None:
            found.append(-2)
            continue
        (above,) = {end for end in rows[hinge].ends[:2] if end != body}
        found.append(-1 if above is None else place.get(above, -1))
    return Shape(tuple(found), bool(springs))


def write_blocks_of(store: Store, blocks: Sequence[tuple[Shape, list[int]]]) -> None:
    """Write the blocks of a store; the members of its trees are written."""
    joints = store.world.joints
    joints.counts[tb.TREE_BLOCKS] = len(blocks)
    joints.mechanisms[:, tb.M_IN_BLOCK] = 0
    joints.members[:, tb.JOINED_SPRING] = -1
    joints.tree_blocks[:, tb.T_MECHANISM : tb.T_MECHANISM + LANES] = -1
    joints.block_lanes[:] = joints.tree_lanes[:] = 0.0
    first = 0
    for b, ((above, sprung), trees) in enumerate(blocks):
        joints.tree_blocks[b, [tb.T_FIRST, tb.T_TIED, tb.T_SPRUNG, tb.T_WRITTEN]] = (
            *(first, above[0] == -1, sprung, 0),
        )
        joints.tree_blocks[b, tb.T_MECHANISM : tb.T_MECHANISM + len(trees)] = trees
        joints.mechanisms[trees, tb.M_IN_BLOCK] = 1
        joints.tree_above[first] = first
        last = first + 1 + len(above)
        joints.tree_above[first + 1 : last] = [first + 1 + max(place, -1) for place in above]
        for lane, n in enumerate(trees):
            root = joints.sparse[n, tb.I_NODE] + 1
            hinges = joints.hinges[root : root + len(above)]
            own = joints.tree_lanes[first + 1 : last]
            own[:, [tb.T_ANCHOR_X + lane, tb.T_ANCHOR_Y + lane]] = hinges[
                :, tb.H_ANCHOR : tb.H_ANCHOR + 2
            ]
            far = hinges[:, tb.H_FAR_ANCHOR : tb.H_FAR_ANCHOR + 2]
            own[:, [tb.T_FAR_ANCHOR_X + lane, tb.T_FAR_ANCHOR_Y + lane]] = far
            for j in range(first_besides(n, joints), joints.mechanisms[n + 1, tb.M_JOINT]):
                joints.members[hung_by_law(j, joints)[0], tb.JOINED_SPRING] = j
        first = last
    joints.tree_blocks[len(blocks), tb.T_FIRST] = first


def rows_of(blocks: Sequence[tuple[Shape, list[int]]]) -> int:
    """Return how many rows the nodes of blocks have, with those of what they hang on."""
    return sum(1 + len(shape.above) for shape, _ in blocks)
