"""Bodies as thin as nothing, thrown on floors as thin, stay above them, stepped or located."""

import math
from typing import Any

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


@pytest.mark.parametrize("seed", [976_541, *range(60)])  # the first floor turns by 1e-7 rad
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


def test_a_capsule_that_falls_flat_on_a_sheet_with_slanted_ends_stays_above() -> None:
    """The sides of its ends are turned by 1e-8 against its top, and 200 m away."""
    assert not stepped(throw(1_107_555))


@pytest.mark.parametrize(
    ("tilt", "height", "speed", "spin"),
    [(0.03344, 0.0167, 0.4743, 0.2964), (0.0445, 0.0216, 0.474, 0.3)],
)
def test_a_rod_whose_end_lies_in_a_sheet_comes_down_on_it(
    tilt: float, height: float, speed: float, spin: float
) -> None:
    """The end is behind the sheet by as much as contacts yield; the other one comes later."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    surface: dict[str, Any] = {"restitution": 0.0, "friction": 0.0}
    scene.add_static(t2.Box(width=4.0, height=1e-8), position=(0.0, -0.5e-8), **surface)
    scene.add_body(
        t2.Segment(length=0.4), mass=1.0, position=(0.0, height), orientation=tilt,
        velocity=(0.0, -speed), angular_velocity=spin, **surface,
    )  # fmt: skip
    sim = t2.Simulator(scene, time_step=1 / 240)
    sim.step(240)
    assert sim.position[1, 1] > -1e-3  # 0.3 m below it without the rule of `is_located`
