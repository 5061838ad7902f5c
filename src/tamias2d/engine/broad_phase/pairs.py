"""The contact list kept valid: updated where few bodies left their bounds, otherwise rebuilt.

It is made for as many steps ahead as has been worth while; of few shapes for all steps to come.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.broad_phase.all_pairs import few_shapes, find_all_pairs
from tamias2d.engine.broad_phase.candidates import find_candidates, sort_candidates
from tamias2d.engine.broad_phase.comoving_frame import choose_frame
from tamias2d.engine.broad_phase.contact_list import replace_contacts
from tamias2d.engine.broad_phase.fat_bounds import fatten_all_bounds
from tamias2d.engine.broad_phase.fat_box import fatten_box
from tamias2d.engine.broad_phase.kept_apart import without_kept_apart
from tamias2d.engine.broad_phase.update import update_incrementally
from tamias2d.engine.tables import BroadPhase, Integers, World
from tamias2d.kernels.assembled import inlined

LONGEST_HORIZON = 64  # steps
SHORTEST_HORIZON = 3  # steps, for a list that is crowded
CROWDED = 3  # contacts to a shape, above which a list is made for fewer steps
TOO_CROWDED = 16  # contacts to a shape, above which it is made anew for less time
MOST_UPDATED = 0.125  # of all bodies: if more leave their bounds, the list is rebuilt


@inlined
def list_stays(left: int, broad_phase: BroadPhase) -> bool:
    """Return whether the list holds as it is, since none of the bodies has left its bounds."""
    counts = broad_phase.counts
    return bool((left == 0) & (counts[tb.LIST_HOLDS] == 1) & (counts[tb.UPDATED] == 0))


def update_pairs(left: int, world: World) -> bool:
    """Add the candidates of the bodies that left their bounds; return whether the list holds.

    If it does not, it must be rebuilt.
    """
    bodies, broad_phase = world.bodies, world.broad_phase
    counts = broad_phase.counts
    in_flight = world.control.counts[tb.STAGE] == tb.OUT_OF_BOUNDS
    many = left + counts[tb.UPDATED] > MOST_UPDATED * len(bodies.kind)
    moves = broad_phase.frame[tb.FRAME_MOVES] != 0.0
    many = many or (left > 0 and few_shapes(bodies, world.shapes))
    if counts[tb.LIST_HOLDS] == 0 or many or (moves and in_flight):
        counts[tb.LIST_HOLDS] = 0
        for i in range(len(broad_phase.left) if left > 0 else 0):
            broad_phase.left[i] = 0
        return False
    if left > 0:
        counts[tb.LIST_HOLDS] = 1 if update_incrementally(world) else 0
    return bool(counts[tb.LIST_HOLDS] == 1)


def rebuild_pairs(world: World) -> int:
    """Make the contact list anew; return DONE, or which array is too short."""
    bodies, shapes, broad_phase = world.bodies, world.shapes, world.broad_phase
    control = world.control
    counts = broad_phase.counts
    few = few_shapes(bodies, shapes)
    total = find_all_pairs(world) if few else find_for_long(world)
    total = without_kept_apart(total, world.state, broad_phase, world.joints)
    if total > len(broad_phase.candidates):
        control.counts[tb.ROWS_NEEDED] = total
        return tb.MORE_CANDIDATES
    sort_candidates(total, broad_phase)
    size = replace_contacts(total, control.counts[tb.LEVEL] > 0, shapes, broad_phase, world.buffers)
    if size > world.buffers.pairs.shape[1]:
        control.counts[tb.ROWS_NEEDED] = size
        return tb.MORE_CONTACTS
    counts[tb.LIST_HOLDS], counts[tb.UPDATED] = 1, 0
    world.touching.counts[tb.ARRANGED] = world.touching.counts[tb.ISLANDS_KNOWN] = 0
    return tb.DONE


def find_for_long(world: World) -> int:
    """Find the pairs that may meet for as long as is worth while; return how many."""
    shapes, counts = len(world.shapes.slot), world.broad_phase.counts
    choose_horizon(shapes, counts)
    choose_frame(world.control, world.bodies, world.broad_phase, world.touching)
    total = find_ahead(world)
    while total > TOO_CROWDED * shapes and counts[tb.HORIZON] > 1:
        counts[tb.HORIZON] //= 2
        total = find_ahead(world)
    return total


def find_ahead(world: World) -> int:
    """Find the pairs that may meet within the horizon; return how many."""
    bodies, shapes, tree, broad_phase = world.bodies, world.shapes, world.tree, world.broad_phase
    ahead = broad_phase.counts[tb.HORIZON] * world.control.progress[tb.PART_TIME]
    fatten_all_bounds(bodies, broad_phase, ahead)
    for s in range(len(shapes.slot)):
        fatten_box(s, bodies, shapes, tree, broad_phase)
    return find_candidates(bodies, shapes, tree, broad_phase)


def choose_horizon(shapes: int, counts: Integers) -> None:
    """Choose for how many steps the list is made, by how long the last one held."""
    if counts[tb.STEPS_SINCE] > 0:
        if counts[tb.CONTACTS] > CROWDED * shapes:
            counts[tb.HORIZON] = max(counts[tb.HORIZON] // 2, SHORTEST_HORIZON)
        elif 2 * counts[tb.STEPS_SINCE] >= counts[tb.HORIZON]:
            counts[tb.HORIZON] = min(2 * counts[tb.HORIZON], LONGEST_HORIZON)
        counts[tb.STEPS_SINCE] = 0
