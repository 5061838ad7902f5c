"""Region queries: what lies at a point or in a box, asked of the places as they are now.

Serves: the simulator, and rays, which meet no body that they start in. Hides: the tree that is
asked, which is not that of the step: users move bodies between steps. Sensors are not solid, and no
query finds them.

Cost: n log n for a tree where something moved, then log n and what is found for each question.
"""

from math import sqrt

from tamias2d.kernels.arrays import (
    Bytes,
    FloatRows,
    Floats,
    Indices,
    PlaceRows,
    Places,
    RankRows,
    Ranks,
)
from tamias2d.state import Array
from tamias2d.stepped.layout import (
    ABSENT,
    CATEGORY,
    FAT,
    HALF_PLANE,
    POLYGON,
    SENSOR,
    TURN,
    Whole,
    X,
    Y,
)
from tamias2d.stepped.rotation import cosine_sine
from tamias2d.stepped.tree import BUNCH, grow_tree, lowest

SLACK = 1e-12  # relative: how much larger boxes are than what is in them


def survey(
    kind: Bytes,
    pose: FloatRows,
    ranked: PlaceRows,
    shape_body: Places,
    shape_kind: Indices,
    shape_first: Indices,
    shape_count: Indices,
    shape_radius: Floats,
    corner: FloatRows,
    box: FloatRows,
    curve: PlaceRows,
    node: FloatRows,
    sizes: Ranks,
) -> None:
    """Make the tree for all shapes where they are; half-planes stand behind its leaves.

    `sizes` (2,) are the numbers of both.
    """
    for s in range(len(shape_kind)):
        i = shape_body[s]
        if kind[i] != ABSENT and shape_kind[s] != HALF_PLANE:
            enclose_shape(s, pose[i], shape_first, shape_count, shape_radius, corner, box)
    leaves = grow_tree(shape_kind, shape_body, kind, ranked, box, curve, node)
    planes = 0
    for k in range(len(shape_kind)):
        s = ranked[0, k]
        if kind[shape_body[s]] != ABSENT and shape_kind[s] == HALF_PLANE:
            curve[0, leaves + planes] = s
            planes += 1
    sizes[0], sizes[1] = leaves, planes


def enclose_shape(
    s: int,
    place: Array,
    shape_first: Whole,
    shape_count: Whole,
    shape_radius: Array,
    corner: Array,
    box: Array,
) -> None:
    """Put a box around a shape."""
    c, d = cosine_sine(place[TURN])
    first = shape_first[s]
    low_x = high_x = c * corner[first, 0] - d * corner[first, 1]
    low_y = high_y = d * corner[first, 0] + c * corner[first, 1]
    for k in range(first + 1, first + shape_count[s]):
        x, y = c * corner[k, 0] - d * corner[k, 1], d * corner[k, 0] + c * corner[k, 1]
        low_x, high_x = min(low_x, x), max(high_x, x)
        low_y, high_y = min(low_y, y), max(high_y, y)
    size = high_x - low_x + high_y - low_y + shape_radius[s]
    more = shape_radius[s] + SLACK * (size + abs(place[X]) + abs(place[Y]))
    box[s, FAT], box[s, FAT + 1] = place[X] + low_x - more, place[Y] + low_y - more
    box[s, FAT + 2], box[s, FAT + 3] = place[X] + high_x + more, place[Y] + high_y + more


def gather(
    low_x: float,
    low_y: float,
    high_x: float,
    high_y: float,
    mask: int,
    pose: FloatRows,
    shape_body: Places,
    shape_kind: Indices,
    shape_first: Indices,
    shape_count: Indices,
    shape_radius: Floats,
    filters: RankRows,
    corner: FloatRows,
    box: FloatRows,
    curve: PlaceRows,
    node: FloatRows,
    sizes: Ranks,
    found: Places,
) -> int:
    """Write the shapes that overlap a box, which may be a point, into `found`; return how many."""
    leaves, total = sizes[0], 0
    deep = lowest(leaves)
    for m in range(leaves, leaves + sizes[1]):
        s = curve[0, m]
        side = corner[shape_first[s]]
        x = low_x if side[2] > 0.0 else high_x
        y = low_y if side[3] > 0.0 else high_y
        if is_asked(s, mask, filters) and x * side[2] + y * side[3] <= side[0]:
            found[total] = s
            total += 1
    at = 1 if leaves > 0 else 0
    while at > 0:
        while at < deep and meets_box(node[at], low_x, low_y, high_x, high_y):
            at = 2 * at
        if at >= deep:
            bunch = (at - deep) * BUNCH
            for m in range(bunch, min(bunch + BUNCH, leaves)):
                s = curve[0, m]
                if is_asked(s, mask, filters) and meets_box(
                    box[s, FAT:], low_x, low_y, high_x, high_y
                ):
                    place, first = pose[shape_body[s]], shape_first[s]
                    corners = corner[first : first + shape_count[s]]
                    of, radius = shape_kind[s], shape_radius[s]
                    if overlaps(low_x, low_y, high_x, high_y, place, of, radius, corners):
                        found[total] = s
                        total += 1
        at = next_node(at)
    return total


def is_asked(s: int, mask: int, filters: Whole) -> bool:
    """Return whether a shape is solid, and of a category that is asked for."""
    return bool(filters[s, SENSOR] == 0 and (filters[s, CATEGORY] & mask) != 0)


def next_node(at: int) -> int:
    """Return the node of the tree that comes after all below one, or 0 after the last."""
    while at & 1:
        at >>= 1
    return at + 1 if at > 0 else 0


def meets_box(box: Array, low_x: float, low_y: float, high_x: float, high_y: float) -> bool:
    """Return whether two boxes overlap."""
    return bool((box[0] <= high_x) & (box[2] >= low_x) & (box[1] <= high_y) & (box[3] >= low_y))


def overlaps(
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
    c, d = cosine_sine(place[TURN])
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
    return reaches(
        one_x - mid_x, one_y - mid_y, end_x - one_x, end_y - one_y, half_x, half_y, radius
    )


def reaches(
    x: float, y: float, by_x: float, by_y: float, half_x: float, half_y: float, radius: float
) -> bool:
    """Return whether a line from a point comes as near as a radius to a box around the origin."""
    if outside(x, y, half_x, half_y) <= radius:
        return True
    if outside(x + by_x, y + by_y, half_x, half_y) <= radius:
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


def outside(x: float, y: float, half_x: float, half_y: float) -> float:
    """Return the distance of a point to a box around the origin."""
    x, y = max(abs(x) - half_x, 0.0), max(abs(y) - half_y, 0.0)
    return sqrt(x * x + y * y)
