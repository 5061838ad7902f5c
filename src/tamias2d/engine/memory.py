"""Arrays that begin with a line of a cache: rows of 8 numbers, or 16, then touch no line twice.

Serves: the world. Hides: where numpy puts its arrays, which differs from one to the next.
"""

from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

LINE = 64  # bytes


def aligned_zeros(shape: int | tuple[int, ...], dtype: DTypeLike = np.float64) -> NDArray[Any]:
    """Return zeros that begin with a line of a cache."""
    kind = np.dtype(dtype)
    size = int(np.prod(shape)) * kind.itemsize
    bare = np.zeros(size + LINE, dtype=np.uint8)
    start = -bare.ctypes.data % LINE
    return bare[start : start + size].view(kind).reshape(shape)


def aligned_copy(values: NDArray[Any]) -> NDArray[Any]:
    """Return a copy that begins with a line of a cache."""
    copy = aligned_zeros(values.shape, values.dtype)
    copy[...] = values
    return copy
