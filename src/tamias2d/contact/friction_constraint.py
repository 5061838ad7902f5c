"""The acceleration of a body on frictional lasting contacts, as functions for `motion` (GD8)."""

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from tamias2d.contact.constrained_acceleration import after_force, contact_acceleration
from tamias2d.contact.core import Core, Placed, place
from tamias2d.contact.manifold import (
    Contact,
    refreshed,
    tangential_acceleration,
    tangential_velocity,
)
from tamias2d.contact.modes import Mode, closed, closed_directions, effects, force_directions
from tamias2d.generated import definitions, friction
from tamias2d.state import Acceleration, State

_STILL: Acceleration = (0.0, 0.0, 0.0)
_FORCE_TOLERANCE = 4e-10
"""Of the largest force: how far one may be outside its cone; more than the residual of a mode."""
_UNIT_VECTORS: tuple[Acceleration, ...] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


class FrictionConstraint:
    """Sticking, sliding or rolling along surfaces whose normals do not turn.

    Contact forces are linear in the loads, and so is the remaining acceleration. It is exactly 0
    where nothing can move.
    """

    def __init__(
        self,
        cores: Sequence[Core],
        body: int,
        mode: Mode,
        allowed: Callable[[Acceleration], Acceleration],
    ) -> None:
        """Take a mode, and the projection of an acceleration on what the contacts allow."""
        core = cores[body]
        self._body = body
        self.sliding = [
            (mode.pressed[0], mode.sense) for mode in mode if mode.pressed and mode.sense
        ]
        """One contact of each sliding pair, with the sense in which it slides."""
        self.state_dependent = not core.steady and len(core.group) <= 1
        rows, columns = closed(mode), force_directions(mode)
        jacobian = np.array([jacobian_row(body, contact) for contact in closed_directions(rows)])
        responses = np.array([unit_response(core, body, contact) for contact in columns]).T
        self._mode = mode
        self._forces = -np.linalg.pinv(effects(cores, rows, columns)) @ jacobian
        left = np.eye(3) + responses @ self._forces
        x, y, turn = (left @ axis for axis in np.array(_UNIT_VECTORS))
        self._left = tuple(
            zip(
                *(allowed((float(c[0]), float(c[1]), float(c[2]))) for c in (x, y, turn)),
                strict=True,
            )
        )

    def __call__(self, acceleration: Acceleration, state: State) -> Acceleration:  # noqa: ARG002
        """Return the acceleration that remains under the contact forces."""
        x, y, turn = acceleration
        across, up, round_ = (p * x + q * y + r * turn + 0.0 for p, q, r in self._left)
        return across, up, round_

    def within_cone(self, acceleration: Acceleration) -> bool:
        """Return whether the forces of the mode lie within the friction cones.

        Where several sets of forces do the same, one of them is examined.
        """
        forces = (self._forces @ acceleration).tolist()
        unseen = _FORCE_TOLERANCE * max(map(abs, forces))
        along = iter(forces[sum(len(mode.pressed) for mode in self._mode) :])
        across = iter(forces)
        for mode in self._mode:
            normal = [next(across) for _ in mode.pressed]
            if min(normal, default=0.0) < -unseen:
                return False
            most = abs(friction.friction_force(1, mode.patch.coefficient, sum(normal)))
            if mode.sticks and abs(next(along)) > most + unseen:
                return False
        return True

    def keeps_sliding(self, state: State) -> bool:
        """Return whether all sliding pairs still slide in their senses, in a state of the body."""
        still = State((0.0, 0.0), 0.0, (0.0, 0.0), 0.0)
        for contact, sense in self.sliding:
            a, b = (state if i == self._body else still for i in (contact.a, contact.b))
            if sense * tangential_velocity(contact, a, b) <= 0:
                return False
        return True


class TurningFrictionConstraint:
    """Closed contacts whose normals or arms turn: for a body that tips or rolls off."""

    state_dependent = True
    tangential_velocity: Sequence[tuple[Contact, int]] = ()

    def __init__(
        self,
        cores: Sequence[Core],
        body: int,
        mode: Mode,
        placed: Mapping[int, Placed],
    ) -> None:
        self._cores = cores
        self._body = body
        self._mode = mode
        self._placed = placed

    def __call__(self, acceleration: Acceleration, state: State) -> Acceleration:
        """Return the acceleration under which the closed contacts stay closed."""
        placed = {**self._placed, self._body: place(self._cores[self._body], state)}
        mode = tuple(
            mode._replace(
                pressed=tuple(refreshed(c, placed[c.a], placed[c.b]) for c in mode.pressed)
            )
            for mode in self._mode
        )
        rows, columns = closed(mode), force_directions(mode)
        by = {self._body: acceleration}
        loads = [
            contact_acceleration(contact, along, placed, by, tangential_acceleration)
            for contact, along in rows
        ]
        found = np.linalg.lstsq(effects(self._cores, rows, columns), -np.array(loads))[0]
        core = self._cores[self._body]
        for contact, force in zip(columns, found.tolist(), strict=True):
            x, y, turn = unit_response(core, self._body, contact)
            across, up, round_ = acceleration
            acceleration = across + force * x, up + force * y, round_ + force * turn
        return acceleration


def jacobian_row(body: int, contact: Contact) -> Acceleration:
    """Return the row of the Jacobian: the contact's normal acceleration by the body's."""
    sign, arm = _side(body, contact)
    x, y = contact.normal
    return sign * x, sign * y, sign * float(definitions.torque(arm, contact.normal))


def unit_response(core: Core, body: int, contact: Contact) -> Acceleration:
    """Return the body's acceleration under a unit of force along the contact's normal."""
    sign, arm = _side(body, contact)
    return after_force(core, _STILL, arm, (sign * contact.normal[0], sign * contact.normal[1]))


def _side(body: int, contact: Contact) -> tuple[int, tuple[float, float]]:
    return (-1, contact.arm_a) if contact.a == body else (1, contact.arm_b)
