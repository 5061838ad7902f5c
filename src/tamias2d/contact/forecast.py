"""When bounces that get ever shorter come to their end (the Zeno time).

Serves: contacts that come to rest. Hides: which forecast is trusted.

Every bounce forecasts the end, as that of a geometric series. Early forecasts suffer from what is
not constant, late ones from rounding, since low bounces are short. The best one is where the change
from one to the next and the rounding are least.
"""

from dataclasses import dataclass

from tamias2d.contact.instant import Instant, PairOf


@dataclass
class _Forecast:
    last: float
    best: float
    doubt: float


class Forecasts:
    """The forecasts of all pairs that bounce."""

    def __init__(self) -> None:
        self._of: dict[PairOf, _Forecast] = {}

    def hear(self, instant: Instant) -> None:
        """Take the forecasts of an instant, and forget those that it has spoilt."""
        for pair in [pair for pair in self._of if set(pair) & instant.changed]:
            if pair not in instant.touches:
                del self._of[pair]
        for pair, touch in instant.touches.items():
            if not touch.rest_at:
                continue
            known = self._of.get(pair)
            if known is None:
                self._of[pair] = _Forecast(touch.rest_at, touch.rest_at, float("inf"))
                continue
            doubt = abs(touch.rest_at - known.last) + touch.rest_noise
            if doubt <= known.doubt:
                known.best, known.doubt = touch.rest_at, doubt
            known.last = touch.rest_at

    def rest_of(self, pair: PairOf, time: float) -> float:
        """Return when a pair comes to rest, s, which is not before now."""
        known = self._of.pop(pair, None)
        return max(known.best, time) if known else time
