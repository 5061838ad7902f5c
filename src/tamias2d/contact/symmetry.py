"""Equal answers, to the bit, where a problem of contacts is symmetric."""

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from tamias2d.state import Array

_EQUAL = 1e-13
"""Of the largest one: by how much rounding may set equal numbers apart."""


def symmetric(
    matrix: Array, known: Array, signed: Sequence[bool], values: Sequence[float]
) -> list[float]:
    """Return values of which those that a symmetry of the problem exchanges are equal, to the bit.

    The problem has a row of couplings for each value, `matrix` (n, n), and numbers that belong to
    the value, `known` (n, m). One that is `signed` may change its sign with its couplings, as a
    tangent does in a mirror; then the first of `known` does, too. The mean of a convex problem's
    answer over its classes is an answer as well.
    """
    count = len(values)
    both = [(k, 1.0) for k in range(count)] + [(k, -1.0) for k in range(count) if signed[k]]
    rows = np.array([k for k, _ in both])
    signs = np.array([sign for _, sign in both])
    size = np.sqrt(np.diag(matrix))
    couplings = np.outer(signs, signs) * (matrix / np.outer(size, size))[np.ix_(rows, rows)]
    own = [known[rows, 0] * signs, *known[rows, 1:].T, np.log(size[rows])]
    classes = equitable_classes(couplings, own)
    parts = np.array(values)[rows] * signs
    means = [
        math.fsum(parts[classes == k].tolist()) / int((classes == k).sum())
        for k in range(int(classes.max()) + 1)
    ]
    return [means[k] for k in classes[:count].tolist()]


def equitable_classes(matrix: Array, known: Sequence[Array]) -> NDArray[np.int64]:
    """Return the class of each row: the coarsest of which all rows of a class have the same numbers
    and the same couplings to each class (equitable partition).
    """
    classes = _rows(np.stack([_ranks(each) for each in known], axis=1))
    if classes.max(initial=-1) == len(classes) - 1:  # there are no equal ones
        return classes
    couplings = _ranks(matrix)
    while True:
        seen = np.sort(couplings * len(classes) + classes, axis=1)
        finer = _rows(np.column_stack([classes, seen]))
        if finer.max() == classes.max():
            return classes
        classes = finer


def _ranks(values: Array) -> NDArray[np.int64]:
    """Return the places of numbers among all of them, the same for those that are equal."""
    order = np.sort(values, axis=None)
    apart = np.diff(order) > _EQUAL * np.abs(order).max(initial=0.0)
    return np.searchsorted(order[1:][apart], values, side="right")


def _rows(values: NDArray[np.int64]) -> NDArray[np.int64]:
    """Return the place of each row among all different ones, in order."""
    order = np.lexsort(values.T[::-1])
    apart = (values[order[1:]] != values[order[:-1]]).any(axis=1)
    found = np.zeros(len(values), dtype=np.int64)
    found[order[1:]] = np.cumsum(apart)
    return found
