"""A run without a foreseeable end is refused early, with the history up to there (R4)."""

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.motion import legacy
from tamias2d.motion.adaptive import Adaptive
from tamias2d.motion.memoised_field import MemoisedField
from tamias2d.solve import Interrupted
from tamias2d.study import certify, companion, quality, tolerance
from tamias2d.study.offers import holding
from tamias2d.study.refusal import refusal
from tamias2d.work_limit import WORK_LIMIT, Work, WorkLimitError


def driven(force: str) -> t2.Scene:
    scene = t2.Scene(gravity=(0, 0))
    scene.add_body(t2.Disc(radius=0.1), mass=1, position=(0, 0), force=(force, 0.0))
    return scene


def between_walls(speed: float) -> t2.Scene:
    scene = t2.Scene(gravity=(0, 0))
    scene.add_body(t2.Disc(radius=0.1), mass=1, position=(0, 0), velocity=(speed, 0), restitution=1)
    for side in (1, -1):
        scene.add_static(t2.HalfPlane(normal=(side, 0), offset=-1), restitution=1)
    return scene


ENDLESS = {
    "fast force": (driven("1[N]*sin(1e6[rad/s]*time)"), "steps to come"),
    "pole": (driven("1[N*s]/(time-0.5[s])"), "steps to come"),
    "square pole": (driven("1[N*s^2]/(time-0.5[s])**2"), "steps to come"),
    "fast disc": (between_walls(1e7), "impacts to come"),
}


@pytest.mark.parametrize("name", ENDLESS)
def test_endless_work_is_refused_early_with_the_run_up_to_there(name: str) -> None:
    scene, found = ENDLESS[name]
    with pytest.raises(WorkLimitError, match=found) as refused:
        t2.simulate(scene, duration=1.0)
    run = refused.value.run
    assert isinstance(run, t2.Run)
    assert run.cost.steps + run.cost.impacts <= 4000  # of 100 000: early
    assert run.times[-1] <= refused.value.time < run.times[-1] + 1 / 60
    assert np.isfinite(run.energy).all()


def test_a_run_refused_before_its_first_sample_is_its_start() -> None:
    with pytest.raises(WorkLimitError) as refused:
        t2.simulate(driven("1[N]*sin(1e6[rad/s]*time)"), duration=1.0, times=[0.5, 1.0])
    assert refused.value.run.times.tolist() == [0.0]


def test_a_run_refused_beyond_float64_keeps_what_is_finite() -> None:
    with pytest.raises(t2.SimulationError, match="beyond what float64 holds") as refused:
        t2.simulate(driven("1[N]*exp(1000[1/s]*time)"), duration=10.0)
    run = refused.value.run
    assert 1 < len(run.times) < 60
    assert np.isfinite(run.energy).all()


def test_a_stiff_spring_is_followed_to_its_end() -> None:
    scene = t2.Scene(gravity=(0, 0))
    scene.add_body(t2.Disc(radius=0.1), mass=1, position=(1.5, 0))
    scene.add_spring(0, (0, 0), stiffness=1e6, rest_length=1.0)
    run = t2.simulate(scene, duration=0.1)
    np.testing.assert_allclose(run.position[:, 0, 0], 1 + 0.5 * np.cos(1e3 * run.times), atol=1e-8)


def test_the_limit_counts_steps_and_impacts_and_is_a_number_of_the_user() -> None:
    scene = between_walls(100.0)
    assert t2.simulate(scene, duration=1.0).cost.impacts == 56
    with pytest.raises(WorkLimitError, match="56 impacts: must be at most 55") as refused:
        t2.simulate(scene, duration=1.0, work_limit=55)
    assert len(refused.value.run.impacts) == 56
    assert t2.simulate(scene, duration=1.0, work_limit=56).cost.impacts == 56


def test_pairs_that_push_each_other_again_and_again_at_an_instant_are_impacts_once() -> None:
    """A heavy disc drops on a light one, which rests on a floor: the three meet in many rounds."""
    scene = t2.Scene(gravity=(0, -9.81))
    scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0), restitution=0.2)
    for mass, height in ((0.1, 0.5), (10.0, 2.0)):
        scene.add_body(t2.Disc(radius=0.5), mass=mass, position=(0, height), restitution=0.2)
    run = t2.simulate(scene, duration=1.0, method=t2.ClosedForm(), work_limit=2)
    assert run.cost.impacts == 2
    assert len(run.impacts) > 100
    with pytest.raises(WorkLimitError, match="2 impacts: must be at most 1"):
        t2.simulate(scene, duration=1.0, method=t2.ClosedForm(), work_limit=1)


def test_steps_of_a_given_length_do_not_count() -> None:
    run = t2.simulate(
        driven("1[N]*sin(10[rad/s]*time)"),
        duration=1.0,
        method=t2.VelocityVerlet(),
        time_step=0.01,
        work_limit=1,
    )
    assert run.cost.steps == 100


