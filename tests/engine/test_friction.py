"""Friction in the frame loop against what is known from outside: slopes, stops, spins, rolling.

Oracles: OF1 to OF5 of the specification. A step of length h errs by about a t h/2 where a body
speeds up by a, with h that of a substep; the tolerances are four times that.
"""

import math

import pytest

import tamias2d as t2
from tamias2d.simulator import Simulator

GRAVITY = 9.81
SLOPE = math.radians(30.0)
RATES = (60, 240, 1000)
SUBSTEPS = 4


def block(friction: float, angle: float, rate: int, speed: float = 0.0) -> Simulator:
    """A box of 1 m on a slope, with a speed down along it."""
    normal, down = (math.sin(angle), math.cos(angle)), (math.cos(angle), -math.sin(angle))
    scene = t2.Scene(gravity=(0.0, -GRAVITY))
    plane = t2.HalfPlane(normal=normal, offset=0.0)
    scene.add_static(plane, friction=friction, restitution=0.0)
    scene.add_body(
        t2.Box(width=1.0, height=1.0),
        mass=2.0,
        position=(0.5 * normal[0], 0.5 * normal[1]),
        orientation=-angle,
        velocity=(speed * down[0], speed * down[1]),
        friction=friction,
        restitution=0.0,
    )
    return Simulator(scene, time_step=1 / rate, substeps=SUBSTEPS)


def along(sim: Simulator, angle: float = SLOPE) -> float:
    """How far along the slope the box is, m."""
    x, y = sim.position[1] - (0.5 * math.sin(angle), 0.5 * math.cos(angle))
    return float(x * math.cos(angle) - y * math.sin(angle))


def speed_along(sim: Simulator) -> float:
    x, y = sim.velocity[1]
    return float(x * math.cos(SLOPE) - y * math.sin(SLOPE))


@pytest.mark.parametrize("rate", RATES)
def test_a_block_slides_as_far_as_it_should(rate: int) -> None:
    """C1. Box2D v3 errs by 0.0098, 0.0024 and 0.0003 m, Pymunk by 0.038, 0.0098 and 0.0024 m."""
    sim = block(0.3, SLOPE, rate)
    sim.step(2 * rate)
    first_order = 2.3562872366623965 * 2.0 / (rate * SUBSTEPS) / 2.0
    assert abs(along(sim) - 4.712574473324793) < 4.0 * first_order


@pytest.mark.parametrize("far", [0.0, 1000.0])
@pytest.mark.parametrize("substeps", [1, 4])
@pytest.mark.parametrize("rate", [60, 240])
@pytest.mark.parametrize(("friction", "degrees"), [(0.1, 5), (0.3, 30), (0.6, 20), (0.9, 40)])
@pytest.mark.parametrize("size", [(1.0, 1.0), (0.1, 0.1), (2.0, 0.1)])
def test_a_block_put_on_a_slope_feels_its_friction_at_once(
    size: tuple[float, float], friction: float, degrees: int, rate: int, substeps: int, far: float
) -> None:
    """In the first step its impulses are not known; yet it slides, or stays, as it should."""
    angle = math.radians(degrees)
    down, up = (math.cos(angle), -math.sin(angle)), (math.sin(angle), math.cos(angle))
    surface = {"friction": friction, "restitution": 0.0}
    sim = Simulator(t2.Scene(gravity=(0.0, -GRAVITY)), time_step=1 / rate, substeps=substeps)
    sim.add_static(t2.HalfPlane(normal=up, offset=0.0), **surface)
    start = [far * along + size[1] / 2 * off for along, off in zip(down, up, strict=True)]
    box = t2.Box(width=size[0], height=size[1])
    sim.add(box, mass=2.0, position=start, orientation=-angle, **surface)
    sim.step()
    free = GRAVITY * math.sin(angle)
    wanted = max(free - friction * GRAVITY * math.cos(angle), 0.0)
    slid = float((sim.position[1] - start) @ down)
    # a thousandth: sweeps are few; a substep is taken with the velocity at its end
    assert abs(float(sim.velocity[1] @ down) - wanted / rate) < 1e-3 * free / rate
    late = wanted / (2 * rate**2 * substeps)
    assert abs(slid - wanted / (2 * rate**2) - late) < 0.15 * free / (rate**2 * substeps)


