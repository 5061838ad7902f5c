"""Springs of joints keep what they have, lose what their dampers take, or settle (IM19)."""

import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm

import tamias2d as t2
from tests.engine.scenes import plain
from tests.simulator.mechanisms import G, energy

MASS, INERTIA, ARM = 1.0, 0.1, 0.5
ABOUT_HINGE = INERTIA + MASS * ARM**2


def sprung(pace: float, ratio: float, angle: float = 0.3, gravity: float = 0.0) -> t2.Scene:
    """A bob on an arm, turned by an angle from where a spring of some pace, rad/s, is at rest.

    Its damper has a ratio to the critical one.
    """
    scene = t2.Scene(gravity=(0.0, -gravity))
    place = (ARM * math.cos(angle), ARM * math.sin(angle))
    scene.add_body(None, mass=MASS, inertia=INERTIA, position=place, orientation=angle)
    damping = 2.0 * ratio * pace * ABOUT_HINGE
    spring = t2.JointSpring(stiffness=ABOUT_HINGE * pace**2, damping=damping, rest=0.0)
    scene.add_joint(t2.Revolute(spring=spring), (0.0, 0.0), 0, other_anchor=(-ARM, 0.0))
    return scene


def all_energy(sim: t2.Simulator, scene: t2.Scene, pace: float) -> float:
    return energy(sim, scene) + 0.5 * ABOUT_HINGE * pace**2 * float(sim.orientation[0]) ** 2


def sprung_chain(links: int, stiffness: float, gravity: float = 0.0) -> t2.Scene:
    """Links of 1 m and 1 kg in a row that spins about its middle, with springs."""
    scene, middle = t2.Scene(gravity=(0.0, -gravity)), 0.5 * links
    for k in range(links):
        x, spin = k + 0.5 - middle, 2.0
        scene.add_body(
            None,
            mass=1.0,
            inertia=1.0 / 12,
            position=(x, 0.0),
            velocity=(0.0, spin * x),
            angular_velocity=spin,
        )
        if k:
            spring = t2.JointSpring(stiffness=stiffness, rest=0.4)
            ends = {"anchor": (0.5, 0.0), "other_anchor": (-0.5, 0.0)}
            scene.add_joint(t2.Revolute(spring=spring), k - 1, k, **ends)
    return scene


def energy_of_chain(sim: t2.Simulator, scene: t2.Scene, stiffness: float) -> float:
    bent = np.diff(sim.orientation) - 0.4
    return energy(sim, scene) + 0.5 * stiffness * float(bent @ bent)


@pytest.mark.parametrize(("pace", "substeps"), [(10.0, 1), (10.0, 4), (60.0, 4)])
def test_a_spring_without_a_damper_keeps_its_energy(pace: float, substeps: int) -> None:
    """What it differs by is of the second order in the angle of a substep."""
    scene = sprung(pace, 0.0)
    sim = plain(scene, substeps=substeps)
    before = all_energy(sim, scene, pace)
    found = []
    for _ in range(300):
        sim.step()
        found.append(all_energy(sim, scene, pace) / before)
    slight = 0.1 * (pace / 60 / substeps) ** 2
    assert np.abs(np.array(found) - 1.0).max() < slight
    assert np.mean(found[:100]) == pytest.approx(np.mean(found[-100:]), abs=0.1 * slight)


@pytest.mark.parametrize("gravity", [0.0, G])
def test_over_a_hundred_thousand_steps_a_spring_loses_and_gains_nothing(gravity: float) -> None:
    scene = sprung(10.0, 0.0, gravity=gravity)
    sim = t2.Simulator(scene)
    before, found = all_energy(sim, scene, 10.0), []
    for _ in range(1000):
        sim.step(100)
        found.append(all_energy(sim, scene, 10.0))
    assert np.array(found) == pytest.approx(before, rel=1e-3)


@pytest.mark.parametrize("links", [2, 5])
def test_springs_of_a_chain_keep_the_energy_of_all(links: int) -> None:
    scene = sprung_chain(links, 100.0)
    sim = plain(scene)
    before, found = energy_of_chain(sim, scene, 100.0), []
    for _ in range(240):
        sim.step()
        found.append(energy_of_chain(sim, scene, 100.0))
    assert np.array(found) == pytest.approx(before, rel=2e-3)


