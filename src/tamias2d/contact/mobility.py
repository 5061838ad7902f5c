"""By how much impulses change the velocities of bodies: inverse masses, and joints (IM3, GD20)."""

from collections.abc import Callable, Iterable, Sequence
from typing import NamedTuple

import numpy as np

from tamias2d.contact.core import Core
from tamias2d.contact.manifold import Contact
from tamias2d.contact.response import coupling
from tamias2d.generated import definitions
from tamias2d.state import Array, State

_HELD = 1e-7
"""Of what it would be without joints: a row that moves less is held by them."""

_REDUNDANT = 1e-12
"""Of the largest one: below it, a coupling is one of contacts that do the same."""
_REDUNDANT_WITH_JOINTS = 1e-9
"""Likewise: a corner that passes below a hinge does nearly the same as what lies beside it."""

Moved = Callable[[float, Sequence[int], Array, Callable[[int], State]], Array]
"""From a time, bodies, impulses (m, n, 3) and states to changes of velocities (m, n, 3)."""


class Mobility(NamedTuple):
    """What impulses, or forces, do to bodies at one instant."""

    cores: Sequence[Core]
    moved_with_joints: Moved
    time: float
    state: Callable[[int], State]

    def at(self, time: float, state: Callable[[int], State]) -> "Mobility":
        """Return what impulses do to the same bodies at another time, s, in other states."""
        return self._replace(time=time, state=state)

    def moved(self, rows: Array, bodies: Sequence[int]) -> Array:
        """Return the changes (m, 3 n) of velocities by impulses (m, 3 n) on n bodies.

        These are whole mechanisms, and other bodies.
        """
        if not self._jointed(bodies):
            return rows * inverse_masses(self.cores, bodies)
        impulses = rows.reshape(len(rows), len(bodies), 3)
        return self.moved_with_joints(self.time, bodies, impulses, self.state).reshape(rows.shape)

    def couplings(self, rows: Sequence[Contact], columns: Sequence[Contact]) -> Array:
        """Return the normal accelerations of contacts by unit forces at others, 1/kg."""
        bodies = self.reached([*rows, *columns])
        if not self._jointed(bodies):
            return np.array([[coupling(self.cores, k, m) for m in columns] for k in rows])
        found: Array = rows_of(rows, bodies) @ self.moved(rows_of(columns, bodies), bodies).T
        return found

    def sizes(self, rows: Array, bodies: Sequence[int]) -> Array:
        """Return the root (m,) of how much each row is moved by its own impulse, 1/kg.

        Where joints hold it, that is how much it would be without them.
        """
        free: Array = np.sqrt((rows * rows * inverse_masses(self.cores, bodies)).sum(axis=1))
        if not self._jointed(bodies):
            return free
        own = np.sqrt(np.maximum((rows * self.moved(rows, bodies)).sum(axis=1), 0.0))
        return np.where(own > _HELD * free, own, free)

    def redundant(self, bodies: Sequence[int]) -> float:
        """Return the share of the largest coupling below which contacts do the same."""
        return _REDUNDANT_WITH_JOINTS if self._jointed(bodies) else _REDUNDANT

    def reached(self, contacts: Iterable[Contact]) -> list[int]:
        """Return the moving bodies of contacts, and those that joints tie to them, in order."""
        touched = dict.fromkeys(i for contact in contacts for i in (contact.a, contact.b))
        return sorted(i for i in with_mechanisms(self.cores, touched) if self.cores[i].dynamic)

    def _jointed(self, bodies: Iterable[int]) -> bool:
        return any(self.cores[i].jointed for i in bodies)


def with_mechanisms(cores: Sequence[Core], bodies: Iterable[int]) -> list[int]:
    """Return bodies, and those that joints tie to them, which an impulse reaches too."""
    found = dict.fromkeys(bodies)
    for body in list(found):
        found |= dict.fromkeys(sorted(cores[body].group) if cores[body].jointed else ())
    return list(found)


def rows_of(directions: Sequence[Contact], bodies: Sequence[int]) -> Array:
    """Return the Jacobian (m, 3 n) of contacts along their normals, for n bodies."""
    place_of = {body: 3 * k for k, body in enumerate(bodies)}
    found = np.zeros((len(directions), 3 * len(bodies)))
    for row, contact in zip(found, directions, strict=True):
        x, y = contact.normal
        for body, arm, sign in ((contact.a, contact.arm_a, -1.0), (contact.b, contact.arm_b, 1.0)):
            if body in place_of:
                k = place_of[body]
                turn = float(definitions.torque(arm, contact.normal))
                row[k : k + 3] = sign * x, sign * y, sign * turn
    return found


def inverse_masses(cores: Sequence[Core], bodies: Sequence[int]) -> Array:
    """Return the inverse of the mass, twice, and of the inertia, of each body (3 n,)."""
    return np.array(
        [
            inverse
            for i in bodies
            for inverse in (
                cores[i].inverse_mass,
                cores[i].inverse_mass,
                cores[i].inverse_inertia,
            )
        ]
    )
