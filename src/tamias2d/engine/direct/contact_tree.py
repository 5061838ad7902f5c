"""Thin islands: bodies that hang together by contacts like a chain or a tree, or nearly so.

Serves: the arrangement, and the direct solver, which takes these islands. Hides: how bodies are
grouped, and in which order a thin island is eliminated: always the body with the fewest neighbours
first, so that almost nothing new comes to be connected.

Source: Tarjan (1975), for grouping; Tinney and Walker (1967), for the order.
"""

from tamias2d.engine.solver.constraints import lane_of
from tamias2d.engine.tables import (
    C_BLOCK,
    C_EDGE,
    C_LANE,
    C_ONE,
    C_OTHER,
    DEGREE,
    DYNAMIC,
    E_NEXT,
    E_ONE,
    E_OTHER,
    FILL,
    GROUNDED,
    I_CONTACT,
    I_NODE,
    INCIDENT,
    LEAF_NODE,
    N_BODY,
    N_DEGREE,
    N_HEAD,
    N_PIVOT,
    NODE,
    NUMBER,
    PASS_NODE,
    SLAB,
    TOUCHING,
    TREE,
    TREE_BODIES,
    TREE_CONTACTS,
    V_COUNT,
    V_FIRST,
    V_NODE,
    Bodies,
    Direct,
    Integers,
    Touching,
)

# isle (n+1, 8), of a body: how many contacts with moving bodies are left to it, and these as one
# number, by exclusive or; the body that stands for its tree, or -1; its knot; and of that body how
# many are in the tree, its contacts with the ground, and its number among the thin ones; its slab
TREES_WIDTH = 8

# web: columns of lists that have nothing else to do with each other


def find_trees(bodies: Bodies, touching: Touching, direct: Direct) -> int:
    """List the touching pairs of thin islands in `hits`; return how many.

    A thin island hangs together like a tree, and touches what does not move in one place at most.
    Then its contacts ask for no more than its bodies can do, and there is one answer.
    """
    join_incident(bodies, touching, direct)
    peeled = take_off_leaves(touching, direct)
    for k in range(touching.counts[TOUCHING]):
        for i in (touching.body_a[k], touching.body_b[k]):
            direct.trees[i, TREE] = (
                i if direct.trees[i, DEGREE] == 0 and bodies.kind[i] == DYNAMIC else -1
            )
    for t in range(peeled - 1, -1, -1):
        i = direct.leaves[t]
        root = direct.trees[direct.taken_off[t], TREE]
        direct.trees[i, TREE] = root
        if root >= 0:
            direct.trees[root, TREE_BODIES] += 1
    for k in range(touching.counts[TOUCHING]):
        i, j = touching.body_a[k], touching.body_b[k]
        root = direct.trees[i, TREE] if bodies.kind[i] == DYNAMIC else direct.trees[j, TREE]
        if root >= 0 and (bodies.kind[i] != DYNAMIC or bodies.kind[j] != DYNAMIC):
            direct.trees[root, GROUNDED] += 1
    listed = 0
    for k in range(touching.counts[TOUCHING]):
        root = tree_of(k, bodies, touching, direct)
        if root >= 0 and direct.trees[root, TREE_BODIES] > 1 and direct.trees[root, GROUNDED] <= 1:
            direct.contacts[listed] = k
            listed += 1
    return listed


def join_incident(bodies: Bodies, touching: Touching, direct: Direct) -> None:
    """Count the contacts of each body with moving ones, and join their numbers to one."""
    for k in range(touching.counts[TOUCHING]):
        for i in (touching.body_a[k], touching.body_b[k]):
            direct.trees[i, DEGREE] = direct.trees[i, INCIDENT] = direct.trees[
                i, GROUNDED
            ] = direct.trees[i, SLAB] = 0
            direct.trees[i, TREE_BODIES], direct.trees[i, NODE], direct.trees[i, NUMBER] = 1, -1, -1
    for k in range(touching.counts[TOUCHING]):
        i, j = touching.body_a[k], touching.body_b[k]
        if bodies.kind[i] == DYNAMIC and bodies.kind[j] == DYNAMIC:
            direct.trees[i, DEGREE], direct.trees[j, DEGREE] = (
                direct.trees[i, DEGREE] + 1,
                direct.trees[j, DEGREE] + 1,
            )
            direct.trees[i, INCIDENT], direct.trees[j, INCIDENT] = (
                direct.trees[i, INCIDENT] ^ k,
                direct.trees[j, INCIDENT] ^ k,
            )


