"""All pairs of a few shapes: their contact list holds wherever bodies go.

To look at each of these pairs costs less than to keep bounds. So bodies that move have bounds
without an end, in a frame that stands still, and no result depends on when the list was made.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.broad_phase.bvh import FAR
from tamias2d.engine.broad_phase.candidates import may_collide, note_candidate
from tamias2d.engine.broad_phase.comoving_frame import stand_still
from tamias2d.engine.broad_phase.fat_bounds import fatten_all_bounds
from tamias2d.engine.hard_scene import are_hard_discs
from tamias2d.engine.tables import Bodies, BroadPhase, Integers, Shapes, Tree, World
from tamias2d.state import Array

FEW_SHAPES = 8  # of which all pairs are listed
FEW_DISCS = 16  # the same of hard discs and half-planes


def few_shapes(bodies: Bodies, shapes: Shapes) -> bool:
    """Return whether there are so few shapes that all are paired."""
    present = 0
    for s in range(len(shapes.slot)):
        present += 1 if bodies.kind[shapes.slot[s]] != tb.ABSENT else 0
    return present <= FEW_SHAPES or (present <= FEW_DISCS and are_hard_discs(bodies, shapes))


def find_all_pairs(world: World) -> int:
    """Note all pairs of shapes that may collide as candidates; return how many there are."""
    bodies, shapes, broad_phase = world.bodies, world.shapes, world.broad_phase
    stand_still(broad_phase)
    fatten_all_bounds(bodies, broad_phase, 0.0)
    open_bounds(bodies, broad_phase)
    number_leaves(bodies.kind, shapes, world.tree)
    total = 0
    for s in range(len(shapes.slot)):
        for t in range(s):
            there = min(bodies.kind[shapes.slot[s]], bodies.kind[shapes.slot[t]]) != tb.ABSENT
            bounded = shapes.kind[s] != tb.HALF_PLANE or shapes.kind[t] != tb.HALF_PLANE
            if bounded and there and may_collide(s, t, bodies, shapes):
                total = note_candidate(total, s, t, broad_phase)
    return total


def open_bounds(bodies: Bodies, broad_phase: BroadPhase) -> None:
    """Let bodies that move be anywhere; those that stand are noted to be where they are."""
    for i in range(len(bodies.kind)):
        if bodies.kind[i] > tb.STATIC:
            bounds = broad_phase.fat_bounds[i]
            bounds[tb.LOW_X], bounds[tb.LOW_Y] = -FAR, -FAR
            bounds[tb.HIGH_X], bounds[tb.HIGH_Y] = FAR, FAR
            bounds[tb.ANGLE_MARGIN] = FAR


def list_holds_for_good(bodies: Bodies, broad_phase: BroadPhase) -> bool:
    """Return whether the contact list holds wherever bodies go.

    What stands may have been moved or turned by hand since the list was made.
    """
    i, size = 0, len(bodies.kind)
    while i < size and holds_for_good(bodies.kind[i], bodies.pose[i], broad_phase.fat_bounds[i]):
        i += 1
    return i == size


def holds_for_good(kind: int, pose: Array, bounds: Array) -> bool:
    """Return whether a body has bounds without an end, or is where it stood as they were made."""
    if kind == tb.STATIC:
        stands = (pose[tb.X] == bounds[tb.LOW_X]) & (pose[tb.Y] == bounds[tb.LOW_Y])
        return bool(stands & (pose[tb.ANGLE] == bounds[tb.BASE_ANGLE]))
    is_open = (bounds[tb.LOW_X] == -FAR) & (bounds[tb.ANGLE_MARGIN] == FAR)
    return bool((kind == tb.ABSENT) | is_open)


def number_leaves(kind: Integers, shapes: Shapes, tree: Tree) -> None:
    """Number the bounded shapes, as if they were the leaves of a tree."""
    leaves = 0
    for s in range(len(shapes.slot)):
        if shapes.kind[s] != tb.HALF_PLANE and kind[shapes.slot[s]] != tb.ABSENT:
            tree.leaf_of_shape[s], tree.morton[tb.LEAF, leaves] = leaves, s
            leaves += 1
    tree.counts[tb.LEAVES] = leaves
