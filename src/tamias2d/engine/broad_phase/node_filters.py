"""What the filters of the shapes under a node of the tree have in common.

Shapes that filters keep apart are not looked at as pairs: a node all of whose shapes are in one
negative group, say, is not compared with another one of that group. Where no filter can keep any
two shapes apart nothing of this is asked. Cost: a visit to each shape and node when the list of
pairs is made.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.broad_phase.bvh import BUNCH, first_leaf_node
from tamias2d.engine.tables import Integers, Tree

ALL_BITS = -1  # the category and the mask of a node with a shape in a positive group


def note_node_filters(leaves: int, filters: Integers, tree: Tree) -> bool:
    """Write the filters of all nodes; return whether they can keep any two shapes apart."""
    if not filters_differ(leaves, filters, tree.morton[tb.LEAF]):
        return False
    of_node, first = tree.filters, first_leaf_node(leaves)
    for k in range(first):
        node = of_node[first + k]
        node[tb.CATEGORY] = node[tb.MASK] = node[tb.GROUP] = 0
        for m in range(BUNCH * k, min(BUNCH * k + BUNCH, leaves)):
            shape = filters[tree.morton[tb.LEAF, m]]
            grouped = shape[tb.GROUP] > 0
            node[tb.CATEGORY] |= ALL_BITS if grouped else shape[tb.CATEGORY]
            node[tb.MASK] |= ALL_BITS if grouped else shape[tb.MASK]
            alike = m == BUNCH * k or node[tb.GROUP] == shape[tb.GROUP]
            node[tb.GROUP] = min(shape[tb.GROUP], 0) if alike else 0
    for k in range(first - 1, 0, -1):
        for c in (tb.CATEGORY, tb.MASK):
            of_node[k, c] = of_node[2 * k, c] | of_node[2 * k + 1, c]
        alike = of_node[2 * k, tb.GROUP] == of_node[2 * k + 1, tb.GROUP]
        of_node[k, tb.GROUP] = of_node[2 * k, tb.GROUP] if alike else 0
    return True


def filters_differ(leaves: int, filters: Integers, leaf: Integers) -> bool:
    """Return whether filters can keep two of the leaves apart."""
    for k in range(leaves):
        shape, first = filters[leaf[k]], filters[leaf[0]]
        if shape[tb.GROUP] < 0 or (shape[tb.CATEGORY] & shape[tb.MASK]) == 0:
            return True
        if shape[tb.CATEGORY] != first[tb.CATEGORY] or shape[tb.MASK] != first[tb.MASK]:
            return True
    return False


def may_meet(one: Integers, other: Integers) -> bool:
    """Return whether some shape under one node may collide with one under another."""
    if one[tb.GROUP] < 0 and one[tb.GROUP] == other[tb.GROUP]:
        return False
    return bool(
        (one[tb.CATEGORY] & other[tb.MASK]) != 0 and (other[tb.CATEGORY] & one[tb.MASK]) != 0
    )
