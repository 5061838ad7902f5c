"""The friction of all pairs at one instant."""

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
