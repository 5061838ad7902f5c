"""Jointed bodies that overlap the ground come out of it as fast as others."""

import numpy as np
import pytest

from tamias2d import Box, Disc, HalfPlane, Revolute, Scene, Simulator

G = 9.81
HEIGHT = 0.3  # of each box, m
SURFACE = {"friction": 0.6, "restitution": 0.0}
OUT = 0.01  # m, left of an overlap


def sunk_row(count: int, depth: float, time_step: float, *, jointed: bool) -> Simulator:
    """Return boxes side by side that overlap the ground, hinged to each other or not."""
    scene = Scene(gravity=(0.0, -G))
    scene.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    height = 0.5 * HEIGHT - depth
    boxes = [
        scene.add_body(
            Box(width=1.0, height=HEIGHT), mass=1.0, position=(k, height), group=-1, **SURFACE
        )
        for k in range(count)
    ]
    for k in range(count - 1 if jointed else 0):
        scene.add_joint(Revolute(), boxes[k], boxes[k + 1], at=(k + 0.5, height))
    return Simulator(scene, time_step=time_step)


def steps_until_out(sim: Simulator, most: int) -> int:
    """Return in how many steps the lowest box is out of the ground but for a centimetre."""
    for step in range(1, most + 1):
        sim.step()
        if sim.position[sim.dynamic, 1].min() > 0.5 * HEIGHT - OUT:
            return step
    return most + 1


@pytest.mark.parametrize("time_step", [1 / 60, 1 / 240])
@pytest.mark.parametrize(("count", "depth"), [(2, 0.02), (2, 0.1), (5, 0.1)])
def test_hinged_boxes_come_out_as_fast_as_free_ones(
    count: int, depth: float, time_step: float
) -> None:
    free = steps_until_out(sunk_row(count, depth, time_step, jointed=False), 30)
    assert free < 30
    assert steps_until_out(sunk_row(count, depth, time_step, jointed=True), 30) <= free + 2


@pytest.mark.parametrize("time_step", [1 / 60, 1 / 240])
def test_what_came_out_rests_on_the_ground(time_step: float) -> None:
    """Nothing is thrown up (free boxes 0.6 mm), and the ground bears the weight and no more."""
    sim = sunk_row(4, 0.1, time_step, jointed=True)
    highest = 0.0
    for _ in range(round(1.0 / time_step)):
        sim.step()
        highest = max(highest, float(sim.position[sim.dynamic, 1].max()))
    assert highest < 0.5 * HEIGHT + 2e-3
    assert sim.contacts.impulse.sum() == pytest.approx(4.0 * G * time_step, rel=1e-6)


def test_a_wheel_that_grows_lifts_the_cart_that_is_jointed_to_it() -> None:
    """A disc under a box gets 0.1 m more of radius: both are up within a fifth of a second."""
    scene = Scene(gravity=(0.0, -G))
    scene.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    wheel = scene.add_body(Disc(radius=0.3), mass=2.0, position=(0.0, 0.3), group=-1, **SURFACE)
    box = Box(width=0.4, height=0.4)
    cart = scene.add_body(box, mass=5.0, position=(0.0, 0.8), inertia=np.inf, group=-1, **SURFACE)
    scene.add_joint(Revolute(), cart, wheel, at=(0.0, 0.3))
    sim = Simulator(scene, time_step=1 / 60)
    sim.step(10)
    sim.set_shape(wheel, Disc(radius=0.4))
    sim.step(12)
    assert sim.position[wheel, 1] == pytest.approx(0.4, abs=OUT)
    assert sim.position[cart, 1] == pytest.approx(0.9, abs=OUT)
