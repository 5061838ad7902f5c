"""Limits of joints that are set anew between steps: stops that move, ropes that are wound up.

Expected values come from uniform motion, from free fall, and from what is the same.
"""

import copy
import math
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tamias2d import (
    Box,
    Disc,
    Distance,
    Groove,
    InputError,
    JointSpring,
    Limits,
    Prismatic,
    Ratchet,
    Revolute,
    Rotary,
    Scene,
    Simulator,
    StepWarning,
    Wheel,
)
from tests.engine.scenes import plain

G = 10.0
WIDE = Limits(lower=-8.0, upper=8.0, restitution=0.0)
SOFT = JointSpring(stiffness=1e-9)
ALONG: dict[str, Any] = {
    "prismatic": Prismatic(axis=(1.0, 0.0), limits=WIDE),
    "groove": Groove(axis=(1.0, 0.0), limits=WIDE),
    "wheel": Wheel(axis=(1.0, 0.0), limits=WIDE, spring=SOFT),
    "distance": Distance(limits=Limits(lower=0.1, upper=9.0, restitution=0.0)),
}
ABOUT: dict[str, Any] = {"revolute": Revolute(limits=WIDE), "rotary": Rotary(limits=WIDE)}


@pytest.mark.parametrize("kind", [*ALONG, *ABOUT])
@pytest.mark.parametrize("restitution", [0.0, 0.5])
def test_a_stop_is_where_it_is_put(kind: str, restitution: float) -> None:
    """From 1, at 2 a second, to a stop at 1.5, where 0.5 of that is left, turned around."""
    scene, turns = Scene(gravity=(0.0, 0.0)), kind in ABOUT
    place = (0.0, 0.0) if turns else (1.0, 0.0)
    start: Any = {"position": place, "orientation": 1.0 if turns else 0.0}
    scene.add_body(None, mass=1.0, inertia=2.0, **start, name="slider")
    scene.add_joint({**ALONG, **ABOUT}[kind], (0.0, 0.0), "slider", name="stop")
    sim = plain(scene)
    sim.step()
    (sim.angular_velocity if turns else sim.velocity[:, 0])[0] = 2.0
    sim.set_limits("stop", Limits(lower=0.5, upper=1.5, restitution=restitution))
    sim.step(20)
    at = sim.orientation[0] if turns else sim.position[0, 0]
    rate = sim.angular_velocity[0] if turns else sim.velocity[0, 0]
    assert rate == pytest.approx(-2.0 * restitution, abs=1e-6)
    left = 1.5 + rate * (20 / 60 - 0.25)
    assert at == pytest.approx(left, abs=2.0 / 60)  # the rest of the step in which it is struck


def crane(**settings: Any) -> Simulator:
    """Return a load of 2 kg on a rope of 2 m."""
    sim = Simulator(Scene(gravity=(0.0, -G)), **settings)
    load = sim.add(Disc(radius=0.2), mass=2.0, position=(0.0, -2.0), restitution=0.0)
    rope = Distance(limits=Limits(upper=2.0, restitution=0.0))
    sim.add_joint(rope, (0.0, 0.0), load, name="rope")
    return sim


def door() -> Simulator:
    """Return a board of 1 m on a hinge with limits."""
    sim = Simulator(Scene(gravity=(0.0, 0.0)))
    board = sim.add(Box(width=1.0, height=0.1), mass=2.0, position=(0.5, 0.0), restitution=0.0)
    sim.add_joint(Revolute(limits=WIDE), (0.0, 0.0), board, other_anchor=(-0.5, 0.0), name="door")
    return sim


def lift() -> Simulator:
    """Return a cabin of 2 kg that hangs on the lower stop of a rail, 2 m above its origin."""
    sim = Simulator(Scene(gravity=(0.0, G)))
    cabin = sim.add(Box(width=0.5, height=0.5), mass=2.0, position=(0.0, 2.0), restitution=0.0)
    rail = Prismatic(axis=(0.0, 1.0), limits=Limits(upper=2.0, restitution=0.0))
    sim.add_joint(rail, (0.0, 0.0), cabin, other_anchor=(0.0, 0.0), name="lift")
    return sim


@pytest.mark.parametrize("rate", [0.05, 0.5])
def test_a_rope_that_is_wound_up_lifts(rate: float) -> None:
    """It lags behind by what a joint lets be left: a third of the way of a step and its sag."""
    sim = crane()
    sim.step(10)
    for k in range(1, 121):
        length = 2.0 - rate * k / 60
        sim.set_limits("rope", Limits(upper=length, restitution=0.0))
        sim.step()
        assert -sim.position[0, 1] == pytest.approx(length, abs=1.5e-3 + rate / 60 / 3)
    sim.step(60)
    assert -sim.position[0, 1] == pytest.approx(2.0 - 2 * rate, abs=1e-6)
    assert not sim.warnings


