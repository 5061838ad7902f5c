"""Groups: the bodies that springs, contacts and impacts of a part of a step connect (DD91).

Beyond an island a group is connected by springs and by what has met in flight. Cost: where springs
are in the world and something was met, a visit to each body and each pair near it. Source: Tarjan
and van Leeuwen (1984), union with path halving.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.sprung import join_mechanisms, mark_sprung_mechanisms
from tamias2d.engine.solver.support import FREE, support_island
from tamias2d.engine.tables import Bodies, Contacts, Integers, Islands, World


def find_groups(flown: bool, world: World, contacts: Contacts) -> None:
    """Give each body its group, and note at its root what connects and supports it."""
    bodies, springs, touching = world.bodies, world.springs, world.touching
    group = springs.group
    for i in range(len(bodies.kind)):
        group[i] = i
    for n in range(springs.counts[tb.NETWORKS]):
        first, last = springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]
        one = first_free(first, last, world)
        for k in range(first, last):
            unite(one, springs.slot[k], bodies, group)
    join_mechanisms(world)
    for k in range(touching.counts[tb.TOUCHING]):
        unite(touching.body_a[k], touching.body_b[k], bodies, group)
    for p in range(world.broad_phase.counts[tb.CONTACTS] if flown else 0):
        i, j = contacts.pairs[p, tb.SLOT_A], contacts.pairs[p, tb.SLOT_B]
        if is_redirected(i, bodies) and is_redirected(j, bodies):
            unite(i, j, bodies, group)
    for i in range(len(bodies.kind)):
        group[i] = root_of_group(i, group)
    begin_groups(bodies, world.islands)
    mark_networks(world)
    mark_sprung_mechanisms(world)
    mark_touched(world)
    if flown:
        mark_met(world, contacts)


def first_free(first: int, last: int, world: World) -> int:
    """Return the first body of some members that moves freely, or any of them."""
    slot = world.springs.slot
    for k in range(first, last):
        if world.bodies.kind[slot[k]] == tb.DYNAMIC:
            return int(slot[k])
    return int(slot[first])


def unite(i: int, j: int, bodies: Bodies, group: Integers) -> None:
    """Make one group of those of two bodies, if both move freely."""
    if bodies.kind[i] == tb.DYNAMIC and bodies.kind[j] == tb.DYNAMIC:
        i, j = root_of_group(i, group), root_of_group(j, group)
        group[max(i, j)] = min(i, j)


def root_of_group(i: int, group: Integers) -> int:
    """Return the root of a body's group as far as it is known."""
    while group[i] != i:
        group[i] = group[group[i]]
        i = group[i]
    return i


def is_redirected(i: int, bodies: Bodies) -> bool:
    """Return whether an impact has redirected a body that moves freely, in a part with flights."""
    return bool(bodies.kind[i] == tb.DYNAMIC and bodies.flight[i, tb.REDIRECTED] > 0.0)


def begin_groups(bodies: Bodies, islands: Islands) -> None:
    """Let no group be supported, or have anything yet."""
    for i in range(len(bodies.kind)):
        row = islands.energy[i]
        row[tb.SUPPORT], row[tb.DRIVEN_RATE], row[tb.SPRUNG], row[tb.MET] = FREE, 0.0, 0.0, 0.0
        row[tb.REFERENCE] = row[tb.REFERENCE + 1] = row[tb.REFERENCE + 2] = 0.0
        row[tb.SPRING_GAIN] = row[tb.HELD_EXCESS] = 0.0


def mark_networks(world: World) -> None:
    """Note which groups have networks, and what supports these."""
    bodies, springs, islands = world.bodies, world.springs, world.islands
    for n in range(springs.counts[tb.NETWORKS]):
        first, last = springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]
        root = springs.group[first_free(first, last, world)]
        islands.energy[root, tb.SPRUNG] = 1.0
        for k in range(first, last):
            if bodies.kind[springs.slot[k]] != tb.DYNAMIC:
                support_island(springs.slot[k], root, bodies, islands)
        for s in range(springs.networks[n, tb.N_SPRING], springs.networks[n + 1, tb.N_SPRING]):
            if springs.ends[s, tb.MEMBER_B] < 0:  # the idle body stands, as the plane does
                support_island(len(bodies.kind) - 1, root, bodies, islands)


def mark_touched(world: World) -> None:
    """Note which groups contacts have acted on, and what supports these."""
    bodies, touching = world.bodies, world.touching
    for k in range(touching.counts[tb.TOUCHING]):
        mark_pair(touching.body_a[k], touching.body_b[k], bodies, world)


def mark_pair(i: int, j: int, bodies: Bodies, world: World) -> None:
    """Note that two bodies have met: where one does not move freely, it supports the other."""
    if bodies.kind[i] != tb.DYNAMIC:
        i, j = j, i
    if bodies.kind[i] == tb.DYNAMIC:
        root = world.springs.group[i]
        world.islands.energy[root, tb.MET] = 1.0
        if bodies.kind[j] != tb.DYNAMIC:
            support_island(j, root, bodies, world.islands)


def mark_met(world: World, contacts: Contacts) -> None:
    """Note the same of impacts in flight: what redirected a body told of it, or carries it."""
    bodies = world.bodies
    for i in range(len(bodies.kind)):
        if is_redirected(i, bodies):
            world.islands.energy[world.springs.group[i], tb.MET] = 1.0
    for p in range(world.broad_phase.counts[tb.CONTACTS]):
        i, j = contacts.pairs[p, tb.SLOT_A], contacts.pairs[p, tb.SLOT_B]
        carried = max(bodies.flight[i, tb.REDIRECTED], bodies.flight[j, tb.REDIRECTED]) > 1.0
        told = contacts.flags[p, tb.TOUCHES] & tb.IS_TOUCHING > 0
        met = is_redirected(i, bodies) or is_redirected(j, bodies)
        if met and (told or carried) and contacts.flags[p, tb.SENSES] == 0:
            mark_pair(i, j, bodies, world)
