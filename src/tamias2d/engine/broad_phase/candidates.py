"""Candidates: pairs of shapes that may touch before a body leaves its fat bounds.

Pairs of leaves whose boxes overlap are found in the tree; circles and sides then rule out more.
Cost: n log n, and the pairs.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.broad_phase.bvh import BUNCH, build_tree, first_leaf_node
from tamias2d.engine.broad_phase.fat_box import (
    circles_apart,
    half_plane_offset,
    note_centre,
    reaches_half_plane,
    sides_apart,
)
from tamias2d.engine.broad_phase.node_filters import may_meet, note_node_filters
from tamias2d.engine.tables import Bodies, BroadPhase, Integers, Shapes, Tree
from tamias2d.state import Array


def find_candidates(bodies: Bodies, shapes: Shapes, tree: Tree, broad_phase: BroadPhase) -> int:
    """Write all candidates, unsorted; return how many.

    If there is no room for all of them, only their number is right.
    """
    leaves = build_tree(shapes.kind, shapes.slot, bodies.kind, broad_phase.canonical, tree)
    tree.counts[tb.LEAVES] = leaves
    for k in range(leaves):
        s = tree.morton[tb.LEAF, k]
        tree.leaf_of_shape[s] = k
        for n in range(4):
            tree.boxes[k, n] = tree.boxes[s, tb.FAT + n]
        note_centre(k, s, bodies, shapes, tree, broad_phase)
    filtered = note_node_filters(leaves, shapes.filters, tree)
    overlapping = find_leaf_pairs(leaves, filtered, tree, broad_phase.leaf_pairs)
    if overlapping > len(broad_phase.leaf_pairs):
        return overlapping
    total = 0
    for p in range(overlapping):
        k, m = broad_phase.leaf_pairs[p, 0], broad_phase.leaf_pairs[p, 1]
        total = note_if_near(total, k, m, bodies, shapes, tree, broad_phase)
    for s in range(len(shapes.kind)):
        if shapes.kind[s] == tb.HALF_PLANE and bodies.kind[shapes.slot[s]] != tb.ABSENT:
            total = find_all_beside(total, s, bodies, shapes, tree, broad_phase)
    return total


def find_leaf_pairs(leaves: int, filtered: bool, tree: Tree, pairs: Integers) -> int:
    """Write the pairs of leaves whose boxes overlap; return how many.

    The leaves of a bunch are compared together with those bunches on their right in the tree whose
    box overlaps theirs, but, where shapes are `filtered`, not with those that filters keep apart
    from them. If there is no room for all pairs, the number is too large.
    """
    total = 0
    first = first_leaf_node(leaves)
    most = len(pairs) - BUNCH * BUNCH
    for bunch in range((leaves + BUNCH - 1) // BUNCH):
        box = tree.nodes[first + bunch]
        at = first + bunch
        while True:
            near = boxes_overlap(box, tree.nodes[at])
            if filtered:
                near = near and may_meet(tree.filters[first + bunch], tree.filters[at])
            if near and at < first:
                at = 2 * at
                continue
            if near:
                other = (at - first) * BUNCH
                for k in range(bunch * BUNCH, min(bunch * BUNCH + BUNCH, leaves)):
                    for m in range(max(k + 1, other), min(other + BUNCH, leaves)):
                        if total <= most:  # written in any case, and kept where they overlap
                            pairs[total, 0], pairs[total, 1] = k, m
                        total += 1 if boxes_overlap(tree.boxes[k], tree.boxes[m]) else 0
            while at & 1:  # up, until there is a node to the right
                at >>= 1
            if at == 0:
                break
            at += 1
    return total if total <= most else total + BUNCH * BUNCH


def boxes_overlap(one: Array, other: Array) -> bool:
    """Return whether two boxes have a common point."""
    return bool(
        (one[0] <= other[2]) & (one[2] >= other[0]) & (one[1] <= other[3]) & (one[3] >= other[1])
    )


def note_if_near(
    total: int,
    k: int,
    m: int,
    bodies: Bodies,
    shapes: Shapes,
    tree: Tree,
    broad_phase: BroadPhase,
) -> int:
    """Note two leaves as a candidate if their shapes may touch; return how many there are."""
    if circles_apart(tree.centres[k], tree.centres[m]):
        return total
    s, t = tree.morton[tb.LEAF, k], tree.morton[tb.LEAF, m]
    if may_collide(s, t, bodies, shapes) and not sides_apart(
        k, m, bodies, shapes, tree, broad_phase
    ):
        return note_candidate(total, s, t, broad_phase)
    return total


def find_all_beside(
    total: int, s: int, bodies: Bodies, shapes: Shapes, tree: Tree, broad_phase: BroadPhase
) -> int:
    """Note the leaves that reach into a half-plane; return how many candidates there are."""
    offset = half_plane_offset(s, shapes, broad_phase)
    side = shapes.world_vertices[shapes.first[s]]
    for k in range(tree.counts[tb.LEAVES]):
        t = tree.morton[tb.LEAF, k]
        if reaches_half_plane(t, offset, side, tree.boxes) and may_collide(s, t, bodies, shapes):
            total = note_candidate(total, s, t, broad_phase)
    return total


def may_collide(s: int, t: int, bodies: Bodies, shapes: Shapes) -> bool:
    """Return whether two shapes may collide, or sense each other, by their bodies and filters.

    Bodies that nothing pushes do not collide, but one that moves is sensed, and senses.
    """
    i, j, filters = shapes.slot[s], shapes.slot[t], shapes.filters
    senses = filters[s, tb.SENSOR] + filters[t, tb.SENSOR] > 0
    if i == j or max(bodies.kind[i], bodies.kind[j]) < (tb.KINEMATIC if senses else tb.DYNAMIC):
        return False
    group = filters[s, tb.GROUP]
    if group != 0 and group == filters[t, tb.GROUP]:
        return bool(group > 0)
    return bool(
        (filters[s, tb.CATEGORY] & filters[t, tb.MASK]) != 0
        and (filters[t, tb.CATEGORY] & filters[s, tb.MASK]) != 0
    )


def note_candidate(total: int, s: int, t: int, broad_phase: BroadPhase) -> int:
    """Write a pair by its ranks, the lower one first, if there is room; count it in any case."""
    rank, candidates = broad_phase.canonical[tb.RANK], broad_phase.candidates
    if total < len(candidates):
        a, b = rank[s], rank[t]
        candidates[total, 0], candidates[total, 1] = min(a, b), max(a, b)
    return total + 1


def sort_candidates(total: int, broad_phase: BroadPhase) -> None:
    """Sort the candidates by their first rank, and by the second where that is equal."""
    candidates, sorting, bins = broad_phase.candidates, broad_phase.sorting, broad_phase.rank_counts
    counting_pass(total, 1, candidates, sorting, bins)
    counting_pass(total, 0, sorting, candidates, bins)


def counting_pass(
    total: int, column: int, source: Integers, target: Integers, bins: Integers
) -> None:
    """Sort pairs by one of their ranks, those where it is equal as they are."""
    for k in range(len(bins)):
        bins[k] = 0
    for p in range(total):
        bins[source[p, column] + 1] += 1
    for k in range(1, len(bins)):
        bins[k] += bins[k - 1]
    for p in range(total):
        rank = source[p, column]
        place = bins[rank]
        bins[rank] = place + 1
        target[place, 0], target[place, 1] = source[p, 0], source[p, 1]
