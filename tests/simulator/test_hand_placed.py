"""Bodies that are put beyond a limit, or off their joints, by hand: told, and back soon (GD21)."""

import math
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.errors import StepWarning
from tamias2d.scene.writing import scene_text

LIMITS = t2.Limits(lower=-0.5, upper=0.5, restitution=0.0)


def door(gravity: float = 0.0) -> t2.Simulator:
    scene = t2.Scene(gravity=(0.0, gravity))
    plank = t2.Box(width=1.0, height=0.1)
    for k in range(2):
        scene.add_body(plank, mass=1.0, position=(k + 0.5, 0.0), restitution=0.0)
    scene.add_joint(t2.Revolute(limits=LIMITS), (0, 0), 0, other_anchor=(-0.5, 0), name="root")
    ends: dict[str, Any] = {"anchor": (0.5, 0.0), "other_anchor": (-0.5, 0.0)}
    scene.add_joint(t2.Revolute(), 0, 1, **ends, name="pin")
    return t2.Simulator(scene, time_step=1 / 60, compiled=False)


def turn(sim: t2.Simulator, angle: float) -> None:
    """Turn both planks about the root by hand."""
    along = np.array([math.cos(angle), math.sin(angle)])
    for k in range(2):
        sim.position[k], sim.orientation[k] = (k + 0.5) * along, angle


@pytest.mark.parametrize(("angle", "side"), [(1.0, "upper"), (-1.0, "lower")])
def test_what_is_put_beyond_a_limit_is_told_and_comes_back_without_energy(
    angle: float, side: str
) -> None:
    sim = door()
    sim.step()
    turn(sim, angle)
    says = f"'root'.*, at 0.0166667 s: it was put 0.5 .* beyond its {side} limit by hand"
    with pytest.warns(StepWarning, match=says) as heard:
        sim.step(12)
    assert heard[0].filename == __file__
    (told,) = sim.warnings
    assert "put its bodies where its limits allow" in told
    assert abs(sim.orientation[0]) == pytest.approx(0.5, abs=1e-5)  # 0.8 ** 48 of a half is left
    speeds = np.abs(sim.velocity).max(), np.abs(sim.angular_velocity).max()
    assert max(speeds) < 1e-4


def test_what_would_have_to_be_lifted_back_stays_and_is_told() -> None:
    sim = door(gravity=-9.81)
    turn(sim, -1.0)
    with pytest.warns(StepWarning, match="at 0 s: it was put 0.5 .* beyond its lower limit"):
        sim.step()
    assert sim.orientation[0] == pytest.approx(-1.0, abs=0.01)


def test_what_is_put_within_its_limits_is_not_told() -> None:
    sim = door()
    sim.step()
    turn(sim, 0.49)
    sim.step(5)
    turn(sim, 0.5 + 9e-4)  # a thousandth of a radian is told
    sim.step(5)
    assert not sim.warnings


def test_a_body_put_off_its_joint_is_told_as_placed_by_hand() -> None:
    sim = door()
    sim.step()
    sim.position[1] += (0.1, 0.0)
    with pytest.warns(StepWarning, match="'pin'.*0.1 apart.*put elsewhere by hand"):
        sim.step(10)
    assert sim.reactions.separation.max() < 1e-4


def test_a_tooth_behind_which_a_wheel_was_put_is_told() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=(0.0, 0.0), restitution=0.0)
    scene.add_joint(t2.Revolute(), (0, 0), 0)
    scene.add_joint(t2.Ratchet(pitch=0.1, restitution=0.0), (0, 0), 0, name="pawl")
    sim = t2.Simulator(scene, compiled=False)
    sim.angular_velocity[0] = 2.0
    sim.step(20)
    tooth = 0.1 * math.floor(float(sim.orientation[0]) / 0.1)
    assert tooth > 0.2
    sim.angular_velocity[0] = 0.0
    sim.orientation[0] = tooth - 0.05
    with pytest.warns(StepWarning, match="'pawl'.*put 0.05 .* beyond its lower limit"):
        sim.step(10)
    assert sim.orientation[0] == pytest.approx(tooth, abs=1e-4)