@pytest.mark.parametrize("rate", RATES)
def test_a_block_that_sticks_does_not_creep_by_a_bit(rate: int) -> None:
    """C1. It settles in the first seconds; then nothing moves any more, for 100 s."""
    sim = block(0.6, SLOPE, rate)
    sim.step(10 * rate)
    assert abs(along(sim)) < 1e-3
    rested = sim.position[1].tobytes() + sim.orientation[1:].tobytes()
    sim.step(100 * rate if rate < 1000 else 20 * rate)
    assert sim.position[1].tobytes() + sim.orientation[1:].tobytes() == rested


def test_the_edge_between_sticking_and_sliding_is_sharp() -> None:
    """C1. A block that slides slowly is slowed above tan(30 deg), and sped up below."""

    def slows(friction: float) -> bool:
        sim = block(friction, SLOPE, 60, speed=0.5)
        sim.step(300)
        before = speed_along(sim)
        sim.step(60)
        return before < 1e-6 or speed_along(sim) < before

    low, high = 0.5, 0.65
    for _ in range(26):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if slows(middle) else (middle, high)
    assert abs(high - math.tan(SLOPE)) < 1e-6


@pytest.mark.parametrize("rate", RATES)
def test_a_block_stops_and_stays(rate: int) -> None:
    """C2"""
    sim = block(0.4, 0.0, rate, speed=5.0)
    farthest = 0.0
    for _ in range(4 * rate):
        sim.step()
        farthest = max(farthest, along(sim, 0.0))
    first_order = 5.0 / (rate * SUBSTEPS) / 2.0
    assert abs(along(sim, 0.0) - 3.1855249745158) < 4.0 * first_order
    # what it leans forward while it brakes it leans back: no more than its contacts give way
    assert farthest - along(sim, 0.0) < 0.1 * first_order
    assert abs(sim.velocity[1]).max() < 1e-12
    assert abs(sim.angular_velocity[1]) < 1e-12


@pytest.mark.parametrize("height", [0.500001, 0.55, 0.57, 0.6, 1.0])
@pytest.mark.parametrize(
    ("friction", "velocity", "spin"),
    [(0.1, (1.46, 2.4), -2.16), (0.5, (4.0 / 3.0, 2.4), -8.0 / 3.0)],
)
def test_a_disc_that_meets_a_floor_slips_or_sticks(
    friction: float, velocity: tuple[float, float], spin: float, height: float
) -> None:
    """C3, wherever in a step they meet."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, friction=friction, restitution=0.8)
    scene.add_body(
        t2.Disc(radius=0.5),
        mass=1.0,
        position=(0.0, height),
        velocity=(2.0, -3.0),
        friction=friction,
        restitution=0.8,
    )
    sim = Simulator(scene)
    sim.step(30)
    # some twenty roundings
    assert sim.velocity[1].tolist() == pytest.approx(velocity, rel=1e-13)
    assert sim.angular_velocity[1] == pytest.approx(spin, rel=1e-13)


@pytest.mark.parametrize("rate", RATES)
@pytest.mark.parametrize(
    ("inertia", "friction", "acceleration", "turning"),
    [
        (0.25, 0.1214, 2.2368117373498735, -4.473623474699747),
        (0.25, 0.5, 2.2368117373498735, -4.473623474699747),
        (0.5, 0.1821, 1.6776088030124052, -3.3552176060248104),
        (0.25, 0.1, 2.433379145033834, -3.687353843963905),
    ],
)
def test_a_wheel_rolls_down_20_degrees(
    inertia: float, friction: float, acceleration: float, turning: float, rate: int
) -> None:
    """C4: a disc, with more grip, a hoop, and a disc that slips."""
    scene = t2.Scene(gravity=(3.3552176060248105, -9.218384609909762))
    scene.add_static(
        t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), friction=friction, restitution=0.0
    )
    scene.add_body(
        t2.Disc(radius=0.5),
        mass=2.0,
        inertia=inertia,
        position=(0.0, 0.5),
        friction=friction,
        restitution=0.0,
    )
    sim = Simulator(scene, time_step=1 / rate, substeps=SUBSTEPS)
    sim.step(3 * rate)
    first_order = 3.0 / (rate * SUBSTEPS) / 2.0  # s^2
    assert abs(sim.position[1, 0] - 4.5 * acceleration) < 4.0 * acceleration * first_order
    # contacts settle in the first steps, which slip a little
    assert sim.velocity[1, 0] == pytest.approx(3.0 * acceleration, rel=0.1 / rate)
    assert sim.angular_velocity[1] == pytest.approx(3.0 * turning, rel=0.1 / rate)
