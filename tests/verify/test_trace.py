"""Verdicts are rolled up, the worst one wins, and a change of the specification shows."""

from typing import Any

import pytest
from hypothesis import given, strategies as st

from tamias2d.errors import InputError
from tamias2d.trace import (
    NONE,
    WORST_FIRST,
    Graph,
    exit_code,
    neighbourhood,
    plan_table,
    trace,
    worst,
)
from tamias2d.verify import results, verify
from tamias2d.verify.items import items
from tamias2d.verify.outcome import Outcome
from tamias2d.verify.suite import cases


def item(id: str, kind: str, *, hash: str = "h", **links: list[str]) -> dict[str, Any]:
    return {
        "id": id, "kind": kind, "title": "", "file": "f", "line": 1, "hash": hash,
        "links": links, "code": [], "data": {},
    }  # fmt: skip


def own_hash(case: Any) -> str:
    return str(case["hash"])


def small(**verdicts: str) -> Graph:
    """A goal on two requirements on two models on an assumption, with a case for each model."""
    found = [
        item("A1", "assumption"),
        item("IM1", "model", uses=["A1"]),
        item("IM2", "model", uses=["A1"]),
        item("R1", "requirement", uses=["IM1"]),
        item("R2", "requirement", uses=["IM2"]),
        item("GS1", "goal", uses=["R1", "R2"]),
        item("TC1", "case", verifies=["R1"], uses=["IM1"]),
        item("TC2", "case", verifies=["R2"], uses=["IM2"]),
        item("LC1", "change", affects=["A1"]),
    ]
    outcomes = {
        id: [Outcome(id, "q", 0.0, 1.0, verdict.split()[0], "old" if "stale" in verdict else "h")]
        for id, verdict in verdicts.items()
    }
    return Graph({each["id"]: each for each in found}, outcomes, own_hash)


def test_all_passes() -> None:
    graph = small(TC1="pass", TC2="pass")
    assert {graph.verdict(id) for id in graph.items if id != "LC1"} == {"pass"}
    assert graph.verdict("LC1") == NONE


@pytest.mark.parametrize(
    ("second", "expected"),
    [("fail", "fail"), ("pass stale", "stale"), ("fail stale", "stale"), ("manual", "manual")],
)
def test_the_worst_verdict_rises_to_the_goal(second: str, expected: str) -> None:
    graph = small(TC1="pass", TC2=second)
    assert [graph.verdict(id) for id in ("R1", "IM1")] == ["pass", "pass"]
    assert [graph.verdict(id) for id in ("R2", "IM2", "A1", "GS1")] == [expected] * 4


def test_a_case_that_was_not_run_says_so() -> None:
    graph = small(TC1="pass")
    assert [graph.verdict(id) for id in ("TC2", "R2", "GS1")] == ["not run"] * 3


def deep(third: str) -> Graph:
    """The small specification; IM1 rests on DD1, which no case names, and DD1 on DD2."""
    items = dict(small().items) | {
        "DD1": item("DD1", "definition", uses=["DD2"]),
        "DD2": item("DD2", "definition"),
        "IM1": item("IM1", "model", uses=["A1", "DD1"]),
        "OA1": item("OA1", "case", uses=["DD2"]),
        "OA2": item("OA2", "case", verifies=["R2"], uses=["DD1"]),
    }
    verdicts = {"TC1": "pass", "TC2": "pass", "OA1": third, "OA2": "pass"}
    outcomes = {
        id: [Outcome(id, "q", 0.0, 1.0, verdict, "h")]
        for id, verdict in verdicts.items()
        if verdict != "not run"
    }
    return Graph(items, outcomes, own_hash)


@pytest.mark.parametrize("third", ["fail", "pass", "manual", "not run"])
def test_what_a_requirement_rests_on_through_others_counts(third: str) -> None:
    graph = deep(third)
    assert [graph.verdict(id) for id in ("DD2", "R1", "GS1")] == [third] * 3
    assert [graph.verdict(id) for id in ("DD1", "IM1", "R2")] == ["pass"] * 3
    assert graph.unrun("R1") == (["DD2"] if third == "not run" else [])


