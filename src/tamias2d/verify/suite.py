"""All cases, run and judged by the comparisons that they ask for."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

from tamias2d.errors import InputError, MissingExtraError, TamiasError
from tamias2d.suggestions import suggests
from tamias2d.verify import (
    certified,
    conserves,
    exact,
    impacts,
    pace,
    people,
    published,
    reference,
    refuses,
    results,
    schemes,
    stepped,
    values,
    worlds,
)
from tamias2d.verify.case import Case
from tamias2d.verify.items import items, label_order, links, meant
from tamias2d.verify.outcome import NOT_RUN, Outcome

Comparison = Callable[[Case, Mapping[str, Any]], Iterator[Outcome]]
COMPARISONS: dict[str, Comparison] = {
    "exact": exact.compare_history,
    "final": exact.compare_final,
    "moments": exact.compare_moments,
    "impacts": impacts.compare,
    "conserves": conserves.compare,
    "schemes": schemes.compare,
    "certified": certified.compare,
    "published": published.compare,
    "stepped": stepped.compare,
    "reference": reference.compare,
    "worlds": worlds.compare,
    "values": values.compare,
    "refuses": refuses.compare,
    "notes": refuses.compare_notes,
    "pace": pace.compare,
    "survey": people.compare,
}


@suggests
def verify(
    ids: str | Iterable[str] | None = None,
    *,
    follow: Callable[[list[Case]], Iterable[Case]] = iter,
) -> list[Outcome]:
    """Run cases, judge them, keep the verdicts for `trace`, and return them.

    The id of another item names the cases that name it, or else all that rest on it. Without ids
    all cases are run. `follow` gives them on one by one, and may show which is at work.

    Raises:
        InputError: an id is unknown, or no case rests on it.
    """
    outcomes = [outcome for case in follow(cases(ids)) for outcome in judge(case)]
    results.add(outcomes)
    return outcomes


def cases(ids: str | Iterable[str] | None = None) -> list[Case]:
    """Return the cases that `verify` would run, in the order of their labels."""
    chosen = sorted((id for id, item in items().items() if item["kind"] == "case"), key=label_order)
    if ids is not None:
        asked = [ids] if isinstance(ids, str) else ids
        wanted = {case for id in asked for case in _named(id, chosen)}
        chosen = [id for id in chosen if id in wanted]
    return [Case(items()[id]) for id in chosen]


def judge(case: Case) -> list[Outcome]:
    """Return the outcomes of one case; an error of a comparison is a failure of it.

    A comparison whose extra is not installed is not run.
    """
    outcomes: list[Outcome] = []
    for key, compare in COMPARISONS.items():
        if key in case.data:
            given = {"tolerance": "0"} | dict(case.data[key])
            try:
                outcomes += compare(case, given)
            except MissingExtraError as missing:
                note = f"needs tamias2d[{missing.extra}]"
                outcomes.append(
                    case.stamped(Outcome(case.id, key, math.inf, 0.0, NOT_RUN, note=note))
                )
            except TamiasError as error:
                outcomes.append(case.outcome(given, key, math.inf, str(error)))
    return outcomes


def _named(id: str, every: Iterable[str]) -> list[str]:
    if id not in items():
        close = meant(id)
        hint = f"Did you mean '{close}'?" if close else "`trace` lists all items."
        raise InputError(f"verify: '{id}' is no item of the specification. {hint}")
    if items()[id]["kind"] == "case":
        return [id]
    found = [case for case in every if id in links(items()[case])]
    found = found or [case for case in every if id in _rests_on(case)]
    if not found:
        raise InputError(f"verify: no case rests on '{id}'. Name a case, a model or a requirement.")
    return found


def _rests_on(id: str) -> set[str]:
    """Return all items that an item uses, directly or through others."""
    seen: set[str] = set()
    todo = [id]
    while todo:
        new = set(items()[todo.pop()]["links"].get("uses", ())) - seen
        seen |= new
        todo += new
    return seen
