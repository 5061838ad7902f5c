"""Runs within a tolerance: planned, run, certified, and made again with finer steps if need be."""

import math
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from tamias2d.certificate import Certificate
from tamias2d.contact import steps_because
from tamias2d.errors import SceneError, SimulationError
from tamias2d.motion import Dop853, DormandPrince5
from tamias2d.motion.error_equation import Watch
from tamias2d.run import Run
from tamias2d.scene import Scene
from tamias2d.scene.acting import felt_velocity, kinked, only_slowed
from tamias2d.scene.reach import pairs_that_can_meet
from tamias2d.solve import Interrupted, solve, solve_halved, solve_with_error
from tamias2d.state import Array
from tamias2d.study.certify import (
    certify_by_companion,
    certify_embedded,
    certify_halved,
    certify_steps,
    certify_tighter,
    certify_with_error,
)
from tamias2d.study.embedded import looser_than
from tamias2d.study.offers import holding
from tamias2d.study.path_error import TIGHTEST, HopelessError, has_error_equation, hopeless
from tamias2d.study.pilot import Estimate
from tamias2d.study.recommend import located_plan, solved
from tamias2d.study.refusal import ToleranceError, refusal, sooner
from tamias2d.study.stepped_plan import plan_steps, stepped_because
from tamias2d.work_limit import WORK_LIMIT

_HALVED, _ORDERLY = 6.0, 1e-5
"""Times the tolerance is that of order 8 whose halved steps are tried first; at most so large is it
that most scenes show the order of the scheme."""
_PLAIN, _SLOWED = 0.3, 10.0
"""The same of whole steps; where bodies are only slowed, and errors decay with their speed."""
_ORDER_8, _IMPACTS = 3e-8, 1e-8
"""Below these tolerances order 8 is cheaper than order 5 where bodies are only slowed: where none
meet, and where steps are short for impacts."""
_FREE, _SPRUNG, _FELT = 0.05, 0.3, 0.7
"""The same of steps whose error is integrated: where no velocity is felt, and errors grow with the
square of the time, where springs hold them back, and where a velocity is felt."""
_STRUCK = 0.2
"""The same where bodies meet and are only slowed."""
_NEXT = 0.5  # of the tolerance is aimed at when that failed
_LOOSE = 1e-3
"""From it on order 5 is cheaper where bodies are only slowed and their error is integrated."""
_HALVES = 3e-6
"""Below it halved steps are cheaper than a run at a tighter tolerance."""
_LOOSEST = 0.3
_TRIES = 3
_BESIDE = 5
"""Tries with the error beside them, each of which tells the next: all others cost more."""
_NAMES = "second", "third", "fourth", "fifth"
_AIMS = 1.0, 1 / 30, 1e-3  # of the tolerance
_TRUE = 1e-5  # within which runs do not lose each other but where the scene does that
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
    asked = _Asked(scene, duration, tolerance, times, progress, work_limit)
    try:
        return _within(asked)
    except ToleranceError as refused:
        raise holding(refused, duration, lambda *other: _within(asked.at(*other))) from None


def _within(asked: "_Asked") -> Run:
    """Return the run that was asked for; a refusal offers what was not tried."""
    scene, duration = asked.scene, asked.duration
    reason = steps_because(scene, duration)
    if reason is None:
        try:
            return _located(asked)
        except Interrupted:
            raise
        except ToleranceError as refused:
            if refused.reachable is not None:
                raise
            if (reason := stepped_because(scene, duration)) is None:
                raise
        except (SimulationError, SceneError):
            if (reason := stepped_because(scene, duration)) is None:
                raise
    return _stepped(asked, reason)


class _Asked(NamedTuple):
    """What `within` was asked for."""

    scene: Scene
    duration: float
    tolerance: float
    times: Array
    progress: bool
    work_limit: int

    def at(self, tolerance: float | None, duration: float) -> "_Asked":
        """Return what is asked for at another tolerance, if one is given, and up to a time, s."""
        times = self.times
        if duration < self.duration:
            times = np.append(times[times < duration], duration)
        return self._replace(
            tolerance=tolerance or self.tolerance, duration=duration, times=times, progress=False
        )

    def run(self, estimate: Estimate) -> Run:
        """Return the run that was estimated."""
        return solve(
            self.scene,
            duration=self.duration,
            method=estimate.method,
            time_step=estimate.time_step,
            times=self.times,
            progress=self.progress,
            work_limit=self.work_limit,
        )

    def with_error(
        self, method: Dop853 | DormandPrince5, watch: Watch | None = None
    ) -> tuple[Run, Array | None]:
        """Return the run of a method with the largest error of its path, as `solve_with_error`."""
        watched = {} if watch is None else {"watch": watch}
        return solve_with_error(
            self.scene,
            duration=self.duration,
            method=method,
            times=self.times,
            progress=self.progress,
            work_limit=self.work_limit,
            **watched,
        )


