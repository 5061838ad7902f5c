"""Without restitution, what is squeezed between others stays there, whatever its mass."""

from typing import Any

import pytest

import tamias2d as t2

SURFACE: Any = {"friction": 0.0, "restitution": 0.0}
SHAPES = {"disc": t2.Disc(radius=0.5), "box": t2.Box(width=1.0, height=1.0)}
SPEED = 2.0


@pytest.mark.parametrize("add_wall", ["add_static", "add_kinematic"])
@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("mass", [3.0, 30.0, 100.0, 1000.0])
@pytest.mark.parametrize("time_step", [1 / 60, 1 / 240])
def test_what_presses_a_light_body_to_a_wall_stops(
    add_wall: str, shape: str, mass: float, time_step: float
) -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    wall = t2.Box(width=0.2, height=4.0)
    getattr(scene, add_wall)(wall, position=(-0.6, 0.0), **SURFACE)
    scene.add_body(SHAPES[shape], mass=1.0, position=(0.0, 0.0), **SURFACE)
    scene.add_body(SHAPES[shape], mass=mass, position=(1.2, 0.0), velocity=(-SPEED, 0.0), **SURFACE)
    sim = t2.Simulator(scene, time_step=time_step)
    sim.step(round(0.5 / time_step))
    assert abs(sim.velocity).max() < 1e-3 * SPEED  # slow enough to be no bounce


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("mass", [0.1, 1.0, 10.0])
def test_two_heavy_bodies_stop_at_a_light_one_between_them(shape: str, mass: float) -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    for x, own in ((-1.2, 100.0), (0.0, mass), (1.2, 100.0)):
        speed = -SPEED * x / 1.2
        scene.add_body(SHAPES[shape], mass=own, position=(x, 0.0), velocity=(speed, 0.0), **SURFACE)
    sim = t2.Simulator(scene, time_step=1 / 60)
    sim.step(60)
    assert abs(sim.velocity).max() < 1e-3 * SPEED
