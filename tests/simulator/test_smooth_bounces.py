"""What bounces on smooth ground: nothing takes its way along it, or its height (DD88, DD102)."""

from typing import Any

import numpy as np
import pytest

import tamias2d as t2

GRAVITY = 10.0
SMOOTH: Any = {"friction": 0.0, "restitution": 1.0}


def ground() -> t2.Scene:
    scene = t2.Scene(gravity=(0.0, -GRAVITY))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SMOOTH)
    return scene


def thrown_pair(joint: Any, ratio: float, seed: int) -> t2.Scene:
    """Two boxes at any angle, whose masses have a ratio, tied where they are nearest."""
    chance = np.random.default_rng(seed)
    scene, away = ground(), chance.uniform(0.0, 2.0 * np.pi)
    half = 0.35 * np.array([np.cos(away), np.sin(away)])
    for side, mass in ((-1.0, 1.0), (1.0, ratio)):
        scene.add_body(
            t2.Box(width=chance.uniform(0.3, 0.6), height=chance.uniform(0.2, 0.4)),
            mass=mass,
            position=tuple((0.0, 1.8) + side * half),
            orientation=chance.uniform(-3.0, 3.0),
            velocity=(3.0, -1.0),
            **SMOOTH,
        )
    scene.add_joint(joint, 1, 2, at=(0.0, 1.8))
    return scene


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
@pytest.mark.parametrize(
    ("joint", "ratio"),
    [(t2.Revolute(), 1.0), (t2.Revolute(), 10.0), (t2.Weld(), 30.0), (t2.Weld(), 100.0)],
    ids=["revolute 1", "revolute 10", "weld 30", "weld 100"],
)
def test_a_pair_keeps_its_momentum_along_smooth_ground(joint: Any, ratio: float) -> None:
    """No contact gives or takes any, whatever the bound on energy takes."""
    for seed in range(6):
        sim = t2.Simulator(thrown_pair(joint, ratio, seed))
        mass = np.array([0.0, 1.0, ratio])
        for _ in range(240):
            sim.step()
            assert mass @ sim.velocity[:, 0] == pytest.approx(3.0 * (1.0 + ratio), rel=1e-3)


@pytest.mark.parametrize("shape", [t2.Disc(radius=0.3), t2.Box(width=0.6, height=0.6)])
@pytest.mark.parametrize(
    "joint", [t2.Rotary(motor=t2.Motor(speed=0.0)), t2.Prismatic(axis=(0.0, 1.0))]
)
def test_what_a_joint_guides_bounces_to_its_height(shape: Any, joint: Any) -> None:
    """From twelve heights, for 20 s; without what gravity gives in a gap a tenth was lost."""
    left = []
    for height in np.linspace(0.4, 2.8, 12):
        scene = ground()
        body = scene.add_body(shape, mass=1.0, position=(0.0, 0.3 + height), **SMOOTH)
        scene.add_joint(joint, (0.0, 0.0), body)
        sim = t2.Simulator(scene)
        sim.step(1200)
        speed, rise = np.hypot(*sim.velocity[body]), sim.position[body, 1] - 0.3
        left.append((speed**2 / 2 + GRAVITY * rise) / (GRAVITY * height))
    assert np.median(left) > 0.99
    assert min(left) > 0.85
    assert max(left) < 1.0 + 1e-9


@pytest.mark.parametrize("drag", [0.4, 4.0])
def test_drag_takes_neither_spin_nor_way_in_a_bounce(drag: float) -> None:
    """A surplus of the bounce is dissipated along the impulse; the disc has no other impulse."""
    scene = ground()
    disc = scene.add_body(
        t2.Disc(radius=0.3),
        mass=1.0,
        position=(0.0, 1.5),
        velocity=(3.0, -2.0),
        angular_velocity=2.0,
        linear_drag=drag,
        **SMOOTH,
    )
    sim = t2.Simulator(scene)
    sim.step(300)
    assert sim.angular_velocity[disc] == pytest.approx(2.0, rel=1e-12)
    assert sim.velocity[disc, 0] == pytest.approx(3.0 * np.exp(-5.0 * drag), rel=1e-9)
