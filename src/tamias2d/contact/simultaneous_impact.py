"""Impacts of several pairs that act on one another and are answered together (DD67, DD68)."""

import math
from collections import defaultdict
from collections.abc import Mapping, MutableMapping, Sequence
from typing import NamedTuple

import numpy as np

from tamias2d.contact.complementarity import complementarity
from tamias2d.contact.lemke import lemke
from tamias2d.contact.manifold import Contact, normal_velocity, tangent_of
from tamias2d.contact.mobility import Mobility, rows_of
from tamias2d.contact.symmetry import symmetric
from tamias2d.generated import friction, impact
from tamias2d.state import Array, State, Vector

_PARALLEL = 1e-12
"""Of the largest one: below it, a coupling is one of contacts that do the same."""
_NEGLIGIBLE = 1e-14
"""Of the terms of a sum, or of the largest one: what rounding leaves of nothing."""


class Meeting(NamedTuple):
    """The contacts of a pair that approaches."""

    contacts: Sequence[Contact]
    restitution: float
    coefficient: float
    """The pair's coefficient of friction."""


def simultaneous_impulses(
    mobility: Mobility, meetings: Sequence[Meeting], states: Mapping[int, State]
) -> list[tuple[Contact, float, float]]:
    """Return the contacts with their impulses along normal and tangent, N s."""
    normals = [contact for meeting in meetings for contact in meeting.contacts]
    rough = [meeting for meeting in meetings if meeting.coefficient > 0]
    tangents = [tangent_of(meeting.contacts[0]) for meeting in rough]
    directions = normals + tangents
    matrix = mobility.couplings(directions, directions)
    rates = np.array([normal_velocity(c, states[c.a], states[c.b]) for c in directions])
    count = len(normals)
    restitution = [meeting.restitution for meeting in meetings for _ in meeting.contacts]
    wanted = [
        -float(impact.impulse(e, rate, 1.0))
        for e, rate in zip(restitution, rates[:count].tolist(), strict=True)
    ]
    pushes = np.array(complementarity(matrix[:count, :count].tolist(), wanted))
    drags = np.zeros(len(rough))
    if rough and pushes.any():
        pushes, drags = _with_friction(matrix, rates, pushes, rough, normals)
    laws = restitution + [meeting.coefficient for meeting in rough]
    known = np.stack([rates, np.array(laws)], axis=1)
    signed = [False] * count + [True] * len(rough)
    found = symmetric(matrix, known, signed, [*pushes.tolist(), *drags.tolist()])
    along = dict(zip(map(id, rough), found[count:], strict=True))
    result, pushes_left = [], iter(found[:count])
    for meeting in meetings:
        own = [max(next(pushes_left), 0.0) for _ in meeting.contacts]
        whole, total = along.get(id(meeting), 0.0), math.fsum(own)
        for contact, push in zip(meeting.contacts, own, strict=True):
            result.append((contact, push, whole * push / total if total else 0.0))
    return result


def apply(
    mobility: Mobility,
    impulses: Sequence[tuple[Contact, float, float]],
    states: MutableMapping[int, State],
) -> None:
    """Change the states by impulses along normals and tangents, N s, all at once.

    Sums are rounded once, so that their order does not matter.
    """
    bodies = mobility.reached(contact for contact, *_ in impulses)
    if any(mobility.cores[i].jointed for i in bodies):
        _apply_with_joints(mobility, bodies, impulses, states)
        return
    cores = mobility.cores
    changes: defaultdict[int, list[tuple[Vector, float]]] = defaultdict(list)
    still: Vector = (0.0, 0.0)
    for contact, push, drag in impulses:
        vector = friction.impulse_vector(push, drag, contact.normal)
        a, b = cores[contact.a], cores[contact.b]
        if a.dynamic:
            turn = friction.angular_velocity_a_after(0.0, a.inverse_inertia, contact.arm_a, vector)
            velocity = friction.velocity_a_after(still, a.inverse_mass, vector)
            changes[contact.a].append((velocity, float(turn)))
        if b.dynamic:
            turn = friction.angular_velocity_b_after(0.0, b.inverse_inertia, contact.arm_b, vector)
            velocity = friction.velocity_b_after(still, b.inverse_mass, vector)
            changes[contact.b].append((velocity, float(turn)))
    for body, parts in changes.items():
        (x, y), spin = states[body].velocity, states[body].angular_velocity
        states[body] = states[body]._replace(
            velocity=(
                math.fsum([x, *(change[0] for change, _ in parts)]),
                math.fsum([y, *(change[1] for change, _ in parts)]),
            ),
            angular_velocity=math.fsum([spin, *(turn for _, turn in parts)]),
        )


