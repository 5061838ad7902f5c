"""Joints in the frame loop hold, keep what theory keeps, and come and go (R13, IM15)."""

import math
import pickle
import random
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.engine.joints import hinge_net, rows as engine_rows
from tamias2d.engine.joints.solve import REMOVED_BY_JOINTS
from tamias2d.engine.menu import CONTACT
from tamias2d.errors import InputError, StepWarning
from tamias2d.motion import Stepped
from tamias2d.scene import (
    Distance,
    Equation,
    Gear,
    Groove,
    JointSpring,
    Limits,
    Motor,
    Prismatic,
    Pulley,
    Ratchet,
    Revolute,
    Scene,
    Weld,
    Wheel,
    catalogue,
)
from tamias2d.simulate import simulate
from tamias2d.simulator import Simulator
from tests.engine.scenes import ground, plain
from tools.measurements.jointed import Energy, net, ragdoll_heap, random_mechanism

G = 10.0


def pendulum() -> Scene:
    scene = Scene(gravity=(0.0, -G))
    scene.add_body(None, mass=1.0, inertia=0.1, position=(1.0, 0.0), name="bob")
    scene.add_joint(Revolute(), "bob", (0.0, 0.0), anchor=(-1.0, 0.0))
    return scene


def chain(count: int, *, last: float = 1.0) -> Scene:
    """Links of 1 m and 1 kg, hanging straight down from the origin; the last one may be heavy."""
    scene = Scene(gravity=(0.0, -G))
    shape = t2.Capsule(length=0.8, radius=0.1)
    for k in range(count):
        mass = last if k == count - 1 else 1.0
        place = (0.0, -0.5 - k)
        turned = {"inertia": mass / 12, "orientation": -math.pi / 2}
        scene.add_body(shape, mass=mass, position=place, restitution=0.0, **turned)
        upper: Any = (0.0, 0.0) if k == 0 else k - 1
        anchor = (0.0, 0.0) if k == 0 else (0.5, 0.0)
        scene.add_joint(Revolute(), upper, k, anchor=anchor, other_anchor=(-0.5, 0.0))
    return scene


def energy(sim: Simulator, scene: Scene) -> float:
    mass = np.array([body.mass if body.dynamic else 0.0 for body in scene.bodies])
    inertia = np.array([body.inertia if body.dynamic else 0.0 for body in scene.bodies])
    moving = 0.5 * (mass @ (sim.velocity**2).sum(axis=1) + inertia @ sim.angular_velocity**2)
    return float(moving - mass @ (sim.position @ np.array(scene.gravity)))


def free_rods(rng: random.Random, count: int) -> Scene:
    """Rods pinned to each other in a row, spinning at random, with nothing else in the world."""
    scene = Scene(gravity=(0.0, 0.0))
    velocity = np.array([rng.gauss(0, 1), rng.gauss(0, 1)])
    for k in range(count):
        spin = rng.gauss(0, 2)
        velocity[1] += 0.5 * spin
        scene.add_body(
            None,
            mass=rng.uniform(0.5, 5.0),
            inertia=rng.uniform(0.05, 0.5),
            position=(float(k), 0.0),
            velocity=tuple(velocity.tolist()),
            angular_velocity=spin,
        )
        velocity[1] += 0.5 * spin
        if k:
            scene.add_joint(Revolute(), k - 1, k, anchor=(0.5, 0.0), other_anchor=(-0.5, 0.0))
    return scene


def momenta(sim: Simulator, scene: Scene) -> tuple[np.ndarray[Any, Any], float]:
    mass = np.array([body.mass for body in scene.bodies])
    inertia = np.array([body.inertia for body in scene.bodies])
    (x, y), (u, v) = sim.position.T, sim.velocity.T
    return mass @ sim.velocity, float(mass @ (x * v - y * u) + inertia @ sim.angular_velocity)


# -- accuracy


def test_pendulum_converges_to_the_exact_way_with_order_two() -> None:
    exact = simulate(pendulum(), duration=1.0, times=[1.0]).position[-1, 0]
    errors = []
    for steps in (30, 60, 120):
        sim = plain(pendulum(), time_step=1 / steps)
        sim.step(steps)
        errors.append(float(np.hypot(*(sim.position[0] - exact))))
    assert errors[0] / errors[1] == pytest.approx(4, abs=0.5)
    assert errors[1] / errors[2] == pytest.approx(4, abs=0.5)


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

    size = total()
    for _ in range(60):
        before = total()
        sim.step()
        assert total() <= before + 1e-11 * (abs(size) + abs(before) + 1)  # rounding of the sums


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


