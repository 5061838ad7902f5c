"""Impacts whose instants steps find: as accurate as rigid impacts are, whatever the step."""

import math
from typing import Any

import numpy as np
import pytest

import tamias2d as t2


def floor_and_disc(
    *, step: float, height: float, restitution: float, friction: float = 0.0
) -> tuple[t2.Simulator, int]:
    surface: Any = {"friction": friction, "restitution": restitution}
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)), time_step=step)
    sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    body = sim.add(
        t2.Disc(radius=0.2),
        mass=2.0,
        position=(0.0, 0.2 + height),
        velocity=(3.0, 0.0),
        angular_velocity=5.0,
        **surface,
    )
    return sim, int(body)


@pytest.mark.parametrize("friction", [0.3, 1.0])
@pytest.mark.parametrize("restitution", [0.5, 1.0])
def test_an_oblique_bounce_leaves_as_rigid_bodies_do(friction: float, restitution: float) -> None:
    """Velocity and spin by momentum and Coulomb's law, worked out by hand; 32 phases of a step."""
    for phase in range(32):
        height = 1.0 + 0.07 * phase / 32
        sim, body = floor_and_disc(
            step=1 / 60, height=height, restitution=restitution, friction=friction
        )
        falling = math.sqrt(2 * height / 9.81)
        steps = int(60 * falling) + 3
        sim.step(steps)
        down, left = 9.81 * falling, steps / 60 - falling
        slip = 3.0 + 5.0 * 0.2
        rub = min(friction * (1 + restitution) * down, slip / 3)  # a disc: it rolls at a third
        expected = (3.0 - rub, restitution * down - 9.81 * left, 5.0 - 2 * rub / 0.2)
        found = (*sim.velocity[body], sim.angular_velocity[body])
        assert found == pytest.approx(expected, abs=1e-9)  # the gap at which they meet, over 4 m/s


@pytest.mark.parametrize("gap", [1e-9, 1e-6, 1e-5])
def test_a_step_may_end_a_hair_before_a_landing(gap: float) -> None:
    """It meets the floor early in the next step. Half of what counts as meeting is 1.2e-5 m."""
    height, restitution, before = 1.0, 0.5, 40
    falling, down = math.sqrt(2 * height / 9.81), math.sqrt(2 * height * 9.81)
    step = (falling - gap / down) / before
    sim, body = floor_and_disc(step=step, height=height, restitution=restitution)
    sim.step(before)
    assert sim.velocity[body][1] == pytest.approx(-9.81 * before * step, rel=1e-12)
    sim.step(10)
    left = (before + 10) * step - falling
    risen = restitution * down * left - 9.81 * left**2 / 2
    assert sim.position[body][1] - 0.2 == pytest.approx(risen, abs=1e-9)
    assert sim.velocity[body][1] == pytest.approx(restitution * down - 9.81 * left, abs=1e-9)


@pytest.mark.parametrize("gap", [2.5e-7, 1e-6])
@pytest.mark.parametrize("step", [1 / 7680, 1 / 61440])
def test_a_body_that_starts_a_hair_above_the_floor_does_not_sink(step: float, gap: float) -> None:
    """A tall box turns about its corner: in a short step it falls by less than a hair, too."""
    surface: Any = {"friction": 0.6, "restitution": 0.0}
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)), time_step=step)
    sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    body = sim.add(
        t2.Box(width=0.1, height=1.0), mass=1.0, position=(0.0, 0.5 + gap), velocity=(0.75, 0.075),
        angular_velocity=-1.5, **surface,
    )  # fmt: skip
    inertia, lowest = 1.01 / 12, 0.0
    for _ in range(600):
        sim.step()
        angle = sim.orientation[body]
        corner = sim.position[body][1] + 0.05 * math.sin(angle) - 0.5 * math.cos(angle)
        lowest = min(lowest, corner)
    speed, spin = sim.velocity[body], sim.angular_velocity[body]
    energy = (speed @ speed + inertia * spin**2) / 2 + 9.81 * sim.position[body][1]
    assert lowest > -1e-9
    assert energy == pytest.approx(5.28375, abs=1e-4)  # 5.25 where it has sunk and is pushed out


