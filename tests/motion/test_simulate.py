"""What `simulate` takes, refuses and says."""

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.contact import Located
from tamias2d.errors import InputError
from tamias2d.event_driven import EventDriven
from tamias2d.simulator import Stepper
from tamias2d.solve import Interrupted


def falling() -> t2.Scene:
    scene = t2.Scene(gravity=(0, -9.81))
    scene.add_body(t2.Disc(radius=0.5), mass=2, position=(0, 5), restitution=0.8)
    scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0))
    return scene


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"duration": 0}, "duration 0 s of the run: must be > 0"),
        ({"duration": -1.0}, "duration -1 s of the run: must be > 0"),
        ({"duration": float("nan")}, "must be finite"),
        ({"duration": float("inf")}, "must be finite"),
        ({"duration": True}, "must be a number"),
        ({"duration": "4"}, "must be a number"),
        ({"duration": 1, "time_step": 0.1}, "takes no time step"),
        ({"duration": 1, "method": t2.VelocityVerlet()}, "needs time step"),
        ({"duration": 1, "method": t2.VelocityVerlet(), "time_step": 0}, "must be > 0"),
        ({"duration": 1, "method": t2.VelocityVerlet}, "must be a method"),
        ({"duration": 1, "method": "verlet"}, "must be a method"),
        ({"duration": 1, "times": [0.5, 0.25]}, r"times\[0\] 0.5 s of the run: 0.25 s follows"),
        ({"duration": 1, "times": [0.5, 2]}, r"times\[1\]"),
        ({"duration": 1, "times": [-0.5]}, "must be >= 0"),
        ({"duration": 1, "times": []}, "found none"),
        ({"duration": 1, "times": 3}, "must be a list"),
    ],
)
def test_bad_arguments_are_one_clear_line(arguments, message):
    with pytest.raises(InputError, match=message) as error:
        t2.simulate(falling(), **arguments)
    assert "\n" not in str(error.value)


def test_closed_form_refuses_loads_that_vary():
    scene = t2.Scene(gravity=(0, 0))
    scene.add_body(None, mass=1, position=(0, 0), force=("1[N]*time/(1[s])", 0), name="kite")
    with pytest.raises(InputError, match=r"'kite' is under a force .* varies with time"):
        t2.simulate(scene, duration=1, method=t2.ClosedForm())


@pytest.mark.parametrize("rtol", [0, 1e-15, 1, float("nan")])
def test_reference_refuses_tolerances_that_float64_cannot_meet(rtol):
    with pytest.raises(InputError, match="from 1e-13"):
        t2.Reference(rtol=rtol)


def test_samples():
    sixty = t2.simulate(falling(), duration=0.5)
    assert len(sixty.times) == 31
    assert sixty.times[-1] == 0.5
    steps = t2.simulate(falling(), duration=0.5, method=t2.VelocityVerlet(), time_step=0.15)
    assert steps.times == pytest.approx([0, 0.15, 0.3, 0.45, 0.5])
    asked = t2.simulate(falling(), duration=0.5, times=np.array([0.1, 0.1, 0.4]))
    assert asked.times.tolist() == [0.1, 0.1, 0.4]
    assert asked.position.shape == (3, 2, 2)
    assert asked.orientation.shape == asked.angular_velocity.shape == (3, 2)


def test_balance():
    run = t2.simulate(falling(), duration=0.5)
    assert run.energy == pytest.approx(2 * 9.81 * 5, rel=1e-14)
    assert run.momentum[:, 1] == pytest.approx(-2 * 9.81 * run.times, abs=1e-13)
    assert run.angular_momentum.tolist() == [0.0] * 31


def test_an_impact_belongs_to_the_time_after_it():
    run = t2.simulate(falling(), duration=1.0)
    again = t2.simulate(falling(), duration=1.0, times=run.impacts.time)
    assert again.velocity[0, 0, 1] > 0


@pytest.mark.parametrize("method", [t2.VelocityVerlet(), t2.RungeKutta4(), t2.Reference()])
def test_impacts_are_located_between_the_steps_of_any_method(method):
    step = 0.1 if method.fixed_step else None
    exact = t2.simulate(falling(), duration=6.0)
    run = t2.simulate(falling(), duration=6.0, method=method, time_step=step)
    count = 8
    np.testing.assert_allclose(
        run.impacts.time[:count], exact.impacts.time[:count], rtol=0, atol=1e-10
    )


def test_interrupted_run_keeps_what_was_computed(monkeypatch):
    def stop(self, duration):
        def told(time):
            if time > 1.2:
                raise KeyboardInterrupt

        go(self, duration, told=told)

    go = Located.go
    monkeypatch.setattr(EventDriven, "pays", lambda *_: False)  # which the clock decides
    monkeypatch.setattr(Located, "go", stop)
    with pytest.raises(Interrupted) as stopped:
        t2.simulate(falling(), duration=4.0)
    assert isinstance(stopped.value, KeyboardInterrupt)
    run = stopped.value.run
    assert len(run.impacts) == 2
    assert 0 <= run.impacts.time[1] - run.times[-1] < 1 / 60
    assert str(stopped.value).startswith("Run of 4 s: interrupted at 2.4")


def test_steps_interrupted_before_the_first_sample_keep_the_start(monkeypatch):
    def stop(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(Stepper, "go", stop)
    with pytest.raises(Interrupted) as stopped:
        t2.simulate(falling(), duration=1.0, method=t2.Stepped(), time_step=0.1, times=[1.0])
    run = stopped.value.run
    assert run.times.tolist() == [0.0]
    np.testing.assert_array_equal(run.position[0], [b.position for b in falling().bodies])


def test_progress_bar(capsys):
    run = t2.simulate(falling(), duration=1.0, progress=True)
    assert len(run.impacts) == 1
    assert capsys.readouterr().out == ""  # it goes to standard error


def test_scene_without_bodies():
    run = t2.simulate(t2.Scene(gravity=(0, -1)), duration=1.0)
    assert run.position.shape == (61, 0, 2)
    assert run.energy.tolist() == [0.0] * 61


def test_digest_tells_runs_apart():
    runs = [t2.simulate(falling(), duration=d).digest() for d in (1.0, 1.0, 1.5)]
    assert runs[0] == runs[1] != runs[2]


def test_unknown_ending():
    with pytest.raises(InputError, match=r"\.rrd or \.npz"):
        t2.simulate(falling(), duration=0.1).save("ball.txt")
