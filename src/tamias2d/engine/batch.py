"""Bodies on their way into the engine: a row for each."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tamias2d.scene.compound import Shape
from tamias2d.state import Array

UNSTATED = -1.0
"""Friction or restitution where a body states none."""


@dataclass(frozen=True, kw_only=True)
class Batch:
    """What k bodies are, and where and how they start; SI units."""

    kind: NDArray[np.int64]
    """(k,), of `tables`: STATIC, KINEMATIC or DYNAMIC"""
    pose: Array
    """(k, 3), position and orientation"""
    motion: Array
    """(k, 3), velocity and angular velocity"""
    load: Array
    """(k, 3), applied force and torque"""
    mass: Array
    """(k,); infinite unless dynamic"""
    inertia: Array
    """(k,); infinite for a body that nothing turns"""
    drag_rates: Array
    """(k, 2), rates at which drag slows the velocity and the angular velocity, 1/s"""
    friction: Array
    """(k,), UNSTATED where the body states none"""
    restitution: Array
    """(k,), UNSTATED where the body states none"""
    filters: NDArray[np.int64]
    """(k, 4): category, mask, group, sensor"""
    shapes: tuple[Shape | None, ...]
    """k shapes; None for a particle"""

    def __len__(self) -> int:
        return len(self.kind)
