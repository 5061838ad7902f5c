"""Slabs: stretches of a large scene that are solved in turns, as far as a cache can hold them.

Serves: the arrangement. Hides: along which axis they follow each other, and how wide they are.

A slab is at least as wide as two bodies that touch are apart: so contacts are within a slab, or
with the next one. Then a slab may be ahead of the next one by a stage of the solver, which goes
through a large scene only once in a step, as a front of some slabs, instead of once in each stage.

Source: Wonnacott (2002), time skewing.
"""

from tamias2d.state import Array
from tamias2d.stepped.layout import (
    ACTIVE,
    ACTIVE_BODY,
    ACTIVE_ROW,
    DYNAMIC,
    HIT_A,
    HIT_B,
    HIT_BY_SLAB,
    HITS,
    REACH,
    SLABS,
    Whole,
    X,
    Y,
)
from tamias2d.stepped.rows import S_BODY, S_HIT, S_ISLE
from tamias2d.stepped.thin import NUMBER, SLAB, TREE

CONTACTS_IN_SLAB = 1024  # to a slab, about
MOST_SLABS = 256
TOO_FAR = 2.5  # reaches of the largest body: farther apart nothing touches


def divide(
    islands: int,
    counts: Whole,
    kind: Whole,
    used: Whole,
    pose: Array,
    body: Array,
    hits: Whole,
    isle: Whole,
    slabs: Whole,
) -> None:
    """Divide what touches into slabs, and list pairs and moving bodies slab by slab.

    Of thin islands, which touch no others, each is in one slab.
    """
    number = choose(islands, counts, kind, pose, body, hits, isle)
    counts[SLABS] = number
    for q in range(number + 1):
        slabs[q, S_ISLE] = -(-q * islands // number)
    if number == 1:
        list_all(counts, used, hits, slabs)
    else:
        list_by_slab(counts, kind, used, hits, isle, slabs)


def list_all(counts: Whole, used: Whole, hits: Whole, slabs: Whole) -> None:
    """List all that touches as one slab."""
    slabs[1, S_HIT], slabs[1, S_BODY] = counts[HITS], counts[ACTIVE]
    for k in range(counts[HITS]):
        hits[HIT_BY_SLAB, k] = k
    listed = 0
    for i in range(len(used)):
        if used[i] == 1:
            hits[ACTIVE_ROW, listed] = i
            listed += 1


def list_by_slab(
    counts: Whole, kind: Whole, used: Whole, hits: Whole, isle: Whole, slabs: Whole
) -> None:
    """List pairs and moving bodies slab by slab, by counting."""
    number = counts[SLABS]
    clear_column(S_HIT, number, slabs)
    for k in range(counts[HITS]):
        slabs[slab_of(k, kind, hits, isle) + 2, S_HIT] += 1
    add_up(S_HIT, number, slabs)
    for k in range(counts[HITS]):
        hits[HIT_BY_SLAB, take_place(slab_of(k, kind, hits, isle), S_HIT, slabs)] = k
    clear_column(S_BODY, number, slabs)
    for k in range(counts[ACTIVE]):
        slabs[isle[hits[ACTIVE_BODY, k], SLAB] + 2, S_BODY] += 1
    add_up(S_BODY, number, slabs)
    for i in range(len(used)):
        if used[i] == 1:
            hits[ACTIVE_ROW, take_place(isle[i, SLAB], S_BODY, slabs)] = i


def clear_column(column: int, number: int, slabs: Whole) -> None:
    """Begin to count what is in each slab."""
    for q in range(number + 2):
        slabs[q, column] = 0


def add_up(column: int, number: int, slabs: Whole) -> None:
    """Make of how many there are in each slab where the next one begins."""
    for q in range(number + 1):
        slabs[q + 1, column] += slabs[q, column]


def take_place(q: int, column: int, slabs: Whole) -> int:
    """Return the next place of a slab; in the end each row says where its slab begins."""
    place = slabs[q + 1, column]
    slabs[q + 1, column] = place + 1
    return int(place)


def choose(
    islands: int,
    counts: Whole,
    kind: Whole,
    pose: Array,
    body: Array,
    hits: Whole,
    isle: Whole,
) -> int:
    """Give each body that can be pushed and touches something its slab; return how many there are.

    Where something moves that cannot be pushed there is one only, for that would be in none.
    """
    wanted = min(counts[HITS] // CONTACTS_IN_SLAB, MOST_SLABS)
    if wanted < 2:
        return 1
    one = hits[ACTIVE_BODY, 0]
    low_x, high_x, low_y, high_y = pose[one, X], pose[one, X], pose[one, Y], pose[one, Y]
    reach = 0.0
    pushed = 0
    for k in range(counts[ACTIVE]):
        i = hits[ACTIVE_BODY, k]
        pushed += kind[i] == DYNAMIC
        low_x, high_x = min(low_x, pose[i, X]), max(high_x, pose[i, X])
        low_y, high_y = min(low_y, pose[i, Y]), max(high_y, pose[i, Y])
        reach = max(reach, body[i, REACH])
    along_x = high_x - low_x > high_y - low_y
    low, extent = (low_x, high_x - low_x) if along_x else (low_y, high_y - low_y)
    number = int(min(extent / (TOO_FAR * reach), float(wanted)))
    if number < 2 or pushed < counts[ACTIVE]:
        return 1
    for k in range(counts[ACTIVE]):
        i = hits[ACTIVE_BODY, k]
        root = isle[i, TREE]
        if root >= 0 and isle[root, NUMBER] >= 0:
            isle[i, SLAB] = isle[root, NUMBER] * number // islands
        else:
            place = pose[i, X] if along_x else pose[i, Y]
            isle[i, SLAB] = min(int((place - low) / (extent / number)), number - 1)
    return number


def slab_of(k: int, kind: Whole, hits: Whole, isle: Whole) -> int:
    """Return the slab of a touching pair: of two that can be pushed, the first one's."""
    i, j = hits[HIT_A, k], hits[HIT_B, k]
    if kind[i] == DYNAMIC and kind[j] == DYNAMIC:
        return int(min(isle[i, SLAB], isle[j, SLAB]))
    return int(isle[i, SLAB] if kind[i] == DYNAMIC else isle[j, SLAB])
