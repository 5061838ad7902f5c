"""Limits and motors of mechanisms with many of them: none comes apart, and none gets energy (IM15).

Rows are chosen by their slopes before bodies are placed: what is tried in vain led them to places
from which nothing came back, and chains of thirty links flew apart by metres.
"""

import math

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.scene import Limits, Motor, Revolute, Scene, catalogue
from tamias2d.simulator import Simulator
from tests.engine.scenes import plain
from tests.simulator.mechanisms import G, energy
from tools.measurements.mechanisms.limited_mechanism import limited_mechanism

APART = 1e-3  # of the reach of a joint: what is told


def limited_chain(
    count: int, width: float, motor: Motor | None = None, bounce: float = 0.0
) -> Scene:
    """Links of 1 m and 1 kg that lie level, held at one end: light in turning, far about hinges."""
    scene = Scene(gravity=(0.0, -G))
    limits = Limits(lower=-width, upper=width, restitution=bounce)
    for k in range(count):
        scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=(k + 0.5, 0.0), restitution=0.0)
        joint = Revolute(limits=limits, motor=motor if k % 2 else None)
        if k:
            scene.add_joint(joint, k - 1, k, anchor=(0.5, 0.0), other_anchor=(-0.5, 0.0))
        else:
            scene.add_joint(joint, (0.0, 0.0), k, other_anchor=(-0.5, 0.0))
    return scene


@pytest.mark.parametrize(
    ("count", "width", "rate", "seconds"),
    [(30, 1.5, 60, 17), (60, 0.2, 60, 8), (60, 0.5, 60, 11), (60, 0.5, 240, 5), (60, 1.5, 60, 6)],
)
def test_long_chain_with_limits_stays_together(
    count: int, width: float, rate: int, seconds: int
) -> None:
    """Before, these were 0.01 to 50 m apart, but for the one at 240 Hz, which was later."""
    scene = limited_chain(count, width)
    sim = Simulator(scene, time_step=1 / rate)
    start = energy(sim, scene)
    for _ in range(seconds * rate):
        sim.step()
        assert sim.reactions.separation.max() < APART
        assert energy(sim, scene) <= start + 1e-9 * G * count
    angles = np.diff(sim.orientation, prepend=0.0)
    assert np.abs(angles).max() < width + 0.01
    assert not sim.warnings


@pytest.mark.parametrize("bounce", [0.0, 0.5, 1.0])
def test_motors_give_no_more_than_their_torque_at_their_speed(bounce: float) -> None:
    """Limits that bounce pumped up what motors held, without an end."""
    speed, most, count = 3.0, 30.0, 24
    scene = limited_chain(count, 0.4, Motor(speed=speed, maximum=most), bounce)
    sim = Simulator(scene, time_step=1 / 60)
    start = energy(sim, scene)
    for k in range(1, 601):
        sim.step()
        assert sim.reactions.separation.max() < APART
        assert energy(sim, scene) <= start + k * sim.time_step * speed * most * count / 2
    assert np.abs(sim.angular_velocity).max() < 100.0


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
@pytest.mark.parametrize("motors", [False, True])
@pytest.mark.parametrize("seed", [*range(12), 23, 26, 32, 43])
def test_random_mechanism_with_limits_stays_together(seed: int, motors: bool) -> None:
    """Of all kinds of joints, with loops; some that are told yield, by some hundredths of a m."""
    scene = limited_mechanism(seed, motors=motors)
    sim = Simulator(scene, time_step=1 / 60)
    start = energy(sim, scene)
    for _ in range(180):
        sim.step()
        assert sim.reactions.separation.max() < (0.1 if sim.warnings else 2 * APART)
        if not motors:
            assert energy(sim, scene) <= start + 1e-9 * abs(start) + 1e-9
    assert math.isfinite(energy(sim, scene))


def test_choice_has_the_same_bits_without_compilation() -> None:
    """The first of steps that choose one by one is among these."""
    scene = limited_chain(20, 0.1, Motor(speed=5.0, maximum=50.0), 1.0)
    sims = [Simulator(scene, time_step=1 / 30), plain(scene, time_step=1 / 30)]
    for sim in sims:
        sim.step(3)
    for name in ("position", "orientation", "velocity", "angular_velocity"):
        one, other = (getattr(sim, name).tobytes() for sim in sims)
        assert one == other


def test_walker_walks_as_far_with_long_steps() -> None:
    """Its motor turns 30 times its mass; it went 0.067 m in 4 s at 1/30 s, and 0.0744 m else."""
    way = []
    for rate in (30, 240):
        sim = Simulator(catalogue.load("walker"), time_step=1 / rate)
        sim.step(4 * rate)
        way.append(sim.position[0, 0])
    assert way[0] == pytest.approx(way[1], rel=5e-3)
