"""The event search, which judges other code, is judged by textbook answers."""

import math

import numpy as np
import pytest

from tamias2d.errors import InputError
from tamias2d.scene import Box, Disc, HalfPlane, Scene, catalogue
from tamias2d.verify.events import simulate_by_events

FLOOR = HalfPlane(normal=(0.0, 1.0), offset=0.0)


def test_a_bouncing_ball() -> None:
    events = simulate_by_events(catalogue.load("bouncing-disc"), duration=3.5)
    fall = math.sqrt(2 / 9.81)
    exact = [fall * (1 + 2 * sum(0.8**k for k in range(1, n + 1))) for n in range(9)]
    assert events.time == pytest.approx(exact, abs=1e-11)


def test_discs_that_meet_off_centre() -> None:
    events = simulate_by_events(catalogue.load("oblique-discs"), duration=3.0)
    assert events.state[:, 3:5] == pytest.approx(
        np.array([[0.25, -0.4330127018922193], [0.75, 0.4330127018922193]]), abs=1e-11
    )


def test_a_corner_that_hits_a_floor() -> None:
    events = simulate_by_events(catalogue.load("spinning-square"), duration=0.26)
    spin = events.state[0, 5]
    assert events.time == pytest.approx([0.25], abs=1e-11)
    assert spin == pytest.approx(-2.14219086825576, abs=1e-10)


def test_shapes_that_are_not_covered_are_refused() -> None:
    scene = Scene(gravity=(0.0, 0.0))
    for x in (0.0, 3.0):
        scene.add_body(Box(width=1.0, height=1.0), mass=1.0, position=(x, 0.0), restitution=1.0)
    with pytest.raises(InputError, match="not covered"):
        simulate_by_events(scene, duration=1.0)


def test_nothing_meets_without_shapes() -> None:
    scene = Scene(gravity=(0.0, -2.0))
    scene.add_body(None, mass=1.0, position=(0.0, 1.0))
    scene.add_static(FLOOR)
    events = simulate_by_events(scene, duration=3.0)
    assert events.time == []
    assert events.state[0, 1] == pytest.approx(-8.0)


def test_a_varying_force_and_an_impact() -> None:
    scene = Scene(gravity=(0.0, 0.0))
    scene.add_body(
        Disc(radius=1.0), mass=2.0, position=(0.0, 2.0), force=(0.0, "-12[N/s]*time"),
        restitution=0.5,
    )  # fmt: skip
    scene.add_static(FLOOR)
    events = simulate_by_events(scene, duration=1.2)
    assert events.time == pytest.approx([1.0], abs=1e-11)  # y = 2 - t^3
    assert events.state[0, 4] == pytest.approx(1.5 - 3 * (1.2**2 - 1), abs=1e-10)
