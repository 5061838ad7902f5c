"""Bounds of runs by equal steps, from runs by other steps (R5)."""

import math

import numpy as np

from tamias2d.run import Run
from tamias2d.state import Array, History
from tamias2d.study.bound import Bound, NoBoundError, companion_of, difference, rounding
from tamias2d.study.companion import RefusedError
from tamias2d.study.error import distance
from tamias2d.study.looks import with_ends_of_steps
from tamias2d.study.refined import SUBSTEPS, Refined, refined
from tamias2d.study.scale import radii

_GAP = 2.0**-41  # of the larger size: four times what an impact in a step leaves between bodies
_GRIDS, _DISTRUSTED = 1.5, 3.0  # times what companions say (after Roache's index)
_ORDER = 0.3  # within which the observed order is that of the scheme
_COARSEST = 16  # steps of a grid that is trusted to show the order


def step_doubling(run: Run, _: Array | None) -> Bound:
    """Bound the error from grids of twice and four times the step.

    Where these are very coarse, or the order that they show is not that of the scheme, the bound
    comes from a grid of half the step, and from the slower of both orders; from none where nothing
    converges yet.
    """
    if run.unresolved is not None:
        raise NoBoundError(run.unresolved)
    step = run.time_step or run.duration
    nominal = float(run.method.facts.order) if run.method.facts else 1.0
    coarse, fine = _coarser(run, step)
    rounded = rounding(run) * math.sqrt(run.duration / step)  # each step rounds, at random
    order = _order(coarse, fine)
    if order is not None and abs(order - nominal) <= _ORDER:
        value = _GRIDS * fine / (2 ** min(order, nominal) - 1) + rounded
        how = f"steps of {step:.4g} s, of twice and of four times that; observed order {order:.2f}"
        return Bound("step doubling", value, how, order)
    finer = difference(run, companion_of(run, time_step=step / 2))
    seen = _order(fine, finer)
    if seen is None:
        value = _DISTRUSTED * finer + rounded
        how = f"steps of {step:.4g} s and of half that; no order to be seen"
        if fine < math.inf and finer > rounding(run):
            raise NoBoundError("halving the step brings the results no nearer to each other")
        return Bound("step doubling", value, how)
    value = _GRIDS * finer / (1 - 2.0 ** -min(seen, nominal)) + rounded
    how = f"steps of {step:.4g} s, of twice and of half that; observed order {seen:.2f}"
    return Bound("step doubling", value, how, seen)


def _coarser(run: Run, step: float) -> tuple[float, float]:
    """Return how far steps of four times and twice are apart, and twice and the run's own, m.

    What is refused (most often as unstable) or too coarse to show an order is infinitely far.
    """
    try:
        twice = companion_of(run, time_step=min(2 * step, run.duration))
        fine = difference(twice, run)
        if run.duration / step < 4 * _COARSEST:
            return math.inf, fine
        return difference(companion_of(run, time_step=4 * step), twice), fine
    except NoBoundError:
        return math.inf, math.inf


def _order(coarse: float, fine: float) -> float | None:
    return math.log2(coarse / fine) if 0 < fine < coarse < math.inf else None


def shorter_runs(run: Run) -> Refined:
    """Return what runs by shorter steps say, trusted no more than those from its own step on."""
    step, substeps = run.time_step or run.duration, getattr(run.method, "substeps", SUBSTEPS)
    times = with_ends_of_steps(run.times, run.duration, step)
    try:
        longer, shorter = (
            refined(
                run.scene,
                duration=run.duration,
                times=times,
                time_step=from_step,
                grid=step,
                substeps=max(substeps, SUBSTEPS),
            )
            for from_step in (step, step / 2)
        )
        return shorter.after(longer)
    except RefusedError as fault:
        raise NoBoundError(f"runs by shorter steps were refused: {fault}") from fault


def against_shorter(run: Run, shorter: Refined) -> Bound:
    """Bound the error of steps through contacts by where shorter ones lead."""
    rows = np.searchsorted(shorter.times, run.times)
    doubt = shorter.doubt[rows]
    finest = History(*(part[rows] for part in shorter.finest))
    away = distance(run.scene, run, finest)
    rounded = rounding(run) * run.duration / shorter.time_step + gaps(run)
    how = (
        f"steps of {shorter.time_step:.4g} s; runs by steps of up to twice that, and by other "
        f"substeps, show that their end is within {float(doubt[-1]):.2g} m of the answer"
    )
    return Bound("step doubling", float((away + doubt).max(initial=0.0)) + rounded, how)


def gaps(run: Run) -> float:
    """Return the gaps at which impacts within steps are found, added up, m."""
    moving = [k for k, body in enumerate(run.scene.bodies) if body.dynamic]
    return _GAP * float(radii(run.scene)[moving].max(initial=0.0)) * len(run.impacts)
