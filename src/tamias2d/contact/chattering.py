"""Events that follow one another without time getting on (chattering)."""

from collections import Counter
from collections.abc import Iterable, Sequence

from tamias2d.contact.core import Core
from tamias2d.contact.refusal import UndecidedContactError, named
from tamias2d.contact.touching import PairOf
from tamias2d.float64 import EPSILON

_MAX_REPEATS = 32  # new paths for a body within a few units of the last place of time


class Chattering:
    """Counts events of bodies at one instant, and refuses too many."""

    def __init__(self, cores: Sequence[Core]) -> None:
        self._cores = cores
        self.stalled = [0 for _ in cores]
        """New paths of each body, in a row, that did not advance in time."""
        self._repeats: tuple[float, Counter[PairOf]] = (0.0, Counter())

    def count_path(self, body: int, before: float, start: float) -> None:
        """Refuse a body whose new paths, from one start to the next, s, no longer advance."""
        stalled = before >= start * (1 - 4 * EPSILON)
        self.stalled[body] = self.stalled[body] + 1 if stalled else 0
        if self.stalled[body] > _MAX_REPEATS:
            raise UndecidedContactError(
                f"'{self._cores[body].name}' at {start!r} s: float64 cannot tell whether its "
                "contacts last or open (R7). End the run before, or change the scene a little.",
                time=start,
            )

    def forget(self, bodies: Iterable[int]) -> None:
        """Forget what was counted of bodies: somebody else counts how often they are asked."""
        for body in bodies:
            self.stalled[body] = 0
        self._repeats = (self._repeats[0], Counter())

    def count_event(self, time: float, i: int, j: int) -> None:
        """Refuse a pair that comes into contact again and again at one instant."""
        if time > self._repeats[0]:
            self._repeats = (time, Counter())
        self._repeats[1][i, j] += 1
        if self._repeats[1][i, j] > _MAX_REPEATS:
            raise UndecidedContactError(
                f"{named(*(self._cores[k].name for k in dict.fromkeys((i, j))))} at {time!r} s: "
                "they meet again and again without getting on (R7). End the run before, or change "
                "the scene a little.",
                time=time,
            )

    def is_again(self, time: float, bodies: Iterable[int]) -> bool:
        """Whether bodies come into contact at an instant so often that they seem not to get on."""
        met = max(self._repeats[1].values(), default=0) if self._repeats[0] == time else 0
        return max(met, *(self.stalled[body] for body in bodies)) > _MAX_REPEATS // 2
