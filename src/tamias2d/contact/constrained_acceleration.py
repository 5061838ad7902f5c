"""The acceleration of a body on frictionless lasting contacts, as functions for `motion` (GD3)."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from tamias2d.contact.core import Core, Placed, place
from tamias2d.contact.manifold import (
    Contact,
    gap_acceleration,
    normal_velocity,
    refreshed,
    sticking_acceleration,
)
from tamias2d.contact.response import after_impulse, coupling
from tamias2d.generated import definitions, rotation, translation
from tamias2d.state import Acceleration, State, Vector

Tangential: TypeAlias = Callable[[Contact, Placed, Placed, Acceleration, Acceleration], float]
"""The tangential acceleration of a contact, m/s^2, under those of its two bodies."""

_STILL: Acceleration = (0.0, 0.0, 0.0)
_PARALLEL = 1e-10


@dataclass(frozen=True)
class Constant:
    """One acceleration, whatever the loads: for bodies in contact under constant ones."""

    acceleration: Acceleration
    state_dependent = False

    def __call__(self, acceleration: Acceleration, state: State) -> Acceleration:  # noqa: ARG002
        """Return the one acceleration."""
        return self.acceleration


@dataclass(frozen=True)
class Projection:
    """The part along the supports, exactly: for a body that slides or rests and does not tip."""

    normals: Sequence[Vector]
    turning: bool
    """Whether the body is free to turn, as a disc is."""
    state_dependent = False

    def __call__(self, acceleration: Acceleration, state: State) -> Acceleration:  # noqa: ARG002
        """Return the part along the supports."""
        x, y, turn = acceleration
        return (*tangential_part((x, y), self.normals), turn if self.turning else 0.0)


class TurningConstraint:
    """Closed contacts whose normals or arms turn: for a body that tips or rolls off."""

    state_dependent = True

    def __init__(
        self,
        cores: Sequence[Core],
        body: int,
        contacts: Sequence[Contact],
        placed: Mapping[int, Placed],
    ) -> None:
        self._cores = cores
        self._body = body
        self._contacts = contacts
        self._placed = placed

    def __call__(self, acceleration: Acceleration, state: State) -> Acceleration:
        """Return the acceleration under which all gaps stay as they are."""
        contacts, normal_forces = self.normal_forces(acceleration, state)
        for contact, force in zip(contacts, normal_forces, strict=True):
            sign, arm = (-1, contact.arm_a) if contact.a == self._body else (1, contact.arm_b)
            vector = (sign * force * contact.normal[0], sign * force * contact.normal[1])
            acceleration = after_force(self._cores[self._body], acceleration, arm, vector)
        return acceleration

    def normal_forces(
        self, acceleration: Acceleration, state: State
    ) -> tuple[list[Contact], list[float]]:
        """Return the contacts in a state, and their normal forces, N; a negative one pulls."""
        placed = {**self._placed, self._body: place(self._cores[self._body], state)}
        contacts = [refreshed(c, placed[c.a], placed[c.b]) for c in self._contacts]
        loads = [opening_acceleration(c, placed, {self._body: acceleration}) for c in contacts]
        return contacts, _constraint_forces(self._cores, contacts, contacts, loads)


def opening_acceleration(
    contact: Contact, placed: Mapping[int, Placed], by: Mapping[int, Acceleration]
) -> float:
    """Return the second derivative of a gap, m/s^2; a body that `by` lacks has no acceleration."""
    a, b = contact.a, contact.b
    return gap_acceleration(contact, placed[a], placed[b], by.get(a, _STILL), by.get(b, _STILL))


def contact_acceleration(
    contact: Contact,
    along: bool,
    placed: Mapping[int, Placed],
    by: Mapping[int, Acceleration],
    tangential: Tangential = sticking_acceleration,
) -> float:
    """Return the normal acceleration of a contact, or that `along` its tangent, m/s^2.

    A body that `by` lacks has no acceleration.
    """
    if not along:
        return opening_acceleration(contact, placed, by)
    a, b = contact.a, contact.b
    return tangential(contact, placed[a], placed[b], by.get(a, _STILL), by.get(b, _STILL))


def constrained_accelerations(
    cores: Sequence[Core],
    bodies: Sequence[int],
    contacts: Sequence[Contact],
    free: Mapping[int, Acceleration],
) -> dict[int, Acceleration]:
    """Return the accelerations nearest to the free ones that leave all contacts closed.

    Nearest in the measure of the masses: Gauss's principle of least constraint. Found among
    the motions that the contacts allow, so that where they allow none, nothing moves, to the bit,
    however light and heavy the bodies are.
    """
    place_of = {body: 3 * k for k, body in enumerate(bodies)}
    size = np.array([cores[i].size for i in bodies])
    rows = np.zeros((len(contacts), 3 * len(bodies)))
    for row, contact in zip(rows, contacts, strict=True):
        for body, arm, sign in ((contact.a, contact.arm_a, -1), (contact.b, contact.arm_b, 1)):
            if body in place_of:
                k = place_of[body]
                turn = definitions.torque(arm, contact.normal) / cores[body].size
                row[k : k + 3] = sign * np.array((*contact.normal, turn))
    _, values, right = np.linalg.svd(rows)
    allowed = right[int((values > _PARALLEL).sum()) :].T
    allowed[np.abs(allowed) < _PARALLEL] = 0.0
    weights = np.sqrt([w for i in bodies for w in _weights(cores[i])])
    wanted = np.array([free[i] for i in bodies])
    wanted[:, 2] *= size
    steps = np.linalg.lstsq(weights[:, None] * allowed, weights * wanted.ravel())[0]
    found = (allowed @ steps).reshape(-1, 3)
    found[np.abs(found) <= 1e-13 * np.abs(wanted).max()] = 0.0
    found[:, 2] /= size
    return {i: (x, y, turn) for i, (x, y, turn) in zip(bodies, found.tolist(), strict=True)}


def without_normal_velocity(
    cores: Sequence[Core],
    contacts: Sequence[Contact],
    states: Mapping[int, State],
    edges: Sequence[Contact] | None = None,
) -> dict[int, State]:
    """Return the states after impulses of either sign that leave no normal velocity.

    They act along the normals, or along as many edges of friction cones (DD75).
    """
    states, along = dict(states), edges or contacts
    rates = [normal_velocity(c, states[c.a], states[c.b]) for c in contacts]
    found = _constraint_forces(cores, contacts, along, rates)
    for contact, impulse in zip(along, found, strict=True):
        a, b = contact.a, contact.b
        states[a], states[b] = after_impulse(cores, contact, impulse, states[a], states[b])
    return states


def tangential_part(vector: Vector, normals: Sequence[Vector]) -> Vector:
    """Return the part of a vector along all of some surfaces, given by their normals."""
    (nx, ny), *others = normals
    if any(abs(nx * y - ny * x) > _PARALLEL for x, y in others):
        return 0.0, 0.0
    return along_surface(vector, (nx, ny))


def along_surface(vector: Vector, normal: Vector) -> Vector:
    """Return the part of a vector along a surface."""
    along = normal[1] * vector[0] - normal[0] * vector[1]
    return along * normal[1] + 0.0, -along * normal[0] + 0.0  # no negative zero


def after_force(core: Core, by: Acceleration, arm: Vector, force: Vector) -> Acceleration:
    """Return the acceleration of a body after one more force at an arm (IM1, IM2)."""
    x, y = translation.acceleration(by[:2], force, 1 / core.inverse_mass)
    inertia = 1 / core.inverse_inertia if core.inverse_inertia else math.inf
    turn = rotation.angular_acceleration(definitions.torque(arm, force), inertia)
    return float(x), float(y), by[2] + float(turn)


def _weights(core: Core) -> tuple[float, float, float]:
    """Return the weight of each acceleration of a body, kg; the angular one is times its size."""
    mass = 1 / core.inverse_mass
    turning = 1 / core.inverse_inertia / core.size**2 if core.inverse_inertia else 1e300
    return mass, mass, turning


def _constraint_forces(
    cores: Sequence[Core],
    contacts: Sequence[Contact],
    edges: Sequence[Contact],
    loads: Sequence[float],
) -> list[float]:
    """Return the forces along some edges, of either sign, that cancel the loads at all contacts."""
    if len(contacts) == 1:
        return [-loads[0] / coupling(cores, contacts[0], edges[0])]
    matrix = np.array([[coupling(cores, k, m) for m in edges] for k in contacts])
    return [float(x) for x in -np.linalg.lstsq(matrix, np.array(loads))[0]]
