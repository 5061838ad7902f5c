"""The list of pairs mended: only those look around who have left their rooms.

Serves: the look around. Hides: the tree, whose boxes grow with those that have new rooms, until all
look around again. That is cheap where a few of many move unlike what was foreseen.
"""

from tamias2d.engine.broad_phase.bvh import BUNCH, first_leaf_node
from tamias2d.engine.broad_phase.candidates import (
    boxes_overlap,
    circles_apart,
    fatten_box,
    half_plane_offset,
    may_collide,
    note_candidate,
    note_centre,
    reaches_half_plane,
    sides_apart,
    sort_candidates,
)
from tamias2d.engine.broad_phase.contact_list import add_contacts, current_contacts
from tamias2d.engine.broad_phase.fat_bounds import fatten_bounds, mean_radius
from tamias2d.engine.broad_phase.vertices import turn_shape
from tamias2d.engine.tables import (
    ABSENT,
    FAT,
    HALF_PLANE,
    HORIZON,
    LEAF,
    LEAVES,
    TIME_STEP,
    UPDATED,
    Bodies,
    BroadPhase,
    ContactBuffers,
    Control,
    Shapes,
    Touching,
    Tree,
)
from tamias2d.state import Array


def update_incrementally(
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    tree: Tree,
    broad_phase: BroadPhase,
    buffers: ContactBuffers,
    touching: Touching,
) -> bool:
    """Give marked bodies new rooms, and add their pairs; return whether there was room for all.

    `used` (n+1,) holds the marks, and is zero in the end.
    """
    fatten_left_bounds(control, bodies, broad_phase)
    for s in range(len(shapes.slot)):
        if broad_phase.left[shapes.slot[s]] == 1:
            turn_shape(s, bodies, shapes)
            fatten_box(s, bodies, shapes, tree, broad_phase)
            if shapes.kind[s] != HALF_PLANE:
                refit(tree.leaf_of_shape[s], s, tree.counts[LEAVES], tree.boxes, tree.nodes)
                note_centre(tree.leaf_of_shape[s], s, bodies, shapes, tree, broad_phase)
    total = 0
    for s in range(len(shapes.slot)):
        if shapes.kind[s] == HALF_PLANE:
            total = find_beside_half_plane(total, s, bodies, shapes, tree, broad_phase)
        elif broad_phase.left[shapes.slot[s]] == 1:
            total = find_near(total, s, tree.counts[LEAVES], bodies, shapes, tree, broad_phase)
    for i in range(len(broad_phase.left)):
        broad_phase.left[i] = 0
    if total > len(broad_phase.candidates):
        return False
    sort_candidates(total, broad_phase.candidates, broad_phase.rank_counts)
    contacts = current_contacts(broad_phase, buffers)
    return add_contacts(total, shapes, broad_phase, contacts, touching)


def fatten_left_bounds(control: Control, bodies: Bodies, broad_phase: BroadPhase) -> None:
    """Give marked bodies new rooms."""
    mean = mean_radius(bodies.kind, bodies.properties)
    ahead = broad_phase.counts[HORIZON] * control.settings[TIME_STEP]
    for i in range(len(bodies.kind)):
        if broad_phase.left[i] == 1:
            fatten_bounds(i, mean, bodies, broad_phase, ahead)
            broad_phase.counts[UPDATED] += 1


def refit(leaf: int, s: int, leaves: int, boxes: Array, nodes: Array) -> None:
    """Let a leaf have the box of its shape, and the nodes above it be large enough."""
    for n in range(4):
        boxes[leaf, n] = boxes[s, FAT + n]
    at = first_leaf_node(leaves) + leaf // BUNCH
    while at > 0:
        nodes[at, 0], nodes[at, 1] = (
            min(nodes[at, 0], boxes[leaf, 0]),
            min(nodes[at, 1], boxes[leaf, 1]),
        )
        nodes[at, 2], nodes[at, 3] = (
            max(nodes[at, 2], boxes[leaf, 2]),
            max(nodes[at, 3], boxes[leaf, 3]),
        )
        at >>= 1


def find_near(
    total: int,
    s: int,
    leaves: int,
    bodies: Bodies,
    shapes: Shapes,
    tree: Tree,
    broad_phase: BroadPhase,
) -> int:
    """Note the bounded shapes that one may meet; of two that both look, the later one does."""
    k = tree.leaf_of_shape[s]
    here = tree.boxes[k]
    first = first_leaf_node(leaves)
    at = 1
    while True:
        while at < first and boxes_overlap(here, tree.nodes[at]):
            at = 2 * at
        if at >= first and boxes_overlap(here, tree.nodes[at]):
            start = (at - first) * BUNCH
            for m in range(start, min(start + BUNCH, leaves)):
                t = tree.morton[LEAF, m]
                if (
                    boxes_overlap(here, tree.boxes[m])
                    and (broad_phase.left[shapes.slot[t]] == 0 or t < s)
                    and not circles_apart(tree.centres[k], tree.centres[m])
                    and may_collide(s, t, bodies, shapes)
                    and not sides_apart(k, m, bodies, shapes, tree, broad_phase)
                ):
                    total = note_candidate(
                        total, s, t, broad_phase.canonical, broad_phase.candidates
                    )
        while at & 1:  # up, until there is a node to the right
            at >>= 1
        if at == 0:
            return total
        at += 1


def find_beside_half_plane(
    total: int, s: int, bodies: Bodies, shapes: Shapes, tree: Tree, broad_phase: BroadPhase
) -> int:
    """Note the shapes that may meet a half-plane, if they have left, or it has."""
    i = shapes.slot[s]
    if bodies.kind[i] == ABSENT:
        return total
    offset = half_plane_offset(s, shapes, broad_phase)
    side = shapes.world_vertices[shapes.first[s]]
    for t in range(len(shapes.slot)):
        j = shapes.slot[t]
        if (
            broad_phase.left[i] + broad_phase.left[j] > 0
            and shapes.kind[t] != HALF_PLANE
            and bodies.kind[j] != ABSENT
            and reaches_half_plane(t, offset, side, tree.boxes)
            and may_collide(s, t, bodies, shapes)
        ):
            total = note_candidate(total, s, t, broad_phase.canonical, broad_phase.candidates)
    return total
