"""Pairs of shapes that may touch before a body leaves its room.

Serves: the look around. Hides: what is ruled out, by boxes, circles and sides.
"""

from math import sqrt

from tamias2d.engine.broad_phase.bvh import BUNCH, FAR, build_tree, first_leaf_node
from tamias2d.engine.tables import (
    ABSENT,
    ANGLE,
    ANGLE_MARGIN,
    BASE_ANGLE,
    BOUNDING_RADIUS,
    CATEGORY,
    CENTRE_RADIUS,
    CENTRE_X,
    CENTRE_Y,
    DANGLE,
    DYNAMIC,
    FAT,
    GROUP,
    HALF_HEIGHT,
    HALF_PLANE,
    HALF_WIDTH,
    HIGH_X,
    HIGH_Y,
    LEAF,
    LEAVES,
    LOW_X,
    LOW_Y,
    MASK,
    SHAPE_RADIUS,
    Bodies,
    BroadPhase,
    Integers,
    Shapes,
    Tree,
)
from tamias2d.state import Array

SPECULATIVE_MARGIN = 0.12  # of the reach: how far around a shape others must be known
LONGER = 3.0  # than another shape: what is looked at by its sides, and not as a circle


def fatten_box(s: int, bodies: Bodies, shapes: Shapes, tree: Tree, broad_phase: BroadPhase) -> None:
    """Put a box around a shape: wherever its body may be at home, and what is near it there."""
    i = shapes.slot[s]
    if shapes.kind[s] == HALF_PLANE or bodies.kind[i] == ABSENT:
        return
    low_x, low_y, high_x, high_y = FAR, FAR, -FAR, -FAR
    far = 0.0
    for k in range(shapes.first[s], shapes.first[s] + shapes.count[s]):
        x, y = shapes.world_vertices[k, 0], shapes.world_vertices[k, 1]
        low_x, high_x = min(low_x, x), max(high_x, x)
        low_y, high_y = min(low_y, y), max(high_y, y)
        far = max(far, x * x + y * y)
    more = shapes.radius[s]
    if bodies.kind[i] == DYNAMIC:
        more += SPECULATIVE_MARGIN * bodies.properties[i, BOUNDING_RADIUS]
    if far > 0.0:  # what turning may do to corners
        more += min(broad_phase.fat_bounds[i, ANGLE_MARGIN], 2.0) * sqrt(far)
    tree.boxes[s, FAT], tree.boxes[s, FAT + 2] = (
        broad_phase.fat_bounds[i, LOW_X] + low_x - more,
        broad_phase.fat_bounds[i, HIGH_X] + high_x + more,
    )
    tree.boxes[s, FAT + 1] = broad_phase.fat_bounds[i, LOW_Y] + low_y - more
    tree.boxes[s, FAT + 3] = broad_phase.fat_bounds[i, HIGH_Y] + high_y + more


def find_candidates(bodies: Bodies, shapes: Shapes, tree: Tree, broad_phase: BroadPhase) -> int:
    """Put all pairs that may meet at home into `found`, unsorted, as ranks; return how many.

    If there is no room for all of them, only their number is right.
    """
    leaves = build_tree(shapes.kind, shapes.slot, bodies.kind, broad_phase.canonical, tree)
    tree.counts[LEAVES] = leaves
    for k in range(leaves):
        s = tree.morton[LEAF, k]
        tree.leaf_of_shape[s] = k
        for n in range(4):
            tree.boxes[k, n] = tree.boxes[s, FAT + n]
        note_centre(k, s, bodies, shapes, tree, broad_phase)
    near = overlapping_leaves(leaves, tree, broad_phase)
    if near > len(broad_phase.candidates):
        return near
    total = 0
    for p in range(near):
        k, m = broad_phase.candidates[p, 2], broad_phase.candidates[p, 3]
        if circles_apart(tree.centres[k], tree.centres[m]):
            continue
        s, t = tree.morton[LEAF, k], tree.morton[LEAF, m]
        if may_collide(s, t, bodies, shapes) and not sides_apart(
            k, m, bodies, shapes, tree, broad_phase
        ):
            total = note_candidate(total, s, t, broad_phase.canonical, broad_phase.candidates)
    for s in range(len(shapes.kind)):
        if shapes.kind[s] == HALF_PLANE and bodies.kind[shapes.slot[s]] != ABSENT:
            offset = half_plane_offset(s, shapes, broad_phase)
            side = shapes.world_vertices[shapes.first[s]]
            for k in range(leaves):
                t = tree.morton[LEAF, k]
                if reaches_half_plane(t, offset, side, tree.boxes) and may_collide(
                    s, t, bodies, shapes
                ):
                    total = note_candidate(
                        total, s, t, broad_phase.canonical, broad_phase.candidates
                    )
    return total