DEMANDS = [id for id, each in items().items() if each["kind"] in ("goal", "requirement")]
CASES = [id for id, each in items().items() if each["kind"] == "case"]


@pytest.mark.parametrize("failed", CASES)
def test_no_requirement_passes_over_a_failure(failed: str) -> None:
    """Where one case fails, so do all demands that rest on what it names, but for people's."""
    outcomes = {
        id: [Outcome(id, "q", 0.0, 1.0, "fail" if id == failed else "pass", "h")] for id in CASES
    }
    graph = Graph(items(), outcomes, lambda _: "h")
    failing = set(graph.forward[failed]).difference(
        id for id, each in items().items() if each["kind"] == "assumption"
    )
    for id in DEMANDS:
        if graph.verdict(id) in ("pass", "uncovered"):
            assert not failing & {id, *graph.reach(id, graph.forward)}, id


def test_what_was_not_run_is_named_by_the_items_that_show_it() -> None:
    assert small().unrun("GS1") == ["IM1", "IM2"]
    graph = small(TC1="pass")
    assert [graph.unrun(id) for id in ("R1", "R2", "GS1", "A1", "TC2")] == [
        *([], ["R2"], ["IM2"], ["A1"], ["TC2"])
    ]
    graph.items["TC3"] = item("TC3", "case", uses=["IM1"])
    assert Graph(graph.items, graph.outcomes, own_hash).unrun("R1") == ["IM1"]


@pytest.mark.parametrize("id", DEMANDS)
@pytest.mark.parametrize("own", [True, False])
def test_verify_runs_what_a_verdict_waits_for(id: str, own: bool) -> None:
    def passed(ids: list[str]) -> dict[str, list[Outcome]]:
        return {case: [Outcome(case, "q", 0.0, 1.0, "pass", "h")] for case in ids}

    done = [] if own else Graph(items(), {}).cases(id)
    before = Graph(items(), passed(done), lambda _: "h")
    asked = before.unrun(id)
    assert bool(asked) == (before.verdict(id) == "not run")
    done += [case.id for case in cases(asked)]
    after = Graph(items(), passed(done), lambda _: "h")
    assert after.unrun(id) == []
    assert after.verdict(id) in ("pass", "manual")


def test_a_requirement_without_cases_is_uncovered_whatever_its_models_say() -> None:
    graph = small(TC1="pass", TC2="pass")
    graph.items["R3"] = item("R3", "requirement", uses=["IM1"])
    again = Graph(graph.items, graph.outcomes, own_hash)
    assert again.verdict("R3") == "uncovered"


def test_what_people_judge_is_manual_without_cases() -> None:
    graph = small()
    graph.items["NFR5"] = item("NFR5", "requirement") | {"data": {"judged": "by people"}}
    assert Graph(graph.items, {}, own_hash).verdict("NFR5") == "manual"


def test_a_circle_of_links_ends() -> None:
    graph = small(TC1="pass", TC2="pass")
    graph.items["R1"]["links"]["uses"].append("R2")
    graph.items["R2"]["links"]["uses"].append("R1")
    assert Graph(graph.items, graph.outcomes, own_hash).verdict("GS1") in ("pass", "uncovered")


@given(st.lists(st.sampled_from(WORST_FIRST)))
def test_worst(verdicts: list[str]) -> None:
    found = worst(verdicts)
    assert found == "uncovered" if not verdicts else found in verdicts
    assert all(WORST_FIRST.index(found) <= WORST_FIRST.index(verdict) for verdict in verdicts)


def test_every_item_is_traced() -> None:
    rows = trace()
    assert [row.id for row in rows] == list(items())
    assert set(rows[0].as_json()) == {
        "id", "kind", "title", "file", "line", "links", "code", "cases", "verdict"
    }  # fmt: skip


