"""Studies: what is tried, what it costs, what fails, and what is drawn and written of it."""

import json
import math
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest

from tamias2d.cost import Cost
from tamias2d.errors import InputError
from tamias2d.motion import RungeKutta4
from tamias2d.scene import Scene, catalogue
from tamias2d.simulate import simulate
from tamias2d.study import candidates, plot as drawn, stepped_plan, truth, work_precision
from tamias2d.study.candidates import Candidate
from tamias2d.study.event_errors import Errors
from tamias2d.study.plot import plot
from tamias2d.study.refusal import ToleranceError
from tamias2d.study.report import as_json, schema
from tamias2d.study.truth import affordable_phases, truth_of
from tamias2d.study.work_precision import Point, Study, study


def points_of(found: Study, method: str) -> list[Point]:
    return [point for point in found.points if point.method == method]


def test_costs_are_counted(studied: Study) -> None:
    """Of a scheme with s stages that knows its last force: s times the steps, and a first one."""
    for method, evaluations in (("VelocityVerlet", 1), ("Yoshida4", 3), ("RungeKutta4", 4)):
        for point in points_of(studied, method):
            if point.cost:
                assert point.setting == f"{point.cost.steps} steps"
                assert point.cost.force_evaluations == evaluations * point.cost.steps + 1
                assert point.seconds is None


def test_too_long_steps_are_points_with_a_reason(studied: Study) -> None:
    """Verlet stands steps of 2/40 s at most: 40 of them in 2 s."""
    failed = [point.setting for point in points_of(studied, "VelocityVerlet") if point.failure]
    assert failed == ["16 steps", "32 steps"]
    reason = points_of(studied, "VelocityVerlet")[0].failure or ""
    assert "time_step 0.125 s" in reason


