"""Compare the impacts of a run: how many, when, how strong."""

import math
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from tamias2d.state import Array
from tamias2d.verify.case import Case
from tamias2d.verify.formula import distance, instant, measure
from tamias2d.verify.outcome import Outcome


def compare(case: Case, given: Mapping[str, Any]) -> Iterator[Outcome]:
    """The count, and the times and impulses of the first impacts, in their order."""
    impacts = case.run.impacts
    if "count" in given:
        error = abs(len(impacts) - int(given["count"]))
        yield case.outcome(given, "count of impacts", error, f"found {len(impacts)}")
    if "times" in given:
        times = np.array([instant(text) for text in given["times"]])
        yield case.outcome(given, _first("times", times), _early(impacts.time, times))
    if "impulses" in given:
        impulses = np.array([measure(text, "impulse") for text in given["impulses"]])
        yield case.outcome(given, _first("impulses", impulses), _early(impacts.impulse, impulses))


def _first(what: str, values: Array) -> str:
    return f"{what} of the first {len(values)} impacts" if len(values) > 1 else what[:-1]


def _early(found: Array, exact: Array) -> float:
    if len(found) < len(exact):
        return math.inf
    return distance(found[: len(exact)], exact)
