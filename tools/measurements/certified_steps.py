"""Whether certificates can be believed where contacts are stepped.

Scenes are simulated for tolerances from 1e-1 to 1e-4; what is refused, for as long as the refusal
offers. The true answer is where shorter steps lead: two runs by steps that are sixteen and more
times shorter than those of the run, and by no fewer substeps; the one that is farther away counts.
"""

import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from statistics import median
from typing import Any

import numpy as np

from tamias2d.certificate import Certificate
from tamias2d.motion import Stepped
from tamias2d.run import Run
from tamias2d.scene import Scene
from tamias2d.simulate import simulate
from tamias2d.study.error import distance
from tamias2d.study.refined import stepped, work_of
from tamias2d.study.refusal import ToleranceError

TOLERANCES = (1e-1, 1e-2, 1e-3, 1e-4)
_SAMPLES = 60
_FINER = ((17, 17), (23, 19))
"""Of the true answers: in how many parts they take a step of the run, and their substeps: more than
runs have, as stacks creep by too few of them"""
_MOST = 1e8  # substeps of one body that a true answer may take


@dataclass(frozen=True)
class SteppedPair:
    """What came of one scene and one tolerance."""

    scene: str
    tolerance: float
    duration: float
    """s: up to where it is met"""
    whole: bool
    """Whether that is the whole duration of the scene"""
    bound: float | None
    error: float | None
    covered: bool | None
    method: str
    refused: str


def pairs(name: str, scene: Scene, tolerances: Sequence[float]) -> Iterator[SteppedPair]:
    """Yield what came of all tolerances; nothing from one on whose contacts are not stepped."""
    for tolerance in tolerances:
        pair = _pair(name, scene, tolerance, scene.duration or 1.0)
        if pair is None:
            return
        yield pair


def summary(found: list[SteppedPair]) -> dict[str, Any]:
    """Return how many claims were true, how tight, and how much was refused."""
    claims = [pair for pair in found if pair.covered is not None]
    tight = [p.bound / p.error for p in claims if p.bound and p.error]
    return {
        "pairs": len(found),
        "claims": len(claims),
        "coverage": sum(bool(p.covered) for p in claims) / len(claims) if claims else None,
        "effectivity_median": median(tight) if tight else None,
        "met_whole": sum(p.whole for p in claims),
        "met_up_to_a_time": sum(not p.whole for p in claims),
        "offers_not_met": sum(p.refused != "" for p in found),
    }


def rows(found: list[SteppedPair]) -> list[dict[str, Any]]:
    """Return pairs as JSON holds them."""
    return [asdict(pair) for pair in found]


def _pair(name: str, scene: Scene, tolerance: float, duration: float) -> SteppedPair | None:
    until, refused = duration, ""
    try:
        run = _run(scene, tolerance, duration)
    except ToleranceError as first:
        until, refused, run = first.until or 0.0, f"{first}", None
        if first.until is not None:
            try:
                run, refused = _run(scene, tolerance, first.until), ""
            except ToleranceError as second:
                refused = f"{second}"
    by_steps = run is not None and isinstance(run.method, Stepped)
    if until == duration and not by_steps:
        return None
    certificate = run.certificate if run is not None else None
    error = None  # of what is located, up to the horizon
    if run is not None and certificate is not None and by_steps:
        error = _error(run, _length(certificate))
    bound = certificate.bound if certificate is not None else None
    return SteppedPair(
        name,
        tolerance,
        until,
        until == duration,
        bound,
        error,
        None if error is None or bound is None else error <= bound,
        "" if run is None else f"{run.method} {run.time_step or ''}",
        refused,
    )


def _run(scene: Scene, tolerance: float, duration: float) -> Run:
    times = np.linspace(0.0, duration, _SAMPLES + 1)
    return simulate(scene, duration=duration, tolerance=tolerance, times=times)


def _error(run: Run, length: float) -> float | None:
    """Return how far a run is from the farther one of two true answers, relative to a length, m.

    None if these cost much.
    """
    step = run.time_step or run.duration
    worst = 0.0
    for parts, substeps in _FINER:
        if work_of(run.scene, run.duration, step / parts, substeps) > _MOST:
            return None
        true = stepped(run.scene, run.duration, run.times, step / parts, substeps)
        worst = max(worst, float(distance(run.scene, run, true).max()))
    return worst / length if math.isfinite(worst) else math.inf


def _length(certificate: Certificate) -> float:
    """Return what a certificate says that its bound is relative to, m."""
    found = re.search(r"relative to the (\S+) m", certificate.measure)
    return float(found[1]) if found else math.nan
