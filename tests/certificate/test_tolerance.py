"""A tolerance is met by the cheapest way, or refused with what can be met."""

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.certificate import Certificate, from_json
from tamias2d.replay import check
from tamias2d.run import Run
from tamias2d.study import asked, companion, tolerance as tolerance_module, unweighed
from tamias2d.study.companion import limit_beside
from tamias2d.study.error import history_error
from tamias2d.study.offers import holding
from tamias2d.study.path_error import has_error_equation
from tamias2d.study.pilot import Pilot
from tamias2d.study.refusal import ToleranceError, refusal
from tamias2d.work_limit import WORK_LIMIT
from tools.measurements import held_out


def oscillator() -> t2.Scene:
    """A mass on a spring whose length is not 0, pulled along it: x = 2 + cos(10 t)."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(3.0, 0.0))
    scene.add_spring(0, (0.0, 0.0), stiffness=100.0, rest_length=2.0)
    return scene


def error_of(run: t2.Run) -> float:
    true = np.stack([2 + np.cos(10 * run.times), np.zeros(len(run.times))], axis=-1)
    return float(np.abs(run.position[:, 0] - true).max()) / 2  # the scale: from 3 m to 1 m


@pytest.mark.parametrize("tolerance", [1e-2, 1e-5, 1e-9])
def test_the_true_error_is_within_bound_and_tolerance(tolerance: float) -> None:
    run = t2.simulate(oscillator(), duration=1.0, tolerance=tolerance)
    certificate = run.certificate
    assert certificate is not None
    assert certificate.bound is not None
    assert error_of(run) <= certificate.bound <= tolerance
    assert certificate.bound < 10 * error_of(run)


def test_no_listed_way_is_cheaper() -> None:
    plan = t2.recommend(oscillator(), duration=1.0, tolerance=1e-6)
    costs = [one.force_evaluations for one in plan.estimates]
    assert costs == sorted(costs)
    assert all(one.why for one in plan.estimates)


def test_others_are_weighed_only_where_the_first_does_not_meet_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """To weigh them costs more than they save."""
    weighed = []
    plan = tolerance_module.located_plan
    monkeypatch.setattr(
        tolerance_module, "located_plan", lambda *inputs: weighed.append(inputs) or plan(*inputs)
    )
    run = t2.simulate(oscillator(), duration=1.0, tolerance=1e-6)
    assert not weighed
    assert run.method == t2.Dop853(3e-7)
    assert "no other method was weighed" in run.notes[0]
    far = t2.Scene(gravity=(0.0, 0.0))  # so far out that its rounding is a part of the tolerance
    far.add_body(None, mass=1.0, position=(3e9, 0.0))
    far.add_spring(0, (3e9 - 3.0, 0.0), stiffness=100.0, rest_length=2.0)
    with pytest.raises(t2.ToleranceError):
        t2.simulate(far, duration=1.0, tolerance=1e-7)
    assert weighed


@pytest.mark.parametrize("tolerance", [1e-3, 1e-4])
def test_a_companion_is_returned_where_only_that_meets_it(
    tolerance: float, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """No third run is made for it, and its certificate can be made again."""
    made: list[t2.Method] = []

    def solve(*asked: Any, **inputs: Any) -> t2.Run:
        made.append(inputs["method"])
        return whole(*asked, **inputs)

    whole = asked.solve
    monkeypatch.setattr(asked, "solve", solve)
    monkeypatch.setattr(companion, "solve", solve)
    monkeypatch.setattr(unweighed, "has_error_equation", lambda *_: False)
    run = t2.simulate(oscillator(), duration=10.0, tolerance=tolerance)
    assert made[1:] == [run.method]
    assert run.certificate is not None
    assert run.certificate.bound is not None
    assert error_of(run) <= run.certificate.bound <= tolerance
    monkeypatch.undo()
    run.save(tmp_path / "run.npz")
    assert check(tmp_path / "run.npz").identical


@pytest.mark.parametrize(
    ("name", "tolerance"),
    [("springs 0", 1e-6), ("orbit 1", 1e-8), ("bounces 3", 1e-6), ("mechanism 5", 1e-8)],
)
def test_the_error_beside_a_run_certifies_it(name: str, tolerance: float, tmp_path: Path) -> None:
    """Its certificate can be made again, by one more run."""
    scene = next(one for one in held_out.scenes() if one.name == name)
    run = t2.simulate(scene, duration=scene.duration, tolerance=tolerance)
    exact = t2.simulate(scene, duration=scene.duration, method=t2.Reference(1e-13), times=run.times)
    assert run.certificate is not None
    assert run.certificate.bound is not None
    assert "and the equation of its error" in run.certificate.how
    assert history_error(run, exact) <= run.certificate.bound <= tolerance
    assert run.certificate.bound < 10 * history_error(run, exact)
    run.save(tmp_path / "run.npz")
    assert check(tmp_path / "run.npz").identical


def test_the_error_beside_what_stands_still_gives_no_run_up() -> None:
    """Rounding is all that moves there: it says nothing of how far off the run will be."""
    scene = t2.catalogue.load("windmill")
    run = t2.simulate(scene, duration=scene.duration, tolerance=1e-4)
    assert run.certificate is not None
    assert run.certificate.how.endswith("and the equation of its error")
    assert "try" not in run.notes[0]


def test_chaos_is_refused_before_other_methods_are_weighed(monkeypatch: pytest.MonkeyPatch) -> None:
    """None of them can be certified, and what is offered instead holds."""
    monkeypatch.setattr(tolerance_module, "located_plan", None)
    scene = t2.Scene(gravity=(0.0, -9.81))
    for position in ((1.2, 0.0), (2.4, 0.1)):
        scene.add_body(None, mass=1.0, position=position)
    scene.add_spring(0, (0.0, 0.0), stiffness=60.0, rest_length=1.0)
    scene.add_spring(0, 1, stiffness=60.0, rest_length=1.0)
    with pytest.raises(t2.ToleranceError, match="a change of 1e-12 of the scale") as refused:
        t2.simulate(scene, duration=200.0, tolerance=1e-6)
    assert refused.value.until is not None
    run = t2.simulate(scene, duration=refused.value.until, tolerance=1e-6)
    assert "no other method was weighed" in run.notes[0]


@pytest.mark.parametrize("name", ["walker", "ball-and-chain"])
def test_joints_that_switch_have_no_equation_of_the_error(name: str) -> None:
    scene = t2.catalogue.load(name)
    smooth = not any(joint.switches for joint in scene.joints)
    assert has_error_equation(scene, t2.Dop853(1e-6), 1.0) == smooth == (name != "walker")
    assert not has_error_equation(scene, t2.Dop853(1e-11), 1.0)


@pytest.mark.parametrize(
    ("name", "tolerance", "how"),
    [
        ("springs 0", 1e-6, "halved=True) against whole steps"),
        ("orbit 1", 1e-8, "halved=True) against Dop853"),
    ],
)
def test_halved_steps_that_meet_something_sudden_are_certified(
    name: str, tolerance: float, how: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """By the whole ones beside them, or if that is not enough by shorter ones."""
    monkeypatch.setattr(unweighed, "has_error_equation", lambda *_: False)
    scene = next(one for one in held_out.scenes() if one.name == name)
    run = t2.simulate(scene, duration=scene.duration, tolerance=tolerance)
    exact = t2.simulate(scene, duration=scene.duration, method=t2.Reference(1e-13), times=run.times)
    assert run.certificate is not None
    assert run.certificate.bound is not None
    assert how in run.certificate.how
    assert history_error(run, exact) <= run.certificate.bound
    run.save(tmp_path / "run.npz")
    assert check(tmp_path / "run.npz").identical


def test_a_looser_tolerance_costs_less() -> None:
    costs = []
    for tolerance in (1e-9, 1e-6, 1e-3):
        run = t2.simulate(oscillator(), duration=1.0, tolerance=tolerance)
        assert run.cost is not None
        costs.append(run.cost.force_evaluations)
    assert costs == sorted(costs, reverse=True)


def test_the_closed_form_costs_nothing() -> None:
    scene = t2.catalogue.load("tc1")
    run = t2.simulate(scene, duration=4.0, tolerance=1e-10)
    assert run.method == t2.ClosedForm()
    assert run.certificate is not None
    assert run.certificate.kind == "exact"


def test_a_run_too_short_for_float64_is_not_told_to_be_shorter() -> None:
    """Its body goes hardly farther than places are rounded; over a longer time it goes on."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_body(None, mass=1.0, position=(0.0, 1.0), velocity=(1.0, 0.0), linear_drag=0.1)
    with pytest.raises(
        ToleranceError, match=r"R5\)\. Let the run last longer, or give a tolerance"
    ):
        t2.simulate(scene, duration=1e-12, tolerance=1e-6)
    assert t2.simulate(scene, duration=1e-9, tolerance=1e-6).certificate is not None


