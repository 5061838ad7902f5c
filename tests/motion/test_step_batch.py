"""Many steps as one path: the same run as step by step, and bounds that hold."""

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.generated import schemes
from tamias2d.motion import Method, integrated
from tamias2d.motion.fixed_steps import FixedSteps
from tamias2d.motion.integrated import IntegratedMotion
from tamias2d.motion.loads import start_states
from tamias2d.motion.step_batch import BatchPath


def bouncing(loads: bool) -> t2.Scene:
    scene = t2.Scene(gravity=(0.0, -9.81))
    for k, drag in enumerate((0.3, 0.0)):
        scene.add_body(
            t2.Disc(radius=0.2),
            mass=1.0 + k,
            position=(1.0 * k, 1.5 + 0.3 * k),
            velocity=(0.7 - k, 0.4),
            restitution=0.9,
            linear_drag=drag,
            force=("2[N]*sin(3[rad/s]*time)", 0.0) if loads else (0.0, 0.0),
        )
    for normal, offset in (((0.0, 1.0), 0.0), ((1.0, 0.0), -1.0), ((-1.0, 0.0), -2.0)):
        scene.add_static(t2.HalfPlane(normal=normal, offset=offset), restitution=0.9)
    return scene


@pytest.mark.parametrize("method", [t2.VelocityVerlet(), t2.RungeKutta4(), t2.SemiImplicitEuler()])
@pytest.mark.parametrize("loads", [False, True])
def test_many_steps_at_once_are_the_same_run(
    method: Method, loads: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = t2.simulate(bouncing(loads), duration=3.0, method=method, time_step=1 / 200)
    monkeypatch.setattr(integrated, "_MOST", 1)
    single = t2.simulate(bouncing(loads), duration=3.0, method=method, time_step=1 / 200)
    assert len(run.impacts) == len(single.impacts) > 8
    # impacts are located to rounding, which each of them makes some times larger
    assert np.allclose(run.impacts.time, single.impacts.time, rtol=0, atol=1e-11)
    assert np.allclose(run.position[-1], single.position[-1], rtol=0, atol=1e-10)


def batch() -> tuple[IntegratedMotion, BatchPath]:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(
        None,
        mass=1.0,
        inertia=0.5,
        position=(1.0, 0.2),
        velocity=(0.0, 1.0),
        angular_velocity=2.0,
    )
    scene.add_spring(0, (0.0, 0.0), stiffness=30.0, rest_length=0.4, anchor=(0.1, 0.0))
    motion = IntegratedMotion(scene, 2.0, FixedSteps(schemes.runge_kutta_4, 2.0, 0.05))
    motion._steps_since_impact = 60
    end, (path,) = motion.segment(0.0, start_states(scene), [None])
    assert end == pytest.approx(30 * 0.05)
    assert isinstance(path, BatchPath)
    return motion, path


def test_bounds_hold_over_every_part_of_many_steps() -> None:
    _, path = batch()
    random = np.random.default_rng(3)
    for first, last in np.sort(random.uniform(0, 1.5, (60, 2)), axis=1).tolist():
        bounds = path.bounds(first, last)
        for time in np.linspace(first, last, 23).tolist():
            x, y, turn = path.acceleration(time)
            _, _, velocity, spin = path.at(time)
            off = np.hypot(x - bounds.acceleration[0], y - bounds.acceleration[1])
            assert off <= bounds.deviation * (1 + 1e-12)
            assert np.hypot(*velocity) <= bounds.speed * (1 + 1e-12)
            assert abs(spin) <= bounds.angular_speed * (1 + 1e-12)
            assert abs(turn) <= bounds.angular_acceleration * (1 + 1e-12)


def test_the_path_is_smooth_from_step_to_step_and_ends_where_it_is_cut() -> None:
    _, path = batch()
    for time in (0.05, 0.4, 1.45):
        before, after = path.at(np.nextafter(time, 0)), path.at(np.nextafter(time, 2))
        assert np.allclose(before.position, after.position, rtol=0, atol=1e-14)
        assert np.allclose(before.velocity, after.velocity, rtol=0, atol=1e-13)
    start, end = path.around(0.42)
    assert start <= 0.42 < end
    cut = path.until(start)
    assert cut.end == start
    assert cut.at(start) == path.at(start)


def test_what_lies_behind_a_wall_does_not_stop_a_run() -> None:
    """The force has no value from 0.3 m below the floor on, where many steps would lead."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    law = "0.1[N]*sqrt(1.3 + y(position)/1[m])"
    scene.add_body(
        t2.Disc(radius=1.0), mass=1.0, position=(0.0, 2.0), restitution=1.0, force=(0.0, law)
    )
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=-2.0))
    run = t2.simulate(scene, duration=5.0, method=t2.VelocityVerlet(), time_step=0.01)
    assert len(run.impacts) >= 2
