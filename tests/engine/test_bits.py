"""The engine as plain Python and compiled: whole runs with the same bits."""

import numpy as np
import pytest

from tamias2d.engine.world import named_arrays
from tamias2d.simulator import Simulator
from tests.engine.scenes import mixed, plain


@pytest.mark.parametrize("seed", range(3))
def test_plain_and_compiled_runs_have_the_same_bits(seed: int) -> None:
    scene = mixed(seed, bodies=8)
    compiled, slow = Simulator(scene), plain(scene)
    most = 0
    with np.errstate(all="ignore"):  # plain arithmetic warns where compiled code does not
        for step in range(50):
            compiled.step()
            slow.step()
            first, second = (named_arrays(sim._engine.world) for sim in (compiled, slow))
            assert list(first) == list(second)
            for name in first:
                assert first[name].tobytes() == second[name].tobytes(), (step, name)
            most = max(most, len(compiled.contacts))
    assert most >= 5  # the run was about contacts
