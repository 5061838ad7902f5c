"""When a lasting contact comes to its end, where loads vary: its push vanishes, or a body tips.

Serves: the located way. Hides: where along a path a contact is looked at.
"""

from collections.abc import Callable, Sequence

from tamias2d.contact.core import Core, place
from tamias2d.contact.manifold import Contact, manifold
from tamias2d.contact.rest import Island
from tamias2d.state import Acceleration, State

_LOOKS = 8
"""How often one path of a held body is looked at: a push that vanishes for less is not seen."""


class Support:
    """A body on what holds it, under loads that vary, along the path on which it is held."""

    def __init__(
        self,
        cores: Sequence[Core],
        body: int,
        contacts: Sequence[Contact],
        state: Callable[[int, float], State],
        free: Callable[[int, float], Acceleration],
    ) -> None:
        self._cores = cores
        self._body = body
        self._contacts = contacts
        self._state = state
        self._free = free

    def ends(self, start: float, end: float, *, decided: bool) -> float | None:
        """Return the first time in s, up to float64, at which not all contacts last, if any.

        What was decided at `start` is not asked again there: it could only differ by rounding.
        """
        early = start if self._lasts(start) else None
        if early is None and not decided:
            return start
        for k in range(1, _LOOKS + 1):
            late = start + (end - start) * k / _LOOKS
            if not self._lasts(late):
                return late if early is None else self._between(early, late)
            early = late
        return None

    def _between(self, early: float, late: float) -> float:
        while early < (middle := (early + late) / 2) < late:
            if self._lasts(middle):
                early = middle
            else:
                late = middle
        return late

    def _lasts(self, time: float) -> bool:
        pairs = {(contact.a, contact.b) for contact in self._contacts}
        states = {i: self._state(i, time) for pair in pairs for i in pair}
        placed = {i: place(self._cores[i], state) for i, state in states.items()}
        contacts = []
        for a, b in sorted(pairs):
            tolerance = 1e-9 * min(placed[a].core.size, placed[b].core.size)
            contacts += manifold(placed[a], placed[b], tolerance, time)
        free = {self._body: self._free(self._body, time)}
        island = Island(self._cores, placed, contacts, free)
        return len(island.lasting) == len(self._contacts) and not island.moves_on(states)
