"""The list of pairs that may touch, with what is known of each.

Serves: the look around. Hides: that there are two lists, of which one is in use, and that one is
two runs, each sorted by the canonical ranks of its shapes: what follows does not depend on the
order in which bodies were added or found.
"""

from tamias2d.state import Array
from tamias2d.stepped.layout import (
    ARRANGED,
    COUNT,
    ISLANDED,
    OF_A,
    OF_B,
    PAIRS,
    POINT,
    SIDE,
    SORTED,
    TOUCH,
    TOUCHED,
    Whole,
)


def take_over(
    total: int,
    counts: Whole,
    ranked: Whole,
    shape_body: Whole,
    found: Whole,
    starts: Whole,
    pairs: Whole,
    touches: Array,
    traces: Whole,
) -> int:
    """Make the sorted pairs the list in use, with what is known of those that were on it.

    Those that touched and are near no more stay once, for what ends with them to be told. Returns
    how many there are; where there is no room for them, the list is as it was.
    """
    side = counts[SIDE]
    pair, touch, trace = pairs[side], touches[side], traces[side]
    next_pair, next_touch, next_trace = pairs[1 - side], touches[1 - side], traces[1 - side]
    size = 0
    first, second = 0, counts[SORTED]  # heads of the two runs
    for p in range(total + 1):
        a, b = (found[p, 0], found[p, 1]) if p < total else (len(ranked[1]), 0)
        known = False
        while True:
            from_first = first < counts[SORTED] and (
                second == counts[PAIRS] or not comes_before(second, first, ranked, pair)
            )
            old = first if from_first else second
            if old == counts[PAIRS]:
                break
            s, t = ranked[1, pair[old, 0]], ranked[1, pair[old, 1]]
            if s > a or (s == a and t > b):
                break
            first, second = (first + 1, second) if from_first else (first, second + 1)
            known = s == a and t == b
            if known or trace[old, TOUCHED] != 0:
                if size < len(pair):
                    copy_pair(old, pair, touch, trace, size, next_pair, next_touch, next_trace)
                size += 1
        if p == total:
            break
        if not known:
            if size < len(pair):
                new_pair(ranked[0, a], ranked[0, b], shape_body, size, next_pair, next_trace)
            size += 1
    if size <= len(pair):
        counts[SIDE] = 1 - side
        counts[PAIRS] = counts[SORTED] = size
        note_starts(ranked, next_pair, size, starts)
    return size


def comes_before(p: int, q: int, ranked: Whole, pair: Whole) -> bool:
    """Return whether a pair on the list is before another in canonical order."""
    s, t = ranked[1, pair[p, 0]], ranked[1, pair[q, 0]]
    return bool(s < t or (s == t and ranked[1, pair[p, 1]] < ranked[1, pair[q, 1]]))


def note_starts(ranked: Whole, pair: Whole, size: int, starts: Whole) -> None:
    """Write where in the first run the pairs of each rank begin, and where it ends."""
    k = 0
    for rank in range(len(ranked[1]) + 1):
        while k < size and ranked[1, pair[k, 0]] < rank:
            k += 1
        starts[rank] = k


def add_pairs(
    total: int,
    counts: Whole,
    ranked: Whole,
    shape_body: Whole,
    found: Whole,
    starts: Whole,
    pair: Whole,
    touch: Array,
    trace: Whole,
) -> bool:
    """Put sorted pairs into the second run that are on neither; return whether there was room.

    The list is two runs in canonical order: what was found when all looked around, and since.
    """
    new = keep_new(total, counts, ranked, found, starts, pair)
    if counts[PAIRS] + new > len(pair):
        return False
    if new > 0:
        counts[ARRANGED] = counts[ISLANDED] = 0  # pairs have other places
    old, place = counts[PAIRS] - 1, counts[PAIRS] + new - 1
    counts[PAIRS] += new
    while new > 0:  # from the end, so that each moves once
        a, b = found[new - 1, 0], found[new - 1, 1]
        if old >= counts[SORTED] and is_after(old, a, b, ranked, pair):
            copy_pair(old, pair, touch, trace, place, pair, touch, trace)
            old -= 1
        else:
            new_pair(ranked[0, a], ranked[0, b], shape_body, place, pair, trace)
            new -= 1
        place -= 1
    return True


def keep_new(
    total: int, counts: Whole, ranked: Whole, found: Whole, starts: Whole, pair: Whole
) -> int:
    """Keep those of the sorted pairs found that are not on the list; return how many."""
    new = 0
    second = counts[SORTED]
    for p in range(total):
        a, b = found[p, 0], found[p, 1]
        known = False
        for k in range(starts[a], starts[a + 1]):
            known = known | (ranked[1, pair[k, 1]] == b)
        while second < counts[PAIRS] and not is_after(second, a, b, ranked, pair):
            known = known | is_pair(second, a, b, ranked, pair)
            second += 1
        if not known:
            found[new, 0], found[new, 1] = a, b
            new += 1
    return new


def is_after(p: int, a: int, b: int, ranked: Whole, pair: Whole) -> bool:
    """Return whether a pair on the list comes after one of these ranks."""
    s, t = ranked[1, pair[p, 0]], ranked[1, pair[p, 1]]
    return bool(s > a or (s == a and t > b))


def is_pair(p: int, a: int, b: int, ranked: Whole, pair: Whole) -> bool:
    """Return whether a pair on the list has these ranks."""
    return bool(ranked[1, pair[p, 0]] == a and ranked[1, pair[p, 1]] == b)


def copy_pair(
    old: int,
    pair: Whole,
    touch: Array,
    trace: Whole,
    new: int,
    next_pair: Whole,
    next_touch: Array,
    next_trace: Whole,
) -> None:
    """Copy a pair; what is known of how it touches, only if it does."""
    for k in range(4):
        next_pair[new, k] = pair[old, k]
    if trace[old, COUNT] > 0 or trace[old, TOUCHED] != 0:
        for k in range(POINT if trace[old, COUNT] == 1 else TOUCH):
            next_touch[new, k] = touch[old, k]
        for k in range(6):
            next_trace[new, k] = trace[old, k]
    else:
        blank(new, next_trace)


def blank(p: int, trace: Whole) -> None:
    """Let nothing be known of how a pair touches: without names, points have no impulses."""
    for k in range(6):
        trace[p, k] = 0


def new_pair(s: int, t: int, shape_body: Whole, new: int, pair: Whole, trace: Whole) -> None:
    """Begin a pair, which does not touch."""
    pair[new, 0], pair[new, 1] = s, t
    pair[new, OF_A], pair[new, OF_B] = shape_body[s], shape_body[t]
    blank(new, trace)
