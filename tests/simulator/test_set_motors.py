"""A motor that gets another speed and maximum between steps, as by a throttle or a button.

Expected values come from constant torques on known inertias, and from what is the same.
"""

import copy
import math
from pathlib import Path
from typing import Any

import pytest

from tamias2d import (
    Box,
    Disc,
    HalfPlane,
    InputError,
    JointSpring,
    Limits,
    Motor,
    Prismatic,
    Revolute,
    Rotary,
    Scene,
    Simulator,
    Wheel,
)
from tests.engine.scenes import plain


def wheel_on_an_axle(motor: Motor, **settings: Any) -> Simulator:
    """Return a body of 2 kg m^2 that a motor, "drive", turns about the origin."""
    scene = Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, inertia=2.0, position=(0.0, 0.0), name="wheel")
    scene.add_joint(Revolute(motor=motor), (0.0, 0.0), "wheel", name="drive")
    return plain(scene, **settings)


def car(motor: Motor, **settings: Any) -> Simulator:
    """Return a box with a sprung wheel on level ground; "engine" drives the wheel."""
    surface = {"friction": 1.0, "restitution": 0.0}
    scene = Scene(gravity=(0.0, -10.0))
    scene.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    scene.add_body(Box(width=2.0, height=0.4), mass=50.0, position=(0.0, 1.0), **surface)
    scene.add_body(Disc(radius=0.4), mass=10.0, position=(-0.5, 0.4), **surface)
    scene.add_body(Disc(radius=0.4), mass=10.0, position=(0.5, 0.4), **surface)
    suspension = Wheel(axis=(0.0, 1.0), spring=JointSpring(stiffness=4e3, damping=400.0))
    for wheel, x in ((2, -0.5), (3, 0.5)):
        scene.add_joint(suspension, 1, wheel, anchor=(x, 0.0))
    scene.add_joint(Rotary(motor=motor), 1, 2, name="engine")
    return plain(scene, **settings)


def test_a_motor_goes_over_to_its_new_speed_with_its_new_maximum() -> None:
    """4 N m on 2 kg m^2 is 2 rad/s^2, 1 N m half of that; without a maximum it is there at once."""
    sim = wheel_on_an_axle(Motor(speed=3.0, maximum=4.0))
    sim.step(60)
    assert sim.angular_velocity[0] == pytest.approx(2.0, rel=1e-12)
    sim.set_motor("drive", Motor(speed=-3.0, maximum=4.0))
    sim.step(60)
    assert sim.angular_velocity[0] == pytest.approx(0.0, abs=1e-12)
    sim.step(120)
    assert sim.angular_velocity[0] == pytest.approx(-3.0, rel=1e-12)
    sim.set_motor("drive", Motor(speed=0.0, maximum=1.0))
    sim.step(120)
    assert sim.angular_velocity[0] == pytest.approx(-2.0, rel=1e-12)
    sim.set_motor("drive", Motor(speed=5.0))
    sim.step()
    assert sim.angular_velocity[0] == pytest.approx(5.0, rel=1e-12)


def test_a_motor_that_is_off_gives_nothing() -> None:
    sim = wheel_on_an_axle(Motor(speed=3.0))
    sim.step(2)
    sim.set_motor("drive", None)
    sim.step(60)
    assert sim.angular_velocity[0] == pytest.approx(3.0, rel=1e-12)
    sim.torque[0] = 2.0
    sim.step(60)
    assert sim.angular_velocity[0] == pytest.approx(4.0, rel=1e-12)
    sim.torque[0] = 0.0
    sim.set_motor("drive", Motor(speed=-1.0, maximum=2.0))
    sim.step(60)
    assert sim.angular_velocity[0] == pytest.approx(3.0, rel=1e-12)


def test_a_flipper_strikes_and_falls_back() -> None:
    """A bat between two stops, which a strong motor turns up while a button is held."""
    scene = Scene(gravity=(0.0, -9.81))
    bat = scene.add_body(Box(width=1.0, height=0.2), mass=1.0, position=(0.5, 0.0), restitution=0.0)
    stops = Limits(lower=-0.5, upper=0.5, restitution=0.0)
    flipper = Revolute(limits=stops, motor=Motor(speed=-20.0, maximum=60.0))
    scene.add_joint(flipper, (0.0, 0.0), bat, other_anchor=(-0.5, 0.0), name="flipper")
    sim = plain(scene)
    for speed in (-20.0, 20.0) * 3:
        sim.set_motor("flipper", Motor(speed=speed, maximum=60.0))
        sim.step(20)
        assert sim.orientation[bat] == pytest.approx(math.copysign(0.5, speed), abs=1e-3)


