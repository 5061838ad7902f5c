"""A tree of boxes over all bounded shapes: who may be near whom.

Serves: the search for pairs, and queries. Hides: that the tree has no pointers. Its leaves are the
shapes along a Morton curve (Morton 1966), a few to a node of the lowest level, and the node k
holds the nodes 2k and 2k + 1.

Cost: n log n to build, log n and what is found to ask.
"""

from tamias2d.engine.tables import (
    ABSENT,
    FAT,
    HALF_PLANE,
    KEY,
    LEAF,
    SHAPE_OF_RANK,
    Integers,
    Tree,
)
from tamias2d.state import Array

BUNCH = 4  # shapes under a node of the lowest level
CELLS = 65535.0  # of the curve, along each axis
FAR = 1.7976931348623157e308


def build_tree(
    shape_kind: Integers, body: Integers, kind: Integers, canonical: Integers, tree: Tree
) -> int:
    """Order the bounded shapes along a curve, and put boxes around them; return how many.

    `body` (m,) is the index of each shape's body in `kind`; `canonical` (2, m) begins with the
    shapes in canonical order. The fat boxes of the shapes are given, the rest of the tree is
    written.
    """
    order, leaf, keys = canonical[SHAPE_OF_RANK], tree.morton[LEAF], tree.morton[KEY]
    count = 0
    low_x, low_y, high_x, high_y = FAR, FAR, -FAR, -FAR
    for k in range(len(order)):
        s = order[k]
        if shape_kind[s] != HALF_PLANE and kind[body[s]] != ABSENT:
            x = 0.5 * tree.boxes[s, FAT] + 0.5 * tree.boxes[s, FAT + 2]
            y = 0.5 * tree.boxes[s, FAT + 1] + 0.5 * tree.boxes[s, FAT + 3]
            low_x, high_x = min(low_x, x), max(high_x, x)
            low_y, high_y = min(low_y, y), max(high_y, y)
            leaf[count] = s
            count += 1
    size = max(high_x - low_x, high_y - low_y)
    scale = CELLS / size if count > 0 and size > 0.0 and size < FAR else 0.0
    for k in range(count):
        s = leaf[k]
        x = 0.5 * tree.boxes[s, FAT] + 0.5 * tree.boxes[s, FAT + 2]
        y = 0.5 * tree.boxes[s, FAT + 1] + 0.5 * tree.boxes[s, FAT + 3]
        keys[k] = spread_bits(int((x - low_x) * scale)) | (
            spread_bits(int((y - low_y) * scale)) << 1
        )
    radix_sort(count, tree)
    fit_nodes(count, leaf, tree.boxes, tree.nodes)
    return count


def spread_bits(cell: int) -> int:
    """Return 16 bits with a zero before each."""
    cell = (cell | (cell << 8)) & 0x00FF00FF
    cell = (cell | (cell << 4)) & 0x0F0F0F0F
    cell = (cell | (cell << 2)) & 0x33333333
    return (cell | (cell << 1)) & 0x55555555


def radix_sort(count: int, tree: Tree) -> None:
    """Sort the first rows by their keys, equal ones as they are: a radix sort of 32 bits."""
    bins = tree.morton[2, tree.morton.shape[1] - 256 :]
    for turn in range(4):
        here, there = (0, 2) if turn % 2 == 0 else (2, 0)
        shift = 8 * turn
        for k in range(256):
            bins[k] = 0
        for k in range(count):
            bins[(tree.morton[here + 1, k] >> shift) & 255] += 1
        start = 0
        for k in range(256):
            size = bins[k]
            bins[k] = start
            start += size
        for k in range(count):
            key = tree.morton[here + 1, k]
            place = bins[(key >> shift) & 255]
            bins[(key >> shift) & 255] = place + 1
            tree.morton[there, place] = tree.morton[here, k]
            tree.morton[there + 1, place] = key


def first_leaf_node(count: int) -> int:
    """Return the first node of the lowest level of a tree of so many shapes."""
    first = 1
    while first * BUNCH < count:
        first *= 2
    return first


def fit_nodes(count: int, leaf: Integers, boxes: Array, nodes: Array) -> None:
    """Put boxes around the shapes of each node, from the lowest level up."""
    first = first_leaf_node(count)
    for k in range(first):
        low_x, low_y, high_x, high_y = FAR, FAR, -FAR, -FAR
        for m in range(BUNCH * k, min(BUNCH * k + BUNCH, count)):
            s = leaf[m]
            low_x, high_x = min(low_x, boxes[s, FAT]), max(high_x, boxes[s, FAT + 2])
            low_y, high_y = min(low_y, boxes[s, FAT + 1]), max(high_y, boxes[s, FAT + 3])
        nodes[first + k, 0], nodes[first + k, 1] = low_x, low_y
        nodes[first + k, 2], nodes[first + k, 3] = high_x, high_y
    for k in range(first - 1, 0, -1):
        nodes[k, 0] = min(nodes[2 * k, 0], nodes[2 * k + 1, 0])
        nodes[k, 1] = min(nodes[2 * k, 1], nodes[2 * k + 1, 1])
        nodes[k, 2] = max(nodes[2 * k, 2], nodes[2 * k + 1, 2])
        nodes[k, 3] = max(nodes[2 * k, 3], nodes[2 * k + 1, 3])