def _apply_with_joints(
    mobility: Mobility,
    bodies: Sequence[int],
    impulses: Sequence[tuple[Contact, float, float]],
    states: MutableMapping[int, State],
) -> None:
    contacts = [contact for contact, *_ in impulses]
    pushes, drags = np.array([both for _, *both in impulses]).T
    total = pushes @ rows_of(contacts, bodies)
    total += drags @ rows_of([tangent_of(contact) for contact in contacts], bodies)
    change = mobility.moved(total[None], bodies).reshape(-1, 3)
    for body, (x, y, spin) in zip(bodies, change.tolist(), strict=True):
        (u, v), turning = states[body].velocity, states[body].angular_velocity
        states[body] = states[body]._replace(
            velocity=(u + x, v + y), angular_velocity=turning + spin
        )


def _with_friction(
    matrix: Array,
    rates: Array,
    pushes: Array,
    rough: Sequence[Meeting],
    normals: Sequence[Contact],
) -> tuple[Array, Array]:
    """Return the impulses along normals and tangents: friction takes as much energy as it may.

    It leaves the normal velocities of the pressed contacts as they are (IM9), so that a tangential
    impulse changes the normal ones with it.
    """
    count = len(pushes)
    pressed = pushes > 0
    size = np.sqrt(np.diag(matrix))
    inverse = _inverse(matrix[:count, :count][np.ix_(pressed, pressed)], size[:count][pressed])
    across = np.zeros((count, len(rough)))  # what a unit along the tangents takes off the normals
    across[pressed] = inverse @ matrix[:count, count:][pressed]
    across[np.abs(across) <= _PARALLEL] = 0.0  # what takes off nothing, but by rounding
    compression = -inverse @ rates[:count][pressed]
    slip = rates[count:] + matrix[count:, :count][:, pressed] @ compression
    effect = _inverse(matrix[count:, count:] - matrix[count:, :count] @ across, size[count:])
    place = {id(contact): k for k, contact in enumerate(normals)}
    rows, most = [*across[pressed]], [*pushes[pressed]]
    for k, meeting in enumerate(rough):
        own = [place[id(contact)] for contact in meeting.contacts]
        bound = meeting.coefficient * across[own].sum(axis=0)
        for sign in (1.0, -1.0):
            rows.append(bound + sign * np.eye(len(rough))[k])
            most.append(meeting.coefficient * pushes[own].sum())
    limits, most_of = np.array(rows), np.array(most)
    coupled = limits @ effect @ limits.T
    slack = most_of + limits @ effect @ slip
    reach, terms = np.diag(coupled), np.diag(np.abs(limits) @ np.abs(effect) @ np.abs(limits).T)
    far = np.sqrt(np.where(reach > _NEGLIGIBLE * terms, reach, np.inf))  # or it is not reached
    found = lemke(coupled / np.outer(far, far), slack / far)
    if found is None:  # it does not happen to what is convex but by rounding: no friction
        return pushes, np.zeros(len(rough))
    multipliers = found / far
    drags = -effect @ (slip + limits.T @ multipliers)
    return pushes - across @ drags, drags


def _inverse(matrix: Array, size: Array) -> Array:
    """Return the pseudoinverse of couplings, in which light and heavy bodies count alike.

    `size` is the root of what each couples with itself, where nothing holds it.
    """
    scale = np.outer(size, size)
    shares = matrix / scale
    shares[np.abs(shares) <= _PARALLEL] = 0.0  # what is held has none but by rounding
    found = np.asarray(np.linalg.pinv(shares, rcond=_PARALLEL, hermitian=True), float)
    found[np.abs(found) <= _NEGLIGIBLE * np.abs(found).max(initial=0.0)] = 0.0
    return found / scale
