"""The look around: who may be near whom, for as many steps ahead as has been worth while.

Serves: a step. Hides: whether all look around, or only those who left their rooms; and when the
list of pairs is made for longer, and when for less long.
"""

from tamias2d.state import (
    Array,
)
from tamias2d.stepped.frame import choose_frame
from tamias2d.stepped.homes import settle
from tamias2d.stepped.layout import (
    ARRANGED,
    FRAME_MOVES,
    HORIZON,
    ISLANDED,
    MENDED,
    NEEDED,
    OUTRUN,
    PAIRS,
    PHASE,
    SINCE,
    STARTS,
    STILL,
    TIME_STEP,
    Whole,
)
from tamias2d.stepped.mending import mend
from tamias2d.stepped.pair_list import take_over
from tamias2d.stepped.pairs import fatten, find_pairs, sort_pairs

LONGEST = 64  # steps ahead that a list is made for, at most
SHORTEST = 3  # steps ahead that a list is made for where it is full of pairs
CROWD = 3  # pairs to a shape: where there are more, a list is made for less long
MENDABLE = 0.125  # of all bodies: so many may leave their rooms until all look around again

DONE, MORE_FOUND, MORE_PAIRS, MORE_BLOCKS, UNSOUND, MORE_WEB = 0, 1, 2, 3, 4, 5  # of a step
CLEAR = 6  # it is done, and no pair is near


def look_again(
    marked: int,
    settings: Array,
    counts: Whole,
    pose: Array,
    motion: Array,
    body: Array,
    home: Array,
    kind: Whole,
    used: Whole,
    ranked: Whole,
    shape_body: Whole,
    shape_kind: Whole,
    shape_first: Whole,
    shape_count: Whole,
    shape_radius: Array,
    surface: Array,
    filters: Whole,
    corner: Array,
    turned: Array,
    box: Array,
    curve: Whole,
    node: Array,
    middle: Array,
    found: Whole,
    pairs: Whole,
    touches: Array,
    traces: Whole,
) -> bool:
    """Return whether the list of pairs holds, when those who are marked have looked around.

    If it does not, it is known to be of no use: the next call says so, too.
    """
    moves = settings[FRAME_MOVES] != 0.0
    many = marked + counts[MENDED] > MENDABLE * len(kind)
    if counts[STILL] == 0 or many or (moves and counts[PHASE] == OUTRUN):
        counts[STILL] = 0
        for i in range(len(used) if marked > 0 else 0):
            used[i] = 0
        return False
    if marked > 0:
        counts[STILL] = 1 if mend(
            settings, counts, pose, motion, body, home, kind, used, ranked, shape_body,
            shape_kind, shape_first, shape_count, shape_radius, surface, filters, corner,
            turned, box, curve, node, middle, found, pairs, touches, traces,
        ) else 0  # fmt: skip
    return bool(counts[STILL] == 1)


def look_around(
    settings: Array,
    counts: Whole,
    pose: Array,
    motion: Array,
    load: Array,
    body: Array,
    flows: Array,
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
    turned: Array,
    box: Array,
    curve: Whole,
    node: Array,
    middle: Array,
    found: Whole,
    pairs: Whole,
    touches: Array,
    traces: Whole,
) -> int:
    """Make the list of pairs anew, for as many steps ahead as has been worth while."""
    if counts[SINCE] > 0:
        if counts[PAIRS] > CROWD * len(shape_body):
            counts[HORIZON] = max(counts[HORIZON] // 2, SHORTEST)
        elif 2 * counts[SINCE] >= counts[HORIZON]:
            counts[HORIZON] = min(2 * counts[HORIZON], LONGEST)
        counts[SINCE] = 0
    choose_frame(settings, counts, kind, motion, load, body, flows)
    settle(settings, counts[HORIZON] * settings[TIME_STEP], kind, pose, motion, body, home)
    for k in range(len(shape_body)):
        fatten(
            k, shape_body, shape_kind, shape_first, shape_count, shape_radius, kind, body, home,
            turned, box,
        )  # fmt: skip
    total = find_pairs(
        counts, shape_kind, shape_body, shape_first, shape_count, shape_radius, surface, filters,
        kind, ranked, turned, box, curve, node, middle, found, pose, motion, body,
        home,
    )  # fmt: skip
    if total > len(found):
        counts[NEEDED] = total
        return MORE_FOUND
    sort_pairs(total, found, curve[3, : len(shape_body) + 1])
    size = take_over(
        total, counts, ranked, shape_body, found, curve[STARTS], pairs, touches, traces
    )  # fmt: skip
    if size > pairs.shape[1]:
        counts[NEEDED] = size
        return MORE_PAIRS
    counts[STILL], counts[MENDED] = 1, 0
    counts[ARRANGED] = counts[ISLANDED] = 0
    return DONE