class _PastHorizonError(Exception):
    """A refusal because no run can be followed so long."""

    def __init__(self, refused: ToleranceError) -> None:
        super().__init__(str(refused))
        self.refused = refused


def _located(asked: _Asked) -> Run:
    """Return a run whose impacts are located.

    Where long steps have no bound, as near a close encounter, those for less may have one.
    """
    refused: ToleranceError | None = None
    aims = [share * asked.tolerance for share in _AIMS]
    for aim in (aims[0], *(aim for aim in aims[1:] if aim >= _TIGHTEST)):
        try:
            return _aimed(asked._replace(tolerance=aim))
        except ToleranceError as fault:
            refused = refused or fault
        except _PastHorizonError as lost:
            refused = refused or lost.refused
            if aim <= _TRUE:
                break
    assert refused is not None
    raise refused


def _aimed(asked: _Asked) -> Run:
    """Return an adaptive run whose impacts are located, or else the cheapest."""
    tolerance = asked.tolerance
    if not solved(asked.scene) and (run := _unweighed(asked)) is not None:
        return run
    plan = located_plan(asked.scene, asked.duration, tolerance, asked.work_limit)
    reached, lost = math.inf, math.inf
    for estimate in plan.estimates:
        for attempt in range(_TRIES):
            if not math.isfinite(estimate.force_evaluations):
                break
            run = certify_by_companion(asked.run(estimate))
            if run.certificate is not None and run.certificate.meets(tolerance):
                return _noted(run, tolerance, attempt)
            reached = min(reached, _reached(run.certificate))
            lost = min(lost, _lost(run.certificate))
            finer = _finer(estimate, _reached(run.certificate) / tolerance)
            if finer is None:
                break
            estimate = finer
    if lost < math.inf:
        raise _PastHorizonError(refusal(tolerance, reached, until=sooner(lost)))
    raise refusal(tolerance, reached)


def _lost(certificate: Certificate | None) -> float:
    """Return the horizon of a run, s."""
    horizon = certificate.predictability_horizon if certificate else None
    return math.inf if horizon is None else horizon


def _unweighed(asked: _Asked) -> Run | None:
    """Return an adaptive run within the tolerance; None if there is none after some tries.

    Pilot runs, which weigh other methods, cost several times what the cheapest of these saves.
    """
    scene, tolerance = asked.scene, asked.tolerance
    meet = bool(pairs_that_can_meet(scene, asked.duration))
    slowed = only_slowed(scene)
    try:
        if has_error_equation(scene, Dop853()):
            if meet:
                return _through_impacts(asked)
            if (run := _with_error(asked)) is not None:
                return run
        if not (meet or slowed or scene.joints or kinked(scene)) and tolerance < _HALVES:
            return _halved(asked)
        loose = tolerance >= (_IMPACTS if meet else _ORDER_8)
        method = DormandPrince5 if slowed and loose else Dop853
        return _whole(asked, method, (_SLOWED if slowed and not meet else _PLAIN) * tolerance)
    except SimulationError:  # of a loose run; the plan refuses what cannot be
        return None


def _with_error(asked: _Asked) -> Run | None:
    """Return a run beside which its error is integrated; None if some are not within it."""
    scene, tolerance = asked.scene, asked.tolerance
    slowed = only_slowed(scene)
    method = DormandPrince5 if slowed and tolerance >= _LOOSE else Dop853
    rtol = tolerance * (_SLOWED if slowed else _aim(scene))
    watch = hopeless(scene, asked.duration, tolerance)
    for attempt in range(_BESIDE):
        if rtol < TIGHTEST:
            return None
        try:
            run, error = asked.with_error(method(rtol=_own(rtol, _LOOSEST)), watch)
        except HopelessError as stopped:
            reached = stopped.share
        else:
            run = certify_with_error(run, error)
            if _meets(run, asked):
                return _first(run, tolerance, attempt)
            reached = _reached(run.certificate)
        rtol *= _NEXT * tolerance / min(reached, 1.0)
    return None


