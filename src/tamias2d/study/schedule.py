"""In which order the candidates of a study are run: the cheapest next, as far as the time goes.

So every method has a point before any has its dearest one, and who stops a study has seen them all.
A candidate with twice the steps takes twice the time of the one before; where that one failed, it
takes at least what steps took elsewhere.
"""

import math
from collections import deque
from collections.abc import Iterator, Sequence
from typing import Protocol

DEAREST = 10.0
"""s of the processor: what all runs of a point may take, by what one of half the cost took."""
LONGEST = 60.0
"""s of the processor: what all points may take together"""


class Rung(Protocol):
    """A method with a setting, on a ladder of settings of twice the steps each."""

    @property
    def name(self) -> str:
        """Of the ladder."""

    @property
    def steps(self) -> int | None:
        """How many are asked for; None where the method chooses them."""

    @property
    def peer(self) -> bool:
        """Whether it is another engine."""


class Schedule:
    """Gives the candidates one by one, and hears what each one took."""

    def __init__(self, tried: Sequence[Rung]) -> None:
        self._left: dict[str, deque[int]] = {}
        for place, candidate in enumerate(tried):
            self._left.setdefault(candidate.name, deque()).append(place)
        self._tried = tried
        self._coming = dict.fromkeys(self._left, 0.0)
        self._failed: set[str] = set()  # methods whose last setting failed
        self._begun: set[str] = set()  # methods that have had a setting run
        self._first = math.inf  # s: the least that the first setting of a method took
        self._spent = 0.0
        self._of_a_step = math.inf  # s: the least that a step of a candidate took

    def __iter__(self) -> Iterator[tuple[int, str | None]]:
        """Yield places of candidates, and why one is not run, if it is not."""
        while waiting := [name for name, left in self._left.items() if left]:
            name = min(waiting, key=self._seconds)
            seconds = self._seconds(name)
            place = self._left[name].popleft()
            refused = self._refused(place, seconds)
            if refused is not None:
                self._coming[name] = 2 * seconds
                if name not in self._begun:
                    self._left[name].clear()
            yield place, refused

    def took(self, place: int, seconds: float, *, failed: bool) -> None:
        """Note what a candidate took, s of the processor."""
        candidate = self._tried[place]
        self._spent += seconds
        if candidate.name not in self._begun and not candidate.peer:
            self._first = min(self._first, seconds)
        self._begun.add(candidate.name)
        self._coming[candidate.name] = 2 * seconds
        if failed:
            self._failed.add(candidate.name)
            return
        self._failed.discard(candidate.name)
        if candidate.steps and not candidate.peer:
            self._of_a_step = min(self._of_a_step, seconds / candidate.steps)

    def leave(self, place: int) -> None:
        """Leave out the finer settings of a candidate's method."""
        self._left[self._tried[place].name].clear()

    def _seconds(self, name: str) -> float:
        """Return what the next candidate of a method will take at least, s."""
        candidate = self._tried[self._left[name][0]]
        known = name in self._failed and self._of_a_step < math.inf and not candidate.peer
        of_steps = (candidate.steps or 0) * self._of_a_step if known else 0.0
        return max(self._coming[name], of_steps)

    def _refused(self, place: int, seconds: float) -> str | None:
        candidate = self._tried[place]
        if candidate.name not in self._begun:  # each method has a point, if it does not take long
            dear = not candidate.peer and DEAREST < self._first < math.inf
            why = f"the first points of other methods took {self._first:.2g} s, and one may take"
            return f"not run: {why} {DEAREST:g} s" if dear else None
        takes = f"not run: it would take about {seconds:.2g} s"
        if seconds > DEAREST:
            return f"{takes}, and a point at most {DEAREST:g} s"
        if self._spent + seconds > LONGEST:
            return f"{takes} after {self._spent:.2g} s for others, and all at most {LONGEST:g} s"
        return None
