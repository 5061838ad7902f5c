"""Numbers that float64 cannot hold end a run by a refusal, not by a warning."""

from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np

from tamias2d.contact import RangeError
from tamias2d.state import Array

_TOTALS = ("energy", "momentum", "angular momentum")


@contextmanager
def within_range(duration: float) -> Iterator[None]:
    """Turn an over- or underflow within the block into a `RangeError`, without warnings."""
    with np.errstate(all="ignore"):
        try:
            yield
        except (OverflowError, ZeroDivisionError):
            raise range_error(f"run of {duration!r} s: a number", 0.0) from None


def refuse_infinite(times: Array, *totals: Array) -> None:
    """Raise `RangeError` at the first time whose energy or momenta are not finite."""
    for name, values in zip(_TOTALS, totals, strict=True):
        bad = ~np.isfinite(values.reshape(len(times), -1)).all(axis=1)
        if bad.any():
            time = float(times[np.argmax(bad)])
            raise range_error(f"run at {time!r} s: its {name}", time)


def range_error(what: str, time: float) -> RangeError:
    """Return the error that names a number beyond float64, and the time reached, s."""
    return RangeError(
        f"{what} is beyond what float64 holds, about 1e-308 to 1e308 (R4). Give values nearer to "
        "1, or a shorter duration.",
        time=time,
    )