def test_a_limit_that_jumps_past_a_joint_gives_it_no_speed_and_is_told() -> None:
    scene = Scene(gravity=(0.0, 0.0))
    scene.add_body(Box(width=1.0, height=0.1), mass=2.0, position=(0.5, 0.0))
    hinge = Revolute(limits=WIDE)
    scene.add_joint(hinge, (0.0, 0.0), 0, other_anchor=(-0.5, 0.0), name="door")
    sim = plain(scene)
    sim.step()
    says = r"'door' \(revolute\), at 0.0166667 s: its lower limit jumped past it by 0.5"
    with pytest.warns(StepWarning, match=says):
        sim.set_limits("door", Limits(lower=0.5, upper=1.0, restitution=0.0))
    sim.step(15)
    assert sim.orientation[0] == pytest.approx(0.5, abs=1e-5)
    assert abs(sim.angular_velocity[0]) < 1e-4


@pytest.mark.parametrize("time_step", [1 / 60, 1 / 240])
def test_a_rope_that_jumps_brings_its_load_back_without_speed_or_force(time_step: float) -> None:
    """It tells the weight, 20 N, all the time; then it lets go, and holds again farther down."""
    sim = crane(time_step=time_step)
    sim.step(10)
    with pytest.warns(StepWarning, match="its upper limit jumped past it by 1 "):
        sim.set_limits("rope", Limits(upper=1.0, restitution=0.0))
    for _ in range(30):
        sim.step()
        assert abs(sim.velocity[0, 1]) < 1e-3
        assert sim.reactions.force[0, 1, 1] == pytest.approx(20.0, rel=0.01)
    assert sim.position[0, 1] == pytest.approx(-1.0, abs=1e-5)
    sim.set_limits("rope", None)
    sim.step(30)
    assert sim.velocity[0, 1] == pytest.approx(-G * 30 * time_step, abs=1e-3)
    sim.set_limits("rope", Limits(upper=4.0, restitution=0.0))
    sim.step(round(1.0 / time_step))
    assert sim.position[0, 1] == pytest.approx(-4.0, abs=1e-3)


