"""Check what must stay the same over a run: momenta and energy.

Serves: cases that name a law. Hides: the scale that a drift is measured by.
"""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from tamias2d.verify.case import Case
from tamias2d.verify.formula import Array
from tamias2d.verify.outcome import Outcome

_QUANTITIES = ("momentum", "angular_momentum", "energy")


def compare(case: Case, given: Mapping[str, Any]) -> Iterator[Outcome]:
    """Either `constant`: the largest change since the start; or `falls`: the largest rise."""
    for quantity in _QUANTITIES:
        if quantity in given:
            rule = given[quantity]
            values: Array = getattr(case.run, quantity)
            change = _rise(values) if rule == "falls" else _drift(values)
            what = "never rises" if rule == "falls" else rule
            yield case.outcome(given, f"{quantity.replace('_', ' ')} {what}", change)


def _drift(values: Array) -> float:
    rows = values.reshape(len(values), -1)
    return float(np.linalg.norm(rows - rows[0], axis=1).max()) / _scale(rows)


def _rise(values: Array) -> float:
    lowest = np.minimum.accumulate(values)
    return float((values - lowest).max()) / _scale(values)


def _scale(values: Array) -> float:
    return float(np.abs(values).max()) or 1.0
