"""Joints with limits, maxima and break thresholds beside contacts that last: closed forms."""

import math

import numpy as np
import pytest

import tamias2d as t2
from tests.contact.test_contact_reactions import missing
from tests.contact.test_jointed_contacts import EXACT, G, floor

STOP = {"restitution": 0.0}


def words(run: t2.Run) -> set[str]:
    return set(run.joint_events.words)


@pytest.mark.parametrize("shape", [t2.Disc(radius=0.5), t2.Box(width=1.0, height=1.0)])
def test_what_slides_along_a_rail_on_the_floor_stops_at_its_end(shape: t2.Disc | t2.Box) -> None:
    """The rail bears the weight, the floor does the same: nothing brakes."""
    scene = t2.Scene(gravity=(0.0, -G))
    floor(scene, 0.5)
    scene.add_body(shape, mass=1, position=(0, 0.5), velocity=(1, 0), friction=0.5, restitution=0.0)
    limits = t2.Limits(lower=-1.0, upper=0.4, restitution=0.0)
    scene.add_joint(t2.Prismatic(axis=(1, 0), limits=limits), (0, 0.5), 1)
    run = t2.simulate(scene, duration=1.0, method=EXACT)
    np.testing.assert_allclose(run.position[-1, 1], (0.4, 0.5), atol=1e-12)
    assert run.joint_events.time[0] == pytest.approx(0.4, rel=1e-12)


def trestle(friction: float, opening: float) -> t2.Scene:
    """Two rods of 1 kg that lean on each other by .4 rad; their hinge opens as far as a limit."""
    scene = t2.Scene(gravity=(0.0, -G))
    floor(scene, friction)
    for side in (-1, 1):
        scene.add_body(
            t2.Capsule(length=1.0, radius=0.05),
            mass=1.0,
            position=(side / 2 * math.sin(0.4), 0.05 + math.cos(0.4) / 2),
            orientation=math.pi / 2 + side * 0.4,
            friction=friction,
            restitution=0.0,
        )
    hinge = t2.Revolute(limits=t2.Limits(lower=0.0, upper=opening, **STOP))
    scene.add_joint(hinge, 1, 2, at=(0.0, 0.05 + math.cos(0.4)))
    return scene


def test_a_trestle_slides_open_until_its_hinge_is_at_the_limit() -> None:
    """Then each foot bears half of the weight, and the hinge the moment of it."""
    run = t2.simulate(trestle(0.0, 1.2), duration=0.6, method=EXACT)
    np.testing.assert_allclose(np.diff(run.orientation[-1, 1:]), 1.2, atol=1e-12)
    np.testing.assert_allclose(run.velocity[-1], 0.0, atol=1e-9)
    wanted = G / 2 * math.sin(0.6)
    np.testing.assert_allclose(np.abs(run.reactions.torque[-1, 0, :2]), wanted, rtol=1e-9)
    assert run.contact_force is not None
    np.testing.assert_allclose(run.contact_force[-1, 1:], [(0.0, G)] * 2, atol=1e-9)
    assert words(run) == {"strikes its upper limit", "rests on its upper limit"}
    assert np.diff(run.energy).max() < 1e-12


def test_what_stops_a_trestle_takes_the_energy_of_its_feet_and_leaves_none() -> None:
    """Before the stop energy is kept: the height that was lost has become speed."""
    run = t2.simulate(trestle(0.0, 1.2), duration=0.6, method=EXACT)
    time = float(run.joint_events.time[0])
    near = t2.simulate(trestle(0.0, 1.2), duration=0.6, times=[time - 1e-9, time], method=EXACT)
    assert near.energy[0] == pytest.approx(run.energy[0], rel=1e-12)
    assert near.energy[1] == pytest.approx(2 * G * (0.05 + math.cos(0.6) / 2), rel=1e-12)


