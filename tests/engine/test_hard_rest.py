"""Few discs in steps that rest on a half-plane: they slide, roll and are struck."""

import math
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.simulator import Simulator
from tests.engine.hard_steps import STEP, assert_as_located, counted

PULL, RADIUS = 9.81, 0.15  # m/s^2, m


def on_slope(slope: float, friction: float, velocity: float, spin: float) -> t2.Scene:
    """A disc of 2 kg that begins on a half-plane, seen along that: gravity is turned, rad."""
    surface: Any = {"restitution": 0.5, "friction": friction}
    scene = t2.Scene(gravity=(PULL * math.sin(slope), -PULL * math.cos(slope)))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    scene.add_body(t2.Disc(radius=RADIUS), mass=2.0, position=(0.0, RADIUS),
                   velocity=(velocity, 0.0), angular_velocity=spin, **surface)  # fmt: skip
    return scene


def state_after(scene: t2.Scene, steps: int) -> tuple[float, float, float]:
    """Return place, velocity and angular velocity of the disc of a scene after some steps."""
    sim = Simulator(scene, time_step=STEP)
    sim.step(steps)
    return float(sim.position[1, 0]), float(sim.velocity[1, 0]), float(sim.angular_velocity[1])


@pytest.mark.parametrize(
    ("velocity", "spin", "friction"), [(2.0, 5.0, 0.1), (1.0, -40.0, 0.2), (0.0, 30.0, 0.7)]
)
def test_a_disc_that_slides_rolls_in_the_end_as_textbooks_say(
    velocity: float, spin: float, friction: float
) -> None:
    """Friction slows the slip by 3 mu g, of which a third is that of the centre (Hibbeler)."""
    slip = velocity + RADIUS * spin
    ends = abs(slip) / (3 * friction * PULL)
    slows = math.copysign(friction * PULL, slip)
    rolls = velocity - slows * ends  # (2 v - R w)/3
    place = velocity * ends - slows * ends**2 / 2 + rolls * (1.0 - ends)
    assert ends < 1.0
    assert rolls == pytest.approx((2 * velocity - RADIUS * spin) / 3, abs=1e-14)
    found = state_after(on_slope(0.0, friction, velocity, spin), 60)
    assert found == pytest.approx((place, rolls, -rolls / RADIUS), abs=1e-12)


@pytest.mark.parametrize(("slope", "friction"), [(0.3, 0.5), (0.3, 0.11), (0.3, 0.1), (0.3, 0.0)])
def test_a_disc_rolls_down_with_two_thirds_of_the_pull_if_friction_holds(
    slope: float, friction: float
) -> None:
    """Friction holds if tan(slope) <= 3 mu; else it slides, and friction turns it (Hibbeler)."""
    along, rubs = PULL * math.sin(slope), friction * PULL * math.cos(slope)
    holds = math.tan(slope) <= 3 * friction
    by = 2 / 3 * along if holds else along - rubs
    turning = -by / RADIUS if holds else -2 * rubs / RADIUS
    found = state_after(on_slope(slope, friction, 0.0, 0.0), 60)
    assert found == pytest.approx((by / 2, by, turning), abs=1e-11)


@pytest.mark.parametrize(
    ("slope", "friction", "velocity", "spin"),
    [
        (0.0, 0.0, 0.7, 3.0),  # slides for ever
        (0.0, 0.5, 0.0, 0.0),  # stands
        (0.0, 0.1, 2.0, 5.0),  # slides, and then rolls
        (0.0, 0.2, 1.0, -40.0),  # is slowed, and comes back
        (0.3, 0.1, 0.0, 0.0),  # is too steep to roll
        (0.3, 0.5, 1.0, -3.0),  # rolls down
        (-0.2, 0.3, 2.0, 9.0),  # rolls up, and down again
    ],
)
def test_a_disc_slides_and_rolls_as_in_a_located_run(
    slope: float, friction: float, velocity: float, spin: float
) -> None:
    scene = on_slope(slope, friction, velocity, spin)
    run = t2.simulate(scene, duration=1.0, times=np.arange(61) * STEP)
    sim = Simulator(scene, time_step=STEP, compiled=False)
    taken: list[int] = []
    with counted(taken):
        for k in range(1, 61):
            start = sim.position[1].copy()
            sim.step()
            found = np.array([*sim.position[1], *sim.velocity[1], sim.orientation[1]])
            right = np.array([*run.position[k, 1], *run.velocity[k, 1], run.orientation[k, 1]])
            np.testing.assert_allclose(found, right, rtol=0.0, atol=1e-12)
            weight = 2.0 * PULL * math.cos(slope)
            assert sim.contacts.impulse == pytest.approx([weight * STEP], rel=1e-12)
            assert sim.contacts.point[0] == pytest.approx((start[0], 0.0), abs=1e-12)
            assert sim.contacts.separation.tolist() == [0.0]
            assert len(sim.began) == (k == 1)
    assert sum(taken) == 60


