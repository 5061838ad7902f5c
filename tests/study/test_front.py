"""The Pareto front, by hand and by its definition."""

from hypothesis import given, strategies as st

from tamias2d.study.front import front

PAIRS = st.lists(st.tuples(st.integers(0, 9), st.integers(0, 9)), min_size=1, max_size=20)


def test_a_front_by_hand() -> None:
    assert front([(3, 1), (1, 5), (2, 5), (2, 3), (4, 2), (1, 6)]) == [1, 3, 0]


def test_an_error_without_limit_is_never_on_it() -> None:
    assert front([(1.0, float("inf"))]) == []


@given(PAIRS)
def test_nothing_is_both_cheaper_and_better(pairs: list[tuple[float, float]]) -> None:
    found = front(pairs)
    for k in found:
        assert not any(
            c <= pairs[k][0] and e <= pairs[k][1] for c, e in pairs if (c, e) != pairs[k]
        )
    for k, (cost, error) in enumerate(pairs):
        assert k in found or any(pairs[j][0] <= cost and pairs[j][1] <= error for j in found)
