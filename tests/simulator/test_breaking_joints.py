"""Joints that break as a step ends, and ratchets (GD21, GD23), in the frame loop."""

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.simulator.joint_set import JointSet
from tests.engine.scenes import plain

G = 9.81


def swinging(force: float = 30.0) -> t2.Scene:
    """A bob of 2 kg on a rod of 1 m, let go level: the rod bears three times the weight below."""
    scene = t2.Scene(gravity=(0.0, -G))
    scene.add_body(None, mass=2.0, inertia=0.1, position=(1.0, 0.0), name="bob")
    scene.add_joint(t2.Distance(), (0.0, 0.0), "bob", name="rod", break_force=force)
    return scene


@pytest.mark.parametrize("steps", [60, 240])
def test_a_rod_breaks_in_the_step_in_which_statics_says_so(steps: int) -> None:
    """At an angle a below the level it bears 3 m g sin a, as m g l sin a has become motion."""
    sim = plain(swinging(), time_step=1 / steps)
    while not sim.joint_events:
        before = np.arctan2(-sim.position[0, 1], sim.position[0, 0])
        sim.step()
    after = np.arctan2(-sim.position[0, 1], sim.position[0, 0])
    turn = math.asin(30.0 / (3 * 2.0 * G))
    step = after - before
    assert before - step < turn < after + step
    (event,) = sim.joint_events
    assert (event.joint, event.words, event.time) == ("rod", "breaks", sim.time)
    assert 1.0 < event.value < 1.02 * math.sin(after) / math.sin(turn)  # of what it bears
    assert sim.joints == ()
    velocity = sim.velocity[0].copy()
    sim.step(steps // 10)
    assert sim.joint_events == ()
    assert sim.velocity[0, 0] == pytest.approx(velocity[0], rel=1e-12)
    assert sim.velocity[0, 1] == pytest.approx(velocity[1] - G / 10, rel=1e-12)


def test_what_a_rod_bears_is_smooth() -> None:
    """A firm row's mass is 1e8 times that of its body: its impulse was lost in rounding."""
    sim = plain(swinging(force=1e9), time_step=1 / 960)
    for _ in range(280):
        sim.step()
    for _ in range(8):
        place, velocity = sim.position[0].copy(), sim.velocity[0].copy()
        sim.step()
        middle, speed = (place + sim.position[0]) / 2, (velocity + sim.velocity[0]) / 2
        bears = 2.0 * (speed @ speed) - 2.0 * G * middle[1]
        assert np.hypot(*sim.reactions.force[0, 0]) == pytest.approx(bears, rel=1e-3)
        assert sim.reactions.separation[0] < 1e-10


def test_a_torque_breaks_a_weld() -> None:
    """A beam of 1 kg and 1 m, held at an end, bears m g / 2; 1 kg at its tip adds m g."""
    for load, breaks in ((0.0, False), (1.0, True)):
        scene = t2.Scene(gravity=(0.0, -G))
        scene.add_body(t2.Box(width=1.0, height=0.1), mass=1.0, position=(0.5, 0.0), name="beam")
        scene.add_joint(
            t2.Weld(), (0.0, 0.0), "beam", other_anchor=(-0.5, 0.0), break_torque=G, name="root"
        )
        sim = plain(scene)
        for _ in range(5):
            sim.apply_force("beam", (0.0, -load * G), at=(1.0, 0.0))
            sim.step()
        assert (sim.joints == ()) is breaks


def chain(weak: float = 30.0) -> t2.Scene:
    """Six links, let go level from a nail; the pin between the third and the fourth is weak, N."""
    scene = t2.Scene(gravity=(0.0, -G))
    for k in range(6):
        scene.add_body(
            t2.Box(width=0.9, height=0.1), mass=1.0, position=(k + 0.5, 0.0), restitution=0.0
        )
        first: Any = k - 1 if k else (0.0, 0.0)
        anchors = {"anchor": (0.5 if k else 0.0, 0.0), "other_anchor": (-0.5, 0.0)}
        bears = weak if k == 3 else 1e6
        scene.add_joint(t2.Revolute(), first, k, **anchors, break_force=bears, name=f"pin{k}")
    return scene


def test_what_does_not_break_goes_on_with_what_it_bore() -> None:
    """The others are told as if none had broken, and no link jumps in the next step."""
    sim, whole = plain(chain()), plain(chain(weak=1e6))
    while len(sim.joints) == 6:
        sim.step()
        whole.step()
    assert [event.joint for event in sim.joint_events] == ["pin3"]
    left, all_of_it = sim.reactions, whole.reactions
    assert left.names == ("pin0", "pin1", "pin2", "pin4", "pin5")
    np.testing.assert_array_equal(left.force, np.delete(all_of_it.force, 3, axis=0))
    np.testing.assert_allclose(left.torque, np.delete(all_of_it.torque, 3, axis=0), atol=1e-12)
    before = sim.velocity.copy()
    sim.step()
    pulled = np.hypot(*all_of_it.force[3, 0]) + 10 * G  # what a link may get in a step, at most
    assert np.hypot(*(sim.velocity - before).T).max() < pulled / 60
    assert sim.reactions.separation.max() < 1e-4


def test_many_steps_at_once_break_the_same() -> None:
    one, many = plain(chain()), plain(chain())
    told = []
    for _ in range(40):
        one.step()
        told += one.joint_events
    many.step(40)
    assert [event.words for event in told] == ["breaks"]
    assert list(many.joint_events) == told
    assert one.digest() == many.digest()


def test_joints_that_keep_bodies_apart_no_longer_do_once_broken() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    for k, name in enumerate("ab"):
        scene.add_body(
            t2.Disc(radius=0.5), mass=1.0, position=(2.0 * k, 0.0), velocity=(1.0 - 2.0 * k, 0.0),
            restitution=1.0, name=name,
        )  # fmt: skip
    rope = t2.Distance(limits=t2.Limits(lower=1.8, restitution=0.0))
    scene.add_joint(rope, "a", "b", break_force=1.0)
    sim = plain(scene)
    sim.step(60)
    assert sim.joints == ()
    sim.velocity[:, 0] = 1.0, -1.0
    sim.step(60)
    assert sim.velocity[:, 0] == pytest.approx([-1.0, 1.0], rel=1e-12)


def wheel(pitch: float = 0.3) -> t2.Scene:
    """Thrown at 2 rad/s against 1 N m: 2 rad at 2 s, and back to the last tooth."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(
        None, mass=1.0, inertia=1.0, position=(0.0, 0.0), angular_velocity=2.0, torque=-1.0,
        name="wheel",
    )  # fmt: skip
    scene.add_joint(t2.Ratchet(pitch=pitch, restitution=0.0), (0.0, 0.0), "wheel", name="pawl")
    return scene


def test_a_ratchet_clicks_forwards_and_holds_backwards() -> None:
    sim = plain(wheel())
    told = []
    for _ in range(240):
        sim.step()
        told += [(event.words, event.joint) for event in sim.joint_events]
    assert told == [*6 * [("clicks", "pawl")], ("strikes its lower limit", "pawl")]
    assert sim.orientation[0] == pytest.approx(1.8, abs=1e-9)
    assert sim.reactions.torque[0, 1] == pytest.approx(1.0, rel=1e-9)


def test_a_ratchet_goes_on_where_it_was_saved(tmp_path: Path) -> None:
    sim = plain(wheel())
    sim.step(90)
    sim.save(tmp_path / "wheel.npz")
    again = t2.Simulator.restore(tmp_path / "wheel.npz", compiled=False)
    for _ in range(150):
        sim.step()
        again.step()
        assert again.joint_events == sim.joint_events
    assert again.digest() == sim.digest()


def test_two_ratchets_that_are_alike_click_each() -> None:
    """The finer one holds."""
    scene = wheel()
    scene.add_joint(t2.Ratchet(pitch=0.35, restitution=0.0), (0.0, 0.0), "wheel", name="other")
    sim = plain(scene)
    sim.step(300)
    assert {event.joint for event in sim.joint_events} == {"pawl", "other"}
    assert sim.orientation[0] == pytest.approx(1.8, abs=1e-9)


def test_a_joint_that_breaks_can_be_added() -> None:
    sim = plain(t2.Scene(gravity=(0.0, -G)))
    bob = sim.add(t2.Disc(radius=0.1), mass=1.0, position=(0.0, -1.0), restitution=0.0)
    sim.add_joint(t2.Distance(), (0.0, 0.0), bob, break_force=1.5 * G, name="thread")
    sim.step(10)
    assert sim.joints == ("thread",)
    sim.apply_impulse(bob, (0.0, -1.0))
    sim.step()
    assert sim.joints == ()
    with pytest.raises(t2.InputError, match=r"break force -1 N of joint 'no': must be > 0"):
        sim.add_joint(t2.Distance(), (0.0, 0.0), bob, break_force=-1.0, name="no")


def test_stepped_runs_tell_what_broke_and_clicked() -> None:
    run = t2.simulate(swinging(), duration=0.5, method=t2.Stepped(), time_step=1 / 240)
    assert run.joint_events.words == ("breaks",)
    assert run.joint_events.joint.tolist() == [0]
    exact = t2.simulate(swinging(), duration=0.5)
    assert run.joint_events.time == pytest.approx(exact.joint_events.time, abs=2 / 240)
    run = t2.simulate(wheel(), duration=2.0, method=t2.Stepped(), time_step=1 / 60)
    assert run.joint_events.value == pytest.approx([0.3, 0.6, 0.9, 1.2, 1.5, 1.8])


def test_worlds_that_are_reset_have_their_joints_back() -> None:
    sims = t2.Simulators(swinging(), worlds=2)
    sims.step(40)
    first = sims.world(0).digest()
    assert sims.world(0).joints == ()
    sims.reset()
    assert sims.world(0).joints == ("rod",)
    sims.step(40)
    assert sims.world(0).digest() == first


def test_joints_of_sleepers_are_left_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing happens to them, and a call takes all of its steps at once; but what wakes breaks."""
    scene = t2.Scene(gravity=(0.0, -G))
    scene.add_body(t2.Disc(radius=0.2), mass=1.0, position=(0.0, -1.0), restitution=0.0, name="bob")
    scene.add_joint(t2.Distance(), (0.0, 0.0), "bob", break_force=2 * G, name="thread")
    sim = plain(scene, sleeping=True)
    sim.step(40)
    assert sim.asleep.all()
    looked = []
    look = JointSet.look
    monkeypatch.setattr(JointSet, "look", lambda *given: looked.append(0) or look(*given))
    sim.step(1000)
    assert len(looked) < 3
    sim.gravity = (0.0, -2.5 * G)
    before = sim.time
    sim.step(1000)
    (event,) = sim.joint_events
    assert event.time == pytest.approx(before + sim.time_step, rel=1e-12)


@pytest.mark.parametrize("order", [1, -1])
def test_the_larger_of_the_loads_breaks_a_gear_and_a_pulley(order: int) -> None:
    """All is at rest: the rope pulls thrice as much at one body, the gear turns the other so."""
    scene = t2.Scene(gravity=(0.0, -G))
    for k, (mass, torque) in enumerate(((1.0, 3.0), (3.0, -1.0))):
        scene.add_body(None, mass=mass, inertia=1.0, position=(k, 0.0), torque=torque, name="ab"[k])
    ends, posts = ("a", "b")[::order], ((0.0, 5.0), (1.0, 5.0))[::order]
    pulley = t2.Pulley(posts=posts, ratio=3.0**order)
    scene.add_joint(pulley, *ends, break_force=2.0 * G, name="rope")
    scene.add_joint(t2.Gear(ratio=3.0**order), *ends, break_torque=2.0, name="gear")
    sim = plain(scene)
    sim.step()
    assert sim.joints == ()


def test_forces_and_torques_that_break_are_those_that_are_told() -> None:
    """On A or B of several joints, of one row and of more, which bear a hair less, or more."""
    scene = t2.Scene(gravity=(0.0, -G))
    upper: Any = (0.0, 0.0)
    for k, kind in enumerate((t2.Weld(), t2.Revolute(), t2.Distance(length=0.5))):
        box = t2.Box(width=0.8, height=0.1)
        scene.add_body(box, mass=1.0, position=(k + 0.5, 0.0), restitution=0.0, name=f"box{k}")
        anchors = {"anchor": (0.5 * (k > 0), 0.0), "other_anchor": (-0.5 * (k < 2), 0.0)}
        bears = {"break_force": 1e9} | ({"break_torque": 1e9} if k == 0 else {})
        scene.add_joint(kind, upper, f"box{k}", **anchors, **bears, name=f"joint{k}")
        upper = f"box{k}"
    sim = plain(scene)
    sim.step(7)
    force = np.hypot(*sim.reactions.force[:, :2].T).max(axis=0)
    torque = np.abs(sim.reactions.torque[:, :2]).max(axis=1)
    assert force.min() > 1.0
    assert (torque > 1.0).tolist() == [True, False, False]
    watch = sim._joints._watch
    assert watch is not None
    for change, broken in ((-1e-9, ["joint0", "joint1", "joint2"]), (1e-9, [])):
        for forces, torques in ((force, np.inf), (np.inf, np.where(torque > 1.0, torque, np.inf))):
            watch._force_most = forces * (1.0 + change) * np.ones(3)
            watch._torque_most = torques * (1.0 + change) * np.ones(3)
            found = watch._overloaded(sim._engine.pose, sim.time_step)
            over = [joint.name for joint, share in found if share > 1.0]
            assert over == (broken if forces is force else broken[:1])
