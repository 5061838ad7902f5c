"""Jointed bodies touch, rest and sleep; joints come and go between steps (R13)."""

import pickle
import random
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.scene import Distance, Groove, Revolute, Scene
from tamias2d.simulator import Simulator
from tests.engine.scenes import plain
from tests.simulator.mechanisms import G, chain, energy, free_rods, links_on_the_ground
from tools.measurements.mechanisms.scenes import ragdoll_heap


def test_jointed_bodies_rest_on_the_ground_and_sleep_as_one() -> None:
    sim = plain(links_on_the_ground(), sleeping=True)
    sim.step(60)
    assert sim.asleep[1:].all()
    assert sim.reactions.separation.max() < 1e-6
    sim.apply_impulse(4, (0.0, 2.0))
    sim.step()
    assert not sim.asleep[1:].any()


@pytest.mark.parametrize("count", [1, 3])
def test_heap_of_ragdolls_gains_no_energy_and_holds(count: int) -> None:
    """In the air what turns may gain what it has lost, by the square of its turn in a substep.

    On the ground overlaps give back what bodies at rest would gain by falling in all substeps, and
    the weight times a fifth of the deepest in each of them, as that is pushed apart.
    """
    scene = ragdoll_heap(count, seed=2)
    sim, size = Simulator(scene), 0.0
    mass = np.array([body.mass if body.dynamic else 0.0 for body in scene.bodies])
    fallen = 4 * 0.5 * mass.sum() * (9.81 / 240) ** 2
    for _ in range(480):  # the last of them topples at 7 s
        before = energy(sim, scene)
        size = max(size, before)
        turned = np.abs(sim.angular_velocity).max() / 240
        goes = float(mass @ (sim.velocity**2).sum(axis=1))
        sim.step()
        deepest = max(0.0, -sim.contacts.separation.min(initial=0.0))
        lift = fallen + 9.81 * mass.sum() * (1.0 - 0.8**4) * deepest
        slight = turned**2 * goes + lift + 1e-13 * size  # rounding of the sums
        assert energy(sim, scene) <= before + slight
        assert sim.reactions.separation.max() < 1e-3  # as R13 has it; small turns leave 2e-4
    assert np.abs(sim.velocity).max() < 2.0


def test_chain_that_hangs_still_falls_asleep_and_wakes_when_it_is_cut() -> None:
    sim = plain(chain(3), sleeping=True)
    sim.step(60)
    assert sim.asleep.all()
    sim.remove_joint(sim.joints[1])
    sim.step(3)
    assert not sim.asleep.any()
    assert sim.velocity[1, 1] < -0.1


@pytest.mark.parametrize("collide", [False, True])
def test_jointed_bodies_touch_only_if_they_may(collide: bool) -> None:
    scene = Scene(gravity=(0.0, 0.0))
    for x in (0.0, 0.4):
        scene.add_body(t2.Disc(radius=0.25), mass=1.0, position=(x, 0.0), restitution=0.0)
    scene.add_joint(Groove(axis=(1.0, 0.0)), 0, 1, collide=collide)
    sim = plain(scene)
    sim.step(20)
    apart = float(sim.position[1, 0] - sim.position[0, 0])
    assert (apart > 0.45) == collide


# -- coming and going


def test_joints_are_added_and_removed_between_steps() -> None:
    scene = Scene(gravity=(0.0, -G))
    for k in range(2):
        scene.add_body(t2.Disc(radius=0.2), mass=1.0, position=(float(k), 0.0), restitution=0.0)
    sim = plain(scene)
    sim.step(3)
    name = sim.add_joint(Revolute(), 0, tuple(sim.position[0].tolist()))
    hung = sim.add_joint(Distance(), 0, 1, name="rod")
    sim.step(10)
    assert sim.joints == (name, hung)
    assert np.hypot(*(sim.position[1] - sim.position[0])) == pytest.approx(1.0, abs=1e-6)
    sim.remove(0)
    sim.step()
    assert sim.joints == ()
    sim.step(5)
    assert sim.velocity[1, 1] < 0


def test_saved_joints_continue_with_the_same_bits(tmp_path: Any) -> None:
    sim = plain(links_on_the_ground(), sleeping=True)
    sim.apply_impulse(2, (0.3, 2.0))
    sim.step(7)
    sim.save(tmp_path / "joints.npz")
    for other in (
        Simulator.restore(tmp_path / "joints.npz", compiled=False),
        pickle.loads(pickle.dumps(sim)),
    ):
        assert other.reactions.force == pytest.approx(sim.reactions.force, abs=0)
    twin = Simulator.restore(tmp_path / "joints.npz", compiled=False)
    sim.step(20)
    twin.step(20)
    assert sim.digest() == twin.digest()


def test_order_of_building_does_not_matter() -> None:
    digests = set()
    for order in (range(4), reversed(range(4))):
        scene = Scene(gravity=(0.0, -G))
        place = {}
        for k in order:
            place[k] = scene.add_body(
                t2.Disc(radius=0.2 + 0.01 * k),
                mass=1.0 + k,
                position=(float(k), 0.0),
                restitution=0.0,
            )
        for k in sorted(range(3), reverse=place[0] != 0):
            scene.add_joint(
                Revolute(), place[k], place[k + 1], anchor=(0.5, 0.0), other_anchor=(-0.5, 0.0)
            )
        scene.add_joint(Revolute(), (-0.5, 0.0), place[0], other_anchor=(-0.5, 0.0))
        sim = plain(scene)
        sim.step(10)
        digests.add(sim.digest())
    assert len(digests) == 1


def test_compiled_and_plain_steps_have_the_same_bits() -> None:
    for scene in (links_on_the_ground(), free_rods(random.Random(3), 4), chain(5, last=672.0)):
        sims = [Simulator(scene, compiled=compiled) for compiled in (True, False)]
        for sim in sims:
            sim.velocity[-1, 0] += 0.1
            sim.step(8)
        assert sims[0].digest() == sims[1].digest()
        assert (sims[0].reactions.force == sims[1].reactions.force).all()
