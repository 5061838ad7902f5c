"""Each symbol admits the values of its range and no others."""

import math
import re

import pytest

from tamias2d.generated.symbols import SYMBOLS

RANGES = {name: symbol.range.text for name, symbol in SYMBOLS.items() if symbol.range.text}
BEYOND = {"<": math.inf, ">": -math.inf}


def limits(text: str) -> list[tuple[float, bool, float]]:
    """Each limit of a range such as `> 0` or `[0, 1]`: its value, whether it is in, and outward.

    Written apart from the reader of ranges, so that it can judge it.
    """
    if text[0] in "<>":
        sign, value = re.fullmatch(r"([<>]=?) *(\S+)", text).groups()
        return [(float(value), sign.endswith("="), BEYOND[sign[0]])]
    left, low, high, right = re.fullmatch(r"([\[(])([^,]+),([^,]+)([\])])", text).groups()
    return [(float(low), left == "[", -math.inf), (float(high), right == "]", math.inf)]


@pytest.mark.parametrize("name", RANGES)
def test_the_limits_of_a_range(name: str) -> None:
    admits = SYMBOLS[name].admits
    for limit, inside, outward in limits(RANGES[name]):
        assert admits(limit) == inside
        assert not admits(math.nextafter(limit, outward))
        assert admits(math.nextafter(limit, -outward))
    assert not any(map(admits, (math.inf, -math.inf, math.nan)))
