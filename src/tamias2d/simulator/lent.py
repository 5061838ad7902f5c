"""Arrays that are lent to users, and whether anybody holds one of them.

Serves: the simulator, which need not look for changes where nobody can have made any. Hides: that
numpy keeps the array alive of which a view is made, so that its references tell of all its views.
What writes by a bare address must hold the array meanwhile, as numpy asks anyway.
"""

from collections.abc import Iterable
from sys import getrefcount
from typing import Any

import numpy as np
from numpy.typing import NDArray


def lent(values: NDArray[Any]) -> NDArray[Any]:
    """Return an array of the same memory, to which all views that are made of it refer."""
    memory: Any = memoryview(values)  # type: ignore[arg-type] # an array is a buffer
    return np.asarray(memory)


def is_held(arrays: Iterable[NDArray[Any]]) -> bool:
    """Return whether anybody but one collection holds one of the arrays, or a view of it."""
    return _most_references(arrays) > _UNHELD


def which_are_held(arrays: Iterable[NDArray[Any]]) -> list[bool]:
    """Return of each array whether anybody but one collection holds it, or a view of it."""
    found = []
    for array in arrays:
        found.append(getrefcount(array) > _UNHELD)
    return found


def _most_references(arrays: Iterable[NDArray[Any]]) -> int:
    most = 0
    for array in arrays:
        count = getrefcount(array)
        if count > most:
            most = count
    return most


_UNHELD = _most_references((lent(np.zeros(1)),))
