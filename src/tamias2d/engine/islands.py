"""Islands: dynamic bodies that are connected by touching contacts.

Joints connect, too. Other bodies connect nothing, so that the ground does not make one island of
all. Cost: about a visit to each contact. Source: Tarjan and van Leeuwen (1984), union with path
halving.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Bodies, Integers, Islands, Joints, Touching
from tamias2d.kernels.assembled import inlined

LAST = 2**31 - 1


def find_islands(bodies: Bodies, touching: Touching, islands: Islands, joints: Joints) -> None:
    """Give each dynamic body its root: the body of its island that touches first.

    Contacts are in canonical order, and so the root does not depend on the order of adding.
    """
    links = islands.links
    for i in range(len(bodies.kind)):
        links[i, tb.ROOT], links[i, tb.FIRST_CONTACT] = i, LAST
    for k in range(touching.counts[tb.TOUCHING]):
        i, j = touching.body_a[k], touching.body_b[k]
        links[i, tb.FIRST_CONTACT] = min(links[i, tb.FIRST_CONTACT], 2 * k)
        links[j, tb.FIRST_CONTACT] = min(links[j, tb.FIRST_CONTACT], 2 * k + 1)
        if bodies.kind[i] == tb.DYNAMIC and bodies.kind[j] == tb.DYNAMIC:
            i, j = root_of(i, links), root_of(j, links)
            if links[j, tb.FIRST_CONTACT] < links[i, tb.FIRST_CONTACT]:
                i, j = j, i
            links[j, tb.ROOT] = i
    join_islands(islands, joints)
    for i in range(len(bodies.kind)):
        links[i, tb.ROOT] = root_of(i, links)


def update_islands(bodies: Bodies, touching: Touching, islands: Islands, joints: Joints) -> None:
    """Find the islands, unless they are known; sleep finds them itself in each step."""
    if touching.counts[tb.ISLANDS_KNOWN] == 0 or islands.counts[tb.SLEEP_STEPS] > 0:
        find_islands(bodies, touching, islands, joints)
        touching.counts[tb.ISLANDS_KNOWN] = 1


def join_islands(islands: Islands, joints: Joints) -> None:
    """Make one island of the bodies of each mechanism, and of all that touches them."""
    links = islands.links
    for n in range(joints.counts[tb.MECHANISMS]):
        first, last = joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1
        one = joints.members[first, tb.JOINED_SLOT]
        for m in range(first + 1, last):
            i, j = root_of(one, links), root_of(joints.members[m, tb.JOINED_SLOT], links)
            if links[j, tb.FIRST_CONTACT] < links[i, tb.FIRST_CONTACT]:
                i, j = j, i
            links[j, tb.ROOT] = i


@inlined
def both_sleep(i: int, j: int, islands: Islands) -> bool:
    """Return whether neither of two bodies is awake."""
    links = islands.links
    return bool(islands.counts[tb.SLEEPING] > 0 and links[i, tb.AWAKE] + links[j, tb.AWAKE] == 0)


def root_of(i: int, links: Integers) -> int:
    """Return the root of a body as far as it is known."""
    while links[i, tb.ROOT] != i:
        links[i, tb.ROOT] = links[links[i, tb.ROOT], tb.ROOT]
        i = links[i, tb.ROOT]
    return i
