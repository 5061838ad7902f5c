"""The friction of all pairs at one instant."""

import math
from collections.abc import Callable, Collection
from typing import NamedTuple

from tamias2d.contact.manifold import Contact
from tamias2d.contact.touching import PairOf


class PairFriction(NamedTuple):
    """The friction of all pairs at one instant."""

    time: float
    of: Callable[[int, int], float]
    """The coefficient of friction of a pair."""
    noise: Callable[[Contact], float]
    """What counts as no tangential velocity, m/s."""
    stopped: Collection[PairOf] = ()
    """The pairs of which an impulse has just ended the sliding."""

    def unseen(self, contact: Contact) -> float:
        """Return what counts as no sliding, m/s: where an impulse has just ended it, anything."""
        return math.inf if (contact.a, contact.b) in self.stopped else self.noise(contact)
