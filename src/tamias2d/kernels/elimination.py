"""Linear equations of joints by elimination: sparse, symmetric, one unknown for each row.

Serves: the reactions of a mechanism, and its return to its constraints. Hides: in which order rows
are eliminated, and where what this leaves behind is kept. Without loops of bodies the work grows
with their number only. The functions are copied into kernels.

The matrix S is factorised into L D L^T in a given order of its rows; `lower` holds what stands in L
below its diagonal, column by column.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from tamias2d.kernels.arrays import Floats, Ranks


@dataclass(frozen=True)
class Elimination:
    """Where everything stands, for rows that share some columns."""

    order: list[int]
    """The rows as they are eliminated."""
    below: list[int]
    """Where each column of L begins in `lower`, and where the last one ends."""
    below_rows: list[int]
    """By the place in `lower`, the row, numbered in order."""
    targets: list[int]
    """For each column, each entry and each one after it: the place in `lower` of their product."""


def elimination(rows: Sequence[set[int]], most: int) -> Elimination | None:
    """Return how rows are eliminated of which the columns are given; None for much more work.

    The row with the fewest neighbours is always next, which leaves trees as they are.
    """
    holders: dict[int, set[int]] = {}
    for row, columns in enumerate(rows):
        for column in columns:
            holders.setdefault(column, set()).add(row)
    near = [set().union(*(holders[c] for c in columns)) - {k} for k, columns in enumerate(rows)]
    left = set(range(len(rows)))
    order: list[int] = []
    behind: list[set[int]] = []
    work = 0
    while left:
        row = min(left, key=lambda k: (len(near[k]), k))
        left.remove(row)
        order.append(row)
        behind.append(near[row])
        work += len(near[row]) ** 2
        if work > most:
            return None
        for other in near[row]:
            near[other] |= near[row]
            near[other] -= {other, row}
    place = {row: k for k, row in enumerate(order)}
    columns_of = [sorted(place[other] for other in others) for others in behind]
    below = [0]
    at: dict[tuple[int, int], int] = {}
    for k, others in enumerate(columns_of):
        at |= {(other, k): below[-1] + i for i, other in enumerate(others)}
        below.append(below[-1] + len(others))
    targets = [
        at[second, first]
        for others in columns_of
        for i, first in enumerate(others)
        for second in others[i + 1 :]
    ]
    return Elimination(order, below, [each for others in columns_of for each in others], targets)


def factorised(
    diagonal: Floats, lower: Floats, below: Ranks, below_rows: Ranks, targets: Ranks
) -> bool:
    """Turn S into its factors; return whether all that it was divided by is positive."""
    t = 0
    for k in range(len(diagonal)):
        pivot = diagonal[k]
        if not 0 < pivot < 1e300:
            return False
        end = below[k + 1]
        for a in range(below[k], end):
            entry = lower[a]
            share = entry / pivot
            row = below_rows[a]
            diagonal[row] = diagonal[row] - share * entry
            for b in range(a + 1, end):
                target = targets[t]
                t += 1
                lower[target] = lower[target] - share * lower[b]
            lower[a] = share
    return True


def solve(
    diagonal: Floats, lower: Floats, below: Ranks, below_rows: Ranks, order: Ranks, row: Floats
) -> None:
    """Turn a row of numbers (m,) into the solution for it."""
    for k in range(len(diagonal)):
        value = row[order[k]]
        for a in range(below[k], below[k + 1]):
            other = order[below_rows[a]]
            row[other] = row[other] - lower[a] * value
    for k in range(len(diagonal) - 1, -1, -1):
        value = row[order[k]] / diagonal[k]
        for a in range(below[k], below[k + 1]):
            value = value - lower[a] * row[order[below_rows[a]]]
        row[order[k]] = value


def inverse_size(
    diagonal: Floats,
    lower: Floats,
    below: Ranks,
    below_rows: Ranks,
    targets: Ranks,
    own: Floats,
    shared: Floats,
) -> float:
    """Return the trace of the inverse of S whose rows and columns are scaled to a diagonal of ones.

    `own` is the diagonal of S, and afterwards that of its inverse, which is found as far as L has
    entries (Erisman and Tinney, On computing certain elements of the inverse of a sparse matrix,
    Communications of the ACM 18, 1975).
    """
    t = len(targets)
    trace = 0.0
    for k in range(len(diagonal) - 1, -1, -1):
        first, end = below[k], below[k + 1]
        for a in range(first, end):
            shared[a] = 0.0
        for a in range(end - 1, first - 1, -1):
            shared[a] = shared[a] - own[below_rows[a]] * lower[a]
            for b in range(end - 1, a, -1):
                t -= 1
                entry = shared[targets[t]]
                shared[a] = shared[a] - entry * lower[b]
                shared[b] = shared[b] - entry * lower[a]
        total = 1 / diagonal[k]
        for a in range(first, end):
            total = total - lower[a] * shared[a]
        trace = trace + own[k] * total
        own[k] = total
    return trace
