"""Bounds of runs that choose their steps, from tighter tolerances or from whole steps (R5)."""

import math
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from tamias2d.certificate import Basis
from tamias2d.motion import Dop853, DormandPrince5, Method, Reference
from tamias2d.motion.halved import Halving
from tamias2d.run import Run
from tamias2d.scene.acting import brief_laws, kinked
from tamias2d.solve import solve_halved
from tamias2d.study.bound import Bound, NoBoundError, companion_of, difference, rounding
from tamias2d.study.companion import error_left, limit_beside
from tamias2d.study.scale import radii, scale
from tamias2d.study.two_digits import two_digits

_BY_HALVES, _BY_COMPANIONS = Basis("halved steps"), Basis("companions")

_TRUSTED = 1.5  # times what companions say (after Roache's index)
_ONE = 2.5  # times what a single companion says: where a run meets something sharp, both may err
_TIGHTER = 30.0  # is the companion of a run that chooses its own steps
_FINER = 3e3  # times that of halved steps is: whole ones must be shorter than halves
_LEFT = 0.5  # of the error may be left in it
_TIGHTEST = 1e-14
_LUCKY = 3.0  # times the root of what the order leaves of an error: either run may be good by luck
_HALVED = 3.0  # times what the order says of halved steps
_SUDDEN = 3.0  # times that where some steps met something sudden
_NEAR, _DISBELIEF = 3e-8, 0.3  # of the scale: as that is exceeded, the order is believed less
_FAR = 1e-2  # of the scale: as that is exceeded, there soon is no order
_FEW = 24  # halved steps show no order, and tighter ones are likely the same
_LEAST = (1e-14, 3e-14, 1e-13)  # tolerances at which steps err by rounding
_ROUNDS = 2e-13
"""The tolerance at which halved steps err by rounding as much as whole ones do, and by the square
of it less at looser ones: measured on orbits of all eccentricities up to 0.99995."""


def of_halves(run: Run, halving: Halving | None, tighter: list[Run]) -> Bound:
    """Bound the error of halved steps from how far whole ones are, or as of others.

    By the order p of the scheme halves err 2^p - 1 times less than both differ. The farther apart
    they are, and the fewer, the less the order is believed: where a run meets something sharp, or
    is coarse, both may err by much the same. Across a kink of a force there is no order, none
    where steps are suddenly short for what a law does for a moment, and none below rounding.
    """
    steps = run.cost.steps if run.cost else 0
    rounds: float = (_ROUNDS / run.method.rtol) ** 2  # type: ignore[attr-defined]
    if halving is None or steps < _FEW or run.method.facts is None or kinked(run.scene):
        return embedded(run, tighter)
    x, y, turn = halving.apart.T
    farthest = float((np.hypot(x, y) + turn * radii(run.scene)).max())
    if rounds > _TRUSTED:
        return _near_rounding(run, farthest)
    if halving.sudden and brief_laws(run.scene):
        return embedded(run, tighter)
    doubt = _doubt(farthest / scale(run)) * (_SUDDEN if halving.sudden else 1.0)
    share = min(doubt / (2.0 ** float(run.method.facts.order) - 1), 1.0)
    value = (share + rounds) * farthest + rounding(run)
    how = f"{run.method} against whole steps, which are {farthest:.2g} m away"
    return Bound("embedded", value, how, basis=_BY_HALVES)


def _near_rounding(run: Run, farthest: float) -> Bound:
    """Bound the error of a run from how far whole steps are: its own, and those of other lengths.

    All of them err by rounding, and of three some are unlikely to err just as the run does.
    """
    asked: float = run.method.rtol  # type: ignore[attr-defined]
    others = sorted(_LEAST, key=lambda rtol: abs(math.log(rtol / asked)))[1:]
    distances = [difference(run, _by_whole_steps(run, rtol)) for rtol in others]
    value = 2 * _TRUSTED * max(farthest, *distances) + rounding(run)
    how = f"{run.method} against whole steps at three tolerances"
    return Bound("embedded", value, how, basis=_BY_HALVES)


