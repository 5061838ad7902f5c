"""The accelerations of several bodies that lasting contacts couple (IM18)."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from tamias2d.contact.constrained_acceleration import Constant, contact_acceleration
from tamias2d.contact.core import Placed, place
from tamias2d.contact.manifold import (
    Contact,
    refreshed,
    speed_scale,
    tangential_velocity,
)
from tamias2d.contact.mobility import Mobility, rows_of
from tamias2d.contact.modes import (
    Mode,
    closed,
    closed_directions,
    cone_edges,
    force_directions,
    forces,
)
from tamias2d.float64 import EPSILON
from tamias2d.generated import friction
from tamias2d.state import Acceleration, Array, State

_FORCE_TOLERANCE = 1e-9
"""Of the largest force: how far one may be outside its cone."""


class CoupledConstraint:
    """Closed contacts of several moving bodies, each of which sticks or slides."""

    state_dependent = True

    def __init__(
        self,
        mobility: Mobility,
        bodies: Sequence[int],
        mode: Mode,
        placed: Mapping[int, Placed],
    ) -> None:
        """Take a mode, and the bodies that stand still."""
        self.bodies = tuple(bodies)
        self.mobility = mobility
        """At any instant."""
        self._mode = mode
        self._still = {i: body for i, body in placed.items() if i not in self.bodies}

    def __call__(self, acceleration: Acceleration, state: State) -> Acceleration:
        """Raise an error: the accelerations of all the bodies are found together."""
        raise NotImplementedError("bodies in contact are accelerated together")

    def together(self, time: float, accelerations: Array, states: Sequence[State]) -> Array:
        """Return the accelerations (n, 3) of all bodies under which closed contacts stay closed."""
        return self._solved(time, accelerations, states).accelerations

    def exerted(self, time: float, accelerations: Array, states: Sequence[State]) -> Array:
        """Return what contacts exert on all bodies (n, 3), N and N m, for accelerations without.

        Where contacts and joints leave open who bears what, it is the least that does it, or where
        that is outside of the cones of friction, forces within them.
        """
        found = self._solved(time, accelerations, states)
        directions, pushes = force_directions(found.mode), found.forces
        if not _within_cones(found) and (other := self._other_forces(found)) is not None:
            directions, pushes = cone_edges(found.mode), other
        total: Array = np.array(pushes) @ rows_of(directions, self.bodies)
        return total.reshape(-1, 3)

    def slides_on(self, states: Sequence[State], slack: Sequence[float]) -> bool:
        """Return whether all parts that slide do so in their senses, in these states.

        `slack`, m/s, is how fast each part may slide against its sense (`against`).
        """
        slips = self._slips(states)
        return all(slip is None or slip > -most for slip, most in zip(slips, slack, strict=True))

    def holds(self, time: float, accelerations: Array, states: Sequence[State]) -> bool:
        """Return whether forces obey Coulomb's law in these states, under these loads."""
        found = self._solved(time, accelerations, states)
        return _within_cones(found) or self._other_forces(found) is not None

    def against(self, states: Sequence[State], accelerations: Array, length: float) -> list[float]:
        """Return how fast each part may slide against its sense for some time, s, by rounding, m/s.

        What is at the edge of sticking may begin so, and would end at once.
        """
        placed = self._placed(states)
        gained = float(np.abs(accelerations).max(initial=0.0)) * length
        found = [0.0] * len(self._mode)
        for k, slip in enumerate(self._slips(states)):
            if slip is None:
                continue
            contact = self._mode[k].pressed[0]
            speeds = speed_scale(contact, placed[contact.a].state, placed[contact.b].state)
            noise = 64 * EPSILON * (speeds + gained)
            if slip <= noise:
                found[k] = max(-2.0 * slip, noise)
        return found

    def _slips(self, states: Sequence[State]) -> list[float | None]:
        """Return how fast each part that slides does so in its sense, m/s."""
        placed = self._placed(states)
        return [
            part.sense * _slip(part.pressed[0], placed) if part.pressed and part.sense else None
            for part in self._mode
        ]

    def _solved(self, time: float, accelerations: Array, states: Sequence[State]) -> "_Solved":
        placed = self._placed(states)
        mode = tuple(
            part._replace(
                pressed=tuple(refreshed(c, placed[c.a], placed[c.b]) for c in part.pressed)
            )
            for part in self._mode
        )
        rows = closed(mode)
        by = {
            i: (x, y, turn)
            for i, (x, y, turn) in zip(self.bodies, accelerations.tolist(), strict=True)
        }
        loads = np.array([contact_acceleration(c, along, placed, by) for c, along in rows])
        jacobian = rows_of(closed_directions(rows), self.bodies)
        mobility = self.mobility.at(time, dict(zip(self.bodies, states, strict=True)).__getitem__)
        pushes = mobility.moved(rows_of(force_directions(mode), self.bodies), self.bodies)
        found = least_forces(
            jacobian,
            pushes,
            mobility.sizes(jacobian, self.bodies),
            loads,
            mobility.redundant(self.bodies),
        )
        result = accelerations + (found @ pushes).reshape(-1, 3)
        return _Solved(mobility, mode, jacobian, loads, found.tolist(), result)

    def _placed(self, states: Sequence[State]) -> dict[int, Placed]:
        moving = {
            i: place(self.mobility.cores[i], s) for i, s in zip(self.bodies, states, strict=True)
        }
        return self._still | moving

    def _other_forces(self, found: "_Solved") -> list[float] | None:
        """Return forces along the edges of the cones that do the same, if there are any."""
        edges = found.mobility.moved(rows_of(cone_edges(found.mode), self.bodies), self.bodies)
        return forces(found.jacobian @ edges.T, found.loads)


