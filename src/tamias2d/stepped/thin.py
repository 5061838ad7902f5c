"""Thin islands: bodies that hang together by contacts like a chain or a tree, or nearly so.

Serves: the arrangement, and the direct solver, which takes these islands. Hides: how bodies are
grouped, and in which order a thin island is eliminated: always the body with the fewest neighbours
first, so that almost nothing new comes to be connected.

Source: Tarjan (1975), for grouping; Tinney and Walker (1967), for the order.
"""

from tamias2d.stepped.layout import (
    DYNAMIC,
    HIT_A,
    HIT_B,
    HIT_PEELED,
    HIT_PEELED_OFF,
    HIT_THIN,
    HITS,
    JOINTS,
    Whole,
)
from tamias2d.stepped.rows import seat_of

# isle (n+1, 8), of a body: how many contacts with moving bodies are left to it, and these as one
# number, by exclusive or; the body that stands for its tree, or -1; its knot; and of that body how
# many are in the tree, its contacts with the ground, and its number among the thin ones; its slab
DEGREE, THREAD, TREE, KNOT, BODIES, GROUNDED, NUMBER, SLAB = 0, 1, 2, 3, 4, 5, 6, 7
ISLE = 8

# web: columns of lists that have nothing else to do with each other
K_BODY, K_HEAD, K_DEGREE, K_TURN = 0, 1, 2, 3  # a knot: a moving body of a thin island
L_ONE, L_OTHER, L_NEXT = 4, 5, 6  # a link between two knots; the next ones of both, in 6 and 7
T_KNOT, T_FIRST, T_COUNT = 8, 9, 10  # a turn: which knot is eliminated, and its part of the tape
J_BLOCK, J_LANE, J_ONE, J_OTHER, J_LINK, J_STATE = 11, 12, 13, 14, 15, 16  # a joint: a contact
TAPE = 17  # of each turn its links, and then the links that change by it
I_KNOT, I_JOINT, I_FRESH = 18, 19, 20  # where an island begins; are its equations eliminated
LEAF, PASS = 21, 22  # knots with at most one neighbour, and with two, that wait
J_BUILT = 23  # the state with which a joint was eliminated
WEB = 24


def find_trees(counts: Whole, kind: Whole, hits: Whole, isle: Whole) -> int:
    """List the touching pairs of thin islands in `hits`; return how many.

    A thin island hangs together like a tree, and touches what does not move in one place at most.
    Then its contacts ask for no more than its bodies can do, and there is one answer.
    """
    thread_contacts(counts, kind, hits, isle)
    peeled = peel(counts, hits, isle)
    for k in range(counts[HITS]):
        for i in (hits[HIT_A, k], hits[HIT_B, k]):
            isle[i, TREE] = i if isle[i, DEGREE] == 0 and kind[i] == DYNAMIC else -1
    for t in range(peeled - 1, -1, -1):
        i = hits[HIT_PEELED, t]
        root = isle[hits[HIT_PEELED_OFF, t], TREE]
        isle[i, TREE] = root
        if root >= 0:
            isle[root, BODIES] += 1
    for k in range(counts[HITS]):
        i, j = hits[HIT_A, k], hits[HIT_B, k]
        root = isle[i, TREE] if kind[i] == DYNAMIC else isle[j, TREE]
        if root >= 0 and (kind[i] != DYNAMIC or kind[j] != DYNAMIC):
            isle[root, GROUNDED] += 1
    listed = 0
    for k in range(counts[HITS]):
        root = tree_of(k, kind, hits, isle)
        if root >= 0 and isle[root, BODIES] > 1 and isle[root, GROUNDED] <= 1:
            hits[HIT_THIN, listed] = k
            listed += 1
    return listed


def thread_contacts(counts: Whole, kind: Whole, hits: Whole, isle: Whole) -> None:
    """Count the contacts of each body with moving ones, and join their numbers to one."""
    for k in range(counts[HITS]):
        for i in (hits[HIT_A, k], hits[HIT_B, k]):
            isle[i, DEGREE] = isle[i, THREAD] = isle[i, GROUNDED] = isle[i, SLAB] = 0
            isle[i, BODIES], isle[i, KNOT], isle[i, NUMBER] = 1, -1, -1
    for k in range(counts[HITS]):
        i, j = hits[HIT_A, k], hits[HIT_B, k]
        if kind[i] == DYNAMIC and kind[j] == DYNAMIC:
            isle[i, DEGREE], isle[j, DEGREE] = isle[i, DEGREE] + 1, isle[j, DEGREE] + 1
            isle[i, THREAD], isle[j, THREAD] = isle[i, THREAD] ^ k, isle[j, THREAD] ^ k


