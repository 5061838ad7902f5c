"""Smooth motion against exact answers: oracles A1 to A4, orders of schemes, the 2018 tables."""

import math

import numpy as np
import pytest

import tamias2d as t2

FIXED_STEP = [t2.ExplicitEuler(), t2.SemiImplicitEuler(), t2.VelocityVerlet(), t2.RungeKutta4()]
EXACT = [t2.ClosedForm(), t2.Reference(), t2.VelocityVerlet(), t2.RungeKutta4()]


def run(scene: t2.Scene, duration: float, method, count: int = 60, **more) -> t2.Run:
    step = duration / count if method.fixed_step else None
    return t2.simulate(scene, duration=duration, method=method, time_step=step, **more)


def pushed() -> t2.Scene:
    scene = t2.Scene(gravity=(0, 0))
    scene.add_body(None, mass=2, position=(0, 0), velocity=(1, 2), force=(3, -4))
    return scene


@pytest.mark.parametrize("method", EXACT)
def test_constant_force(method):
    """A1."""
    last = run(pushed(), 2.0, method)
    assert last.position[-1, 0].tolist() == pytest.approx([5, 0], abs=2e-12)
    assert last.velocity[-1, 0].tolist() == pytest.approx([4, -2], abs=2e-12)


@pytest.mark.parametrize(("method", "sign"), [(FIXED_STEP[0], -1), (FIXED_STEP[1], 1)])
def test_constant_of_the_euler_errors(method, sign):
    """A1: the error is a h T/2, exactly, below or above."""
    last = run(pushed(), 2.0, method, 50)
    error = sign * np.array((1.5, -2.0)) * 0.04 * 2 / 2
    assert last.position[-1, 0] - (5, 0) == pytest.approx(error, abs=1e-14)


@pytest.mark.parametrize("degrees", [0, 45, 90, 135, 180, 225, 270, -60])
@pytest.mark.parametrize("method", EXACT)
def test_projectile(degrees, method):
    """A2, over the whole history."""
    a = math.radians(degrees)
    scene = t2.Scene(gravity=(0, -9.81))
    scene.add_body(None, mass=1, position=(0, 0), velocity=(20 * math.cos(a), 20 * math.sin(a)))
    history = run(scene, 1.5, method)
    t = history.times
    exact = np.stack((20 * t * math.cos(a), 20 * t * math.sin(a) - 9.81 * t**2 / 2), axis=-1)
    np.testing.assert_allclose(history.position[:, 0], exact, rtol=0, atol=2e-12)
    assert history.energy == pytest.approx(history.energy[0], rel=1e-12)


@pytest.mark.parametrize("method", EXACT)
def test_constant_torque(method):
    """A3."""
    scene = t2.Scene(gravity=(0, 0))
    scene.add_body(None, mass=1, inertia=2, torque=3, position=(0, 0), angular_velocity=-1)
    last = run(scene, 4.0, method)
    assert last.orientation[-1, 0] == pytest.approx(8, abs=5e-12)
    assert last.angular_velocity[-1, 0] == pytest.approx(5, abs=5e-12)


def test_fast_spin():
    """A4: no limit on speed or angle."""
    scene = t2.Scene(gravity=(0, 0))
    scene.add_body(t2.Box(width=1, height=1), mass=1, position=(0, 0), angular_velocity=1e5)
    assert run(scene, 1.0, t2.ClosedForm()).orientation[-1, 0] == 1e5


def shaken() -> t2.Scene:
    scene = t2.Scene(gravity=(0, 0))
    scene.add_body(
        None,
        mass=2,
        inertia=0.5,
        position=(1, 0),
        velocity=(1, 0),
        force=("10[N]*sin(2[rad/s]*time)", 0),
        torque="1[N*m]*cos(3[rad/s]*time)",
    )
    return scene


def shaken_error(history: t2.Run) -> float:
    """Integrated by hand."""
    t = history.times
    place = 1 + t + 2.5 * (t - np.sin(2 * t) / 2)
    turn = 2 / 9 * (1 - np.cos(3 * t))
    return max(
        np.abs(history.position[:, 0, 0] - place).max(),
        np.abs(history.orientation[:, 0] - turn).max(),
    )


@pytest.mark.parametrize(("method", "order"), list(zip(FIXED_STEP, (1, 1, 2, 4), strict=True)))
def test_orders(method, order):
    errors = [shaken_error(run(shaken(), 3.3, method, 40 * 2**k)) for k in range(5)]
    found = np.log2(np.array(errors[:-1]) / errors[1:])
    assert found == pytest.approx(order, abs=0.1)


@pytest.mark.parametrize("method", FIXED_STEP)
def test_between_steps_the_order_is_kept(method):
    times = np.linspace(0, 3.3, 101)
    coarse, fine = (
        shaken_error(run(shaken(), 3.3, method, count, times=times)) for count in (160, 320)
    )
    order = {"ExplicitEuler": 1, "SemiImplicitEuler": 1, "VelocityVerlet": 2, "RungeKutta4": 4}
    assert math.log2(coarse / fine) == pytest.approx(order[type(method).__name__], abs=0.25)


def test_reference_is_taken_where_loads_vary():
    history = t2.simulate(shaken(), duration=20.0)
    assert "varies with time" in history.notes[0]
    assert shaken_error(history) < 2e-11


@pytest.mark.parametrize("method", [t2.ClosedForm(), *FIXED_STEP])
def test_rotated_scene_has_the_rotated_answer(method):
    """A2, metamorphic: directions are all alike."""

    def ends(angle: float) -> np.ndarray:
        c, s = math.cos(angle), math.sin(angle)
        turn = np.array(((c, s), (-s, c)))
        scene = t2.Scene(gravity=np.array((0.3, -9.81)) @ turn)
        scene.add_body(
            None,
            mass=3,
            position=np.array((1.0, 2.0)) @ turn,
            velocity=np.array((4.0, 5.0)) @ turn,
            force=tuple((np.array((0.5, -0.25)) @ turn).tolist()),
        )
        return run(scene, 1.5, method).position[-1, 0] @ turn.T

    for angle in (0.3, 1.0, 2.0, 4.0):
        assert ends(angle) == pytest.approx(ends(0.0), abs=1e-13)


def test_published_table_of_2018():
    """TC2 of the plan, with its halved displacements: steps 32, 63, 94 and 121 of 0.03333 s."""
    scene = t2.Scene(gravity=(0, 0))
    scene.add_body(None, mass=10, position=(20, 20), force=(100, 0))
    history = t2.simulate(scene, duration=121 * 0.03333, method=t2.Legacy2018(), time_step=0.03333)
    at = [32, 63, 94, 121]
    assert history.position[at, 0, 0] == pytest.approx([22.84, 31.02, 44.54, 60.66], abs=0.01)
    assert history.velocity[at, 0, 0] == pytest.approx([10.50, 20.83, 31.16, 40.16], abs=0.01)


def test_paths_with_and_without_neighbours_are_the_same():
    """Whether other bodies are watched must not change how one moves."""
    for method in (t2.ClosedForm(), t2.VelocityVerlet(), t2.Reference()):
        runs = []
        for neighbours in (0, 1):
            scene = t2.Scene(gravity=(0, -9.81))
            for k in range(1 + neighbours):
                scene.add_body(
                    t2.Disc(radius=0.5),
                    mass=1,
                    position=(100 * k, 0),
                    velocity=(1, 2),
                    restitution=1,
                )
            runs.append(run(scene, 1.5, method).position[:, 0])
        np.testing.assert_allclose(*runs, rtol=0, atol=1e-12)