@dataclass(frozen=True)
class Resting(Constant):
    """Bodies at rest, some of which joints hold; the forces that keep them so are known."""

    kept_by: CoupledConstraint = field(compare=False)
    """The same contacts as a constraint that is solved for its forces."""

    @property
    def bodies(self) -> tuple[int, ...]:
        """All bodies that rest together."""
        return self.kept_by.bodies

    def exerted(self, time: float, accelerations: Array, states: Sequence[State]) -> Array:
        """Return what contacts exert on all bodies (n, 3), N and N m."""
        return self.kept_by.exerted(time, accelerations, states)


class _Solved(NamedTuple):
    """What the contacts of a mode do in some states."""

    mobility: Mobility
    mode: Mode
    jacobian: Array
    loads: Array
    forces: list[float]
    accelerations: Array


def _slip(contact: Contact, placed: Mapping[int, Placed]) -> float:
    """Return the tangential velocity of a contact where its bodies are now, m/s."""
    a, b = placed[contact.a], placed[contact.b]
    return tangential_velocity(refreshed(contact, a, b), a.state, b.state)


def least_forces(
    jacobian: Array, pushes: Array, size: Array, loads: Array, redundant: float
) -> Array:
    """Return the least forces that take the loads off closed contacts.

    `pushes` (m, 3 n) are the accelerations by a unit of each; by their `size` light and heavy
    bodies count alike. Couplings below a share of the largest are of contacts that do the same.
    """
    if not len(loads):
        return np.zeros(0)
    matrix = (jacobian @ pushes.T) / np.outer(size, size)
    found: Array = np.linalg.lstsq(matrix, -loads / size, rcond=redundant)[0] / size
    return found


def _within_cones(found: _Solved) -> bool:
    """Return whether the least forces lie within the friction cones."""
    unseen = _FORCE_TOLERANCE * max(map(abs, found.forces), default=0.0)
    along = iter(found.forces[sum(len(part.pressed) for part in found.mode) :])
    across = iter(found.forces)
    for part in found.mode:
        normal = [next(across) for _ in part.pressed]
        if min(normal, default=0.0) < -unseen:
            return False
        most = abs(friction.friction_force(1, part.patch.coefficient, sum(normal)))
        if part.sticks and abs(next(along)) > most + unseen:
            return False
    return True
