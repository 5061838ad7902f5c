"""Mechanisms that bounce leave as located impacts say, and keep their energy (DD96)."""

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.state import Array


def thrown_rods(seed: int, number: int, restitution: float) -> t2.Scene:
    """Rods of 0.9 m in a straight row on hinges, thrown at the ground as if they were one."""
    chance = np.random.default_rng(seed)
    surface = {"restitution": restitution, "friction": 0.0}
    scene = t2.Scene(gravity=(0.0, 0.0))
    leaning, sideways, spin = chance.uniform([0.2, -0.5, -0.5], [1.2, 0.5, 0.5])
    along = np.array([np.cos(leaning), np.sin(leaning)])
    for k in range(number):
        scene.add_body(
            t2.Box(width=0.9, height=0.1),
            mass=1.0 + k,
            position=tuple((0.0, 2.0) + k * along),
            orientation=leaning,
            velocity=(sideways - spin * k * along[1], -2.0 + spin * k * along[0]),
            angular_velocity=spin,
            **surface,
        )
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    for k in range(number - 1):
        scene.add_joint(t2.Revolute(), k, k + 1, at=tuple((0.0, 2.0) + (k + 0.5) * along))
    return scene


def error_after_impact(scene: t2.Scene, number: int, frames: int) -> float:
    """How far velocities are off, m/s, at the end of the frame in which the first impact is."""
    run = t2.simulate(scene, duration=2.0)
    frame = int(np.ceil(run.impacts.time[0] * 60.0))
    sim = t2.Simulator(scene, time_step=1.0 / (60.0 * frames))
    sim.step(frame * frames)
    return float(np.abs(sim.velocity[:number] - run.velocity[frame, :number]).max())


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("restitution", [0.5, 1.0])
def test_an_impact_on_a_mechanism_is_the_located_one_in_the_limit_of_short_steps(
    restitution: float, seed: int
) -> None:
    """It comes up to a step late, in which velocities of 2 m/s turn by up to their rates."""
    scene = thrown_rods(seed, 2, restitution)
    errors = [error_after_impact(scene, 2, frames) for frames in (1, 4, 16)]
    assert errors[0] < 0.15
    assert errors[2] < 0.15 / 8.0


def rods_in_a_box(seed: int, number: int) -> tuple[t2.Simulator, Array]:
    """Hinged rods of 1 kg between walls without friction that lose nothing, and their inertia."""
    chance = np.random.default_rng(seed)
    surface = {"restitution": 1.0, "friction": 0.0}
    scene = t2.Scene(gravity=(0.0, 0.0))
    rod = t2.Box(width=0.9, height=0.1)
    (x, y), spin = chance.uniform(-2.0, 2.0, 2), chance.uniform(-3.0, 3.0)
    for k in range(number):
        moving = {"velocity": (x, y + spin * k), "angular_velocity": spin}
        scene.add_body(rod, mass=1.0, position=(float(k), 0.0), **moving, **surface)
    for across, up in ((1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)):
        scene.add_static(t2.HalfPlane(normal=(across, up), offset=-3.0), **surface)
    for k in range(number - 1):
        scene.add_joint(t2.Revolute(), k, k + 1, at=(k + 0.5, 0.0))
    return t2.Simulator(scene, time_step=1 / 240), rod.inertia(1.0)


@pytest.mark.parametrize(("number", "least"), [(2, 0.8), (4, 0.5)])
@pytest.mark.parametrize("seed", range(3))
def test_rods_that_lose_nothing_by_an_impact_bounce_on(
    seed: int, number: int, least: float
) -> None:
    """For 20 s; joints that held only in the next step left a tenth, and of four a hundredth."""
    sim, inertia = rods_in_a_box(seed, number)
    first = 0.0
    for _ in range(4800):
        moving, turning = sim.velocity[:number], sim.angular_velocity[:number]
        energy = 0.5 * float((moving**2).sum() + inertia * (turning**2).sum())
        first = first or energy
        assert energy <= first * (1.0 + 1e-9)
        sim.step()
    assert energy > least * first
