"""Islands: bodies that touch each other, whichever way round.

Serves: sleeping, the bound on energy, and whatever solves parts alone. Hides: how they are found.

What does not move freely connects nothing, so that the ground does not make one island of all.
Cost: about as many visits as there are contacts. Source: Tarjan and van Leeuwen (1984), union with
path halving.
"""

from tamias2d.engine.tables import (
    DYNAMIC,
    FIRST_CONTACT,
    ISLANDS_KNOWN,
    ROOT,
    SLEEP_STEPS,
    TOUCHING,
    Bodies,
    Integers,
    Islands,
    Touching,
)

LAST = 2**31 - 1


def find_islands(bodies: Bodies, touching: Touching, islands: Islands) -> None:
    """Give each body that moves freely the row of that body of its island which touches first.

    `hits` holds the touching pairs in its first row, in canonical order: so it is not the order of
    rows that decides from where an island is seen.
    """
    for i in range(len(bodies.kind)):
        islands.links[i, ROOT], islands.links[i, FIRST_CONTACT] = i, LAST
    for k in range(touching.counts[TOUCHING]):
        i, j = touching.body_a[k], touching.body_b[k]
        islands.links[i, FIRST_CONTACT] = min(islands.links[i, FIRST_CONTACT], 2 * k)
        islands.links[j, FIRST_CONTACT] = min(islands.links[j, FIRST_CONTACT], 2 * k + 1)
        if bodies.kind[i] == DYNAMIC and bodies.kind[j] == DYNAMIC:
            i, j = root_of(i, islands.links), root_of(j, islands.links)
            if islands.links[j, FIRST_CONTACT] < islands.links[i, FIRST_CONTACT]:
                i, j = j, i
            islands.links[j, ROOT] = i
    for i in range(len(bodies.kind)):
        islands.links[i, ROOT] = root_of(i, islands.links)


def update_islands(bodies: Bodies, touching: Touching, islands: Islands) -> None:
    """Find the islands, unless they are known; where bodies may sleep, sleep writes them too."""
    if touching.counts[ISLANDS_KNOWN] == 0 or islands.counts[SLEEP_STEPS] > 0:
        find_islands(bodies, touching, islands)
        touching.counts[ISLANDS_KNOWN] = 1


def root_of(i: int, island: Integers) -> int:
    """Return the body that stands for an island as far as it is known."""
    while island[i, ROOT] != i:
        island[i, ROOT] = island[island[i, ROOT], ROOT]
        i = island[i, ROOT]
    return i
