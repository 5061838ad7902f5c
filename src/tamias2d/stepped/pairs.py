"""Pairs of shapes that may touch before a body leaves its room.

Serves: the look around. Hides: what is ruled out, by boxes, circles and sides.
"""

from math import sqrt

from tamias2d.state import Array
from tamias2d.stepped.layout import (
    ABSENT,
    CATEGORY,
    DTURN,
    DYNAMIC,
    FAT,
    GROUP,
    HALF_HEIGHT,
    HALF_PLANE,
    HALF_WIDTH,
    HIGH_X,
    HIGH_Y,
    HOME_TURN,
    LEAVES,
    LOW_X,
    LOW_Y,
    MASK,
    MIDDLE_REACH,
    MIDDLE_X,
    MIDDLE_Y,
    PLACE,
    REACH,
    SHAPE_REACH,
    TURN,
    TURN_ROOM,
    Whole,
)
from tamias2d.stepped.tree import BUNCH, FAR, grow_tree, lowest

AROUND = 0.12  # of the reach: how far around a shape others must be known
LONGER = 3.0  # than another shape: what is looked at by its sides, and not as a circle


def fatten(
    s: int,
    shape_body: Whole,
    shape_kind: Whole,
    shape_first: Whole,
    shape_count: Whole,
    shape_radius: Array,
    kind: Whole,
    body: Array,
    home: Array,
    turned: Array,
    box: Array,
) -> None:
    """Put a box around a shape: wherever its body may be at home, and what is near it there."""
    i = shape_body[s]
    if shape_kind[s] == HALF_PLANE or kind[i] == ABSENT:
        return
    low_x, low_y, high_x, high_y = FAR, FAR, -FAR, -FAR
    far = 0.0
    for k in range(shape_first[s], shape_first[s] + shape_count[s]):
        x, y = turned[k, 0], turned[k, 1]
        low_x, high_x = min(low_x, x), max(high_x, x)
        low_y, high_y = min(low_y, y), max(high_y, y)
        far = max(far, x * x + y * y)
    more = shape_radius[s]
    if kind[i] == DYNAMIC:
        more += AROUND * body[i, REACH]
    if far > 0.0:  # what turning may do to corners
        more += min(home[i, TURN_ROOM], 2.0) * sqrt(far)
    box[s, FAT], box[s, FAT + 2] = home[i, LOW_X] + low_x - more, home[i, HIGH_X] + high_x + more
    box[s, FAT + 1] = home[i, LOW_Y] + low_y - more
    box[s, FAT + 3] = home[i, HIGH_Y] + high_y + more


def find_pairs(
    counts: Whole,
    shape_kind: Whole,
    shape_body: Whole,
    shape_first: Whole,
    shape_count: Whole,
    shape_radius: Array,
    surface: Array,
    filters: Whole,
    kind: Whole,
    ranked: Whole,
    turned: Array,
    box: Array,
    curve: Whole,
    node: Array,
    middle: Array,
    found: Whole,
    pose: Array,
    motion: Array,
    body: Array,
    home: Array,
) -> int:
    """Put all pairs that may meet at home into `found`, unsorted, as ranks; return how many.

    If there is no room for all of them, only their number is right.
    """
    leaves = grow_tree(shape_kind, shape_body, kind, ranked, box, curve, node)
    counts[LEAVES] = leaves
    for k in range(leaves):
        s = curve[0, k]
        curve[PLACE, s] = k
        for n in range(4):
            box[k, n] = box[s, FAT + n]
        know_middle(k, s, shape_body, surface, kind, body, home, middle)
    near = overlaps(leaves, box, node, found)
    if near > len(found):
        return near
    total = 0
    for p in range(near):
        k, m = found[p, 2], found[p, 3]
        if circles_apart(middle[k], middle[m]):
            continue
        s, t = curve[0, k], curve[0, m]
        if may_meet(s, t, shape_body, kind, filters) and not sides_apart(
            k, m, curve, middle, shape_body, shape_first, shape_count, shape_radius, pose, motion,
            home, turned,
        ):  # fmt: skip
            total = note_pair(total, s, t, ranked, found)
    for s in range(len(shape_kind)):
        if shape_kind[s] == HALF_PLANE and kind[shape_body[s]] != ABSENT:
            offset = foremost(s, shape_body, shape_first, turned, home)
            side = turned[shape_first[s]]
            for k in range(leaves):
                t = curve[0, k]
                if reaches(t, offset, side, box) and may_meet(s, t, shape_body, kind, filters):
                    total = note_pair(total, s, t, ranked, found)
    return total


