"""Located impacts against scipy's event detection: other code, other geometry, other formulas."""

import math
from collections.abc import Callable

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import tamias2d as t2

G = 9.81


def first_event(
    start: list[float],
    acceleration: Callable[[float], list[float]],
    distance: Callable[[np.ndarray], float],
    duration: float,
) -> tuple[float, np.ndarray]:
    """Return when the distance first falls to 0, and the state (coordinates, rates) then."""
    half = len(start) // 2

    def rate(t: float, y: np.ndarray) -> np.ndarray:
        return np.concatenate((y[half:], acceleration(t)))

    def event(t: float, y: np.ndarray) -> float:  # noqa: ARG001
        return distance(y)

    event.terminal, event.direction = True, -1
    found = solve_ivp(
        rate,
        (0, duration),
        start,
        method="DOP853",
        rtol=1e-13,
        atol=1e-14,
        max_step=duration / 400,
        events=event,
    )
    return float(found.t_events[0][0]), found.y_events[0][0]


def to_box(x: float, y: float, angle: float, px: float, py: float, half: tuple) -> float:
    """Return the distance of a point from a box, negative inside, by clamping in its own axes."""
    c, s = math.cos(angle), math.sin(angle)
    dx, dy = abs(c * (px - x) + s * (py - y)) - half[0], abs(c * (py - y) - s * (px - x)) - half[1]
    return math.hypot(max(dx, 0), max(dy, 0)) + min(max(dx, dy), 0)


def corners(x: float, y: float, angle: float, half: tuple) -> list[tuple[float, float]]:
    c, s = math.cos(angle), math.sin(angle)
    signs = ((1, 1), (1, -1), (-1, 1), (-1, -1))
    return [
        (x + c * i * half[0] - s * j * half[1], y + s * i * half[0] + c * j * half[1])
        for i, j in signs
    ]


def check(run: t2.Run, time: float) -> None:
    assert run.impacts.time[0] == pytest.approx(time, abs=1e-9)


def test_spinning_box_meets_the_floor():
    scene = t2.Scene(gravity=(0, -G))
    scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0))
    scene.add_body(
        t2.Box(width=1.4, height=0.3),
        mass=1,
        position=(0, 3),
        velocity=(1, 2),
        angular_velocity=9,
        restitution=0.5,
    )
    time, state = first_event(
        [0, 3, 0, 1, 2, 9],
        lambda _: [0, -G, 0],
        lambda y: min(p[1] for p in corners(*y[:3], (0.7, 0.15))),
        3.0,
    )
    run = t2.simulate(scene, duration=time + 1e-3)
    check(run, time)
    lowest = min(corners(*state[:3], (0.7, 0.15)), key=lambda p: p[1])
    arm = lowest[0] - state[0]
    assert run.impacts.normal_velocity[0] == pytest.approx(state[4] + state[5] * arm, abs=1e-9)
    assert run.impacts.point[0].tolist() == pytest.approx(lowest, abs=1e-9)


def test_disc_meets_a_spinning_box():
    scene = t2.Scene(gravity=(0, 0))
    scene.add_body(
        t2.Disc(radius=0.3), mass=1, position=(-4, 0.5), velocity=(2, 0), restitution=0.5
    )
    scene.add_body(t2.Box(width=2, height=0.5), mass=3, position=(0, 0), angular_velocity=3)
    time, _ = first_event(
        [-4, 0.5, 0, 0, 0, 2, 0, 0, 0, 3],
        lambda _: [0] * 5,
        lambda y: to_box(y[2], y[3], y[4], y[0], y[1], (1, 0.25)) - 0.3,
        3.0,
    )
    check(t2.simulate(scene, duration=3.0), time)


def test_two_spinning_boxes_meet():
    scene = t2.Scene(gravity=(0, -G))
    a, b = (1.0, 0.4), (0.3, 0.8)
    scene.add_body(
        t2.Box(width=2, height=0.8),
        mass=1,
        position=(0, 0),
        velocity=(1, 6),
        angular_velocity=-4,
        restitution=0.5,
    )
    scene.add_body(
        t2.Box(width=0.6, height=1.6),
        mass=2,
        position=(4, 1),
        velocity=(-2, 5),
        angular_velocity=5,
    )

    def distance(y: np.ndarray) -> float:
        return min(
            [to_box(*y[:3], *p, a) for p in corners(*y[3:6], b)]
            + [to_box(*y[3:6], *p, b) for p in corners(*y[:3], a)]
        )

    start = [0, 0, 0, 4, 1, 0, 1, 6, -4, -2, 5, 5]
    time, _ = first_event(start, lambda _: [0, -G, 0, 0, -G, 0], distance, 2.0)
    check(t2.simulate(scene, duration=2.0), time)


def test_discs_under_unlike_forces_meet():
    scene = t2.Scene(gravity=(0, -G))
    disc = t2.Disc(radius=0.5)
    scene.add_body(disc, mass=2, position=(-3, 0), velocity=(4, 5), force=(3, 1), restitution=0.5)
    scene.add_body(disc, mass=1, position=(3, 0.3), velocity=(-1, 4), force=(-1, 2))
    time, state = first_event(
        [-3, 0, 3, 0.3, 4, 5, -1, 4],
        lambda _: [1.5, 0.5 - G, -1, 2 - G],
        lambda y: math.hypot(y[2] - y[0], y[3] - y[1]) - 1,
        4.0,
    )
    run = t2.simulate(scene, duration=time + 1e-3)
    check(run, time)
    normal = state[2:4] - state[:2]
    assert run.impacts.normal[0].tolist() == pytest.approx(normal.tolist(), abs=1e-8)
    assert run.impacts.normal_velocity[0] == pytest.approx(
        (state[6:] - state[4:6]) @ normal, abs=1e-8
    )


@pytest.mark.parametrize("method", [t2.Reference(), t2.RungeKutta4()])
def test_shaken_disc_meets_a_wall(method):
    """The force varies with time: the path is integrated, by scipy's stepper or by a scheme."""
    scene = t2.Scene(gravity=(0, 0))
    scene.add_static(t2.HalfPlane(normal=(-1, 0), offset=-3))
    scene.add_body(
        t2.Disc(radius=0.5),
        mass=0.5,
        position=(0, 0),
        force=("10[N]*sin(7[rad/s]*time)", "1[N]*time/(1[s])"),
        restitution=0.5,
    )
    time, state = first_event(
        [0, 0, 0, 0],
        lambda t: [20 * math.sin(7 * t), 2 * t],
        lambda y: 2.5 - y[0],
        3.0,
    )
    step = 1e-3 if method.fixed_step else None
    run = t2.simulate(scene, duration=time + 1e-3, method=method, time_step=step)
    check(run, time)
    assert run.impacts.normal_velocity[0] == pytest.approx(-state[2], abs=1e-8)
