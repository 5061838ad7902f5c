"""A certificate for a run, from companion runs of the same scene that bound its error."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TypeAlias

import numpy as np

from tamias2d.certificate import Certificate, Kind, hashes, not_claimed
from tamias2d.contact import RULED
from tamias2d.errors import InputError
from tamias2d.motion import (
    ClosedForm,
    Dop853,
    DormandPrince5,
    Legacy2018,
    Method,
    Reference,
    Stepped,
)
from tamias2d.motion.law_resolution import LOOKS, UNRESOLVED
from tamias2d.run import Run
from tamias2d.scene.acting import brief_laws, kinked
from tamias2d.scene.rules import shown
from tamias2d.solve import solve_halved
from tamias2d.state import Array, History
from tamias2d.study.companion import RefusedError, companion, limit_beside
from tamias2d.study.error import MEASURE, apart, distance, radii, scale, way
from tamias2d.study.invariants import energy_drift, energy_rise, energy_rounding
from tamias2d.study.penetration import Penetration, crowded, penetrations
from tamias2d.study.perturbed import LOST, MOVED, growth, horizon, rounding_spread
from tamias2d.study.refined import SUBSTEPS, Refined, refined
from tamias2d.suggestions import suggests

_EPSILON = 2.0**-52
_GAP = 2.0**-41  # of the larger size: four times what an impact in a step leaves between bodies
_ROUNDINGS = 2.0  # of the largest terms of a closed form, in each of its values
_FORCES, _EVALUATIONS = 2.0, 22  # roundings of a force that holds; forces that a step asks for
_SPREADS = 3.0  # times as far as runs perturbed by one rounding the exact answer may be
_TRUSTED, _GRIDS, _DISTRUSTED = 1.5, 1.5, 3.0  # times what companions say (after Roache's index)
_ONE = 2.5  # times what a single companion says: where a run meets something sharp, both may err
_ORDER = 0.3  # within which the observed order is that of the scheme
_COARSEST = 16  # steps of a grid that is trusted to show the order
_TIGHTER = 30.0  # is the companion of a run that chooses its own steps
_LEFT = 0.5  # of the error may be left in it
_TIGHTEST = 1e-14
_COARSE = 10 * MOVED  # is the tolerance of a method whose steps err more than what is perturbed
_HALVED = 3.0  # times what the order says of halved steps
_NEAR, _DISBELIEF = 3e-8, 0.5  # of the scale: as that is exceeded, the order is believed less
_FEW = 24  # halved steps show no order, and tighter ones are likely the same
_ROUNDS = 2e-13
"""The tolerance at which halved steps err by rounding as much as whole ones do, and by the square
of it less at looser ones: measured on orbits of all eccentricities up to 0.99995."""


_SOLUTION = "the exact solution of the scene's equations"
_LIMIT = "where ever shorter steps lead"
_STEPPED_MEASURE = MEASURE.replace("its exact place", _LIMIT)
_LEFT_OPEN = (
    "that rigid bodies do so where what is struck touches others: steps answer the blow at all "
    "contacts at once, and restitution follows (A18)"
)
_BRIEF = "what a law does for less than {shortest:.3g} s: it is asked a thousand times over the run"
_POINTS = "how far a body without a shape has turned: it has no point but its centre"
_UNSEEN = "that no body passes through another: of so many it is not looked for"
_BALANCE = "balance of energy, with what impacts take, relative to the largest kinetic energy"
_KEPT = "the balance of energy"
_RISE = "rise of the energy above what it was before"
_RISING = f"{_RISE}, relative to the largest kinetic one, or to what lifts bodies by their radius"


@dataclass(frozen=True)
class _Bound:
    kind: Kind
    value: float
    """m"""
    how: str
    order: float | None = None


_Way: TypeAlias = Callable[[Run, Array | None], _Bound]
"""From a run, and how small changes grow in it where that is known, to a bound."""


class _NoBoundError(Exception):
    """Why there is none; `lost_at` is the horizon, s, if that is why."""

    def __init__(self, why: str, lost_at: float | None = None) -> None:
        super().__init__(why)
        self.lost_at = lost_at


@suggests
def certify(run: Run) -> Run:
    """Return the run with a certificate; without a bound where bodies pass through each other.

    The scene is simulated some times more: in closed form twice, by a stepped scheme on two coarser
    grids (together three quarters of the run's cost, and a finer one if they disagree about the
    order), by an adaptive one at a tighter tolerance or, where its steps are halved, by whole ones,
    through contacts four times by steps from a half to a quarter (some ten times the run's cost);
    once more, perturbed, where steps are equal or a path is exact; and once to look for bodies that
    overlap or pass through each other.
    """
    if not isinstance(run, Run):
        raise InputError(f"run: found {shown(run)}: must be a Run (R5). Give one of `simulate`.")
    if isinstance(run.method, Stepped):
        return certify_steps(run)
    return _certified(run, lambda: _way(run.method), told=True)


def certify_halved(run: Run, apart: Array | None) -> Run:
    """Return a run by halved steps with a certificate, from how far whole ones are, (n, 3)."""
    return _certified(run, lambda: lambda run, _: _of_halves(run, apart))


def certify_embedded(run: Run) -> tuple[Run, Run | None]:
    """Return an adaptive run with a certificate, and the one at a tighter tolerance behind it."""
    tighter: list[Run] = []
    found = _certified(run, lambda: lambda run, _: _embedded(run, tighter))
    return found, tighter[-1] if tighter else None


def _certified(run: Run, way: Callable[[], _Way], *, told: bool = False) -> Run:
    """Return a run with a certificate, which tells of the horizon also where its bound is large."""
    if not crowded(run) and (fault := next(penetrations(run), None)) is not None:
        return replace(run, certificate=_of_penetration(run, fault))
    try:
        certificate = _of_positions(run, _found(run, way(), told=told))
    except _NoBoundError as reason:
        certificate = _of_energy(run, str(reason), reason.lost_at)
    else:  # the way of many bodies is searched only if something is said of it
        if crowded(run) and (fault := next(penetrations(run), None)) is not None:
            certificate = _of_penetration(run, fault)
    return replace(run, certificate=_with_rule(certificate, run))


def is_bounded(run: Run) -> bool:
    """Return whether the certificate of a run states a bound."""
    certificate = certify(run).certificate
    return certificate is not None and certificate.bound is not None


def _with_rule(certificate: Certificate, run: Run) -> Certificate:
    """Return a certificate that tells what was decided by rule, and when (A18)."""
    told = tuple(
        f"that nature decides as the {note}" for note in run.notes if note.startswith(f"{RULED}: ")
    )
    return replace(certificate, does_not_claim=certificate.does_not_claim + told)


def _found(run: Run, way: _Way, *, told: bool) -> _Bound:
    """Return a bound; none past the horizon.

    Runs that agree although each of their steps errs by more than what is perturbed show that this
    does not grow: they need no perturbed run.
    """
    early, fault = None, None
    if getattr(run.method, "rtol", 0.0) >= _COARSE:
        try:
            early = way(run, None)
        except _NoBoundError as reason:
            fault = reason
        if early is not None and (not told or early.value <= LOST * scale(run)):
            return early
    grown = growth(run)
    if (lost_at := horizon(run, grown)) is not None:
        raise _NoBoundError(
            f"a change of {MOVED:g} of the scale grows to {LOST:.0%} of it within the run", lost_at
        )
    if fault is not None:
        raise fault
    return early or way(run, grown)


def certify_steps(run: Run, shorter: Refined | None = None) -> Run:
    """Return a run by steps through contacts with a certificate, from runs by shorter steps.

    Without such, four are made, by steps from a half to a quarter of its own.
    """
    if not crowded(run) and (fault := next(penetrations(run), None)) is not None:
        return replace(run, certificate=_of_penetration(run, fault))
    lost_at = None
    try:
        shorter = shorter or _shorter(run)
        lost_at = shorter.horizon(LOST)
        certificate = _of_positions(run, _against_shorter(run, shorter))
    except _NoBoundError as reason:
        certificate = _of_energy(run, str(reason), lost_at)
    return replace(run, certificate=certificate)


def _way(method: Method) -> _Way:
    if isinstance(method, ClosedForm):
        return _exact
    if isinstance(method, Legacy2018):
        raise _NoBoundError("the scheme of 2018 is inconsistent: no step makes its error small")
    if method.fixed_step:
        return _step_doubling
    if isinstance(method, Dop853 | DormandPrince5) and method.halved:
        return lambda run, _: _of_halves(run, _whole_beside(run))
    return lambda run, _: _embedded(run, [])


def _of_positions(run: Run, found: _Bound) -> Certificate:
    stepped = isinstance(run.method, Stepped)
    length, of = scale(run), "that the farthest one goes"
    if not way(run.scene, run):
        of = "taken where nothing moves"
    if stepped and length < (largest := float(radii(run.scene).max(initial=0.0))):
        length, of = largest, "around the largest one"  # what only sinks in goes nowhere
    if found.value > length:
        raise _NoBoundError(f"a bound by {found.kind} would be larger than the motion itself")
    until = f"at all {len(run.times)} samples up to {run.times[-1]:g} s"
    return Certificate(
        kind=found.kind,
        measure=f"{_STEPPED_MEASURE if stepped else MEASURE}, relative to the {length:.6g} m {of}",
        bound=found.value / length,
        how=found.how,
        claims=(f"how far it is from {_LIMIT if stepped else _SOLUTION}, {until}",),
        does_not_claim=(
            *not_claimed(None),
            *_brief(run),
            *_turning(run),
            *((_LEFT_OPEN,) if stepped else ()),
            *((_UNSEEN,) if stepped and crowded(run) else ()),
        ),
        observed_order=found.order,
        predictability_horizon=None,
        hashes=hashes(run.scene),
    )


def _brief(run: Run) -> tuple[str, ...]:
    """Return what is not claimed of laws that may do something for a moment."""
    if isinstance(run.method, ClosedForm) or not brief_laws(run.scene):
        return ()
    return (_BRIEF.format(shortest=run.duration / LOOKS),)


def _turning(run: Run) -> tuple[str, ...]:
    """Return what is not claimed of bodies without a shape: they have no point but the centre."""
    points = [k for k, b in enumerate(run.scene.bodies) if b.dynamic and b.shape is None]
    return (_POINTS,) if np.ptp(run.orientation[:, points], axis=0).any() else ()


def _of_penetration(run: Run, fault: Penetration) -> Certificate:
    """Return the certificate of a run that is wrong, whatever else is known of it."""
    first, second = (run.scene.bodies[k].name for k in fault.bodies)
    what = f"overlap by {fault.depth:.3g} m" if fault.depth else "pass through each other"
    return Certificate(
        kind="none",
        measure=MEASURE,
        bound=None,
        how=f"'{first}' and '{second}' {what} at {fault.time:.6g} s",
        claims=(),
        does_not_claim=(*not_claimed(None), "where single bodies are, since solid ones do not"),
        observed_order=None,
        predictability_horizon=None,
        hashes=hashes(run.scene),
    )


def _of_energy(run: Run, reason: str, lost_at: float | None) -> Certificate:
    """Return what is left to say: how well the run keeps the balance of energy."""
    stepped = isinstance(run.method, Stepped)
    strayed = energy_rise(run) if stepped else energy_drift(run)
    if strayed is None or not math.isfinite(strayed):
        bound = None
    else:
        bound = strayed + energy_rounding(run)
    return Certificate(
        kind="none" if bound is None else "invariants",
        measure=_RISING if stepped else _BALANCE,
        bound=bound,
        how=reason,
        claims=() if bound is None else (f"{_RISE if stepped else _KEPT} at all samples",),
        does_not_claim=(
            *not_claimed(lost_at),
            "where single bodies are, since " + reason,
            *((_UNSEEN,) if crowded(run) else ()),
        ),
        observed_order=None,
        predictability_horizon=lost_at,
        hashes=hashes(run.scene),
    )


def _exact(run: Run, grown: Array | None) -> _Bound:
    """Bound what rounding does, from the sizes of the terms and, with impacts, from perturbed runs.

    An impact is located within the rounding of its gap, which moves its instant by that over the
    normal velocity, and all that follows. Runs perturbed by one rounding show that.
    """
    value = _ROUNDINGS * rounding(run) * _held(run)
    if not len(run.impacts):
        return _Bound("exact", value, "closed form, bounded from the rounding of its terms")
    strayed = rounding_spread(run)
    if strayed is None or grown is None:
        raise _NoBoundError("a scene that differs by rounding ends in a refusal")
    how = (
        f"closed form and {len(run.impacts)} located impacts, bounded from runs perturbed "
        f"by one rounding; a small change grows to {float(grown.max()):.3g} times its size"
    )
    return _Bound("exact", value + _SPREADS * strayed, how)


def _held(run: Run) -> float:
    """Return how much more rounds where contacts hold bodies, whose paths are integrated then.

    Each step rounds, at random, and so does the force that holds them.
    """
    evaluations = run.cost.force_evaluations if run.cost else 0
    return max(1.0, _FORCES * math.sqrt(evaluations / _EVALUATIONS))


def rounding(run: Run) -> float:
    """Return the rounding of the largest terms in any place of the run, m."""
    reach = radii(run.scene)
    speed = np.hypot(*np.moveaxis(run.velocity, -1, 0)) + np.abs(run.angular_velocity) * reach
    far = np.hypot(*np.moveaxis(run.position, -1, 0)) + np.abs(run.orientation) * reach
    worst = far.max(axis=0) + run.times[-1] * speed.max(axis=0)
    moving = np.array([body.dynamic for body in run.scene.bodies], dtype=bool)
    return _EPSILON * float(worst[moving].max(initial=0.0))


def _gaps(run: Run) -> float:
    """Return the gaps at which impacts within steps are found, added up, m."""
    moving = [k for k, body in enumerate(run.scene.bodies) if body.dynamic]
    return _GAP * float(radii(run.scene)[moving].max(initial=0.0)) * len(run.impacts)


def _step_doubling(run: Run, _: Array | None) -> _Bound:
    """Bound the error from grids of twice and four times the step.

    Where these are very coarse, or the order that they show is not that of the scheme, the bound
    comes from a grid of half the step, and from the slower of both orders; from none where nothing
    converges yet.
    """
    if note := next((note for note in run.notes if note.startswith(UNRESOLVED)), ""):
        raise _NoBoundError(note)
    step = run.time_step or run.duration
    nominal = float(run.method.facts.order) if run.method.facts else 1.0
    coarse, fine = _coarser(run, step)
    rounded = rounding(run) * math.sqrt(run.duration / step)  # each step rounds, at random
    order = _order(coarse, fine)
    if order is not None and abs(order - nominal) <= _ORDER:
        value = _GRIDS * fine / (2 ** min(order, nominal) - 1) + rounded
        how = f"steps of {step:.4g} s, of twice and of four times that; observed order {order:.2f}"
        return _Bound("step doubling", value, how, order)
    finer = _difference(run, _companion(run, time_step=step / 2))
    seen = _order(fine, finer)
    if seen is None:
        value = _DISTRUSTED * finer + rounded
        how = f"steps of {step:.4g} s and of half that; no order to be seen"
        if fine < math.inf and finer > rounding(run):
            raise _NoBoundError("halving the step brings the results no nearer to each other")
        return _Bound("step doubling", value, how)
    value = _GRIDS * finer / (1 - 2.0 ** -min(seen, nominal)) + rounded
    how = f"steps of {step:.4g} s, of twice and of half that; observed order {seen:.2f}"
    return _Bound("step doubling", value, how, seen)


def _shorter(run: Run) -> Refined:
    """Return what runs by shorter steps say."""
    step, substeps = run.time_step or run.duration, getattr(run.method, "substeps", SUBSTEPS)
    try:
        return refined(
            run.scene,
            duration=run.duration,
            times=run.times,
            time_step=step / 2,
            grid=step,
            substeps=max(substeps, SUBSTEPS),
        )
    except RefusedError as fault:
        raise _NoBoundError(f"runs by shorter steps were refused: {fault}") from fault


def _against_shorter(run: Run, shorter: Refined) -> _Bound:
    """Bound the error of steps through contacts by where shorter ones lead."""
    rows = np.searchsorted(shorter.times, run.times)
    doubt = shorter.doubt[rows]
    finest = History(*(part[rows] for part in shorter.finest))
    away = distance(run.scene, run, finest)
    rounded = rounding(run) * run.duration / shorter.time_step + _gaps(run)
    how = (
        f"steps of {shorter.time_step:.4g} s; runs by steps of up to twice that, and by other "
        f"substeps, show that this is within {float(doubt[-1]):.2g} m of the answer"
    )
    return _Bound("step doubling", float((away + doubt).max(initial=0.0)) + rounded, how)


def _coarser(run: Run, step: float) -> tuple[float, float]:
    """Return how far steps of four times and twice are apart, and twice and the run's own, m.

    What is refused (most often as unstable) or too coarse to show an order is infinitely far.
    """
    try:
        twice = _companion(run, time_step=min(2 * step, run.duration))
        fine = _difference(twice, run)
        if run.duration / step < 4 * _COARSEST:
            return math.inf, fine
        return _difference(_companion(run, time_step=4 * step), twice), fine
    except _NoBoundError:
        return math.inf, math.inf


def _order(coarse: float, fine: float) -> float | None:
    return math.log2(coarse / fine) if 0 < fine < coarse < math.inf else None


def _of_halves(run: Run, apart: Array | None) -> _Bound:
    """Bound the error of halved steps from how far whole ones are, (n, 3), or as of others.

    By the order p of the scheme halves err 2^p - 1 times less than both differ. The farther apart
    they are, and the fewer, the less the order is believed: where a run meets something sharp, or
    is coarse, both may err by much the same. Across a kink of a force there is no order, and none
    below rounding.
    """
    steps = run.cost.steps if run.cost else 0
    rounds: float = (_ROUNDS / run.method.rtol) ** 2  # type: ignore[attr-defined]
    if apart is None or steps < _FEW or run.method.facts is None or kinked(run.scene):
        return _embedded(run, [])
    if rounds > _TRUSTED:
        return _against(run, Reference(1e-13))
    farthest = float((np.hypot(apart[:, 0], apart[:, 1]) + apart[:, 2] * radii(run.scene)).max())
    order = float(run.method.facts.order)
    doubt = _HALVED * max(1.0, (farthest / (_NEAR * scale(run))) ** _DISBELIEF)
    value = (min(doubt / (2**order - 1), 1.0) + rounds) * farthest + rounding(run)
    how = f"{run.method} against whole steps, which are {farthest:.2g} m away"
    return _Bound("embedded", value, how)


def _whole_beside(run: Run) -> Array | None:
    """Return how far whole steps are from a run by halved ones, (n, 3); None where that is hidden.

    The run is made again.
    """
    assert isinstance(run.method, Dop853 | DormandPrince5)
    limit = limit_beside(run)
    return solve_halved(
        run.scene, duration=run.duration, method=run.method, times=run.times, work_limit=limit
    )[1]


def _embedded(run: Run, tighter: list[Run]) -> _Bound:
    """Bound the error from the same method at a tighter tolerance, or from an independent one.

    A tighter tolerance must have made the steps so much shorter that what is left of the error, by
    the order of the method, is a small part of it: over few steps it may change nothing. Where even
    it takes few, some are likely the same, with the same error, and it is believed no more than it
    was asked for. The runs that are made are added to those that are `tighter`.
    """
    rtol: float = run.method.rtol  # type: ignore[attr-defined]
    tightest = _ROUNDS if getattr(run.method, "halved", False) else _TIGHTEST
    if isinstance(run.method, Reference) or rtol / _TIGHTER < tightest:
        return _against(
            run, Dop853(1e-14) if isinstance(run.method, Reference) else Reference(1e-13)
        )
    left = 1.0
    while left > _LEFT and rtol / _TIGHTER >= tightest:
        rtol = float(f"{rtol / _TIGHTER:.1e}")
        companion = _at(run, rtol)
        tighter.append(companion)
        left = _left(run, companion)
    if left > _LEFT:
        return _against(run, Reference(1e-13))
    value = _ONE * _difference(run, companion) / (1 - left) + rounding(run)
    if _is_short(companion):
        value = max(value, rtol * scale(run))
    return _Bound("embedded", value, f"{run.method} against {companion.method}")


def _is_short(run: Run) -> bool:
    """Return whether a run takes few steps from one event to the next: these cut its steps."""
    steps = run.cost.steps if run.cost else 0
    return steps < _FEW * (1 + len(run.impacts) + len(run.joint_events))


def _at(run: Run, rtol: float) -> Run:
    """Return a run of the same scene by the same method at another tolerance."""
    return _companion(run, method=replace(run.method, rtol=rtol))  # type: ignore[type-var]


def _left(run: Run, companion: Run) -> float:
    """Return how much of the error a companion has left, by the number of its steps."""
    steps = [one.cost.steps if one.cost else 1 for one in (run, companion)]
    order = float(run.method.facts.order) if run.method.facts else 1.0
    return float((steps[0] / steps[1]) ** order)


def _against(run: Run, method: Method) -> _Bound:
    """Bound the error from a run as tight as float64 allows, by another program."""
    distance = _difference(run, _companion(run, method=method))
    value = 2 * _TRUSTED * distance + rounding(run)
    return _Bound("reference", value, f"{run.method} against {method}")


def _difference(one: Run, other: Run) -> float:
    worst = float(apart(one, other).max())
    return worst if math.isfinite(worst) else math.inf


def _companion(run: Run, *, method: Method | None = None, time_step: float | None = None) -> Run:
    """Return a run of the same scene at the same times, by another method or step."""
    try:
        return companion(
            run.scene,
            duration=run.duration,
            times=run.times,
            method=method or run.method,
            time_step=time_step,
            work_limit=limit_beside(run),
        )
    except RefusedError as fault:
        raise _NoBoundError(f"a companion run was refused: {fault}") from fault
