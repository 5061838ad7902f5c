"""Elastic bodies that loads press together do not rebound from being pressed (DD93)."""

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.state import Array


def pressed(seed: int, restitution: float, time_step: float, substeps: int) -> Array:
    """Return the velocities in the first steps of a tower that starts in contact, and is pushed."""
    rng = np.random.default_rng(seed)
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)), time_step=time_step, substeps=substeps)
    surface = {"friction": 0.3, "restitution": restitution}
    sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    top = 0.0
    for _ in range(4):
        wide, high = rng.uniform(0.5, 2.0), rng.uniform(0.2, 0.8)
        place = (rng.uniform(-0.1, 0.1), top + high / 2)
        body = sim.add(
            t2.Box(width=wide, height=high), mass=rng.uniform(0.2, 4.0), position=place, **surface
        )
        sim.force[body] = rng.uniform(-15.0, 15.0), -rng.uniform(20.0, 60.0)
        top += high
    found = []
    for _ in range(4):
        sim.step()
        found.append(sim.velocity[1:].copy())
    return np.array(found)


@pytest.mark.parametrize("substeps", [1, 4])
@pytest.mark.parametrize("rate", [60, 240])
@pytest.mark.parametrize("seed", range(6))
def test_a_tower_that_is_pressed_moves_as_one_that_does_not_bounce(
    seed: int, rate: int, substeps: int
) -> None:
    """What contacts have left to the next step, as they are solved in turns, is no impact."""
    elastic = pressed(seed, 1.0, 1 / rate, substeps)
    soft = pressed(seed, 0.0, 1 / rate, substeps)
    assert np.abs(elastic - soft).max() < 1e-9  # m/s, beside loads that give 0.1 to 5 in a step
