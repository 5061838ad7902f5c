"""Numbers at the ends of what can be computed: done in time, or refused by name."""

import warnings

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.contact import RangeError, located
from tamias2d.contact.refusal import UndecidedContactError
from tamias2d.errors import InputError
from tamias2d.event_driven import EventDriven
from tamias2d.solve import Interrupted


def drifting(position: float = 0.0, velocity: float = 1e-9) -> t2.Scene:
    scene = t2.Scene(gravity=(0, 0))
    for k in range(2):
        place, speed = (position, 5.0 * k), (velocity, 0)
        scene.add_body(t2.Disc(radius=1), mass=1, position=place, velocity=speed, restitution=1)
    return scene


@pytest.mark.parametrize("duration", [3e9, 1e300])
def test_too_many_samples_are_refused_before_they_are_made(duration):
    with pytest.raises(InputError, match=r"GiB.*Give `times` of the samples"):
        t2.simulate(drifting(), duration=duration)


@pytest.mark.parametrize("times", [None, [0.0, 4.0]])
@pytest.mark.parametrize("time_step", [1e-9, 1e-300, 5e-324])
def test_too_many_steps_are_refused_before_they_are_made(time_step, times):
    way = {"method": t2.ExplicitEuler(), "time_step": time_step, "times": times}
    with pytest.raises(InputError, match=r"GiB.*Give a larger time_step"):
        t2.simulate(drifting(), duration=4.0, **way)


def test_a_long_closed_form_run_takes_few_samples():
    run = t2.simulate(drifting(), duration=3e9, times=[0.0, 3e9])
    assert run.position[-1, 0, 0] == pytest.approx(3.0)


@pytest.mark.parametrize(
    ("scene", "duration"),
    [
        (drifting(1e200, 1e200), 1.0),
        (drifting(0.0, 1e154), 1e200),
        (drifting(0.0, 1e100), 1e250),
    ],
)
def test_what_float64_cannot_hold_is_refused_without_a_warning(scene, duration):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(RangeError, match="beyond what float64 holds"):
            t2.simulate(scene, duration=duration, times=[0.0, duration])


def test_what_the_scheme_of_2018_cannot_sample_is_refused():
    way = {"method": t2.Legacy2018(), "time_step": 0.1}
    with pytest.raises(InputError, match="Leave times out"):
        t2.simulate(drifting(), duration=1.0, times=[0.0, 0.25], **way)


def spinning(spin: float) -> t2.Scene:
    scene = t2.Scene(gravity=(0, 0))
    scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0))
    box = t2.Box(width=1, height=1)
    turn = {"orientation": 0.3, "angular_velocity": spin, "restitution": 1.0}
    scene.add_body(box, mass=1, position=(0, 2), velocity=(0, -1), **turn)
    return scene


@pytest.mark.parametrize("spin", [1e3, 1e6])
def test_turns_out_of_reach_are_not_looked_at(spin, monkeypatch):
    """The circle around the box meets the plane at 2 - sqrt(1/2) s; the box within a turn of it."""
    looked = []
    placed = t2.contact.conservative_advancement.Pair.placed
    monkeypatch.setattr(
        t2.contact.conservative_advancement.Pair,
        "placed",
        lambda self, time: (looked.append(time), placed(self, time))[1],
    )
    run = t2.simulate(spinning(spin), duration=2.0)
    touches = 2 - np.sqrt(0.5)
    assert touches <= run.impacts.time[0] <= touches + 2 * np.pi / spin
    assert run.energy[-1] == pytest.approx(run.energy[0], rel=1e-12)
    assert len(looked) < 1000


def test_a_pair_that_meets_without_end_is_refused(monkeypatch):
    """As when an impact leaves everything as it was."""
    monkeypatch.setattr(EventDriven, "pays", lambda *_: False)  # which the clock decides
    monkeypatch.setattr(
        located.Located, "_resolve_instant", lambda self, *_: self._schedule_impacts([0, 1])
    )
    with pytest.raises(UndecidedContactError, match="again and again"):
        t2.simulate(spinning(1.0), duration=2.0, method=t2.ClosedForm())


def test_an_interrupt_before_the_first_path_gets_through(monkeypatch):
    def stop(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(located, "refuse_overlap", stop)
    with pytest.raises(Interrupted) as stopped:
        t2.simulate(spinning(1.0), duration=2.0)
    assert stopped.value.run.times.tolist() == [0.0]
    assert stopped.value.run.position[0, 1].tolist() == [0.0, 2.0]
