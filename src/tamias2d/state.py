"""Where bodies are and how they move: at one instant, and over a run."""

from collections.abc import Callable
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

Vector: TypeAlias = tuple[float, float]
Array: TypeAlias = NDArray[np.float64]
Acceleration: TypeAlias = tuple[float, float, float]
"""Both components in m/s^2, and the angular one in rad/s^2."""
Hold: TypeAlias = Callable[[Acceleration], Acceleration]
"""What a lasting contact makes of the acceleration that the loads alone would give a body."""


class State(NamedTuple):
    """The state of one body: of its centre of mass, and of its rotation."""

    position: Vector
    """m"""
    orientation: float
    """rad, counter-clockwise, unbounded"""
    velocity: Vector
    """m/s"""
    angular_velocity: float
    """rad/s"""


class History(NamedTuple):
    """The states of n bodies at k times."""

    position: Array
    """(k, n, 2), m"""
    orientation: Array
    """(k, n), rad"""
    velocity: Array
    """(k, n, 2), m/s"""
    angular_velocity: Array
    """(k, n), rad/s"""