def take_off_leaves(touching: Touching, direct: Direct) -> int:
    """Take away bodies with one contact left, until there is none; return how many these are.

    Of a tree one body is left, without a contact; of all else some that have two or more.
    """
    peeled = 0
    for k in range(touching.counts[TOUCHING]):
        for i in (touching.body_a[k], touching.body_b[k]):
            leaf = i
            while direct.trees[leaf, DEGREE] == 1:
                link = direct.trees[leaf, INCIDENT]
                other = touching.body_a[link] + touching.body_b[link] - leaf
                direct.trees[leaf, DEGREE] = 0
                direct.trees[other, DEGREE] -= 1
                direct.trees[other, INCIDENT] ^= link
                direct.leaves[peeled], direct.taken_off[peeled] = leaf, other
                peeled += 1
                leaf = other
    return peeled


def tree_of(k: int, bodies: Bodies, touching: Touching, direct: Direct) -> int:
    """Return the body that stands for the tree to which a touching pair belongs, or -1."""
    i, j = touching.body_a[k], touching.body_b[k]
    return direct.trees[i, TREE] if bodies.kind[i] == DYNAMIC else direct.trees[j, TREE]


def number_trees(bodies: Bodies, touching: Touching, direct: Direct) -> int:
    """Find all thin islands, and give each a number and room for knots and joints.

    Returns how many there are, or less than zero: for how much room `web` has too little.
    """
    listed = find_trees(bodies, touching, direct)
    direct.counts[TREE_CONTACTS] = listed
    if listed == 0:
        return 0
    if 5 * listed + 16 > len(direct.sparse):
        return -(5 * listed + 16)
    tree_count = knots = 0
    for m in range(listed):
        i = tree_of(direct.contacts[m], bodies, touching, direct)
        if direct.trees[i, NUMBER] < 0:
            direct.trees[i, NUMBER] = tree_count
            direct.sparse[tree_count, I_NODE], direct.sparse[tree_count, I_CONTACT] = knots, 0
            knots += direct.trees[i, TREE_BODIES]
            tree_count += 1
        direct.sparse[direct.trees[i, NUMBER], I_CONTACT] += 1
    joints = 0
    for n in range(tree_count):
        count = direct.sparse[n, I_CONTACT]
        direct.sparse[n, I_CONTACT] = joints
        direct.sparse[n, LEAF_NODE], direct.sparse[n, PASS_NODE] = joints, direct.sparse[n, I_NODE]
        joints += count
    direct.sparse[tree_count, I_NODE], direct.sparse[tree_count, I_CONTACT] = knots, joints
    return tree_count


def plan_elimination(tree_count: int, bodies: Bodies, touching: Touching, direct: Direct) -> int:
    """List the joints and the turns of all thin islands, as they have been numbered.

    Returns less than zero for how much room `web` has too little, else how many islands there are.
    """
    links = 0
    for m in range(direct.counts[TREE_CONTACTS]):
        k = direct.contacts[m]
        number = direct.trees[tree_of(k, bodies, touching, direct), NUMBER]
        links = list_contact(k, links, number, bodies, touching, direct)
    tape = 0
    for n in range(tree_count):
        links, tape = order_nodes(n, links, tape, direct.sparse)
        if links < 0:
            return links
    return tree_count


def list_contact(
    k: int, links: int, number: int, bodies: Bodies, touching: Touching, direct: Direct
) -> int:
    """List a touching pair as a joint, with its knots and its link; return how many links."""
    i, j = touching.body_a[k], touching.body_b[k]
    joint = direct.sparse[number, LEAF_NODE]
    direct.sparse[number, LEAF_NODE] += 1
    direct.sparse[joint, C_BLOCK], direct.sparse[joint, C_LANE] = lane_of(k, touching)
    for n in range(2):
        body = j if n == 1 else i
        if bodies.kind[body] == DYNAMIC and direct.trees[body, NODE] < 0:
            knot = direct.sparse[number, PASS_NODE]
            direct.sparse[number, PASS_NODE] += 1
            direct.trees[body, NODE] = knot
            (
                direct.sparse[knot, N_BODY],
                direct.sparse[knot, N_HEAD],
                direct.sparse[knot, N_DEGREE],
            ) = body, -1, 0
            direct.sparse[knot, N_PIVOT] = -1
        direct.sparse[joint, C_ONE + n] = (
            direct.trees[body, NODE] if bodies.kind[body] == DYNAMIC else -1
        )
    direct.sparse[joint, C_EDGE] = -1
    one, other = direct.sparse[joint, C_ONE], direct.sparse[joint, C_OTHER]
    if one >= 0 and other >= 0:
        link = edge_between(one, other, direct.sparse)
        if link < 0:
            connect(links, one, other, direct.sparse)
            link = links
            links += 1
        direct.sparse[joint, C_EDGE] = link
    return links


