"""The arrangement of contacts: slabs, blocks, thin islands, and which bodies take part.

Serves: a step. Hides: that all of it stays from step to step while the same pairs touch.
"""

from tamias2d.state import Array
from tamias2d.stepped.layout import (
    ACTIVE,
    ACTIVE_BODY,
    ARRANGED,
    BOUNCING,
    HIT_A,
    HIT_B,
    HITS,
    KINEMATIC,
    NEEDED,
    SEATED,
    THIN,
    Whole,
)
from tamias2d.stepped.rows import colour, count_lanes, give_places
from tamias2d.stepped.slabs import divide
from tamias2d.stepped.surroundings import DONE, MORE_BLOCKS, MORE_WEB
from tamias2d.stepped.thin import number_islands, plan


def arrange(
    counts: Whole,
    trace: Whole,
    kind: Whole,
    used: Whole,
    pose: Array,
    body: Array,
    hits: Whole,
    fill: Whole,
    slabs: Whole,
    rows: Array,
    lanes: Whole,
    isle: Whole,
    web: Whole,
) -> int:
    """Arrange what touches, and mark the bodies that take part; or say what has too little room."""
    if counts[ARRANGED] == 1:
        for k in range(counts[ACTIVE]):
            used[hits[ACTIVE_BODY, k]] = 1
        return DONE
    colour(counts, trace, kind, hits, used)
    mark_active(counts, kind, used, hits)
    islands = number_islands(counts, kind, hits, isle, web)
    if islands >= 0:
        divide(islands, counts, kind, used, pose, body, hits, isle, slabs)
        needed = give_places(counts, hits, fill, slabs)
        if needed > len(rows):
            counts[NEEDED] = needed
            return MORE_BLOCKS
        islands = plan(islands, counts, kind, hits, isle, web)
    if islands < 0:
        counts[NEEDED] = -islands
        return MORE_WEB
    counts[THIN] = islands
    count_lanes(counts, hits, lanes)
    counts[ARRANGED], counts[SEATED], counts[BOUNCING] = 1, 0, 0
    return DONE


def mark_active(counts: Whole, kind: Whole, used: Whole, hits: Whole) -> None:
    """List the moving bodies that have contacts, in the order of touching.

    Their colours, which are not needed any more, become marks.
    """
    for i in range(len(used)):
        used[i] = 0
    active = 0
    for k in range(counts[HITS]):
        for i in (hits[HIT_A, k], hits[HIT_B, k]):
            if used[i] == 0 and kind[i] >= KINEMATIC:
                used[i] = 1
                hits[ACTIVE_BODY, active] = i
                active += 1
    counts[ACTIVE] = active
