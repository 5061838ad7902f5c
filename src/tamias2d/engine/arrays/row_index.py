"""Rows of arrays as indices: numpy takes a slice faster than an array of places."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from tamias2d.state import IntArray


def index_of(rows: Sequence[int]) -> slice | IntArray:
    """Return an index of rows: a slice where they lie side by side in this order."""
    if len(rows) == 1 or (rows and rows[-1] - rows[0] + 1 == len(rows) and _ascend(rows)):
        return slice(rows[0], rows[-1] + 1)
    return np.array(rows, dtype=np.int64)


def _ascend(rows: Sequence[int]) -> bool:
    return all(b == a + 1 for a, b in pairwise(rows))