def test_nothing_is_left_without_a_case() -> None:
    """Whoever adds a requirement or a model has to say how it is checked."""
    open_ = [
        row.id
        for row in trace()
        if row.kind in ("requirement", "model", "property", "scheme", "definition", "theory")
        and not row.cases
        and "judged" not in items()[row.id]["data"]
    ]
    assert open_ == []


def test_all_that_is_specified_is_reached_from_a_demand() -> None:
    """Whoever adds an equation has to say which requirement asks for it."""
    graph = Graph(items(), {})
    demands = {id for id, each in items().items() if each["kind"] in ("goal", "requirement")}
    reached = demands.union(*(graph.reach(id, graph.forward) for id in demands))
    beside = ("case", "change", "erratum")
    left = [id for id, each in items().items() if each["kind"] not in beside and id not in reached]
    assert left == []


def test_nothing_is_uncovered_when_all_cases_pass() -> None:
    passed = {
        id: [Outcome(id, "q", 0.0, 1.0, "pass", "h")]
        for id, each in items().items()
        if each["kind"] == "case"
    }
    graph = Graph(items(), passed, lambda _: "h")
    assert {graph.verdict(id) for id in items()} == {"pass", "manual", NONE}


def test_an_uncovered_item_is_no_success_whatever_its_kind() -> None:
    graph = small(TC1="pass", TC2="pass")
    graph.items["hinge"] = item("hinge", "constraint")
    again = Graph(graph.items, graph.outcomes, own_hash)
    rows = [again.traced(id) for id in again.items]
    assert [row.id for row in rows if row.verdict == "uncovered"] == ["hinge"]
    assert exit_code(rows) == 1


def test_a_result_is_stale_when_what_it_rests_on_changes(monkeypatch: pytest.MonkeyPatch) -> None:
    verify(["TC1", "TC8"])
    verdicts = {row.id: row.verdict for row in trace()}
    assert [verdicts[id] for id in ("TC1", "TC8")] == ["pass", "pass"]
    monkeypatch.setitem(items()["IM2"], "hash", "changed")  # type: ignore[arg-type]
    verdicts = {row.id: row.verdict for row in trace()}
    assert [verdicts[id] for id in ("TC1", "TC8", "R6", "GS2")] == ["pass", *["stale"] * 3]


def test_a_failure_reaches_requirement_and_goal() -> None:
    outcome = verify("TC8")[0]
    results.add([Outcome(**{**vars(outcome), "verdict": "fail"})])
    rows = {row.id: row.verdict for row in trace()}
    assert [rows[id] for id in ("TC8", "IM2", "R6", "GS2")] == ["fail"] * 4
    assert exit_code(trace()) == 1


def test_what_hangs_together_with_an_assumption() -> None:
    near = neighbourhood("A6")
    ids = {row.id for row in near.depended_on_by}
    assert {"IM1", "IM2", "IM3", "R5", "GS1", "TC1", "LC2"} <= ids
    assert "UC1" not in ids
    assert near.item.id == "A6"
    assert {row.id for row in trace("A6")} == {"A6", *ids}


def test_what_a_case_rests_on() -> None:
    ids = {row.id for row in neighbourhood("TC8").rests_on}
    assert {"R6", "IM2", "TM4"} <= ids


@pytest.mark.parametrize("id", ["A66", "", "a6"])
def test_an_unknown_id_is_refused(id: str) -> None:
    with pytest.raises(InputError, match="trace: "):
        trace(id)


def test_the_plan_table_is_corrected() -> None:
    columns, rows = plan_table()
    marked = {id: [c for c, m in zip(columns, marks, strict=True) if m] for id, _, marks in rows}
    assert marked["TC1"] == ["IM1", "R1", "R2", "R5"]
    assert marked["TC9"] == ["IM2", "R1", "R2", "R6"]
    assert marked["TC14"][-1] == "NFR1"
    assert [id for id, *_ in rows][-3:] == ["TC12", "TC13", "TC14"]