def test_a_see_saw_stops_with_a_box_on_it() -> None:
    """The stop bears what the box weighs, times its lever."""
    scene = t2.Scene(gravity=(0.0, -G))
    plank = t2.Box(width=3.0, height=0.1)
    scene.add_body(plank, mass=2.0, position=(0.0, 0.8), friction=0.5, restitution=0.0)
    stops = t2.Limits(lower=-0.1, upper=0.1, **STOP)
    scene.add_joint(t2.Revolute(limits=stops), (0.0, 0.8), 0, at=(0.0, 0.8))
    box = t2.Box(width=0.3, height=0.3)
    scene.add_body(box, mass=1.0, position=(-1.0, 1.0), friction=0.5, restitution=0.0)
    run = t2.simulate(scene, duration=0.5, method=EXACT)
    np.testing.assert_allclose(run.orientation[-1], 0.1, atol=1e-12)
    lever = math.cos(0.1) + 0.2 * math.sin(0.1)
    assert run.reactions.torque[-1, 0, 1] == pytest.approx(-G * lever, rel=1e-9)
    np.testing.assert_allclose(run.velocity[-1], 0.0, atol=1e-8)


def pulled(break_force: float) -> t2.Scene:
    """A box of 3 kg that a growing force pulls, and one of 2 kg behind it on a rod; they rub."""
    scene = t2.Scene(gravity=(0.0, -G))
    floor(scene, 0.2)
    box = t2.Box(width=1.0, height=0.2)
    for x, mass, force in ((0.0, 2.0, 0.0), (3.0, 3.0, "15[N] + 10[N/s]*time")):
        scene.add_body(
            box, mass=mass, position=(x, 0.1), force=(force, 0.0), friction=0.2, restitution=0.0
        )
    scene.add_joint(t2.Distance(), 1, 2, break_force=break_force)
    return scene


def test_a_rod_breaks_when_what_it_pulls_takes_too_much_with_its_friction() -> None:
    """It bears 2/5 of the force, of which 15 N + 10 N/s t; what is left behind stops by mu g."""
    run = t2.simulate(pulled(8.0), duration=1.0, method=EXACT)
    assert run.joint_events.words == ("breaks",)
    assert run.joint_events.time[0] == pytest.approx(0.5, rel=1e-12)
    speed = (15 * 0.5 + 5 * 0.5**2) / 5 - 0.2 * G * 0.5
    way = ((15 * 0.5**2 / 2 + 5 * 0.5**3 / 3) / 5 - 0.2 * G * 0.5**2 / 2, speed**2 / 0.4 / G)
    assert run.position[-1, 1, 0] == pytest.approx(sum(way), abs=1e-10)
    gained = (15 * 0.5 + 5 * (1 - 0.5**2)) / 3 - 0.2 * G * 0.5
    assert run.velocity[-1, 2, 0] == pytest.approx(speed + gained, abs=1e-10)


@pytest.mark.parametrize("most", [9.0, 10.5])
def test_a_weak_hinge_holds_what_a_ledge_bears(most: float) -> None:
    """A rod of 1 m and 2 kg with 3 kg at its end: of 49 N the hinge bears 9.81."""
    scene = t2.Scene(gravity=(0.0, -G))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=-0.1), friction=0.0, restitution=0.0)
    scene.add_body(None, mass=2.0, inertia=0.2, position=(0.5, 0.0), name="rod")
    scene.add_body(
        t2.Disc(radius=0.1), mass=3.0, position=(1.0, 0.0), friction=0.0, restitution=0.0
    )
    scene.add_joint(t2.Revolute(), (0.0, 0.0), "rod", at=(0.0, 0.0), break_force=most)
    scene.add_joint(t2.Weld(), "rod", 2, at=(1.0, 0.0))
    run = t2.simulate(scene, duration=0.1, method=EXACT)
    assert words(run) == ({"breaks"} if most < G else set())


