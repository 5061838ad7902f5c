"""What rough contacts make of a body's acceleration, as functions that motion can call (GD8).

Serves: motion along a rough contact that lasts. Hides: how the forces of a mode follow the loads.
"""

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from tamias2d.contact.core import Core, Placed, place
from tamias2d.contact.hold import accelerated, opening
from tamias2d.contact.manifold import Contact, followed, scrape, sliding
from tamias2d.contact.modes import Mode, closed, directed, effects, ways
from tamias2d.contact.refusal import LastingContactError, named
from tamias2d.generated import definitions, friction
from tamias2d.state import Acceleration, State

_STILL: Acceleration = (0.0, 0.0, 0.0)
_SEEN = 4e-10
"""Of the forces: by how much one may be beyond its bound; more than what modes leave of loads."""
_AXES: tuple[Acceleration, ...] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


class Gripped:
    """Sticking, sliding or rolling along surfaces that stay as they are.

    The forces are linear in the loads, and so is what they leave of the acceleration. Where nothing
    can move nothing is left, to the bit.
    """

    def __init__(
        self,
        cores: Sequence[Core],
        body: int,
        mode: Mode,
        allowed: Callable[[Acceleration], Acceleration],
    ) -> None:
        """Take a mode, and what leaves of an acceleration that to which the contacts are open."""
        core = cores[body]
        self._body = body
        self.sliding = [
            (part.pressed[0], part.sense) for part in mode if part.pressed and part.sense
        ]
        """A contact of each pair that slides, with the sense of the sliding."""
        self.bends = not core.steady and len(core.group) <= 1
        rows, columns = closed(mode), ways(mode)
        feels = np.array([_felt(body, contact) for contact in directed(rows)])
        gives = np.array([_given(core, body, contact) for contact in columns]).T
        self._mode = mode
        self._forces = -np.linalg.pinv(effects(cores, rows, columns)) @ feels
        left = np.eye(3) + gives @ self._forces
        x, y, turn = (left @ axis for axis in np.array(_AXES))
        self._left = tuple(
            zip(
                *(allowed((float(c[0]), float(c[1]), float(c[2]))) for c in (x, y, turn)),
                strict=True,
            )
        )

    def __call__(self, acceleration: Acceleration, state: State) -> Acceleration:  # noqa: ARG002
        """Return what the contacts leave of an acceleration."""
        x, y, turn = acceleration
        ahead, up, round_ = (p * x + q * y + r * turn + 0.0 for p, q, r in self._left)
        return ahead, up, round_

    def fits(self, acceleration: Acceleration) -> bool:
        """Return whether forces of the mode can be seen to be within Coulomb's bounds.

        Where several sets of forces do the same, one of them is looked at.
        """
        forces = (self._forces @ acceleration).tolist()
        unseen = _SEEN * max(map(abs, forces))
        along = iter(forces[sum(len(part.pressed) for part in self._mode) :])
        across = iter(forces)
        for part in self._mode:
            normal = [next(across) for _ in part.pressed]
            if min(normal, default=0.0) < -unseen:
                return False
            most = abs(friction.friction_force(1, part.patch.roughness, sum(normal)))
            if part.sticks and abs(next(along)) > most + unseen:
                return False
        return True

    def slides(self, state: State) -> bool:
        """Return whether all that slides still does so in its sense, in a state of the body."""
        still = State((0.0, 0.0), 0.0, (0.0, 0.0), 0.0)
        for contact, sense in self.sliding:
            a, b = (state if i == self._body else still for i in (contact.a, contact.b))
            if sense * sliding(contact, a, b) <= 0:
                return False
        return True


class Scraping:
    """Contacts kept closed while their normals or arms turn: for a body that tips or rolls off."""

    bends = True
    sliding: Sequence[tuple[Contact, int]] = ()

    def __init__(
        self,
        cores: Sequence[Core],
        body: int,
        mode: Mode,
        placed: Mapping[int, Placed],
        time: float,
    ) -> None:
        """Take a mode.

        Raises:
            LastingContactError: a side rolls on something round.
        """
        self._cores = cores
        self._body = body
        self._mode = mode
        self._placed = placed
        for contact, along in closed(mode):
            if along:
                self._refuse_rocking(contact, time)

    def __call__(self, acceleration: Acceleration, state: State) -> Acceleration:
        """Return the acceleration that leaves closed what is closed."""
        placed = {**self._placed, self._body: place(self._cores[self._body], state)}
        mode = tuple(
            part._replace(
                pressed=tuple(followed(c, placed[c.a], placed[c.b]) for c in part.pressed)
            )
            for part in self._mode
        )
        rows, columns = closed(mode), ways(mode)
        by = {self._body: acceleration}
        loads = [_load(contact, along, placed, by) for contact, along in rows]
        found = np.linalg.lstsq(effects(self._cores, rows, columns), -np.array(loads))[0]
        core = self._cores[self._body]
        for contact, force in zip(columns, found.tolist(), strict=True):
            x, y, turn = _given(core, self._body, contact)
            ahead, up, spin = acceleration
            acceleration = ahead + force * x, up + force * y, spin + force * turn
        return acceleration

    def _refuse_rocking(self, contact: Contact, time: float) -> None:
        p = contact.b if contact.axis.swapped else contact.a
        q = contact.a if contact.axis.swapped else contact.b
        rocks = p == self._body and (self._cores[q].radius or contact.axis.side is None)
        if rocks and len(self._cores[p].corners) > 1:
            names = named(self._cores[contact.a].name, self._cores[contact.b].name)
            raise LastingContactError(
                f"{names} at {time!r} s: a side or a corner rolls on something round with "
                "friction, which the located way does not follow (GD8). End the run before, or "
                "change the scene.",
                time=time,
            )


def _load(
    contact: Contact, along: bool, placed: Mapping[int, Placed], by: Mapping[int, Acceleration]
) -> float:
    if not along:
        return opening(contact, placed, by)
    a, b = contact.a, contact.b
    return scrape(contact, placed[a], placed[b], by.get(a, _STILL), by.get(b, _STILL))


def _felt(body: int, contact: Contact) -> Acceleration:
    """Return what of a body's acceleration is that of the contact along its normal."""
    sign, arm = _side(body, contact)
    x, y = contact.normal
    return sign * x, sign * y, sign * float(definitions.torque(arm, contact.normal))


def _given(core: Core, body: int, contact: Contact) -> Acceleration:
    """Return what a unit of force along a contact's normal does to the body."""
    sign, arm = _side(body, contact)
    return accelerated(core, _STILL, arm, (sign * contact.normal[0], sign * contact.normal[1]))


def _side(body: int, contact: Contact) -> tuple[int, tuple[float, float]]:
    return (-1, contact.arm_a) if contact.a == body else (1, contact.arm_b)
