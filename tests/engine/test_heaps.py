"""Heaps of boxes that bounce come to rest as those do that do not: what carries is not dropped."""

import numpy as np
import pytest

from tamias2d import Box, HalfPlane, Scene, Simulator

G = 9.81
WIDE, SIZE, PITCH = 14, 0.15, 0.24  # boxes side by side as they are poured; m


@pytest.mark.filterwarnings("ignore::tamias2d.errors.StepWarning")  # lowest boxes are pressed
@pytest.mark.parametrize(("restitution", "seed"), [(0.1, 1), (0.3, 2)])
def test_a_heap_of_thirty_layers_comes_to_rest(restitution: float, seed: int) -> None:
    sim = Simulator(Scene(gravity=(0.0, -G)), sleeping=True)
    surface = {"friction": 0.5, "restitution": 0.0}
    sim.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    for x in (-2.0, 2.0):
        sim.add_static(Box(width=0.5, height=200.0), position=(x, 100.0), **surface)
    k = np.arange(400)
    places = np.column_stack((-1.63 + PITCH * (k % WIDE), 0.2 + PITCH * (k // WIDE)))
    boxes = sim.add(
        Box(width=SIZE, height=SIZE),
        mass=1.0,
        position=places,
        velocity=np.random.default_rng(seed).normal(0.0, 1.0, (len(k), 2)),
        friction=0.5,
        restitution=restitution,
    )
    sim.step(1500)
    speed = np.sqrt((sim.velocity[boxes] ** 2).sum(axis=1).mean())
    assert speed < 0.05 * G * sim.time_step  # of what gravity gives in a step
