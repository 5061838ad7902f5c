"""Region queries: the shapes at a point or in a box, with bodies where they are now.

Users move bodies between steps, so that queries have a tree of their own. Sensors are not solid,
and no query finds them.

Cost: n log n for a tree where something moved, then log n and the shapes found for each query.
"""

from math import sqrt
from typing import NamedTuple

from tamias2d.engine import tables as tb
from tamias2d.engine.broad_phase.bvh import BUNCH, build_tree, first_leaf_node
from tamias2d.engine.rotation import cosine_sine
from tamias2d.engine.tables import BodyState, Integers, Shapes, Tree, World
from tamias2d.kernels.arrays import Places
from tamias2d.state import Array

SLACK = 1e-12  # by which boxes are larger than their shapes, of their sizes and places


def build_query_tree(world: World) -> None:
    """Build the tree of all shapes where they are; half-planes stand behind its leaves."""
    state, shapes, tree, broad_phase = world.state, world.shapes, world.tree, world.broad_phase
    for s in range(len(shapes.kind)):
        i = state.body_of_shape[s]
        if state.kind[i] != tb.ABSENT and shapes.kind[s] != tb.HALF_PLANE:
            fit_box(s, state.pose[i], shapes, tree)
    leaves = build_tree(shapes.kind, state.body_of_shape, state.kind, broad_phase.canonical, tree)
    planes = 0
    for k in range(len(shapes.kind)):
        s = broad_phase.canonical[0, k]
        if state.kind[state.body_of_shape[s]] != tb.ABSENT and shapes.kind[s] == tb.HALF_PLANE:
            tree.morton[tb.LEAF, leaves + planes] = s
            planes += 1
    tree.counts[tb.LEAVES], tree.counts[tb.PLANES] = leaves, planes


def fit_box(s: int, pose: Array, shapes: Shapes, tree: Tree) -> None:
    """Put a box around a shape of a body with a pose."""
    c, d = cosine_sine(pose[tb.ANGLE])
    first, local = shapes.first[s], shapes.local_vertices
    low_x = high_x = c * local[first, 0] - d * local[first, 1]
    low_y = high_y = d * local[first, 0] + c * local[first, 1]
    for k in range(first + 1, first + shapes.vertex_count[s]):
        x, y = c * local[k, 0] - d * local[k, 1], d * local[k, 0] + c * local[k, 1]
        low_x, high_x = min(low_x, x), max(high_x, x)
        low_y, high_y = min(low_y, y), max(high_y, y)
    size = high_x - low_x + high_y - low_y + shapes.radius[s]
    more = shapes.radius[s] + SLACK * (size + abs(pose[tb.X]) + abs(pose[tb.Y]))
    tree.boxes[s, tb.FAT], tree.boxes[s, tb.FAT + 1] = (
        pose[tb.X] + low_x - more,
        pose[tb.Y] + low_y - more,
    )
    tree.boxes[s, tb.FAT + 2] = pose[tb.X] + high_x + more
    tree.boxes[s, tb.FAT + 3] = pose[tb.Y] + high_y + more


class Box(NamedTuple):
    """A box of the world, which may be a point, m."""

    low_x: float
    low_y: float
    high_x: float
    high_y: float


def shapes_in_box(
    world: World,
    low_x: float,
    low_y: float,
    high_x: float,
    high_y: float,
    mask: int,
    found: Places,
) -> int:
    """Write the shapes that overlap a box, which may be a point, into `found`; return how many."""
    shapes, tree = world.shapes, world.tree
    box = Box(low_x, low_y, high_x, high_y)
    leaves = tree.counts[tb.LEAVES]
    total = half_planes_in_box(box, mask, world.state, shapes, tree, found)
    deep = first_leaf_node(leaves)
    at = 1 if leaves > 0 else 0
    while at > 0:
        while at < deep and meets_box(tree.nodes[at], box):
            at = 2 * at
        if at >= deep:
            bunch = (at - deep) * BUNCH
            for m in range(bunch, min(bunch + BUNCH, leaves)):
                s = tree.morton[tb.LEAF, m]
                near = is_selected(s, mask, shapes.filters) and meets_box(
                    tree.boxes[s, tb.FAT :], box
                )
                if near and overlaps_box(s, box, world.state, shapes):
                    found[total] = s
                    total += 1
        at = next_node(at)
    return total


def side_of_half_plane(s: int, state: BodyState, shapes: Shapes) -> tuple[float, float, float]:
    """Return the offset, m, and the normal of a half-plane where its body is."""
    side, pose = shapes.local_vertices[shapes.first[s]], state.pose[state.body_of_shape[s]]
    c, d = cosine_sine(pose[tb.ANGLE])
    nx, ny = c * side[2] - d * side[3], d * side[2] + c * side[3]
    return side[0] + nx * pose[tb.X] + ny * pose[tb.Y], nx, ny


