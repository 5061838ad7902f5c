"""Verdicts survive the way to the file and back, and a bad file does no harm."""

import math

import pytest
from hypothesis import given, strategies as st

from tamias2d import storage
from tamias2d.verify import results
from tamias2d.verify.outcome import Outcome, read_outcome

OUTCOMES = st.builds(
    Outcome,
    id=st.sampled_from(["TC1", "OB8a"]),
    quantity=st.text(max_size=5),
    error=st.floats(min_value=0, allow_nan=False),
    tolerance=st.floats(min_value=0, allow_nan=False, allow_infinity=False),
    verdict=st.sampled_from(["pass", "fail", "manual"]),
    hash=st.text("0123456789abcdef", max_size=12),
    note=st.text(max_size=5),
)


@given(OUTCOMES)
def test_an_outcome_comes_back(outcome: Outcome) -> None:
    assert read_outcome(outcome.as_json()) == outcome


def test_infinity_is_null() -> None:
    outcome = Outcome("TC1", "position", math.inf, 1e-12, "fail")
    assert outcome.as_json()["error"] is None


@pytest.mark.parametrize(
    "content",
    [
        "",
        "{",
        "[]",
        "null",
        '{"format": 0, "cases": []}',
        '{"format": 2, "cases": [{"id": "TC1"}]}',
    ],
)
def test_a_file_that_cannot_be_read_counts_as_none(content: str) -> None:
    storage.results_path().write_text(content)
    assert results.read() == {}
    results.add([Outcome("TC1", "position", 0.0, 1e-12, "pass")])
    assert list(results.read()) == ["TC1"]


def test_no_file_is_no_result() -> None:
    assert results.read() == {}
