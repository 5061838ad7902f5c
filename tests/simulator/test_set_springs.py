"""Springs of joints that get another stiffness, damping or rest between steps.

Expected values come from oscillations in closed form, from weights in equilibrium, and from what is
the same.
"""

import copy
import math
from pathlib import Path
from typing import Any

import pytest

from tamias2d import (
    Box,
    Disc,
    Distance,
    InputError,
    JointSpring,
    Limits,
    Revolute,
    Rotary,
    Scene,
    Simulator,
    StepWarning,
    Target,
    Wheel,
)
from tests.engine.scenes import plain

G = 10.0
SPRING = JointSpring(stiffness=8.0, rest=0.0)


def balance(spring: JointSpring = SPRING, **settings: Any) -> Simulator:
    """Return a wheel of 2 kg m^2 on a sprung axle, "coil", which turns at 1 rad/s."""
    scene = Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, inertia=2.0, position=(0.0, 0.0), angular_velocity=1.0)
    scene.add_joint(Revolute(spring=spring), (0.0, 0.0), 0, name="coil")
    return plain(scene, time_step=1 / 240, **settings)


def energy(sim: Simulator, stiffness: float, rest: float) -> float:
    turned: float = sim.orientation[0] - rest
    return float(sim.angular_velocity[0] ** 2 + stiffness * turned**2 / 2)


@pytest.mark.parametrize("stiffness", [2.0, 32.0, 200.0])
def test_it_swings_at_its_new_rate(stiffness: float) -> None:
    """Amplitude and phase go over; a step of 1/240 s shows the rate to its square."""
    sim = balance()
    sim.step(60)
    sim.set_spring("coil", JointSpring(stiffness=stiffness))
    rate = math.sqrt(stiffness / 2.0)
    phase = math.atan2(rate * sim.orientation[0], sim.angular_velocity[0])
    size = math.hypot(sim.orientation[0], sim.angular_velocity[0] / rate)
    had = energy(sim, stiffness, 0.0)
    sim.step(100)
    now = size * math.sin(phase + rate * 100 / 240)
    assert sim.orientation[0] == pytest.approx(now, abs=1e-5 * size * rate)
    assert energy(sim, stiffness, 0.0) == pytest.approx(had, rel=1e-9)


def test_it_swings_about_its_new_rest_and_settles_there() -> None:
    sim = balance()
    sim.step(60)
    sim.set_spring("coil", JointSpring(stiffness=8.0, rest=1.0))
    had = energy(sim, 8.0, 1.0)
    sim.step(200)
    assert energy(sim, 8.0, 1.0) == pytest.approx(had, rel=1e-9)
    sim.set_spring("coil", JointSpring(stiffness=8.0, damping=8.0))  # critical, the same rest
    sim.step(1200)
    assert sim.orientation[0] == pytest.approx(1.0, abs=1e-3)


def test_a_spring_that_is_off_pulls_nothing() -> None:
    sim = balance()
    sim.set_spring("coil", None)
    sim.step(240)
    assert sim.angular_velocity[0] == pytest.approx(1.0, abs=1e-12)
    sim.set_spring("coil", JointSpring(stiffness=8.0, damping=8.0))
    sim.step(1200)
    assert sim.orientation[0] == pytest.approx(0.0, abs=1e-3)


@pytest.mark.parametrize("kind", [Target, Distance], ids=lambda kind: kind.__name__)
def test_a_weight_hangs_lower_on_a_softer_spring(kind: Any) -> None:
    scene = Scene(gravity=(0.0, -G))
    spring = JointSpring(stiffness=2000.0, damping=100.0)
    scene.add_body(Box(width=1.0, height=1.0), mass=2.0, position=(0.0, -1.0))
    at = (0.0, -1.0) if kind is Target else (0.0, 0.0)
    scene.add_joint(kind(spring=spring), at, 0, name="hook")
    sim = plain(scene)
    for stiffness in (2000.0, 500.0):
        sim.set_spring("hook", JointSpring(stiffness=stiffness, damping=100.0))
        sim.step(240)
        assert sim.position[0, 1] == pytest.approx(-1.0 - 2.0 * G / stiffness, abs=1e-5)


def test_a_suspension_gives_way_and_rises() -> None:
    scene = Scene(gravity=(0.0, -G))
    scene.add_body(Box(width=1.0, height=0.2), mass=50.0, position=(0.0, 1.0))
    scene.add_joint(Rotary(limits=Limits(lower=-0.1, upper=0.1, restitution=0.0)), (0.0, 0.0), 0)
    spring = JointSpring(stiffness=4e3, damping=400.0)
    scene.add_joint(Wheel(axis=(0.0, 1.0), spring=spring), (0.0, 1.0), 0, name="suspension")
    sim = plain(scene)
    for stiffness, rest in ((4e3, None), (1e3, None), (1e3, 0.3)):
        new = JointSpring(stiffness=stiffness, damping=400.0, rest=rest)
        sim.set_spring("suspension", new)
        sim.step(240)
        height = 1.0 + (rest or 0.0) - 50.0 * G / stiffness
        assert sim.position[0, 1] == pytest.approx(height, abs=1e-4)


