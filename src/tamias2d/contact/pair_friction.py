"""The friction of all pairs at one instant."""

import math
from collections.abc import Callable, Collection, Mapping, Sequence
from typing import NamedTuple

from tamias2d.contact.core import Placed
from tamias2d.contact.manifold import LASTING_NOISE, Contact, speed_scale, tangential_velocity
from tamias2d.contact.modes import Patch
from tamias2d.contact.touching import PairOf
from tamias2d.float64 import EPSILON
from tamias2d.state import Acceleration, State


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

    def unseen_speed(self, free: Mapping[int, Acceleration]) -> float:
        """Return what rounding of time leaves of speeds, m/s, under accelerations by loads."""
        pull = max(abs(x) + abs(y) for x, y, _ in free.values())
        return 64 * EPSILON * self.time * pull

    def patches(
        self,
        contacts: Sequence[Contact],
        placed: Mapping[int, Placed],
        free: Mapping[int, Acceleration],
    ) -> list[Patch]:
        """Return the contacts of each pair, and how they slide."""
        unseen, found = self.unseen_speed(free), []
        for a, b in dict.fromkeys((contact.a, contact.b) for contact in contacts):
            own = tuple(contact for contact in contacts if (contact.a, contact.b) == (a, b))
            speed = tangential_velocity(own[0], placed[a].state, placed[b].state)
            coefficient = self.of(a, b)
            slides = coefficient > 0 and abs(speed) > self.unseen(own[0]) + unseen
            found.append(Patch(own, coefficient, int(math.copysign(1, speed)) if slides else 0))
        return found


class LastingFriction(NamedTuple):
    """The friction of pairs in lasting contact, while they slide as they did."""

    of: Callable[[int, int], float]
    """The coefficient of friction of a pair."""
    senses: Mapping[PairOf, int]
    """Of pairs with friction: 0 if they stick, else the sense in which they slide."""

    def at(self, time: float, states: Mapping[int, State]) -> PairFriction:
        """Return the friction of all pairs at a time in s."""
        return PairFriction(time, self.of, lambda contact: self._noise(contact, states))

    def of_contacts(self, contacts: Sequence[Contact]) -> dict[PairOf, int]:
        """Return the senses of the pairs of some contacts."""
        pairs = dict.fromkeys((contact.a, contact.b) for contact in contacts)
        return {pair: self.senses[pair] for pair in pairs if pair in self.senses}

    def _noise(self, contact: Contact, states: Mapping[int, State]) -> float:
        sticks = self.senses.get((contact.a, contact.b)) == 0
        speed = speed_scale(contact, states[contact.a], states[contact.b])
        return speed * (LASTING_NOISE if sticks else 64 * EPSILON)