@pytest.mark.parametrize("turn", [3.0, -2.0])
def test_a_car_that_is_put_back_on_its_wheels_has_not_turned(turn: float) -> None:
    """It was told that its wheels' grooves had turned too far in a substep."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -10.0)))
    hull = sim.add(t2.Box(width=2.0, height=0.5), mass=800.0, position=(0.0, 1.0), restitution=0.0)
    places = np.array([(-0.8, 0.4), (0.8, 0.4)])
    wheels = sim.add(t2.Disc(radius=0.4), mass=40.0, position=places, group=-1, restitution=0.0)
    spring = t2.JointSpring(stiffness=9e4, damping=6e3)
    for k, place in zip(wheels.tolist(), places, strict=True):
        sim.add_joint(t2.Wheel(axis=(0.0, 1.0), spring=spring), hull, k, at=place)
    sim.orientation[hull] = turn
    cosine, sine = np.cos(turn), np.sin(turn)
    sim.position[wheels] = (0.0, 1.0) + (places - (0.0, 1.0)) @ [[cosine, sine], [-sine, cosine]]
    sim.step()  # which the chassis takes upside down, or nearly
    sim.orientation[hull], sim.position[hull] = 0.0, (5.0, 3.0)
    sim.position[wheels] = places + np.array([5.0, 2.0])
    sim.velocity[:] = sim.angular_velocity[:] = 0.0
    sim.step(30)
    assert sim.warnings == ()


def test_a_wheel_without_a_motor_is_a_wheel_and_a_groove_is_a_groove() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    for x in (0.0, 1.0):
        scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=(x, 0.0), restitution=0.0)
    spring, motor = t2.JointSpring(stiffness=1.0), t2.Motor(speed=0.0)
    limits = t2.Limits(lower=-1.0, upper=2.0, restitution=0.0)
    for kind in (
        t2.Wheel(axis=(1.0, 0.0), spring=spring),
        t2.Wheel(axis=(1.0, 0.0), spring=spring, limits=limits, motor=motor),
        t2.Groove(axis=(1.0, 0.0)),
        t2.Groove(axis=(1.0, 0.0), limits=limits, motor=motor),
    ):
        scene.add_joint(kind, 0, 1)
    assert [joint.kind for joint in scene.joints] == ["wheel", "wheel", "groove", "groove"]
    text = scene_text(scene)
    assert scene_text(t2.load(text)) == text


def test_a_joint_that_does_not_fit_says_where_its_anchors_are() -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    box = sim.add(t2.Box(width=1.0, height=1.0), mass=1.0, position=(5.0, 0.0), restitution=0.0)
    message = r"off by 0.5 m \(TM7\).*the centres of bodies unless they are stated, and `at` puts"
    with pytest.raises(t2.InputError, match=message):
        sim.add_joint(t2.Weld(), (5.0, 0.5), box)
    sim.add_joint(t2.Weld(), (5.0, 0.5), box, at=(5.0, 0.5))


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
@pytest.mark.parametrize("kinds", [("prismatic", "revolute"), ("pulley", "revolute")])
@pytest.mark.parametrize("seed", [3, 20, 42])
def test_what_is_put_elsewhere_before_the_first_step_comes_back_without_energy(
    kinds: tuple[str, str], seed: int
) -> None:
    """It was pulled back with up to 125 kJ, as what holds a body may be that was moved itself."""
    of = {
        "prismatic": t2.Prismatic(axis=(1.0, 0.3)),
        "pulley": t2.Pulley(posts=((-2.0, 5.0), (2.0, 5.0))),
        "revolute": t2.Revolute(),
    }
    chance = np.random.default_rng(seed)
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)), time_step=1 / 120, compiled=False)
    places = chance.uniform(-3.0, 3.0, (3, 2))
    sim.add([t2.Disc(radius=0.3)] * 3, mass=1.0, position=places, restitution=0.0, mask=0)
    for k, kind in enumerate(kinds):
        at: Any = {} if kind == "pulley" else {"at": tuple(places[k + 1].tolist())}
        sim.add_joint(of[kind], 0, k + 1, **at)
    sim.position[0], sim.orientation[0] = chance.uniform(-4.5, 4.5, 2), chance.uniform(-3.0, 3.0)
    for _ in range(10):
        sim.step()
        assert np.abs(sim.velocity).max() < 1e-12


def test_a_world_that_is_reset_takes_a_pose_as_one_that_was_restored() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    for k in range(2):
        scene.add_body(t2.Box(width=0.5, height=0.1), mass=1.0, position=(k, 0.0), mask=0)
    scene.add_joint(t2.Revolute(), 0, 1, at=(0.5, 0.0))
    fresh, later = (t2.Simulator(scene, compiled=False) for _ in range(2))
    state = later.copy_state()
    later.step(3)
    later.restore_state(state)
    for sim in (fresh, later):
        sim.position[1, 1] = 0.3
        with pytest.warns(StepWarning, match="put elsewhere by hand"):
            sim.step()
    assert np.array_equal(fresh.position, later.position)
    assert np.array_equal(fresh.velocity, later.velocity)


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
@pytest.mark.parametrize("kind", [t2.Revolute(), t2.Weld()])
@pytest.mark.parametrize("steps", [0, 1])
def test_what_is_held_follows_its_point_also_before_the_first_step(kind: Any, steps: int) -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)), compiled=False)
    load = sim.add(t2.Disc(radius=0.1), mass=1.0, position=(0.0, 0.0), restitution=0.0)
    sim.add_joint(kind, (0.0, 1.0), load, at=(0.0, 1.0), name="hook")
    sim.step(steps)
    sim.set_target("hook", (0.0, 2.0))
    sim.step(30)
    assert sim.position[load] == pytest.approx((0.0, 1.0), abs=1e-6)
