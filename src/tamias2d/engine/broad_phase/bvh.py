"""A bounding volume hierarchy over all bounded shapes, without pointers.

Its leaves are the shapes in Morton order, `BUNCH` of them to a node of the lowest level; node k
holds the nodes 2k and 2k + 1. Cost: n log n to build, log n and the answers to ask.
Source: Morton (1966).
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Integers, Tree
from tamias2d.state import Array, Vector

BUNCH = 4  # shapes under a node of the lowest level
CELLS = 65535.0  # of the Morton grid, along each axis
BINS = 256  # of a pass of the radix sort: 8 of 32 bits
FAR = 1.7976931348623157e308


def build_tree(
    shape_kind: Integers, body: Integers, kind: Integers, canonical: Integers, tree: Tree
) -> int:
    """Build the tree over the fat boxes of the bounded shapes; return how many these are.

    `body` (m,) is the index of each shape's body in `kind`; `canonical` (2, m) begins with the
    shapes in canonical order.
    """
    order, leaf, keys, boxes = (
        canonical[tb.SHAPE_OF_RANK],
        tree.morton[tb.LEAF],
        tree.morton[tb.KEY],
        tree.boxes,
    )
    count = 0
    low_x, low_y, high_x, high_y = FAR, FAR, -FAR, -FAR
    for k in range(len(order)):
        s = order[k]
        if shape_kind[s] != tb.HALF_PLANE and kind[body[s]] != tb.ABSENT:
            x, y = box_centre(s, boxes)
            low_x, high_x = min(low_x, x), max(high_x, x)
            low_y, high_y = min(low_y, y), max(high_y, y)
            leaf[count] = s
            count += 1
    extent = max(high_x - low_x, high_y - low_y)
    scale = CELLS / extent if count > 0 and extent > 0.0 and extent < FAR else 0.0
    for k in range(count):
        x, y = box_centre(leaf[k], boxes)
        column, row = int((x - low_x) * scale), int((y - low_y) * scale)
        keys[k] = spread_bits(column) | (spread_bits(row) << 1)
    radix_sort(count, tree)
    fit_nodes(count, leaf, boxes, tree.nodes)
    return count


def box_centre(s: int, boxes: Array) -> Vector:
    """Return the centre of the fat box of a shape."""
    x = 0.5 * boxes[s, tb.FAT] + 0.5 * boxes[s, tb.FAT + 2]
    y = 0.5 * boxes[s, tb.FAT + 1] + 0.5 * boxes[s, tb.FAT + 3]
    return x, y


def spread_bits(cell: int) -> int:
    """Return 16 bits with a zero before each."""
    cell = (cell | (cell << 8)) & 0x00FF00FF
    cell = (cell | (cell << 4)) & 0x0F0F0F0F
    cell = (cell | (cell << 2)) & 0x33333333
    return (cell | (cell << 1)) & 0x55555555


def radix_sort(count: int, tree: Tree) -> None:
    """Sort the leaves by their keys of 32 bits, those with equal keys as they are."""
    for shift in (0, 16):
        radix_pass(count, shift, tree.morton, tree.sorting, tree.bins)
        radix_pass(count, shift + 8, tree.sorting, tree.morton, tree.bins)


def radix_pass(count: int, shift: int, source: Integers, target: Integers, bins: Integers) -> None:
    """Sort by the eight bits of the keys from `shift` on."""
    for k in range(BINS):
        bins[k] = 0
    for k in range(count):
        bins[(source[tb.KEY, k] >> shift) & (BINS - 1)] += 1
    start = 0
    for k in range(BINS):
        size = bins[k]
        bins[k] = start
        start += size
    for k in range(count):
        key = source[tb.KEY, k]
        place = bins[(key >> shift) & (BINS - 1)]
        bins[(key >> shift) & (BINS - 1)] = place + 1
        target[tb.LEAF, place], target[tb.KEY, place] = source[tb.LEAF, k], key


def first_leaf_node(count: int) -> int:
    """Return the first node of the lowest level of a tree of so many shapes."""
    first = 1
    while first * BUNCH < count:
        first *= 2
    return first


def fit_nodes(count: int, leaf: Integers, boxes: Array, nodes: Array) -> None:
    """Fit the box of each node around its shapes, from the lowest level up."""
    first = first_leaf_node(count)
    for k in range(first):
        low_x, low_y, high_x, high_y = FAR, FAR, -FAR, -FAR
        for m in range(BUNCH * k, min(BUNCH * k + BUNCH, count)):
            s = leaf[m]
            low_x, high_x = min(low_x, boxes[s, tb.FAT]), max(high_x, boxes[s, tb.FAT + 2])
            low_y, high_y = min(low_y, boxes[s, tb.FAT + 1]), max(high_y, boxes[s, tb.FAT + 3])
        nodes[first + k, 0], nodes[first + k, 1] = low_x, low_y
        nodes[first + k, 2], nodes[first + k, 3] = high_x, high_y
    for k in range(first - 1, 0, -1):
        nodes[k, 0] = min(nodes[2 * k, 0], nodes[2 * k + 1, 0])
        nodes[k, 1] = min(nodes[2 * k, 1], nodes[2 * k + 1, 1])
        nodes[k, 2] = max(nodes[2 * k, 2], nodes[2 * k + 1, 2])
        nodes[k, 3] = max(nodes[2 * k, 3], nodes[2 * k + 1, 3])
