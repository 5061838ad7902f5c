"""What happens next in a flight, against looking at everything."""

import numpy as np
from hypothesis import given, strategies as st

from tamias2d.stepped.flight_agenda import (
    PAIRS_OF,
    STARTS_OF,
    TOURNAMENT,
    WINNER,
    list_by_body,
    play_again,
    play_all,
)
from tamias2d.stepped.layout import OF_A, OF_B, PAIRS

TIMES = st.sampled_from([0.0, 0.25, 0.5, 1.0, 2.0])


@given(st.lists(TIMES, min_size=1, max_size=40), st.lists(st.tuples(st.integers(0, 39), TIMES)))
def test_the_first_of_the_soonest_wins_after_each_change(
    start: list[float], changes: list[tuple[int, float]]
) -> None:
    times, agenda = np.array(start), np.zeros((3, 4 * len(start)), np.int32)
    play_all(len(times), times, agenda)
    assert agenda[TOURNAMENT, WINNER] == np.argmin(times)
    for event, time in changes:
        times[event % len(times)] = time
        play_again(event % len(times), len(times), times, agenda)
        assert agenda[TOURNAMENT, WINNER] == np.argmin(times)


@given(st.integers(2, 12), st.data())
def test_each_body_has_its_pairs_in_their_order(bodies: int, data: st.DataObject) -> None:
    one = st.integers(0, bodies - 1)
    drawn = data.draw(st.lists(st.tuples(one, one).filter(lambda p: p[0] != p[1]), max_size=30))
    pair = np.zeros((max(len(drawn), 1), 4), np.int32)
    for p, (i, j) in enumerate(drawn):
        pair[p, OF_A], pair[p, OF_B] = i, j
    counts, agenda = np.zeros(23, np.int64), np.zeros((3, 4 * (bodies + len(pair))), np.int32)
    counts[PAIRS] = len(drawn)
    list_by_body(counts, bodies, pair, agenda)
    for i in range(bodies):
        listed = agenda[PAIRS_OF, agenda[STARTS_OF, i] : agenda[STARTS_OF, i + 1]]
        assert listed.tolist() == [p for p, both in enumerate(drawn) if i in both]