def overlaps(leaves: int, box: Array, node: Array, found: Whole) -> int:
    """Write which leaves overlap which to the columns 2 and 3 of `found`; return how many.

    All leaves of a bunch look together for bunches that theirs overlaps, on their right in the
    tree: those before have found them. If there is no room for all, the number is too large.
    """
    total = 0
    first = lowest(leaves)
    room = len(found) - BUNCH * BUNCH
    for bunch in range((leaves + BUNCH - 1) // BUNCH):
        here = node[first + bunch]
        at = first + bunch
        while True:
            while at < first and boxes_overlap(here, node[at]):
                at = 2 * at
            if at >= first and boxes_overlap(here, node[at]):
                other = (at - first) * BUNCH
                for k in range(bunch * BUNCH, min(bunch * BUNCH + BUNCH, leaves)):
                    for m in range(max(k + 1, other), min(other + BUNCH, leaves)):
                        if total <= room:  # written in any case, and kept where they overlap
                            found[total, 2], found[total, 3] = k, m
                        total += 1 if boxes_overlap(box[k], box[m]) else 0
            while at & 1:  # up, until there is a node to the right
                at >>= 1
            if at == 0:
                break
            at += 1
    return total if total <= room else total + BUNCH * BUNCH


def boxes_overlap(one: Array, other: Array) -> bool:
    """Return whether two boxes have a common point."""
    return bool(
        (one[0] <= other[2]) & (one[2] >= other[0]) & (one[1] <= other[3]) & (one[3] >= other[1])
    )


def know_middle(
    k: int,
    s: int,
    shape_body: Whole,
    surface: Array,
    kind: Whole,
    body: Array,
    home: Array,
    middle: Array,
) -> None:
    """Write where a shape's body is at home, and how far it is known, to the k-th row."""
    i, here = shape_body[s], middle[k]
    more = AROUND * body[i, REACH] if kind[i] == DYNAMIC else 0.0
    here[MIDDLE_X] = 0.5 * (home[i, LOW_X] + home[i, HIGH_X])
    here[MIDDLE_Y] = 0.5 * (home[i, LOW_Y] + home[i, HIGH_Y])
    here[HALF_WIDTH] = 0.5 * (home[i, HIGH_X] - home[i, LOW_X]) + more
    here[HALF_HEIGHT] = 0.5 * (home[i, HIGH_Y] - home[i, LOW_Y]) + more
    here[MIDDLE_REACH] = surface[s, SHAPE_REACH]


def circles_apart(one: Array, other: Array) -> bool:
    """Return whether the circles of two shapes stay apart while their bodies are at home."""
    x = abs(other[MIDDLE_X] - one[MIDDLE_X]) - (one[HALF_WIDTH] + other[HALF_WIDTH])
    y = abs(other[MIDDLE_Y] - one[MIDDLE_Y]) - (one[HALF_HEIGHT] + other[HALF_HEIGHT])
    reach = one[MIDDLE_REACH] + other[MIDDLE_REACH]
    x, y = max(x, 0.0), max(y, 0.0)
    return bool(x * x + y * y > reach * reach)


def sides_apart(
    k: int,
    m: int,
    curve: Whole,
    middle: Array,
    shape_body: Whole,
    shape_first: Whole,
    shape_count: Whole,
    shape_radius: Array,
    pose: Array,
    motion: Array,
    home: Array,
    turned: Array,
) -> bool:
    """Return whether a side of the longer of two shapes looks past the other at home."""
    if middle[k, MIDDLE_REACH] < middle[m, MIDDLE_REACH]:
        k, m = m, k
    one, other = middle[k], middle[m]
    s = curve[0, k]
    if one[MIDDLE_REACH] < LONGER * other[MIDDLE_REACH] or shape_count[s] == 1:
        return False
    i = shape_body[s]
    x, y = other[MIDDLE_X] - one[MIDDLE_X], other[MIDDLE_Y] - one[MIDDLE_Y]
    wide = one[HALF_WIDTH] + other[HALF_WIDTH]
    high = one[HALF_HEIGHT] + other[HALF_HEIGHT]
    turn = home[i, TURN_ROOM] + abs(pose[i, TURN] - home[i, HOME_TURN]) + abs(motion[i, DTURN])
    reach = other[MIDDLE_REACH] + shape_radius[s] + turn * (abs(x) + abs(y) + wide + high)
    for c in range(shape_first[s], shape_first[s] + shape_count[s]):
        along_x, along_y = turned[c, 2], turned[c, 3]
        room = along_x * (x - turned[c, 0]) + along_y * (y - turned[c, 1])
        if room - abs(along_x) * wide - abs(along_y) * high > reach:
            return True
    return False


def foremost(s: int, shape_body: Whole, shape_first: Whole, turned: Array, home: Array) -> float:
    """Return how far a half-plane reaches along its normal at home, m from the origin."""
    i, first = shape_body[s], shape_first[s]
    normal_x, normal_y = turned[first, 2], turned[first, 3]
    on_x = home[i, HIGH_X] if normal_x > 0.0 else home[i, LOW_X]
    on_y = home[i, HIGH_Y] if normal_y > 0.0 else home[i, LOW_Y]
    offset: float = turned[first, 0] + normal_x * on_x + normal_y * on_y
    return offset


def reaches(t: int, offset: float, side: Array, box: Array) -> bool:
    """Return whether the box of a shape reaches into a half-plane."""
    x = box[t, FAT] if side[2] > 0.0 else box[t, FAT + 2]
    y = box[t, FAT + 1] if side[3] > 0.0 else box[t, FAT + 3]
    return bool(side[2] * x + side[3] * y <= offset)


def may_meet(s: int, t: int, shape_body: Whole, kind: Whole, filters: Whole) -> bool:
    """Return whether two shapes are to be looked at at all."""
    i, j = shape_body[s], shape_body[t]
    if i == j or max(kind[i], kind[j]) != DYNAMIC:
        return False
    group = filters[s, GROUP]
    if group != 0 and group == filters[t, GROUP]:
        return bool(group > 0)
    return bool(
        (filters[s, CATEGORY] & filters[t, MASK]) != 0
        and (filters[t, CATEGORY] & filters[s, MASK]) != 0
    )


def note_pair(total: int, s: int, t: int, ranked: Whole, found: Whole) -> int:
    """Write down a pair by its ranks, the lower one first, if there is room; count it anyway."""
    if total < len(found):
        a, b = ranked[1, s], ranked[1, t]
        found[total, 0], found[total, 1] = min(a, b), max(a, b)
    return total + 1


def sort_pairs(total: int, found: Whole, starts: Whole) -> None:
    """Sort pairs by both ranks in the columns 0 and 1: by the second one, then by the first.

    There are no more ranks than shapes, so that counting puts each pair in its place.
    """
    for key in range(1, -1, -1):
        here, there = (0, 2) if key == 1 else (2, 0)
        for k in range(len(starts)):
            starts[k] = 0
        for p in range(total):
            starts[found[p, here + key] + 1] += 1
        for k in range(1, len(starts)):
            starts[k] += starts[k - 1]
        for p in range(total):
            rank = found[p, here + key]
            place = starts[rank]
            starts[rank] = place + 1
            found[place, there], found[place, there + 1] = found[p, here], found[p, here + 1]
