"""Every comparison passes what is right, and fails what is wrong by a little."""

import math
from collections.abc import Callable
from typing import Any

import pytest

from tamias2d.errors import SpecError
from tests.verify.conftest import Judged

Change = Callable[[Any], object]


def put(*path: Any) -> Change:
    """Put the last of the path in the place that the others name."""
    *where, last, value = path

    def change(data: Any) -> None:
        for key in where:
            data = data[key]
        data[last] = value

    return change


WRONG: list[tuple[str, str, Change]] = [
    ("TC2", "exact", put("exact", "bodies", "body", "position",
                         "vector(20[m] + 5.00001[m/s^2]*time**2, 20[m])")),
    ("TC2", "exact", put("exact", "bodies", "body", "velocity",
                         "vector(10[m/s^2]*time, 0.000001[m/s])")),
    ("TC2", "exact", put("scene", "tc3")),
    ("OA3", "final", put("final", "bodies", "body", "orientation", "8.0000001[rad]")),
    ("OB6b", "moments", put("moments", "states", 1, "at", "1.75[s]")),
    ("OB8b", "impacts", put("impacts", "count", "30")),
    ("OB4", "impacts", put("impacts", "times", 0, "0.1000001[s]")),
    ("OB4", "impacts", put("impacts", "times", ["0.1[s]", "0.2[s]"])),
    ("OB4", "impacts", put("impacts", "impulses", 0, "5.5935926 N*s")),
    ("OB3", "conserves", put("conserves", "energy", "constant")),
    ("OB6d", "conserves", put("conserves", "momentum", "constant")),
    ("OA14a", "schemes", put("exact", "bodies", "body", "position",
                            "vector(1[m]*sin(2[rad/s]*time), 1.001[m/s]*time*exp(-time/1[s]))")),
    ("OA5", "exact", put("scene", "bodies", "body", "linear_drag", "0.500000001 kg/s")),
    ("OA5", "exact", put("exact", "reference", "1e-17")),
    ("OA5", "schemes", put("scene", "bodies", "body", "linear_drag", "0.5001 kg/s")),
    ("OA5", "schemes", put("schemes", "orders", ["velocity_verlet"])),
    ("OA5", "schemes", put("schemes", "shows", "velocity_verlet", "2")),
    ("OA10b", "schemes", put("final", "bodies", "body", "orientation", "-0.332976[rad]")),
    ("OA10", "moments", put("moments", "states", 1, "at", "1.000000001[s]")),
    ("OE3", "certified", put("exact", "bodies", "light", "position",
                             "vector(1.501[m]*cos(time*sqrt(0.5[1/s^2])), 0[m])")),
    ("OE3", "certified", put("certified", "tolerance", "0.1")),
    ("OJ24", "worlds", put("worlds", "bodies", "bob", "position", "vector(0[m], 0.65[m])")),
    ("OA12b", "conserves", put("conserves", "schemes", {"explicit_euler": "30"})),
    ("OA9j", "schemes", put("schemes", "steps", "26")),
    ("OA9j", "schemes", put("schemes", "durations", {"dop853": "1 s"})),
    ("OA1", "schemes", put("schemes", "constants", "explicit_euler", "body", "position",
                           "vector(1.5[m/s^2], -2[m/s^2])*time*time_step/2")),
    ("TC5", "published", put("published", "tables", "second", "position", 1, ["300.0", "72.06"])),
    ("TC5", "published", put("published", "misprints", 0, "reads", "628.0")),
    ("TC5", "published", put("published", "tables", "third", "position", 0, ["628.41", "-6.82"])),
    ("TC8", "published", put("published", "time_step", "0.0333333333 s")),
    ("OB1", "values", put("values", "calls", 0, "expect", "impulse", "0.77712998542468 N*s")),
    ("OB1", "values", put("values", "calls", 0, "given", "angular_velocity_b", "3 rad/s")),
    ("OD1", "values", put("values", "calls", 1, "expect", "overlap", "false")),
    ("OC1", "refuses", put("refuses", "scenes", "negative mass", "says", "charge")),
    ("OC1", "refuses", put("refuses", "scenes", "negative mass", "scene", "bodies", "body",
                           "mass", "1 kg")),
    ("OG23", "stepped", put("stepped", "bodies", "plank", "position",
                            "vector(0[m], 1.5[m] - 1.626*9.81[m]/256**2)")),
    ("OG25", "stepped", put("scene", "gravity", ["0 m/s^2", "-1e-9 m/s^2"])),
    ("OA9k", "notes", put("notes", "scenes", "Verlet with steps of 0.2002 s", "time_step",
                          "0.2 s")),
]  # fmt: skip


@pytest.mark.parametrize(("id", "comparison"), sorted({(id, name) for id, name, _ in WRONG}))
def test_passes_as_it_stands(judged: Judged, id: str, comparison: str) -> None:
    outcomes = judged(id, comparison)
    assert outcomes
    assert [str(one) for one in outcomes if one.verdict != "pass"] == []


@pytest.mark.parametrize(("id", "comparison", "change"), WRONG)
def test_fails_when_wrong(judged: Judged, id: str, comparison: str, change: Change) -> None:
    assert "fail" in {one.verdict for one in judged(id, comparison, change)}


def test_reference_fails_when_the_event_search_differs(
    judged: Judged, monkeypatch: pytest.MonkeyPatch
) -> None:
    from tamias2d.verify import reference

    search = reference.simulate_by_events

    def late(*args: Any, **named: Any) -> Any:
        found = search(*args, **named)
        found.time[-1] += 1e-8
        return found

    only = put("reference", "scenes", {"oblique-discs": "3 s"})
    assert {one.verdict for one in judged("TC13", "reference", only)} == {"pass"}
    monkeypatch.setattr(reference, "simulate_by_events", late)
    times, *others = judged("TC13", "reference", only)
    assert times.verdict == "fail"
    assert {one.verdict for one in others} == {"pass"}


def test_survey_is_judged_by_people(judged: Judged) -> None:
    (outcome,) = judged("TC12", "survey")
    assert outcome.verdict == "manual"
    assert outcome.as_json()["error"] is None


def test_wrong_unit_of_an_answer_is_refused(judged: Judged) -> None:
    change = put("exact", "bodies", "body", "position", "vector(20[m], 20[s])")
    with pytest.raises(SpecError, match="position"):
        judged("TC2", "exact", change)


def test_too_few_impacts_are_an_infinite_error(judged: Judged) -> None:
    change = put("impacts", "times", ["0.1[s]", "0.15[s]"])
    outcome = judged("OB4", "impacts", change)[1]
    assert math.isinf(outcome.error)


def test_a_clock_fails_no_case(judged: Judged) -> None:
    slow = judged("TC14", "pace", put("pace", "tolerance", "1e-9"))
    assert [one.verdict for one in slow] == ["manual"]
    assert "Measure it again" in slow[0].note