def test_meshes_hold() -> None:
    """A net of hinges whose factors would fill is solved by iteration."""
    scene = Scene(gravity=(0.0, -G))
    for k in range(16):
        x, y = divmod(k, 4)
        scene.add_body(None, mass=1.0, inertia=0.08, position=(float(x), float(-y)))
        if k in (0, 12):
            scene.add_joint(Revolute(), (float(x), float(-y)), k)
        if y:
            scene.add_joint(Revolute(), k - 1, k, anchor=(0.0, -0.5), other_anchor=(0.0, 0.5))
        if x:
            scene.add_joint(Revolute(), k - 4, k, anchor=(0.5, 0.0), other_anchor=(-0.5, 0.0))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(engine_rows, "LOOPED", 0)
        patch.setattr(engine_rows, "FEW", 0)
        sim = plain(scene)
        sim.step(20)
    assert sim.reactions.separation.max() < 1e-3


@pytest.mark.parametrize("seed", [7, 12, 46])
def test_mechanisms_that_whirl_hold(seed: int) -> None:
    """Grooves whip light bodies by a tenth of a radian in a substep: rows turn meanwhile.

    With the rows of a substep's begin alone they come apart by 1 to 12 cm.
    """
    sim = Simulator(random_mechanism(seed), time_step=1 / 60, compiled=False)
    most = 0.0
    for _ in range(100):
        sim.step()
        most = max(most, float(sim.reactions.separation.max()))
    assert most < 1e-5


