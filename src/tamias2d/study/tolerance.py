"""Runs within a tolerance: planned, run, certified, and made again with finer steps if need be."""

import math
from dataclasses import replace

from tamias2d.certificate import Certificate
from tamias2d.run import Run
from tamias2d.scene import Scene
from tamias2d.solve import solve
from tamias2d.state import Array
from tamias2d.study.certify import certify
from tamias2d.study.pilot import Estimate
from tamias2d.study.recommend import recommend, refusal
from tamias2d.work_limit import WORK_LIMIT

_TRIES = 3
_TIGHTEST = 1e-14
_MOST = 30.0  # times too large a bound is believed to be, or no bound at all


def within(
    scene: Scene,
    *,
    duration: float,
    tolerance: float,
    times: Array,
    progress: bool = False,
    work_limit: int = WORK_LIMIT,
) -> Run:
    """Return the cheapest run whose certificate meets a tolerance, at sample times (k,), s.

    Raises as `simulate` and `recommend` do.
    """
    plan = recommend(scene, duration=duration, tolerance=tolerance, work_limit=work_limit)
    reached = math.inf
    for estimate in plan.estimates:
        for attempt in range(_TRIES):
            if not math.isfinite(estimate.force_evaluations):
                break
            run = certify(
                solve(
                    scene,
                    duration=duration,
                    method=estimate.method,
                    time_step=estimate.time_step,
                    times=times,
                    progress=progress,
                    work_limit=work_limit,
                )
            )
            if run.certificate is not None and run.certificate.meets(tolerance):
                return _noted(run, plan.tolerance, attempt)
            reached = min(reached, _reached(run.certificate))
            finer = _finer(estimate, _reached(run.certificate) / tolerance)
            if finer is None:
                break
            estimate = finer
    raise refusal(tolerance, reached)


def _noted(run: Run, tolerance: float, attempt: int) -> Run:
    again = "" if attempt == 0 else f", at the {('second', 'third')[attempt - 1]} try"
    step = "" if run.time_step is None else f" with steps of {run.time_step:.4g} s"
    note = f"{run.method}{step}: the cheapest within {tolerance:g}{again}"
    return replace(run, notes=(note, *run.notes[1:]))


def _reached(certificate: Certificate | None) -> float:
    if certificate is None or certificate.bound is None or certificate.kind == "invariants":
        return math.inf
    return certificate.bound


def _finer(estimate: Estimate, excess: float) -> Estimate | None:
    """Return the estimate with a step that makes up for a bound `excess` times too large."""
    excess = 1.2 * min(excess, _MOST)
    method = estimate.method
    if estimate.time_step is not None:
        order = float(method.facts.order) if method.facts else 1.0
        return replace(estimate, time_step=estimate.time_step / excess ** (1 / order))
    rtol = getattr(method, "rtol", 0.0)
    if rtol / excess < _TIGHTEST:
        return None
    return replace(estimate, method=replace(method, rtol=rtol / excess))  # type: ignore[type-var]
