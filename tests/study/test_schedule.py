"""Candidates are run from cheap to dear, as far as the time goes; what each takes is by hand."""

from collections.abc import Callable

import pytest

from tamias2d.study import schedule as module
from tamias2d.study.candidates import Candidate
from tamias2d.study.schedule import Schedule


def ladder(name: str, *, peer: bool = False) -> list[Candidate]:
    def never(*_: object) -> None:
        pytest.fail("run")

    return [Candidate(name, f"{n} steps", never, n, peer) for n in (16, 32, 64)]  # type: ignore[arg-type]


def order_of(
    tried: list[Candidate],
    seconds: Callable[[Candidate], float],
    failing: tuple[tuple[str, int], ...] = (),
) -> list[tuple[str, int | None, str | None]]:
    found = []
    schedule = Schedule(tried)
    for place, refused in schedule:
        one = tried[place]
        found.append((one.name, one.steps, refused))
        if refused is None:
            failed = (one.name, one.steps) in failing
            schedule.took(place, seconds(one), failed=failed)
    return found


def test_the_cheapest_comes_next() -> None:
    """Each of ten times the cost; each method has its first turn before any has its second."""
    cost = {"cheap": 1e-3, "dear": 1e-1}
    tried = [*ladder("dear"), *ladder("cheap")]
    found = order_of(tried, lambda one: cost[one.name] * (one.steps or 0) / 16)
    assert [(name, steps) for name, steps, _ in found] == [
        ("dear", 16), ("cheap", 16), ("cheap", 32), ("cheap", 64), ("dear", 32), ("dear", 64),
    ]  # fmt: skip
    assert all(refused is None for _, _, refused in found)


def test_what_would_take_too_long_is_not_run(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "LONGEST", 10.0)
    tried = [*ladder("dear"), *ladder("cheap"), *ladder("peer", peer=True)]
    cost = {"cheap": 1.0, "dear": 6.0, "peer": 0.1}
    found = order_of(tried, lambda one: cost[one.name] * (one.steps or 0) / 16)
    refused = {(name, steps): why for name, steps, why in found if why}
    assert [*refused] == [("cheap", 64), ("dear", 32), ("dear", 64)]
    assert refused["dear", 32] == "not run: it would take about 12 s, and a point at most 10 s"
    assert "after 9.7 s for others, and all at most 10 s" in refused["cheap", 64]


def test_every_method_has_a_point_if_it_does_not_take_long(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(module, "LONGEST", 5.0)
    tried = [*ladder("first"), *ladder("second"), *ladder("peer", peer=True)]
    found = order_of(tried, lambda one: 0.1 if one.peer else 9.0)
    assert {(name, steps) for name, steps, why in found if why is None} == {
        ("first", 16), ("second", 16), ("peer", 16),
    }  # fmt: skip
    found = order_of(tried, lambda one: 0.1 if one.peer else 11.0)
    refused = [(name, steps, why) for name, steps, why in found if why and name == "second"]
    took = "not run: the first points of other methods took 11 s, and one may take 10 s"
    assert refused == [("second", 16, took)]
    assert ("peer", 16, None) in found


def test_a_failure_tells_nothing_of_the_next() -> None:
    """Failures are quick. What steps take is known from another method then."""
    tried = [*ladder("bad"), *ladder("good")]
    found = order_of(
        tried,
        lambda one: 1e-6 if one.name == "bad" else 0.25 * (one.steps or 0),
        failing=(("bad", 16), ("bad", 32)),
    )
    refused = {(name, steps): why for name, steps, why in found if why}
    assert ("bad", 64) in refused
    assert refused["bad", 64].startswith("not run: it would take about 16 s")


def test_what_is_exact_needs_no_finer_setting() -> None:
    tried = [*ladder("exact"), *ladder("other")]
    schedule = Schedule(tried)
    seen = []
    for place, _ in schedule:
        seen.append(place)
        schedule.took(place, 1e-3, failed=False)
        if place == 0:
            schedule.leave(place)
    assert seen == [0, 3, 4, 5]