def test_a_car_is_driven_stopped_and_driven_back() -> None:
    """The wheel turns against the box as it is told, and rolls; with its motor off it rolls on."""
    sim = car(Motor(speed=0.0, maximum=300.0))
    for speed in (-5.0, 5.0):
        sim.set_motor("engine", Motor(speed=speed, maximum=300.0))
        sim.step(150)
        spin = sim.angular_velocity[2]
        assert spin - sim.angular_velocity[1] == pytest.approx(speed, abs=1e-6)
        assert sim.velocity[2, 0] == pytest.approx(-0.4 * spin, abs=0.02)
    sim.set_motor("engine", None)
    before = sim.velocity[1:, 0] @ sim.mass[1:]
    sim.step(30)
    after = sim.velocity[1:, 0] @ sim.mass[1:]
    assert after == pytest.approx(before, rel=0.05)


def slide(motor: Motor) -> Simulator:
    """Return a body on a rail with a pendulum: no tree of hinges, so it is solved by factors."""
    scene = Scene(gravity=(0.0, -10.0))
    scene.add_body(Box(width=0.4, height=0.2), mass=2.0, position=(0.0, 0.0), restitution=0.0)
    scene.add_body(Disc(radius=0.1), mass=1.0, position=(0.3, -1.0), restitution=0.0)
    scene.add_joint(Prismatic(axis=(1.0, 0.0), motor=motor), (0.0, 0.0), 0, name="engine")
    scene.add_joint(Revolute(), 0, 1, other_anchor=(-0.3, 1.0))
    return plain(scene)


def two_motors(motor: Motor) -> Simulator:
    """Return a car whose wheel has two motors, whose order their numbers decide."""
    sim = car(motor)
    sim.add_joint(Rotary(motor=Motor(speed=2.0, maximum=3.0)), 1, 2, name="other engine")
    return sim


@pytest.mark.parametrize("make", [car, slide, two_motors])
@pytest.mark.parametrize("old", [Motor(speed=0.0, maximum=60.0), Motor(speed=-4.0)], ids=str)
@pytest.mark.parametrize("new", [Motor(speed=6.0, maximum=40.0), Motor(speed=0.0), None], ids=str)
def test_saved_with_a_new_motor_it_goes_on_with_the_same_bits(
    make: Any, old: Motor, new: Motor | None, tmp_path: Path
) -> None:
    sim = make(old)
    sim.step(10)
    sim.set_motor("engine", new)
    sim.save(tmp_path / "driven.npz")
    others = [copy.copy(sim), Simulator.restore(tmp_path / "driven.npz", compiled=False)]
    for one in (sim, *others):
        one.step(15)
    assert len({one.digest() for one in (sim, *others)}) == 1


def test_a_motor_set_before_the_first_step_is_that_of_the_scene() -> None:
    sim, meant = (car(Motor(speed=speed, maximum=60.0)) for speed in (1.0, -3.0))
    sim.set_motor("engine", Motor(speed=-3.0, maximum=60.0))
    for one in (sim, meant):
        one.step(30)
    assert sim.digest() == meant.digest()


def test_another_motor_wakes_what_sleeps_and_the_same_one_does_not() -> None:
    sim = car(Motor(speed=0.0, maximum=60.0), sleeping=True)
    for _ in range(40):
        sim.set_motor("engine", Motor(speed=0.0, maximum=60.0))
        sim.step(10)
    assert sim.asleep[1:].all()
    sim.set_motor("engine", Motor(speed=-3.0, maximum=60.0))
    sim.step(60)
    assert not sim.asleep[1:].any()
    assert sim.velocity[1, 0] > 0.3


def test_what_is_no_motor_is_refused_by_name() -> None:
    sim = car(Motor(speed=0.0, maximum=60.0))
    wrong: Any = 3.0
    before = sim.digest()
    with pytest.raises(InputError, match="joint 'motor': the simulator has none such"):
        sim.set_motor("motor", Motor(speed=1.0))
    with pytest.raises(InputError, match=r"joint 'joint0' \(wheel\): it has no motor .*Motor\("):
        sim.set_motor("joint0", Motor(speed=1.0))
    with pytest.raises(InputError, match=r"motor of joint 'engine': found 3.0: .*Give Motor\("):
        sim.set_motor("engine", wrong)
    with pytest.raises(InputError, match=r"maximum 0 N\*m of motor of joint 'engine': must be > 0"):
        sim.set_motor("engine", Motor(speed=1.0, maximum=0.0))
    with pytest.raises(InputError, match=r"speed of motor of joint 'engine': found nan"):
        sim.set_motor("engine", Motor(speed=math.nan))
    assert sim.digest() == before


