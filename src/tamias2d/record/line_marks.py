"""Marks of lines that are no plain rims: dashes around a sensor, ticks on the solid side of a line.

Both are short lines of two points, so that each way to draw has them: the viewer knows no dashes.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Points = NDArray[np.float64]

_FEWEST, _MOST = 8, 200  # of marks on a line


def dashes(line: Points, length: float) -> list[Points]:
    """Return dashes of about a length, m, with gaps as long, along a line (v, 2)."""
    count = _count(line, 2 * length)
    stops, _ = _along(line, np.arange(2 * count) / (2 * count))
    return list(stops.reshape(count, 2, 2))


def ticks(line: Points, length: float) -> list[Points]:
    """Return ticks of a length, m, to the left of a line (v, 2), twice as far from each other."""
    count = _count(line, 2 * length)
    feet, left = _along(line, (np.arange(count) + 0.5) / count)
    return list(np.stack([feet, feet + length * left], axis=1))


def _count(line: Points, spacing: float) -> int:
    whole = float(np.hypot(*np.diff(line, axis=0).T).sum())
    return int(np.clip(round(whole / spacing), _FEWEST, _MOST))


def _along(line: Points, shares: Points) -> tuple[Points, Points]:
    """Return the points at shares of a line's length, and the normals on its left there."""
    pieces = np.diff(line, axis=0)
    lengths = np.hypot(*pieces.T)
    ends = np.cumsum(lengths)
    at = shares * ends[-1]
    k = np.minimum(np.searchsorted(ends, at, side="right"), len(pieces) - 1)
    tangent = pieces[k] / lengths[k, None]
    points = line[k] + (at - (ends - lengths)[k])[:, None] * tangent
    return points, np.column_stack([-tangent[:, 1], tangent[:, 0]])
