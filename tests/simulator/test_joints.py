"""Joints in the frame loop hold, keep what theory keeps, and tell what they bear (R13, IM15)."""

import math
import random
from typing import Any

import numpy as np
import pytest

from tamias2d.engine.menu import CONTACT
from tamias2d.errors import InputError
from tamias2d.motion import Stepped
from tamias2d.scene import (
    Distance,
    Equation,
    Gear,
    Groove,
    Limits,
    Prismatic,
    Pulley,
    Ratchet,
    Revolute,
    Scene,
    Weld,
)
from tamias2d.simulate import simulate
from tests.engine.scenes import plain
from tests.simulator.mechanisms import G, chain, free_rods, links_on_the_ground, momenta, pendulum


def test_pendulum_converges_to_the_exact_way_with_order_two() -> None:
    exact = simulate(pendulum(), duration=1.0, times=[1.0]).position[-1, 0]
    errors = []
    for steps in (30, 60, 120):
        sim = plain(pendulum(), time_step=1 / steps)
        sim.step(steps)
        errors.append(float(np.hypot(*(sim.position[0] - exact))))
    assert errors[0] / errors[1] == pytest.approx(4, abs=0.5)
    assert errors[1] / errors[2] == pytest.approx(4, abs=0.5)


def test_a_body_at_the_origin_is_held_where_it_is() -> None:
    """It was taken for one that has been placed already, with an angle without a cosine."""
    scene = Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, inertia=1.0, position=(0.0, 0.0))
    scene.add_joint(Revolute(), (1.0, 0.0), 0, other_anchor=(1.0, 0.0))
    sim = plain(scene)
    sim.step()
    assert sim.position[0] == pytest.approx((0.0, 0.0), abs=1e-15)


def test_stepped_runs_take_joints() -> None:
    run = simulate(pendulum(), duration=0.5, method=Stepped(), time_step=1 / 60)
    exact = simulate(pendulum(), duration=0.5, times=[0.5])
    assert run.position[-1, 0] == pytest.approx(exact.position[-1, 0], abs=1e-3)


def test_free_mechanisms_keep_momentum_and_angular_momentum() -> None:
    scene = free_rods(random.Random(1), 5)
    sim = plain(scene)
    before, turning = momenta(sim, scene)
    sim.step(60)
    after, turning_after = momenta(sim, scene)
    assert after == pytest.approx(before, abs=1e-12 * np.abs(before).max())  # rounding of sums
    assert turning_after == pytest.approx(turning, rel=1e-12)  # rounding of sums
    assert sim.reactions.separation.max() < 1e-5  # the rest of a substep, by IM15, on arms of 1 m


@pytest.mark.parametrize("seed", range(6))
def test_energy_never_rises_by_itself(seed: int) -> None:
    rng = random.Random(seed)
    scene = free_rods(rng, rng.randint(2, 5))
    sim = plain(scene)
    sim.gravity = (rng.gauss(0, 5), rng.gauss(0, 5))
    mass = np.array([body.mass for body in scene.bodies])
    inertia = np.array([body.inertia for body in scene.bodies])

    def total() -> float:
        moving = 0.5 * (mass @ (sim.velocity**2).sum(axis=1) + inertia @ sim.angular_velocity**2)
        return float(moving - mass @ (sim.position @ sim.gravity))

    start = total()
    for _ in range(60):
        sim.step()
        assert total() <= start + 1e-11 * (abs(start) + 1)  # rounding of the sums


def test_four_welds_around_a_disc_stay_at_rest() -> None:
    """Box2D's issue 997: they spin up by themselves there."""
    scene = Scene(gravity=(0.0, -G))
    scene.add_body(None, mass=1.0, inertia=0.1, position=(0.0, 0.0))
    scene.add_joint(Revolute(), (0.0, 0.0), 0)
    for k in range(4):
        turn = k * math.pi / 2
        x, y = math.cos(turn), math.sin(turn)
        scene.add_body(None, mass=1.0, inertia=0.1, position=(x, y), orientation=turn)
        scene.add_joint(Weld(), 0, k + 1, anchor=(x / 2, y / 2), other_anchor=(-0.5, 0.0))
    sim = plain(scene)
    sim.step(60)
    assert np.abs(sim.velocity).max() < 1e-9
    assert np.abs(sim.orientation[0]) < 1e-9


def test_heavy_ball_does_not_stretch_its_chain() -> None:
    scene = chain(12, last=672.0)
    sim = plain(scene)
    sim.velocity[:] = np.column_stack((-2.0 * sim.position[:, 1], 0 * sim.position[:, 1]))
    sim.angular_velocity[:] = 2.0  # all of it swings as one
    furthest = 0.0
    for _ in range(60):
        sim.step()
        end = sim.position[-1]
        furthest = max(furthest, float(np.hypot(*end)))
    assert sim.reactions.separation.max() < 1e-5
    assert furthest < 11.5 * 1.005


# -- what is told


def test_reactions_of_a_hanging_chain_are_the_weights_below() -> None:
    sim = plain(chain(4))
    sim.step(2)
    told = sim.reactions
    weights = G * np.arange(4, 0, -1)
    assert told.force[:, 0, 1] == pytest.approx(-weights, rel=1e-6)  # on the body above
    assert told.force[:, 1, 1] == pytest.approx(weights, rel=1e-6)
    assert told.impulse == pytest.approx(told.force / 60)
    assert told.torque == pytest.approx(0.0, abs=1e-6)
    assert told.names == sim.joints
    assert told.index(sim.joints[2]) == 2


