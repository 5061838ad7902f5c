"""Slabs: parts of a large scene that are solved in turns, each as large as a cache holds.

A slab is at least as wide as two touching bodies are apart, so that contacts are within a slab or
with the next one. Then a slab may be a stage of the solver ahead of the next one, and a step goes
through a large scene once, as a front of some slabs, instead of once in each stage.
Source: Wonnacott (2002), time skewing.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Bodies, Constraints, Direct, Integers, Touching

CONTACTS_IN_SLAB = 512  # about; a front of nine slabs is 1.5 MB
FEWEST_CONTACTS = 2048  # for which slabs are made: fewer are in the cache as they are
WIDTH = 2.5  # bounding radii of the largest body: bodies farther apart do not touch


def divide_into_slabs(
    tree_count: int,
    one: bool,
    bodies: Bodies,
    touching: Touching,
    constraints: Constraints,
    direct: Direct,
) -> None:
    """Divide the touching contacts into slabs, and list contacts and active bodies by slab.

    Each tree-like island is in one slab. There is one only where springs act in the substeps,
    because they reach from any slab to any other.
    """
    number = 1 if one else assign_slabs(tree_count, bodies, touching, constraints, direct)
    constraints.counts[tb.SLABS] = number
    for q in range(number + 1):
        constraints.slabs[q, tb.S_TREE] = -(-q * tree_count // number)
    if number == 1:
        list_all(bodies, touching, constraints)
    else:
        list_by_slab(bodies, touching, constraints)


def list_all(bodies: Bodies, touching: Touching, constraints: Constraints) -> None:
    """List all contacts and active bodies as one slab."""
    constraints.slabs[1, tb.S_CONTACT] = touching.counts[tb.TOUCHING]
    constraints.slabs[1, tb.S_BODY] = constraints.counts[tb.ACTIVE]
    for k in range(touching.counts[tb.TOUCHING]):
        touching.by_slab[k] = k
    listed = 0
    for i in range(len(bodies.moved)):
        if bodies.moved[i] == 1:
            touching.active_by_slab[listed] = i
            listed += 1


def list_by_slab(bodies: Bodies, touching: Touching, constraints: Constraints) -> None:
    """List contacts and active bodies slab by slab, by counting."""
    slabs, slab_of_body, number = (
        constraints.slabs,
        constraints.slab_of_body,
        constraints.counts[tb.SLABS],
    )
    clear_column(tb.S_CONTACT, number, slabs)
    for k in range(touching.counts[tb.TOUCHING]):
        slabs[slab_of(k, bodies, touching, slab_of_body) + 2, tb.S_CONTACT] += 1
    add_up_column(tb.S_CONTACT, number, slabs)
    for k in range(touching.counts[tb.TOUCHING]):
        q = slab_of(k, bodies, touching, slab_of_body)
        touching.by_slab[next_place(q, tb.S_CONTACT, slabs)] = k
    clear_column(tb.S_BODY, number, slabs)
    for k in range(constraints.counts[tb.ACTIVE]):
        slabs[slab_of_body[touching.active[k]] + 2, tb.S_BODY] += 1
    add_up_column(tb.S_BODY, number, slabs)
    for i in range(len(bodies.moved)):
        if bodies.moved[i] == 1:
            touching.active_by_slab[next_place(slab_of_body[i], tb.S_BODY, slabs)] = i


def clear_column(column: int, number: int, slabs: Integers) -> None:
    """Begin to count: what is in slab q is counted in row q + 2."""
    for q in range(number + 2):
        slabs[q, column] = 0


def add_up_column(column: int, number: int, slabs: Integers) -> None:
    """Add the counts up: row q + 1 now says where slab q begins."""
    for q in range(number + 1):
        slabs[q + 1, column] += slabs[q, column]


def next_place(q: int, column: int, slabs: Integers) -> int:
    """Return the next place of a slab; after the last one, row q says where slab q begins."""
    place = slabs[q + 1, column]
    slabs[q + 1, column] = place + 1
    return int(place)


def assign_slabs(
    tree_count: int, bodies: Bodies, touching: Touching, constraints: Constraints, direct: Direct
) -> int:
    """Give each active body its slab; return how many there are.

    If a body moves that cannot be pushed, there is one slab only: its contacts may be anywhere.
    """
    contacts = touching.counts[tb.TOUCHING]
    if contacts < FEWEST_CONTACTS:
        return 1
    wanted = min(contacts // CONTACTS_IN_SLAB, tb.MOST_SLABS)
    along, low, extent, radius = find_extent(bodies, touching, constraints)
    number = int(min(extent / (WIDTH * radius), float(wanted)))
    if number < 2 or not all_dynamic(bodies, touching, constraints):
        return 1
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        root = direct.trees[i, tb.TREE]
        if root >= 0 and direct.trees[root, tb.TREE_NUMBER] >= 0:
            slab = direct.trees[root, tb.TREE_NUMBER] * number // tree_count
        else:
            slab = min(int((bodies.pose[i, along] - low) / (extent / number)), number - 1)
        constraints.slab_of_body[i] = slab
    return number


def find_extent(
    bodies: Bodies, touching: Touching, constraints: Constraints
) -> tuple[int, float, float, float]:
    """Return along which axis active bodies reach farther, from where, how far; largest radius."""
    pose, first = bodies.pose, touching.active[0]
    low_x, high_x, low_y, high_y = (
        pose[first, tb.X],
        pose[first, tb.X],
        pose[first, tb.Y],
        pose[first, tb.Y],
    )
    radius = 0.0
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        low_x, high_x = min(low_x, pose[i, tb.X]), max(high_x, pose[i, tb.X])
        low_y, high_y = min(low_y, pose[i, tb.Y]), max(high_y, pose[i, tb.Y])
        radius = max(radius, bodies.properties[i, tb.BOUNDING_RADIUS])
    if high_x - low_x > high_y - low_y:
        return tb.X, low_x, high_x - low_x, radius
    return tb.Y, low_y, high_y - low_y, radius


def all_dynamic(bodies: Bodies, touching: Touching, constraints: Constraints) -> bool:
    """Return whether all active bodies are dynamic."""
    dynamic = 0
    for k in range(constraints.counts[tb.ACTIVE]):
        dynamic += bodies.kind[touching.active[k]] == tb.DYNAMIC
    return dynamic == constraints.counts[tb.ACTIVE]


def slab_of(k: int, bodies: Bodies, touching: Touching, slab_of_body: Integers) -> int:
    """Return the slab of a touching contact: of two dynamic bodies, the lower one."""
    i, j = touching.body_a[k], touching.body_b[k]
    if bodies.kind[i] == tb.DYNAMIC and bodies.kind[j] == tb.DYNAMIC:
        return int(min(slab_of_body[i], slab_of_body[j]))
    return int(slab_of_body[i] if bodies.kind[i] == tb.DYNAMIC else slab_of_body[j])
