"""Bounds of runs that choose their steps, from tighter tolerances or from whole steps (R5)."""

from dataclasses import replace

import numpy as np

from tamias2d.motion import Dop853, DormandPrince5, Method, Reference
from tamias2d.run import Run
from tamias2d.scene.acting import kinked
from tamias2d.solve import solve_halved
from tamias2d.state import Array
from tamias2d.study.bound import Bound, companion_of, difference, rounding
from tamias2d.study.companion import limit_beside
from tamias2d.study.error import radii, scale

_TRUSTED = 1.5  # times what companions say (after Roache's index)
_ONE = 2.5  # times what a single companion says: where a run meets something sharp, both may err
_TIGHTER = 30.0  # is the companion of a run that chooses its own steps
_LEFT = 0.5  # of the error may be left in it
_TIGHTEST = 1e-14
_HALVED = 3.0  # times what the order says of halved steps
_NEAR, _DISBELIEF = 3e-8, 0.5  # of the scale: as that is exceeded, the order is believed less
_FEW = 24  # halved steps show no order, and tighter ones are likely the same
_ROUNDS = 2e-13
"""The tolerance at which halved steps err by rounding as much as whole ones do, and by the square
of it less at looser ones: measured on orbits of all eccentricities up to 0.99995."""


def of_halves(run: Run, apart: Array | None) -> Bound:
    """Bound the error of halved steps from how far whole ones are, (n, 3), or as of others.

    By the order p of the scheme halves err 2^p - 1 times less than both differ. The farther apart
    they are, and the fewer, the less the order is believed: where a run meets something sharp, or
    is coarse, both may err by much the same. Across a kink of a force there is no order, and none
    below rounding.
    """
    steps = run.cost.steps if run.cost else 0
    rounds: float = (_ROUNDS / run.method.rtol) ** 2  # type: ignore[attr-defined]
    if apart is None or steps < _FEW or run.method.facts is None or kinked(run.scene):
        return embedded(run, [])
    if rounds > _TRUSTED:
        return _against(run, Reference(1e-13))
    farthest = float((np.hypot(apart[:, 0], apart[:, 1]) + apart[:, 2] * radii(run.scene)).max())
    order = float(run.method.facts.order)
    doubt = _HALVED * max(1.0, (farthest / (_NEAR * scale(run))) ** _DISBELIEF)
    value = (min(doubt / (2**order - 1), 1.0) + rounds) * farthest + rounding(run)
    how = f"{run.method} against whole steps, which are {farthest:.2g} m away"
    return Bound("embedded", value, how)


def whole_beside(run: Run) -> Array | None:
    """Return how far whole steps are from a run by halved ones, (n, 3); None where that is hidden.

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
    value = _ONE * difference(run, companion) / (1 - left) + rounding(run)
    if _is_short(companion):
        value = max(value, rtol * scale(run))
    return Bound("embedded", value, f"{run.method} against {companion.method}")


def _is_short(run: Run) -> bool:
    """Return whether a run takes few steps from one event to the next: these cut its steps."""
    steps = run.cost.steps if run.cost else 0
    return steps < _FEW * (1 + len(run.impacts) + len(run.joint_events))


def _at(run: Run, rtol: float) -> Run:
    """Return a run of the same scene by the same method at another tolerance."""
    return companion_of(run, method=replace(run.method, rtol=rtol))  # type: ignore[type-var]


def _left(run: Run, companion: Run) -> float:
    """Return how much of the error a companion has left, by the number of its steps."""
    steps = [one.cost.steps if one.cost else 1 for one in (run, companion)]
    order = float(run.method.facts.order) if run.method.facts else 1.0
    return float((steps[0] / steps[1]) ** order)


def _against(run: Run, method: Method) -> Bound:
    """Bound the error from a run as tight as float64 allows, by another program."""
    distance = difference(run, companion_of(run, method=method))
    value = 2 * _TRUSTED * distance + rounding(run)
    return Bound("reference", value, f"{run.method} against {method}")