def limb(count: int, **settings: Any) -> Simulator:
    """Return so many equal arms of two links with sprung elbows, beside each other."""
    scene = Scene(gravity=(0.0, -G))
    for k in range(count):
        for m in range(2):
            place = (10.0 * k + m + 0.5, 0.0)
            scene.add_body(Box(width=1.0, height=0.1), mass=1.0, position=place, group=-1)
            upper: Any = (10.0 * k, 0.0) if m == 0 else 2 * k
            ends: Any = {"anchor": (0.5 * m, 0.0), "other_anchor": (-0.5, 0.0)}
            kind = Revolute(spring=JointSpring(stiffness=20.0, damping=1.0)) if m else Revolute()
            scene.add_joint(kind, upper, 2 * k + m, **ends, name=f"joint {k} {m}")
    return plain(scene, **settings)


def test_one_of_equal_trees_has_its_spring_alone() -> None:
    """Eight trees are solved side by side, each as it would be alone."""
    many, alone = limb(8), limb(1)
    for sim in (many, alone):
        sim.step(4)
        sim.set_spring("joint 0 1", JointSpring(stiffness=90.0, damping=0.3, rest=0.5))
        sim.step(12)
    assert many.position[:2].tolist() == alone.position[:2].tolist()
    assert many.position[2].tolist() != [*(alone.position[0] + (10.0, 0.0))]


def two_coils(**settings: Any) -> Simulator:
    """Return a wheel with two springs, whose order their numbers decide."""
    sim = balance(**settings)
    other = Rotary(spring=JointSpring(stiffness=9.0, rest=0.2))
    sim.add_joint(other, (0.0, 0.0), 0, name="other")
    return sim


@pytest.mark.parametrize(
    ("make", "name"), [(balance, "coil"), (two_coils, "coil"), (lambda: limb(8), "joint 3 1")]
)
@pytest.mark.parametrize("new", [JointSpring(stiffness=50.0, damping=0.5, rest=0.3), None], ids=str)
def test_saved_with_a_new_spring_it_goes_on_with_the_same_bits(
    make: Any, name: str, new: JointSpring | None, tmp_path: Path
) -> None:
    sim = make()
    sim.step(6)
    sim.set_spring(name, new)
    sim.save(tmp_path / "sprung.npz")
    others = [copy.copy(sim), Simulator.restore(tmp_path / "sprung.npz")]
    for one in (sim, *others):
        one.step(12)
    assert len({one.digest() for one in (sim, *others)}) == 1


def test_a_spring_set_before_the_first_step_is_that_of_the_scene() -> None:
    new = JointSpring(stiffness=3.0, damping=0.2, rest=0.1)
    sim, meant = balance(), balance(new)
    sim.set_spring("coil", new)
    for one in (sim, meant):
        one.step(30)
    assert sim.digest() == meant.digest()


def test_another_spring_wakes_what_sleeps_and_the_same_one_does_not() -> None:
    scene = Scene(gravity=(0.0, -G))
    scene.add_body(Disc(radius=0.5), mass=1.0, position=(0.0, 0.0))
    hung = JointSpring(stiffness=100.0, damping=20.0)
    scene.add_joint(Target(spring=hung), (0.0, 0.0), 0, name="hook")
    sim = Simulator(scene, sleeping=True)
    for _ in range(60):
        sim.set_spring("hook", hung)
        sim.step(10)
    assert sim.asleep[0]
    sim.set_spring("hook", JointSpring(stiffness=50.0, damping=20.0))
    sim.step(10)
    assert sim.velocity[0, 1] < -0.1


def test_a_spring_that_is_too_stiff_is_told() -> None:
    sim = balance()
    with pytest.warns(StepWarning, match=r"joint 'coil' \(revolute\): its spring of stiffness"):
        sim.set_spring("coil", JointSpring(stiffness=1e17))


def test_what_is_no_spring_is_refused_by_name() -> None:
    sim = balance()
    body = sim.add(None, mass=1.0, position=(3.0, 0.0))
    sim.add_joint(Target(spring=SPRING), (3.0, 0.0), body, name="mouse")
    sim.add_joint(Distance(), (5.0, 0.0), body, name="rod")
    sim.step()
    wrong: Any = 3.0
    before = sim._arrays()["digest"].tolist()
    for name, spring, says in (
        ("spring", SPRING, "joint 'spring': the simulator has none such"),
        ("rod", SPRING, r"joint 'rod' \(distance\): it has no spring .*JointSpring\("),
        ("coil", wrong, r"spring of joint 'coil': found 3.0: .*Give JointSpring\("),
        ("coil", JointSpring(stiffness=0.0), r"stiffness 0 N\*m/rad of spring of joint 'coil'"),
        ("coil", JointSpring(stiffness=1.0, damping=-1.0), "damping -1 .* of spring of joint"),
        ("coil", JointSpring(stiffness=1.0, rest=math.inf), "rest of spring of joint 'coil'"),
        ("mouse", JointSpring(stiffness=1.0, rest=1.0), "joint 'mouse': rest 1 m: it pulls to"),
    ):
        with pytest.raises(InputError, match=says):
            sim.set_spring(name, spring)
    assert sim._arrays()["digest"].tolist() == before
