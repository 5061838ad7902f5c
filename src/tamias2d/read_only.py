"""Arrays that are copies: what is written into one would be lost, and is refused by name.

What is made of one, such as a copy, a sum or a pickle, is an array like any other.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tamias2d.errors import InputError


class ReadOnlyArray(np.ndarray[Any, np.dtype[Any]]):
    """An array that says what to do instead where a value is written into it."""

    name: str
    remedy: str

    def __array_finalize__(self, source: object) -> None:
        """Take over what a part of an array says."""
        self.name = getattr(source, "name", "")
        self.remedy = getattr(source, "remedy", "")

    def __setitem__(self, key: Any, value: Any) -> None:
        """Write into a copy, or raise `InputError`."""
        _refuse(self)
        super().__setitem__(key, value)

    def fill(self, value: Any) -> None:
        """Fill a copy, or raise `InputError`."""
        _refuse(self)
        super().fill(value)

    def sort(self, *args: Any, **kwargs: Any) -> None:
        """Sort a copy, or raise `InputError`."""
        _refuse(self)
        super().sort(*args, **kwargs)

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **options: Any) -> Any:
        """Compute with plain arrays; raise `InputError` if the result is to be written here."""
        for written in (*options.get("out", ()), *inputs[: method == "at"]):
            _refuse(written)
        if "out" in options:
            options["out"] = tuple(_plain(each) for each in options["out"])
        if "where" in options:
            options["where"] = _plain(options["where"])
        return getattr(ufunc, method)(*(_plain(each) for each in inputs), **options)

    def __reduce__(self) -> Any:
        """Keep the numbers alone."""
        return np.array(self).__reduce__()


def read_only(values: NDArray[Any], name: str, remedy: str) -> NDArray[Any]:
    """Return a copy's numbers as an array into which nothing can be written.

    Its name and the remedy are told to who tries; costs a microsecond.
    """
    view = values.view(ReadOnlyArray)
    view.name, view.remedy = name, remedy
    view.flags.writeable = False
    return view


def _refuse(written: object) -> None:
    if isinstance(written, ReadOnlyArray) and not written.flags.writeable:
        raise InputError(
            f"{written.name}: found a value for a part of a copy: it would be lost (R4). "
            f"{written.remedy}"
        )


def _plain(value: Any) -> Any:
    return np.asarray(value) if isinstance(value, ReadOnlyArray) else value
