"""Links that are straight between two fixed ends bear what falls on them, and throw nothing (DD98).

Their hinges are singular there. Before solutions that throw a mechanism were taken back, hinges
came apart by up to 4 m, bodies moved by metres in a step that told 0.2 m/s, forces reached
1e152 N, and some steps were refused. While contacts pushed light links by their own inertia and
joints by a far larger one, links of a drawbridge still came apart by up to 2.7 m.
"""

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from tamias2d import Box, Capsule, Revolute, Scene, Simulator

SURFACE: dict[str, Any] = {"friction": 0.5, "restitution": 0.1}
GRAVITY = (0.0, -9.81)
Array = NDArray[np.float64]


def bridge(planks: int, width: float, mass: float) -> Simulator:
    """Return a straight bridge of hinged planks between fixed points; each weighs so much, kg."""
    sim = Simulator(Scene(gravity=GRAVITY))
    ends = np.linspace(-width / 2, width / 2, planks + 1)
    shape = Box(width=0.95 * width / planks, height=0.12)
    for x in (ends[1:] + ends[:-1]) / 2:
        sim.add(shape, mass=mass, position=(float(x), 3.0), **SURFACE)
    for k, x in enumerate(ends):
        left: Any = k - 1 if k else (float(x), 3.0)
        right: Any = k if k < planks else (float(x), 3.0)
        sim.add_joint(Revolute(), left, right, at=(float(x), 3.0))
    return sim


def add_walker(sim: Simulator, x: float, y: float) -> None:
    """Add a torso of 30 kg on two legs of two parts each, which are hinged."""
    own: dict[str, Any] = {"group": -1, **SURFACE}
    torso = sim.add(Box(width=0.4, height=0.8), mass=30.0, position=(x, y), **own)
    for side in (-0.12, 0.12):
        upright = {"orientation": np.pi / 2, **own}
        thigh, shin = (
            sim.add(Capsule(length=0.35, radius=r), mass=m, position=(x + side, y - h), **upright)
            for r, m, h in ((0.09, 8.0, 0.65), (0.08, 5.0, 1.1))
        )
        sim.add_joint(Revolute(), torso, thigh, at=(x + side, y - 0.42))
        sim.add_joint(Revolute(), thigh, shin, at=(x + side, y - 0.88))


def drawbridge(chance: np.random.Generator, links: int) -> Simulator:
    """Return a level board of 50 kg that a straight chain of light links holds, and boxes above."""
    sim = Simulator(Scene(gravity=GRAVITY))
    board = sim.add(Box(width=4.0, height=0.2), mass=50.0, position=(2.0, 2.0), **SURFACE)
    sim.add_joint(Revolute(), (0.0, 2.0), board, at=(0.0, 2.0))
    ends = np.linspace((0.0, 5.0), (3.9, 2.0), links + 1)
    along = ends[1] - ends[0]
    shape = Capsule(length=float(np.hypot(*along)) - 0.1, radius=0.05)
    leaning = float(np.arctan2(along[1], along[0]))
    for k, at in enumerate(ends):
        if k < links:
            middle = tuple((at + along / 2).tolist())
            own: dict[str, Any] = {"orientation": leaning, "group": -9, **SURFACE}
            link = sim.add(shape, mass=0.5, position=middle, **own)
        upper: Any = link - (k < links) if k else (0.0, 5.0)
        sim.add_joint(Revolute(), upper, link if k < links else board, at=tuple(at.tolist()))
    for k in range(6):
        at = (chance.uniform(0.5, 3.5), 4.0 + 0.8 * k)
        sim.add(Box(width=0.5, height=0.5), mass=chance.uniform(5, 40), position=at, **SURFACE)
    return sim


def follow(sim: Simulator, steps: int) -> tuple[float, float]:
    """Step; return how far joints were apart, and what bodies moved beyond their velocities, m."""
    apart = beyond = 0.0
    for _ in range(steps):
        places, before = sim.position.copy(), np.hypot(*sim.velocity.T)
        sim.step()
        way = np.hypot(*(sim.position - places).T)
        told = np.maximum(before, np.hypot(*sim.velocity.T)) * sim.time_step
        beyond = max(beyond, float((way - told).max()))
        apart = max(apart, float(sim.reactions.separation.max()))
    return apart, beyond


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
@pytest.mark.parametrize("planks", [8, 20])
def test_a_walker_falls_on_a_straight_bridge(planks: int) -> None:
    chance = np.random.default_rng(0)
    for _ in range(6):
        sim = bridge(planks, 10.0, 3.0)
        add_walker(sim, chance.uniform(-4.0, 4.0), chance.uniform(4.6, 6.0))
        apart, beyond = follow(sim, 120)
        assert apart < 0.06
        assert beyond < 0.12


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
@pytest.mark.parametrize("planks", [8, 20])
def test_a_box_of_ten_times_a_plank_falls_on_a_straight_bridge(planks: int) -> None:
    for x, fall in zip(np.linspace(-0.4, 0.4, 9), 3 * (0.5, 1.0, 2.0), strict=True):
        sim = bridge(planks, float(planks), 1.0)
        at = (float(x) * planks, 3.35 + fall)
        sim.add(Box(width=0.5, height=0.5), mass=10.0, position=at, **SURFACE)
        apart, beyond = follow(sim, 120)
        assert apart < 0.05
        assert beyond < 0.1


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
@pytest.mark.parametrize("links", [5, 14])
def test_boxes_fall_on_a_drawbridge(links: int) -> None:
    for seed in range(5):
        sim = drawbridge(np.random.default_rng(seed), links)
        apart, beyond = follow(sim, 150)
        assert apart < 0.1
        assert beyond < 0.2
