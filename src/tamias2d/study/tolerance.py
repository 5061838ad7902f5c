"""Runs within a tolerance: planned, run, certified, and made again with finer steps if need be."""

import math
from dataclasses import replace

from tamias2d.certificate import Certificate
from tamias2d.contact import steps_because
from tamias2d.errors import SceneError, SimulationError
from tamias2d.motion import Dop853
from tamias2d.run import Run
from tamias2d.scene import Scene
from tamias2d.scene.reach import pairs_that_can_meet
from tamias2d.solve import with_reason
from tamias2d.state import Array
from tamias2d.study.asked import Asked
from tamias2d.study.bound import rounding
from tamias2d.study.certify import certify_by_companion, certify_steps
from tamias2d.study.offers import holding
from tamias2d.study.path_error import has_error_equation
from tamias2d.study.pilot import Estimate
from tamias2d.study.recommend import located_plan, solved
from tamias2d.study.refusal import ChaosError, ToleranceError, refusal, sooner
from tamias2d.study.scale import scale
from tamias2d.study.stepped_plan import plan_steps, stepped_because
from tamias2d.study.unweighed import SMALLEST, TRIES, again, reached_by, unweighed
from tamias2d.work_limit import WORK_LIMIT

_AIMS = 1.0, 1 / 30, 1e-3  # of the tolerance
_TRUE = 1e-5  # within which runs do not lose each other but where the scene does that
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
    asked = Asked(scene, duration, tolerance, times, progress, work_limit)
    try:
        return _within(asked)
    except ToleranceError as refused:
        raise holding(refused, duration, lambda *other: _within(asked.at(*other))) from None


def _within(asked: Asked) -> Run:
    """Return the run that was asked for; a refusal offers what was not tried."""
    scene, duration = asked.scene, asked.duration
    reason = steps_because(scene, duration)
    if reason and (run := _rubbing(asked)) is not None:
        return asked.sampled(run)
    if reason is None:
        try:
            return asked.sampled(_located(asked.looked_at()))
        except ToleranceError as refused:
            if refused.reachable is not None:
                raise
            if (reason := stepped_because(scene, duration)) is None:
                raise
        except (SimulationError, SceneError):
            if (reason := stepped_because(scene, duration)) is None:
                raise
    return _stepped(asked, reason)


def _rubbing(asked: Asked) -> Run | None:
    """Return an adaptive run of mechanisms that rub or rest, if one is within the tolerance."""
    if steps_because(asked.scene, asked.duration, within=True) is not None:
        return None
    try:
        return unweighed(asked.looked_at())
    except (SimulationError, SceneError):
        return None


class _PastHorizonError(Exception):
    """A refusal because no run can be followed so long."""

    def __init__(self, refused: ToleranceError) -> None:
        super().__init__(str(refused))
        self.refused = refused


def _located(asked: Asked) -> Run:
    """Return a run whose impacts are located.

    Where long steps have no bound, as near a close encounter, those for less may have one. Runs
    beside which their error is integrated have told which steps are short enough.
    """
    refused: ToleranceError | None = None
    scene, duration = asked.scene, asked.duration
    smooth = not pairs_that_can_meet(scene, duration)
    told = smooth and has_error_equation(scene, Dop853(), duration)
    aims = [share * asked.tolerance for share in (_AIMS[:1] if told else _AIMS)]
    for aim in (aims[0], *(aim for aim in aims[1:] if aim >= SMALLEST)):
        try:
            return _aimed(asked._replace(tolerance=aim))
        except ChaosError:
            raise
        except ToleranceError as fault:
            refused = refused or fault
        except _PastHorizonError as lost:
            refused = refused or lost.refused
            if aim <= _TRUE:
                break
    assert refused is not None
    raise refused


def _aimed(asked: Asked) -> Run:
    """Return an adaptive run whose impacts are located, or else the cheapest."""
    tolerance = asked.tolerance
    if not solved(asked.scene) and (run := unweighed(asked)) is not None:
        return run
    plan = located_plan(asked.scene, asked.duration, tolerance, asked.work_limit)
    reached, lost, rounded = math.inf, math.inf, False
    for estimate in plan.estimates:
        for attempt in range(TRIES):
            if not math.isfinite(estimate.force_evaluations):
                break
            run = certify_by_companion(asked.run(estimate))
            if asked.is_met(run):
                return _noted(run, tolerance, attempt)
            reached = min(reached, reached_by(run.certificate))
            lost = min(lost, _lost(run.certificate))
            rounded = rounded or _is_rounding(run, tolerance)
            finer = _finer(estimate, reached_by(run.certificate) / tolerance)
            if finer is None:
                break
            estimate = finer
    if lost < math.inf:
        raise _PastHorizonError(refusal(tolerance, reached, until=sooner(lost)))
    raise refusal(tolerance, reached, too_short=rounded)


def _is_rounding(run: Run, tolerance: float) -> bool:
    """Return whether rounding is too much: the farther bodies go, the less it counts."""
    if len(run.impacts):
        return False
    exact = run.certificate is not None and run.certificate.kind == "exact"
    return exact or rounding(run) > tolerance * scale(run)


def _lost(certificate: Certificate | None) -> float:
    """Return the horizon of a run, s."""
    horizon = certificate.predictability_horizon if certificate else None
    return math.inf if horizon is None else horizon


def _stepped(asked: Asked, reason: str) -> Run:
    """Return the cheapest run by steps through contacts: its pilots bound its error, too."""
    plan = plan_steps(
        asked.scene,
        duration=asked.duration,
        tolerance=asked.tolerance,
        times=asked.times,
        work_limit=asked.work_limit,
        reason=reason,
    )
    run = certify_steps(asked.run(plan.estimates[0]), plan.refined)
    if not asked.is_met(run):
        why = run.certificate.how if run.certificate else "no bound was found"
        raise ToleranceError(
            f"tolerance {asked.tolerance:g}: the steps that meet it give no bound: {why} (R5). "
            "Take a smaller tolerance, or certify a run by steps of your own."
        )
    return _noted(run, asked.tolerance, 0)


def _noted(run: Run, tolerance: float, attempt: int) -> Run:
    step = "" if run.time_step is None else f" with steps of {run.time_step:.4g} s"
    note = f"{run.method}{step}: the cheapest within {tolerance:g}{again(attempt)}"
    return with_reason(run, note)


def _finer(estimate: Estimate, excess: float) -> Estimate | None:
    """Return the estimate with a step that makes up for a bound `excess` times too large."""
    excess = 1.2 * min(excess, _MOST)
    method = estimate.method
    if estimate.time_step is not None:
        order = float(method.facts.order) if method.facts else 1.0
        return replace(estimate, time_step=estimate.time_step / excess ** (1 / order))
    rtol = getattr(method, "rtol", 0.0)
    if rtol / excess < SMALLEST:
        return None
    return replace(estimate, method=replace(method, rtol=rtol / excess))  # type: ignore[type-var]
