"""Bodies that fall on each other do not get deep into each other, whatever corner comes down."""

import pytest

from tamias2d.study.engines.own import Own
from tools.measurements.drops import deepest, drop


@pytest.mark.parametrize("first", range(0, 40, 10))
def test_no_drop_is_deep(first: int) -> None:
    for seed in range(first, first + 10):
        _, deep, _ = deepest(Own, drop(seed))
        assert deep <= 0.05, seed
