"""Pilot runs: how fast the error of each method falls with its cost, in this very scene.

Errors are differences from one run at a far tighter tolerance, at times spread over the whole run:
short horizons would not show how errors grow. Two grids on which the error falls at the order of
the scheme give its constant C, and error = C h^p gives the step for a tolerance. Costs are counted,
not timed, so that the same scene gives the same answer. A method is given up as soon as its own
order says that it will cost more than the best one.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from tamias2d.motion import Dop853, Method
from tamias2d.run import Run
from tamias2d.scene import Scene
from tamias2d.solve import solve
from tamias2d.state import Array
from tamias2d.study.companion import RefusedError, companion, error_left
from tamias2d.study.error import apart
from tamias2d.study.refusal import sooner
from tamias2d.study.scale import scale
from tamias2d.study.two_digits import two_digits
from tamias2d.work_limit import WORK_LIMIT, WorkLimitError

MARGIN = 2.0
"""Of the tolerance over the error that is aimed at: certificates are larger than errors."""
_SAMPLES = 120
_ORDER = 0.35  # within which an observed order is that of the scheme
_TRIALS = 5
_CHEAP = 1e-4  # is the first tolerance of a pilot, from which its order says whether it can win
_ENOUGH = 0.8  # of the cost is needed by the best setting: a further trial would not pay
_WITNESS = 1e-2  # of the tolerance is that of the run which the others are compared with
_LOOSER = 30.0  # times its tolerance has the run that shows how far it can be trusted
_DOUBT = 0.1  # of the tolerance may be in doubt
_FEWEST = 8  # steps of a pilot
_FARTHER = 16.0  # times the steps of a pilot that its order is trusted for
_LOOSEST, _TIGHTEST = 0.1, 1e-14
_RUNS = 2  # of the longest that a run may be: the pilots' share of work


@dataclass(frozen=True)
class Estimate:
    """What a method is expected to cost for a tolerance; `why` not, if it cannot."""

    method: Method
    time_step: float | None
    """s"""
    force_evaluations: float
    error: float
    """Relative to the scale: an upper bound with the tolerance's margin."""
    observed_order: float | None
    why: str = ""


