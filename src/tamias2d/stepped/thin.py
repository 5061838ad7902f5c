"""Thin islands: bodies that hang together by contacts like a chain or a tree, or nearly so.

Serves: the colours, and the direct solver, which takes these islands. Hides: how bodies are
grouped, and in which order a thin island is eliminated: always the body with the fewest neighbours
first, so that almost nothing new comes to be connected.

Source: Tarjan (1975), for grouping; Tinney and Walker (1967), for the order.
"""

from tamias2d.stepped.layout import DYNAMIC, HIT, HIT_COLOUR, HIT_PLACE, HITS, ISLAND, Whole
from tamias2d.stepped.rows import COLOURS, LANES

# isle (n+1, 6): of the root of an island how many bodies it has, and contacts between them, its
# number among the thin ones, how many leaves, and contacts with the ground; of a body its knot
BODIES, CONTACTS, NUMBER, KNOT, LEAVES_OF, GROUNDED = 0, 1, 2, 3, 4, 5
ISLE = 6

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


def island_of(
    k: int, pair: Whole, shape_body: Whole, kind: Whole, hits: Whole, island: Whole
) -> int:
    """Return the root of the island to which a touching pair belongs."""
    p = hits[0, k]
    i, j = shape_body[pair[p, 0]], shape_body[pair[p, 1]]
    return island[i if kind[i] == DYNAMIC else j, ISLAND]


def is_leaf(i: int, kind: Whole, used: Whole) -> bool:
    """Return whether a moving body has one contact, which is one colour."""
    return kind[i] == DYNAMIC and used[i] != 0 and used[i] & (used[i] - 1) == 0


def has_leaf(kind: Whole, used: Whole) -> bool:
    """Return whether any body is a leaf: without one there is no thin island to be looked for."""
    leaves = 0
    for i in range(len(kind)):
        leaves += 1 if is_leaf(i, kind, used) else 0
    return leaves > 0


def is_thin(i: int, isle: Whole) -> bool:
    """Return whether an island hangs together like a tree, the ground being one of its bodies.

    Then its contacts ask for no more than its bodies can do, and there is one answer.
    """
    tree = isle[i, BODIES] > 1 and isle[i, CONTACTS] < isle[i, BODIES] and isle[i, GROUNDED] <= 1
    return tree and isle[i, LEAVES_OF] > 0


def count_islands(
    counts: Whole,
    pair: Whole,
    shape_body: Whole,
    kind: Whole,
    used: Whole,
    hits: Whole,
    island: Whole,
    isle: Whole,
) -> int:
    """Count bodies and contacts of all islands; return how many contacts are in thin ones."""
    for i in range(len(kind)):
        isle[i, BODIES] = isle[i, CONTACTS] = isle[i, LEAVES_OF] = isle[i, GROUNDED] = 0
        isle[i, NUMBER] = isle[i, KNOT] = -1
    for i in range(len(kind)):
        isle[island[i, ISLAND], BODIES] += 1
        isle[island[i, ISLAND], LEAVES_OF] += 1 if is_leaf(i, kind, used) else 0
    for k in range(counts[HITS]):
        p = hits[0, k]
        i, j = shape_body[pair[p, 0]], shape_body[pair[p, 1]]
        free = kind[i] == DYNAMIC and kind[j] == DYNAMIC
        at = CONTACTS if free else GROUNDED
        isle[island_of(k, pair, shape_body, kind, hits, island), at] += 1
    joints = 0
    for i in range(len(kind)):
        joints += isle[i, CONTACTS] + isle[i, GROUNDED] if is_thin(i, isle) else 0
    return joints


def plan(
    counts: Whole,
    pair: Whole,
    shape_body: Whole,
    kind: Whole,
    used: Whole,
    hits: Whole,
    fill: Whole,
    island: Whole,
    isle: Whole,
    web: Whole,
) -> int:
    """List the joints and the turns of all thin islands; return how many islands there are.

    Or less than zero: for how much room `web` has too little.
    """
    joints = count_islands(counts, pair, shape_body, kind, used, hits, island, isle)
    if joints == 0:
        return 0
    if 5 * joints + 16 > len(web):
        return -(5 * joints + 16)
    islands = knots = 0
    for k in range(counts[HITS]):
        i = island_of(k, pair, shape_body, kind, hits, island)
        if is_thin(i, isle):
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
    links = 0
    for k in range(counts[HITS]):
        number = isle[island_of(k, pair, shape_body, kind, hits, island), NUMBER]
        if number >= 0:
            links = join(k, links, number, pair, shape_body, kind, hits, fill, isle, web)
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
    pair: Whole,
    shape_body: Whole,
    kind: Whole,
    hits: Whole,
    fill: Whole,
    isle: Whole,
    web: Whole,
) -> int:
    """List a touching pair as a joint, with its knots and its link; return how many links."""
    p, c, place = hits[HIT, k], hits[HIT_COLOUR, k], hits[HIT_PLACE, k]
    i, j = shape_body[pair[p, 0]], shape_body[pair[p, 1]]
    joint = web[number, LEAF]
    web[number, LEAF] += 1
    single = c >= 2 * COLOURS
    web[joint, J_BLOCK] = fill[1, c] + (place if single else place // LANES)
    web[joint, J_LANE] = 0 if single else place % LANES
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
