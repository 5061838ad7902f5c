"""The contact list kept valid: updated where few bodies left their bounds, otherwise rebuilt.

It is made for as many steps ahead as has been worth while.
"""

from tamias2d.engine.broad_phase.candidates import find_candidates, sort_candidates
from tamias2d.engine.broad_phase.comoving_frame import choose_frame
from tamias2d.engine.broad_phase.contact_list import replace_contacts
from tamias2d.engine.broad_phase.fat_bounds import fatten_all_bounds
from tamias2d.engine.broad_phase.fat_box import fatten_box
from tamias2d.engine.broad_phase.kept_apart import without_kept_apart
from tamias2d.engine.broad_phase.update import update_incrementally
from tamias2d.engine.tables import (
    ARRANGED,
    CONTACTS,
    DONE,
    FRAME_MOVES,
    HORIZON,
    ISLANDS_KNOWN,
    LEVEL,
    LIST_HOLDS,
    MORE_CANDIDATES,
    MORE_CONTACTS,
    OUT_OF_BOUNDS,
    PART_TIME,
    ROWS_NEEDED,
    STAGE,
    STEPS_SINCE,
    UPDATED,
    Integers,
    World,
)

LONGEST_HORIZON = 64  # steps
SHORTEST_HORIZON = 3  # steps, for a list that is crowded
CROWDED = 3  # contacts to a shape, above which a list is made for fewer steps
TOO_CROWDED = 16  # contacts to a shape, above which it is made anew for less time
MOST_UPDATED = 0.125  # of all bodies: if more leave their bounds, the list is rebuilt


def update_pairs(left: int, world: World) -> bool:
    """Add the candidates of the bodies that left their bounds; return whether the list holds.

    If it does not, it must be rebuilt.
    """
    bodies, broad_phase = world.bodies, world.broad_phase
    counts = broad_phase.counts
    in_flight = world.control.counts[STAGE] == OUT_OF_BOUNDS
    many = left + counts[UPDATED] > MOST_UPDATED * len(bodies.kind)
    moves = broad_phase.frame[FRAME_MOVES] != 0.0
    if counts[LIST_HOLDS] == 0 or many or (moves and in_flight):
        counts[LIST_HOLDS] = 0
        for i in range(len(broad_phase.left) if left > 0 else 0):
            broad_phase.left[i] = 0
        return False
    if left > 0:
        counts[LIST_HOLDS] = 1 if update_incrementally(world) else 0
    return bool(counts[LIST_HOLDS] == 1)


def rebuild_pairs(world: World) -> int:
    """Make the contact list anew; return DONE, or which array is too short."""
    bodies, shapes, broad_phase = world.bodies, world.shapes, world.broad_phase
    control = world.control
    counts = broad_phase.counts
    choose_horizon(len(shapes.slot), counts)
    choose_frame(control, bodies, broad_phase, world.touching)
    total = find_ahead(world)
    while total > TOO_CROWDED * len(shapes.slot) and counts[HORIZON] > 1:
        counts[HORIZON] //= 2
        total = find_ahead(world)
    total = without_kept_apart(total, world.state, broad_phase, world.joints)
    if total > len(broad_phase.candidates):
        control.counts[ROWS_NEEDED] = total
        return MORE_CANDIDATES
    sort_candidates(total, broad_phase)
    size = replace_contacts(total, control.counts[LEVEL] > 0, shapes, broad_phase, world.buffers)
    if size > world.buffers.pairs.shape[1]:
        control.counts[ROWS_NEEDED] = size
        return MORE_CONTACTS
    counts[LIST_HOLDS], counts[UPDATED] = 1, 0
    world.touching.counts[ARRANGED] = world.touching.counts[ISLANDS_KNOWN] = 0
    return DONE


def find_ahead(world: World) -> int:
    """Find the pairs that may meet within the horizon; return how many."""
    bodies, shapes, tree, broad_phase = world.bodies, world.shapes, world.tree, world.broad_phase
    ahead = broad_phase.counts[HORIZON] * world.control.progress[PART_TIME]
    fatten_all_bounds(bodies, broad_phase, ahead)
    for s in range(len(shapes.slot)):
        fatten_box(s, bodies, shapes, tree, broad_phase)
    return find_candidates(bodies, shapes, tree, broad_phase)


def choose_horizon(shapes: int, counts: Integers) -> None:
    """Choose for how many steps the list is made, by how long the last one held."""
    if counts[STEPS_SINCE] > 0:
        if counts[CONTACTS] > CROWDED * shapes:
            counts[HORIZON] = max(counts[HORIZON] // 2, SHORTEST_HORIZON)
        elif 2 * counts[STEPS_SINCE] >= counts[HORIZON]:
            counts[HORIZON] = min(2 * counts[HORIZON], LONGEST_HORIZON)
        counts[STEPS_SINCE] = 0
