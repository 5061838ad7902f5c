"""What an instant reads of the simulation."""

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from typing import NamedTuple

from tamias2d.contact.core import Core
from tamias2d.contact.jointed_impact import Struck
from tamias2d.contact.manifold import Contact
from tamias2d.contact.mobility import Mobility
from tamias2d.contact.touching import PairOf
from tamias2d.state import Acceleration, State, Vector


class InstantInputs(NamedTuple):
    """The state of the simulation that an instant reads."""

    cores: Sequence[Core]
    state: Callable[[int], State]
    """Of a body, now."""
    overlapping: Callable[[int], Iterable[int]]
    """The bodies whose bounding boxes overlap with that of a body."""
    free: Callable[[int, Callable[[int], State]], Acceleration]
    """The acceleration of an unconstrained body, now, for given states."""
    struck: Struck
    """What impulses on jointed bodies change, now; limits answer those that press them."""
    mobility: Mobility
    """What impulses on any bodies change, now."""
    lasting_mobility: Mobility
    """What forces on any bodies change, now; joints answer as they do between instants."""
    lasting: Mapping[PairOf, Sequence[Contact]]
    """The contacts that have lasted until now."""
    sticking: Collection[PairOf]
    """The pairs of these that stick."""
    separating_direction: Callable[[PairOf], Vector | None]
    """The direction in which a pair was last apart, if that is known."""
    restitution: Callable[[int, int], float]
    friction: Callable[[int, int], float]
    until: float
    """When the run ends, s."""
    again: bool
    """Whether its bodies come into contact again and again at this instant."""
