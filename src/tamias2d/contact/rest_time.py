"""The time at which ever shorter bounces end (the Zeno time).

Every bounce gives an estimate of the end, as that of a geometric series. Early estimates suffer
from loads that vary, late ones from rounding, since low bounces are short. The best one has the
least sum of rounding and change from the estimate before.
"""

from math import inf
from typing import NamedTuple

from tamias2d.contact.instant import Instant
from tamias2d.contact.touching import PairOf


class Estimate(NamedTuple):
    """When the bounces of a pair end: the last and the best estimate, and its doubt, s."""

    last: float
    best: float
    doubt: float


NONE = Estimate(0.0, 0.0, -1.0)


def better_estimate(
    last: float, best: float, doubt: float, found: float, noise: float
) -> tuple[float, float, float]:
    """Return the last and the best estimate and its doubt after a new one, s.

    `noise` is the error of the new one by rounding; a doubt below 0 says that it is the first.
    """
    if doubt < 0.0:
        return found, found, inf
    change = abs(found - last) + noise
    if change <= doubt:
        return found, found, change
    return found, best, doubt


class RestTimes:
    """The estimates of all pairs that bounce."""

    def __init__(self) -> None:
        self.of: dict[PairOf, Estimate] = {}

    def update(self, instant: Instant) -> None:
        """Take the estimates of an instant, and forget the pairs that it has disturbed."""
        for pair in [pair for pair in self.of if set(pair) & instant.changed]:
            if pair not in instant.touching_pairs:
                del self.of[pair]
        for pair, touch in instant.touching_pairs.items():
            if not touch.rest_at:
                continue
            known = self.of.get(pair, NONE)
            self.of[pair] = Estimate(*better_estimate(*known, touch.rest_at, touch.rest_noise))

    def time_of(self, pair: PairOf, instant: Instant) -> float:
        """Return when a pair comes to rest that stays from an instant on, s; not before that.

        It is the best estimate, if the last bounce agrees: those of a body that comes down on one
        corner after another are no geometric series. One that ends after the run is none, either:
        what presses so little has no time to do it.
        """
        known, touch = self.of.pop(pair, None), instant.touching_pairs[pair]
        if known is None or not touch.rest_at:
            return instant.time
        seen = max(touch.rest_noise, touch.rest_at - instant.time)
        best = known.best if abs(known.best - touch.rest_at) <= seen else touch.rest_at
        return max(best, instant.time) if best <= instant.until else instant.time
