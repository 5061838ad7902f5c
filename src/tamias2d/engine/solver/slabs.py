"""Slabs: stretches of a large scene that are solved in turns, as far as a cache can hold them.

Serves: the arrangement. Hides: along which axis they follow each other, and how wide they are.

A slab is at least as wide as two bodies that touch are apart: so contacts are within a slab, or
with the next one. Then a slab may be ahead of the next one by a stage of the solver, which goes
through a large scene only once in a step, as a front of some slabs, instead of once in each stage.

Source: Wonnacott (2002), time skewing.
"""

from tamias2d.engine.tables import (
    ACTIVE,
    BOUNDING_RADIUS,
    DYNAMIC,
    MOST_SLABS,
    NUMBER,
    S_BODY,
    S_CONTACT,
    S_TREE,
    SLAB,
    SLABS,
    TOUCHING,
    TREE,
    Bodies,
    Constraints,
    Direct,
    Integers,
    Touching,
    X,
    Y,
)

CONTACTS_IN_SLAB = 1024  # to a slab, about
TOO_FAR = 2.5  # reaches of the largest body: farther apart nothing touches


def divide_into_slabs(
    tree_count: int, bodies: Bodies, touching: Touching, constraints: Constraints, direct: Direct
) -> None:
    """Divide what touches into slabs, and list pairs and moving bodies slab by slab.

    Of thin islands, which touch no others, each is in one slab.
    """
    number = assign_slabs(tree_count, bodies, touching, constraints, direct)
    constraints.counts[SLABS] = number
    for q in range(number + 1):
        constraints.slabs[q, S_TREE] = -(-q * tree_count // number)
    if number == 1:
        list_all(bodies, touching, constraints)
    else:
        list_by_slab(bodies, touching, constraints, direct)


def list_all(bodies: Bodies, touching: Touching, constraints: Constraints) -> None:
    """List all that touches as one slab."""
    constraints.slabs[1, S_CONTACT], constraints.slabs[1, S_BODY] = (
        touching.counts[TOUCHING],
        constraints.counts[ACTIVE],
    )
    for k in range(touching.counts[TOUCHING]):
        touching.by_slab[k] = k
    listed = 0
    for i in range(len(bodies.moved)):
        if bodies.moved[i] == 1:
            touching.active_by_slab[listed] = i
            listed += 1


def list_by_slab(
    bodies: Bodies, touching: Touching, constraints: Constraints, direct: Direct
) -> None:
    """List pairs and moving bodies slab by slab, by counting."""
    number = constraints.counts[SLABS]
    clear_column(S_CONTACT, number, constraints.slabs)
    for k in range(touching.counts[TOUCHING]):
        constraints.slabs[slab_of(k, bodies, touching, direct) + 2, S_CONTACT] += 1
    add_up_column(S_CONTACT, number, constraints.slabs)
    for k in range(touching.counts[TOUCHING]):
        touching.by_slab[
            next_place(slab_of(k, bodies, touching, direct), S_CONTACT, constraints.slabs)
        ] = k
    clear_column(S_BODY, number, constraints.slabs)
    for k in range(constraints.counts[ACTIVE]):
        constraints.slabs[direct.trees[touching.active[k], SLAB] + 2, S_BODY] += 1
    add_up_column(S_BODY, number, constraints.slabs)
    for i in range(len(bodies.moved)):
        if bodies.moved[i] == 1:
            touching.active_by_slab[
                next_place(direct.trees[i, SLAB], S_BODY, constraints.slabs)
            ] = i


def clear_column(column: int, number: int, slabs: Integers) -> None:
    """Begin to count what is in each slab."""
    for q in range(number + 2):
        slabs[q, column] = 0


def add_up_column(column: int, number: int, slabs: Integers) -> None:
    """Make of how many there are in each slab where the next one begins."""
    for q in range(number + 1):
        slabs[q + 1, column] += slabs[q, column]


def next_place(q: int, column: int, slabs: Integers) -> int:
    """Return the next place of a slab; in the end each row says where its slab begins."""
    place = slabs[q + 1, column]
    slabs[q + 1, column] = place + 1
    return int(place)


def assign_slabs(
    tree_count: int, bodies: Bodies, touching: Touching, constraints: Constraints, direct: Direct
) -> int:
    """Give each body that can be pushed and touches something its slab; return how many there are.

    Where something moves that cannot be pushed there is one only, for that would be in none.
    """
    wanted = min(touching.counts[TOUCHING] // CONTACTS_IN_SLAB, MOST_SLABS)
    if wanted < 2:
        return 1
    one = touching.active[0]
    low_x, high_x, low_y, high_y = (
        bodies.pose[one, X],
        bodies.pose[one, X],
        bodies.pose[one, Y],
        bodies.pose[one, Y],
    )
    reach = 0.0
    pushed = 0
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        pushed += bodies.kind[i] == DYNAMIC
        low_x, high_x = min(low_x, bodies.pose[i, X]), max(high_x, bodies.pose[i, X])
        low_y, high_y = min(low_y, bodies.pose[i, Y]), max(high_y, bodies.pose[i, Y])
        reach = max(reach, bodies.properties[i, BOUNDING_RADIUS])
    along_x = high_x - low_x > high_y - low_y
    low, extent = (low_x, high_x - low_x) if along_x else (low_y, high_y - low_y)
    number = int(min(extent / (TOO_FAR * reach), float(wanted)))
    if number < 2 or pushed < constraints.counts[ACTIVE]:
        return 1
    for k in range(constraints.counts[ACTIVE]):
        i = touching.active[k]
        root = direct.trees[i, TREE]
        if root >= 0 and direct.trees[root, NUMBER] >= 0:
            direct.trees[i, SLAB] = direct.trees[root, NUMBER] * number // tree_count
        else:
            place = bodies.pose[i, X] if along_x else bodies.pose[i, Y]
            direct.trees[i, SLAB] = min(int((place - low) / (extent / number)), number - 1)
    return number


def slab_of(k: int, bodies: Bodies, touching: Touching, direct: Direct) -> int:
    """Return the slab of a touching pair: of two that can be pushed, the first one's."""
    i, j = touching.body_a[k], touching.body_b[k]
    if bodies.kind[i] == DYNAMIC and bodies.kind[j] == DYNAMIC:
        return int(min(direct.trees[i, SLAB], direct.trees[j, SLAB]))
    return int(direct.trees[i, SLAB] if bodies.kind[i] == DYNAMIC else direct.trees[j, SLAB])