def test_a_disc_comes_to_rest_and_stays() -> None:
    """It bounces until gravity brings it back within half a step, and then does not move."""
    surface: Any = {"restitution": 0.9, "friction": 0.0}
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=(0.0, 1.0), **surface)
    sim = Simulator(scene, time_step=STEP)
    sim.step(1200)
    assert sim.velocity[1].tolist() == [0.0, 0.0]
    assert sim.position[1, 1] == pytest.approx(0.5, abs=1e-12)
    before = sim.position.copy()
    sim.step(10**6)
    assert np.array_equal(sim.position, before)


def struck(
    restitution: float, friction: float, offset: float, *, rolling: float = 0.0,
    falling: tuple[float, float] = (0.0, 0.0),
) -> t2.Scene:  # fmt: skip
    """A disc on a floor on which another one falls, from aside; with their velocities."""
    surface: Any = {"restitution": restitution, "friction": friction}
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=(0.0, 0.5), velocity=(rolling, 0.0),
                   **surface)  # fmt: skip
    scene.add_body(t2.Disc(radius=0.3), mass=1.0, position=(offset, 2.0), velocity=falling,
                   **surface)  # fmt: skip
    return scene


@pytest.mark.parametrize("friction", [0.0, 0.4])
@pytest.mark.parametrize("restitution", [0.6, 0.9])
@pytest.mark.parametrize("offset", [0.0, 0.1, 0.5])
def test_a_disc_at_rest_that_is_struck_answers_as_in_a_located_run(
    restitution: float, friction: float, offset: float
) -> None:
    """It meets the half-plane at the same instant, and perhaps the other disc again.

    A rebound that gravity ends within half a step counts as none.
    """
    scene = struck(restitution, friction, offset)
    assert_as_located(scene, 25, place=9.81 * STEP**2 / 32, speed=9.81 * STEP / 4)


def test_a_disc_that_falls_on_a_rolling_one_meets_it_in_time() -> None:
    """Their gap is no parabola: one is pulled down, and the other one is carried."""
    scene = struck(0.9, 0.0, 0.4, rolling=0.3, falling=(-0.5, -3.0))
    run = assert_as_located(scene, 19, place=1e-12, speed=1e-11)
    assert run.impacts.time[0] < 19 * STEP


def test_what_loses_nothing_bounces_for_ever() -> None:
    surface: Any = {"restitution": 1.0, "friction": 0.0}
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=(0.0, 0.50001), **surface)
    sim = Simulator(scene, time_step=STEP)
    for _ in range(100):
        sim.step()
        height = sim.velocity[1, 1] ** 2 / (2 * 9.81) + sim.position[1, 1] - 0.5
        assert height == pytest.approx(1e-5, rel=1e-9)


def test_discs_that_roll_at_each_other_meet_in_time() -> None:
    """One slides, the other rolls: they do not accelerate alike."""
    surface: Any = {"restitution": 0.8, "friction": 0.1}
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    for x, speed, spin in ((0.0, 3.0, 0.0), (2.0, -1.0, 2.0)):
        scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=(x, 0.5), velocity=(speed, 0.0),
                       angular_velocity=spin, **surface)  # fmt: skip
    assert_as_located(scene, 16, place=1e-12, speed=1e-11)