def test_without_a_tolerance_there_is_no_certificate_and_the_same_run() -> None:
    scene = oscillator()
    run = t2.simulate(scene, duration=1.0)
    assert run.certificate is None
    certified = t2.certify(run)
    assert certified.digest() == run.digest()
    assert certified.certificate is not None


def test_a_plan_is_the_same_each_time() -> None:
    assert t2.recommend(oscillator(), duration=1.0, tolerance=1e-4) == t2.recommend(
        oscillator(), duration=1.0, tolerance=1e-4
    )


def test_what_cannot_be_met_is_refused_with_what_can() -> None:
    scene = t2.catalogue.load("billiard")
    with pytest.raises(t2.ToleranceError, match="give a tolerance of") as refused:
        t2.simulate(scene, duration=6.0, tolerance=1e-14)
    reachable = refused.value.reachable
    assert reachable is not None
    assert t2.simulate(scene, duration=6.0, tolerance=reachable).certificate is not None


@pytest.mark.parametrize("tolerance", [0.0, -1.0, 1e-17, 2.0, float("nan"), "1e-6", True])
def test_what_is_no_tolerance_is_refused(tolerance: object) -> None:
    with pytest.raises(t2.InputError, match=r"tolerance .*R5"):
        t2.simulate(oscillator(), duration=1.0, tolerance=tolerance)  # type: ignore[arg-type]


