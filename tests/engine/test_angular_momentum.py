"""Islands that nothing holds keep their angular momentum in steps (IM17)."""

import pytest

from tools.fuzz import momentum

# what came off by 1e-8 to 1.5e-4 of the sum of magnitudes, with the arms of the begin of a step
# alone: through blocks of lanes, trees, restitution, parts of a step, and impacts in flight
OFF = (16, 24, 40, 72, 82, 143, 183, 217, 241)


@pytest.mark.parametrize("seed", OFF)
def test_what_nothing_pushes_keeps_its_angular_momentum(seed: int) -> None:
    assert momentum.stepped(seed) == "done"
