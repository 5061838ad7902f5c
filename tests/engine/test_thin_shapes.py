"""Bodies as thin as nothing, thrown on floors as thin, stay above them, stepped or located."""

import math

import pytest

import tamias2d as t2
from tools.measurements.throws import located, stepped, throw

PASSED = (14, 18, 29, 32, 51, 79, 91, 98, 105, 124, 146, 149, 157, 176, 218, 242, 302, 366, 385)
PASSED += (426, 438, 448, 468, 478, 526, 570, 624, 682, 846, 892, 939, 967, 1025, 1029, 1042, 1055)
PASSED += (1151, 1210, 1216, 1244, 1298, 1299, 1499)
"""Seeds of throws that passed once."""


@pytest.mark.parametrize("seed", [*PASSED, *range(60)])
def test_nothing_passes_through_a_floor_where_it_is_stepped(seed: int) -> None:
    assert not stepped(throw(seed))


@pytest.mark.parametrize("seed", range(60))
def test_nothing_passes_through_a_floor_where_impacts_are_located(seed: int) -> None:
    assert not located(throw(seed))


@pytest.mark.parametrize("tilt", [0.0, 1e-12, 0.1, 1.5])
@pytest.mark.parametrize("height", [1e-3, 1.0])
def test_a_segment_comes_to_rest_on_a_segment(tilt: float, height: float) -> None:
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_static(t2.Segment(length=20.0), restitution=0.0, friction=0.5)
    up = height + 0.5 * math.sin(tilt)
    scene.add_body(
        t2.Segment(length=1.0), mass=1.0, position=(0.0, up), orientation=tilt,
        restitution=0.0, friction=0.5,
    )  # fmt: skip
    sim = t2.Simulator(scene)
    sim.step(300)
    assert abs(sim.position[1, 1]) < 1e-2
    assert abs(sim.velocity[1]).max() < 1e-3


def test_a_segment_that_falls_flat_on_a_long_free_one_stays_above() -> None:
    """Where they meet, rounding at an arm of 200 m hides the gap, and with it the side."""
    assert not stepped(throw(922_401))