def test_tolerance_and_method_are_not_asked_for_together() -> None:
    with pytest.raises(t2.InputError, match="Give one of the two"):
        t2.simulate(oscillator(), duration=1.0, method=t2.Reference(), tolerance=1e-3)


@pytest.mark.parametrize("suffix", [".npz", ".rrd"])
def test_a_recording_keeps_the_certificate_and_replays(tmp_path: Path, suffix: str) -> None:
    run = t2.simulate(oscillator(), duration=1.0, tolerance=1e-4)
    path = tmp_path / f"run{suffix}"
    run.save(path)
    assert Run.load(path).certificate == run.certificate
    assert check(path).identical


def test_a_certificate_survives_json() -> None:
    run = t2.simulate(oscillator(), duration=1.0, tolerance=1e-4)
    certificate = run.certificate
    assert isinstance(certificate, Certificate)
    assert from_json(certificate.to_json()) == certificate
    assert "\n" not in str(certificate)
    with pytest.raises(t2.RecordingError, match="cannot be read"):
        from_json('{"kind": "exact"}')


def test_hashes_follow_the_scene() -> None:
    first = t2.simulate(oscillator(), duration=1.0, tolerance=1e-2).certificate
    other = oscillator()
    other.add_body(None, mass=1.0, position=(0.0, 0.0))
    second = t2.simulate(other, duration=1.0, tolerance=1e-2).certificate
    assert first is not None
    assert second is not None
    assert first.hashes["scene"] != second.hashes["scene"]
    assert first.hashes["code"] == second.hashes["code"]
    assert all(len(value) == 64 for value in first.hashes.values())


