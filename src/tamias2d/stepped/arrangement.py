"""The arrangement of contacts: blocks, thin islands, and which bodies take part.

Serves: a step. Hides: that all of it stays from step to step while the same pairs touch.
"""

from tamias2d.state import Array
from tamias2d.stepped.layout import (
    ACTIVE,
    ACTIVE_BODY,
    ACTIVE_ROW,
    ARRANGED,
    HIT_A,
    HIT_B,
    HITS,
    KINEMATIC,
    NEEDED,
    SEATED,
    THIN,
    Whole,
)
from tamias2d.stepped.rows import clear_lanes, colour
from tamias2d.stepped.surroundings import DONE, MORE_BLOCKS, MORE_WEB
from tamias2d.stepped.thin import plan


def arrange(
    counts: Whole,
    trace: Whole,
    kind: Whole,
    used: Whole,
    hits: Whole,
    fill: Whole,
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
    needed = colour(counts, trace, kind, hits, used, fill)
    if needed > len(rows):
        counts[NEEDED] = needed
        return MORE_BLOCKS
    counts[THIN] = plan(counts, kind, hits, fill, isle, web)
    if counts[THIN] < 0:
        counts[NEEDED] = -counts[THIN]
        return MORE_WEB
    mark_active(counts, kind, used, hits)
    clear_lanes(len(used) - 1, fill, rows, lanes)
    counts[ARRANGED], counts[SEATED] = 1, 0
    return DONE


def mark_active(
    counts: Whole,
    kind: Whole,
    used: Whole,
    hits: Whole,
) -> int:
    """List the moving bodies that have contacts; return how many.

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
    listed = 0
    for i in range(len(kind)):
        if used[i] == 1:
            hits[ACTIVE_ROW, listed] = i
            listed += 1
    return active
