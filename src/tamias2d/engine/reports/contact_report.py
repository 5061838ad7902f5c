"""The contact report: what touched in the last step.

A body that goes so far in a step that it is stopped where it meets another met it *in flight*.
"""

from collections.abc import Iterable
from dataclasses import dataclass, fields
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.engine.arrays.store import Store
from tamias2d.read_only import read_only
from tamias2d.state import Array, IntArray


@dataclass(frozen=True, kw_only=True)
class Contacts:
    """The m points at which bodies pushed each other in a step, in canonical order."""

    bodies: IntArray
    """(m, 2), indices of bodies A and B"""
    point: Array
    """(m, 2), where they touched as the step began or, in flight, as they met, m"""
    normal: Array
    """(m, 2), unit, from A to B"""
    impulse: Array
    """(m,), along the normal, on B, over that step, N s"""
    friction_impulse: Array
    """(m, 2), by which friction changed the momentum of B in that step, N s"""
    separation: Array
    """(m,), there, m; negative where they overlapped, 0 in flight"""

    def __len__(self) -> int:
        return len(self.bodies)


REMEDY = "They tell what a step did: call apply_impulse or apply_force to push bodies."


class Points(NamedTuple):
    """Points of contact, each by its pair and its number there, with its impulses."""

    pair: IntArray
    number: IntArray
    impulse: Array
    friction: Array
    """(k, 2), N s"""


class Pairs(NamedTuple):
    """What the engine knows of some pairs (k,) of shapes after a step of each."""

    bodies: IntArray
    """(k, 2), indices of bodies A and B"""
    touches: IntArray
    """(k,), bits"""
    points: IntArray
    """(k,), how many there are"""
    normal: Array
    """(k, 2), along which they pushed each other, or touched if they did not"""
    impulse: Array
    """(k, 2), at two points, N s"""
    friction: Array
    """(k, 2, 2), at two points, N s"""
    manifold: Array

    def pushed(self) -> Points:
        """Return the points at which they pushed each other."""
        touching = self.touches & tb.IS_TOUCHING != 0
        pair, number = np.nonzero((self.impulse > 0.0) & touching[:, None])
        return Points(pair, number, self.impulse[pair, number], self.friction[pair, number])

    def contacts(self, points: Points) -> Contacts:
        """Return where points are, and their impulses."""
        pair, number, impulse, friction = points
        row = self.manifold[pair]
        at = np.arange(len(pair))
        place = tb.WORLD_POINT + tb.POINT * number
        point = np.column_stack((row[at, place], row[at, place + 1]))
        gap = np.where(self.points[pair] == 0, 0.0, row[at, tb.GAP + tb.POINT * number])
        normal = self.normal[pair]
        return contacts_of((self.bodies[pair], point, normal, impulse, friction, gap))


def touches_of(store: Store) -> IntArray:
    """Return the bits of all pairs on the contact list that tell whether they touch."""
    counts = store.world.broad_phase.counts
    side, size = counts[tb.BUFFER], counts[tb.CONTACTS]
    return store.world.buffers.flags[side, :size, tb.TOUCHES].astype(np.int64)


def sensed_by(store: Store, body: int) -> IntArray:
    """Return the bodies (k,) that a sensor met in the last step, each as often as shapes did."""
    counts = store.world.broad_phase.counts
    flags = store.world.buffers.flags[counts[tb.BUFFER], : counts[tb.CONTACTS]]
    met = (flags[:, tb.SENSES] == 1) & (flags[:, tb.TOUCHES] & tb.IS_TOUCHING != 0)
    pairs = bodies_of(store, np.flatnonzero(met))
    pairs = pairs[(pairs == body).any(axis=1)]
    return pairs.sum(axis=1) - body


def bodies_of(store: Store, rows: IntArray) -> IntArray:
    """Return the indices of bodies (k, 2) of some pairs on the contact list."""
    world = store.world
    slots = world.buffers.pairs[
        world.broad_phase.counts[tb.BUFFER], rows, tb.SLOT_A : tb.SLOT_B + 1
    ]
    return world.state.body_of_slot[slots].astype(np.int64)