def edge_between(one: int, other: int, sparse: Integers) -> int:
    """Return the link of two knots, or -1."""
    if sparse[one, N_DEGREE] > sparse[other, N_DEGREE]:
        one, other = other, one
    half = sparse[one, N_HEAD]
    while half >= 0:
        link = half // 2
        if sparse[link, E_OTHER - half % 2] == other:
            return link
        half = sparse[link, E_NEXT + half % 2]
    return -1


def connect(link: int, one: int, other: int, sparse: Integers) -> None:
    """Link two knots."""
    sparse[link, E_ONE], sparse[link, E_OTHER] = one, other
    sparse[link, E_NEXT], sparse[link, E_NEXT + 1] = sparse[one, N_HEAD], sparse[other, N_HEAD]
    sparse[one, N_HEAD], sparse[other, N_HEAD] = 2 * link, 2 * link + 1
    sparse[one, N_DEGREE] += 1
    sparse[other, N_DEGREE] += 1


def order_nodes(n: int, links: int, tape: int, sparse: Integers) -> tuple[int, int]:
    """Put the knots of an island in order; return how many links there are now, and the tape.

    Or less than zero: for how many rows `web` has too few.
    """
    first, last = sparse[n, I_NODE], sparse[n + 1, I_NODE]
    leaves = passes = 0
    for knot in range(first, last):
        if sparse[knot, N_DEGREE] <= 1:
            sparse[leaves, LEAF_NODE] = knot
            leaves += 1
        elif sparse[knot, N_DEGREE] == 2:
            sparse[passes, PASS_NODE] = knot
            passes += 1
    for turn in range(first, last):
        knot = -1
        while knot < 0 and leaves > 0:
            leaves -= 1
            knot = (
                sparse[leaves, LEAF_NODE] if sparse[sparse[leaves, LEAF_NODE], N_PIVOT] < 0 else -1
            )
        while knot < 0 and passes > 0:
            passes -= 1
            knot = (
                sparse[passes, PASS_NODE] if sparse[sparse[passes, PASS_NODE], N_PIVOT] < 0 else -1
            )
        if knot < 0:
            for other in range(first, last):
                if sparse[other, N_PIVOT] < 0 and (
                    knot < 0 or sparse[other, N_DEGREE] < sparse[knot, N_DEGREE]
                ):
                    knot = other
        count = sparse[knot, N_DEGREE]
        if max(links, tape + last) + count * (count + 1) // 2 + 2 > len(sparse):
            return -2 * len(sparse), 0
        sparse[turn, V_NODE], sparse[turn, V_FIRST], sparse[turn, V_COUNT] = knot, tape, count
        sparse[knot, N_PIVOT] = turn
        half = sparse[knot, N_HEAD]
        k = tape
        while half >= 0:
            if sparse[sparse[half // 2, E_OTHER - half % 2], N_PIVOT] < 0:
                sparse[k, FILL] = half // 2
                k += 1
            half = sparse[half // 2, E_NEXT + half % 2]
        at = tape + count
        for k in range(count):
            one = other_node(sparse[tape + k, FILL], knot, sparse)
            sparse[one, N_DEGREE] -= 1
            for m in range(k):
                other = other_node(sparse[tape + m, FILL], knot, sparse)
                link = edge_between(one, other, sparse)
                if link < 0:
                    connect(links, one, other, sparse)
                    link = links
                    links += 1
                sparse[at, FILL] = link
                at += 1
        for k in range(count):
            other = other_node(sparse[tape + k, FILL], knot, sparse)
            if sparse[other, N_DEGREE] <= 1:
                sparse[leaves, LEAF_NODE] = other
                leaves += 1
            elif sparse[other, N_DEGREE] == 2:
                sparse[passes, PASS_NODE] = other
                passes += 1
        tape = at
    for turn in range(first, last):
        knot, start = sparse[turn, V_NODE], sparse[turn, V_FIRST]
        for k in range(start, start + sparse[turn, V_COUNT]):
            link = sparse[k, FILL]
            sparse[link, E_ONE], sparse[link, E_OTHER] = knot, other_node(link, knot, sparse)
    return links, tape


def other_node(link: int, knot: int, sparse: Integers) -> int:
    """Return the knot at the other end of a link."""
    return sparse[link, E_OTHER] if sparse[link, E_ONE] == knot else sparse[link, E_ONE]
