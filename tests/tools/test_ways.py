"""Ways of bodies through the parts of a step, beside what their ends say."""

from pathlib import Path

import numpy as np

import tamias2d as t2
from tests.engine.crowds import rain
from tools.measurements.arena.ways import ways


def test_a_body_that_nothing_meets_goes_as_far_as_its_velocity_says(tmp_path: Path) -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    sim.add(t2.Disc(radius=0.1), mass=1.0, position=(0.0, 0.0), velocity=(3.0, 4.0))
    sim.step()
    sim.save(tmp_path / "step.npz")
    np.testing.assert_allclose(ways(tmp_path / "step.npz"), [5.0 / 60], rtol=1e-14)  # roundings


def test_ways_to_and_fro_are_longer_than_from_end_to_end(tmp_path: Path) -> None:
    sim, rows = rain(0.02, 0.5, count=12)
    longer = 0.0
    for step in range(6):
        saved, place = tmp_path / f"{step}.npz", sim.position.copy()
        sim.save(saved)
        sim.step()
        ends, length = np.hypot(*(sim.position - place).T), ways(saved)
        assert (length >= ends * (1.0 - 1e-12)).all()  # roundings
        if sim.parts == 1:
            np.testing.assert_allclose(length[rows], ends[rows], rtol=1e-9)
        longer = max(longer, float((length - ends)[rows].max()))
    assert longer > 1e-3  # m: some were turned back between the begin and the end of a step