def test_a_spring_along_a_distance_keeps_its_energy() -> None:
    """It turns about a point while it swings in and out."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=2.0, inertia=0.1, position=(1.5, 0.0), velocity=(0.0, 3.0))
    spring = t2.JointSpring(stiffness=200.0, rest=1.0)
    scene.add_joint(t2.Distance(spring=spring), (0.0, 0.0), 0)
    sim = plain(scene)

    def all_of_it() -> float:
        far = float(np.linalg.norm(sim.position[0])) - 1.0
        return energy(sim, scene) + 100.0 * far**2

    before, found = all_of_it(), []
    for _ in range(600):
        sim.step()
        found.append(all_of_it())
    assert np.array(found) == pytest.approx(before, rel=5e-3)
    assert np.mean(found[:100]) == pytest.approx(np.mean(found[-100:]), rel=5e-4)


def decay(energies: list[float]) -> float:
    """Return how fast energies of single steps fall, 1/s, by a line through their logarithms."""
    count = len(energies)
    return -float(np.polyfit(np.arange(count) / 60, np.log(energies), 1)[0])


@pytest.mark.parametrize("pace", [4.0, 12.0, 100.0])
@pytest.mark.parametrize("ratio", [0.02, 0.3, 0.7, 2.0])
def test_a_damper_takes_what_it_takes_exactly(pace: float, ratio: float) -> None:
    """The energy falls as that of the linear oscillation does, by its matrix exponential."""
    scene = sprung(pace, ratio)
    sim, rates = plain(scene), np.array([[0.0, 1.0], [-(pace**2), -2.0 * ratio * pace]])
    slower = pace * (ratio if ratio < 1 else ratio - math.sqrt(ratio**2 - 1))
    found, exact = [], []
    for k in range(min(300, max(6, round(60 * 4.0 / slower)))):
        sim.step()
        found.append(all_energy(sim, scene, pace))
        angle, spin = expm(rates * (k + 1) / 60) @ (0.3, 0.0)
        exact.append(0.5 * ABOUT_HINGE * (spin**2 + (pace * angle) ** 2))
    assert decay(found) == pytest.approx(decay(exact), rel=0.05)


def exact_angle(pace: float, ratio: float, seconds: float) -> float:
    """Return the angle of the bob after a time, s, as scipy finds it."""

    def rates(_time: float, now: Any) -> list[float]:
        angle, spin = now
        turning = -MASS * G * ARM * math.cos(angle) / ABOUT_HINGE
        return [spin, turning - pace**2 * angle - 2 * ratio * pace * spin]

    ways: dict[str, Any] = {"rtol": 1e-12, "atol": 1e-12, "method": "DOP853"}
    return float(solve_ivp(rates, (0.0, seconds), [0.3, 0.0], **ways).y[0, -1])


@pytest.mark.parametrize("ratio", [0.0, 0.2])
def test_the_error_of_a_spring_is_of_the_second_order(ratio: float) -> None:
    errors = []
    for substeps in (2, 4, 8):
        sim = plain(sprung(10.0, ratio, gravity=G), substeps=substeps)
        sim.step(60)
        errors.append(abs(float(sim.orientation[0]) - exact_angle(10.0, ratio, 1.0)))
    assert errors[-1] < 2e-3
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.2)
    assert errors[1] / errors[2] == pytest.approx(4.0, rel=0.2)


@pytest.mark.parametrize("pace", [1e3, 1e4, 1e5])
@pytest.mark.parametrize("ratio", [0.0, 5.0])
def test_a_spring_too_stiff_for_substeps_settles(pace: float, ratio: float) -> None:
    scene = sprung(pace, ratio)
    sim = plain(scene)
    before = all_energy(sim, scene, pace)
    for _ in range(30):
        sim.step()
        assert all_energy(sim, scene, pace) < before
    assert all_energy(sim, scene, pace) < 1e-9 * before


def test_a_chain_that_hangs_by_springs_gains_nothing_in_a_hundred_thousand_steps() -> None:
    """Where only the scheme bounds its energy, that rises by 1.5 per cent."""
    scene, lean = t2.Scene(gravity=(0.0, -G)), 1.0 - math.pi / 2
    out = np.array([math.cos(lean), math.sin(lean)])
    for k in range(4):
        place = tuple(((k + 0.5) * out).tolist())
        scene.add_body(None, mass=1.0, inertia=1 / 12, position=place, orientation=lean)
        ends = {"anchor": (0.5 * (k > 0), 0.0), "other_anchor": (-0.5, 0.0)}
        kind = t2.Revolute(spring=t2.JointSpring(stiffness=10.0))
        scene.add_joint(kind, k - 1 if k else (0.0, 0.0), k, **ends)
    sim = t2.Simulator(scene)

    def all_of_it() -> float:
        bent = np.diff(sim.orientation, prepend=0.0) - np.array([lean, 0.0, 0.0, 0.0])
        return energy(sim, scene) + 5.0 * float(bent @ bent) + 8.0 * G  # 80 J above its lowest

    before = all_of_it()
    for _ in range(2000):
        sim.step(50)
        assert 0.99 * before < all_of_it() < before * (1 + 1e-9)
