"""Numbers as they come, with odd ones among them."""

import math
import random

ODD = (0.0, -1.0, 5e-324, 1e-320, 1e-150, 1e-30, 1e15, 1e30, 1e80, 1e154, 1e200, 1e300)
NONE = (math.nan, math.inf)


class Numbers:
    """Numbers of a seed: most of a case are sound."""

    def __init__(self, seed: int) -> None:
        """Take a seed; it also decides the share of odd numbers."""
        self.chance = random.Random(seed)
        self.odd = self.chance.choice((0.0, 0.02, 0.1, 0.4))

    def strange(self) -> bool:
        """Return whether the next value is an odd one."""
        return self.chance.random() < self.odd

    def number(self, low: float = -3.0, high: float = 3.0) -> float:
        """Return a number of a range, or an odd one."""
        if self.strange():
            return self.chance.choice((1.0, -1.0)) * self.chance.choice((*ODD, *NONE))
        return self.chance.uniform(low, high)

    def positive(self, low: float = -1.0, high: float = 0.5) -> float:
        """Return ten to a power of a range, or an odd number."""
        return self.number() if self.strange() else 10.0 ** self.chance.uniform(low, high)

    def pair(self, size: float = 3.0) -> tuple[float, float]:
        """Return two numbers."""
        return self.number(-size, size), self.number(-size, size)
