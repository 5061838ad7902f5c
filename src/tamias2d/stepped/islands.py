"""Islands: bodies that touch each other, whichever way round.

Serves: sleeping, the bound on energy, and whatever solves parts alone. Hides: how they are found.

What does not move freely connects nothing, so that the ground does not make one island of all.
Cost: about as many visits as there are contacts. Source: Tarjan and van Leeuwen (1984), union with
path halving.
"""

from tamias2d.stepped.layout import (
    DYNAMIC,
    HIT_A,
    HIT_B,
    HITS,
    ISLAND,
    ISLANDED,
    PATIENCE,
    TURN_IN,
    Whole,
)

LAST = 2**31 - 1


def find_islands(counts: Whole, kind: Whole, hits: Whole, island: Whole) -> None:
    """Give each body that moves freely the row of that body of its island which touches first.

    `hits` holds the touching pairs in its first row, in canonical order: so it is not the order of
    rows that decides from where an island is seen.
    """
    for i in range(len(kind)):
        island[i, ISLAND], island[i, TURN_IN] = i, LAST
    for k in range(counts[HITS]):
        i, j = hits[HIT_A, k], hits[HIT_B, k]
        island[i, TURN_IN] = min(island[i, TURN_IN], 2 * k)
        island[j, TURN_IN] = min(island[j, TURN_IN], 2 * k + 1)
        if kind[i] == DYNAMIC and kind[j] == DYNAMIC:
            i, j = root_of(i, island), root_of(j, island)
            if island[j, TURN_IN] < island[i, TURN_IN]:
                i, j = j, i
            island[j, ISLAND] = i
    for i in range(len(kind)):
        island[i, ISLAND] = root_of(i, island)


def know_islands(counts: Whole, kind: Whole, hits: Whole, island: Whole) -> None:
    """Find the islands, unless they are known; where bodies may sleep, sleep writes them too."""
    if counts[ISLANDED] == 0 or counts[PATIENCE] > 0:
        find_islands(counts, kind, hits, island)
        counts[ISLANDED] = 1


def root_of(i: int, island: Whole) -> int:
    """Return the body that stands for an island as far as it is known."""
    while island[i, ISLAND] != i:
        island[i, ISLAND] = island[island[i, ISLAND], ISLAND]
        i = island[i, ISLAND]
    return i
