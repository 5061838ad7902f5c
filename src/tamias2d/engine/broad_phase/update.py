"""The contact list updated: only bodies that left their bounds get new ones, and are asked about.

The boxes of the tree grow with them until the list is rebuilt. This is cheap where a few of many
bodies move unlike what was foreseen. Cost: log n for each of their shapes, and a pass over shapes.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.broad_phase.bvh import BUNCH, first_leaf_node
from tamias2d.engine.broad_phase.candidates import (
    boxes_overlap,
    may_collide,
    note_candidate,
    note_if_near,
    sort_candidates,
)
from tamias2d.engine.broad_phase.contact_list import add_contacts, current_contacts
from tamias2d.engine.broad_phase.fat_bounds import fatten_bounds, mean_radius
from tamias2d.engine.broad_phase.fat_box import (
    fatten_box,
    half_plane_offset,
    note_centre,
    reaches_half_plane,
)
from tamias2d.engine.broad_phase.kept_apart import without_kept_apart
from tamias2d.engine.broad_phase.vertices import turn_shape
from tamias2d.engine.tables import Bodies, BroadPhase, Control, Shapes, Tree, World


def update_incrementally(world: World) -> bool:
    """Fatten the bodies that are marked as `left`, and add their contacts; unmark them.

    Returns whether there was room for all contacts.
    """
    bodies, shapes, tree, broad_phase = world.bodies, world.shapes, world.tree, world.broad_phase
    fatten_left_bounds(world.control, bodies, broad_phase)
    for s in range(len(shapes.slot)):
        if broad_phase.left[shapes.slot[s]] == 1:
            turn_shape(s, bodies, shapes)
            fatten_box(s, bodies, shapes, tree, broad_phase)
            if shapes.kind[s] != tb.HALF_PLANE:
                refit(tree.leaf_of_shape[s], s, tree)
                note_centre(tree.leaf_of_shape[s], s, bodies, shapes, tree, broad_phase)
    total = 0
    for s in range(len(shapes.slot)):
        if shapes.kind[s] == tb.HALF_PLANE:
            total = find_left_beside(total, s, bodies, shapes, tree, broad_phase)
        elif broad_phase.left[shapes.slot[s]] == 1:
            total = find_near(total, s, bodies, shapes, tree, broad_phase)
    for i in range(len(broad_phase.left)):
        broad_phase.left[i] = 0
    total = without_kept_apart(total, world.state, broad_phase, world.joints)
    if total > len(broad_phase.candidates):
        return False
    sort_candidates(total, broad_phase)
    contacts = current_contacts(broad_phase, world.buffers)
    in_parts = world.control.counts[tb.LEVEL] > 0
    return add_contacts(total, in_parts, shapes, broad_phase, contacts, world.touching)


def fatten_left_bounds(control: Control, bodies: Bodies, broad_phase: BroadPhase) -> None:
    """Give the bodies that left their bounds new ones."""
    mean = mean_radius(bodies.kind, bodies.properties)
    ahead = broad_phase.counts[tb.HORIZON] * control.progress[tb.PART_TIME]
    for i in range(len(bodies.kind)):
        if broad_phase.left[i] == 1:
            fatten_bounds(i, mean, bodies, broad_phase, ahead)
            broad_phase.counts[tb.UPDATED] += 1


def refit(leaf: int, s: int, tree: Tree) -> None:
    """Give a leaf the box of its shape, and let the nodes above it contain that."""
    boxes, nodes = tree.boxes, tree.nodes
    for n in range(4):
        boxes[leaf, n] = boxes[s, tb.FAT + n]
    at = first_leaf_node(tree.counts[tb.LEAVES]) + leaf // BUNCH
    while at > 0:
        for n in range(2):
            nodes[at, n] = min(nodes[at, n], boxes[leaf, n])
            nodes[at, n + 2] = max(nodes[at, n + 2], boxes[leaf, n + 2])
        at >>= 1


def find_near(
    total: int, s: int, bodies: Bodies, shapes: Shapes, tree: Tree, broad_phase: BroadPhase
) -> int:
    """Note the bounded shapes that may touch one of a body that left; return how many in all.

    Of two such shapes the later one notes the pair.
    """
    k, leaves = tree.leaf_of_shape[s], tree.counts[tb.LEAVES]
    box = tree.boxes[k]
    first = first_leaf_node(leaves)
    at = 1
    while True:
        while at < first and boxes_overlap(box, tree.nodes[at]):
            at = 2 * at
        if at >= first and boxes_overlap(box, tree.nodes[at]):
            start = (at - first) * BUNCH
            for m in range(start, min(start + BUNCH, leaves)):
                t = tree.morton[tb.LEAF, m]
                is_noted_here = broad_phase.left[shapes.slot[t]] == 0 or t < s
                if is_noted_here and boxes_overlap(box, tree.boxes[m]):
                    total = note_if_near(total, k, m, bodies, shapes, tree, broad_phase)
        while at & 1:  # up, until there is a node to the right
            at >>= 1
        if at == 0:
            return total
        at += 1


def find_left_beside(
    total: int, s: int, bodies: Bodies, shapes: Shapes, tree: Tree, broad_phase: BroadPhase
) -> int:
    """Note the shapes that may touch a half-plane, if either body left; return how many in all."""
    i = shapes.slot[s]
    if bodies.kind[i] == tb.ABSENT:
        return total
    offset = half_plane_offset(s, shapes, broad_phase)
    side = shapes.world_vertices[shapes.first[s]]
    for t in range(len(shapes.slot)):
        j = shapes.slot[t]
        if (
            broad_phase.left[i] + broad_phase.left[j] > 0
            and shapes.kind[t] != tb.HALF_PLANE
            and bodies.kind[j] != tb.ABSENT
            and reaches_half_plane(t, offset, side, tree.boxes)
            and may_collide(s, t, bodies, shapes)
        ):
            total = note_candidate(total, s, t, broad_phase)
    return total
