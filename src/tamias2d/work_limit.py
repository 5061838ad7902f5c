"""The limit of a run's work: the steps that an adaptive method chooses, and the impacts (R4).

Steps of a length that the user gave are not counted: their number is known before the run. Impacts
are meetings, one for each pair and instant, however many rounds an instant takes (DD67).
"""

import math

import numpy as np
from numpy.typing import NDArray

from tamias2d.errors import SimulationError

WORK_LIMIT = 100_000
"""Steps and impacts of a run, together, where nothing else is asked; a step takes about 1 ms."""

SAMPLE = 1000
"""Steps, or impacts, from which the rest of a run is estimated."""


class WorkLimitError(SimulationError):
    """A run takes more steps and impacts than its limit; `run` is the history up to there."""

    code = "work-limit"

    def __init__(self, message: str, *, time: float) -> None:
        super().__init__(message)
        self.time = time


class Work:
    """The steps and impacts of one run, which end it by an error where they have no end.

    The rest of the steps is estimated from the last thousand without an impact, so that steps
    that shrink towards a singularity are found. The rest of the impacts is estimated from all of
    them, for bounces that come to rest get ever shorter. Since the pace may change, an estimate
    ends a run only if it is sqrt(limit / done) times the limit: ten times after 1000 of 100 000.
    """

    def __init__(self, duration: float, limit: int = WORK_LIMIT) -> None:
        """Take the duration of the run, s; of 0, nothing is estimated."""
        self._duration = duration
        self._limit = limit
        self._steps = 0
        self._impacts = 0
        self._sampled = 0  # steps since `_start`, when the last impact was or the sample began, s
        self._start = 0.0

    def step(self, time: float) -> None:
        """Count a step of an adaptive method to a time in s.

        Raises:
            WorkLimitError: the steps and impacts are too many, or will be.
        """
        self._steps += 1
        self._sampled += 1
        coming = 0.0
        if self._sampled == SAMPLE:
            covered, left = time - self._start, self._duration - time
            coming = left / covered * SAMPLE if covered > 0 else 0.0
            self._sampled, self._start = 0, time
        self._check(time, coming, "steps", "a method of fixed steps")

    def impacts(self, count: int, time: float) -> None:
        """Count the impacts at a time in s.

        Raises:
            WorkLimitError: the steps and impacts are too many, or will be.
        """
        self._impacts += count
        self._sampled, self._start = 0, time
        coming = 0.0
        if self._impacts >= SAMPLE:
            left = self._duration - time
            coming = left / time * self._impacts if time > 0 else math.inf
        self._check(time, coming, "impacts", "method=Stepped()")

    def fitting(self, times: NDArray[np.float64]) -> int:
        """Count impacts at sorted times, s, up to the first that is too much; return how many."""
        counts = self._impacts + np.arange(1, len(times) + 1)
        done = self._steps + counts
        with np.errstate(all="ignore"):
            left = (self._duration - times) / times * counts
        coming = np.where(counts >= SAMPLE, np.where(times > 0, left, math.inf), 0.0)
        good = (done <= self._limit) & (coming <= self._limit * np.sqrt(self._limit / done))
        found = len(times) if good.all() else int(np.argmin(good))
        if found:
            self._impacts += found
            self._sampled, self._start = 0, float(times[found - 1])
        return found

    def _check(self, time: float, coming: float, what: str, other: str) -> None:
        done = self._steps + self._impacts
        if done <= self._limit and coming <= self._limit * math.sqrt(self._limit / done):
            return
        found = f"{self._steps} steps and {self._impacts} impacts"
        if coming:
            found += f", and about {coming:.3g} {what} to come"
        raise WorkLimitError(
            f"run at {time!r} s: found {found}: must be at most {self._limit} (R4). End the run "
            f"before, look for a load that changes too fast, use {other}, or give a larger "
            "work_limit.",
            time=time,
        )
