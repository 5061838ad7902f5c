"""Bodies that touch and fall go along their parabolas, as each would alone (IM1)."""

import numpy as np
import pytest

import tamias2d as t2

G = 10.0
SURFACE = {"friction": 0.6, "restitution": 0.0}
BOX = t2.Box(width=0.5, height=0.5)


@pytest.mark.parametrize("substeps", [1, 4])
@pytest.mark.parametrize("count", [2, 5])
def test_what_touches_falls_as_what_does_not(count: int, substeps: int) -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -G)), substeps=substeps)
    heights = 0.5 * np.arange(count)
    bodies = sim.add(BOX, mass=1.0, position=[(0.0, float(y)) for y in heights], **SURFACE)
    sim.step(60)
    assert sim.velocity[bodies, 1] == pytest.approx(np.full(count, -G), rel=1e-12)
    assert sim.position[bodies, 1] - heights == pytest.approx(np.full(count, -G / 2), rel=1e-12)


@pytest.mark.parametrize("sleeping", [False, True])
def test_a_stack_falls_freely_once_its_floor_is_gone(sleeping: bool) -> None:
    """Its overlaps push it apart by no more than they are, which bits do not decide."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -G)), sleeping=sleeping)
    floor = sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    sim.add(BOX, mass=1.0, position=[(0.0, 0.25), (0.0, 0.75)], **SURFACE)
    sim.step(400)
    before = sim.position[1:, 1].copy()
    sim.remove(floor)
    sim.step(120)
    fallen = sim.position[1:, 1] - before
    assert fallen == pytest.approx(
        np.full(2, -G / 2 * 2.0**2), abs=4e-4
    )  # g h H / 2 of the first step, in which contacts still press
