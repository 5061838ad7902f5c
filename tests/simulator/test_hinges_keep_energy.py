"""Mechanisms of hinges that nothing touches keep their energy over 1e5 steps (IM15, DD79).

It is the sum of motion and height of all bodies, above that with which the mechanism hangs still.
What a step is wrong by goes to and fro: by the square of the angle of a substep, up to 0.3 per cent
where a light link whirls.
"""

import math
import random
from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tests.engine.scenes import ground
from tests.simulator.mechanisms import G, energy, free_rods

STEPS = 100_000
ROUNDING = 1e-11  # of heights of some metres, where 0.025 J are at play


def rods(leans: Sequence[float], masses: Sequence[float] | None = None) -> t2.Scene:
    """Thin rods of 1 m, each hinged to the one above and turned by an angle from hanging, rad."""
    scene, end = t2.Scene(gravity=(0.0, -G)), np.zeros(2)
    for k, lean in enumerate(leans):
        out = np.array([math.sin(lean), -math.cos(lean)])
        mass = masses[k] if masses else 1.0
        placed: dict[str, Any] = {"orientation": lean - math.pi / 2, "inertia": mass / 12}
        scene.add_body(None, mass=mass, position=tuple((end + 0.5 * out).tolist()), **placed)
        anchors = {"anchor": (0.5 * (k > 0), 0.0), "other_anchor": (-0.5, 0.0)}
        scene.add_joint(t2.Revolute(), k - 1 if k else (0.0, 0.0), k, **anchors)
        end += out
    return scene


def hanging(scene: t2.Scene) -> float:
    """Return the energy of rods that hang still, J."""
    return -G * sum(body.mass * (k + 0.5) for k, body in enumerate(scene.bodies))


def four_bars(lean: float) -> t2.Scene:
    """Two rods of 1 m that hang from points 1 m apart, with a third one across their ends."""
    scene, out = t2.Scene(gravity=(0.0, -G)), np.array([math.sin(lean), -math.cos(lean)])
    at = [0.5 * out, out + np.array([0.5, 0.0]), 0.5 * out + np.array([1.0, 0.0])]
    for place, turn in zip(at, (lean - math.pi / 2, 0.0, lean - math.pi / 2), strict=True):
        scene.add_body(
            None, mass=1.0, inertia=1 / 12, position=tuple(place.tolist()), orientation=turn
        )
    scene.add_joint(t2.Revolute(), (0.0, 0.0), 0, other_anchor=(-0.5, 0.0))
    scene.add_joint(t2.Revolute(), 0, 1, anchor=(0.5, 0.0), other_anchor=(-0.5, 0.0))
    scene.add_joint(t2.Revolute(), 1, 2, anchor=(0.5, 0.0), other_anchor=(0.5, 0.0))
    scene.add_joint(t2.Revolute(), (1.0, 0.0), 2, other_anchor=(-0.5, 0.0))
    return scene


