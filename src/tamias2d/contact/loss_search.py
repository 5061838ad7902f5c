"""The search for the time at which the lasting contacts of bodies change on their paths."""

from collections.abc import Callable, Sequence

from tamias2d.contact.active_contacts import ActiveContacts
from tamias2d.contact.body_paths import BodyPaths
from tamias2d.contact.contact_loss import ContactLossWatch
from tamias2d.contact.core import Core, place
from tamias2d.contact.coupled_constraint import CoupledConstraint
from tamias2d.contact.coupled_loss import CoupledLossWatch
from tamias2d.contact.gap import slight_opening
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
            return self._first_coupled(constraint) if body == constraint.bodies[0] else None
        contacts = self._active.on([body])
        others = dict.fromkeys(i for c in contacts for i in (c.a, c.b) if i != body)
        supports = {i: self._paths.state(i, now) for i in others}
        if constraint is None or any(self._cores[i].dynamic for i in supports):
            return None
        placed = place(self._cores[body], self._paths.state(body, now))
        slight = min(
            slight_opening(placed, place(self._cores[i], state), now, until)
            for i, state in supports.items()
        )
        watch = ContactLossWatch(
            self._cores,
            body,
            contacts,
            supports,
            lambda time: self._free(body, time),
            slight,
            (self._friction, self._active.senses),
        )
        return watch.first_loss(self._paths.path(body), constraint)

    def _first_coupled(self, constraint: CoupledConstraint) -> float | None:
        contacts = self._active.on(constraint.bodies)
        bodies = {*constraint.bodies, *(i for c in contacts for i in (c.a, c.b))}
        paths = {i: self._paths.path(i) for i in sorted(bodies)}
        return CoupledLossWatch(self._cores, constraint, contacts, paths, self._free).first_loss()

    def _free(self, body: int, time: float) -> Acceleration:
        return self._motion.free(body, time, lambda i: self._paths.state(i, time))
