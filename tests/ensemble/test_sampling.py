"""What varies: grids, values, distributions and designs, and what is refused."""

from itertools import product
from typing import Any

import numpy as np
import pytest
from scipy import stats
from scipy.stats import qmc

import tamias2d as t2
from tamias2d.ensemble.sampling import sampled
from tests.ensemble.scenes import bouncing

RESTITUTION, HEIGHT = "bodies.ball.restitution", "bodies.ball.position.y"
UNIFORM = {RESTITUTION: stats.uniform(0.2, 0.6), HEIGHT: stats.norm(1.5, 0.1)}


def values(vary: Any, worlds: Any = None, seed: Any = 1, design: Any = None) -> dict[str, Any]:
    found = sampled(bouncing(), vary, worlds, seed, design)
    return {place.path: array for place, array in found.items()}


def test_more_worlds_leave_those_that_there_were() -> None:
    few, many = values(UNIFORM, 10), values(UNIFORM, 1000)
    for path in UNIFORM:
        np.testing.assert_array_equal(few[path], many[path][:10])


def test_what_else_varies_changes_nothing() -> None:
    alone = values({HEIGHT: UNIFORM[HEIGHT]}, 10)
    np.testing.assert_array_equal(alone[HEIGHT], values(UNIFORM, 10)[HEIGHT])
    swapped = values(dict(reversed(UNIFORM.items())), 10)
    np.testing.assert_array_equal(swapped[RESTITUTION], values(UNIFORM, 10)[RESTITUTION])


def test_values_follow_their_distribution_and_are_independent() -> None:
    found = values(UNIFORM, 4000, seed=7)
    for path, distribution in UNIFORM.items():
        assert stats.kstest(found[path], distribution.cdf).pvalue > 1e-4
    # of 4000 independent pairs the correlation is within 4/sqrt(4000) but once in 16 000
    assert abs(np.corrcoef(found[RESTITUTION], found[HEIGHT])[0, 1]) < 4 / np.sqrt(4000)
    assert not np.array_equal(found[HEIGHT], values(UNIFORM, 4000, seed=8)[HEIGHT])


@pytest.mark.parametrize("design", [qmc.Sobol, qmc.LatinHypercube, qmc.Halton])
def test_a_design_spreads_values_more_evenly(design: Any) -> None:
    def discrepancy(found: dict[str, Any]) -> float:
        shares = [UNIFORM[path].cdf(found[path]) for path in UNIFORM]
        return float(qmc.discrepancy(np.column_stack(shares)))

    spread = values(UNIFORM, 256, design=design)
    assert discrepancy(spread) < discrepancy(values(UNIFORM, 256)) / 2
    again = values(UNIFORM, 256, design=design)
    np.testing.assert_array_equal(spread[HEIGHT], again[HEIGHT])


def test_grids_are_combined_and_the_last_is_fastest() -> None:
    found = values({RESTITUTION: t2.Grid(0.1, 0.5), HEIGHT: t2.Grid(np.linspace(1, 2, 3))})
    rows = list(zip(found[RESTITUTION].tolist(), found[HEIGHT].tolist(), strict=True))
    assert rows == list(product((0.1, 0.5), (1.0, 1.5, 2.0)))


def test_units_are_read_and_vectors_are_pairs() -> None:
    found = values({HEIGHT: ["150 cm", "2 m"], "gravity": [["0", "-1 m/s^2"], [1.0, 2.0]]})
    assert found[HEIGHT].tolist() == [1.5, 2.0]
    assert found["gravity"].tolist() == [[0.0, -1.0], [1.0, 2.0]]


REFUSED = [
    ({RESTITUTION: [0.5, 1.2]}, {}, r"1\.2 for world 1: must be in \[0, 1\] \(symbol restitution"),
    ({RESTITUTION: stats.norm(0.5, 1.0)}, {"worlds": 99}, r"for world \d+: must be in \[0, 1\]"),
    ({HEIGHT: [1.0, np.nan]}, {}, "nan m for world 1: must be finite"),
    ({"bodies.ball.mass": [1.0, np.inf]}, {}, "inf kg for world 1: must be finite"),
    (
        {HEIGHT: stats.norm()},
        {"worlds": 2, "design": qmc.Sobol(d=1)},
        r"design: found <.*Sobol.*must be a class .*without brackets, such as design=qmc\.Sobol",
    ),
    ({HEIGHT: ["1 kg"]}, {}, r"of unit kg: must be in m \(symbol position\)"),
    ({HEIGHT: ["1"]}, {}, "of unit 1: must be in m"),
    ({HEIGHT: [None]}, {}, r"must be numbers in m, or texts with a unit \(R2\)"),
    ({HEIGHT: 1.0}, {}, r"found 1\.0: must be values for all worlds, a t2\.Grid, or a distrib"),
    ({"gravity": stats.norm()}, {"worlds": 2}, "a distribution has one number.*'gravity.x'"),
    ({"gravity": [1.0, 2.0]}, {}, r"of shape \(2,\): must be \(2, 2\), a pair for each world"),
    ({HEIGHT: [[1.0, 2.0]]}, {}, r"of shape \(1, 2\): must be \(1,\), one number for each"),
    ({HEIGHT: [1.0], RESTITUTION: [0.1, 0.2]}, {}, "found 2, but vary .* is 1: all must tell"),
    ({HEIGHT: [1.0]}, {"worlds": 3}, "must tell the same number of worlds"),
    ({HEIGHT: t2.Grid(1.0, 2.0)}, {"worlds": 3}, "the product of the grids is 2"),
    ({HEIGHT: []}, {}, r"found no value \(R5\)"),
    ({HEIGHT: stats.norm()}, {}, r"worlds: found none: must be stated"),
    ({HEIGHT: stats.norm()}, {"worlds": 0}, "worlds 0: must be a whole number of at least 1"),
    ({HEIGHT: stats.norm()}, {"worlds": 3, "seed": None}, r"seed: found none: must be stated"),
    ({HEIGHT: stats.norm()}, {"worlds": 3, "seed": -1}, "seed -1: must be a whole number"),
    ({HEIGHT: [1.0], "bodies.ball.position": [[1.0, 1.0]]}, {}, "the same value varies twice"),
    ({}, {"worlds": 2}, r"vary: found \{\}: must name what varies"),
    (None, {"worlds": 2}, "vary: found None: must name what varies"),
]


@pytest.mark.parametrize(("vary", "more", "message"), REFUSED)
def test_what_cannot_be_varied_so_is_refused(vary: Any, more: Any, message: str) -> None:
    with pytest.raises(t2.InputError, match=message) as found:
        values(vary, **more)
    assert "\n" not in str(found.value)