def shares(scene: t2.Scene, lowest: float, time_step: float = 1 / 60) -> np.ndarray[Any, Any]:
    """Return the energy above the lowest over 1e5 steps, as a share of what there was."""
    sim, found = t2.Simulator(scene, time_step=time_step), []
    start = energy(sim, scene) - lowest
    for _ in range(STEPS // 50):
        sim.step(50)
        found.append((energy(sim, scene) - lowest) / start)
    return np.array(found)


@pytest.mark.parametrize("time_step", [1 / 60, 1 / 120])
@pytest.mark.parametrize("lean", [0.1, 1.0, 2.5])
def test_a_pendulum_keeps_its_energy(lean: float, time_step: float) -> None:
    scene = rods([lean])
    found = shares(scene, hanging(scene), time_step)
    assert found.max() < 1.0 + ROUNDING
    assert found.min() > 1.0 - 2e-4


@pytest.mark.parametrize(
    ("leans", "masses"),
    [
        ([0.3, 0.3], None),
        ([1.5, 2.0], None),
        ([2.5, 2.9], None),
        ([1.4, 1.4, 1.4], None),
        ([0.3] * 10, None),
        ([1.2, 1.2], [1.0, 100.0]),
        ([1.2, 1.2], [100.0, 1.0]),
    ],
)
def test_chains_keep_their_energy(leans: list[float], masses: list[float] | None) -> None:
    scene = rods(leans, masses)
    found = shares(scene, hanging(scene))
    assert found.max() < 1.0 + ROUNDING
    assert found.min() > 0.99
    assert found[-100:].mean() > 0.999


def test_a_loop_of_hinges_keeps_its_energy() -> None:
    found = shares(four_bars(1.0), -2.0 * G)
    assert found.max() < 1.0 + ROUNDING
    assert found.min() > 0.999


@pytest.mark.parametrize("seed", range(4))
def test_rods_that_nothing_holds_keep_their_energy(seed: int) -> None:
    rng = random.Random(500 + seed)
    found = shares(free_rods(rng, rng.randint(2, 6)), 0.0)
    assert found.max() < 1.0 + ROUNDING
    assert found.min() > 0.999


def test_a_pendulum_keeps_its_energy_beside_boxes_that_rest() -> None:
    """The bound on what contacts make looks at all bodies: it takes nothing of the pendulum."""
    scene = rods([1.0, 0.5])
    hung = hanging(scene)
    ground(scene, 0.5)
    for k in range(2):
        box = {"mass": 5.0, "position": (9.0, 0.5 + k), "friction": 0.5, "restitution": 0.0}
        scene.add_body(t2.Box(width=1.0, height=1.0), **box)
    sim, found = t2.Simulator(scene, sleeping=False), []
    swing = slice(0, 2)
    for _ in range(STEPS // 50):
        speeds = (sim.velocity[swing] ** 2).sum() + (sim.angular_velocity[swing] ** 2).sum() / 12
        found.append(0.5 * speeds + G * sim.position[swing, 1].sum() - hung)
        sim.step(50)
    assert np.array(found) == pytest.approx(found[0], rel=0.005)
    assert max(found) < found[0] * (1.0 + ROUNDING)


@pytest.mark.parametrize("seed", range(12))
def test_random_trees_of_hinges_never_have_more_energy_than_they_began_with(seed: int) -> None:
    rng = random.Random(900 + seed)
    scene, ends, half = t2.Scene(gravity=(0.0, -G)), [np.zeros(2)], [0.0]
    for k in range(rng.randint(2, 8)):
        above, lean = rng.randrange(1, k + 1) if k else 0, rng.uniform(-math.pi, math.pi)
        length, mass = rng.uniform(0.4, 1.5), 10 ** rng.uniform(-1, 1)
        out = length * np.array([math.sin(lean), -math.cos(lean)])
        placed: dict[str, Any] = {"orientation": lean - math.pi / 2}
        placed["position"] = tuple((ends[above] + 0.5 * out).tolist())
        scene.add_body(None, mass=mass, inertia=mass * length**2 / 12, **placed)
        held = above - 1 if above else (0.0, 0.0)
        anchors = {"anchor": (half[above], 0.0), "other_anchor": (-0.5 * length, 0.0)}
        scene.add_joint(t2.Revolute(), held, k, **anchors)
        ends.append(ends[above] + out)
        half.append(0.5 * length)
    lowest = -G * sum(body.mass for body in scene.bodies) * float(sum(half) * 2.0)
    found = shares(scene, lowest)
    assert found.max() < 1.0 + ROUNDING


def test_what_joints_take_of_a_kick_does_not_come_back() -> None:
    """A body is kicked as it may not move: its joints take what does not fit them for good."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    for k in range(4):
        scene.add_body(None, mass=1.0, inertia=1 / 12, position=(float(k), 0.0))
        if k:
            ends = {"anchor": (0.5, 0.0), "other_anchor": (-0.5, 0.0)}
            scene.add_joint(t2.Revolute(), k - 1, k, **ends)
    sim = t2.Simulator(scene)
    for k in range(4):
        sim.apply_impulse(k, (6.0 * (-1.0) ** k, 2.0 * k * k))
    kicked = energy(sim, scene)
    sim.step()
    fits = energy(sim, scene)
    assert fits < 0.8 * kicked
    for _ in range(1000):
        sim.step(20)
        assert energy(sim, scene) < fits * (1.0 + 1e-3)  # what goes to and fro, as above


def test_a_restored_pendulum_goes_on_with_the_same_bits(tmp_path: Any) -> None:
    sim = t2.Simulator(rods([2.5, 0.3]))
    sim.step(333)
    sim.save(tmp_path / "pendulum.npz")
    twin = t2.Simulator.restore(tmp_path / "pendulum.npz")
    sim.step(2000)
    twin.step(2000)
    assert sim.digest() == twin.digest()
