"""Islands: bodies that touch each other, whichever way round.

Serves: sleeping, the bound on energy, and whatever solves parts alone. Hides: how they are found.

What does not move freely connects nothing, so that the ground does not make one island of all.
Cost: about as many visits as there are contacts. Source: Tarjan and van Leeuwen (1984), union with
path halving.
"""

from tamias2d.stepped.layout import DYNAMIC, HITS, ISLAND, Whole


def find_islands(
    counts: Whole, pair: Whole, shape_body: Whole, kind: Whole, hits: Whole, island: Whole
) -> None:
    """Give each body that moves freely the lowest row of its island's bodies.

    `hits` holds the touching pairs in its first row.
    """
    for i in range(len(kind)):
        island[i, ISLAND] = i
    for k in range(counts[HITS]):
        p = hits[0, k]
        i, j = shape_body[pair[p, 0]], shape_body[pair[p, 1]]
        if kind[i] == DYNAMIC and kind[j] == DYNAMIC:
            i, j = root_of(i, island), root_of(j, island)
            island[max(i, j), ISLAND] = min(i, j)
    for i in range(len(kind)):  # what leads there has a lower row, which is done already
        island[i, ISLAND] = island[island[i, ISLAND], ISLAND]


def root_of(i: int, island: Whole) -> int:
    """Return the body that stands for an island as far as it is known."""
    while island[i, ISLAND] != i:
        island[i, ISLAND] = island[island[i, ISLAND], ISLAND]
        i = island[i, ISLAND]
    return i
