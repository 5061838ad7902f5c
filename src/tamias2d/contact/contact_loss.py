"""When a lasting contact ends: its normal force vanishes, its features change, or sliding stops."""

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from tamias2d.contact.core import Core, Placed, place
from tamias2d.contact.friction_constraint import FrictionConstraint, TurningFrictionConstraint
from tamias2d.contact.frictional_rest import island_of, slides_on
from tamias2d.contact.gap import axes, resolution
from tamias2d.contact.manifold import Contact, manifold, refreshed
from tamias2d.contact.mobility import Mobility
from tamias2d.contact.pair_friction import LastingFriction
from tamias2d.contact.refusal import Refusal
from tamias2d.contact.rolling_island import RollingConstraint
from tamias2d.path import PathPiece
from tamias2d.state import Acceleration, Constraint, State

_SLACK = 1e-9  # of the size: by how much an axis of a lasting contact may seem second to another
_SAMPLES = 32  # of a path, between which a contact may not open and close again unseen


class ContactLossWatch:
    """The lasting contacts of one body on its supports, along its path."""

    def __init__(
        self,
        cores: Sequence[Core],
        body: int,
        contacts: Sequence[Contact],
        supports: Mapping[int, State],
        free: Callable[[float], Acceleration],
        slight: float,
        friction: LastingFriction,
        mobility: Mobility,
    ) -> None:
        """Take, among others, the friction of pairs, and an opening that is not seen."""
        self._mobility = mobility
        self._cores = cores
        self._body = body
        self._contacts = contacts
        self._supports = supports
        self._free = free
        self._slight = slight
        self._friction = friction

    def first_loss(self, path: PathPiece, constraint: Constraint) -> float | None:
        """Return the first time in s at which the contacts change, or None."""
        core = self._cores[self._body]
        endless = all(self._cores[i].endless for i in self._supports)
        if not constraint.state_dependent and core.steady and endless:
            if isinstance(constraint, RollingConstraint):
                return constraint.sliding_end(path)
            return (
                self._sliding_end(path, constraint)
                if isinstance(constraint, FrictionConstraint)
                else None
            )
        before = path.start
        for time in np.linspace(path.start, path.end, _SAMPLES + 1)[1:].tolist():
            if not self._lasts(path, time, constraint):
                return self._bisect(path, before, time, constraint)
            before = time
        return None

    def _sliding_end(self, path: PathPiece, constraint: FrictionConstraint) -> float | None:
        """Return when sliding under constant loads ends, s; its velocity is linear in time."""
        if not constraint.sliding or constraint.keeps_sliding(path.at(path.end)):
            return None
        low, high = path.start, path.end
        while low < (middle := (low + high) / 2) < high:
            low, high = (
                (middle, high) if constraint.keeps_sliding(path.at(middle)) else (low, middle)
            )
        return high

    def _bisect(self, path: PathPiece, low: float, high: float, constraint: Constraint) -> float:
        while low < (middle := (low + high) / 2) < high:
            if self._lasts(path, middle, constraint):
                low = middle
            else:
                high = middle
        return high

    def _lasts(self, path: PathPiece, time: float, constraint: Constraint) -> bool:
        if isinstance(constraint, FrictionConstraint) and all(
            self._cores[i].endless for i in self._supports
        ):
            if not constraint.keeps_sliding(path.at(time)):
                return False
            if constraint.within_cone(self._free(time)):
                return True
        states = {**self._supports, self._body: path.at(time)}
        placed = {i: place(self._cores[i], state) for i, state in states.items()}
        try:
            now = (
                self._refreshed(placed)
                if constraint.state_dependent
                else self._rebuilt(placed, time)
            )
        except Refusal:
            return False
        if [_feature_ids(contact) for contact in now] != [
            _feature_ids(contact) for contact in self._contacts
        ]:
            return False
        friction, senses = self._friction.at(time, states), self._friction.of_contacts(now)
        free = {self._body: self._free(time)}
        if len(now) == 1 and isinstance(constraint, TurningFrictionConstraint):
            sense = slides_on(self._cores, placed, now[0], free, self._slight, friction)
            if sense and senses == {(now[0].a, now[0].b): sense}:
                return True
        try:
            island = island_of(
                self._cores, placed, now, free, self._slight, friction, self._mobility
            )
        except Refusal:
            return False
        if len(island.lasting) < len(now) or island.senses != senses:
            return False
        return (
            constraint.state_dependent
            or not island.constraints(states, time)[self._body].state_dependent
        )

    def _refreshed(self, placed: Mapping[int, Placed]) -> list[Contact]:
        """Return the contacts whose axis still is the best one of its pair."""
        now = []
        for contact in self._contacts:
            a, b = placed[contact.a], placed[contact.b]
            found = axes(a, b)
            best = max(axis.gap for axis in found)
            slack = _SLACK * min(a.core.size, b.core.size)
            if any(axis[:2] == contact.axis[:2] and axis.gap >= best - slack for axis in found):
                now.append(refreshed(contact, a, b))
        return now

    def _rebuilt(self, placed: Mapping[int, Placed], time: float) -> list[Contact]:
        """Return the manifolds of all pairs, found anew."""
        now: list[Contact] = []
        for i, j in dict.fromkeys((contact.a, contact.b) for contact in self._contacts):
            lasting = [contact for contact in self._contacts if (contact.a, contact.b) == (i, j)]
            a, b = placed[i], placed[j]
            now += manifold(a, b, resolution(a, b, time), time, lasting)
        return now


def _feature_ids(contact: Contact) -> object:
    return contact.a, contact.b, contact.axis[:2], contact.gap.which
