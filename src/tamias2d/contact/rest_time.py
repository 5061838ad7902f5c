"""The time at which ever shorter bounces end (the Zeno time).

Every bounce gives an estimate of the end, as that of a geometric series. Early estimates suffer
from loads that vary, late ones from rounding, since low bounces are short. The best one has the
least sum of rounding and change from the estimate before.
"""

from dataclasses import dataclass

from tamias2d.contact.instant import Instant, PairOf


@dataclass
class _RestTime:
    last: float
    best: float
    doubt: float


class RestTimes:
    """The estimates of all pairs that bounce."""

    def __init__(self) -> None:
        self._of: dict[PairOf, _RestTime] = {}

    def update(self, instant: Instant) -> None:
        """Take the estimates of an instant, and forget the pairs that it has disturbed."""
        for pair in [pair for pair in self._of if set(pair) & instant.changed]:
            if pair not in instant.touching_pairs:
                del self._of[pair]
        for pair, touch in instant.touching_pairs.items():
            if not touch.rest_at:
                continue
            known = self._of.get(pair)
            if known is None:
                self._of[pair] = _RestTime(touch.rest_at, touch.rest_at, float("inf"))
                continue
            doubt = abs(touch.rest_at - known.last) + touch.rest_noise
            if doubt <= known.doubt:
                known.best, known.doubt = touch.rest_at, doubt
            known.last = touch.rest_at

    def time_of(self, pair: PairOf, time: float) -> float:
        """Return when a pair comes to rest, s, which is not before now."""
        known = self._of.pop(pair, None)
        return max(known.best, time) if known else time