@pytest.mark.parametrize("rate", [0.2, 1.0, 4.0])
@pytest.mark.parametrize("time_step", [1 / 60, 1 / 240])
def test_a_rope_is_wound_up_at_any_speed(rate: float, time_step: float) -> None:
    """A load of 0.28 m in radius on 4.8 m: it is less than a step's way behind, 5 g in the mean."""
    sim = Simulator(Scene(gravity=(0.0, -G)), time_step=time_step)
    load = sim.add(Box(width=0.4, height=0.4), mass=5.0, position=(0.0, -4.8), restitution=0.0)
    rope = Distance(limits=Limits(upper=4.8, restitution=0.0))
    sim.add_joint(rope, (0.0, 0.0), load, name="rope")
    sim.step(10)
    told, steps = [], round(0.6 / time_step)
    for k in range(1, steps + 1):
        length = 4.8 - rate * time_step * k
        sim.set_limits("rope", Limits(upper=length, restitution=0.0))
        sim.step()
        told.append(sim.reactions.force[0, 1, 1])
        assert abs(-sim.position[0, 1] - length) < 1.05 * rate * time_step
    half = told[steps // 2 :]
    assert sum(half) / len(half) == pytest.approx(50.0, rel=0.03)
    assert not sim.warnings


@pytest.mark.parametrize("kind", ["prismatic", "wheel", "revolute"])
def test_a_stop_that_jumps_lifts_without_speed(kind: str) -> None:
    scene, turns = Scene(gravity=(0.0, -G)), kind == "revolute"
    at_zero = Limits(lower=0.0, upper=9.0, restitution=0.0)
    joints: dict[str, Any] = {
        "prismatic": Prismatic(axis=(0.0, 1.0), limits=at_zero),
        "wheel": Wheel(axis=(0.0, 1.0), limits=at_zero, spring=SOFT),
        "revolute": Revolute(limits=at_zero),
    }
    place: Any = {"position": (0.5 if turns else 0.0, 0.0)}
    place["inertia"] = None if turns else math.inf
    scene.add_body(Box(width=1.0, height=0.1), mass=3.0, **place, name="arm")
    ends: Any = {"other_anchor": (-0.5, 0.0)} if turns else {}
    scene.add_joint(joints[kind], (0.0, 0.0), "arm", **ends, name="stop")
    sim = plain(scene)
    sim.step(5)
    with pytest.warns(StepWarning, match="its lower limit jumped past it"):
        sim.set_limits("stop", Limits(lower=0.5, upper=9.0, restitution=0.0))
    for _ in range(20):
        sim.step()
        assert max(abs(sim.velocity[0, 1]), abs(sim.angular_velocity[0])) < 1e-3
        assert sim.reactions.force[0, 1, 1] == pytest.approx(30.0, rel=0.01)
    at = sim.orientation[0] if turns else sim.position[0, 1]
    assert at == pytest.approx(0.5, abs=1e-5)


def test_a_jump_wakes_what_sleeps_and_brings_it_back() -> None:
    sim = crane(sleeping=True)
    sim.step(300)
    assert sim.asleep[0]
    with pytest.warns(StepWarning, match="jumped past it"):
        sim.set_limits("rope", Limits(upper=1.5, restitution=0.0))
    sim.step(20)
    assert sim.position[0, 1] == pytest.approx(-1.5, abs=1e-4)


def test_a_limit_that_is_moved_as_soon_as_it_is_added_takes_along_too() -> None:
    sim = crane()
    sim.set_limits("rope", Limits(upper=1.99, restitution=0.0))
    sim.step(30)
    assert sim.position[0, 1] == pytest.approx(-1.99, abs=1e-6)
    assert not sim.warnings


def test_a_slow_winch_after_a_jump_goes_on_slowly() -> None:
    """What was left of the jump comes back without speed, and then the winch takes along."""
    sim = crane()
    sim.step(10)
    with pytest.warns(StepWarning, match="its upper limit jumped"):
        sim.set_limits("rope", Limits(upper=1.5, restitution=0.0))
    for k in range(1, 31):
        sim.set_limits("rope", Limits(upper=1.5 - 0.2 * k / 60, restitution=0.0))
        sim.step()
        assert abs(sim.velocity[0, 1]) < 0.5
    assert -sim.position[0, 1] == pytest.approx(1.4, abs=0.2 / 60)


def test_an_end_that_is_left_out_limits_nothing() -> None:
    scene = Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, inertia=1.0, position=(0.0, 0.0), angular_velocity=-3.0)
    scene.add_joint(Rotary(limits=WIDE), (0.0, 0.0), 0, name="stop")
    sim = plain(scene)
    sim.set_limits("stop", Limits(upper=1.0, restitution=0.5))
    sim.step(240)
    assert sim.orientation[0] == pytest.approx(-12.0)
    sim.set_limits("stop", Limits(upper=-11.0, lower=-12.5, restitution=1.0))
    sim.step(30)
    assert sim.angular_velocity[0] == pytest.approx(3.0)


def mechanism(limits: Limits, **settings: Any) -> Simulator:
    """Return three links of which the second hinge has limits, "elbow"."""
    scene = Scene(gravity=(0.0, -G))
    for k in range(3):
        scene.add_body(Box(width=1.0, height=0.1), mass=1.0, position=(k + 0.5, 0.0), group=-1)
        upper: Any = (0.0, 0.0) if k == 0 else k - 1
        ends: Any = {"anchor": (0.5 * (k > 0), 0.0), "other_anchor": (-0.5, 0.0)}
        kind = Revolute(limits=limits) if k == 1 else Revolute()
        scene.add_joint(kind, upper, k, **ends, name="elbow" if k == 1 else f"hinge{k}")
    return plain(scene, **settings)


def slide(limits: Limits, **settings: Any) -> Simulator:
    """Return a trolley on a rail with stops, "elbow", from which a bob hangs."""
    scene = Scene(gravity=(1.0, -G))
    scene.add_body(None, mass=2.0, inertia=1.0, position=(0.0, 0.0))
    scene.add_body(None, mass=1.0, inertia=1.0, position=(0.3, -1.0))
    scene.add_joint(Prismatic(axis=(1.0, 0.0), limits=limits), (0.0, 0.0), 0, name="elbow")
    scene.add_joint(Revolute(), 0, 1, other_anchor=(-0.3, 1.0))
    return plain(scene, **settings)


def two_stops(limits: Limits, **settings: Any) -> Simulator:
    """Return two links whose hinge has limits twice, whose order their numbers decide."""
    sim = mechanism(limits, **settings)
    sim.add_joint(Rotary(limits=Limits(lower=-0.6, upper=0.7, restitution=0.0)), 0, 1, name="other")
    return sim


