"""A pair that touches at an instant, and the impulses of the instant."""

from dataclasses import dataclass, field
from typing import NamedTuple

from tamias2d.contact.manifold import Contact

PairOf = tuple[int, int]


class ContactImpulse(NamedTuple):
    """One impulse at a contact."""

    contact: Contact
    impulse: float
    """Along the normal, N s."""
    normal_velocity: float
    """Before it, m/s."""


@dataclass
class TouchingPair:
    """A touching pair."""

    pair: PairOf
    contacts: list[Contact]
    tolerance: float
    """The largest gap that counts as 0, m."""
    speed: float
    """The size of the terms that make up its velocities, m/s."""
    noise: float
    """The largest normal velocity that counts as 0, m/s."""
    rounding: float
    """Of the speed: what rounding leaves of a velocity that is none."""
    striking: list[Contact] = field(init=False)
    """Those of its contacts, and of its neighbours in a chain, that take part in impacts."""
    staying: list[Contact] = field(default_factory=list)
    rest_at: float = 0.0
    """When its bounces end if they go on as a geometric series of times, s; 0 if they do not."""
    rest_noise: float = 0.0
    """The error of `rest_at` by rounding, s."""

    def __post_init__(self) -> None:
        self.striking = self.contacts
