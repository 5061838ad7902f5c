"""Worlds that are driven between steps go the way of each alone, driven likewise."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import tamias2d as t2

SURFACE: Any = {"friction": 1.0, "restitution": 0.0}
WORLDS = 4
Drive = Callable[[Any, Any], object]


def cart(world: int = 0, random: object = None) -> t2.Scene:  # noqa: ARG001
    """A box with a driven wheel on level ground, heavier from world to world, and a hook."""
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    box = t2.Box(width=2.0, height=0.4)
    scene.add_body(box, mass=40.0 + world, position=(0.0, 1.0), name="box", **SURFACE)
    wheel = t2.Disc(radius=0.4)
    for name, x in (("left", -0.5), ("right", 0.5)):
        scene.add_body(wheel, mass=10.0, position=(x, 0.4), name=name, **SURFACE)
        scene.add_joint(t2.Revolute(), "box", name, anchor=(x, -0.6), name=f"{name} axle")
    drive = t2.Rotary(motor=t2.Motor(speed=1.0, maximum=60.0))
    scene.add_joint(drive, "box", "left", name="engine")
    ball = t2.Disc(radius=0.2)
    scene.add_body(ball, mass=1.0, position=(0.0, 5.0), name="ball", **SURFACE)
    prop = t2.Distance(limits=limits(0.3, 0.6), spring=spring(1e3, 20.0))
    scene.add_body(t2.Disc(radius=0.1), mass=2.0, position=(4.0, 0.6), name="load", **SURFACE)
    scene.add_joint(prop, (4.0, 1.0), "load", name="prop")
    pull = t2.Target(spring=t2.JointSpring(stiffness=500.0, damping=30.0))
    scene.add_joint(pull, (0.0, 5.0), "ball", name="hook")
    return scene


def both(**settings: Any) -> tuple[t2.Simulators, list[t2.Simulator]]:
    """Return worlds together, and the same ones alone."""
    together = t2.Simulators(cart, worlds=WORLDS, seed=1, **settings)
    return together, [t2.Simulator(cart(world), **settings) for world in range(WORLDS)]


def check(together: t2.Simulators, alone: list[t2.Simulator]) -> None:
    for name in ("position", "velocity", "orientation", "angular_velocity", "asleep"):
        wanted = np.stack([getattr(sim, name) for sim in alone])
        np.testing.assert_array_equal(getattr(together, name), wanted, strict=True)


SPEEDS = np.array([-3.0, 0.0, 2.0, 5.0])
MOST = np.array([5.0, 60.0, 1e3, 40.0])
SHORTEST = np.array([0.3, 0.33, 0.36, 0.39])
PLACES = np.array([(0.0, 5.0), (0.5, 4.0), (-1.0, 5.5), (0.0, 5.0)])
FORCES = np.arange(24.0).reshape(WORLDS, 3, 2) - 9.0
THREE = ["ball", "box", "left"]


def motor(speed: Any, maximum: Any = None) -> t2.Motor:
    return t2.Motor(speed=speed, maximum=maximum)


def limits(lower: Any = None, upper: Any = None) -> t2.Limits:
    return t2.Limits(restitution=0.0, lower=lower, upper=upper)


def spring(
    stiffness: Any, damping: Any = 0.0, rest: Any = None, maximum: Any = None
) -> t2.JointSpring:
    return t2.JointSpring(stiffness=stiffness, damping=damping, rest=rest, maximum=maximum)


DRIVES: dict[str, tuple[Drive, Drive]] = {
    "motors": (
        lambda sims, _: sims.set_motor("engine", SPEEDS, maximum=MOST),
        lambda sim, w: sim.set_motor("engine", motor(SPEEDS[w], MOST[w])),
    ),
    "one motor": (
        lambda sims, _: sims.set_motor("engine", 2, maximum=9),
        lambda sim, _: sim.set_motor("engine", motor(2.0, 9.0)),
    ),
    "without a maximum": (
        lambda sims, _: sims.set_motor("engine", SPEEDS.tolist()),
        lambda sim, w: sim.set_motor("engine", motor(SPEEDS[w])),
    ),
    "motors off": (
        lambda sims, _: sims.set_motor("engine", None),
        lambda sim, _: sim.set_motor("engine", None),
    ),
    "limits": (
        lambda sims, _: sims.set_limits("prop", lower=SHORTEST, upper=0.55, restitution=0.0),
        lambda sim, w: sim.set_limits("prop", limits(lower=SHORTEST[w], upper=0.55)),
    ),
    "one limit": (
        lambda sims, _: sims.set_limits("prop", upper=0.41, restitution=np.zeros(WORLDS)),
        lambda sim, _: sim.set_limits("prop", limits(upper=0.41)),
    ),
    "limits off": (
        lambda sims, _: sims.set_limits("prop", restitution=0.0),
        lambda sim, _: sim.set_limits("prop", None),
    ),
    "springs": (
        lambda sims, _: sims.set_spring("prop", 10 * MOST, damping=9, rest=SHORTEST),
        lambda sim, w: sim.set_spring("prop", spring(10 * MOST[w], 9.0, SHORTEST[w])),
    ),
    "springs with a maximum": (
        lambda sims, _: sims.set_spring("prop", 10 * MOST, damping=9, maximum=MOST),
        lambda sim, w: sim.set_spring("prop", spring(10 * MOST[w], 9.0, maximum=MOST[w])),
    ),
    "one spring": (
        lambda sims, _: sims.set_spring("prop", 2e3),
        lambda sim, _: sim.set_spring("prop", spring(2e3)),
    ),
    "springs off": (
        lambda sims, _: sims.set_spring("prop", None),
        lambda sim, _: sim.set_spring("prop", None),
    ),
    "targets": (
        lambda sims, _: sims.set_target("hook", PLACES),
        lambda sim, w: sim.set_target("hook", PLACES[w]),
    ),
    "one target": (
        lambda sims, _: sims.set_target("hook", (1, 4)),
        lambda sim, _: sim.set_target("hook", (1.0, 4.0)),
    ),
    "forces": (
        lambda sims, _: sims.apply_force(THREE, FORCES, at=(0.0, 1.0)),
        lambda sim, w: sim.apply_force(THREE, FORCES[w], at=(0.0, 1.0)),
    ),
    "forces on one": (
        lambda sims, _: sims.apply_force("ball", FORCES[:, 0], at=PLACES),
        lambda sim, w: sim.apply_force("ball", FORCES[w, 0], at=PLACES[w]),
    ),
    "impulses": (
        lambda sims, _: sims.apply_impulse(THREE, FORCES[0]),
        lambda sim, _: sim.apply_impulse(THREE, FORCES[0]),
    ),
    "one impulse": (
        lambda sims, _: sims.apply_impulse(THREE, (1.0, 2.0), at=FORCES),
        lambda sim, w: sim.apply_impulse(THREE, (1.0, 2.0), at=FORCES[w]),
    ),
}


@pytest.mark.parametrize("name", DRIVES)
def test_worlds_are_driven_as_each_alone(name: str) -> None:
    together, alone = both()
    drive, drive_one = DRIVES[name]
    together.step(3)
    before = together.position.copy()
    for one in alone:
        one.step(3)
    for _ in range(3):
        drive(together, None)
        together.step(2)
        for world, sim in enumerate(alone):
            drive_one(sim, world)
            sim.step(2)
        check(together, alone)
    assert (together.position != before).any()
    assert together.world(2).digest() == alone[2].digest()


def test_a_reset_brings_the_drives_of_the_start_back() -> None:
    together, alone = both()
    together.step(20)
    first = together.world(3).digest()
    together.set_motor("engine", SPEEDS)
    together.set_target("hook", PLACES + 1.0)
    together.set_limits("prop", upper=0.5, restitution=1.0)
    together.set_spring("prop", 10.0)
    together.apply_force("ball", (9.0, 9.0))
    together.step(5)
    together.reset()
    together.step(20)
    assert together.world(3).digest() == first
    for sim in alone:
        sim.step(20)
    check(together, alone)


def test_what_sleeps_wakes_where_its_motor_is_another_one() -> None:
    together, _ = both(sleeping=True)
    together.set_motor("engine", 0.0, maximum=60.0)
    together.step(400)
    car = [together.index(name) for name in ("box", "left", "right")]
    assert together.asleep[:, car].all()
    together.set_motor("engine", [0.0, 1.0, 0.0, -1.0], maximum=60.0)
    together.step(5)
    assert together.asleep[:, car].any(axis=1).tolist() == [True, False, True, False]


def two_kinds(world: int, random: object) -> t2.Scene:  # noqa: ARG001
    """A joint that has a motor in the first world alone."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, inertia=1.0, position=(0.0, 0.0), name="wheel")
    kind = t2.Revolute(motor=motor(1.0)) if world == 0 else t2.Revolute()
    scene.add_joint(kind, (0.0, 0.0), "wheel", name="axle")
    return scene


