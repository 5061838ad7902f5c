"""How long lasting contacts last: until a push would have to pull, or what touches changes.

Serves: the located way. Hides: what is watched, and how its root is found.
"""

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from tamias2d.contact.core import Core, place
from tamias2d.contact.gap import resolution
from tamias2d.contact.manifold import Contact, manifold
from tamias2d.contact.path import Piece
from tamias2d.contact.refusal import Refusal
from tamias2d.contact.rest import Island
from tamias2d.state import Acceleration, Hold, State

_SAMPLES = 32  # of a path, between which a contact may not open and close again unseen


class Watch:
    """The lasting contacts of one body on its supports, along its path."""

    def __init__(
        self,
        cores: Sequence[Core],
        body: int,
        contacts: Sequence[Contact],
        supports: Mapping[int, State],
        free: Callable[[float], Acceleration],
    ) -> None:
        self._cores = cores
        self._body = body
        self._contacts = contacts
        self._supports = supports
        self._free = free

    def ends(self, path: Piece, hold: Hold) -> float | None:
        """Return the first time in s at which the contacts do not go on as they are, or None."""
        core = self._cores[self._body]
        endless = all(self._cores[i].endless for i in self._supports)
        if not hold.bends and core.steady and endless:
            return None
        before = path.start
        for time in np.linspace(path.start, path.end, _SAMPLES + 1)[1:].tolist():
            if not self._lasts(path, time, hold):
                return self._between(path, before, time, hold)
            before = time
        return None

    def _between(self, path: Piece, low: float, high: float, hold: Hold) -> float:
        while low < (middle := (low + high) / 2) < high:
            if self._lasts(path, middle, hold):
                low = middle
            else:
                high = middle
        return high

    def _lasts(self, path: Piece, time: float, hold: Hold) -> bool:
        states = {**self._supports, self._body: path.at(time)}
        placed = {i: place(self._cores[i], state) for i, state in states.items()}
        pairs = dict.fromkeys((c.a, c.b) for c in self._contacts)
        now: list[Contact] = []
        for a, b in pairs:
            kept = [c for c in self._contacts if (c.a, c.b) == (a, b)]
            tolerance = resolution(placed[a], placed[b], time)
            try:
                now += manifold(placed[a], placed[b], tolerance, time, kept)
            except Refusal:
                return False
        if [_what(c) for c in now] != [_what(c) for c in self._contacts]:
            return False
        island = Island(self._cores, placed, now, {self._body: self._free(time)})
        same = len(island.lasting) == len(now)
        return same and island.holds(states, time)[self._body].bends == hold.bends


def _what(contact: Contact) -> object:
    axis = contact.axis
    return contact.a, contact.b, axis.swapped, axis.side, contact.gap.index
