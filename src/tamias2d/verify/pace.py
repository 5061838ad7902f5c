"""Measure how long a scene takes."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from time import perf_counter
from typing import Any

from tamias2d.simulate import simulate
from tamias2d.verify.case import Case
from tamias2d.verify.outcome import FAIL, MANUAL, Outcome


def compare(case: Case, given: Mapping[str, Any]) -> Iterator[Outcome]:
    """The seconds of one run, after a first one that loads what is loaded once.

    A clock never fails a case: it also tells what else the machine does. People judge a slow run.
    """
    case.run  # noqa: B018 - the first one
    start = perf_counter()
    simulate(case.scene, duration=case.duration)
    outcome = case.outcome(given, "seconds for the run", perf_counter() - start)
    if outcome.verdict == FAIL:
        note = "slower than the limit, here and now. Measure it again on an idle machine"
        outcome = replace(outcome, verdict=MANUAL, note=note)
    yield outcome