def test_where_there_are_no_joints_there_are_no_reactions() -> None:
    """They were asked of an engine that knows of no joints, after the last was removed, too."""
    scene = Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(0.0, 0.0))
    sim = plain(scene)
    assert sim.reactions.force.shape == (0, 3, 2)
    name = sim.add_joint(Revolute(), (0.0, 0.0), 0)
    sim.step()
    assert sim.reactions.names == (name,)
    sim.remove_joint(name)
    sim.step()
    assert sim.reactions.names == ()


def test_weld_of_a_cantilever_tells_its_moment() -> None:
    scene = Scene(gravity=(0.0, -G))
    scene.add_body(None, mass=2.0, inertia=1.0, position=(1.5, 0.0))
    scene.add_joint(Weld(), (0.0, 0.0), 0, other_anchor=(-1.5, 0.0))
    sim = plain(scene)
    sim.step(2)
    assert sim.reactions.force[0, 1] == pytest.approx((0.0, 2.0 * G), abs=1e-6)
    assert sim.reactions.torque[0, 1] == pytest.approx(2.0 * G * 1.5, rel=1e-6)


# -- kinds


def test_atwoods_machine_by_a_pulley() -> None:
    scene = Scene(gravity=(0.0, -G))
    scene.add_body(None, mass=3.0, inertia=1.0, position=(-1.0, -3.0))
    scene.add_body(None, mass=1.0, inertia=1.0, position=(1.0, -3.0))
    scene.add_joint(Pulley(posts=[(-1.0, 0.0), (1.0, 0.0)]), 0, 1)
    sim = plain(scene)
    sim.step(30)
    assert sim.velocity[:, 1] == pytest.approx([-G / 4, G / 4], rel=1e-6)  # a = g (3 - 1)/(3 + 1)


def test_each_kind_holds() -> None:
    scene = Scene(gravity=(0.0, -G))
    for k in range(7):
        scene.add_body(None, mass=1.0, inertia=0.2, position=(float(k), 0.1 * k), name=f"b{k}")
    scene.add_joint(Prismatic(axis=(1.0, 1.0)), (0.0, 0.0), "b0")
    scene.add_joint(Revolute(), "b0", "b1", anchor=(0.5, 0.05), other_anchor=(-0.5, -0.05))
    scene.add_joint(Distance(), "b1", "b2", anchor=(0.1, 0.2), other_anchor=(-0.2, 0.1))
    scene.add_joint(Groove(axis=(1.0, 0.3)), "b2", "b3", other_anchor=(-1.0, -0.1))
    scene.add_joint(Weld(), "b3", "b4", anchor=(0.5, 0.05), other_anchor=(-0.5, -0.05))
    scene.add_joint(Revolute(), (5.0, 0.5), "b5")
    scene.add_joint(Revolute(), (6.0, 0.6), "b6")
    scene.add_joint(Gear(ratio=-2.0), "b5", "b6", third="b4")
    sim = plain(scene)
    sim.torque[5] = 1.0
    sim.step(40)
    told = sim.reactions
    assert told.separation.max() < 1e-6
    assert told.angular_separation.max() < 1e-6
    assert np.abs(sim.velocity).max() > 0.5


# -- only what the scene requires


def test_scenes_without_joints_do_without_all_of_it() -> None:
    assert "joint" not in CONTACT.source().lower()
    sim = plain(links_on_the_ground(1))
    joints = sim._engine.world.joints
    assert len(joints.joints) == len(joints.members) == len(joints.sparse) == 0


# -- refusals


def test_a_joint_of_its_own_equation_is_refused_by_name() -> None:
    scene = Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, inertia=1.0, position=(1.0, 0.0))
    scene.add_joint(Equation("norm(position_a) - 1[m]"), 0, name="own")
    with pytest.raises(InputError, match=r"'own' \(equation\): steps know no equation.*\(R13\)"):
        plain(scene)
    free = Scene(gravity=(0.0, 0.0))
    free.add_body(None, mass=1.0, inertia=1.0, position=(1.0, 0.0))
    with pytest.raises(InputError, match=r"'joint0' \(equation\): steps know no equation"):
        plain(free).add_joint(Equation("norm(position_a) - 1[m]"), 0)


@pytest.mark.parametrize(
    "kind",
    [Revolute(limits=Limits(lower=-1.0, restitution=0.5)), Ratchet(pitch=0.1, restitution=0.5)],
)
def test_limits_that_bounce_are_refused_by_name(kind: Any) -> None:
    scene = Scene(gravity=(0.0, -G))
    scene.add_body(None, mass=1.0, inertia=0.1, position=(1.0, 0.0), name="bob")
    scene.add_joint(kind, (0.0, 0.0), "bob", other_anchor=(-1.0, 0.0), name="held")
    with pytest.raises(InputError, match=r"joint 'held' \(.*\): steps know no restitution of lim"):
        plain(scene)


def test_joints_that_do_not_fit_are_refused() -> None:
    sim = plain(pendulum())
    with pytest.raises(InputError, match="does not hold"):
        sim.add_joint(Revolute(), "bob", (5.0, 5.0))
    with pytest.raises(InputError, match="to itself"):
        sim.add_joint(Revolute(), 0, 0)
    with pytest.raises(InputError, match="none such"):
        sim.add_joint(Revolute(), "nobody", 0)
    with pytest.raises(InputError, match="none such"):
        sim.remove_joint("nothing")
    with pytest.raises(InputError, match="text of its own"):
        sim.add_joint(Revolute(), "bob", (0.0, 0.0), anchor=(-1.0, 0.0), name=sim.joints[0])