def test_net_of_hinges_moves_as_any_mesh_does(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where it leaves as little, and removes as much."""
    monkeypatch.setattr(hinge_net, "LEFT_OPEN", 1e-4)
    monkeypatch.setattr(hinge_net, "REMOVED_BY_NET", REMOVED_BY_JOINTS)
    found = []
    for own in (True, False):
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(engine_rows, "LOOPED", 0)
            patch.setattr(engine_rows, "FEW", 0)
            if not own:
                patch.setattr(engine_rows, "is_net", lambda _: False)
            sim = plain(net(4))
            sim.step(20)
        found.append(sim.position.copy())
    assert found[0] == pytest.approx(found[1], abs=1e-6)  # iterations leave a hundredth of 1e-5 m


def test_net_at_rest_asks_for_no_iterations(monkeypatch: pytest.MonkeyPatch) -> None:
    """It starts from the impulses of as long a time: half of it as a step begins and ends."""
    asked, own = [], hinge_net.iterate_net
    monkeypatch.setattr(engine_rows, "LOOPED", 0)
    monkeypatch.setattr(engine_rows, "FEW", 0)
    monkeypatch.setattr(hinge_net, "iterate_net", lambda *of: asked.append(own(*of)))
    sim = plain(net(4))
    sim.step(20)
    assert asked
    asked.clear()
    sim.step(5)
    assert not asked


def test_net_that_hangs_gains_no_energy() -> None:
    """Links that are not solved to the end are closed only as far as there is energy for it."""
    scene = net(20)
    sim, seen = Simulator(scene, time_step=1 / 60), Energy(scene)
    for _ in range(120):
        sim.step()
        place = np.column_stack((sim.position, sim.orientation))
        seen.look(place, np.column_stack((sim.velocity, sim.angular_velocity)))
    assert seen.gain < 1e-7  # heights of 1e2 m times 2e3 N are known to 1e-11 J, of 1e-4 J at least
    assert sim.reactions.separation.max() < 5e-4  # a thousandth of the arms


LAWS: dict[str, dict[str, Any]] = {
    "none": {},
    "spring": {"spring": JointSpring(stiffness=20.0, damping=1.0)},
    "motor": {"motor": Motor(speed=2.0, maximum=30.0)},
    "limits": {"limits": Limits(lower=-1.1, upper=1.2, restitution=0.0)},
}


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("tied", ["at one end", "at both ends", "nowhere"])
def test_trees_of_hinges_move_as_any_mechanism_does(law: str, tied: str) -> None:
    """The factors of a matrix are the oracle: they know nothing of trees."""
    scene = Scene(gravity=(0.0, -G))
    shape = t2.Capsule(length=0.8, radius=0.1)
    for k in range(4):
        turn = (0.5, -0.5)[k % 2]
        at = ((0.5 + k) * math.cos(turn), 0.5 * math.sin(0.5))
        scene.add_body(shape, mass=1.0 + k, position=at, orientation=turn, restitution=0.0)
        if k:
            ends = (k, k - 1) if k == 2 else (k - 1, k)
            anchors = ((-0.5, 0.0), (0.5, 0.0)) if k == 2 else ((0.5, 0.0), (-0.5, 0.0))
            joint = Revolute(**LAWS[law])
            scene.add_joint(joint, *ends, anchor=anchors[0], other_anchor=anchors[1])
    if tied != "nowhere":
        scene.add_joint(Revolute(), (0.0, 0.0), 0, other_anchor=(-0.5, 0.0))
    if tied == "at both ends":
        scene.add_joint(Revolute(), (4 * math.cos(0.5), 0.0), 3, other_anchor=(0.5, 0.0))
    found = []
    for tree in (True, False):
        with pytest.MonkeyPatch.context() as patch:
            if not tree:
                patch.setattr(engine_rows, "hinge_tree", lambda *_: None)
            sim = plain(scene)
            sim.step(20)
        found.append((sim.position.copy(), sim.reactions.force.copy()))
    assert found[0][0] == pytest.approx(found[1][0], abs=1e-4)  # what a substep leaves by IM15
    loads = np.abs(found[1][1]).max()
    assert found[0][1] == pytest.approx(found[1][1], abs=1e-2 * loads + 1e-6)


# -- what governs a freedom


def governed(**law: Any) -> Scene:
    """A bob of 1 kg on an arm of 1 m, level, whose hinge is governed by something."""
    scene = Scene(gravity=(0.0, -G))
    scene.add_body(None, mass=1.0, inertia=0.1, position=(1.0, 0.0), name="bob")
    scene.add_joint(Revolute(**law), (0.0, 0.0), "bob", other_anchor=(-1.0, 0.0))
    return scene


def test_limit_stops_and_bears_the_weight() -> None:
    sim = plain(governed(limits=Limits(lower=-0.5, upper=1.0, restitution=0.0)))
    sim.step(40)
    assert sim.orientation[0] == pytest.approx(-0.5, abs=1e-6)  # passed by less than a substep
    assert sim.angular_velocity[0] == pytest.approx(0.0, abs=1e-9)
    assert sim.reactions.torque[0, 1] == pytest.approx(G * math.cos(0.5), rel=1e-6)


def test_limit_never_pulls() -> None:
    scene = governed(limits=Limits(lower=0.0, restitution=0.0))
    sim = plain(scene)
    sim.step(3)
    sim.angular_velocity[0], sim.velocity[0] = 3.0, (0.0, 3.0)
    sim.step(6)
    free = plain(governed())
    free.angular_velocity[0], free.velocity[0] = 3.0, (0.0, 3.0)
    free.step(6)
    assert sim.orientation[0] == pytest.approx(free.orientation[0], abs=2e-3)  # of order one
    assert sim.reactions.force == pytest.approx(free.reactions.force, rel=2e-2)


def test_motor_keeps_its_speed_or_gives_the_most_that_it_can() -> None:
    sim = plain(governed(motor=Motor(speed=2.0)))
    sim.step(6)
    assert sim.angular_velocity[0] == pytest.approx(2.0, rel=1e-7)  # firm to 1e-8
    sim = plain(governed(motor=Motor(speed=2.0, maximum=4.0)))
    sim.step(1)
    assert sim.angular_velocity[0] * 60 == pytest.approx((4.0 - G) / 1.1, rel=1e-6)
    assert sim.reactions.torque[0, 1] == pytest.approx(4.0, rel=1e-5)  # arms at the end


def test_motor_that_gives_the_most_tears_no_mechanism() -> None:
    """Jansen's legs weigh thirty times their crank, which has to reach its speed with them."""
    sim = plain(catalogue.load("walker"))
    for _ in range(5):
        sim.step()
        assert sim.reactions.separation.max() < 1e-8
        assert abs(sim.reactions.torque[sim.joints.index("motor"), 1]) < 20.0 * (1 + 1e-6)
    assert sim.angular_velocity[0] == pytest.approx(-math.pi, rel=1e-6)


def test_brake_holds_what_it_can() -> None:
    sim = plain(governed(motor=Motor(speed=0.0, maximum=1.2 * G)))
    sim.step(20)
    assert abs(sim.orientation[0]) < 1e-7


def test_spring_of_a_joint_rests_where_its_torque_is_that_of_the_weight() -> None:
    spring = JointSpring(stiffness=100.0, damping=20.0, rest=0.0)
    sim = plain(governed(spring=spring))
    sim.step(180)
    angle = sim.orientation[0]
    assert 100.0 * angle == pytest.approx(-G * math.cos(angle), rel=1e-4)


def test_stiff_spring_gains_no_energy() -> None:
    scene = governed(spring=JointSpring(stiffness=1e6, rest=0.1))
    sim, most = plain(scene), 0.5 * 1e6 * 0.1**2
    for _ in range(30):
        sim.step()
        moving = 0.5 * ((sim.velocity**2).sum() + 0.1 * sim.angular_velocity[0] ** 2)
        stored = 0.5e6 * (sim.orientation[0] - 0.1) ** 2
        assert moving + stored + G * sim.position[0, 1] <= most * (1 + 1e-9)


def test_rope_holds_a_weight_at_its_length_and_lets_it_come_nearer() -> None:
    scene = Scene(gravity=(0.0, -G))
    scene.add_body(None, mass=2.0, inertia=0.1, position=(0.0, -0.5))
    scene.add_joint(Distance(limits=Limits(upper=1.0, restitution=0.0)), (0.0, 0.0), 0)
    sim = plain(scene)
    sim.step(10)
    assert sim.velocity[0, 1] == pytest.approx(-G * 10 / 60)
    sim.step(30)
    assert sim.position[0, 1] == pytest.approx(-1.0, abs=1e-6)
    assert sim.reactions.force[0, 1, 1] == pytest.approx(2.0 * G, rel=1e-6)


def test_car_stands_on_its_springs() -> None:
    scene = Scene(gravity=(0.0, -G))
    ground(scene, 0.5)
    stuff = {"friction": 0.5, "restitution": 0.0}
    hull = scene.add_body(t2.Box(width=2.0, height=0.4), mass=100.0, position=(0.0, 1.0), **stuff)
    spring = JointSpring(stiffness=20e3, damping=3e3, rest=0.0)
    for x in (-0.7, 0.7):
        wheel = scene.add_body(t2.Disc(radius=0.3), mass=10.0, position=(x, 0.3), **stuff)
        kind = Wheel(axis=(0.0, 1.0), spring=spring, limits=Limits(lower=-0.2, restitution=0.0))
        scene.add_joint(kind, hull, wheel, anchor=(x, -0.7))
    sim = plain(scene)
    sim.step(60)
    sunk = float(1.0 - sim.position[hull, 1])
    assert sunk == pytest.approx(100.0 * G / 2 / 20e3, abs=2e-3)  # contacts yield by as much
    assert np.abs(sim.velocity).max() < 0.05


def test_joints_that_are_apart_are_told_by_name() -> None:
    sim = plain(pendulum())
    sim.position[0] = (1.5, 0.0)
    with pytest.warns(StepWarning, match=r"joint 'joint0' \(revolute\).*apart.*R13"):
        sim.step()


# -- contacts and sleep


def links_on_the_ground(count: int = 4, *, collide: bool = False) -> Scene:
    scene = Scene(gravity=(0.0, -G))
    ground(scene, 0.5)
    for k in range(count):
        place = (0.8 * k, 0.25)
        scene.add_body(
            t2.Disc(radius=0.25), mass=1.0, position=place, friction=0.5, restitution=0.0
        )
        if k:
            ends = (k, k + 1)
            scene.add_joint(
                Revolute(), *ends, anchor=(0.4, 0.0), other_anchor=(-0.4, 0.0), collide=collide
            )
    return scene


def test_jointed_bodies_rest_on_the_ground_and_sleep_as_one() -> None:
    sim = plain(links_on_the_ground(), sleeping=True)
    sim.step(60)
    assert sim.asleep[1:].all()
    assert sim.reactions.separation.max() < 1e-6
    sim.apply_impulse(4, (0.0, 2.0))
    sim.step()
    assert not sim.asleep[1:].any()


def test_heap_of_ragdolls_gains_no_energy_and_holds() -> None:
    scene = ragdoll_heap(3, seed=2)
    sim, size = Simulator(scene), 0.0
    for _ in range(300):
        before = energy(sim, scene)
        size = max(size, before)
        sim.step()
        assert energy(sim, scene) <= before + 1e-13 * size  # rounding of the sums
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


@pytest.mark.parametrize(
    ("kind", "bears", "what"),
    [
        (Ratchet(pitch=0.1, restitution=0.0), {}, "ratchets"),
        (Revolute(), {"break_force": 10.0}, "breaking"),
        (Revolute(limits=Limits(lower=-1.0, restitution=0.5)), {}, "restitution of limits"),
    ],
)
def test_what_steps_do_not_know_is_refused_by_name(kind: Any, bears: Any, what: str) -> None:
    scene = Scene(gravity=(0.0, -G))
    scene.add_body(None, mass=1.0, inertia=0.1, position=(1.0, 0.0), name="bob")
    scene.add_joint(kind, (0.0, 0.0), "bob", other_anchor=(-1.0, 0.0), name="held", **bears)
    with pytest.raises(InputError, match=rf"joint 'held' \(.*\): steps know no {what}"):
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