def overlapping_leaves(leaves: int, tree: Tree, broad_phase: BroadPhase) -> int:
    """Write which leaves overlap which to the columns 2 and 3 of `found`; return how many.

    All leaves of a bunch look together for bunches that theirs overlaps, on their right in the
    tree: those before have found them. If there is no room for all, the number is too large.
    """
    total = 0
    first = first_leaf_node(leaves)
    room = len(broad_phase.candidates) - BUNCH * BUNCH
    for bunch in range((leaves + BUNCH - 1) // BUNCH):
        here = tree.nodes[first + bunch]
        at = first + bunch
        while True:
            while at < first and boxes_overlap(here, tree.nodes[at]):
                at = 2 * at
            if at >= first and boxes_overlap(here, tree.nodes[at]):
                other = (at - first) * BUNCH
                for k in range(bunch * BUNCH, min(bunch * BUNCH + BUNCH, leaves)):
                    for m in range(max(k + 1, other), min(other + BUNCH, leaves)):
                        if total <= room:  # written in any case, and kept where they overlap
                            broad_phase.candidates[total, 2], broad_phase.candidates[total, 3] = (
                                k,
                                m,
                            )
                        total += 1 if boxes_overlap(tree.boxes[k], tree.boxes[m]) else 0
            while at & 1:  # up, until there is a node to the right
                at >>= 1
            if at == 0:
                break
            at += 1
    return total if total <= room else total + BUNCH * BUNCH


def boxes_overlap(one: Array, other: Array) -> bool:
    """Return whether two boxes have a common point."""
    return bool(
        (one[0] <= other[2]) & (one[2] >= other[0]) & (one[1] <= other[3]) & (one[3] >= other[1])
    )


def note_centre(
    k: int, s: int, bodies: Bodies, shapes: Shapes, tree: Tree, broad_phase: BroadPhase
) -> None:
    """Write where a shape's body is at home, and how far it is known, to the k-th row."""
    i, here = shapes.slot[s], tree.centres[k]
    more = (
        SPECULATIVE_MARGIN * bodies.properties[i, BOUNDING_RADIUS]
        if bodies.kind[i] == DYNAMIC
        else 0.0
    )
    here[CENTRE_X] = 0.5 * (broad_phase.fat_bounds[i, LOW_X] + broad_phase.fat_bounds[i, HIGH_X])
    here[CENTRE_Y] = 0.5 * (broad_phase.fat_bounds[i, LOW_Y] + broad_phase.fat_bounds[i, HIGH_Y])
    here[HALF_WIDTH] = (
        0.5 * (broad_phase.fat_bounds[i, HIGH_X] - broad_phase.fat_bounds[i, LOW_X]) + more
    )
    here[HALF_HEIGHT] = (
        0.5 * (broad_phase.fat_bounds[i, HIGH_Y] - broad_phase.fat_bounds[i, LOW_Y]) + more
    )
    here[CENTRE_RADIUS] = shapes.material[s, SHAPE_RADIUS]


def circles_apart(one: Array, other: Array) -> bool:
    """Return whether the circles of two shapes stay apart while their bodies are at home."""
    x = abs(other[CENTRE_X] - one[CENTRE_X]) - (one[HALF_WIDTH] + other[HALF_WIDTH])
    y = abs(other[CENTRE_Y] - one[CENTRE_Y]) - (one[HALF_HEIGHT] + other[HALF_HEIGHT])
    reach = one[CENTRE_RADIUS] + other[CENTRE_RADIUS]
    x, y = max(x, 0.0), max(y, 0.0)
    return bool(x * x + y * y > reach * reach)


def sides_apart(
    k: int, m: int, bodies: Bodies, shapes: Shapes, tree: Tree, broad_phase: BroadPhase
) -> bool:
    """Return whether a side of the longer of two shapes looks past the other at home."""
    if tree.centres[k, CENTRE_RADIUS] < tree.centres[m, CENTRE_RADIUS]:
        k, m = m, k
    one, other = tree.centres[k], tree.centres[m]
    s = tree.morton[LEAF, k]
    if one[CENTRE_RADIUS] < LONGER * other[CENTRE_RADIUS] or shapes.count[s] == 1:
        return False
    i = shapes.slot[s]
    x, y = other[CENTRE_X] - one[CENTRE_X], other[CENTRE_Y] - one[CENTRE_Y]
    wide = one[HALF_WIDTH] + other[HALF_WIDTH]
    high = one[HALF_HEIGHT] + other[HALF_HEIGHT]
    turn = (
        broad_phase.fat_bounds[i, ANGLE_MARGIN]
        + abs(bodies.pose[i, ANGLE] - broad_phase.fat_bounds[i, BASE_ANGLE])
        + abs(bodies.motion[i, DANGLE])
    )
    reach = other[CENTRE_RADIUS] + shapes.radius[s] + turn * (abs(x) + abs(y) + wide + high)
    for c in range(shapes.first[s], shapes.first[s] + shapes.count[s]):
        along_x, along_y = shapes.world_vertices[c, 2], shapes.world_vertices[c, 3]
        room = along_x * (x - shapes.world_vertices[c, 0]) + along_y * (
            y - shapes.world_vertices[c, 1]
        )
        if room - abs(along_x) * wide - abs(along_y) * high > reach:
            return True
    return False


def half_plane_offset(s: int, shapes: Shapes, broad_phase: BroadPhase) -> float:
    """Return how far a half-plane reaches along its normal at home, m from the origin."""
    i, first = shapes.slot[s], shapes.first[s]
    normal_x, normal_y = shapes.world_vertices[first, 2], shapes.world_vertices[first, 3]
    on_x = broad_phase.fat_bounds[i, HIGH_X] if normal_x > 0.0 else broad_phase.fat_bounds[i, LOW_X]
    on_y = broad_phase.fat_bounds[i, HIGH_Y] if normal_y > 0.0 else broad_phase.fat_bounds[i, LOW_Y]
    offset: float = shapes.world_vertices[first, 0] + normal_x * on_x + normal_y * on_y
    return offset


def reaches_half_plane(t: int, offset: float, side: Array, boxes: Array) -> bool:
    """Return whether the box of a shape reaches into a half-plane."""
    x = boxes[t, FAT] if side[2] > 0.0 else boxes[t, FAT + 2]
    y = boxes[t, FAT + 1] if side[3] > 0.0 else boxes[t, FAT + 3]
    return bool(side[2] * x + side[3] * y <= offset)


def may_collide(s: int, t: int, bodies: Bodies, shapes: Shapes) -> bool:
    """Return whether two shapes are to be looked at at all."""
    i, j = shapes.slot[s], shapes.slot[t]
    if i == j or max(bodies.kind[i], bodies.kind[j]) != DYNAMIC:
        return False
    group = shapes.filters[s, GROUP]
    if group != 0 and group == shapes.filters[t, GROUP]:
        return bool(group > 0)
    return bool(
        (shapes.filters[s, CATEGORY] & shapes.filters[t, MASK]) != 0
        and (shapes.filters[t, CATEGORY] & shapes.filters[s, MASK]) != 0
    )


def note_candidate(total: int, s: int, t: int, canonical: Integers, found: Integers) -> int:
    """Write down a pair by its ranks, the lower one first, if there is room; count it anyway."""
    if total < len(found):
        a, b = canonical[1, s], canonical[1, t]
        found[total, 0], found[total, 1] = min(a, b), max(a, b)
    return total + 1


def sort_candidates(total: int, found: Integers, starts: Integers) -> None:
    """Sort pairs by both ranks in the columns 0 and 1: by the second one, then by the first.

    There are no more ranks than shapes, so that counting puts each pair in its place.
    """
    for key in range(1, -1, -1):
        here, there = (0, 2) if key == 1 else (2, 0)
        for k in range(len(starts)):
            starts[k] = 0
        for p in range(total):
            starts[found[p, here + key] + 1] += 1
        for k in range(1, len(starts)):
            starts[k] += starts[k - 1]
        for p in range(total):
            rank = found[p, here + key]
            place = starts[rank]
            starts[rank] = place + 1
            found[place, there], found[place, there + 1] = found[p, here], found[p, here + 1]
