"""The look around: who may be near whom, for as many steps ahead as has been worth while.

Serves: a step. Hides: whether all look around, or only those who left their rooms; and when the
list of pairs is made for longer, and when for less long.
"""

from tamias2d.engine.broad_phase.candidates import fatten_box, find_candidates, sort_candidates
from tamias2d.engine.broad_phase.comoving_frame import choose_frame
from tamias2d.engine.broad_phase.contact_list import replace_contacts
from tamias2d.engine.broad_phase.fat_bounds import fatten_all_bounds
from tamias2d.engine.broad_phase.update import update_incrementally
from tamias2d.engine.tables import (
    ARRANGED,
    CONTACTS,
    FRAME_MOVES,
    HORIZON,
    ISLANDS_KNOWN,
    LIST_HOLDS,
    OUT_OF_BOUNDS,
    ROWS_NEEDED,
    STAGE,
    STEPS_SINCE,
    TIME_STEP,
    UPDATED,
    Bodies,
    BroadPhase,
    ContactBuffers,
    Control,
    Shapes,
    Touching,
    Tree,
)

LONGEST_HORIZON = 64  # steps ahead that a list is made for, at most
SHORTEST_HORIZON = 3  # steps ahead that a list is made for where it is full of pairs
CROWD = 3  # pairs to a shape: where there are more, a list is made for less long
MOST_UPDATED = 0.125  # of all bodies: so many may leave their rooms until all look around again

DONE, MORE_CANDIDATES, MORE_CONTACTS, MORE_BLOCKS, INVALID, MORE_SPARSE = (
    0,
    1,
    2,
    3,
    4,
    5,
)  # of a step
CLEAR = 6  # it is done, and no pair is near
OVERFLOWED = 7  # it is done, and a body's numbers are not finite


def update_pairs(
    marked: int,
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    tree: Tree,
    broad_phase: BroadPhase,
    buffers: ContactBuffers,
    touching: Touching,
) -> bool:
    """Return whether the list of pairs holds, when those who are marked have looked around.

    If it does not, it is known to be of no use: the next call says so, too.
    """
    moves = broad_phase.frame[FRAME_MOVES] != 0.0
    many = marked + broad_phase.counts[UPDATED] > MOST_UPDATED * len(bodies.kind)
    if (
        broad_phase.counts[LIST_HOLDS] == 0
        or many
        or (moves and control.counts[STAGE] == OUT_OF_BOUNDS)
    ):
        broad_phase.counts[LIST_HOLDS] = 0
        for i in range(len(broad_phase.left) if marked > 0 else 0):
            broad_phase.left[i] = 0
        return False
    if marked > 0:
        broad_phase.counts[LIST_HOLDS] = (
            1
            if update_incrementally(control, bodies, shapes, tree, broad_phase, buffers, touching)
            else 0
        )
    return bool(broad_phase.counts[LIST_HOLDS] == 1)


def rebuild_pairs(
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    tree: Tree,
    broad_phase: BroadPhase,
    buffers: ContactBuffers,
    touching: Touching,
) -> int:
    """Make the list of pairs anew, for as many steps ahead as has been worth while."""
    if broad_phase.counts[STEPS_SINCE] > 0:
        if broad_phase.counts[CONTACTS] > CROWD * len(shapes.slot):
            broad_phase.counts[HORIZON] = max(broad_phase.counts[HORIZON] // 2, SHORTEST_HORIZON)
        elif 2 * broad_phase.counts[STEPS_SINCE] >= broad_phase.counts[HORIZON]:
            broad_phase.counts[HORIZON] = min(2 * broad_phase.counts[HORIZON], LONGEST_HORIZON)
        broad_phase.counts[STEPS_SINCE] = 0
    choose_frame(control, bodies, broad_phase, touching)
    fatten_all_bounds(
        bodies, broad_phase, broad_phase.counts[HORIZON] * control.settings[TIME_STEP]
    )
    for k in range(len(shapes.slot)):
        fatten_box(k, bodies, shapes, tree, broad_phase)
    total = find_candidates(bodies, shapes, tree, broad_phase)
    if total > len(broad_phase.candidates):
        control.counts[ROWS_NEEDED] = total
        return MORE_CANDIDATES
    sort_candidates(total, broad_phase.candidates, broad_phase.rank_counts)
    size = replace_contacts(total, shapes, broad_phase, buffers)
    if size > buffers.pairs.shape[1]:
        control.counts[ROWS_NEEDED] = size
        return MORE_CONTACTS
    broad_phase.counts[LIST_HOLDS], broad_phase.counts[UPDATED] = 1, 0
    touching.counts[ARRANGED] = touching.counts[ISLANDS_KNOWN] = 0
    return DONE