def test_the_measure_sees_turning() -> None:
    scene = t2.catalogue.load("pendulum")
    coarse = t2.simulate(
        scene, duration=1.0, method=t2.VelocityVerlet(), time_step=0.05, times=[0.0, 0.5, 1.0]
    )
    fine = t2.simulate(scene, duration=1.0, times=[0.0, 0.5, 1.0])
    assert history_error(coarse, fine) > 1e-5


def test_a_scene_without_bodies_and_one_far_away_are_certified() -> None:
    nothing = t2.simulate(t2.Scene(gravity=(0.0, 0.0)), duration=1.0, tolerance=1e-3)
    assert nothing.certificate is not None
    assert nothing.certificate.bound == 0.0
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(1e6, 0.0), velocity=(1e-6, 0.0))
    far = t2.simulate(scene, duration=1.0, tolerance=1e-3)
    assert far.certificate is not None
    assert far.certificate.bound is not None
    assert 1e-5 < far.certificate.bound < 1e-3


def rattling() -> t2.Scene:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(
        None, mass=1.0, position=(0.0, 0.0), force=("1[N]*sin(1e3[rad/s]*time)", "0[N]"), name="a"
    )
    return scene


def test_pilots_that_would_take_too_long_are_refused_with_what_to_do() -> None:
    with pytest.raises(t2.ToleranceError, match=r"End the run at .* work_limit of about") as e:
        t2.simulate(rattling(), duration=1.0, tolerance=1e-6, work_limit=100)
    needed = int(float(str(e.value).split("work_limit of about ")[1].split(",")[0]))
    run = t2.simulate(rattling(), duration=1.0, tolerance=1e-6, work_limit=needed)
    assert run.certificate is not None
    assert run.certificate.meets(1e-6)
    until = e.value.until
    assert until is not None
    assert t2.simulate(rattling(), duration=until, tolerance=1e-6, work_limit=100).certificate


def test_pilots_together_take_twice_the_work_of_a_run_at_most() -> None:
    limit = 2000
    scene = rattling()
    pilot = Pilot(scene, 1.0, 1e-6, limit)
    for method in (t2.RungeKutta4(), t2.VelocityVerlet(), t2.SemiImplicitEuler()):
        pilot.fixed_step(method, math.inf)
    assert pilot.spent <= 16 * 2 * limit  # of all schemes, order 8 asks most often in a step


def test_companions_of_a_long_run_may_be_longer() -> None:
    run = t2.simulate(rattling(), duration=1.0, method=t2.Dop853(1e-8))
    assert run.cost is not None
    assert limit_beside(run) == WORK_LIMIT
    long = replace(run, cost=replace(run.cost, steps=WORK_LIMIT))
    assert limit_beside(long) == 4 * WORK_LIMIT


def test_what_is_offered_can_be_asked_for() -> None:
    fault = refusal(1e-2, 0.0123)
    assert fault.reachable == 0.013
    assert "give a tolerance of 0.013 or more" in str(fault)
    far = refusal(1e-2, 0.83)
    assert far.reachable is None
    assert "at most 0.1 can be asked for" in str(far)


def test_offers_that_are_refused_are_not_made() -> None:
    def meet(tolerance: float | None, time: float) -> None:
        asked.append((tolerance, time))
        if tolerance is not None:
            raise ToleranceError("refused, too.", 2 * tolerance)
        if time > 1.5:
            raise ToleranceError("not so long.", until=1.5)

    asked: list[tuple[float | None, float]] = []
    refused = ToleranceError("refused.", 1e-3, until=2.0, otherwise="give up")
    found = holding(refused, 4.0, meet)
    assert found.reachable is None
    assert found.until == 1.5
    assert str(found) == "refused. End the run at 1.5 s, or give up."
    assert asked == [(1e-3, 4.0), (2e-3, 4.0), (None, 2.0), (None, 1.5)]


