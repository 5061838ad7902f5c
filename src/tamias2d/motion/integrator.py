"""What the schemes have in common, to whoever takes their steps."""

from typing import Protocol

from tamias2d.motion.memoised_field import MemoisedField
from tamias2d.motion.polynomial import DenseStep
from tamias2d.state import Array


class Integrator(Protocol):
    """A scheme, with its choice of steps."""

    best_at_ends: bool
    """Whether velocities between the ends of a step are worse than at them."""

    def step(
        self, field: MemoisedField, start: float, limit: float, position: Array, velocity: Array
    ) -> DenseStep:
        """Step coordinates and rates (n, 3) from `start` towards `limit`, s, and not past it."""