def test_errors_fall_at_the_order_of_the_scheme(
    spring: Scene, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(work_precision, "_FIRST", 128)
    monkeypatch.setattr(work_precision, "_RUNGS", 2)
    monkeypatch.setattr(candidates, "TOLERANCES", (1e-4,))
    found = study(spring, duration=0.2, timed=False)
    for method, order in (("SemiImplicitEuler", 1), ("VelocityVerlet", 2), ("RungeKutta4", 4)):
        coarse, fine = (point.error for point in points_of(found, method))
        assert coarse is not None
        assert fine is not None
        assert math.log2(coarse.size / fine.size) == pytest.approx(order, abs=0.1)


def test_the_closed_form_alone_is_on_the_lean_front(studied: Study) -> None:
    assert [studied.points[k].method for k in studied.leanest] == ["ClosedForm"]
    assert studied.complete
    assert studied.truth == "closed form"


def by_hand(*points: Point) -> Study:
    return Study(
        scene="none", duration=1.0, truth="by hand", floor=1e-9, phases=1, impacts=0,
        points=points, complete=True,
    )  # fmt: skip


def point(method: str, error: float, evaluations: int, *, peer: bool = False) -> Point:
    cost = Cost(steps=1, rejected=0, force_evaluations=evaluations, impacts=0)
    found = Errors(position=error)
    return Point(method=method, setting="", peer=peer, error=found, worst=found, cost=cost)


def test_a_front_by_hand() -> None:
    """Another engine, what is off by more than all, and what is below the floor do not count."""
    found = by_hand(
        point("Peer", 1e-12, 1, peer=True),
        point("Lost", 2.0, 1),
        point("Cheap", 1e-1, 2),
        point("Good", 1e-10, 50),
        point("Better than can be known", 1e-11, 60),
    )
    assert found.leanest == [2, 3]


def test_an_error_without_limit_is_null_in_json() -> None:
    report = as_json(by_hand(point("Broken", math.inf, 1)), tolerance=None)
    jsonschema.validate(report, schema())
    assert report["points"][0]["error"]["size"] is None
    json.dumps(report, allow_nan=False)


def test_other_engines_are_shown_but_never_on_the_front(studied: Study) -> None:
    peers = [k for k, point in enumerate(studied.points) if point.peer]
    assert len(peers) == 6
    told = studied.points[peers[-1]]
    assert told.method == "pyb2d3"
    assert told.failure is not None
    assert "which is not translated" in told.failure
    assert not {*peers} & {*studied.leanest, *studied.fastest}


def test_phases_give_median_and_worst(bounce: Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(work_precision, "_RUNGS_OF_IMPACTS", 2)
    monkeypatch.setattr(candidates, "TOLERANCES", (1e-4,))
    found = study(bounce, duration=1.5, phases_asked=4, timed=False)
    assert found.phases == 4
    point = points_of(found, "SemiImplicitEuler")[1]
    assert point.error is not None
    assert point.worst is not None
    assert 0 < point.error.size < point.worst.size
    exact = points_of(found, "VelocityVerlet")
    assert len(exact) == 1  # nothing is gained by more steps
    assert exact[0].worst is not None
    assert exact[0].worst.size < 1e-12


def test_a_stopped_study_keeps_what_it_has(spring: Scene) -> None:
    def stop(of: int, done: int, what: str) -> None:  # noqa: ARG001
        if done == 3:
            raise KeyboardInterrupt

    found = study(spring, duration=0.5, told=stop, timed=False)
    assert not found.complete
    assert len(found.points) == 3


def test_a_scene_of_other_loads_has_a_reference(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(work_precision, "_RUNGS", 1)
    monkeypatch.setattr(candidates, "TOLERANCES", (1e-4,))
    found = study(catalogue.load("kepler"), duration=1.0, timed=False)
    assert found.truth == "Reference(rtol=1e-13)"
    assert found.floor < 1e-11
    assert not points_of(found, "ClosedForm")


def test_a_report_keeps_its_schema(studied: Study) -> None:
    report = as_json(studied, tolerance=1e-6)
    jsonschema.validate(report, schema())
    assert json.loads(json.dumps(report, allow_nan=False)) == report
    report["points"][0]["error"]["position"] = -1.0
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(report, schema())


def test_a_study_is_drawn_with_its_failures(studied: Study, tmp_path: Path) -> None:
    path = tmp_path / "study.svg"
    plot(studied, path, tolerance=1e-6)
    text = path.read_text()
    for words in ("tolerance 1e-06", "VelocityVerlet", "Pymunk", "spring, 2 s"):
        assert f"<!-- {words}" in text
    for suffix in (".jpeg2000", ".gif"):  # which would not move
        with pytest.raises(InputError, match=rf"suffix '\{suffix}': .* \.png, \.svg, \.pdf\. Give"):
            plot(studied, tmp_path / f"study{suffix}", tolerance=None)


def test_an_engine_that_is_missing_is_named_and_has_no_point(
    studied: Study, tmp_path: Path
) -> None:
    from matplotlib.figure import Figure

    missing = tuple(
        Point(method=p.method, setting=p.setting, peer=True, failure="is not installed")
        if p.peer
        else p
        for p in studied.points
    )
    axes = Figure().subplots()
    drawn._rim(axes, replace(studied, points=[p for p in missing if p.peer]), drawn._seconds)
    assert len(axes.lines) == 0
    path = tmp_path / "study.svg"
    plot(replace(studied, points=missing), path, tolerance=None)
    assert "<!-- Pymunk: nothing was measured -->" in path.read_text()


@pytest.mark.parametrize(
    ("low", "high", "labels"), [(2e-3, 2e-2, 3), (1.3e-3, 8e-2, 5), (1e-9, 1.0, 5)]
)
def test_labels_of_an_axis_are_a_few(low: float, high: float, labels: int) -> None:
    """Powers of ten, or twos and fives beside them; nothing else, which would overlap."""
    from matplotlib.figure import Figure

    axes = Figure().subplots()
    axes.set(xscale="log", yscale="log", xlim=(low, high), ylim=(low, high))
    drawn._mark(axes)
    for axis in (axes.xaxis, axes.yaxis):
        shown = [label for label in axis.get_ticklabels(which="both") if label.get_text()]
        inside = [one for one in shown if low <= 10 ** _power(one.get_text()) <= high]
        assert len(inside) >= labels
        assert len(shown) <= 12


def _power(text: str) -> float:
    """Return the power of ten of a label, as 5 * 10^-3 in TeX."""
    found = re.search(r"(?:(\d)\s*\\times)?\s*\{?10\^\{(.*?)\}", text)
    assert found is not None, text
    return math.log10(float(found[1] or 1)) + float(found[2].replace("\N{MINUS SIGN}", "-"))


def test_a_method_that_is_not_finite_has_an_error_without_limit(spring: Scene) -> None:
    def run(scene: Scene, duration: float, times: Any) -> Any:
        run = simulate(scene, duration=duration, method=RungeKutta4(), time_step=0.01, times=times)
        return replace(run, position=run.position * np.nan)

    point = work_precision.point_of(
        Candidate("Broken", "", run), [spring], [truth_of(spring, 1.0)], timed=False
    )
    assert point.error is not None
    assert point.error.size == math.inf
    assert not point.valid


def test_a_long_study_is_refused_before_it_starts(monkeypatch: pytest.MonkeyPatch) -> None:
    """By the first part of it that takes too long; that its code is loaded counts for nothing."""
    real, asked = truth.solve, []

    def counted(scene: Scene, **inputs: Any) -> Any:
        asked.append(inputs["duration"])
        return real(scene, **inputs)

    monkeypatch.setattr(truth, "solve", counted)
    monkeypatch.setattr(truth, "_LONGEST", 1e-6)
    scene = catalogue.load("kepler")
    with pytest.raises(ToleranceError, match=r"End the run at .* s, or ask") as refused:
        study(scene, duration=10.0)
    assert refused.value.until is not None
    assert 0.0 < refused.value.until < 10.0
    assert asked == [10.0 / 64] * 2


def test_where_nothing_can_meet_nothing_is_simulated_to_know_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(stepped_plan, "solve", lambda *_, **__: pytest.fail("simulated"))
    assert stepped_plan.stepped_because(catalogue.load("kepler"), 10.0) is None
    net = stepped_plan.stepped_because(catalogue.load("joint-grid"), 10.0)
    assert net == "joints hold 893 moving bodies, more than 400"


def test_a_setting_that_would_take_long_is_not_run(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tamias2d.study.schedule.LONGEST", 1e-9)
    found = study(catalogue.load("kepler"), duration=1.0, timed=False)
    of_one = points_of(found, "RungeKutta4")
    assert of_one[0].failure is None
    assert all("not run: it would take" in (point.failure or "") for point in of_one[1:])


def test_a_study_without_a_point_is_none(spring: Scene) -> None:
    def stop(of: int, done: int, what: str) -> None:  # noqa: ARG001
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        study(spring, duration=0.5, told=stop, timed=False)


def test_phases_are_as_many_as_there_is_time_for(
    bounce: Scene, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tamias2d.study.truth.LONGEST", 1e9)
    assert affordable_phases(bounce, 1.5, 2) == 2
    monkeypatch.setattr("tamias2d.study.truth.LONGEST", 1e-9)
    assert affordable_phases(bounce, 1.5, 32) == 1