def _through_impacts(asked: _Asked) -> Run | None:
    """Return a run whose error is carried through its impacts; None if some are not within it.

    Where it cannot be, and below what it can tell, runs are certified by tighter ones.
    """
    scene, tolerance = asked.scene, asked.tolerance
    slowed = only_slowed(scene)
    method = DormandPrince5 if slowed and tolerance >= _IMPACTS else Dop853
    rtol = tolerance * (_STRUCK if slowed else _aim(scene))
    for attempt in range(_BESIDE):
        if rtol < TIGHTEST:
            break
        run, error = asked.with_error(method(rtol=_own(rtol, _LOOSEST)))
        if error is None:
            return _tightened(asked, *certify_embedded(run))
        run = certify_with_error(run, error)
        if _meets(run, asked):
            return _first(run, tolerance, attempt)
        rtol *= _NEXT * tolerance / min(_reached(run.certificate), 1.0)
    return _whole(asked, method, _PLAIN * tolerance)


def _aim(scene: Scene) -> float:
    """Return the tolerance of a method that is likely to do, over the one that was asked for."""
    if felt_velocity(scene):
        return _FELT
    return _SPRUNG if scene.springs else _FREE


def _halved(asked: _Asked) -> Run | None:
    """Return a run by halved steps, which are certified by whole ones, of the same times or not."""
    run, halving = solve_halved(
        asked.scene,
        duration=asked.duration,
        method=Dop853(rtol=_own(_HALVED * asked.tolerance, _ORDERLY)),
        times=asked.times,
        progress=asked.progress,
        work_limit=asked.work_limit,
    )
    run, tighter = certify_halved(run, halving)
    if tighter is None and not _meets(run, asked) and _reached(run.certificate) < math.inf:
        run, tighter = certify_embedded(run)
    return _tightened(asked, run, tighter)


def _whole(asked: _Asked, method: type[Dop853] | type[DormandPrince5], rtol: float) -> Run | None:
    """Return a run by whole steps, which are certified by those at a tighter tolerance."""
    first = asked.run(_estimate(asked, method(rtol=_own(rtol, _LOOSEST))))
    return _tightened(asked, *certify_embedded(first))


def _tightened(asked: _Asked, run: Run, tighter: Run | None) -> Run | None:
    """Return a run, or else the one at a tighter tolerance behind it, which is the next to try."""
    for attempt in range(_TRIES):
        if attempt:
            run, tighter = certify_embedded(run)
        if _meets(run, asked):
            return _first(run, asked.tolerance, attempt)
        if tighter is None or not _reached(run.certificate) < math.inf:
            return None
        run = _believed(tighter, run)
        if _meets(run, asked):
            return _first(run, asked.tolerance, attempt)
    return None


def _believed(run: Run, before: Run) -> Run:
    """Return a run with a certificate from the one before it, if it can be made again from this."""
    method = run.method
    if not isinstance(method, Dop853 | DormandPrince5):
        return run
    known = any(one == before.method for one in looser_than(method))
    return certify_tighter(run, before) if known else run


def _meets(run: Run, asked: _Asked) -> bool:
    return run.certificate is not None and run.certificate.meets(asked.tolerance)


def _estimate(asked: _Asked, method: Dop853 | DormandPrince5) -> Estimate:
    return Estimate(method, None, 0.0, asked.tolerance, None)


def _first(run: Run, tolerance: float, attempt: int) -> Run:
    """Return a run that notes that no other method was weighed."""
    note = f"{run.method}: within {tolerance:g}{_again(attempt)}; no other method was weighed"
    return replace(run, notes=(note, *run.notes[1:]))


def _own(rtol: float, loosest: float) -> float:
    """Return the tolerance of a method, rounded to two digits: notes are read by people."""
    return float(f"{min(max(rtol, _TIGHTEST), loosest):.1e}")


def _stepped(asked: _Asked, reason: str) -> Run:
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
    if run.certificate is None or not run.certificate.meets(asked.tolerance):
        why = run.certificate.how if run.certificate else "no bound was found"
        raise ToleranceError(
            f"tolerance {asked.tolerance:g}: the steps that meet it give no bound: {why} (R5). "
            "Take a smaller tolerance, or certify a run by steps of your own."
        )
    return _noted(run, asked.tolerance, 0)


def _noted(run: Run, tolerance: float, attempt: int) -> Run:
    step = "" if run.time_step is None else f" with steps of {run.time_step:.4g} s"
    note = f"{run.method}{step}: the cheapest within {tolerance:g}{_again(attempt)}"
    return replace(run, notes=(note, *run.notes[1:]))


def _again(attempt: int) -> str:
    return "" if attempt == 0 else f", at the {_NAMES[attempt - 1]} try"


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
