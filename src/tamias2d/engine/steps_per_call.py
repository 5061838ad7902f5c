"""How many steps one call of compiled code takes: so few that Python sees signals in between."""

from time import perf_counter

_LONGEST = 0.05  # s


class StepsPerCall:
    """The number of steps for a call; where only one step is wanted, nothing is timed."""

    def __init__(self) -> None:
        self.most = 1
        self._start = 0.0

    def begin(self) -> None:
        """Note that a call begins."""
        self._start = perf_counter()

    def end(self, steps: int) -> None:
        """Note that a call has ended, and how many steps it took, however many were asked for."""
        spent = perf_counter() - self._start
        if spent > _LONGEST:
            self.most = max(steps // 2, 1)
        elif steps == self.most and spent < _LONGEST / 2:
            self.most *= 2
