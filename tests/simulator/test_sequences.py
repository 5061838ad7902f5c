"""Sequences of calls at random, odd values among them: each call is done, or refused by name."""

import pytest

from tools.fuzz import changed_sequences, jointed_sequences
from tools.fuzz.sequences import sequence

FOUND = (2408, 3033, 3913, 4159)
"""Seeds of sequences that broke something once."""
FOUND_JOINTED = (46, 101, 600403)
"""Likewise: a step that float64 could not hold left joints, and the rest of a wall, with what is no
number."""


FOUND_CHANGED = (50390,)
"""Likewise: an engine that was not told of the click of a ratchet."""


@pytest.mark.parametrize("seed", [*FOUND, *range(150)])
def test_a_sequence_of_calls_breaks_nothing(seed: int) -> None:
    sequence(seed)


@pytest.mark.parametrize("seed", [*FOUND_JOINTED, *range(40)])
def test_a_sequence_of_calls_with_joints_breaks_nothing(seed: int) -> None:
    jointed_sequences.case(seed)


@pytest.mark.parametrize("seed", [*FOUND_CHANGED, *range(40)])
def test_a_sequence_of_calls_that_change_things_breaks_nothing(seed: int) -> None:
    changed_sequences.case(seed)


def test_sequences_are_refused_now_and_then() -> None:
    assert 0 < sum(sequence(seed, calls=10) for seed in range(30)) < 200
