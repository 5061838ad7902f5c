"""A disc on a half-plane that slides, rolls or stands, beside answers by hand and by scipy."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import tamias2d as t2

G = 9.81


def on_slope(
    *, friction: float, slope: float = 0.0, speed: float = 0.0, spin: float = 0.0,
    torque: float = 0.0, push: float = 0.0, inertia: float | None = None,
) -> t2.Scene:  # fmt: skip
    """A disc that lies on a slope, which falls to the right, and moves along it."""
    x, y = math.sin(slope), math.cos(slope)
    scene = t2.Scene(gravity=(0.0, -G))
    scene.add_static(t2.HalfPlane(normal=(x, y), offset=0.0))
    scene.add_body(
        t2.Disc(radius=0.3),
        mass=1.7,
        inertia=inertia,
        position=(0.3 * x, 0.3 * y),
        velocity=(speed * y, -speed * x),
        angular_velocity=spin,
        torque=torque,
        force=(push, 0.0),
        restitution=0.0,
        friction=friction,
    )
    return scene


def moved(scene: t2.Scene, slope: float, times: list[float]) -> np.ndarray:
    """Return way and speed down the slope, angle and spin at some times (k, 4)."""
    run = t2.simulate(scene, duration=times[-1], times=times, method=t2.ClosedForm())
    down = np.array([math.cos(slope), -math.sin(slope)])
    ways = run.position[:, 1] @ down, run.velocity[:, 1] @ down
    return np.stack([*ways, run.orientation[:, 1], run.angular_velocity[:, 1]], axis=1)


@pytest.mark.parametrize(("speed", "spin"), [(3.0, 0.0), (0.0, -20.0), (3.0, 40.0), (-2.0, -60.0)])
@pytest.mark.parametrize("friction", [0.05, 0.4, 1.0])
def test_a_disc_that_is_thrown_rolls_with_what_its_angular_momentum_says(speed, spin, friction):
    """About a point of the floor it stays: `m v r - I w` is `3/2 m v r` from then on.

    All is within a few roundings.
    """
    slip, rolling = speed + 0.3 * spin, (2 * speed - 0.3 * spin) / 3
    end = abs(slip) / (3 * friction * G)
    way = (speed + rolling) / 2 * end
    found = moved(on_slope(friction=friction, speed=speed, spin=spin), 0.0, [0.0, end, end + 2.0])
    assert found[1] == pytest.approx(
        [way, rolling, found[1, 2], -rolling / 0.3], rel=1e-13, abs=1e-13
    )
    wanted = [way + 2 * rolling, rolling, found[1, 2] - 2 * rolling / 0.3, -rolling / 0.3]
    assert found[2] == pytest.approx(wanted, rel=1e-13, abs=1e-13)


@pytest.mark.parametrize("slope", [0.1, 0.4, 0.7, 1.2])
@pytest.mark.parametrize("friction", [0.05, 0.2, 0.6])
def test_down_a_slope_a_disc_rolls_or_slides_for_ever(slope, friction):
    """It rolls with two thirds of the acceleration, if friction can turn it so fast."""
    rolls = math.tan(slope) / 3 <= friction
    by = (
        2 / 3 * G * math.sin(slope) if rolls else G * (math.sin(slope) - friction * math.cos(slope))
    )
    turning = -by / 0.3 if rolls else -2 * friction * G * math.cos(slope) / 0.3
    *_, (way, speed, angle, spin) = moved(on_slope(friction=friction, slope=slope), slope, [0, 2.0])
    assert [way, speed] == pytest.approx([2 * by, 2 * by], rel=1e-13)
    assert [angle, spin] == pytest.approx([2 * turning, 2 * turning], rel=1e-13)


def test_a_disc_that_is_balanced_stands_to_the_bit():
    """Pushed uphill as hard as its weight pulls, along a slope whose numbers are not exact."""
    slope = math.pi / 6
    scene = on_slope(friction=0.5, slope=slope, push=-1.7 * G * math.tan(slope))
    found = moved(scene, slope, [0.0, 1000.0])
    assert (found[1, 1:] == 0.0).all()


def by_scipy(scene: t2.Scene, slope: float, friction: float, duration: float) -> np.ndarray:
    """Return way, speed, angle and spin at the end: the equations of motion, piece by piece."""
    disc = scene.bodies[1]
    mass, inertia, radius = disc.mass, disc.inertia, 0.3
    (fx, fy), torque = disc.force, disc.torque
    c, s = math.cos(slope), math.sin(slope)
    along = c * fx - s * (fy - mass * G)
    normal = -(s * fx + c * (fy - mass * G))
    bound = friction * normal
    holding = -(along / mass + radius * torque / inertia) / (1 / mass + radius**2 / inertia)
    pushes = s * disc.position[0] + c * disc.position[1]
    assert normal > 0.1
    assert pushes == pytest.approx(radius)
    start = [
        c * disc.position[0] - s * disc.position[1],
        c * disc.velocity[0] - s * disc.velocity[1],
        disc.orientation,
        disc.angular_velocity,
    ]
    time, state = 0.0, np.array(start)
    while time < duration:
        slip = state[1] + radius * state[3]
        if abs(slip) < 1e-9:
            force = holding if abs(holding) <= bound else -math.copysign(bound, -holding)
        else:
            force = -math.copysign(bound, slip)

        def rate(_: float, y: np.ndarray, force: float = force) -> list[float]:
            return [y[1], (along + force) / mass, y[3], (torque + radius * force) / inertia]

        def stopped(_: float, y: np.ndarray) -> float:
            return float(y[1] + radius * y[3])

        stopped.terminal = True  # type: ignore[attr-defined]
        events = [] if abs(slip) < 1e-9 else [stopped]
        found = solve_ivp(rate, (time, duration), state, events=events, rtol=1e-12, atol=1e-13)
        time, state = float(found.t[-1]), found.y[:, -1]
    return state


@pytest.mark.parametrize("seed", range(20))
def test_under_any_constant_loads_it_goes_where_scipy_takes_it(seed):
    chance = np.random.default_rng(seed)
    slope, friction = chance.uniform(-0.8, 0.8), chance.uniform(0.01, 1.0)
    scene = on_slope(
        friction=friction,
        slope=slope,
        speed=chance.normal(0, 3),
        spin=chance.normal(0, 20),
        torque=chance.choice([0.0, chance.normal(0, 1)]),
        push=chance.choice([0.0, chance.normal(0, 3)]),
        inertia=chance.choice([0.01, 0.0765, 0.153]),
    )
    *_, found = moved(scene, slope, [0.0, 3.0])
    # scipy is off by 1e-12 of each of some hundred steps, and calls a slip of 1e-9 m/s none
    assert found == pytest.approx(by_scipy(scene, slope, friction, 3.0), rel=1e-9, abs=1e-9)