BAD: list[tuple[Callable[[t2.Simulators], object], str]] = [
    (lambda s: s.set_motor("motor", 1.0), "world 0: joint 'motor': the simulator has none such"),
    (lambda s: s.set_motor("hook", 1.0), r"world 0: joint 'hook' \(target\): it has no motor"),
    (
        lambda s: s.set_motor("engine", [1.0, 2.0]),
        r"speed of the worlds: .* \(2,\): .*for 4 worlds",
    ),
    (lambda s: s.set_motor("engine", "fast"), "speed of the worlds: found 'fast'"),
    (lambda s: s.set_motor("engine", [0, 0, 0, np.nan]), "world 3: speed of motor of joint 'eng"),
    (lambda s: s.set_motor("engine", 1.0, maximum=[9, 0, 9, 9]), r"world 1: maximum 0 N\*m of mot"),
    (
        lambda s: s.set_limits("hook", upper=1.0, restitution=0.0),
        r"world 0: joint 'hook' \(target\): it has no limits",
    ),
    (lambda s: s.set_limits("prop", upper=1.0, restitution=[0, 0, 2, 0]), "world 2: restitution"),
    (
        lambda s: s.set_limits("prop", lower=[0.1, 0.9, 0, 0], upper=0.8, restitution=0.0),
        "world 1: limits? of joint 'prop'",
    ),
    (
        lambda s: s.set_spring("engine", 1.0),
        r"world 0: joint 'engine' \(rotary\): it has no spring",
    ),
    (lambda s: s.set_limits("prop", upper=1.0, restitution=None), "world 0: restitution of limits"),
    (lambda s: s.set_spring("prop", [1, 1, 1, -1]), "world 3: stiffness"),
    (
        lambda s: s.set_spring("prop", 1.0, damping=None),
        "world 0: damping of spring .*: found None",
    ),
    (lambda s: s.set_spring("prop", 1.0, rest="long"), "rest of the worlds: found 'long'"),
    (lambda s: s.set_target("engine", (0, 0)), r"world 0: joint 'engine' \(rotary\): it holds no"),
    (lambda s: s.set_target("hook", 3.0), r"point of the worlds: found an array of shape \(\)"),
    (lambda s: s.set_target("hook", [(0, 0)] * 3 + [(1e99, 0)]), r"world 3: point \(1e\+99,"),
    (
        lambda s: s.apply_force("cat", (0, 0)),
        "body 'cat': the simulator has none such|bodies: found",
    ),
    (lambda s: s.apply_force("ball", [(0, 0)]), r"force of the worlds: .*\(1, 2\): .*\(4, 2\)"),
    (
        lambda s: s.apply_force([1, 2], np.zeros((4, 2))),
        r"of shape \(2,\) or \(2, 2\) or \(4, 2, 2\)",
    ),
    (lambda s: s.apply_impulse([1, 2], [(0, 0), (0, np.inf)]), r"impulse\[1\]\[1\] of the worlds"),
    (lambda s: s.apply_impulse(1, (0, 1), at="top"), "at of the worlds: found <U3"),
]


@pytest.mark.parametrize(("call", "says"), BAD)
def test_what_cannot_be_driven_is_refused_and_nothing_is_set(
    call: Callable[[t2.Simulators], object], says: str
) -> None:
    together, alone = both()
    with pytest.raises(t2.InputError, match=says):
        call(together)
    together.step(3)
    for sim in alone:
        sim.step(3)
    check(together, alone)


def test_worlds_whose_joints_differ_are_told_by_their_number() -> None:
    together = t2.Simulators(two_kinds, worlds=2, seed=1)
    with pytest.raises(t2.InputError, match=r"world 1: joint 'axle' \(revolute\): it has no motor"):
        together.set_motor("axle", 3.0)
    together.step(60)
    assert together.angular_velocity[0, 0] == pytest.approx(1.0)
