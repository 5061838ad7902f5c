"""Towers ride on what moves as on the ground, and slide as one body (IM10, DD104).

Laws: that of Galilei, and that a load under acceleration is a load.
"""

import numpy as np
import pytest

import tamias2d as t2

GRAVITY = 9.81
STONE = {"friction": 0.6, "restitution": 0.0}
STILL = 1e-5  # m/s: what rounding leaves in a tower, of which its solution is within 1e-5


def lift(**settings: object) -> t2.Simulator:
    """A plate at height 0 that moves as it is told."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -GRAVITY)), **settings)  # type: ignore[arg-type]
    sim.add_kinematic(
        t2.Box(width=30.0, height=0.4), position=(0.0, -0.2), velocity=(0.0, 0.0), **STONE
    )
    return sim


def even_tower(sim: t2.Simulator, count: int) -> None:
    for k in range(count):
        sim.add(t2.Box(width=1.0, height=0.5), mass=1.0, position=(0.0, 0.25 + 0.5 * k), **STONE)


def seen_from_lift(sim: t2.Simulator) -> float:
    """The fastest speed as seen from the lift, m/s."""
    return float(np.hypot(*(sim.velocity[1:] - sim.velocity[0]).T).max())


@pytest.mark.parametrize("speed", [0.03, 0.05, 0.2, 1.0])
@pytest.mark.parametrize("count", [3, 5, 10, 20])
def test_a_tower_rests_on_a_lift_that_goes_evenly(count: int, speed: float) -> None:
    sim = lift()
    even_tower(sim, count)
    sim.step(30)
    sim.velocity[0] = 0.0, speed
    sim.step(12)
    for _ in range(120):
        sim.step()
        assert seen_from_lift(sim) < STILL
    assert abs(sim.position[1:, 0]).max() < 1e-4
    heights = np.diff(sim.position[1:, 1])
    assert abs(heights - 0.5).max() < 1e-4


@pytest.mark.parametrize("seed", range(24))
def test_a_tower_rides_on_a_lift_that_speeds_up_or_slows_down(seed: int) -> None:
    """Towers of boxes of all sizes and masses; in steps and substeps of all lengths."""
    chance = np.random.default_rng(9300 + seed)
    rate = int(chance.choice([30, 60, 120]))
    sim = lift(time_step=1 / rate, substeps=int(chance.choice([1, 2, 4, 8])))
    top = 0.0
    for _ in range(chance.integers(2, 14)):
        wide, high = chance.uniform((0.6, 0.2), (1.2, 0.6))
        place = chance.uniform(-0.03, 0.03), top + high / 2
        mass = chance.uniform(0.5, 2.0)
        sim.add(t2.Box(width=wide, height=high), mass=mass, position=place, **STONE)
        top += high
    sim.step(rate)
    start = sim.position[1:].copy()
    acceleration = chance.choice([0.3, 1.0, 3.0, -0.3, -1.0, -3.0])
    for k in range(2 * rate):
        sim.velocity[0] = 0.0, acceleration * min(k + 1, rate) / rate
        sim.step()
        assert seen_from_lift(sim) < STILL
    moved = sim.position[1:] - start - (sim.position[0] - (0.0, -0.2))
    assert abs(moved).max() < 1e-4


@pytest.mark.parametrize("down", [5.0, 8.0])
def test_a_tower_keeps_together_on_a_lift_that_nearly_falls(down: float) -> None:
    """The lift goes in steps of velocity: boxes fall behind by one of these, and no more."""
    sim = lift()
    even_tower(sim, 10)
    sim.step(30)
    fastest = 0.0
    for k in range(90):
        sim.velocity[0] = 0.0, -down * (k + 1) / 60
        sim.step()
        fastest = max(fastest, seen_from_lift(sim))
    assert fastest <= down / 60
    assert abs(sim.position[1:, 0]).max() < 1e-3


def test_a_tower_is_carried_by_a_belt() -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -GRAVITY)))
    sim.add_static(t2.Box(width=30.0, height=0.4), position=(0.0, -0.2), surface_speed=0.3, **STONE)
    even_tower(sim, 6)
    sim.step(60)
    for _ in range(120):
        sim.step()
        assert abs(np.hypot(*sim.velocity[1:].T) - 0.3).max() < STILL


@pytest.mark.parametrize(
    ("count", "below", "between"), [(2, 0.5, 0.5), (3, 0.3, 0.6), (5, 0.3, 0.6)]
)
def test_a_tower_that_slides_comes_to_rest_as_one_body(
    count: int, below: float, between: float
) -> None:
    """It does not tip: the friction below is less than its width over its height."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -GRAVITY)))
    ground = {"friction": below**2 / between, "restitution": 0.0}  # of two it is the mean
    sim.add_static(t2.Box(width=100.0, height=0.4), position=(0.0, -0.2), **ground)
    for k in range(count):
        place, surface = (0.0, 0.25 + 0.5 * k), {"friction": between, "restitution": 0.0}
        sim.add(t2.Box(width=1.0, height=0.5), mass=1.0, position=place, **surface)
    sim.step(10)
    sim.velocity[1:] = 3.0, 0.0
    for k in range(1, 75):
        sim.step()
        expected = max(3.0 - below * GRAVITY * k / 60, 0.0)
        assert abs(sim.velocity[1:, 0] - expected).max() < 1e-4
    assert np.ptp(sim.position[1:, 0]) < 1e-4


@pytest.mark.parametrize("seed", range(24))
def test_what_the_floor_gives_a_tower_that_a_belt_takes_along_is_what_it_gets(seed: int) -> None:
    """Boxes of 30 g to 30 kg: none falls through another one, in a single substep either."""
    chance = np.random.default_rng([4718, seed])
    sim, count = t2.Simulator(t2.Scene(gravity=(0.0, -GRAVITY)), substeps=1), chance.integers(2, 8)
    surface = {"friction": float(chance.choice([0.1, 0.3, 0.6, 1.0])), "restitution": 0.0}
    plate = t2.Box(width=60.0, height=0.4)
    sim.add_static(plate, position=(0.0, -0.2), surface_speed=0.0, **surface)
    top = 0.0
    for _ in range(count):
        high = chance.uniform(0.2, 0.7)
        mass = chance.uniform(0.5, 2.0) if seed % 2 else 10 ** chance.uniform(-1.5, 1.5)
        box = t2.Box(width=chance.uniform(0.5, 1.2), height=high)
        sim.add(box, mass=mass, position=(chance.uniform(-0.03, 0.03), top + high / 2), **surface)
        top += high
    sim.step(30)
    sim.set_surface(0, surface_speed=chance.uniform(0.3, 5.0))
    weight = sim.mass[1:].sum() * GRAVITY / 60
    for _ in range(5):
        before = sim.mass[1:] @ sim.velocity[1:, 1]
        sim.step()
        on_floor = (sim.contacts.bodies == 0).any(axis=1)
        given = sim.contacts.impulse[on_floor].sum()
        got = sim.mass[1:] @ sim.velocity[1:, 1] - before + weight
        assert given == pytest.approx(got, abs=0.01 * weight)