@pytest.mark.parametrize("height", [0.4085, 0.4087, 0.409])
def test_a_wheel_that_lands_at_the_end_of_a_step_gets_no_more_than_the_maximum(
    height: float,
) -> None:
    """Friction brakes the wheel after joints were solved: its motor does not make up for that."""
    surface = {"friction": 1.0, "restitution": 0.0}
    scene = Scene(gravity=(0.0, -10.0))
    scene.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    place: Any = {"position": (0.0, height), "velocity": (0.0, -1.0)}
    scene.add_body(Disc(radius=0.4), mass=3.0, angular_velocity=-15.0, **place, **surface)
    scene.add_body(None, mass=10.0, inertia=3.0, **place)
    scene.add_joint(Revolute(), 2, 1)
    scene.add_joint(Rotary(motor=Motor(speed=-15.0, maximum=5.0)), 2, 1, name="motor")
    sim = plain(scene, time_step=1 / 240)
    for _ in range(12):
        before = sim.angular_velocity[2]
        sim.step()
        assert abs(3.0 * (sim.angular_velocity[2] - before) * 240) <= 5.0 * (1 + 1e-9)
        assert abs(sim.reactions.torque[1, 1]) <= 5.0 * (1 + 1e-9)


def test_a_piston_that_drives_a_crate_into_a_wall_gives_no_more_than_its_maximum() -> None:
    """The crate reaches the wall at the end of a step, and the piston the crate in the next one."""
    surface = {"friction": 0.0, "restitution": 0.5}
    scene = Scene(gravity=(0.0, 0.0))
    scene.add_static(HalfPlane(normal=(-1.0, 0.0), offset=-5.0), **surface)
    for width, height, x in ((0.4, 0.8, 4.187466973610554), (0.6, 0.6, 4.687482767821861)):
        box, place = Box(width=width, height=height), (x, 0.0)
        scene.add_body(box, mass=2.0, position=place, velocity=(3.00046, 0.0), **surface)
    drive = Prismatic(axis=(1.0, 0.0), motor=Motor(speed=3.0, maximum=5.0))
    scene.add_joint(drive, (4.187466973610554, 0.0), 1)
    sim = plain(scene, time_step=1 / 240)
    for _ in range(24):
        sim.step()
        assert abs(sim.reactions.force[0, 1, 0]) <= 5.0 * (1 + 1e-9)


def test_what_a_motor_puts_in_is_told() -> None:
    """One lifts 2 kg against 10 m/s^2 at 0.5 m/s, one turns an inertia: torque times speed."""
    scene = Scene(gravity=(0.0, -10.0))
    scene.add_body(None, mass=2.0, inertia=1.0, position=(0.0, 0.0))
    lift = Prismatic(axis=(0.0, 1.0), motor=Motor(speed=0.5))
    scene.add_joint(lift, (0.0, 0.0), 0, name="lift")
    scene.add_body(None, mass=1.0, inertia=2.0, position=(5.0, 0.0))
    drive = Revolute(motor=Motor(speed=9.0, maximum=4.0))
    scene.add_joint(drive, (5.0, 0.0), 1, name="drive")
    sim = plain(scene)
    sim.step(30)
    told = sim.reactions
    assert told.speed == pytest.approx([0.5, 1.0], rel=1e-9)  # 4 / 2 rad/s^2 for 0.5 s
    assert told.power == pytest.approx([10.0, 4.0], rel=1e-8)
    assert copy.deepcopy(sim).reactions.power == pytest.approx(told.power, rel=1e-12)


@pytest.mark.parametrize("speed", [-0.05, 0.001, 0.03])
def test_a_slow_motor_does_not_fall_asleep(speed: float) -> None:
    sim = Simulator(Scene(gravity=(0.0, -9.81)), sleeping=True)
    hand = sim.add(Box(width=1.0, height=0.1), mass=1.0, position=(0.0, 0.0), restitution=0.0)
    sim.add_joint(Revolute(motor=Motor(speed=speed)), (0.0, 0.0), int(hand))
    sim.step(1200)
    assert sim.orientation[hand] == pytest.approx(20 * speed, rel=1e-9)


def test_a_motor_that_gives_all_it_can_and_stands_falls_asleep() -> None:
    sim = Simulator(Scene(gravity=(0.0, -9.81)), sleeping=True)
    arm = sim.add(Box(width=1.0, height=0.1), mass=1.0, position=(0.5, 0.0), restitution=0.0)
    stop = Limits(lower=0.0, upper=1.0, restitution=0.0)
    weak = Revolute(motor=Motor(speed=1.0, maximum=1.0), limits=stop)
    sim.add_joint(weak, (0.0, 0.0), int(arm), other_anchor=(-0.5, 0.0))
    sim.step(120)
    assert sim.asleep[arm]


