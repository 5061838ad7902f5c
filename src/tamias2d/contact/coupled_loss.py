"""When contacts of several moving bodies change: they open, slide, stick or get elsewhere."""

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from tamias2d.contact.core import Core, place
from tamias2d.contact.coupled_constraint import CoupledConstraint
from tamias2d.contact.frictional_rest import island_of
from tamias2d.contact.gap import resolution
from tamias2d.contact.manifold import Contact, manifold, refreshed
from tamias2d.contact.pair_friction import LastingFriction
from tamias2d.contact.refusal import Refusal
from tamias2d.path import PathPiece
from tamias2d.state import Acceleration, Array, State

_SAMPLES = 8  # of a step, between which nothing changes and changes back unseen


class CoupledLossWatch:
    """The lasting contacts of several bodies, along the paths of one step."""

    def __init__(
        self,
        cores: Sequence[Core],
        constraint: CoupledConstraint,
        contacts: Sequence[Contact],
        paths: Mapping[int, PathPiece],
        free: Callable[[int, float], Acceleration],
        slight: float,
        friction: LastingFriction,
    ) -> None:
        """Take the paths of all bodies in contact, and the accelerations by loads alone.

        An opening by less than `slight`, m/s^2, is not seen.
        """
        self._cores = cores
        self._constraint = constraint
        self._contacts = contacts
        self._paths = paths
        self._free = free
        self._slight = slight
        self._friction = friction
        self._slack: list[float] = []

    def first_loss(self) -> float | None:
        """Return the first time in s at which the contacts change, or None."""
        path = self._paths[self._constraint.bodies[0]]
        before = path.start
        states = [self._paths[i].at(before) for i in self._constraint.bodies]
        self._slack = self._constraint.against(states, self._loads(before), path.end - before)
        for time in np.linspace(path.start, path.end, _SAMPLES + 1)[1:].tolist():
            first: float = time
            lost = False
            for lasts in (self._slides_on, self._holds, self._same_features):  # cheap ones first
                if not lasts(first):
                    first, lost = _bisect(lasts, before, first), True
            if lost:
                return first
            before = time
        return None

    def _slides_on(self, time: float) -> bool:
        """Return whether what slides does so in its sense."""
        return self._constraint.slides_on(self._own(time), self._slack)

    def _holds(self, time: float) -> bool:
        """Return whether forces obey Coulomb's law, but for an opening that is not seen."""
        return self._constraint.holds(time, self._loads(time), self._own(time)) or self._stays(time)

    def _stays(self, time: float) -> bool:
        """Return whether an instant would decide that all goes on as it does.

        Else the contacts that it keeps would be lost again, as soon as time gets on.
        """
        states = {i: path.at(time) for i, path in self._paths.items()}
        placed = {i: place(self._cores[i], state) for i, state in states.items()}
        now = [refreshed(c, placed[c.a], placed[c.b]) for c in self._contacts]
        free = {i: self._free(i, time) for i in self._constraint.bodies}
        friction = self._friction.at(time, states)
        try:
            mobility = self._constraint.mobility.at(time, states.__getitem__)
            island = island_of(self._cores, placed, now, free, self._slight, friction, mobility)
        except Refusal:
            return False
        same = island.senses == self._friction.of_contacts(now)
        return same and len(island.lasting) == len(now)

    def _own(self, time: float) -> list[State]:
        return [self._paths[i].at(time) for i in self._constraint.bodies]

    def _loads(self, time: float) -> Array:
        return np.array([self._free(i, time) for i in self._constraint.bodies])

    def _same_features(self, time: float) -> bool:
        """Return whether each pair touches with the corners and sides that it did.

        What else touches is found as an impact.
        """
        placed = {i: place(self._cores[i], path.at(time)) for i, path in self._paths.items()}
        for i, j in dict.fromkeys((contact.a, contact.b) for contact in self._contacts):
            own = [contact for contact in self._contacts if (contact.a, contact.b) == (i, j)]
            a, b = placed[i], placed[j]
            try:
                now = manifold(a, b, resolution(a, b, time), time, own)
            except Refusal:
                return False
            found = [_features(contact) for contact in now]
            if not all(_features(contact) in found for contact in own):
                return False
        return True


def _bisect(lasts: Callable[[float], bool], low: float, high: float) -> float:
    """Return the first time in s at which something does not last any more."""
    while low < (middle := (low + high) / 2) < high:
        if lasts(middle):
            low = middle
        else:
            high = middle
    return high


def _features(contact: Contact) -> object:
    return contact.axis[:2], contact.gap.which
