"""Arrays that begin at a cache line: rows of 8 or 16 numbers then touch no line twice."""

from math import prod
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

LINE = 64  # bytes of a cache line


def aligned_zeros(shape: int | tuple[int, ...], dtype: DTypeLike = np.float64) -> NDArray[Any]:
    """Return zeros that begin at a cache line."""
    kind = np.dtype(dtype)
    size = kind.itemsize * (shape if isinstance(shape, int) else prod(shape))
    unaligned = np.zeros(size + LINE, dtype=np.uint8)
    start = -unaligned.__array_interface__["data"][0] % LINE
    return unaligned[start : start + size].view(kind).reshape(shape)
