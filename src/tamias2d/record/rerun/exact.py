"""Numbers as columns of a recording, and back."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import pyarrow as pa

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import NDArray


BLOCK = 2**25
"""Bytes that are sent, and later loaded, at once."""


def blocks(rows: int, size: int) -> Iterator[slice]:
    """Cut rows, of so many bytes each, into blocks."""
    step = max(1, BLOCK // max(size, 1))
    return (slice(start, start + step) for start in range(0, rows, step))


def column(values: NDArray[Any]) -> Any:
    """A row for each number (r,) or vector (r, 2)."""
    if values.ndim == 1:
        return np.ascontiguousarray(values)
    return pa.FixedSizeListArray.from_arrays(pa.array(values.ravel()), values.shape[1])


def values(column: Any) -> NDArray[Any]:
    """All numbers (r,) or vectors (r, 2) of a column, however they are spread over its rows."""
    rows = column.flatten()
    is_vector = hasattr(rows.type, "list_size")
    flat = np.asarray(rows.flatten() if is_vector else rows)
    return flat.reshape(-1, rows.type.list_size) if is_vector else flat