@pytest.mark.parametrize("step", [1 / 60, 1 / 240, 1e-3])
def test_a_ball_keeps_its_height_whatever_the_step(step: float) -> None:
    sim, body = floor_and_disc(step=step, height=1.0, restitution=1.0)
    sim.velocity[body], sim.angular_velocity[body] = (0.0, 0.0), 0.0
    sim.step(int(20 / step))
    energy = (sim.velocity[body] ** 2).sum() / 2 + 9.81 * (sim.position[body][1] - 0.2)
    assert energy == pytest.approx(9.81, rel=1e-9)  # 22 bounces


def test_a_ball_comes_to_rest_when_its_bounces_add_up() -> None:
    sim, body = floor_and_disc(step=1 / 60, height=1.0, restitution=0.8)
    first = math.sqrt(2 / 9.81)
    exact = first * (1 + 2 * 0.8 / (1 - 0.8))
    sim.step(int(60 * exact) - 30)
    assert abs(sim.velocity[body][1]) > 0.2
    sim.step(60)
    assert abs(sim.velocity[body][1]) < 1e-2


def test_a_body_lands_without_an_overlap() -> None:
    surface: Any = {"friction": 0.5, "restitution": 0.0}
    for phase in np.linspace(0, 1, 12):
        sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
        sim.add_static(t2.Box(width=40, height=10), position=(0.0, -5.0), **surface)
        body = sim.add(
            t2.Disc(radius=0.1),
            mass=1.0,
            position=(0.0, 0.1 + 0.09 * (1.3 + phase)),
            velocity=(0.0, -5.4),  # 0.9 radii a step
            **surface,
        )
        for _ in range(6):
            sim.step()
            assert sim.position[body][1] >= 0.1 * (1 - 1e-3)


def test_a_touching_cradle_passes_the_blow_on() -> None:
    surface: Any = {"friction": 0.0, "restitution": 1.0}
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    row = sim.add(
        t2.Disc(radius=0.5), mass=1.0, position=[(float(k), 0.0) for k in range(5)], **surface
    )
    sim.add(t2.Disc(radius=0.5), mass=1.0, position=(-2.0, 0.0), velocity=(3.0, 0.0), **surface)
    sim.step(60)
    assert sim.velocity[:, 0] == pytest.approx([0, 0, 0, 0, 3, 0], abs=1e-12)
    assert sim.position[row[4]][0] > 5.0


@pytest.mark.parametrize("diameters", [0.05, 0.5])
def test_a_gas_of_elastic_discs_keeps_its_energy(diameters: float) -> None:
    """64 discs in a tenth of a square, at so many diameters a step."""
    chance = np.random.default_rng(3)
    surface: Any = {"friction": 0.0, "restitution": 1.0}
    side = math.sqrt(64 * math.pi / 4 / 0.1)
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    for normal, offset in (((0, 1), 0), ((0, -1), -side), ((1, 0), 0), ((-1, 0), -side)):
        sim.add_static(t2.HalfPlane(normal=normal, offset=offset), **surface)
    places = [(side / 8 * (k % 8 + 0.5), side / 8 * (k // 8 + 0.5)) for k in range(64)]
    speed = diameters * 60 / math.sqrt(2)
    rows = sim.add(
        t2.Disc(radius=0.5),
        mass=1.0,
        position=places,
        velocity=speed * chance.normal(size=(64, 2)),
        **surface,
    )
    before = (sim.velocity[rows] ** 2).sum()
    sim.step(1000)
    assert (sim.velocity[rows] ** 2).sum() == pytest.approx(before, rel=5e-3)
    assert ((sim.position[rows] > 0.0) & (sim.position[rows] < side)).all()


@pytest.mark.parametrize("seed", range(3))
def test_balls_that_land_in_one_step_all_keep_their_heights(seed: int) -> None:
    """The impact of one on the floor leaves the paths of the others what they are."""
    restitution, radius = 0.8, 0.1
    high = 1.0 + np.random.default_rng(seed).uniform(0.0, 0.06, 5)
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_static(
        t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), restitution=restitution, friction=0.0
    )
    for k, height in enumerate(high.tolist()):
        scene.add_body(
            t2.Disc(radius=radius), mass=1.0, position=(0.5 * k, radius + height),
            velocity=(0.0, 0.0), orientation=0.0, angular_velocity=0.0,
            restitution=restitution, friction=0.0,
        )  # fmt: skip
    sim = t2.Simulator(scene, time_step=1 / 60)
    while sim.time < 0.6:
        sim.step()
    energy = sim.velocity[1:, 1] ** 2 / 2 + 9.81 * (sim.position[1:, 1] - radius)
    assert energy == pytest.approx(restitution**2 * 9.81 * high, rel=1e-12)