def peel(counts: Whole, hits: Whole, isle: Whole) -> int:
    """Take away bodies with one contact left, until there is none; return how many these are.

    Of a tree one body is left, without a contact; of all else some that have two or more.
    """
    peeled = 0
    for k in range(counts[HITS]):
        for i in (hits[HIT_A, k], hits[HIT_B, k]):
            leaf = i
            while isle[leaf, DEGREE] == 1:
                link = isle[leaf, THREAD]
                other = hits[HIT_A, link] + hits[HIT_B, link] - leaf
                isle[leaf, DEGREE] = 0
                isle[other, DEGREE] -= 1
                isle[other, THREAD] ^= link
                hits[HIT_PEELED, peeled], hits[HIT_PEELED_OFF, peeled] = leaf, other
                peeled += 1
                leaf = other
    return peeled


def tree_of(k: int, kind: Whole, hits: Whole, isle: Whole) -> int:
    """Return the body that stands for the tree to which a touching pair belongs, or -1."""
    i, j = hits[HIT_A, k], hits[HIT_B, k]
    return isle[i, TREE] if kind[i] == DYNAMIC else isle[j, TREE]


def number_islands(counts: Whole, kind: Whole, hits: Whole, isle: Whole, web: Whole) -> int:
    """Find all thin islands, and give each a number and room for knots and joints.

    Returns how many there are, or less than zero: for how much room `web` has too little.
    """
    listed = find_trees(counts, kind, hits, isle)
    counts[JOINTS] = listed
    if listed == 0:
        return 0
    if 5 * listed + 16 > len(web):
        return -(5 * listed + 16)
    islands = knots = 0
    for m in range(listed):
        i = tree_of(hits[HIT_THIN, m], kind, hits, isle)
        if isle[i, NUMBER] < 0:
            isle[i, NUMBER] = islands
            web[islands, I_KNOT], web[islands, I_JOINT] = knots, 0
            knots += isle[i, BODIES]
            islands += 1
        web[isle[i, NUMBER], I_JOINT] += 1
    joints = 0
    for n in range(islands):
        count = web[n, I_JOINT]
        web[n, I_JOINT] = joints
        web[n, LEAF], web[n, PASS] = joints, web[n, I_KNOT]
        joints += count
    web[islands, I_KNOT], web[islands, I_JOINT] = knots, joints
    return islands


def plan(islands: int, counts: Whole, kind: Whole, hits: Whole, isle: Whole, web: Whole) -> int:
    """List the joints and the turns of all thin islands, as they have been numbered.

    Returns less than zero for how much room `web` has too little, else how many islands there are.
    """
    links = 0
    for m in range(counts[JOINTS]):
        k = hits[HIT_THIN, m]
        number = isle[tree_of(k, kind, hits, isle), NUMBER]
        links = join(k, links, number, kind, hits, isle, web)
    tape = 0
    for n in range(islands):
        links, tape = eliminate(n, links, tape, web)
        if links < 0:
            return links
    return islands


def join(
    k: int,
    links: int,
    number: int,
    kind: Whole,
    hits: Whole,
    isle: Whole,
    web: Whole,
) -> int:
    """List a touching pair as a joint, with its knots and its link; return how many links."""
    i, j = hits[HIT_A, k], hits[HIT_B, k]
    joint = web[number, LEAF]
    web[number, LEAF] += 1
    web[joint, J_BLOCK], web[joint, J_LANE] = seat_of(k, hits)
    for n in range(2):
        body = j if n == 1 else i
        if kind[body] == DYNAMIC and isle[body, KNOT] < 0:
            knot = web[number, PASS]
            web[number, PASS] += 1
            isle[body, KNOT] = knot
            web[knot, K_BODY], web[knot, K_HEAD], web[knot, K_DEGREE] = body, -1, 0
            web[knot, K_TURN] = -1
        web[joint, J_ONE + n] = isle[body, KNOT] if kind[body] == DYNAMIC else -1
    web[joint, J_LINK] = -1
    one, other = web[joint, J_ONE], web[joint, J_OTHER]
    if one >= 0 and other >= 0:
        link = between(one, other, web)
        if link < 0:
            connect(links, one, other, web)
            link = links
            links += 1
        web[joint, J_LINK] = link
    return links


