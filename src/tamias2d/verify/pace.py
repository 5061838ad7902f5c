"""Measure how long a scene takes.

Serves: the case of performance. Hides: how the clock is read.
"""

from collections.abc import Iterator, Mapping
from time import perf_counter
from typing import Any

from tamias2d.simulate import simulate
from tamias2d.verify.case import Case
from tamias2d.verify.outcome import Outcome


def compare(case: Case, given: Mapping[str, Any]) -> Iterator[Outcome]:
    """The seconds of one run, after a first one that loads what is loaded once."""
    case.run  # noqa: B018 - the first one
    start = perf_counter()
    simulate(case.scene, duration=case.duration)
    yield case.outcome(given, "seconds for the run", perf_counter() - start)
