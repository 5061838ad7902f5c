"""Paths in closed form: they solve their equations, keep their bounds, and are hit on time."""

import math

import numpy as np
import pytest
from hypothesis import given, strategies as st
from scipy.integrate import solve_ivp

from tamias2d.errors import InputError
from tamias2d.motion import ClosedForm, ExponentialDrag, PathPiece, Reference
from tamias2d.motion.closed_form import ClosedFormMotion
from tamias2d.motion.loads import start_states
from tamias2d.scene import Disc, HalfPlane, Scene, catalogue
from tamias2d.simulate import simulate

number = st.floats(-5, 5)
vector = st.tuples(number, number)
positive = st.floats(0.01, 20)


def dragged(
    velocity: tuple[float, float], drag: float, gravity: tuple[float, float], torque: float = 3
) -> Scene:
    scene = Scene(gravity=gravity)
    ball = Disc(radius=0.5)
    scene.add_body(
        ball, mass=2, position=(1, 2), velocity=velocity, torque=torque, linear_drag=drag
    )
    return scene


def sprung(velocity: tuple[float, float], stiffness: float, gravity: tuple[float, float]) -> Scene:
    scene = Scene(gravity=gravity)
    scene.add_body(Disc(radius=0.5), mass=2, position=(1, 2), velocity=velocity, torque=3)
    scene.add_spring(0, (-1, 0.5), stiffness=stiffness, rest_length=0)
    return scene


scenes = st.builds(dragged, vector, positive, vector) | st.builds(sprung, vector, positive, vector)


def path(scene: Scene, duration: float) -> PathPiece:
    _, pieces = ClosedFormMotion(scene, duration).segment(0.0, start_states(scene), [None])
    return pieces[0]


@given(scenes, st.floats(0, 3), st.floats(0, 3), st.floats(0, 1))
def test_bounds_hold_within_their_window(scene: Scene, one: float, two: float, x: float) -> None:
    piece = path(scene, 3.0)
    first, last = sorted((one, two))
    time = min(max(first + x * (last - first), first), last)
    bounds = piece.bounds(first, last)
    ax, ay, turn = piece.acceleration(time)
    off = math.hypot(ax - bounds.acceleration[0], ay - bounds.acceleration[1])
    assert off <= bounds.deviation
    assert math.hypot(*piece.at(time).velocity) <= bounds.speed
    assert abs(piece.at(time).angular_velocity) <= bounds.angular_speed
    assert abs(turn) <= bounds.angular_acceleration


@given(scenes)
def test_a_window_that_shrinks_has_bounds_that_shrink(scene: Scene) -> None:
    """What looks for impacts refines its window and counts on it."""
    piece = path(scene, 3.0)
    wide, narrow = piece.bounds(1.0, 1.1).deviation, piece.bounds(1.0, 1.001).deviation
    size = math.hypot(*piece.acceleration(1.0)[:2]) + math.hypot(*piece.at(1.0).velocity)
    assert narrow <= wide
    assert narrow <= 0.05 * size + 1e-9


@given(scenes)
def test_a_path_starts_at_its_state_to_the_bit_and_samples_agree(scene: Scene) -> None:
    piece = path(scene, 3.0)
    assert piece.at(0.0) == start_states(scene)[0]
    times = np.linspace(0, 3, 7)
    rows = [
        (*s.position, s.orientation, *s.velocity, s.angular_velocity)
        for s in map(piece.at, times.tolist())
    ]
    np.testing.assert_allclose(piece.sample(times), rows, rtol=1e-13, atol=1e-13)


@pytest.mark.parametrize(
    "scene", [dragged((3, -4), 0.7, (1, -9.81)), sprung((3, -4), 30, (1, -9.81))]
)
def test_a_path_solves_newtons_law(scene: Scene) -> None:
    """The forces are written down anew here, and scipy integrates."""
    body = scene.bodies[0]
    pull = scene.springs[0].stiffness if scene.springs else 0.0

    def rate(_time: float, y: np.ndarray) -> np.ndarray:
        force = pull * (np.array((-1, 0.5)) - y[:2]) - body.linear_drag * y[2:]
        return np.concatenate((y[2:], force / 2 + (1, -9.81)))

    start = (*body.position, *body.velocity)
    true = solve_ivp(rate, (0, 3), start, method="DOP853", rtol=1e-12, atol=1e-12).y[:, -1]
    for method in (None, Reference()):
        run = simulate(scene, duration=3, method=method)
        found = (*run.position[-1, 0], *run.velocity[-1, 0])
        np.testing.assert_allclose(found, true, rtol=1e-10)
        assert run.orientation[-1, 0] == pytest.approx(3 / (0.5 * 2 * 0.5**2) * 4.5, rel=1e-12)
    assert isinstance(simulate(scene, duration=3).method, ClosedForm)


def test_a_wall_is_hit_on_the_way_of_an_oscillation() -> None:
    """From 1 m the surface passes 0.5 m at arccos(0.6)/10 s; the speed is 10 * 0.8 m/s."""
    scene = Scene(gravity=(0, 0))
    scene.add_body(Disc(radius=0.1), mass=1, position=(1, 0), restitution=1)
    scene.add_spring(0, (0, 0), stiffness=100, rest_length=0)
    scene.add_static(HalfPlane(normal=(1, 0), offset=0.5))
    run = simulate(scene, duration=20)
    first = math.acos(0.6) / 10
    np.testing.assert_allclose(run.impacts.time, first * np.arange(1, len(run.impacts) * 2, 2))
    assert abs(run.impacts.time[0] - first) < 1e-15
    assert run.impacts.normal_velocity[0] == pytest.approx(-8, rel=1e-14)
    assert np.ptp(run.energy) < 1e-11
    assert len(run.impacts) == 108


