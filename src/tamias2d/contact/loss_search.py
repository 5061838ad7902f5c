"""The search for the time at which the lasting contacts of bodies change on their paths."""

from collections.abc import Callable, Sequence

from tamias2d.contact.active_contacts import ActiveContacts
from tamias2d.contact.body_paths import BodyPaths
from tamias2d.contact.contact_loss import ContactLossWatch
from tamias2d.contact.core import Core, place
from tamias2d.contact.coupled_constraint import CoupledConstraint
from tamias2d.contact.coupled_loss import CoupledLossWatch
from tamias2d.contact.gap import slight_opening
from tamias2d.contact.manifold import Contact
from tamias2d.contact.mobility import Mobility
from tamias2d.contact.pair_friction import LastingFriction
from tamias2d.path import Paths
from tamias2d.state import Acceleration


class LossSearch:
    """Finds when contacts that last are lost, of a body or of several that they couple."""

    def __init__(
        self,
        cores: Sequence[Core],
        paths: BodyPaths,
        active: ActiveContacts,
        motion: Paths,
        friction: Callable[[int, int], float],
    ) -> None:
        """Take, among others, what makes the paths of bodies, and the friction of pairs."""
        self._cores = cores
        self._paths = paths
        self._active = active
        self._motion = motion
        self._friction = friction

    def first_loss(self, body: int, now: float, until: float) -> float | None:
        """Return when the contacts of a body change first, s; or None.

        Contacts of several moving bodies are those of the first of them. The run is at a time, and
        goes on until another, s.
        """
        constraint = self._active.constraints[body]
        if isinstance(constraint, CoupledConstraint):
            first = body == constraint.bodies[0]
            return self._first_coupled(constraint, now, until) if first else None
        contacts = self._active.on([body])
        others = dict.fromkeys(i for c in contacts for i in (c.a, c.b) if i != body)
        supports = {i: self._paths.state(i, now) for i in others}
        coupled = self._cores[body].jointed or any(self._cores[i].dynamic for i in supports)
        if constraint is None or coupled:  # that all rests, for good
            return None
        watch = ContactLossWatch(
            self._cores,
            body,
            contacts,
            supports,
            lambda time: self._free(body, time),
            self._slight(contacts, now, until),
            LastingFriction(self._friction, self._active.senses),
            Mobility(self._cores, self._motion.pushed, now, lambda i: self._paths.state(i, now)),
        )
        return watch.first_loss(self._paths.path(body), constraint)

    def _first_coupled(
        self, constraint: CoupledConstraint, now: float, until: float
    ) -> float | None:
        contacts = self._active.on(constraint.bodies)
        bodies = {*constraint.bodies, *(i for c in contacts for i in (c.a, c.b))}
        watch = CoupledLossWatch(
            self._cores,
            constraint,
            contacts,
            {i: self._paths.path(i) for i in sorted(bodies)},
            self._free,
            self._slight(contacts, now, until),
            LastingFriction(self._friction, self._active.senses),
        )
        return watch.first_loss()

    def _slight(self, contacts: Sequence[Contact], now: float, until: float) -> float:
        """Return the acceleration, m/s^2, by which contacts open too little to be seen."""
        bodies = dict.fromkeys(i for c in contacts for i in (c.a, c.b))
        placed = {i: place(self._cores[i], self._paths.state(i, now)) for i in bodies}
        return min(slight_opening(placed[c.a], placed[c.b], now, until) for c in contacts)

    def _free(self, body: int, time: float) -> Acceleration:
        return self._motion.free(body, time, lambda i: self._paths.state(i, time))