NARROW = Limits(lower=-0.4, upper=0.4, restitution=0.0)
BOUNCY = Limits(lower=-0.5, upper=0.2, restitution=0.7)


@pytest.mark.parametrize("make", [mechanism, slide, two_stops])
@pytest.mark.parametrize(("old", "new"), [(WIDE, NARROW), (NARROW, BOUNCY), (BOUNCY, None)])
def test_saved_with_new_limits_it_goes_on_with_the_same_bits(
    make: Any, old: Limits, new: Limits | None, tmp_path: Path
) -> None:
    sim = make(old)
    sim.step(6)
    sim.set_limits("elbow", new)
    sim.save(tmp_path / "limited.npz")
    others = [copy.copy(sim), Simulator.restore(tmp_path / "limited.npz")]
    for one in (sim, *others):
        one.step(15)
    assert len({one.digest() for one in (sim, *others)}) == 1


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
@pytest.mark.parametrize("steps", [0, 1, 3])
@pytest.mark.parametrize("make", [crane, door, lift])
def test_saved_while_it_comes_back_it_goes_on_with_the_same_bits(
    make: Callable[[], Simulator], steps: int, tmp_path: Path
) -> None:
    """From the jump of a limit until the joint is within it, and on to where it stays."""
    sim = make()
    sim.step(5)
    sim.set_limits(sim.joints[0], Limits(upper=-0.5 if make is door else 1.0, restitution=0.0))
    sim.step(steps)
    sim.save(tmp_path / "pulled.npz")
    restored = Simulator.restore(tmp_path / "pulled.npz")
    others = [copy.deepcopy(sim), pickle.loads(pickle.dumps(sim)), restored]
    for _ in range(20):
        for one in (sim, *others):
            one.step()
        assert len({one.digest() for one in (sim, *others)}) == 1
        forces = {one.reactions.force.tobytes() for one in (sim, *others)}
        assert len(forces) == 1


@pytest.mark.parametrize("make", [mechanism, slide])
def test_limits_set_before_the_first_step_are_those_of_the_scene(make: Any) -> None:
    sim, meant = make(WIDE), make(BOUNCY)
    sim.set_limits("elbow", BOUNCY)
    for one in (sim, meant):
        one.step(30)
    assert sim.digest() == meant.digest()


def test_other_limits_wake_what_sleeps_and_the_same_ones_do_not() -> None:
    sim = crane(sleeping=True)
    for _ in range(30):
        sim.set_limits("rope", Limits(upper=2.0, restitution=0.0))
        sim.step(10)
    assert sim.asleep[0]
    sim.set_limits("rope", Limits(upper=3.0, restitution=0.0))
    sim.step(10)
    assert sim.velocity[0, 1] < -1.0


def test_what_are_no_limits_is_refused_by_name() -> None:
    sim = crane()
    hinge = {"mass": 1.0, "inertia": 1.0, "position": (5.0, 0.0)}
    other = sim.add(None, **hinge)
    sim.add_joint(Revolute(), (5.0, 0.0), other, name="hinge")
    sim.add_joint(Ratchet(pitch=0.5, restitution=0.0), (5.0, 0.0), other, name="teeth")
    sim.step()
    wrong: Any = (0.0, 1.0)
    before = sim._arrays()["digest"].tolist()
    for name, limits, says in (
        ("string", WIDE, "joint 'string': the simulator has none such"),
        ("hinge", WIDE, r"joint 'hinge' \(revolute\): it has no limits .*Limits\("),
        ("teeth", NARROW, "limits of joint 'teeth': its teeth limit a ratchet"),
        ("rope", wrong, r"limits of joint 'rope': found \(0.0, 1.0\): .*Give Limits\("),
        ("rope", Limits(restitution=0.0), "limits of joint 'rope': found none"),
        ("rope", Limits(upper=-1.0, restitution=0.0), "upper -1 m: a distance is positive"),
        ("rope", Limits(upper=math.nan, restitution=0.0), "upper of limits of joint 'rope'"),
        ("rope", Limits(upper=1.0, restitution=2.0), "restitution 2 of limits of joint 'rope'"),
        (
            "rope",
            Limits(lower=1.0, upper=2.0, restitution=0.0),
            "lower 1 of limits of joint 'rope': it has no such limit that could be set",
        ),
    ):
        with pytest.raises(InputError, match=says):
            sim.set_limits(name, limits)
    assert sim._arrays()["digest"].tolist() == before
