"""The look around: who may be near whom, for as many steps ahead as has been worth while.

Serves: a step. Hides: when the list of pairs is made for longer, and when for less long.
"""

from tamias2d.state import (
    Array,
)
from tamias2d.stepped.layout import (
    HORIZON,
    NEEDED,
    PAIRS,
    SINCE,
    STATIC,
    STILL,
    TIME_STEP,
    Whole,
)
from tamias2d.stepped.pairs import (
    LONGEST,
    choose_frame,
    fatten,
    find_pairs,
    settle,
    sort_pairs,
    take_over,
    turn_corners,
)

DONE, MORE_FOUND, MORE_PAIRS, MORE_BLOCKS, UNSOUND, MORE_WEB = 0, 1, 2, 3, 4, 5  # of a step


def look_around(
    settings: Array,
    counts: Whole,
    pose: Array,
    motion: Array,
    body: Array,
    home: Array,
    kind: Whole,
    ranked: Whole,
    shape_body: Whole,
    shape_kind: Whole,
    shape_first: Whole,
    shape_count: Whole,
    shape_radius: Array,
    surface: Array,
    filters: Whole,
    mixed: Array,
    corner: Array,
    turned: Array,
    box: Array,
    curve: Whole,
    node: Array,
    found: Whole,
    pairs: Whole,
    touches: Array,
    traces: Whole,
) -> int:
    """Make the list of pairs anew, for as many steps ahead as has been worth while."""
    if counts[SINCE] > 0:
        if counts[PAIRS] > 2 * len(shape_body):
            counts[HORIZON] = max(counts[HORIZON] // 2, 2)
        elif 2 * counts[SINCE] >= counts[HORIZON]:
            counts[HORIZON] = min(2 * counts[HORIZON], LONGEST)
        counts[SINCE] = 0
    turn_corners(
        shape_body, shape_kind, shape_first, shape_count, kind, STATIC, pose, corner, turned
    )
    choose_frame(settings, counts, kind, motion)
    settle(settings, counts[HORIZON] * settings[TIME_STEP], kind, pose, motion, body, home)
    fatten(
        shape_body,
        shape_kind,
        shape_first,
        shape_count,
        shape_radius,
        kind,
        body,
        home,
        turned,
        box,
    )
    total = find_pairs(
        counts,
        shape_kind,
        shape_body,
        filters,
        kind,
        ranked,
        box,
        curve,
        node,
        turned,
        shape_first,
        found,
        pose,
        home,
    )
    if total > len(found):
        counts[NEEDED] = total
        return MORE_FOUND
    sort_pairs(total, found, curve[3, : len(shape_body) + 1])
    size = take_over(total, counts, ranked, found, surface, mixed, pairs, touches, traces)
    if size > pairs.shape[1]:
        counts[NEEDED] = size
        return MORE_PAIRS
    counts[STILL] = 1
    return DONE