def half_planes_in_box(
    box: Box, mask: int, state: BodyState, shapes: Shapes, tree: Tree, found: Integers
) -> int:
    """Write the half-planes that overlap a box into `found`; return how many."""
    leaves, total = tree.counts[tb.LEAVES], 0
    for m in range(leaves, leaves + tree.counts[tb.PLANES]):
        s = tree.morton[tb.LEAF, m]
        offset, nx, ny = side_of_half_plane(s, state, shapes)
        x = box.low_x if nx > 0.0 else box.high_x
        y = box.low_y if ny > 0.0 else box.high_y
        if is_selected(s, mask, shapes.filters) and x * nx + y * ny <= offset:
            found[total] = s
            total += 1
    return total


def is_selected(s: int, mask: int, filters: Integers) -> bool:
    """Return whether a shape is solid, and of a category in the mask."""
    return bool(filters[s, tb.SENSOR] == 0 and (filters[s, tb.CATEGORY] & mask) != 0)


def next_node(at: int) -> int:
    """Return the node of the tree that comes after all below one, or 0 after the last."""
    while at & 1:
        at >>= 1
    return at + 1 if at > 0 else 0


def meets_box(bounds: Array, box: Box) -> bool:
    """Return whether two boxes overlap."""
    return bool(
        (bounds[0] <= box.high_x)
        & (bounds[2] >= box.low_x)
        & (bounds[1] <= box.high_y)
        & (bounds[3] >= box.low_y)
    )


def overlaps_box(s: int, box: Box, state: BodyState, shapes: Shapes) -> bool:
    """Return whether a shape that is not a half-plane overlaps a box; touching counts.

    The box around the shape overlaps it.
    """
    i, first, count = state.body_of_shape[s], shapes.first[s], shapes.vertex_count[s]
    vertices = shapes.local_vertices[first : first + count]
    c, d = cosine_sine(state.pose[i, tb.ANGLE])
    x = 0.5 * box.low_x + 0.5 * box.high_x - state.pose[i, tb.X]
    y = 0.5 * box.low_y + 0.5 * box.high_y - state.pose[i, tb.Y]
    half_x, half_y = 0.5 * box.high_x - 0.5 * box.low_x, 0.5 * box.high_y - 0.5 * box.low_y
    if shapes.vertex_count[s] > 2:
        return not some_side_separates(vertices, c, d, x, y, half_x, half_y)
    last = len(vertices) - 1
    one_x = c * vertices[0, 0] - d * vertices[0, 1]
    one_y = d * vertices[0, 0] + c * vertices[0, 1]
    end_x = c * vertices[last, 0] - d * vertices[last, 1]
    end_y = d * vertices[last, 0] + c * vertices[last, 1]
    return line_reaches_box(
        one_x - x, one_y - y, end_x - one_x, end_y - one_y, half_x, half_y, shapes.radius[s]
    )


def some_side_separates(
    vertices: Array, c: float, d: float, x: float, y: float, half_x: float, half_y: float
) -> bool:
    """Return whether a side of a polygon, turned by an angle, has all of a box in front of it.

    The centre of the box is at (x, y) from the body's; c and d are the cosine and the sine.
    """
    for k in range(len(vertices)):
        vx, vy = vertices[k, 0], vertices[k, 1]
        nx, ny = c * vertices[k, 2] - d * vertices[k, 3], d * vertices[k, 2] + c * vertices[k, 3]
        height = (x - (c * vx - d * vy)) * nx + (y - (d * vx + c * vy)) * ny
        if height > half_x * abs(nx) + half_y * abs(ny):
            return True
    return False


def line_reaches_box(
    x: float, y: float, by_x: float, by_y: float, half_x: float, half_y: float, radius: float
) -> bool:
    """Return whether a line from a point comes as near as a radius to a box around the origin."""
    if distance_to_box(x, y, half_x, half_y) <= radius:
        return True
    if distance_to_box(x + by_x, y + by_y, half_x, half_y) <= radius:
        return True
    size = by_x * by_x + by_y * by_y
    if size == 0.0:
        return False
    beside = far = False  # of the line are vertices of the box
    for k in range(4):
        to_x = (half_x if k % 2 else -half_x) - x
        to_y = (half_y if k // 2 else -half_y) - y
        share = (to_x * by_x + to_y * by_y) / size
        aside = by_x * to_y - by_y * to_x
        beside = beside or aside >= 0.0
        far = far or aside <= 0.0
        if 0.0 <= share <= 1.0 and aside * aside <= radius * radius * size:
            return True
    crossing = beside and far
    left, right = min(x, x + by_x), max(x, x + by_x)
    down, up = min(y, y + by_y), max(y, y + by_y)
    return crossing and left <= half_x and right >= -half_x and down <= half_y and up >= -half_y


def distance_to_box(x: float, y: float, half_x: float, half_y: float) -> float:
    """Return the distance of a point to a box around the origin."""
    x, y = max(abs(x) - half_x, 0.0), max(abs(y) - half_y, 0.0)
    return sqrt(x * x + y * y)
