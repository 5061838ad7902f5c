"""The list of pairs mended: only those look around who have left their rooms.

Serves: the look around. Hides: the tree, whose boxes grow with those that have new rooms, until all
look around again. That is cheap where a few of many move unlike what was foreseen.
"""

from tamias2d.state import Array
from tamias2d.stepped.homes import mean_reach, settle_one
from tamias2d.stepped.layout import (
    ABSENT,
    FAT,
    HALF_PLANE,
    HORIZON,
    LEAVES,
    MENDED,
    PLACE,
    SIDE,
    STARTS,
    TIME_STEP,
    Whole,
)
from tamias2d.stepped.pair_list import add_pairs
from tamias2d.stepped.pairs import (
    boxes_overlap,
    circles_apart,
    fatten,
    foremost,
    know_middle,
    may_meet,
    note_pair,
    reaches,
    sides_apart,
    sort_pairs,
)
from tamias2d.stepped.tree import BUNCH, lowest
from tamias2d.stepped.turning import turn_shape


def mend(
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
    """Give marked bodies new rooms, and add their pairs; return whether there was room for all.

    `used` (n+1,) holds the marks, and is zero in the end.
    """
    resettle(settings, counts, kind, pose, motion, body, home, used)
    for s in range(len(shape_body)):
        if used[shape_body[s]] == 1:
            turn_shape(s, shape_body, shape_kind, shape_first, shape_count, pose, corner, turned)
            fatten(
                s, shape_body, shape_kind, shape_first, shape_count, shape_radius, kind, body,
                home, turned, box,
            )  # fmt: skip
            if shape_kind[s] != HALF_PLANE:
                regrow(curve[PLACE, s], s, counts[LEAVES], box, node)
                know_middle(curve[PLACE, s], s, shape_body, surface, kind, body, home, middle)
    total = 0
    for s in range(len(shape_body)):
        if shape_kind[s] == HALF_PLANE:
            total = beside(
                total, s, shape_body, shape_kind, shape_first, kind, filters, used, ranked, turned,
                box, found, home,
            )  # fmt: skip
        elif used[shape_body[s]] == 1:
            total = near_one(
                total, s, counts[LEAVES], shape_body, shape_first, shape_count, shape_radius,
                filters, kind, used, ranked, turned, box, curve, node, middle, found, pose,
                motion, home,
            )  # fmt: skip
    for i in range(len(used)):
        used[i] = 0
    side = counts[SIDE]
    if total > len(found):
        return False
    sort_pairs(total, found, curve[3, : len(shape_body) + 1])
    return add_pairs(
        total, counts, ranked, shape_body, found, curve[STARTS], pairs[side], touches[side],
        traces[side],
    )  # fmt: skip


def resettle(
    settings: Array,
    counts: Whole,
    kind: Whole,
    pose: Array,
    motion: Array,
    body: Array,
    home: Array,
    used: Whole,
) -> None:
    """Give marked bodies new rooms."""
    mean = mean_reach(kind, body)
    ahead = counts[HORIZON] * settings[TIME_STEP]
    for i in range(len(kind)):
        if used[i] == 1:
            settle_one(i, mean, settings, ahead, kind, pose, motion, body, home)
            counts[MENDED] += 1


def regrow(leaf: int, s: int, leaves: int, box: Array, node: Array) -> None:
    """Let a leaf have the box of its shape, and the nodes above it be large enough."""
    for n in range(4):
        box[leaf, n] = box[s, FAT + n]
    at = lowest(leaves) + leaf // BUNCH
    while at > 0:
        node[at, 0], node[at, 1] = min(node[at, 0], box[leaf, 0]), min(node[at, 1], box[leaf, 1])
        node[at, 2], node[at, 3] = max(node[at, 2], box[leaf, 2]), max(node[at, 3], box[leaf, 3])
        at >>= 1


def near_one(
    total: int,
    s: int,
    leaves: int,
    shape_body: Whole,
    shape_first: Whole,
    shape_count: Whole,
    shape_radius: Array,
    filters: Whole,
    kind: Whole,
    used: Whole,
    ranked: Whole,
    turned: Array,
    box: Array,
    curve: Whole,
    node: Array,
    middle: Array,
    found: Whole,
    pose: Array,
    motion: Array,
    home: Array,
) -> int:
    """Note the bounded shapes that one may meet; of two that both look, the later one does."""
    k = curve[PLACE, s]
    here = box[k]
    first = lowest(leaves)
    at = 1
    while True:
        while at < first and boxes_overlap(here, node[at]):
            at = 2 * at
        if at >= first and boxes_overlap(here, node[at]):
            start = (at - first) * BUNCH
            for m in range(start, min(start + BUNCH, leaves)):
                t = curve[0, m]
                if (
                    boxes_overlap(here, box[m])
                    and (used[shape_body[t]] == 0 or t < s)
                    and not circles_apart(middle[k], middle[m])
                    and may_meet(s, t, shape_body, kind, filters)
                    and not sides_apart(
                        k, m, curve, middle, shape_body, shape_first, shape_count, shape_radius,
                        pose, motion, home, turned,
                    )
                ):  # fmt: skip
                    total = note_pair(total, s, t, ranked, found)
        while at & 1:  # up, until there is a node to the right
            at >>= 1
        if at == 0:
            return total
        at += 1


def beside(
    total: int,
    s: int,
    shape_body: Whole,
    shape_kind: Whole,
    shape_first: Whole,
    kind: Whole,
    filters: Whole,
    used: Whole,
    ranked: Whole,
    turned: Array,
    box: Array,
    found: Whole,
    home: Array,
) -> int:
    """Note the shapes that may meet a half-plane, if they have left, or it has."""
    i = shape_body[s]
    if kind[i] == ABSENT:
        return total
    offset = foremost(s, shape_body, shape_first, turned, home)
    side = turned[shape_first[s]]
    for t in range(len(shape_body)):
        j = shape_body[t]
        if (
            used[i] + used[j] > 0
            and shape_kind[t] != HALF_PLANE
            and kind[j] != ABSENT
            and reaches(t, offset, side, box)
            and may_meet(s, t, shape_body, kind, filters)
        ):
            total = note_pair(total, s, t, ranked, found)
    return total