def arm_at_a_stop(maximum: float | None, *, shape: bool = True, gravity: float = 9.81) -> Simulator:
    """A motor that leans on a stop, half a radian up."""
    sim = Simulator(Scene(gravity=(0.0, -gravity)), sleeping=True)
    arm: dict[str, Any] = {"mass": 1.0, "position": (0.5, 0.0)}
    if shape:
        sim.add(Box(width=1.0, height=0.1), restitution=0.0, **arm)
    else:
        sim.add(None, inertia=0.1, **arm)
    stop = Limits(lower=-0.5, upper=0.5, restitution=0.0)
    leaning = Revolute(motor=Motor(speed=2.0, maximum=maximum), limits=stop)
    sim.add_joint(leaning, (0.0, 0.0), 0, other_anchor=(-0.5, 0.0), name="hinge")
    return sim


@pytest.mark.parametrize("gravity", [0.0, 9.81])
@pytest.mark.parametrize("shape", [False, True])
@pytest.mark.parametrize("maximum", [None, 20.0])
def test_a_motor_that_leans_on_a_limit_falls_asleep_there(
    maximum: float | None, shape: bool, gravity: float
) -> None:
    sim = arm_at_a_stop(maximum, shape=shape, gravity=gravity)
    sim.step(120)
    assert sim.asleep[0]
    assert sim.orientation[0] == pytest.approx(0.5, abs=1e-3)
    sim.step(120)
    assert sim.asleep[0]


@pytest.mark.parametrize("restitution", [0.0, 0.5])
@pytest.mark.parametrize("speed", [0.5, 2.0, 100.0])
def test_a_motor_without_a_maximum_goes_no_further_than_a_limit(
    speed: float, restitution: float
) -> None:
    """It was taken as far beyond as it goes in some substeps, with half of its speed."""
    sim = Simulator(Scene(gravity=(0.0, -9.81)))
    sim.add(Box(width=1.0, height=0.1), mass=1.0, position=(0.5, 0.0), restitution=0.0)
    stop = Limits(lower=-0.5, upper=0.5, restitution=restitution)
    leaning = Revolute(motor=Motor(speed=speed), limits=stop)
    sim.add_joint(leaning, (0.0, 0.0), 0, other_anchor=(-0.5, 0.0), name="hinge")
    sim.step(240)
    assert sim.orientation[0] == pytest.approx(0.5, abs=1e-9)
    assert sim.angular_velocity[0] == pytest.approx(0.0, abs=1e-8)  # as firm as a row is
    assert sim.reactions.limit[0] == 1
    sim.set_motor("hinge", Motor(speed=-speed))
    sim.step(240)
    assert sim.orientation[0] == pytest.approx(-0.5, abs=1e-8)


@pytest.mark.parametrize("waking", ["motor", "limits", "torque", "contact", "wake"])
@pytest.mark.parametrize("maximum", [None, 20.0])
def test_what_leans_wakes(maximum: float | None, waking: str) -> None:
    sim = arm_at_a_stop(maximum)
    sim.step(120)
    assert sim.asleep[0]
    if waking == "motor":
        sim.set_motor("hinge", Motor(speed=-2.0, maximum=maximum))
    elif waking == "limits":
        sim.set_limits("hinge", Limits(lower=-0.5, upper=0.8, restitution=0.0))
    elif waking == "torque":
        sim.torque[0] = -1.0
    elif waking == "wake":
        sim.wake(0)
    else:
        place = (0.8, 0.6)
        sim.add(Box(width=0.1, height=0.1), mass=1.0, position=place, restitution=0.0, friction=0.5)
    woken = False
    for _ in range(60):
        sim.step()
        woken |= not sim.asleep[0]
    assert woken
    there = {"motor": -0.5, "limits": 0.8}.get(waking, 0.5)
    assert sim.orientation[0] == pytest.approx(there, abs=1e-2)


@pytest.mark.parametrize("maximum", [1e-3, 1e-2])
def test_a_wheel_that_a_weak_motor_turns_does_not_fall_asleep(maximum: float) -> None:
    """It is slow for a second, as the motor gives all that it can."""
    sim = Simulator(Scene(gravity=(0.0, -9.81)), sleeping=True)
    sim.add(Box(width=1.0, height=1.0), mass=6.0, position=(0.0, 0.0), restitution=0.0)
    sim.add_joint(Revolute(motor=Motor(speed=9.0, maximum=maximum)), (0.0, 0.0), 0)
    sim.step(240)
    assert sim.angular_velocity[0] == pytest.approx(4 * maximum, rel=1e-9)  # 1 kg m^2