class Pilot:
    """Pilot runs of one scene, for one tolerance; `spent` force evaluations on them.

    Together they take at most twice as many steps and impacts as one run may.

    Raises:
        WorkLimitError: that is too few for the run that the others would be compared with.
    """

    def __init__(
        self, scene: Scene, duration: float, tolerance: float, work_limit: int = WORK_LIMIT
    ) -> None:
        self._scene = scene
        self._duration = duration
        self._times = np.linspace(0.0, duration, _SAMPLES + 1)
        self.tolerance = tolerance
        self._aim = tolerance / MARGIN
        self.spent = 0
        self._work_limit = work_limit
        self._left = _RUNS * work_limit
        self.reachable = 0.0
        """The error of the tightest run that was looked at, relative to the scale."""
        self.until: float | None = None
        """Before it that run is within the tolerance, if it is not all along, s."""
        self._looser: tuple[float, Run]
        """What the witness was compared with: its tolerance, and the run."""
        self._exact = self._witness()
        self.scale = scale(self._exact)

    def fixed_step(self, method: Method, most: float) -> Estimate:
        """Return the step with which a scheme meets the tolerance; give up above a cost."""
        order = float(method.facts.order) if method.facts else 1.0
        count = _FEWEST
        before, seen, cost = math.inf, None, 0.0
        while True:
            if count > self._left:
                why = f"{count} steps are more than are left to pilot runs"
                return Estimate(method, None, math.inf, before, seen, why)
            error, run = self._error(method, self._duration / count)
            if run is not None and run.cost is not None:
                cost = run.cost.force_evaluations / run.cost.steps
            seen = math.log2(before / error) if 0 < error < before < math.inf else None
            if error <= self._aim:
                wanted = self._between(count, before, error, seen)
                return self._estimate(method, wanted, cost, seen)
            if seen is not None and abs(seen - order) <= _ORDER:
                farther = (error / self._aim) ** (1 / min(seen, order))
                if farther <= _FARTHER or farther * count * cost > most:
                    return self._estimate(method, count * farther, cost, seen)
            least = count * (min(error, 1.0) / self._aim) ** (1 / (order + _ORDER))
            if cost and least * cost > most:
                why = f"needs at least {least * cost:.0f} force evaluations"
                return Estimate(method, None, math.inf, error, seen, why)
            if count * cost > most or count > 2**22:
                why = "no order" if seen is None else f"order {seen:.2f}, of {order:g},"
                why = f"{why} seen at {count} steps" if error < math.inf else "refused so far"
                why += f", which cost {count * cost:.0f}" if count * cost > most else ""
                return Estimate(method, None, math.inf, error, seen, why)
            before, count = error, 2 * count

    def adaptive(self, method: type[Any], most: float = math.inf) -> Estimate:
        """Return the tolerance of its own with which an adaptive method meets that of the run.

        How its errors follow its tolerance has no law, so that the one that is returned was tried.
        What would cost more than `most` is given up.
        """
        order = float(method().facts.order)
        rtol, error, cost = self._first_of(method)
        best, least, why = None, math.inf, "refused"
        tried: set[float] = set()
        while len(tried) < _TRIALS and rtol not in tried and self._left > 0:
            tried.add(rtol)
            if not error:
                error, run = self._error(method(rtol=rtol), None)
                cost = run.cost.force_evaluations if run and run.cost else math.inf
            least = min(least, error)
            if error <= self._aim and (best is None or cost < best.force_evaluations):
                best = Estimate(method(rtol=rtol), None, cost, error * MARGIN, None)
            share = error / self._aim
            if _ENOUGH <= share ** (1 / order) <= 1:
                break
            needed = cost * share ** (1 / (order + _ORDER))
            if needed > most and best is None:
                why = f"needs at least {needed:.0f} force evaluations"
                break
            rtol, error = self._nearer(rtol, error), 0.0
        if math.isfinite(least) and why == "refused":
            why = f"reaches only {least:.1e}"
        return best or Estimate(method(rtol=rtol), None, math.inf, least, None, why)

    def _first_of(self, method: type[Any]) -> tuple[float, float, float]:
        """Return a first tolerance of an adaptive method, with its error and cost if it was run."""
        if method is not Dop853:
            return min(max(self.tolerance, _CHEAP), _LOOSEST), 0.0, math.inf
        rtol, run = self._looser
        error = float(apart(run, self._exact).max()) / self.scale
        return rtol, error, run.cost.force_evaluations if run.cost else math.inf

    def _nearer(self, rtol: float, error: float) -> float:
        """Return a tolerance that brings an error nearer to the one that is aimed at."""
        factor = min(max(0.6 * self._aim / max(error, 1e-17), 1e-3), 1e3)
        return two_digits(min(max(rtol * factor, _TIGHTEST), _LOOSEST))

    def _between(self, count: int, before: float, error: float, seen: float | None) -> float:
        """Return how many steps are enough, if `count` are and half of them may not be."""
        if seen is None or before <= self._aim:
            return count
        return float(max(count * (error / self._aim) ** (1 / seen), count / 2))

    def _estimate(
        self, method: Method, count: float, per_step: float, seen: float | None
    ) -> Estimate:
        steps = 4 * math.ceil(count / 4)  # so that the certificate's coarser grids fit
        step = self._duration / steps
        return Estimate(method, step, steps * per_step, self.tolerance, seen)

    def _witness(self) -> Run:
        """Return the run that the others are compared with, and see how far it can be trusted.

        Its error is a part of how far it is from a looser run, which follows from their steps.
        """
        rtol = two_digits(max(self.tolerance * _WITNESS, 1e-13))
        looser = two_digits(rtol * _LOOSER)
        loose = self._run(Dop853(rtol=looser))
        while True:
            tight = self._run(Dop853(rtol=rtol))
            away = apart(tight, loose) / scale(tight) * min(1.0, MARGIN * error_left(loose, tight))
            self._looser = looser, loose
            self.reachable = float(away.max())
            self.until = self._within(away)
            if self.reachable <= self.tolerance * _DOUBT or rtol <= 1e-13:
                return tight
            loose, looser, rtol = tight, rtol, two_digits(max(rtol / _LOOSER, 1e-13))

    def _within(self, away: Array) -> float | None:
        """Return a time, s, before a run is farther away (k,) than the tolerance; None if never."""
        lost = np.flatnonzero(~(away <= self.tolerance))
        return sooner(float(self._times[lost[0] - 1])) if len(lost) and lost[0] > 1 else None

    def _error(self, method: Method, time_step: float | None) -> tuple[float, Run | None]:
        try:
            run = self._counted(companion, method, time_step)
        except RefusedError as refused:
            if isinstance(refused.__cause__, WorkLimitError):
                self._left -= self._work_limit
            return math.inf, None
        error = float(apart(run, self._exact).max()) / self.scale
        return (error if math.isfinite(error) else math.inf), run

    def _run(self, method: Method) -> Run:
        return self._counted(solve, method, None)

    def _counted(self, solver: Callable[..., Run], method: Method, time_step: float | None) -> Run:
        run = solver(
            self._scene,
            duration=self._duration,
            method=method,
            time_step=time_step,
            times=self._times,
            work_limit=max(min(self._work_limit, self._left), 1),
        )
        if run.cost is not None:
            self.spent += run.cost.force_evaluations
            self._left -= run.cost.steps + run.cost.impacts
        return run