def test_a_ball_under_drag_bounces_when_the_reference_says_so() -> None:
    scene = dragged((1, 3), 0.8, (0, -9.81), torque=0)
    scene.add_static(HalfPlane(normal=(0, 1), offset=0))
    scene.set_restitution(0, 1, 0.9)
    exact = simulate(scene, duration=4)
    other = simulate(scene, duration=4, method=Reference())
    assert len(exact.impacts) == len(other.impacts) > 4
    np.testing.assert_allclose(exact.impacts.time, other.impacts.time, rtol=0, atol=1e-10)
    assert np.all(np.diff(exact.energy) < 1e-12)  # neither drag nor bounces give back


def test_a_ball_at_rest_under_drag_slides_to_a_stop() -> None:
    """On a floor it goes on for m v / c and no further, and never sinks."""
    scene = Scene(gravity=(0, -9.81))
    scene.add_body(
        Disc(radius=0.5), mass=2, position=(0, 0.5), velocity=(3, 0), linear_drag=4, restitution=0
    )
    scene.add_static(HalfPlane(normal=(0, 1), offset=0))
    run = simulate(scene, duration=30)
    assert isinstance(run.method, ClosedForm)
    assert run.position[-1, 0, 0] == pytest.approx(2 * 3 / 4, rel=1e-12)
    assert np.all(run.position[:, 0, 1] == 0.5)


def test_a_ball_on_the_floor_oscillates_along_it() -> None:
    """The spring also presses it down by 100 N/m times 0.3 m, which the floor bears."""
    scene = Scene(gravity=(0, -9.81))
    scene.add_body(Disc(radius=0.5), mass=1, position=(1, 0.5), restitution=0)
    scene.add_static(HalfPlane(normal=(0, 1), offset=0))
    scene.add_spring(0, (0, 0.2), stiffness=100, rest_length=0)
    run = simulate(scene, duration=3)
    assert isinstance(run.method, ClosedForm)
    np.testing.assert_allclose(run.position[:, 0, 0], np.cos(10 * run.times), atol=1e-13)
    np.testing.assert_allclose(run.position[:, 0, 1], 0.5, rtol=1e-15)


def test_drag_that_bears_a_falling_ball_does_not_bear_it_at_rest() -> None:
    """At the impact the drag of 8 kg/s is more than the weight; after it, there is none."""
    scene = dragged((0, -9), 8, (0, -10), torque=0)
    scene.add_static(HalfPlane(normal=(0, 1), offset=0))
    scene.set_restitution(0, 1, 0)
    run = simulate(scene, duration=2)
    (hit,) = run.impacts.time
    assert run.impacts.normal_velocity[0] * -8 > 20
    assert f"from {hit.item():.15g} s" in run.notes[-1]
    assert np.all(run.position[run.times > hit, 0, 1] == 0.5)


def test_no_exact_path_is_claimed_where_something_else_acts() -> None:
    def refused(change: str) -> str:
        scene = sprung((0, 0), 5, (0, 0))
        match change:
            case "anchor":
                scene.add_body(Disc(radius=1), mass=1, position=(9, 9))
                scene.add_spring(1, (3, 0), stiffness=1, rest_length=0, anchor=(0.5, 0))
            case "length":
                scene.add_spring(0, (5, 5), stiffness=1, rest_length=1)
            case "field":
                scene.add_field(force=("1[N/m]*x(position)", 0))
            case "attraction":
                scene.add_body(None, mass=1, position=(9, 9))
                scene.add_attraction(gravitational_constant=1)
        with pytest.raises(InputError) as caught:
            simulate(scene, duration=1, method=ClosedForm())
        return str(caught.value)

    for change in ("anchor", "length", "field", "attraction"):
        assert "has no closed form" in refused(change)
    for name in ("quadratic-drag", "damped-oscillator", "kepler", "pendulum"):
        assert isinstance(simulate(catalogue.load(name), duration=0.1).method, Reference)
    scene = sprung((0, 0), 5, (0, 0))
    scene.add_field(force=("2[m/s^2]*mass", 1))  # a law, but one that does not change
    assert isinstance(simulate(scene, duration=0.1).method, ClosedForm)


def test_angular_drag_slows_turning() -> None:
    """The angular velocity decays as exp(-c t/I); numbers of linear drag in other units."""
    scene = Scene(gravity=(0, 0))
    scene.add_body(None, mass=1, inertia=2, position=(0, 0), angular_velocity=10, angular_drag=0.5)
    scene.add_body(None, mass=1, inertia=2, position=(0, 0), torque=1.0, angular_drag=0.5)
    ways = [(None, None, 1e-14), (Reference(), None, 1e-12), (ExponentialDrag(), 0.01, 1e-13)]
    for method, step, tolerance in ways:
        run = simulate(scene, duration=3.0, method=method, time_step=step)
        assert run.angular_velocity[-1, 0] == pytest.approx(4.7236655274101471, rel=tolerance)
        assert run.orientation[-1, 0] == pytest.approx(21.105337890359412, rel=tolerance)
        ends = 2 * (1 - math.exp(-0.75))  # of the terminal angular velocity, torque over drag
        assert run.angular_velocity[-1, 1] == pytest.approx(ends, rel=tolerance)
