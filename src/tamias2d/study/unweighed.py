"""Runs that are likely to be within a tolerance, with no other method weighed.

Each is certified; if its bound is too large, others at tolerances of the method that it tells
follow.
"""

import math
from dataclasses import replace
from typing import NamedTuple, TypeAlias

from tamias2d.certificate import Certificate
from tamias2d.errors import SimulationError
from tamias2d.motion import Dop853, DormandPrince5
from tamias2d.run import Run
from tamias2d.scene import Scene
from tamias2d.scene.acting import felt_velocity, kinked, only_slowed
from tamias2d.scene.reach import pairs_that_can_meet
from tamias2d.solve import with_reason
from tamias2d.study.asked import Asked
from tamias2d.study.certify import (
    certify_embedded,
    certify_halved,
    certify_tighter,
    certify_with_error,
)
from tamias2d.study.embedded import looser_than
from tamias2d.study.path_error import HopelessError, has_error_equation, hopeless, tightest
from tamias2d.study.pilot import Estimate
from tamias2d.study.refusal import ChaosError, chaotic, sooner
from tamias2d.study.two_digits import two_digits

Adaptive: TypeAlias = Dop853 | DormandPrince5

TRIES = 3
SMALLEST = 1e-14
"""Of the tolerances of a method that are tried."""
_HALVED, _ORDERLY = 6.0, 1e-5
"""Times the tolerance is that of order 8 whose halved steps are tried first; at most so large is it
that most scenes show the order of the scheme."""
_PLAIN, _SLOWED = 0.3, 3.0
"""The same of whole steps; where bodies are only slowed, and errors decay with their speed."""
_ORDER_8, _IMPACTS = 3e-8, 1e-8
"""Below these tolerances order 8 is cheaper than order 5 where bodies are only slowed: where none
meet, and where steps are short for impacts."""
_FREE, _SPRUNG, _FELT = 0.05, 0.3, 0.7
"""The same of steps whose error is integrated: where no velocity is felt, and errors grow with the
square of the time, where springs or joints hold them back, and where a velocity is felt."""
_STRUCK = 0.2
"""The same where bodies meet and are only slowed."""
_NEXT = 0.5  # of the tolerance is aimed at when that failed
_LOOSE = 1e-5
"""From it on order 5 is cheaper where bodies are only slowed and their error is integrated."""
_COARSE, _JOINED = 1e-3, 0.1
"""From it on order 5 is cheaper where joints hold, too, at so many times the tolerance."""
_HALVES = 3e-6
"""Below it halved steps are cheaper than a run at a tighter tolerance."""
_LOOSEST = 0.3
_BESIDE = 5
"""Tries with the error beside them, each of which tells the next: all others cost more."""
_NAMES = "second", "third", "fourth", "fifth"


def unweighed(asked: Asked) -> Run | None:
    """Return an adaptive run within the tolerance; None if there is none after some tries.

    Pilot runs, which weigh other methods, cost several times what the cheapest of these saves.

    Raises:
        ChaosError: small changes grow too large for any method.
    """
    scene, tolerance = asked.scene, asked.tolerance
    meet = bool(pairs_that_can_meet(scene, asked.duration))
    slowed = only_slowed(scene)
    tried = _Tried()
    try:
        if has_error_equation(scene, Dop853(), asked.duration):
            if meet:
                return _through_impacts(asked, _first(asked, _STRUCK, _IMPACTS))
            tried = _with_error(asked, _first(asked, _SLOWED, _LOOSE))
            if tried.run is not None:
                return tried.run
        if not (meet or slowed or scene.joints or kinked(scene)) and tolerance < _HALVES:
            rtol = min(_HALVED * tolerance, _HALVED / _PLAIN * tried.needed)
            return _halved(asked, Dop853(rtol=_own(rtol, _ORDERLY)))
        loose = tolerance >= (_IMPACTS if meet else _ORDER_8)
        rtol = _own(min((_SLOWED if slowed and not meet else _PLAIN) * tolerance, tried.needed))
        return _whole(asked, DormandPrince5(rtol=rtol) if slowed and loose else Dop853(rtol=rtol))
    except ChaosError as chaos:
        until = min(chaos.until or math.inf, sooner(tried.left))
        raise chaos.offering(chaos.reachable, until) from None
    except SimulationError:  # of a loose run; the plan refuses what cannot be
        return None


class _Tried(NamedTuple):
    """What runs with the error beside them have told."""

    run: Run | None = None
    """One that is within the tolerance, if there is any."""
    needed: float = math.inf
    """At most such a tolerance of whole steps."""
    left: float = math.inf
    """When the last of those that were stopped left the tolerance, s."""


def _first(asked: Asked, slowed_to: float, loose: float) -> Adaptive:
    """Return the method that is tried first with its error beside it.

    Where bodies are only slowed its tolerance is so many times that of the run, and from a loose
    one on it is of order 5, as it is where joints hold.
    """
    scene, tolerance = asked.scene, asked.tolerance
    if scene.joints and tolerance >= _COARSE:
        return DormandPrince5(rtol=_own(_JOINED * tolerance))
    slowed = only_slowed(scene)
    rtol = _own(tolerance * (slowed_to if slowed else _aim(scene)))
    return DormandPrince5(rtol=rtol) if slowed and tolerance >= loose else Dop853(rtol=rtol)


