"""Quantities of worlds from which statistics follow: finite, and not too large to be squared."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from tamias2d.errors import SimulationError
from tamias2d.state import Array

_LARGEST = 1e100


def refuse_no_numbers(numbers: Array, varied: Mapping[str, Any], whose: str) -> None:
    """Raise `SimulationError` if the quantity of a world is no number to reckon with.

    `varied` has for each path the values of the worlds, by which the message says which it is.
    """
    good = np.abs(numbers) <= _LARGEST  # nan is not
    if good.all():
        return
    row = int(np.argmin(good))
    world = ", ".join(f"{path} {np.asarray(values)[row]}" for path, values in varied.items())
    raise SimulationError(
        f"{whose}: the quantity is {numbers[row]:g} in the world of {world}: must be finite, and "
        f"at most {_LARGEST:g} in size (R10). Let the function return such a number in every "
        "world, in another unit if need be."
    )
