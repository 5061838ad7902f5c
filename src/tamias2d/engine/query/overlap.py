"""Region queries: what lies at a point or in a box, asked of the places as they are now.

Serves: the simulator, and rays, which meet no body that they start in. Hides: the tree that is
asked, which is not that of the step: users move bodies between steps. Sensors are not solid, and no
query finds them.

Cost: n log n for a tree where something moved, then log n and what is found for each question.
"""

from math import sqrt

from tamias2d.engine.broad_phase.bvh import BUNCH, build_tree, first_leaf_node
from tamias2d.engine.motion.rotation import cosine_sine
from tamias2d.engine.tables import (
    ABSENT,
    ANGLE,
    CATEGORY,
    FAT,
    HALF_PLANE,
    LEAF,
    LEAVES,
    PLANES,
    POLYGON,
    SENSOR,
    Integers,
    Shapes,
    Tree,
    World,
    X,
    Y,
)
from tamias2d.kernels.arrays import (
    Places,
)
from tamias2d.state import Array

SLACK = 1e-12  # relative: how much larger boxes are than what is in them


def build_query_tree(world: World) -> None:
    """Make the tree for all shapes where they are; half-planes stand behind its leaves."""
    state, shapes, tree, broad_phase = world.state, world.shapes, world.tree, world.broad_phase
    for s in range(len(shapes.kind)):
        i = state.body_of_shape[s]
        if state.kind[i] != ABSENT and shapes.kind[s] != HALF_PLANE:
            fit_box(s, state.pose[i], shapes, tree)
    leaves = build_tree(shapes.kind, state.body_of_shape, state.kind, broad_phase.canonical, tree)
    planes = 0
    for k in range(len(shapes.kind)):
        s = broad_phase.canonical[0, k]
        if state.kind[state.body_of_shape[s]] != ABSENT and shapes.kind[s] == HALF_PLANE:
            tree.morton[LEAF, leaves + planes] = s
            planes += 1
    tree.counts[LEAVES], tree.counts[PLANES] = leaves, planes


def fit_box(s: int, place: Array, shapes: Shapes, tree: Tree) -> None:
    """Put a box around a shape."""
    c, d = cosine_sine(place[ANGLE])
    first = shapes.first[s]
    low_x = high_x = c * shapes.local_vertices[first, 0] - d * shapes.local_vertices[first, 1]
    low_y = high_y = d * shapes.local_vertices[first, 0] + c * shapes.local_vertices[first, 1]
    for k in range(first + 1, first + shapes.count[s]):
        x, y = (
            c * shapes.local_vertices[k, 0] - d * shapes.local_vertices[k, 1],
            d * shapes.local_vertices[k, 0] + c * shapes.local_vertices[k, 1],
        )
        low_x, high_x = min(low_x, x), max(high_x, x)
        low_y, high_y = min(low_y, y), max(high_y, y)
    size = high_x - low_x + high_y - low_y + shapes.radius[s]
    more = shapes.radius[s] + SLACK * (size + abs(place[X]) + abs(place[Y]))
    tree.boxes[s, FAT], tree.boxes[s, FAT + 1] = place[X] + low_x - more, place[Y] + low_y - more
    tree.boxes[s, FAT + 2], tree.boxes[s, FAT + 3] = (
        place[X] + high_x + more,
        place[Y] + high_y + more,
    )


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
    state, shapes, tree = world.state, world.shapes, world.tree
    leaves, total = tree.counts[LEAVES], 0
    deep = first_leaf_node(leaves)
    for m in range(leaves, leaves + tree.counts[PLANES]):
        s = tree.morton[LEAF, m]
        side = shapes.local_vertices[shapes.first[s]]
        x = low_x if side[2] > 0.0 else high_x
        y = low_y if side[3] > 0.0 else high_y
        if is_asked(s, mask, shapes.filters) and x * side[2] + y * side[3] <= side[0]:
            found[total] = s
            total += 1
    at = 1 if leaves > 0 else 0
    while at > 0:
        while at < deep and meets_box(tree.nodes[at], low_x, low_y, high_x, high_y):
            at = 2 * at
        if at >= deep:
            bunch = (at - deep) * BUNCH
            for m in range(bunch, min(bunch + BUNCH, leaves)):
                s = tree.morton[LEAF, m]
                if is_asked(s, mask, shapes.filters) and meets_box(
                    tree.boxes[s, FAT:], low_x, low_y, high_x, high_y
                ):
                    place, first = state.pose[state.body_of_shape[s]], shapes.first[s]
                    corners = shapes.local_vertices[first : first + shapes.count[s]]
                    of, radius = shapes.kind[s], shapes.radius[s]
                    if overlaps_box(low_x, low_y, high_x, high_y, place, of, radius, corners):
                        found[total] = s
                        total += 1
        at = next_node(at)
    return total


def is_asked(s: int, mask: int, filters: Integers) -> bool:
    """Return whether a shape is solid, and of a category that is asked for."""
    return bool(filters[s, SENSOR] == 0 and (filters[s, CATEGORY] & mask) != 0)


def next_node(at: int) -> int:
    """Return the node of the tree that comes after all below one, or 0 after the last."""
    while at & 1:
        at >>= 1
    return at + 1 if at > 0 else 0


def meets_box(boxes: Array, low_x: float, low_y: float, high_x: float, high_y: float) -> bool:
    """Return whether two boxes overlap."""
    return bool(
        (boxes[0] <= high_x) & (boxes[2] >= low_x) & (boxes[1] <= high_y) & (boxes[3] >= low_y)
    )


def overlaps_box(
    low_x: float,
    low_y: float,
    high_x: float,
    high_y: float,
    place: Array,
    kind: int,
    radius: float,
    corners: Array,
) -> bool:
    """Return whether a shape overlaps a box of the world; touching counts.

    Convex shapes are apart if a side of one of them has all of the other beyond it.
    """
    c, d = cosine_sine(place[ANGLE])
    mid_x, mid_y = 0.5 * low_x + 0.5 * high_x - place[X], 0.5 * low_y + 0.5 * high_y - place[Y]
    half_x, half_y = 0.5 * high_x - 0.5 * low_x, 0.5 * high_y - 0.5 * low_y
    if kind == POLYGON:
        for k in range(len(corners)):
            x, y = c * corners[k, 2] - d * corners[k, 3], d * corners[k, 2] + c * corners[k, 3]
            on_x = c * corners[k, 0] - d * corners[k, 1]
            on_y = d * corners[k, 0] + c * corners[k, 1]
            height = (mid_x - on_x) * x + (mid_y - on_y) * y
            if height > half_x * abs(x) + half_y * abs(y):
                return False
        return True  # its own box has been looked at
    one_x, one_y = c * corners[0, 0] - d * corners[0, 1], d * corners[0, 0] + c * corners[0, 1]
    last = len(corners) - 1
    end_x = c * corners[last, 0] - d * corners[last, 1]
    end_y = d * corners[last, 0] + c * corners[last, 1]
    return line_reaches_box(
        one_x - mid_x, one_y - mid_y, end_x - one_x, end_y - one_y, half_x, half_y, radius
    )


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
    beside = far = False  # of the line are corners of the box
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
