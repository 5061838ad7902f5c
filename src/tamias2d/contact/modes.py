"""The modes of Coulomb friction at an instant: which contacts press, stick and slide.

A force at a contact lies in the friction cone between n - mu t and n + mu t, for a normal n and a
tangent t: where the contact sticks it is any non-negative sum of the cone's edges and n, where it
slides it is along the edge against the sliding. Non-negative least squares therefore decides
whether a mode has forces (GD8).
"""

from collections.abc import Iterator, Sequence
from itertools import islice, product
from typing import NamedTuple

import numpy as np

from tamias2d.contact.core import Core
from tamias2d.contact.manifold import Contact, tangent_of
from tamias2d.contact.response import coupling
from tamias2d.generated import friction
from tamias2d.state import Array

_RESIDUAL = 1e-10
"""Of the loads: the residual that forces may leave."""
_NEGLIGIBLE = 1e-200  # 1/kg; a force with a smaller effect has none
_MAX_MODES = 4096  # that are tried


class Patch(NamedTuple):
    """The contacts of one pair, and how they slide."""

    contacts: tuple[Contact, ...]
    coefficient: float
    """The pair's coefficient of friction."""
    sense: int
    """1 if they slide along the tangent, -1 if against it, 0 if they do not slide."""


class Part(NamedTuple):
    """The contacts of a patch that press in a mode, and how they slide."""

    patch: Patch
    pressed: tuple[Contact, ...]
    """Those of its contacts that may press; the others open."""
    sense: int
    """Of the sliding that is there or begins; 0 without sliding or friction."""

    @property
    def sticks(self) -> bool:
        """Whether the pair may not move along the tangent."""
        return bool(self.pressed and self.patch.coefficient and not self.sense)


Mode = tuple[Part, ...]


def modes(patches: Sequence[Patch]) -> Iterator[Mode]:
    """Go through all modes, those in which most contacts press and stick first."""
    return islice(product(*(list(_parts(patch)) for patch in patches)), _MAX_MODES)


def _parts(patch: Patch) -> Iterator[Part]:
    decided = patch.sense or not patch.coefficient
    senses = (patch.sense,) if decided else (0, 1, -1)
    groups = [patch.contacts]
    if len(patch.contacts) > 1:
        groups += [(contact,) for contact in patch.contacts]
    for group in groups:
        yield from (Part(patch, group, sense) for sense in senses)
    yield Part(patch, (), patch.sense)


def closed(mode: Mode) -> list[tuple[Contact, bool]]:
    """Return the contacts that a mode keeps from opening, and (true) from sliding."""
    found = [(contact, False) for part in mode for contact in part.pressed]
    return found + [(part.pressed[0], True) for part in mode if part.sticks]


def cone_edges(mode: Mode) -> list[Contact]:
    """Return the edges of the friction cones of a mode, as contacts with these for normals."""
    found = []
    for part in mode:
        senses = (0, -1, 1) if part.sticks else (part.sense,)
        found += [
            _cone_edge(contact, part.patch.coefficient, sense)
            for contact in part.pressed
            for sense in senses
        ]
    return found


def force_directions(mode: Mode) -> list[Contact]:
    """Return as many directions as `closed` has, of which the cone edges are sums."""
    found = [
        contact if part.sticks else _cone_edge(contact, part.patch.coefficient, part.sense)
        for part in mode
        for contact in part.pressed
    ]
    return found + [tangent_of(part.pressed[0]) for part in mode if part.sticks]


def effects(
    cores: Sequence[Core], rows: Sequence[tuple[Contact, bool]], columns: Sequence[Contact]
) -> Array:
    """Return the acceleration in each closed direction by a unit of each force, 1/kg."""
    directions = closed_directions(rows)
    return np.array([[coupling(cores, row, column) for column in columns] for row in directions])


def closed_directions(rows: Sequence[tuple[Contact, bool]]) -> list[Contact]:
    """Return closed contacts, with the directions in which they are closed for normals."""
    return [tangent_of(contact) if along else contact for contact, along in rows]


def forces(matrix: Array, loads: Array) -> list[float] | None:
    """Return non-negative forces that cancel all loads, N, or None if there are none."""
    from scipy.optimize import nnls

    scale = np.abs(loads).max()
    if scale == 0:
        return [0.0] * matrix.shape[1]
    size = np.maximum(np.abs(matrix).max(axis=1), _NEGLIGIBLE)  # light and heavy bodies count alike
    rows = matrix / size[:, None]
    weights = np.maximum(np.abs(rows).max(axis=0), _NEGLIGIBLE)
    try:
        found, _ = nnls(rows / weights, -loads / size)
    except RuntimeError:  # it went in a circle, as it may where nothing fits
        return None
    found = found / weights
    return found.tolist() if np.abs(matrix @ found + loads).max() <= _RESIDUAL * scale else None


def _cone_edge(contact: Contact, coefficient: float, sense: int) -> Contact:
    """Return a contact whose normal is the edge of its friction cone against the sliding."""
    slope = friction.friction_force(sense, coefficient, 1.0)
    if not slope:
        return contact
    (x, y), (u, v) = contact.normal, tangent_of(contact).normal
    size = 1 + abs(slope)  # bounded for any coefficient
    return contact._replace(normal=((x + slope * u) / size, (y + slope * v) / size))
