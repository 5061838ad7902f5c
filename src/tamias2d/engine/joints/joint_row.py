"""A joint as the engine is told of it."""

import math
from typing import NamedTuple

from tamias2d.engine.tables import KEPT, MOTOR, SPRING


class JointRow(NamedTuple):
    """A joint of up to three bodies, given by rows, or None for the plane."""

    kind: str
    """One of `generated.joint_rows`."""
    ends: tuple[int | None, int | None, int | None]
    given: tuple[float, ...]
    """Its parameters, SI units."""
    apart: bool
    """Whether its bodies may not touch each other."""
    law: int = KEPT
    """What governs it, one of those in `tables`."""
    numbers: tuple[float, float, float, float] = (0.0, math.inf, 0.0, 0.0)
    """Of its law: rate, maximum, stiffness and damping."""

    @property
    def driven(self) -> bool:
        """Whether it may give energy."""
        return (self.law == MOTOR and self.numbers[0] != 0) or self.law == SPRING

    @property
    def governed(self) -> bool:
        """Whether it is a limit, a motor or a spring."""
        return self.law != KEPT