@pytest.mark.parametrize("bad", [0, -1, 1.5, True, None, "many"])
def test_a_limit_is_a_whole_number(bad: object) -> None:
    with pytest.raises(t2.InputError, match=r"work_limit .*whole number"):
        t2.simulate(between_walls(1.0), duration=1.0, work_limit=bad)


def test_bounces_that_come_to_rest_are_not_taken_for_endless() -> None:
    """Each is shorter than the one before: the last 1000 of 2000 take a thousandth of the time."""
    work, time = Work(1e3), 0.0
    for k in range(2000):
        time += 0.993**k
        work.impacts(1, time)
        work.step(time)


def test_a_burst_of_steps_is_not_taken_for_the_whole_run() -> None:
    work = Work(1.0)
    for k in range(1, 1001):
        work.step(k * 2e-6)  # at this pace half a million would be left
    for k in range(1, 1001):
        work.step(k * 1e-3)


def test_the_limit_itself_is_reached_and_not_passed() -> None:
    work = Work(1.0)
    for k in range(1, WORK_LIMIT + 1):
        work.step(k / WORK_LIMIT)
    with pytest.raises(WorkLimitError, match="100001 steps and 0 impacts: must"):
        work.step(1.0)


def stopped_at(call: int, monkeypatch: pytest.MonkeyPatch, owner: object, name: str) -> None:
    """Let Ctrl-C come at a call of a function."""
    function, calls = getattr(owner, name), []

    def counted(*arguments: object, **more: object) -> object:
        calls.append(None)
        if len(calls) == call:
            raise KeyboardInterrupt
        return function(*arguments, **more)

    monkeypatch.setattr(owner, name, counted)


@pytest.mark.parametrize(
    ("method", "owner", "name", "call"),
    [
        (None, MemoisedField, "__call__", 1000),
        (t2.Dop853(rtol=1e-12), Adaptive, "batch", 5),
    ],
    ids=str,
)
def test_ctrl_c_ends_a_run_without_contacts_with_its_history(
    method: object, owner: object, name: str, call: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    stopped_at(call, monkeypatch, owner, name)
    with pytest.raises(Interrupted) as stopped:
        t2.simulate(driven("1[N]*sin(1e3[rad/s]*time)"), duration=1.0, method=method)
    run = stopped.value.run
    assert 1 < len(run.times) < 61
    # the double integral of sin(w t)
    exact = run.times / 1e3 - np.sin(1e3 * run.times) / 1e6
    np.testing.assert_allclose(run.position[:, 0, 0], exact, rtol=0, atol=1e-9)


def test_ctrl_c_ends_a_run_of_2018_with_its_start(monkeypatch: pytest.MonkeyPatch) -> None:
    stopped_at(5, monkeypatch, legacy, "_step")
    with pytest.raises(Interrupted) as stopped:
        t2.simulate(
            driven("1[N]*sin(1[rad/s]*time)"), duration=1.0, method=t2.Legacy2018(), time_step=0.1
        )
    assert stopped.value.run.times.tolist() == [0.0]


def falling() -> t2.Scene:
    """Return a ball that bounces in air."""
    scene = t2.Scene(gravity=(0, -9.81))
    scene.add_body(t2.Disc(radius=0.1), mass=1, position=(0, 2), quadratic_drag=0.1)
    scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0), restitution=0.8)
    return scene


@pytest.mark.parametrize(
    ("asked", "owner", "name"),
    [
        ({"tolerance": 1e-6}, tolerance, "pairs_that_can_meet"),
        ({"tolerance": 1e-6}, certify, "penetrations"),
        ({"tolerance": 1e-12}, companion, "solve"),
        ({"quality": 1e-3}, quality, "steps_because"),
    ],
    ids=["choice", "certificate", "companion", "quality"],
)
def test_ctrl_c_between_tries_leaves_the_start(
    asked: dict[str, float], owner: object, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    stopped_at(1, monkeypatch, owner, name)
    scene = falling()
    with pytest.raises(Interrupted) as stopped:
        t2.simulate(scene, duration=1.0, **asked)
    assert stopped.value.run.times.tolist() == [0.0]
    assert stopped.value.run.scene == scene


def test_ctrl_c_in_a_try_leaves_its_history(monkeypatch: pytest.MonkeyPatch) -> None:
    stopped_at(20, monkeypatch, Adaptive, "batch")
    with pytest.raises(Interrupted) as stopped:
        t2.simulate(driven("1[N]*sin(1e3[rad/s]*time)"), duration=1.0, tolerance=1e-6)
    run = stopped.value.run
    assert 1 < len(run.times) < 61
    assert run.certificate is None


def test_ctrl_c_while_an_offer_is_tried_is_not_swallowed() -> None:
    def stopped(*_: object) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        holding(refusal(1e-9, 1e-6), 1.0, stopped)