def between(one: int, other: int, web: Whole) -> int:
    """Return the link of two knots, or -1."""
    if web[one, K_DEGREE] > web[other, K_DEGREE]:
        one, other = other, one
    half = web[one, K_HEAD]
    while half >= 0:
        link = half // 2
        if web[link, L_OTHER - half % 2] == other:
            return link
        half = web[link, L_NEXT + half % 2]
    return -1


def connect(link: int, one: int, other: int, web: Whole) -> None:
    """Link two knots."""
    web[link, L_ONE], web[link, L_OTHER] = one, other
    web[link, L_NEXT], web[link, L_NEXT + 1] = web[one, K_HEAD], web[other, K_HEAD]
    web[one, K_HEAD], web[other, K_HEAD] = 2 * link, 2 * link + 1
    web[one, K_DEGREE] += 1
    web[other, K_DEGREE] += 1


def eliminate(n: int, links: int, tape: int, web: Whole) -> tuple[int, int]:
    """Put the knots of an island in order; return how many links there are now, and the tape.

    Or less than zero: for how many rows `web` has too few.
    """
    first, last = web[n, I_KNOT], web[n + 1, I_KNOT]
    leaves = passes = 0
    for knot in range(first, last):
        if web[knot, K_DEGREE] <= 1:
            web[leaves, LEAF] = knot
            leaves += 1
        elif web[knot, K_DEGREE] == 2:
            web[passes, PASS] = knot
            passes += 1
    for turn in range(first, last):
        knot = -1
        while knot < 0 and leaves > 0:
            leaves -= 1
            knot = web[leaves, LEAF] if web[web[leaves, LEAF], K_TURN] < 0 else -1
        while knot < 0 and passes > 0:
            passes -= 1
            knot = web[passes, PASS] if web[web[passes, PASS], K_TURN] < 0 else -1
        if knot < 0:
            for other in range(first, last):
                if web[other, K_TURN] < 0 and (
                    knot < 0 or web[other, K_DEGREE] < web[knot, K_DEGREE]
                ):
                    knot = other
        count = web[knot, K_DEGREE]
        if max(links, tape + last) + count * (count + 1) // 2 + 2 > len(web):
            return -2 * len(web), 0
        web[turn, T_KNOT], web[turn, T_FIRST], web[turn, T_COUNT] = knot, tape, count
        web[knot, K_TURN] = turn
        half = web[knot, K_HEAD]
        k = tape
        while half >= 0:
            if web[web[half // 2, L_OTHER - half % 2], K_TURN] < 0:
                web[k, TAPE] = half // 2
                k += 1
            half = web[half // 2, L_NEXT + half % 2]
        at = tape + count
        for k in range(count):
            one = beyond(web[tape + k, TAPE], knot, web)
            web[one, K_DEGREE] -= 1
            for m in range(k):
                other = beyond(web[tape + m, TAPE], knot, web)
                link = between(one, other, web)
                if link < 0:
                    connect(links, one, other, web)
                    link = links
                    links += 1
                web[at, TAPE] = link
                at += 1
        for k in range(count):
            other = beyond(web[tape + k, TAPE], knot, web)
            if web[other, K_DEGREE] <= 1:
                web[leaves, LEAF] = other
                leaves += 1
            elif web[other, K_DEGREE] == 2:
                web[passes, PASS] = other
                passes += 1
        tape = at
    for turn in range(first, last):
        knot, start = web[turn, T_KNOT], web[turn, T_FIRST]
        for k in range(start, start + web[turn, T_COUNT]):
            link = web[k, TAPE]
            web[link, L_ONE], web[link, L_OTHER] = knot, beyond(link, knot, web)
    return links, tape


def beyond(link: int, knot: int, web: Whole) -> int:
    """Return the knot at the other end of a link."""
    return web[link, L_OTHER] if web[link, L_ONE] == knot else web[link, L_ONE]