def test_what_stands_still_but_for_rounding_is_measured_by_its_size() -> None:
    run = t2.simulate(t2.catalogue.load("windmill"), duration=2.0, tolerance=1e-6)
    assert run.certificate is not None
    assert run.certificate.meets(1e-6)
    assert np.ptp(run.position, axis=0).max() < 1e-12


def test_tolerances_beyond_float64_are_refused_as_such() -> None:
    with pytest.raises(t2.ToleranceError, match="tolerance 1e-15"):
        t2.simulate(t2.catalogue.load("pendulum"), duration=0.1, tolerance=1e-15)


@pytest.mark.parametrize("tolerance", [1e-1, 1e-2, 1e-5])
@pytest.mark.parametrize(("eccentricity", "periods"), [(0.998, 5.3), (0.999, 3.3)])
def test_a_loose_tolerance_is_met_where_a_tight_one_is(
    eccentricity: float, periods: float, tolerance: float
) -> None:
    """Long steps miss how two stars pass each other closely; they were all that was tried."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    fastest = math.sqrt(2 * (1 - eccentricity) / (1 + eccentricity))
    scene.add_body(None, mass=1.0, position=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(1 + eccentricity, 0.0), velocity=(0.0, fastest))
    scene.add_attraction(gravitational_constant=1.0)
    duration = periods * math.tau / math.sqrt(2)
    run = t2.simulate(scene, duration=duration, tolerance=tolerance)
    assert run.certificate is not None
    assert run.certificate.meets(tolerance)


def test_fast_spin_is_no_long_way() -> None:
    scene = t2.Scene(gravity=(0, 0))
    scene.add_body(t2.Disc(radius=0.1), mass=1, position=(1, 0), angular_velocity=1e5)
    scene.add_field(force=("-1[N/m]*x(position)-1[N/m^3]*x(position)**3", "0[N]"))
    run = t2.simulate(scene, duration=10.0, tolerance=1e-4)
    exact = t2.simulate(scene, duration=10.0, method=t2.Dop853(rtol=1e-13))
    assert run.certificate is not None
    assert "the 2.2 m that the farthest one goes" in run.certificate.measure
    assert np.abs(run.position - exact.position).max() < 1e-4 * 2.2


@pytest.mark.parametrize(
    ("name", "duration", "tolerance"), [("kepler", 10.0, 1e-6), ("pendulum", 0.7, 1e-7)]
)
def test_the_scale_does_not_depend_on_the_samples(
    name: str, duration: float, tolerance: float, tmp_path: Path
) -> None:
    scene, found = t2.catalogue.load(name), set()
    for times in (None, [0.0, duration], [duration], [0.99 * duration, duration], [0.1, 0.1]):
        run = t2.simulate(scene, duration=duration, times=times, tolerance=tolerance)
        assert times is None or run.times.tolist() == times
        assert run.certificate is not None
        found.add((run.method, run.certificate.bound, run.certificate.measure))
        mine = t2.simulate(scene, duration=duration, times=times, method=t2.Dop853(rtol=1e-8))
        judged = t2.certify(mine).certificate
        assert judged is not None
        assert judged.measure == run.certificate.measure
    assert len(found) == 1
    run.save(tmp_path / "run.npz")
    assert check(tmp_path / "run.npz").identical


@pytest.mark.parametrize("drag", [0.0, 0.1])
def test_runs_too_short_for_their_rounding_are_to_last_longer(drag: float) -> None:
    scene = t2.Scene(gravity=(0, -9.81))
    scene.add_body(t2.Disc(radius=0.5), mass=1, position=(0, 5), quadratic_drag=drag)
    with pytest.raises(t2.ToleranceError, match="Let the run last longer") as refused:
        t2.simulate(scene, duration=1e-6, tolerance=1e-8)
    assert refused.value.reachable is not None
    assert t2.simulate(scene, duration=1e-3, tolerance=1e-8).certificate is not None
