"""A pile comes to rest, however wide it is: its contacts feed none of its waves (DD76)."""

import math

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.generated import soft_contact

RADIUS = 0.25


def lattice(columns: int, rows: int) -> t2.Simulator:
    """Discs that touch each other, between walls."""
    width = (columns + 0.5) * 2 * RADIUS
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)))
    surface = {"friction": 0.6, "restitution": 0.0}
    sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    for side in (-1.0, 1.0):
        sim.add_static(t2.HalfPlane(normal=(-side, 0.0), offset=-width / 2), **surface)
    k, row = np.arange(columns * rows) % columns, np.arange(columns * rows) // columns
    x = -width / 2 + RADIUS + 2 * RADIUS * k + RADIUS * (row % 2)
    y = RADIUS + math.sqrt(3) * RADIUS * row
    sim.add(t2.Disc(radius=RADIUS), mass=1.0, position=np.column_stack((x, y)), **surface)
    return sim


def test_a_wide_pile_comes_to_rest() -> None:
    """It rings at 0.1 m/s for ever where contacts are much firmer at rest than in motion."""
    sim = lattice(200, 50)
    sim.step(12 * 60)
    assert math.sqrt((sim.velocity**2).sum(axis=1).mean()) < 1e-3


@pytest.mark.parametrize("time_step", [1 / 240, 0.3])
def test_at_the_even_frequency_the_spring_gives_what_a_hard_contact_does(time_step: float) -> None:
    """DD76, by other equations: DD28 inverted, and the impulse that stops the row."""
    frequency = soft_contact.angular_frequency_even(time_step)
    impulse, mass = 2.0, 3.0
    overlap = -soft_contact.separation_rest(impulse, mass, frequency, time_step)
    assert impulse == pytest.approx(mass * overlap / time_step, rel=1e-14)
