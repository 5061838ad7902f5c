"""What the compiler is given for lanes does what the plain functions do, to the bit."""

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, strategies as st
from numba import njit

from tamias2d.kernels import lane_code, lanes
from tamias2d.kernels.lanes import LANES, ROW

ROWS, LEAD, COLUMN = 40, 5, 3
SEEDS = st.integers(0, 2**32 - 1)


@njit
def load_half(places, first, rows, loaded, to):
    lane_code.load_half(places, first, rows, loaded, to)


@njit
def load_rows(places, first, rows, loaded, to):
    lane_code.load_rows(places, first, rows, loaded, to)


@njit
def load_part(places, first, rows, loaded, to):
    lane_code.load_part(places, first, rows, COLUMN, loaded, to)


@njit
def store_half(places, first, rows, loaded, to):
    lane_code.store_half(places, first, rows, loaded, to)


@njit
def both_above(row, a, least_a, b, least_b):
    return lane_code.both_above(row, a, least_a, b, least_b)


def plain_part(places, first, rows, loaded, to):
    lanes.load_part(places, first, rows, COLUMN, loaded, to)


PLAIN = {load_part: plain_part} | {
    compiled: getattr(lanes, compiled.__name__) for compiled in (load_half, load_rows, store_half)
}


def moved(move: Callable[..., None], seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Return random rows and lanes, after some have been moved."""
    random = np.random.default_rng(seed)
    rows = random.normal(size=(ROWS, COLUMN + ROW))
    places = random.permutation(ROWS)[: LEAD + LANES].astype(np.uint32)
    loaded = random.normal(size=LEAD + ROW * LANES)
    move(places, LEAD, rows, loaded, LEAD)
    return rows, loaded


@pytest.mark.parametrize("compiled", PLAIN)
@given(seed=SEEDS)
def test_rows_are_moved_as_by_the_plain_function(compiled: Callable[..., None], seed: int) -> None:
    for ours, theirs in zip(moved(compiled, seed), moved(PLAIN[compiled], seed), strict=True):
        assert np.array_equal(ours, theirs)


@given(seed=SEEDS)
def test_all_that_is_loaded_is_stored_where_it_was(seed: int) -> None:
    random = np.random.default_rng(seed)
    rows, loaded = random.normal(size=(ROWS, COLUMN + ROW)), np.zeros(ROW * LANES)
    places = random.permutation(ROWS)[:LANES].astype(np.uint32)
    rows[:, lanes.USED] = 0.0
    before = rows.copy()
    load_half(places, 0, rows, loaded, 0)
    rows[places, : lanes.HALF] = 0.0
    store_half(places, 0, rows, loaded, 0)
    assert np.array_equal(rows, before)


@given(seed=SEEDS, least=st.tuples(st.floats(-3.0, 3.0), st.floats(-3.0, 3.0)))
def test_lanes_are_compared_as_by_the_plain_function(seed: int, least: tuple[float, float]) -> None:
    row = np.random.default_rng(seed).normal(size=LEAD + 3 * LANES)
    row[LEAD] = np.nan
    question = (row, LEAD, least[0], LEAD + 2 * LANES, least[1])
    assert both_above(*question) == lanes.both_above(*question)


@given(lane=st.integers(0, LANES - 1))
def test_any_lane_is_seen(lane: int) -> None:
    row = np.zeros(2 * LANES)
    row[lane] = row[LANES + lane] = 1.0
    assert both_above(row, 0, 0.5, LANES, 0.5)
    row[lane] = 0.5
    assert not both_above(row, 0, 0.5, LANES, 0.5)
