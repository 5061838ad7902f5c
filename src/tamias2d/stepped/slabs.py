"""Slabs: stretches of a large scene that are solved in turns, as far as a cache can hold them.

Serves: the arrangement. Hides: along which axis they follow each other, and how wide they are.

A slab is as wide as two bodies that touch are apart, at least: so contacts are within a slab, or
with the next one. Then a slab may be ahead of the next one by a stage of the solver, which goes
through a large scene only once in a step, as a front of some slabs, instead of once in each stage.

Source: Wonnacott (2002), time skewing.
"""

from tamias2d.state import Array
from tamias2d.stepped.layout import (
    ACTIVE,
    ACTIVE_BODY,
    ACTIVE_ROW,
    DYNAMIC,
    HIT_A,
    HIT_B,
    HIT_BY_SLAB,
    HITS,
    KINEMATIC,
    SLABS,
    Whole,
    X,
    Y,
)
from tamias2d.stepped.rows import S_BODY, S_HIT, S_ISLE
from tamias2d.stepped.thin import NUMBER, SLAB, tree_of

CONTACTS_IN_SLAB = 1024  # to a slab, about
MOST_SLABS = 256
ROOMIER = 1.0 + 1e-9  # than bodies that touch are apart: rounding may not put another slab between


def divide(
    islands: int,
    counts: Whole,
    kind: Whole,
    used: Whole,
    pose: Array,
    hits: Whole,
    isle: Whole,
    slabs: Whole,
) -> None:
    """Divide what touches into slabs, and list pairs and moving bodies slab by slab.

    Of thin islands, which touch no others, each is in one slab.
    """
    number = choose(islands, counts, kind, pose, hits, isle)
    counts[SLABS] = number
    for q in range(number + 1):
        slabs[q, S_ISLE] = -(-q * islands // number)
    clear_column(S_HIT, number, slabs)
    for k in range(counts[HITS]):
        slabs[slab_of(k, kind, hits, isle) + 2, S_HIT] += 1
    add_up(S_HIT, number, slabs)
    for k in range(counts[HITS]):
        hits[HIT_BY_SLAB, take_place(slab_of(k, kind, hits, isle), S_HIT, slabs)] = k
    clear_column(S_BODY, number, slabs)
    for k in range(counts[ACTIVE]):
        slabs[isle[hits[ACTIVE_BODY, k], SLAB] + 2, S_BODY] += 1
    add_up(S_BODY, number, slabs)
    for i in range(len(used) if counts[ACTIVE] > 0 else 0):
        if used[i] == 1:
            hits[ACTIVE_ROW, take_place(isle[i, SLAB], S_BODY, slabs)] = i


def clear_column(column: int, number: int, slabs: Whole) -> None:
    """Begin to count what is in each slab."""
    for q in range(number + 2):
        slabs[q, column] = 0


def add_up(column: int, number: int, slabs: Whole) -> None:
    """Make of how many there are in each slab where the next one begins."""
    for q in range(number + 1):
        slabs[q + 1, column] += slabs[q, column]


def take_place(q: int, column: int, slabs: Whole) -> int:
    """Return the next place of a slab; in the end each row says where its slab begins."""
    place = slabs[q + 1, column]
    slabs[q + 1, column] = place + 1
    return int(place)


def choose(islands: int, counts: Whole, kind: Whole, pose: Array, hits: Whole, isle: Whole) -> int:
    """Give each body that can be pushed and touches something its slab; return how many there are.

    Bodies that are not named in the end are in the first one.
    """
    wanted = min(counts[HITS] // CONTACTS_IN_SLAB, MOST_SLABS)
    if wanted < 2 or some_moves_by_itself(counts, kind, hits):
        return 1
    axis, number, low, width = X, 1, 0.0, 0.0
    for along in (X, Y):
        first, last, apart = extent_along(along, counts, kind, pose, hits, isle)
        room = float(wanted) if apart < 0.0 or last - first > apart == 0.0 else 1.0
        if apart > 0.0:
            room = (last - first) / (ROOMIER * apart)
        fitting = int(min(room, float(wanted)))
        if fitting > number:
            axis, number, low, width = along, fitting, first, (last - first) / fitting
    if number == 1:
        return 1
    for k in range(counts[HITS]):
        root = thin_root(k, kind, hits, isle)
        for i in (hits[HIT_A, k], hits[HIT_B, k]):
            if kind[i] == DYNAMIC and root >= 0:
                isle[i, SLAB] = isle[root, NUMBER] * number // islands
            elif kind[i] == DYNAMIC:
                isle[i, SLAB] = min(int((pose[i, axis] - low) / width), number - 1)
    return number


def some_moves_by_itself(counts: Whole, kind: Whole, hits: Whole) -> bool:
    """Return whether something touches that moves and cannot be pushed: it is in no slab."""
    found = False
    for k in range(counts[HITS]):
        found = found | (kind[hits[HIT_A, k]] == KINEMATIC) | (kind[hits[HIT_B, k]] == KINEMATIC)
    return bool(found)


def extent_along(
    axis: int, counts: Whole, kind: Whole, pose: Array, hits: Whole, isle: Whole
) -> tuple[float, float, float]:
    """Return where along an axis bodies that are in no thin island begin and end, m.

    And how far two that touch are apart, at most; less than zero where all islands are thin.
    """
    first, last, apart = 0.0, 0.0, -1.0
    for k in range(counts[HITS]):
        if thin_root(k, kind, hits, isle) >= 0:
            continue
        i, j = hits[HIT_A, k], hits[HIT_B, k]
        i, j = (i if kind[i] == DYNAMIC else j), (j if kind[j] == DYNAMIC else i)
        low, high = min(pose[i, axis], pose[j, axis]), max(pose[i, axis], pose[j, axis])
        first = low if apart < 0.0 else min(first, low)
        last = high if apart < 0.0 else max(last, high)
        apart = max(apart, high - low)
    return first, last, apart


def thin_root(k: int, kind: Whole, hits: Whole, isle: Whole) -> int:
    """Return the body that stands for the thin island of a touching pair, or -1."""
    root = tree_of(k, kind, hits, isle)
    return root if root >= 0 and isle[root, NUMBER] >= 0 else -1


def slab_of(k: int, kind: Whole, hits: Whole, isle: Whole) -> int:
    """Return the slab of a touching pair: of two that can be pushed, the first one's."""
    i, j = hits[HIT_A, k], hits[HIT_B, k]
    if kind[i] == DYNAMIC and kind[j] == DYNAMIC:
        return int(min(isle[i, SLAB], isle[j, SLAB]))
    return int(isle[i, SLAB] if kind[i] == DYNAMIC else isle[j, SLAB])
