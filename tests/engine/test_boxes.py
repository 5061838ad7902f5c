"""Contacts whose boxes are far apart are not looked at, and nothing comes of those."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import tamias2d as t2
from tamias2d.engine import tables as tb
from tamias2d.engine.broad_phase.vertices import turn_vertices
from tamias2d.engine.narrow_phase import boxes, touching
from tamias2d.engine.narrow_phase.boxes import note_boxes, stays_far
from tamias2d.engine.tables import World
from tamias2d.simulator import Simulator
from tests.engine.crowds import rain

CLOSE = 0.02
PART = 0.25  # s


def started(first: Any, second: Any) -> World:
    """Return the world of a disc that moves and another body, after a step."""
    sim = Simulator(t2.Scene(gravity=(0.0, 0.0)), compiled=False)
    surface: Any = {"friction": 0.0, "restitution": 0.0}
    sim.add(first, mass=1.0, position=(0.0, 50.0), **surface)
    sim.add_static(second, position=(0.0, 0.0), **surface)
    sim.step()
    return sim._engine.world


def far(world: World) -> bool:
    """Return whether the shapes of both bodies are, as nothing is known of their contact."""
    none = np.zeros(10, dtype=np.int32)
    return stays_far(0, 1, 0.0, none, world.shapes.boxes)


def digest_of_rain(monkeypatch: pytest.MonkeyPatch, most: float) -> str:
    """Return that of a crowd with boxes where a list has more contacts to a shape."""
    monkeypatch.setattr(boxes, "LONG", most)
    sim, _ = rain(0.02, 0.5, count=20, compiled=False)
    sim.step(8)
    return sim.digest()


def test_boxes_change_no_bit(monkeypatch: pytest.MonkeyPatch) -> None:
    looks = 0

    def counted(*args: Any) -> bool:
        nonlocal looks
        far = stays_far(*args)
        looks += far
        return far

    monkeypatch.setattr(touching, "stays_far", counted)
    never = digest_of_rain(monkeypatch, 1e9)
    assert looks == 0
    assert digest_of_rain(monkeypatch, 0.0) == never
    assert looks > 0


@settings(max_examples=300, deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_what_boxes_leave_out_does_not_come_near(seed: int) -> None:
    """A disc and a box keep their distance, which is found in the axes of the box, on their way."""
    chance = np.random.default_rng(seed)
    radius, half, turn = chance.uniform(0.1, 1), chance.uniform(0.1, 1, 2), chance.uniform(0, 6)
    places, speeds = chance.uniform(-4, 4, (2, 2)), chance.uniform(-4, 4, (2, 2))
    world = started(t2.Disc(radius=radius), t2.Box(width=2 * half[0], height=2 * half[1]))
    slots = world.state.slot_of_body[:2]
    world.bodies.pose[slots, : tb.ANGLE], world.bodies.pose[slots, tb.ANGLE] = places, turn
    world.bodies.motion[slots, : tb.SPIN] = speeds
    turn_vertices(world.bodies, world.shapes, tb.STATIC)
    note_boxes(PART, CLOSE, world.bodies, world.shapes)
    if not far(world):
        return
    near = CLOSE * min(radius, float(np.hypot(*half)))
    c, s = np.cos(turn), np.sin(turn)
    for time in np.linspace(0.0, PART, 17):
        x, y = places[0] - places[1] + time * (speeds[0] - speeds[1])
        beside = np.maximum(np.abs((c * x + s * y, c * y - s * x)) - half, 0.0)
        assert np.hypot(*beside) - radius > near - 1e-12


def test_a_contact_that_is_known_is_looked_at() -> None:
    far = np.zeros((2, 8))
    far[1, tb.BOX_LOW_X] = far[1, tb.BOX_HIGH_X] = 1.0
    flags = np.zeros(10, dtype=np.int32)
    assert stays_far(0, 1, 0.0, flags, far)
    for known in (tb.POINT_COUNT, tb.TOUCHES, tb.FEATURE, tb.FEATURE + 1):
        flags[:] = 0
        flags[known] = 1
        assert not stays_far(0, 1, 0.0, flags, far)


@pytest.mark.parametrize(
    "shape",
    [t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), t2.Box(width=1.0, height=1e-3)],
    ids=["half-plane", "thin"],
)
def test_what_is_boundless_or_thin_is_never_far(shape: Any) -> None:
    world = started(t2.Disc(radius=0.5), shape)
    world.bodies.pose[world.state.slot_of_body[0], tb.Y] = 1e9
    note_boxes(PART, CLOSE, world.bodies, world.shapes)
    assert not far(world)