def told_pairs(logged: IntArray, manifolds: Array) -> Pairs:
    """Return what rows of a contact log tell."""
    count = logged[:, tb.LOG_POINTS]
    split = logged[:, tb.LOG_SPLIT] == 1
    normal, impulse = _impulses(manifolds, count, split)
    impulse[logged[:, tb.LOG_SENSES] == 1] = 0.0  # nothing is written there: sensors push nothing
    friction = _friction(manifolds, count, split)
    bodies = logged[:, tb.LOG_A : tb.LOG_B + 1]
    return Pairs(bodies, logged[:, tb.LOG_TOUCHES], count, normal, impulse, friction, manifolds)


def logged_at(store: Store, rows: IntArray) -> tuple[IntArray, Array]:
    """Return what a contact log would hold of contacts on the list after the last step."""
    world = store.world
    side = world.broad_phase.counts[tb.BUFFER]
    logged = np.zeros((len(rows), world.log.rows.shape[1]), dtype=np.int64)
    logged[:, tb.LOG_PLACE] = rows
    logged[:, tb.LOG_A : tb.LOG_B + 1] = bodies = bodies_of(store, rows)
    flags = world.buffers.flags[side, rows]
    for column, flag in _LOGGED.items():
        logged[:, column] = flags[:, flag]
    manifolds = world.buffers.manifolds[side, rows]
    return logged, np.hstack((manifolds, world.state.pose[bodies[:, 0], :2]))


_LOGGED = {
    tb.LOG_TOUCHES: tb.TOUCHES,
    tb.LOG_POINTS: tb.POINT_COUNT,
    tb.LOG_SENSES: tb.SENSES,
    tb.LOG_SPLIT: tb.IN_PARTS,
}


def contact_report(store: Store) -> Contacts:
    """Return what touched in the last step."""
    rows = np.flatnonzero(touches_of(store) & tb.IS_TOUCHING)
    if len(rows) == 0:
        return NO_CONTACTS
    pairs = told_pairs(*logged_at(store, rows))
    return pairs.contacts(pairs.pushed())


def _impulses(touch: Array, count: IntArray, split: NDArray[np.bool_]) -> tuple[Array, Array]:
    """Return the normals (m, 2) along which pairs pushed each other, and impulses at two points.

    In flight and over the parts of a step they pushed each other as one, by a sum of vectors.
    """
    totals = touch[:, [tb.TOTAL_IMPULSE, tb.TOTAL_IMPULSE + tb.POINT]]
    push = touch[:, [tb.PART_PUSH_X, tb.PART_PUSH_Y]]
    push = np.where(split[:, None], touch[:, tb.PUSH : tb.PUSH + 2], push)
    as_one = split | (count == 0)
    size = np.hypot(push[:, 0], push[:, 1])
    along = push / np.where(size > 0.0, size, 1.0)[:, None]
    normal = np.where(as_one[:, None], along, touch[:, tb.NX : tb.NY + 1])
    second = np.where(count == 2, totals[:, 1], 0.0)
    first = np.where(as_one, size, totals[:, 0])
    return normal, np.column_stack((first, np.where(as_one, 0.0, second)))


def _friction(touch: Array, count: IntArray, split: NDArray[np.bool_]) -> Array:
    """Return what friction gave at two points of pairs (m, 2, 2); likewise."""
    part = touch[:, [tb.PART_FRICTION_X, tb.PART_FRICTION_Y]]
    before = touch[:, tb.FRICTION_BEFORE : tb.FRICTION_BEFORE + 2]
    whole = np.where(split[:, None], before, part)
    tangent = np.column_stack((-touch[:, tb.NY], touch[:, tb.NX]))
    of_points = part[:, :, None] * tangent[:, None, :]
    of_points[count < 2, 1] = 0.0
    as_one = split | (count == 0)
    of_points[as_one] = 0.0
    of_points[as_one, 0] = whole[as_one]
    return of_points


def contacts_of(columns: Iterable[NDArray[Any]]) -> Contacts:
    """Return the contacts with these columns, in the order of the fields; they become read-only."""
    names = (field.name for field in fields(Contacts))
    return Contacts(
        **{
            name: read_only(values, f"{name} of the contacts", REMEDY)
            for name, values in zip(names, columns, strict=True)
        }
    )


def _nothing() -> Contacts:
    none = np.empty(0)
    pairs = np.empty((0, 2), dtype=np.int64)
    vectors = np.empty((0, 2))
    return contacts_of((pairs, vectors, vectors.copy(), none, vectors.copy(), none.copy()))


NO_CONTACTS = _nothing()
"""Made once, because most steps of a scene without piles have it."""
