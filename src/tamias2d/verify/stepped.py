"""Compare a run in steps through contacts: where it ends, what it keeps, its bits (R12, R16)."""

import math
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from tamias2d.motion.methods import Stepped
from tamias2d.run import Run
from tamias2d.simulate import simulate
from tamias2d.verify import kept
from tamias2d.verify.case import Case
from tamias2d.verify.conserves import kept as conserved
from tamias2d.verify.exact import answers
from tamias2d.verify.formula import distance, measure
from tamias2d.verify.outcome import Outcome


def compare(case: Case, given: Mapping[str, Any]) -> Iterator[Outcome]:
    """The end, and what stays the same, as stated; the bits again, of a run and of what is kept."""
    step = float(measure(given["time_step"], "time_step"))
    run, again = (
        simulate(case.scene, duration=case.duration, method=Stepped(), time_step=step)
        for _ in range(2)
    )
    for answer in answers(run, given.get("bodies", {}), slice(-1, None)):
        error = distance(answer.found, answer.exact)
        yield case.outcome(given, f"{answer.label} at the end of the steps", error)
    yield from conserved(case, given, run, " in steps")
    if "centre_of_mass" in given:
        yield case.outcome(given, "way of the centre of mass in steps", _off_its_line(run))
    same = run.digest() == again.digest()
    yield case.outcome(given, "bits of a second run", 0.0 if same else math.inf)
    yield from kept.compare(case, given, run, step)


def _off_its_line(run: Run) -> float:
    """Return how far the centre of mass of what moves gets off its line, of the longest way."""
    moving = [k for k, body in enumerate(run.scene.bodies) if body.dynamic]
    mass = np.array([run.scene.bodies[k].mass for k in moving])
    centre = mass @ run.position[:, moving] / mass.sum()
    line = centre[0] + np.outer(run.times, run.momentum[0] / mass.sum())
    ways = np.linalg.norm(run.position - run.position[0], axis=-1)
    return float(np.linalg.norm(centre - line, axis=1).max() / ways.max())
