"""Heaps of boxes fall asleep, whether they bounce or not: what carries is not dropped."""

import numpy as np
import pytest

from tamias2d import Box, HalfPlane, Scene, Simulator

G = 9.81
WIDE, SIZE, PITCH = 14, 0.15, 0.24  # boxes side by side as they are poured; m


@pytest.mark.filterwarnings("ignore::tamias2d.errors.StepWarning")  # lowest boxes are pressed
@pytest.mark.parametrize(
    ("count", "restitution", "seed"), [(300, 0.0, 2), (400, 0.0, 4), (400, 0.1, 2), (600, 0.3, 1)]
)
def test_a_heap_of_many_layers_falls_asleep(count: int, restitution: float, seed: int) -> None:
    """In a heap of 20 to 40 layers single contacts of boxes carry many times their weight."""
    sim = Simulator(Scene(gravity=(0.0, -G)), sleeping=True)
    surface = {"friction": 0.5, "restitution": 0.0}
    sim.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    for x in (-2.0, 2.0):
        sim.add_static(Box(width=0.5, height=200.0), position=(x, 100.0), **surface)
    k = np.arange(count)
    places = np.column_stack((-1.63 + PITCH * (k % WIDE), 0.2 + PITCH * (k // WIDE)))
    boxes = sim.add(
        Box(width=SIZE, height=SIZE),
        mass=1.0,
        position=places,
        velocity=np.random.default_rng(seed).normal(0.0, 1.0, (len(k), 2)),
        friction=0.5,
        restitution=restitution,
    )
    sim.step(1800)
    assert sim.asleep[boxes].all()
