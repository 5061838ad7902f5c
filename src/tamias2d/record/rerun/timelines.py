"""The viewer's timelines: the time of the scene in nanoseconds, and the number of a sample."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import rerun as rr

from tamias2d.errors import RecordingError
from tamias2d.record.rerun import layout

if TYPE_CHECKING:
    from pathlib import Path

    from numpy.typing import NDArray

_END = 9e9  # s, of a clock that counts nanoseconds in 64 bits


def nanoseconds(times: NDArray[np.float64], path: Path, remedy: str) -> NDArray[np.int64]:
    """Round times in s to the viewer's clock; raise `RecordingError` if they are beyond it."""
    if times[-1] > _END:
        raise RecordingError(
            f"{path}: a time of {times[-1]:g} s is beyond the viewer's clock, which ends at "
            f"{_END:g} s. {remedy}"
        )
    return np.rint(times * 1e9).astype(np.int64)


def columns(clock: NDArray[np.int64], steps: NDArray[np.int64]) -> list[rr.TimeColumn]:
    """Return the columns of both timelines."""
    return [
        rr.TimeColumn(layout.TIME, duration=clock.astype("timedelta64[ns]")),
        rr.TimeColumn(layout.STEP, sequence=steps),
    ]
