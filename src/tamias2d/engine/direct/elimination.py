"""The order of elimination of tree-like islands, and the edges that come to be by it.

The node with the fewest neighbours is eliminated next, and its neighbours become connected: in a
tree nearly nothing is. An edge is listed at both of its nodes as one of its half-edges.
Cost: a visit to each edge, and to each that comes to be. Source: Tinney and Walker (1967).
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.direct.contact_tree import tree_of
from tamias2d.engine.solver.blocks import lane_of
from tamias2d.engine.tables import Bodies, Direct, Integers, Touching


def plan_elimination(tree_count: int, bodies: Bodies, touching: Touching, direct: Direct) -> int:
    """List the contacts of all islands that are solved directly, and order their nodes.

    Returns how many islands there are, or less than zero: minus the rows that `sparse` needs.
    """
    counts = direct.counts
    counts[tb.EDGES] = counts[tb.FILL_LENGTH] = 0
    for m in range(counts[tb.TREE_CONTACTS]):
        list_contact(direct.contacts[m], bodies, touching, direct)
    for n in range(tree_count):
        if not order_nodes(n, counts, direct.sparse):
            return -2 * len(direct.sparse)
    return tree_count


def list_contact(k: int, bodies: Bodies, touching: Touching, direct: Direct) -> None:
    """List a touching contact with its lane, its nodes and its edge."""
    sparse = direct.sparse
    island = direct.trees[tree_of(k, bodies, touching, direct.trees), tb.TREE_NUMBER]
    contact = sparse[island, tb.I_NEXT_CONTACT]
    sparse[island, tb.I_NEXT_CONTACT] += 1
    sparse[contact, tb.C_BLOCK], sparse[contact, tb.C_LANE] = lane_of(k, touching)
    a = node_of(touching.body_a[k], island, bodies, direct)
    b = node_of(touching.body_b[k], island, bodies, direct)
    edge = edge_of(a, b, direct.counts, sparse) if a >= 0 and b >= 0 else -1
    sparse[contact, tb.C_NODE_A], sparse[contact, tb.C_NODE_B], sparse[contact, tb.C_EDGE] = (
        a,
        b,
        edge,
    )


def node_of(i: int, island: int, bodies: Bodies, direct: Direct) -> int:
    """Return the node of a body, which is made if there is none; -1 if it does not move freely."""
    trees, sparse = direct.trees, direct.sparse
    if bodies.kind[i] != tb.DYNAMIC:
        return -1
    if trees[i, tb.NODE] < 0:
        node = sparse[island, tb.I_NEXT_NODE]
        sparse[island, tb.I_NEXT_NODE] += 1
        trees[i, tb.NODE] = node
        sparse[node, tb.N_BODY], sparse[node, tb.N_HEAD] = i, -1
        sparse[node, tb.N_DEGREE], sparse[node, tb.N_PIVOT] = 0, -1
    return int(trees[i, tb.NODE])


def edge_of(one: int, other: int, counts: Integers, sparse: Integers) -> int:
    """Return the edge between two nodes, which is made if there is none."""
    edge = edge_between(one, other, sparse)
    if edge < 0:
        edge = counts[tb.EDGES]
        counts[tb.EDGES] += 1
        connect(edge, one, other, sparse)
    return edge


def edge_between(one: int, other: int, sparse: Integers) -> int:
    """Return the edge between two nodes, or -1."""
    if sparse[one, tb.N_DEGREE] > sparse[other, tb.N_DEGREE]:
        one, other = other, one
    half = sparse[one, tb.N_HEAD]
    while half >= 0:
        if sparse[half // 2, tb.E_NODE_B - half % 2] == other:
            return half // 2
        half = sparse[half // 2, tb.E_NEXT + half % 2]
    return -1


def connect(edge: int, one: int, other: int, sparse: Integers) -> None:
    """Make an edge between two nodes."""
    sparse[edge, tb.E_NODE_A], sparse[edge, tb.E_NODE_B] = one, other
    sparse[edge, tb.E_NEXT], sparse[edge, tb.E_NEXT + 1] = (
        sparse[one, tb.N_HEAD],
        sparse[other, tb.N_HEAD],
    )
    sparse[one, tb.N_HEAD], sparse[other, tb.N_HEAD] = 2 * edge, 2 * edge + 1
    sparse[one, tb.N_DEGREE] += 1
    sparse[other, tb.N_DEGREE] += 1


def order_nodes(n: int, counts: Integers, sparse: Integers) -> bool:
    """Eliminate the nodes of an island in order; return whether there were rows enough."""
    first, last = sparse[n, tb.I_NODE], sparse[n + 1, tb.I_NODE]
    counts[tb.LEAF_NODES] = counts[tb.PASS_NODES] = 0
    for node in range(first, last):
        stack_node(node, counts, sparse)
    for pivot in range(first, last):
        node = next_node(first, last, counts, sparse)
        degree = sparse[node, tb.N_DEGREE]
        used = max(counts[tb.EDGES], counts[tb.FILL_LENGTH] + last)
        if used + degree * (degree + 1) // 2 + 2 > len(sparse):
            return False
        eliminate(pivot, node, counts, sparse)
    orient_edges(first, last, sparse)
    return True


def stack_node(node: int, counts: Integers, sparse: Integers) -> None:
    """Push a node that has few neighbours on its stack."""
    if sparse[node, tb.N_DEGREE] <= 1:
        sparse[counts[tb.LEAF_NODES], tb.LEAF_NODE] = node
        counts[tb.LEAF_NODES] += 1
    elif sparse[node, tb.N_DEGREE] == 2:
        sparse[counts[tb.PASS_NODES], tb.PASS_NODE] = node
        counts[tb.PASS_NODES] += 1


def next_node(first: int, last: int, counts: Integers, sparse: Integers) -> int:
    """Return a node with the fewest neighbours of those that are not eliminated."""
    node = pop_node(tb.LEAF_NODE, tb.LEAF_NODES, counts, sparse)
    if node < 0:
        node = pop_node(tb.PASS_NODE, tb.PASS_NODES, counts, sparse)
    if node < 0:
        for other in range(first, last):
            if sparse[other, tb.N_PIVOT] < 0 and (
                node < 0 or sparse[other, tb.N_DEGREE] < sparse[node, tb.N_DEGREE]
            ):
                node = other
    return node


def pop_node(stack: int, size: int, counts: Integers, sparse: Integers) -> int:
    """Pop a node that is not eliminated from one of the stacks; -1 if there is none."""
    while counts[size] > 0:
        counts[size] -= 1
        node = sparse[counts[size], stack]
        if sparse[node, tb.N_PIVOT] < 0:
            return int(node)
    return -1


def eliminate(pivot: int, node: int, counts: Integers, sparse: Integers) -> None:
    """Write a pivot with its part of the fill list, and connect the neighbours of its node."""
    start, degree = counts[tb.FILL_LENGTH], sparse[node, tb.N_DEGREE]
    sparse[pivot, tb.PIVOT_NODE] = node
    sparse[pivot, tb.PIVOT_FIRST], sparse[pivot, tb.PIVOT_COUNT] = start, degree
    sparse[node, tb.N_PIVOT] = pivot
    list_edges(node, start, sparse)
    at = start + degree
    for k in range(degree):
        one = other_node(sparse[start + k, tb.FILL], node, sparse)
        sparse[one, tb.N_DEGREE] -= 1
        for m in range(k):
            other = other_node(sparse[start + m, tb.FILL], node, sparse)
            sparse[at, tb.FILL] = edge_of(one, other, counts, sparse)
            at += 1
    for k in range(degree):
        stack_node(other_node(sparse[start + k, tb.FILL], node, sparse), counts, sparse)
    counts[tb.FILL_LENGTH] = at


def list_edges(node: int, at: int, sparse: Integers) -> None:
    """List the edges of a node to nodes that are not eliminated."""
    half = sparse[node, tb.N_HEAD]
    while half >= 0:
        if sparse[sparse[half // 2, tb.E_NODE_B - half % 2], tb.N_PIVOT] < 0:
            sparse[at, tb.FILL] = half // 2
            at += 1
        half = sparse[half // 2, tb.E_NEXT + half % 2]


def orient_edges(first: int, last: int, sparse: Integers) -> None:
    """Let A be the node of each edge that is eliminated first."""
    for pivot in range(first, last):
        node, start = sparse[pivot, tb.PIVOT_NODE], sparse[pivot, tb.PIVOT_FIRST]
        for k in range(start, start + sparse[pivot, tb.PIVOT_COUNT]):
            edge = sparse[k, tb.FILL]
            other = other_node(edge, node, sparse)
            sparse[edge, tb.E_NODE_A], sparse[edge, tb.E_NODE_B] = node, other


def other_node(edge: int, node: int, sparse: Integers) -> int:
    """Return the node at the other end of an edge."""
    return (
        sparse[edge, tb.E_NODE_B]
        if sparse[edge, tb.E_NODE_A] == node
        else sparse[edge, tb.E_NODE_A]
    )