def _aim(scene: Scene) -> float:
    """Return the tolerance of a method that is likely to do, over the one that was asked for."""
    if felt_velocity(scene) and not scene.joints:
        return _FELT
    return _SPRUNG if scene.springs or scene.joints else _FREE


def _with_error(asked: Asked, method: Adaptive) -> _Tried:
    """Try runs beside which their error is integrated; the method is the first to try.

    Where it cannot be, runs are certified by tighter ones.
    """
    tolerance = asked.tolerance
    watch = hopeless(asked.scene, asked.duration, tolerance)
    needed = left = math.inf
    for attempt in range(_BESIDE):
        if method.rtol < tightest(asked.scene):
            break
        try:
            run, error = asked.with_error(method, watch)
        except HopelessError as stopped:
            reached, left = stopped.share, stopped.time
        else:
            if error is None:
                return _Tried(_tightened(asked, *certify_embedded(run)), needed)
            run = certify_with_error(run, error)
            if asked.is_met(run):
                return _Tried(_noted(run, tolerance, attempt))
            reached, left = reached_by(run.certificate), math.inf
        method = _next(method, tolerance, reached, tightest(asked.scene))
        needed = method.rtol
    return _Tried(None, needed, left)


def _through_impacts(asked: Asked, method: Adaptive) -> Run | None:
    """Return a run whose error is carried through its impacts; None if some are not within it.

    Where it cannot be, and below what it can tell, runs are certified by tighter ones. The method
    is the first to try.
    """
    tolerance = asked.tolerance
    for attempt in range(_BESIDE):
        if method.rtol < tightest(asked.scene):
            break
        run, error = asked.with_error(method)
        if error is None:
            return _tightened(asked, *certify_embedded(run))
        run = certify_with_error(run, error)
        if asked.is_met(run):
            return _noted(run, tolerance, attempt)
        method = _next(method, tolerance, reached_by(run.certificate), tightest(asked.scene))
    return _whole(asked, replace(method, rtol=_own(min(_PLAIN * tolerance, method.rtol))))


def _halved(asked: Asked, method: Adaptive) -> Run | None:
    """Return a run by halved steps, which are certified by whole ones, of the same times or not."""
    run, tighter = certify_halved(*asked.halved(method))
    if tighter is None and not asked.is_met(run) and reached_by(run.certificate) < math.inf:
        run, tighter = certify_embedded(run)
    return _tightened(asked, run, tighter)


def _whole(asked: Asked, method: Adaptive) -> Run | None:
    """Return a run by whole steps, which are certified by those at a tighter tolerance."""
    first = asked.run(Estimate(method, None, 0.0, asked.tolerance, None))
    return _tightened(asked, *certify_embedded(first))


def _tightened(asked: Asked, run: Run, tighter: Run | None) -> Run | None:
    """Return a run, or else the one at a tighter tolerance behind it, which is the next to try."""
    reached = math.inf
    for attempt in range(TRIES):
        if attempt:
            run, tighter = certify_embedded(run)
        if asked.is_met(run):
            return _noted(run, asked.tolerance, attempt)
        if (lost_at := _lost(run.certificate)) is not None:
            raise chaotic(asked.tolerance, lost_at, reached)
        reached = min(reached, reached_by(run.certificate))
        if tighter is None or not reached_by(run.certificate) < math.inf:
            return None
        run = _believed(tighter, run)
        if asked.is_met(run):
            return _noted(run, asked.tolerance, attempt)
    return None


def _lost(certificate: Certificate | None) -> float | None:
    """Return when a small change is lost, s, if a certificate tells it."""
    return certificate.predictability_horizon if certificate else None


def _believed(run: Run, before: Run) -> Run:
    """Return a run with a certificate from the one before it, if it can be made again from this."""
    method = run.method
    if not isinstance(method, Dop853 | DormandPrince5):
        return run
    known = any(one == before.method for one in looser_than(method))
    return certify_tighter(run, before) if known else run


def _noted(run: Run, tolerance: float, attempt: int) -> Run:
    """Return a run that notes that no other method was weighed."""
    note = f"{run.method}: within {tolerance:g}{again(attempt)}; no other method was weighed"
    return with_reason(run, note)


def again(attempt: int) -> str:
    """Return what a note says of the tries before."""
    return "" if attempt == 0 else f", at the {_NAMES[attempt - 1]} try"


def _next(method: Adaptive, tolerance: float, reached: float, tightest: float) -> Adaptive:
    """Return the method at the tolerance that a bound which was too large tells to try.

    What is said of a run that was stopped is a guess: the tightest one is tried before none is.
    """
    rtol = method.rtol * _NEXT * tolerance / min(reached, 1.0)
    if rtol < tightest < _NEXT * method.rtol:
        rtol = tightest
    return replace(method, rtol=_own(rtol))


def _own(rtol: float, loosest: float = _LOOSEST) -> float:
    """Return the tolerance of a method that is tried: within what there are, in two digits."""
    return two_digits(min(max(rtol, SMALLEST), loosest))


def reached_by(certificate: Certificate | None) -> float:
    """Return the bound of places that a certificate states; infinity if it states none."""
    if certificate is None or certificate.bound is None or not certificate.bounds_positions:
        return math.inf
    return certificate.bound
