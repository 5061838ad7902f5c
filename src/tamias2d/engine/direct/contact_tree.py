"""Tree-like islands: dynamic bodies that are connected by contacts without a cycle.

Bodies with one contact are taken off until none is left. Of a tree one body, the root, remains,
without a contact; of all else some bodies that have two or more. A body keeps its contacts as one
number, joined by exclusive or, so that the last one is known without a list.
Cost: some visits to each contact. Source: Tarjan (1975) for sets.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Bodies, Direct, Integers, Touching


def find_trees(bodies: Bodies, touching: Touching, direct: Direct) -> int:
    """List the contacts of tree-like islands that can be solved directly; return how many.

    Such an island touches bodies that do not move freely in one contact at most. Then its contacts
    ask for no more than its bodies can do, and there is one answer.
    """
    trees = direct.trees
    join_incident(bodies, touching, trees)
    leaves = take_off_leaves(touching, direct)
    for k in range(touching.counts[tb.TOUCHING]):
        for i in (touching.body_a[k], touching.body_b[k]):
            trees[i, tb.TREE] = (
                i if trees[i, tb.DEGREE] == 0 and bodies.kind[i] == tb.DYNAMIC else -1
            )
    for t in range(leaves - 1, -1, -1):
        root = trees[direct.taken_off[t], tb.TREE]
        trees[direct.leaves[t], tb.TREE] = root
        if root >= 0:
            trees[root, tb.TREE_BODIES] += 1
    count_grounded(bodies, touching, trees)
    listed = 0
    for k in range(touching.counts[tb.TOUCHING]):
        root = tree_of(k, bodies, touching, trees)
        if root >= 0 and trees[root, tb.TREE_BODIES] > 1 and trees[root, tb.GROUNDED] <= 1:
            direct.contacts[listed] = k
            listed += 1
    return listed


def join_incident(bodies: Bodies, touching: Touching, trees: Integers) -> None:
    """Count the contacts of each body with dynamic ones, and join them by exclusive or."""
    for k in range(touching.counts[tb.TOUCHING]):
        for i in (touching.body_a[k], touching.body_b[k]):
            trees[i, tb.DEGREE] = trees[i, tb.INCIDENT] = trees[i, tb.GROUNDED] = 0
            trees[i, tb.TREE_BODIES], trees[i, tb.NODE], trees[i, tb.TREE_NUMBER] = 1, -1, -1
    for k in range(touching.counts[tb.TOUCHING]):
        i, j = touching.body_a[k], touching.body_b[k]
        if bodies.kind[i] == tb.DYNAMIC and bodies.kind[j] == tb.DYNAMIC:
            trees[i, tb.DEGREE] += 1
            trees[j, tb.DEGREE] += 1
            trees[i, tb.INCIDENT] ^= k
            trees[j, tb.INCIDENT] ^= k


def take_off_leaves(touching: Touching, direct: Direct) -> int:
    """Take off bodies with one contact until there is none; return how many these are."""
    trees = direct.trees
    leaves = 0
    for k in range(touching.counts[tb.TOUCHING]):
        for i in (touching.body_a[k], touching.body_b[k]):
            leaf = i
            while trees[leaf, tb.DEGREE] == 1:
                contact = trees[leaf, tb.INCIDENT]
                other = touching.body_a[contact] + touching.body_b[contact] - leaf
                trees[leaf, tb.DEGREE] = 0
                trees[other, tb.DEGREE] -= 1
                trees[other, tb.INCIDENT] ^= contact
                direct.leaves[leaves], direct.taken_off[leaves] = leaf, other
                leaves += 1
                leaf = other
    return leaves


def count_grounded(bodies: Bodies, touching: Touching, trees: Integers) -> None:
    """Count the contacts of each tree with bodies that do not move freely."""
    for k in range(touching.counts[tb.TOUCHING]):
        root = tree_of(k, bodies, touching, trees)
        i, j = touching.body_a[k], touching.body_b[k]
        if root >= 0 and (bodies.kind[i] != tb.DYNAMIC or bodies.kind[j] != tb.DYNAMIC):
            trees[root, tb.GROUNDED] += 1


def tree_of(k: int, bodies: Bodies, touching: Touching, trees: Integers) -> int:
    """Return the root of the tree to which a touching contact belongs, or -1."""
    i, j = touching.body_a[k], touching.body_b[k]
    return trees[i, tb.TREE] if bodies.kind[i] == tb.DYNAMIC else trees[j, tb.TREE]


def number_trees(bodies: Bodies, touching: Touching, direct: Direct) -> int:
    """Number the islands that can be solved directly, with room for their nodes and contacts.

    Returns how many there are, or less than zero: minus the rows that `sparse` needs.
    """
    trees, sparse = direct.trees, direct.sparse
    listed = find_trees(bodies, touching, direct)
    direct.counts[tb.TREE_CONTACTS] = listed
    if listed == 0:
        return 0
    if 5 * listed + 16 > len(sparse):
        return -(5 * listed + 16)
    number = nodes = 0
    for m in range(listed):
        root = tree_of(direct.contacts[m], bodies, touching, trees)
        if trees[root, tb.TREE_NUMBER] < 0:
            trees[root, tb.TREE_NUMBER] = number
            sparse[number, tb.I_NODE] = sparse[number, tb.I_NEXT_NODE] = nodes
            sparse[number, tb.I_CONTACT] = 0
            nodes += trees[root, tb.TREE_BODIES]
            number += 1
        sparse[trees[root, tb.TREE_NUMBER], tb.I_CONTACT] += 1
    contacts = 0
    for n in range(number):
        count = sparse[n, tb.I_CONTACT]
        sparse[n, tb.I_CONTACT] = sparse[n, tb.I_NEXT_CONTACT] = contacts
        contacts += count
    sparse[number, tb.I_NODE], sparse[number, tb.I_CONTACT] = nodes, contacts
    return number
