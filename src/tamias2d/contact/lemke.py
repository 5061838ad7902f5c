"""The linear complementarity problem by Lemke's method, for couplings that are not symmetric."""

import numpy as np
from numpy.typing import NDArray

from tamias2d.contact.symmetry import equitable_classes
from tamias2d.state import Array

_TIED = 1e-11
"""Of the largest value of a column: what counts as none when the least ratio has been taken."""
_NEGLIGIBLE = 1e-11
"""A pivot that is none."""
_PIVOTS = 50  # for each unknown


def lemke(matrix: Array, vector: Array) -> Array | None:
    """Return x >= 0 with w = matrix x + vector >= 0 and x w = 0 item by item, or None.

    Unknowns that a symmetry of the problem exchanges are equal to the bit: it is solved for one of
    each class. `matrix` is scaled so that its largest items are about 1. Source: Cottle, Pang and
    Stone, The Linear Complementarity Problem (2009), 4.4 and 4.9 (lexicographic ratios).
    """
    classes = equitable_classes(matrix, [vector])
    count = int(classes.max()) + 1
    members = (classes[:, None] == np.arange(count)).astype(float)
    first = members.argmax(axis=0)
    weight = members.sum(axis=0)  # of a row, so that what is copositive remains so
    found = _solved((matrix @ members)[first] * weight[:, None], vector[first] * weight)
    return None if found is None else found[classes]


def _solved(matrix: Array, vector: Array) -> Array | None:
    count = len(vector)
    scale = np.abs(vector).max(initial=0.0)
    if count == 0 or vector.min() >= -_NEGLIGIBLE * scale:
        return np.zeros(count)
    artificial = 2 * count
    table = np.hstack([np.eye(count), -matrix, -np.ones((count, 1)), vector[:, None] / scale])
    basis = np.arange(count)
    row = int(np.lexsort((*-table[:, :count].T, table[:, -1]))[0])
    entering = artificial
    for _ in range(_PIVOTS * count):
        leaving = int(basis[row])
        _pivot(table, row, entering)
        basis[row] = entering
        if leaving == artificial:
            found = np.zeros(2 * count + 1)
            found[basis] = np.maximum(table[:, -1], 0.0) * scale
            return found[count:artificial]
        entering = (leaving + count) % (2 * count)
        next_row = _ratio_test(table, basis, entering, artificial)
        if next_row is None:
            return None  # a ray
        row = next_row
    return None


def _pivot(table: Array, row: int, column: int) -> None:
    table[row] /= table[row, column]
    others = np.arange(len(table)) != row
    table[others] -= np.outer(table[others, column], table[row])


def _ratio_test(
    table: Array, basis: NDArray[np.int_], entering: int, artificial: int
) -> int | None:
    """Return the row that leaves: the least ratio, and among equal ones the least in order."""
    column = table[:, entering]
    rows = np.flatnonzero(column > _NEGLIGIBLE)
    if not len(rows):
        return None
    for place in (-1, *range(len(table))):
        values = table[rows, place]
        least = (values / column[rows]).min()
        rows = rows[values - least * column[rows] <= _TIED * max(1.0, np.abs(values).max())]
        tied = rows[basis[rows] == artificial]
        if place == -1 and len(tied):
            return int(tied[0])
        if len(rows) == 1:
            break
    return int(rows[0])
