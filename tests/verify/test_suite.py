"""Which cases are run for an id, and what becomes of an error."""

import sys

import pytest

from tamias2d.errors import InputError, SpecError
from tamias2d.trace import trace
from tamias2d.verify import cases, results, suite, verify
from tamias2d.verify.case import Case
from tamias2d.verify.items import items


def test_all_cases_in_the_order_of_their_labels() -> None:
    labels = [case.id for case in cases()]
    assert labels[:3] == ["TC1", "TC2", "TC3"]
    assert labels.index("TC9") < labels.index("TC10") < labels.index("TC10b") < labels.index("OA1")
    assert len(labels) == sum(item["kind"] == "case" for item in items().values())


def test_an_item_names_the_cases_that_rest_on_it() -> None:
    labels = {case.id for case in cases("IM2")}
    assert {"TC8", "TC9", "OA3"} <= labels
    assert "TC1" not in labels


def test_a_model_below_others_names_cases_too() -> None:
    assert {"TC1", "OB3"} <= {case.id for case in cases(["TM1"])}


@pytest.mark.parametrize("id", ["TC99", "", "tc1", "E1", "UC1"])
def test_an_unknown_or_idle_id_is_refused(id: str) -> None:
    with pytest.raises(InputError, match="verify: "):
        cases([id])


def test_verdicts_are_kept_and_others_stay() -> None:
    first = verify("TC1")
    second = verify(["TC2"])
    assert results.read() == {"TC1": first, "TC2": second}


def test_an_error_is_a_failure_of_its_comparison(monkeypatch: pytest.MonkeyPatch) -> None:
    def fault(*_: object) -> None:
        raise SpecError("here: found this: must be that (R4). Mend it.")

    monkeypatch.setitem(suite.COMPARISONS, "exact", fault)  # type: ignore[arg-type]
    outcomes = suite.judge(Case(items()["TC2"]))
    assert [outcome.verdict for outcome in outcomes] == ["fail", "pass", "pass"]
    assert "Mend it" in outcomes[0].note


def test_a_comparison_whose_extra_is_missing_is_not_run(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "xarray", None)
    outcomes = [each for each in verify("OJ24") if each.quantity == "worlds"]
    assert [(each.verdict, each.note) for each in outcomes] == [
        ("not run", "needs tamias2d[ensemble]")
    ]
    assert trace("OJ24")[0].verdict == "not run"


def test_every_comparison_is_used_by_some_case() -> None:
    used = {key for case in cases() for key in case.data}
    assert set(suite.COMPARISONS) <= used


def test_every_comparison_says_why_its_tolerance_and_whence_its_answer() -> None:
    for case in cases():
        for key in set(case.data) & set(suite.COMPARISONS) - {"survey"}:
            assert case.data[key]["because"]
            assert case.data[key]["source"]
