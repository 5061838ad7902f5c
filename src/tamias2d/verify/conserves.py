"""Check the quantities that stay the same over a run: momenta and energy."""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from tamias2d.run import Run
from tamias2d.state import Array
from tamias2d.verify.case import Case
from tamias2d.verify.outcome import Outcome
from tamias2d.verify.schemes import run_by

_QUANTITIES = ("momentum", "angular_momentum", "energy")


def compare(case: Case, given: Mapping[str, Any]) -> Iterator[Outcome]:
    """Either `constant`: the largest change since the start; or `falls`: the largest rise.

    With `schemes`, each with its number of steps, their runs are judged in place of the case's.
    """
    schemes = given.get("schemes", {})
    for scheme, steps in schemes.items():
        run = run_by(case, scheme, int(steps))
        yield from kept(case, given, run, f" by {scheme}")
    if not schemes:
        yield from kept(case, given, case.run, "")


def kept(case: Case, given: Mapping[str, Any], run: Run, by: str) -> Iterator[Outcome]:
    """What a run keeps, of the quantities that are given."""
    for quantity in _QUANTITIES:
        if quantity in given:
            rule = given[quantity]
            values: Array = getattr(run, quantity)
            size = _momenta(run) if quantity == "momentum" else _largest(values)
            change = (_rise if rule == "falls" else _drift)(values) / (size or 1.0)
            what = "never rises" if rule == "falls" else rule
            yield case.outcome(given, f"{quantity.replace('_', ' ')} {what}{by}", change)


def _drift(values: Array) -> float:
    rows = values.reshape(len(values), -1)
    return float(np.linalg.norm(rows - rows[0], axis=1).max())


def _rise(values: Array) -> float:
    lowest = np.minimum.accumulate(values)
    return float((values - lowest).max())


def _largest(values: Array) -> float:
    return float(np.linalg.norm(values.reshape(len(values), -1), axis=1).max())


def _momenta(run: Run) -> float:
    """Return the largest sum of the bodies' momenta, each by its size: their own may cancel."""
    moving = [k for k, body in enumerate(run.scene.bodies) if body.dynamic]
    mass = np.array([run.scene.bodies[k].mass for k in moving])
    return float((mass * np.linalg.norm(run.velocity[:, moving], axis=-1)).sum(axis=-1).max())