def driven(speed: float, maximum: float, slope: float = 0.0) -> t2.Run:
    """A frame of 4 kg on two discs of 1 kg and .3 m, one of which a motor turns."""
    scene = t2.Scene(gravity=(G * math.sin(slope), -G * math.cos(slope)))
    floor(scene, 1.0)
    scene.add_body(None, mass=4.0, inertia=1.0, position=(0.0, 0.5), name="frame")
    for k, x in enumerate((-0.8, 0.8)):
        scene.add_body(
            t2.Disc(radius=0.3), mass=1.0, position=(x, 0.3), friction=1.0, restitution=0.0
        )
        motor = None if k else t2.Motor(speed=speed, maximum=maximum)
        scene.add_joint(t2.Revolute(motor=motor), "frame", 2 + k, at=(x, 0.3))
    return t2.simulate(scene, duration=1.0, method=EXACT)


def test_a_cart_is_driven_by_a_motor_that_gives_its_maximum() -> None:
    """Energy: each wheel counts as one and a half; 2.1 N m on .3 m drive 7 kg by 7 N."""
    run = driven(-5.0, 2.1)
    np.testing.assert_allclose(run.velocity[-1, 1], (1.0, 0.0), atol=1e-9)
    np.testing.assert_allclose(np.abs(run.reactions.torque[:, 0, 1]), 2.1, rtol=1e-12)


def test_a_cart_whose_motor_is_strong_goes_at_its_speed() -> None:
    """7 N drive it to 1.5 m/s in 1.5 s, 14 N in .75 s."""
    run = driven(-5.0, 4.2)
    assert run.joint_events.words[-1] == "keeps the speed of its motor"
    assert run.joint_events.time[-1] == pytest.approx(0.75, rel=1e-9)
    np.testing.assert_allclose(run.velocity[-1, 1], (1.5, 0.0), atol=1e-9)


@pytest.mark.parametrize("share", [0.98, 1.02])
def test_a_brake_holds_a_cart_on_a_slope_if_it_is_strong_enough(share: float) -> None:
    """It takes the weight along the slope times the radius."""
    run = driven(0.0, share * 6 * G * math.sin(0.1) * 0.3, 0.1)
    wanted = 0.0 if share > 1 else (1 - share) * 6 * G * math.sin(0.1) / 7
    np.testing.assert_allclose(run.velocity[-1, 1], (wanted, 0.0), atol=1e-9)


def falling_pair(seed: int) -> t2.Scene:
    """Two boxes that fall on a rough floor, with a hinge that turns by half a radian at most."""
    rng = np.random.default_rng(seed)
    scene = t2.Scene(gravity=(0.0, -G))
    floor(scene, 0.3)
    turned = rng.uniform(-0.8, 0.8)
    c, s = math.cos(turned), math.sin(turned)
    for k in range(2):
        scene.add_body(
            t2.Box(width=0.6, height=0.2),
            mass=rng.uniform(0.5, 2),
            position=(k * 0.6 * c, 0.9 + k * 0.6 * s),
            orientation=turned,
            friction=0.3,
            restitution=0.0,
        )
    limits = t2.Limits(lower=-rng.uniform(0.1, 0.5), upper=rng.uniform(0.1, 0.5), **STOP)
    scene.add_joint(t2.Revolute(limits=limits), 1, 2, at=(0.3 * c, 0.9 + 0.3 * s))
    return scene


@pytest.mark.parametrize("seed", range(3))
def test_a_pair_with_a_stop_that_falls_obeys_newton_and_its_limits(seed: int) -> None:
    scene = falling_pair(seed)
    middles = np.linspace(0.3, 1.1, 17)
    times = np.sort(np.concatenate([middles - 1e-5, middles, middles + 1e-5]))
    run = t2.simulate(scene, duration=1.2, times=times, method=EXACT)
    happened = np.concatenate([run.impacts.time, run.joint_events.time])
    met = np.abs(np.subtract.outer(run.times[1::3], happened)).min(axis=1) < 2e-5
    assert np.abs(missing(run)[~met]).max() < 1e-4
    assert np.diff(run.energy).max() < 1e-9
    limits = scene.joints[0].freedoms[0].limits
    assert limits is not None
    assert limits.lower is not None
    assert limits.upper is not None
    bent = run.orientation[:, 2] - run.orientation[:, 1]
    assert limits.lower - 1e-9 < bent.min()
    assert bent.max() < limits.upper + 1e-9
