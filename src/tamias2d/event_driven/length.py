"""The length of a vector with the bits of CPython's `math.hypot`, for compiled code.

The function of the C library, which compiled code would have, rounds now and then otherwise.
"""

import math
import random
from functools import cache
from math import frexp, ldexp, sqrt

from tamias2d.event_driven.tables import Pair

SPLIT = 134217729.0  # 2^27 + 1
ABOVE, BELOW = 2.0**52 + 1.0, 1.0 - 2.0**-53
EXTREME = 1e200
_TRIED = 2000


def hypot(x: float, y: float) -> float:
    """Return the length of a vector as `math.hypot` of CPython does, to the bit."""
    x, y = abs(x), abs(y)
    largest = max(x, y)
    if largest == 0.0:
        return 0.0
    power = power_of_two(largest)
    scale = 0.5 / power
    total, low, lost = 1.0, 0.0, 0.0
    for value in (x * scale, y * scale):
        high, rest = product(value, value)
        after = total + high
        lost += (total - after) + high
        low += rest
        total = after
    length = sqrt(total - 1.0 + (low + lost))
    high, rest = product(-length, length)
    after = total + high
    lost += (total - after) + high
    low += rest
    error = after - 1.0 + (low + lost)
    return (length + error / (2.0 * length)) * power * 2.0


def power_of_two(x: float) -> float:
    """Return the largest power of two that is not above a positive number.

    In the middle of the range it follows from rounding (Rump, 2009, unit in the first place).
    """
    if 1.0 / EXTREME < x < EXTREME:
        above = ABOVE * x
        return above - above * BELOW
    _, exponent = frexp(x)
    return ldexp(1.0, exponent - 1)


def product(x: float, y: float) -> Pair:
    """Return a product, rounded, and what rounding took from it (Dekker)."""
    split = x * SPLIT
    x_high = split - (split - x)
    split = y * SPLIT
    y_high = split - (split - y)
    x_low, y_low = x - x_high, y - y_high
    found = x * y
    return found, x_high * y_high - found + x_high * y_low + x_low * y_high + x_low * y_low


@cache
def hypot_agrees() -> bool:
    """Whether this Python's `math.hypot` is the one that is written here."""
    numbers = random.Random(1)
    pairs = [
        (numbers.gauss(0, 1) * 10 ** numbers.uniform(-3, 3), numbers.gauss(0, 1))
        for _ in range(_TRIED)
    ]
    return all(hypot(x, y) == math.hypot(x, y) for x, y in pairs)
