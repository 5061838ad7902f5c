"""The complementarity problem of the forces, or impulses, at contacts with friction (IM18)."""

from collections.abc import Mapping, Sequence

import numpy as np

from tamias2d.contact.constrained_acceleration import contact_acceleration
from tamias2d.contact.core import Placed
from tamias2d.contact.lemke import lemke
from tamias2d.contact.mobility import Mobility, rows_of
from tamias2d.contact.modes import Part, Patch, closed_directions, force_directions
from tamias2d.state import Acceleration, Array


class ForceProblem:
    """What forces at the contacts of some patches do, each of which sticks, slides or may begin."""

    def __init__(self, mobility: Mobility, bodies: Sequence[int], patches: Sequence[Patch]) -> None:
        self.patches = patches
        self.sticking = [patch for patch in patches if patch.coefficient and not patch.sense]
        contacts = [contact for patch in patches for contact in patch.contacts]
        self._contacts = contacts
        mode = tuple(Part(patch, patch.contacts, patch.sense) for patch in patches)
        tangents = closed_directions([(patch.contacts[0], True) for patch in self.sticking])
        rows = rows_of([*contacts, *tangents], bodies)
        self.rows = rows
        """The Jacobian of the contacts and of the tangents that may stick."""
        columns = rows_of(force_directions(mode), bodies)
        self._size = mobility.sizes(rows, bodies)
        self._matrix = mobility.moved(rows, bodies) @ columns.T / np.outer(self._size, self._size)
        self.count = len(contacts)
        place = {id(contact): k for k, contact in enumerate(contacts)}
        self._bounds = np.zeros((len(self.sticking), self.count))
        for k, patch in enumerate(self.sticking):
            for contact in patch.contacts:
                self._bounds[k, place[id(contact)]] = patch.coefficient

    def loads(self, placed: Mapping[int, Placed], free: Mapping[int, Acceleration]) -> Array:
        """Return the accelerations of the rows, m/s^2, where loads alone accelerate the bodies."""
        rows = [(contact, False) for contact in self._contacts]
        rows += [(patch.contacts[0], True) for patch in self.sticking]
        return np.array([contact_acceleration(c, along, placed, free) for c, along in rows])

    def solved(self, loads: Array) -> tuple[Array, Array] | None:
        """Return the pushes and the drags, N, for the accelerations without them."""
        n, m = self.count, len(self.sticking)
        scaled = loads / self._size
        near, far = self._matrix[:n, :n], self._matrix[:n, n:]
        below, drags = self._matrix[n:, :n], self._matrix[n:, n:]
        bounds = self._bounds * self._size[n:, None] / self._size[None, :n]
        one, none = np.eye(m), np.zeros((m, m))
        matrix = np.block(
            [
                [near, far, -far, np.zeros((n, m))],
                [below, drags, -drags, one],
                [-below, -drags, drags, one],
                [bounds, -one, -one, none],
            ]
        )
        vector = np.concatenate([scaled[:n], scaled[n:], -scaled[n:], np.zeros(m)])
        found = lemke(matrix, vector)
        if found is None:
            return None
        pushes = found[:n] / self._size[:n]
        return pushes, (found[n : n + m] - found[n + m : n + 2 * m]) / self._size[n:]
