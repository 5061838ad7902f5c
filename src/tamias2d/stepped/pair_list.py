"""The list of pairs that may touch, with what is known of each.

Serves: the look around. Hides: that there are two lists, of which one is in use, and that one is
two runs, each sorted by the canonical ranks of its shapes: what follows does not depend on the
order in which bodies were added or found.
"""

from tamias2d.generated.definitions import pair_friction, pair_restitution
from tamias2d.state import Array
from tamias2d.stepped.layout import (
    ARRANGED,
    COUNT,
    FRICTION,
    ISLANDED,
    OF_A,
    OF_B,
    PAIR_FRICTION,
    PAIR_RESTITUTION,
    PAIRS,
    RESTITUTION,
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
    surface: Array,
    mixed: Array,
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
                new_pair(
                    ranked[0, a], ranked[0, b], shape_body, surface, mixed, size, next_pair,
                    next_touch, next_trace,
                )  # fmt: skip
            size += 1
    if size <= len(pair):
        counts[SIDE] = 1 - side
        counts[PAIRS] = counts[SORTED] = size
    return size


def comes_before(p: int, q: int, ranked: Whole, pair: Whole) -> bool:
    """Return whether a pair on the list is before another in canonical order."""
    s, t = ranked[1, pair[p, 0]], ranked[1, pair[q, 0]]
    return bool(s < t or (s == t and ranked[1, pair[p, 1]] < ranked[1, pair[q, 1]]))


def add_pair(
    a: int,
    b: int,
    counts: Whole,
    ranked: Whole,
    shape_body: Whole,
    surface: Array,
    mixed: Array,
    pair: Whole,
    touch: Array,
    trace: Whole,
) -> bool:
    """Put a pair, by its ranks, into the second run if it is on neither; return if there was room.

    The list is two runs in canonical order: what was found when all looked around, and since.
    """
    end = counts[PAIRS]
    at = place_of(a, b, 0, counts[SORTED], ranked, pair)
    if at < counts[SORTED] and is_pair(at, a, b, ranked, pair):
        return True
    at = place_of(a, b, counts[SORTED], end, ranked, pair)
    if at < end and is_pair(at, a, b, ranked, pair):
        return True
    if end == len(pair):
        return False
    for p in range(end, at, -1):
        for k in range(4):
            pair[p, k] = pair[p - 1, k]
        for k in range(TOUCH):
            touch[p, k] = touch[p - 1, k]
        for k in range(6):
            trace[p, k] = trace[p - 1, k]
    new_pair(ranked[0, a], ranked[0, b], shape_body, surface, mixed, at, pair, touch, trace)
    counts[PAIRS] = end + 1
    counts[ARRANGED] = counts[ISLANDED] = 0  # pairs have other places
    return True


def place_of(a: int, b: int, low: int, high: int, ranked: Whole, pair: Whole) -> int:
    """Return the first place of a run that is not before a pair of ranks."""
    while low < high:
        middle = (low + high) // 2
        s, t = ranked[1, pair[middle, 0]], ranked[1, pair[middle, 1]]
        if s < a or (s == a and t < b):
            low = middle + 1
        else:
            high = middle
    return low


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
    """Copy what is known of a pair; of one that does not touch, only how its surfaces mix."""
    for k in range(4):
        next_pair[new, k] = pair[old, k]
    if trace[old, COUNT] > 0 or trace[old, TOUCHED] != 0:
        for k in range(TOUCH):
            next_touch[new, k] = touch[old, k]
        for k in range(6):
            next_trace[new, k] = trace[old, k]
    else:
        blank(new, next_trace)
        next_touch[new, PAIR_FRICTION] = touch[old, PAIR_FRICTION]
        next_touch[new, PAIR_RESTITUTION] = touch[old, PAIR_RESTITUTION]


def blank(p: int, trace: Whole) -> None:
    """Let nothing be known of how a pair touches: without names, points have no impulses."""
    for k in range(6):
        trace[p, k] = 0


def new_pair(
    s: int,
    t: int,
    shape_body: Whole,
    surface: Array,
    mixed: Array,
    new: int,
    pair: Whole,
    touch: Array,
    trace: Whole,
) -> None:
    """Begin a pair: it does not touch, and its surfaces are mixed by the rules of the scene.

    `mixed` (k, 4) holds what was set for pairs of shapes: both, friction, restitution.
    """
    pair[new, 0], pair[new, 1] = s, t
    pair[new, OF_A], pair[new, OF_B] = shape_body[s], shape_body[t]
    blank(new, trace)
    touch[new, PAIR_FRICTION] = both_friction(surface[s, FRICTION], surface[t, FRICTION])
    touch[new, PAIR_RESTITUTION] = both_restitution(
        surface[s, RESTITUTION], surface[t, RESTITUTION]
    )
    for k in range(len(mixed)):
        one, other = mixed[k, 0], mixed[k, 1]
        if (one == s and other == t) or (one == t and other == s):
            touch[new, PAIR_FRICTION] = (
                mixed[k, 2] if mixed[k, 2] >= 0.0 else touch[new, PAIR_FRICTION]
            )
            touch[new, PAIR_RESTITUTION] = (
                mixed[k, 3] if mixed[k, 3] >= 0.0 else touch[new, PAIR_RESTITUTION]
            )


def both_friction(first: float, second: float) -> float:
    """Return the friction of two surfaces; -1 where one states none, and 0 if neither does."""
    if first < 0.0 or second < 0.0:
        return max(first, second, 0.0)
    return pair_friction(first, second)


def both_restitution(first: float, second: float) -> float:
    """Return the restitution of two surfaces; -1 where one states none, and 0 if neither does."""
    if first < 0.0 or second < 0.0:
        return max(first, second, 0.0)
    return pair_restitution(first, second)
