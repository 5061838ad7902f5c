"""Located impacts of bodies that act on each other, against scipy's events; and their energy."""

import itertools
from collections.abc import Callable

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from tamias2d.motion import Reference, RungeKutta4
from tamias2d.scene import Disc, HalfPlane, Scene
from tamias2d.simulate import simulate

Array = np.ndarray


def pair_on_a_spring() -> Scene:
    """The lower ball bounces on the floor, and the upper one feels it through the spring."""
    scene = Scene(gravity=(0, -9.81))
    scene.add_body(Disc(radius=0.5), mass=1, position=(0, 2), restitution=1)
    scene.add_body(Disc(radius=0.3), mass=0.5, position=(0.4, 4), velocity=(1, 0), restitution=1)
    scene.add_static(HalfPlane(normal=(0, 1), offset=0))
    scene.add_spring(0, 1, stiffness=30, rest_length=1.5)
    return scene


def pair_that_attracts() -> Scene:
    """Two heavy balls fall upon each other and bounce, again and again; one also hits a wall."""
    scene = Scene(gravity=(0, 0))
    scene.add_body(Disc(radius=0.5), mass=3, position=(0, 0), velocity=(0, 0.5), restitution=1)
    scene.add_body(Disc(radius=0.3), mass=1, position=(3, 0.5), velocity=(0, -0.2), restitution=1)
    scene.add_static(HalfPlane(normal=(0, 1), offset=-0.6))
    scene.add_attraction(gravitational_constant=2)
    return scene


def spring(q: Array) -> Array:
    span = q[1] - q[0]
    length = np.linalg.norm(span)
    pull = 30 * (length - 1.5) * span / length
    return np.array((pull / 1.0, -pull / 0.5)) + np.array((0, -9.81))


def attraction(q: Array) -> Array:
    span = q[1] - q[0]
    return np.array((1.0 * span, -3.0 * span)) * 2 / np.linalg.norm(span) ** 3


def by_events(
    scene: Scene, accelerations: Callable[[Array], Array], floor: float, duration: float
) -> tuple[list[float], Array]:
    """Integrate both balls with scipy, from one of its events to the next; e = 1 throughout."""
    radius = np.array([body.shape.radius for body in scene.bodies[:2]])  # type: ignore[union-attr]
    mass = np.array([body.mass for body in scene.bodies[:2]])
    y = np.array([(*b.position, *b.velocity) for b in scene.bodies[:2]])
    y = np.concatenate((y[:, :2].ravel(), y[:, 2:].ravel()))

    def rate(_t: float, y: Array) -> Array:
        return np.concatenate((y[4:], accelerations(y[:4].reshape(2, 2)).ravel()))

    gaps = [lambda _t, y, k=k: y[2 * k + 1] - radius[k] - floor for k in (0, 1)]
    gaps.append(lambda _t, y: float(np.hypot(*(y[2:4] - y[:2]))) - radius.sum())
    for gap in gaps:
        gap.terminal, gap.direction = True, -1  # type: ignore[attr-defined]
    time, times = 0.0, []
    while time < duration:
        part = solve_ivp(
            rate, (time, duration), y, method="DOP853", rtol=1e-13, atol=1e-13, events=gaps,
            max_step=0.01,
        )  # fmt: skip
        time, y = float(part.t[-1]), part.y[:, -1].copy()
        if part.status == 1:
            times.append(time)
            hit = next(k for k, found in enumerate(part.t_events) if len(found))
            if hit < 2:
                y[5 + 2 * hit] *= -1
            else:
                normal = (y[2:4] - y[:2]) / np.hypot(*(y[2:4] - y[:2]))
                push = 2 * normal @ (y[6:] - y[4:6]) / (1 / mass).sum() * normal
                y[4:6] += push / mass[0]
                y[6:] -= push / mass[1]
    return times, y


CASES = [(pair_on_a_spring, spring, 0.0, 4.0), (pair_that_attracts, attraction, -0.6, 6.0)]


@pytest.mark.parametrize(("build", "law", "floor", "duration"), CASES)
def test_a_hit_is_felt_by_whoever_is_coupled(
    build: Callable[[], Scene], law: Callable[[Array], Array], floor: float, duration: float
) -> None:
    scene = build()
    run = simulate(scene, duration=duration)
    times, state = by_events(scene, law, floor, duration)
    assert len(run.impacts) == len(times) >= 4
    np.testing.assert_allclose(run.impacts.time, times, rtol=0, atol=1e-9)
    np.testing.assert_allclose(run.position[-1, :2].ravel(), state[:4], rtol=0, atol=1e-9)
    np.testing.assert_allclose(run.velocity[-1, :2].ravel(), state[4:], rtol=0, atol=1e-9)


@pytest.mark.parametrize("build", [pair_on_a_spring, pair_that_attracts])
def test_energy_of_motion_springs_and_attraction_together_stays(
    build: Callable[[], Scene],
) -> None:
    run = simulate(build(), duration=4)
    assert len(run.impacts) > 2
    assert np.ptp(run.energy) < 1e-10 * np.abs(run.energy).max()


def test_momentum_stays_without_walls() -> None:
    scene = Scene(gravity=(0, 0))
    for k in range(4):
        scene.add_body(
            Disc(radius=0.3), mass=k + 1, position=(k, k % 2), velocity=(-k, 1), restitution=0.8
        )
    for i, j in itertools.pairwise(range(4)):
        scene.add_spring(i, j, stiffness=20, rest_length=0.2, damping=0.3, anchor=(0.1, 0.2))
    scene.add_attraction(gravitational_constant=1)
    run = simulate(scene, duration=2)
    assert len(run.impacts) > 2
    for kept in (run.momentum, run.angular_momentum):
        assert np.abs(kept - kept[0]).max() < 1e-10 * np.abs(kept).max()
    assert run.energy[-1] < run.energy[0]


def test_a_stepped_scheme_feels_the_hit_too() -> None:
    """Its impact times come near those of the reference as the step shrinks, by its order."""
    scene = pair_on_a_spring()
    true = simulate(scene, duration=1.5, method=Reference()).impacts.time
    errors = []
    for step in (0.02, 0.01, 0.005):
        times = simulate(scene, duration=1.5, method=RungeKutta4(), time_step=step).impacts.time
        assert len(times) == len(true)
        errors.append(np.abs(times - true).max())
    assert errors[0] > 8 * errors[1] > 64 * errors[2]
    assert errors[2] < 1e-6


def test_the_note_names_every_reason_for_the_reference() -> None:
    scene = Scene(gravity=(0, 0))
    scene.add_body(None, mass=1.0, position=(0, 0), linear_drag=0.5)
    scene.add_field(force=("1[N/s]*time", 0.0))
    (note, *_) = simulate(scene, duration=0.1).notes
    assert "under linear drag and in a field" in note
