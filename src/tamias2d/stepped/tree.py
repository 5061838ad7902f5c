"""A tree of boxes over all bounded shapes: who may be near whom.

Serves: the search for pairs, and queries. Hides: that the tree has no pointers. Its leaves are the
shapes along a Morton curve (Morton 1966), a few to a node of the lowest level, and the node k
holds the nodes 2k and 2k + 1.

Cost: n log n to build, log n and what is found to ask.
"""

from tamias2d.state import Array
from tamias2d.stepped.layout import ABSENT, FAT, HALF_PLANE, Whole

BUNCH = 4  # shapes under a node of the lowest level
CELLS = 65535.0  # of the curve, along each axis
FAR = 1.7976931348623157e308


def grow_tree(
    shape_kind: Whole,
    shape_body: Whole,
    kind: Whole,
    ranked: Whole,
    box: Array,
    curve: Whole,
    node: Array,
) -> int:
    """Order the bounded shapes along a curve, and put boxes around them; return how many.

    `ranked` (2, m) holds the shapes in canonical order first, `box` (m, 8) their boxes. Written are
    `curve` (5, m + 256), which holds the shapes along the curve first, and `node` (2k, 4).
    """
    order, leaf, keys = ranked[0], curve[0], curve[1]
    count = 0
    low_x, low_y, high_x, high_y = FAR, FAR, -FAR, -FAR
    for k in range(len(order)):
        s = order[k]
        if shape_kind[s] != HALF_PLANE and kind[shape_body[s]] != ABSENT:
            x = 0.5 * box[s, FAT] + 0.5 * box[s, FAT + 2]
            y = 0.5 * box[s, FAT + 1] + 0.5 * box[s, FAT + 3]
            low_x, high_x = min(low_x, x), max(high_x, x)
            low_y, high_y = min(low_y, y), max(high_y, y)
            leaf[count] = s
            count += 1
    size = max(high_x - low_x, high_y - low_y)
    scale = CELLS / size if count > 0 and size > 0.0 and size < FAR else 0.0
    for k in range(count):
        s = leaf[k]
        x = 0.5 * box[s, FAT] + 0.5 * box[s, FAT + 2]
        y = 0.5 * box[s, FAT + 1] + 0.5 * box[s, FAT + 3]
        keys[k] = spread(int((x - low_x) * scale)) | (spread(int((y - low_y) * scale)) << 1)
    sort_along(count, curve)
    enclose(count, leaf, box, node)
    return count


def spread(cell: int) -> int:
    """Return 16 bits with a zero before each."""
    cell = (cell | (cell << 8)) & 0x00FF00FF
    cell = (cell | (cell << 4)) & 0x0F0F0F0F
    cell = (cell | (cell << 2)) & 0x33333333
    return (cell | (cell << 1)) & 0x55555555


def sort_along(count: int, curve: Whole) -> None:
    """Sort the first rows by their keys, equal ones as they are: a radix sort of 32 bits."""
    bins = curve[2, curve.shape[1] - 256 :]
    for turn in range(4):
        here, there = (0, 2) if turn % 2 == 0 else (2, 0)
        shift = 8 * turn
        for k in range(256):
            bins[k] = 0
        for k in range(count):
            bins[(curve[here + 1, k] >> shift) & 255] += 1
        start = 0
        for k in range(256):
            size = bins[k]
            bins[k] = start
            start += size
        for k in range(count):
            key = curve[here + 1, k]
            place = bins[(key >> shift) & 255]
            bins[(key >> shift) & 255] = place + 1
            curve[there, place] = curve[here, k]
            curve[there + 1, place] = key


def lowest(count: int) -> int:
    """Return the first node of the lowest level of a tree of so many shapes."""
    first = 1
    while first * BUNCH < count:
        first *= 2
    return first


def enclose(count: int, leaf: Whole, box: Array, node: Array) -> None:
    """Put boxes around the shapes of each node, from the lowest level up."""
    first = lowest(count)
    for k in range(first):
        low_x, low_y, high_x, high_y = FAR, FAR, -FAR, -FAR
        for m in range(BUNCH * k, min(BUNCH * k + BUNCH, count)):
            s = leaf[m]
            low_x, high_x = min(low_x, box[s, FAT]), max(high_x, box[s, FAT + 2])
            low_y, high_y = min(low_y, box[s, FAT + 1]), max(high_y, box[s, FAT + 3])
        node[first + k, 0], node[first + k, 1] = low_x, low_y
        node[first + k, 2], node[first + k, 3] = high_x, high_y
    for k in range(first - 1, 0, -1):
        node[k, 0] = min(node[2 * k, 0], node[2 * k + 1, 0])
        node[k, 1] = min(node[2 * k, 1], node[2 * k + 1, 1])
        node[k, 2] = max(node[2 * k, 2], node[2 * k + 1, 2])
        node[k, 3] = max(node[2 * k, 3], node[2 * k + 1, 3])
