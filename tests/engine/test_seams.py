"""Level static shapes that adjoin have no seam; what stands higher, or lies beyond a gap, stops."""

from typing import Any

import numpy as np
import pytest

import tamias2d as t2

SMOOTH: Any = {"friction": 0.0, "restitution": 0.0}


def ground(pieces: list[tuple[float, float]]) -> t2.Scene:
    """Boxes of half a metre whose tops are at these places, m, and which go down to -1 m."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    for x, top in pieces:
        shape = t2.Box(width=0.5, height=1.0 + top)
        scene.add_static(shape, position=(x, (top - 1.0) / 2), **SMOOTH)
    return scene


def slide(scene: t2.Scene, shape: Any, speed: float, height: float) -> tuple[t2.Simulator, int]:
    """A body that slides from x = 1 m on."""
    row = scene.add_body(
        shape, mass=1.0, position=(1.0, height), velocity=(speed, 0.0), name="slider", **SMOOTH
    )
    return t2.Simulator(scene), row


@pytest.mark.parametrize("speed", [0.3, 1.0, 3.0, 12.0, 20.0, 30.0, 60.0])
@pytest.mark.parametrize("shape", ["box", "turned"])
def test_what_slides_over_level_pieces_stays_level(speed: float, shape: str) -> None:
    level = [(0.5 * k, 0.0) for k in range(170)]
    corners = [(0.2, -0.2), (0.2, 0.2), (-0.2, 0.2), (-0.2, -0.2)]
    body = t2.Box(width=0.4, height=0.4) if shape == "box" else t2.Polygon(vertices=corners)
    sim, row = slide(ground(level), body, speed, 0.2)
    for _ in range(80):
        sim.step()
        # contacts let a body sink by some 1e-4 of its size, of which it may rise again
        assert sim.position[row, 1] == pytest.approx(0.2, abs=2e-4)
        assert sim.velocity[row, 0] == pytest.approx(speed, abs=3e-4)


@pytest.mark.parametrize("speed", [1.0, 5.0])
def test_a_ledge_a_wall_and_the_far_side_of_a_gap_stop_a_body(speed: float) -> None:
    ledge = [(0.5 * k, 0.0 if k < 6 else 0.05) for k in range(10)]
    wall = [(0.5 * k, 0.0 if k < 6 else 2.0) for k in range(10)]
    for pieces in (ledge, wall):
        sim, row = slide(ground(pieces), t2.Box(width=0.4, height=0.4), speed, 0.2)
        for _ in range(round(60 * 1.6 / speed)):
            sim.step()
            assert (sim.contacts.separation > -0.01).all()
        # it stands before what stops it, or tips over the ledge
        assert sim.position[row, 0] < 2.57
    pit = [(0.5 * k, 0.0) for k in range(6)] + [(4.5 + 0.5 * k, 0.0) for k in range(4)]
    sim, row = slide(ground(pit), t2.Box(width=0.4, height=0.4), speed, 0.2)
    deepest = 0.0
    for _ in range(round(60 * 3.4 / speed)):
        sim.step()
        x, y = sim.position[row]
        if -0.8 < y < -0.05:  # it falls through the gap, whose far side begins at 4.25 m
            deepest = max(deepest, x + 0.2)
    assert deepest <= 4.25 + 0.02


ROUND: Any = {
    "disc": (t2.Disc(radius=0.3), 0.3),
    "lying": (t2.Capsule(length=0.5, radius=0.1), 0.1),
    "plate": (t2.Box(width=0.4, height=0.4), 0.2),
}


@pytest.mark.parametrize("drop", [0.0, 0.01, 0.5])
@pytest.mark.parametrize("speed", [1.8, 3.7, 16.0, 19.0])
@pytest.mark.parametrize("name", ROUND)
def test_level_tiles_brake_nothing_that_rolls_or_lies(name: str, speed: float, drop: float) -> None:
    shape, height = ROUND[name]
    level = [(0.5 * k, 0.0) for k in range(90)]
    sim, row = slide(ground(level), shape, speed, height + drop)
    sim.step(120)
    assert sim.position[row, 1] == pytest.approx(height, abs=2e-4)
    assert sim.velocity[row, 0] == pytest.approx(speed, rel=1e-5)


@pytest.mark.parametrize("kind", ["box", "triangle", "capsule"])
@pytest.mark.parametrize("seed", [0, 3, 5, 9, 12, 14])
def test_level_tiles_brake_nothing_that_tumbles(kind: str, seed: int) -> None:
    rng = np.random.default_rng(seed)
    angles = 2 * np.pi * (np.arange(3) + rng.uniform(-0.3, 0.3, 3)) / 3
    shapes: Any = {
        "box": t2.Box(width=rng.uniform(0.3, 0.8), height=rng.uniform(0.2, 0.6)),
        "triangle": t2.Polygon(vertices=[(0.4 * np.cos(a), 0.4 * np.sin(a)) for a in angles]),
        "capsule": t2.Capsule(length=0.5, radius=0.1),
    }
    speed, scene = rng.uniform(1.0, 20.0), t2.Scene(gravity=(0.0, -9.81))
    for k in range(-2, 25):
        scene.add_static(t2.Box(width=2.0, height=1.0), position=(2.0 * k, -0.5), **SMOOTH)
    row = scene.add_body(
        shapes[kind],
        mass=1.0,
        position=(1.0, 0.7),
        orientation=rng.uniform(0.0, 6.0),
        velocity=(speed, 0.0),
        **SMOOTH,
    )
    sim = t2.Simulator(scene)
    sim.step(120)
    assert sim.velocity[row, 0] == pytest.approx(speed, rel=1e-4)


def test_a_body_on_its_corner_is_stopped_by_a_wall_on_the_ground() -> None:
    scene = ground([(0.5 * k, 0.0 if k < 6 else 2.0) for k in range(10)])
    row = scene.add_body(
        t2.Box(width=0.4, height=0.4),
        mass=1.0,
        position=(2.2, 0.4 / 2**0.5),
        orientation=0.785398,
        velocity=(3.0, 0.0),
        **SMOOTH,
    )
    sim = t2.Simulator(scene)
    sim.step(40)
    assert sim.position[row, 0] < 2.75 - 0.19
