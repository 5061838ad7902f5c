"""The cheapest steps and substeps whose run is near enough to an answer that is known.

They are tried from cheap to dear, each whole. What its longer steps say is hopeless is passed over,
but tried before only the steps are left that the answer itself comes from.
"""

import math
from collections.abc import Iterator
from dataclasses import replace

from tamias2d.motion import Stepped
from tamias2d.scene import Scene
from tamias2d.simulator.stepper import SAME_STEP
from tamias2d.study.companion import RefusedError
from tamias2d.study.pilot import Estimate
from tamias2d.study.refined import Refined, stepped, work_of

_SUBSTEPS = (1, 2, 4, 8, 16)
_FALLS = 8.0  # times, at most, halving a step usually makes an error smaller


class Pilots:
    """Runs that are tried for a tolerance, which the answer meets with steps of its own."""

    def __init__(self, refined: Refined, duration: float, tolerance: float, first: float) -> None:
        self._refined, self._duration, self._tolerance = refined, duration, tolerance
        self._first = first
        """The step, s, that samples are ends of, as of all shorter ones"""
        self._failed: dict[int, Estimate] = {}
        """The last of each number of substeps"""
        self.spent = 0
        """Steps"""

    def cheapest(self) -> tuple[Estimate, ...]:
        """Return the estimate that meets the tolerance, and then the last of those that failed."""
        for step, substeps in self._promising():
            estimate = self._tried(step, substeps)
            if estimate.error <= self._tolerance:
                self._failed.pop(substeps, None)
                return (estimate, *self._lost())
            self._failed[substeps] = estimate
        return (self._answer(), *self._lost())

    def _promising(self) -> Iterator[tuple[float, int]]:
        """Yield steps, s, and substeps: those that probably fail at the end.

        Errors of steps longer than the first tell nothing of others: these have samples within
        steps, where an impact may be.
        """
        passed_over: list[tuple[float, int]] = []
        coarsest, finest = 2 * self._first, 2 * self._refined.time_step
        for step, substeps in ladder(self._refined.scene, self._duration, coarsest, finest):
            last = self._failed.get(substeps)
            if last is not None and self._fails(last, step):
                passed_over.append((step, substeps))
            else:
                yield step, substeps
        yield from passed_over

    def _fails(self, longer: Estimate, step: float) -> bool:
        """Whether an error of longer steps says that a step, s, is too long."""
        before = longer.time_step or math.inf
        halvings = round(math.log2(before / step))
        tells = before <= self._first * (1 + SAME_STEP)
        return tells and longer.error / _FALLS**halvings > self._tolerance

    def _tried(self, step: float, substeps: int) -> Estimate:
        steps = math.ceil(self._duration / step)
        self.spent += steps
        method, refined = Stepped(substeps), self._refined
        try:
            history = stepped(refined.scene, self._duration, refined.times, step, substeps)
        except RefusedError as fault:
            return Estimate(method, step, math.inf, math.inf, None, f"refused: {fault}")
        error = refined.bound(history) / float(refined.length[-1])
        return Estimate(method, step, steps, error, None, "the cheapest")

    def _answer(self) -> Estimate:
        """Return the run that others are compared with."""
        known = self._refined
        steps = math.ceil(self._duration / known.time_step)
        method = Stepped(known.substeps)
        return Estimate(method, known.time_step, steps, known.share, None, "the cheapest")

    def _lost(self) -> Iterator[Estimate]:
        """Yield estimates that fail, with the reason."""
        for one in self._failed.values():
            why = one.why
            if math.isfinite(one.error):
                why = "needs shorter steps, which cost more than the cheapest"
            yield replace(one, force_evaluations=math.inf, why=why)


def ladder(
    scene: Scene, duration: float, coarsest: float, finest: float
) -> Iterator[tuple[float, int]]:
    """Yield steps, s, and substeps from cheap to dear."""
    steps = [coarsest]
    while steps[-1] / 2 >= finest * (1 - 1e-9):
        steps.append(steps[-1] / 2)
    pairs = [(step, substeps) for step in steps for substeps in _SUBSTEPS]
    yield from sorted(pairs, key=lambda pair: work_of(scene, duration, *pair))