def _doubt(share: float) -> float:
    """Return how many times what the order says is believed, where whole steps are a share away."""
    near: float = _HALVED * max(1.0, (share / _NEAR) ** _DISBELIEF)
    return near * max(1.0, (share / _FAR) ** 2)


def whole_beside(run: Run) -> Halving | None:
    """Return how far whole steps are from a run by halved ones; None where that is hidden.

    The run is made again.
    """
    assert isinstance(run.method, Dop853 | DormandPrince5)
    limit = limit_beside(run)
    return solve_halved(
        run.scene, duration=run.duration, method=run.method, times=run.times, work_limit=limit
    )[1]


def embedded(run: Run, tighter: list[Run]) -> Bound:
    """Bound the error from the same method at a tighter tolerance, or from an independent one.

    A tighter tolerance must have made the steps so much shorter that what is left of the error, by
    the order of the method, is a small part of it: over few steps it may change nothing. Where even
    it takes few, some are likely the same, with the same error, and it is believed no more than it
    was asked for. The runs that are made are added to those that are `tighter`.
    """
    rtol: float = run.method.rtol  # type: ignore[attr-defined]
    halved = getattr(run.method, "halved", False)
    tightest, times = (_ROUNDS, _FINER) if halved else (_TIGHTEST, _TIGHTER)
    if isinstance(run.method, Reference) or rtol / times < tightest:
        return _against(
            run, Dop853(1e-14) if isinstance(run.method, Reference) else Reference(1e-13)
        )
    left = 1.0
    while left > _LEFT and rtol / times >= tightest:
        rtol = two_digits(rtol / times)
        companion = _by_whole_steps(run, rtol)
        tighter.append(companion)
        left, times = error_left(run, companion), _TIGHTER
    if left > _LEFT:
        return _against(run, Reference(1e-13))
    value = _ONE * difference(run, companion) / (1 - left) + rounding(run)
    if _is_short(companion):
        value = max(value, rtol * scale(run))
    return Bound(
        "embedded", value, f"{run.method} against {companion.method}", basis=_BY_COMPANIONS
    )


def of_tighter(run: Run, looser: Run) -> Bound:
    """Bound the error of a run from a looser one, whose companion it was.

    Errors of steps that are chosen follow the tolerance roughly. Where the looser run is good by
    luck, this one errs by more of the difference than the order leaves, which its root allows for.
    """
    left = error_left(looser, run)
    if left > _LEFT:
        raise NoBoundError("the steps of the looser run are nearly as short")
    value = _LUCKY * math.sqrt(left) * difference(run, looser) + rounding(run)
    if _is_short(run):
        value = max(value, run.method.rtol * scale(run))  # type: ignore[attr-defined]
    rtol: float = looser.method.rtol  # type: ignore[attr-defined]
    basis = Basis("looser run", rtol=rtol)
    return Bound("embedded", value, f"{run.method} against {looser.method}", basis=basis)


def looser_than(method: Dop853 | DormandPrince5) -> Iterator[Dop853 | DormandPrince5]:
    """Yield the methods whose companion, at a tighter tolerance, is by another one."""
    for nearly in (1.0, 0.99, 1.01, 0.98, 1.02):  # times: tolerances have two digits
        rtol = two_digits(nearly * _TIGHTER * method.rtol)
        if rtol < 1 and two_digits(rtol / _TIGHTER) == method.rtol:
            yield replace(method, rtol=rtol)


def _is_short(run: Run) -> bool:
    """Return whether a run takes few steps from one event to the next: these cut its steps."""
    steps = run.cost.steps if run.cost else 0
    return steps < _FEW * (1 + len(run.impacts) + len(run.joint_events))


def _by_whole_steps(run: Run, rtol: float) -> Run:
    """Return a run of the same scene by the same method at another tolerance."""
    assert isinstance(run.method, Dop853 | DormandPrince5)
    return companion_of(run, method=replace(run.method, rtol=rtol, halved=False))


def _against(run: Run, method: Method) -> Bound:
    """Bound the error from a run as tight as float64 allows, by another program."""
    distance = difference(run, companion_of(run, method=method))
    value = 2 * _TRUSTED * distance + rounding(run)
    return Bound("reference", value, f"{run.method} against {method}", basis=_BY_COMPANIONS)
