"""Where a line through many vertices crosses, touches or covers itself (A16)."""

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from tamias2d.scene.rules import Vector


def crossings(
    segments: Sequence[tuple[Vector, Vector]], *, loop: bool
) -> Iterator[tuple[int, int]]:
    """Yield pairs of pieces with a common point that is no vertex of neighbours, m.

    Cost: n log n, and a look at all pieces beside each other.
    """
    ends = np.array(segments)
    ends /= np.abs(ends).max()  # products are finite then
    for a, b in _near(ends):
        if loop and (a, b) == (0, len(ends) - 1):
            common = _folds_back(ends[b], ends[a])
        else:
            common = _folds_back(ends[a], ends[b]) if b == a + 1 else _meet(ends[a], ends[b])
        if common:
            yield a, b


def _near(ends: NDArray[np.float64]) -> Iterator[tuple[int, int]]:
    """Yield pairs of pieces whose bounding boxes touch, the earlier one first."""
    low, high = ends.min(axis=1), ends.max(axis=1)
    order = np.argsort(low[:, 0], kind="stable")
    last = np.searchsorted(low[order, 0], high[order, 0], side="right")
    for place, k in enumerate(order):
        others = order[place + 1 : last[place]]
        near = (low[others, 1] <= high[k, 1]) & (high[others, 1] >= low[k, 1])
        for m in others[near]:
            yield min(int(k), int(m)), max(int(k), int(m))


def _meet(one: NDArray[np.float64], other: NDArray[np.float64]) -> bool:
    """Return whether two pieces (2, 2) whose bounding boxes touch have a common point."""
    return all(
        _left_of(p, q[0]) * _left_of(p, q[1]) <= 0.0 for p, q in ((one, other), (other, one))
    )


def _folds_back(piece: NDArray[np.float64], following: NDArray[np.float64]) -> bool:
    """Return whether a piece (2, 2) lies on the one before it."""
    way, on = piece[1] - piece[0], following[1] - following[0]
    return _left_of(piece, following[1]) == 0.0 and bool(way @ on < 0.0)


def _left_of(piece: NDArray[np.float64], point: NDArray[np.float64]) -> float:
    """Return 1 for a point on the left of a piece (2, 2), -1 on the right, 0 in its line."""
    (ax, ay), (bx, by) = piece
    return float(np.sign((bx - ax) * (point[1] - ay) - (by - ay) * (point[0] - ax)))
