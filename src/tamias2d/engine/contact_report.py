"""The contact report: what touched in the last step, and which pairs began or ceased to touch.

A body that goes so far in a step that it is stopped where it meets another met it *in flight*.
"""

from collections.abc import Iterable
from dataclasses import dataclass, fields
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.engine.store import Store
from tamias2d.read_only import read_only
from tamias2d.state import Array, IntArray


@dataclass(frozen=True, kw_only=True)
class Contacts:
    """The m points at which bodies pushed each other in the last step, in canonical order."""

    bodies: IntArray
    """(m, 2), indices of bodies A and B"""
    point: Array
    """(m, 2), where they touched as the step began or, in flight, as they met, m"""
    normal: Array
    """(m, 2), unit, from A to B"""
    impulse: Array
    """(m,), along the normal, on B, over the whole step, N s"""
    separation: Array
    """(m,), there, m; negative where they overlapped, 0 in flight"""

    def __len__(self) -> int:
        return len(self.bodies)


_REMEDY = "They tell what a step did: call apply_impulse or apply_force to push bodies."


class _Points(NamedTuple):
    """Points of contact, each by its pair and its number there, with its impulse."""

    pair: IntArray
    number: IntArray
    impulse: Array


@dataclass(frozen=True, kw_only=True)
class Touching:
    """What touched in a step, and which pairs did not before or do not any more."""

    contacts: Contacts
    began: Contacts
    """One point for each pair: that with the largest impulse, with the impulse of all of them."""
    ended: IntArray
    """(k, 2), indices of bodies"""


def contact_report(store: Store) -> Touching:
    """Return what touched in the last step."""
    state, buffers, counts = store.world.state, store.world.buffers, store.world.broad_phase.counts
    side, size = int(counts[tb.BUFFER]), int(counts[tb.CONTACTS])
    rows = np.flatnonzero(buffers.flags[side, :size, tb.TOUCHES])
    if len(rows) == 0:
        return _NOTHING
    flags, found = buffers.flags[side, rows].astype(np.int64), buffers.manifolds[side, rows]
    bodies = state.body_of_slot[buffers.pairs[side, rows, tb.SLOT_A : tb.SLOT_B + 1]].astype(
        np.int64
    )
    code = np.minimum(*bodies.T) * len(state.pose) + np.maximum(*bodies.T)
    bits = flags[:, tb.TOUCHES]
    now, before = bits & tb.IS_TOUCHING != 0, bits & tb.WAS_TOUCHING != 0
    count = flags[:, tb.POINT_COUNT]
    split = store.world.control.counts[tb.FINEST] > 0
    normal, impulse = _impulses(found, count, split=split)
    impulse[flags[:, tb.SENSES] == 1] = 0.0  # nothing is written there: a sensor pushes nothing
    pair, number = np.nonzero((impulse > 0.0) & now[:, None])
    pushed = _Points(pair, number, impulse[pair, number])
    unpushed = now.copy()
    unpushed[pair] = False
    sensed = np.flatnonzero(unpushed)
    points = _Points(
        np.concatenate((pushed.pair, sensed)),
        np.concatenate((pushed.number, np.zeros_like(sensed))),
        np.concatenate((pushed.impulse, np.zeros(len(sensed)))),
    )
    normal[sensed] = found[sensed, tb.NX : tb.NY + 1]
    found[sensed, tb.WORLD_POINT : tb.WORLD_POINT + 2] = (
        state.pose[bodies[sensed, 0], :2] + found[sensed, tb.PX : tb.PY + 1]
    )
    begun = _strongest(points, code, _only_in(code, now, before))
    ended = np.flatnonzero(_is_in(code, _only_in(code, before, now)))
    ended = np.sort(ended[np.unique(code[ended], return_index=True)[1]])
    return Touching(
        contacts=_contacts(bodies, found, count, normal, pushed),
        began=_contacts(bodies, found, count, normal, begun),
        ended=pairs_of(bodies[ended]),
    )


def _impulses(touch: Array, count: IntArray, *, split: bool) -> tuple[Array, Array]:
    """Return the normals (m, 2) along which pairs pushed each other, and impulses at two points.

    In flight and over the parts of a step they pushed each other as one, by a sum of vectors.
    """
    totals = touch[:, [tb.TOTAL_IMPULSE, tb.TOTAL_IMPULSE + tb.POINT]]
    push = touch[:, tb.PUSH : tb.PUSH + 2] if split else touch[:, [tb.PART_PUSH_X, tb.PART_PUSH_Y]]
    as_one = split | (count == 0)
    size = np.hypot(push[:, 0], push[:, 1])
    along = push / np.where(size > 0.0, size, 1.0)[:, None]
    normal = np.where(as_one[:, None], along, touch[:, tb.NX : tb.NY + 1])
    second = np.where(count == 2, totals[:, 1], 0.0)
    first = np.where(as_one, size, totals[:, 0])
    return normal, np.column_stack((first, np.where(as_one, 0.0, second)))


def _only_in(code: IntArray, one: NDArray[np.bool_], other: NDArray[np.bool_]) -> IntArray:
    """Return the codes (k,) of contacts of one kind that none of the other kind has, sorted.

    In most steps there is none, and no contact of one kind alone.
    """
    found = np.sort(code[one & ~other])
    if len(found) == 0:
        return found
    found = found[np.diff(found, prepend=-1) > 0]
    return found[~_is_in(found, np.sort(code[other]))]


def _is_in(codes: IntArray, wanted: IntArray) -> NDArray[np.bool_]:
    """Return which codes (k,) are among the wanted ones, which are sorted."""
    if len(wanted) == 0:
        return np.zeros(len(codes), dtype=bool)
    place = np.minimum(np.searchsorted(wanted, codes), len(wanted) - 1)
    found: NDArray[np.bool_] = wanted[place] == codes
    return found


def _strongest(found: _Points, code: IntArray, wanted: IntArray) -> _Points:
    """Return one point for each wanted pair of bodies, sorted, with the sum of its impulses."""
    of = code[found.pair]
    row = np.flatnonzero(_is_in(of, wanted))
    total = np.zeros(len(wanted))
    np.add.at(total, np.searchsorted(wanted, of[row]), found.impulse[row])
    row = row[np.lexsort((row, -found.impulse[row], of[row]))]
    row = row[np.unique(of[row], return_index=True)[1]]
    order = np.argsort(found.pair[row])
    row, total = row[order], total[order]
    return _Points(found.pair[row], found.number[row], total)


def _contacts(
    bodies: IntArray, touch: Array, count: IntArray, normal: Array, points: _Points
) -> Contacts:
    """Return where points are, and their impulses."""
    pair, number, impulse = points
    row = touch[pair]
    at = np.arange(len(pair))
    place = tb.WORLD_POINT + tb.POINT * number
    point = np.column_stack((row[at, place], row[at, place + 1]))
    separation = np.where(count[pair] == 0, 0.0, row[at, tb.GAP + tb.POINT * number])
    return contacts_of((bodies[pair], point, normal[pair], impulse, separation))


def contacts_of(columns: Iterable[NDArray[Any]]) -> Contacts:
    """Return the contacts with these columns, in the order of the fields; they become read-only."""
    names = (field.name for field in fields(Contacts))
    return Contacts(
        **{
            name: read_only(values, f"{name} of the contacts", _REMEDY)
            for name, values in zip(names, columns, strict=True)
        }
    )


def pairs_of(bodies: IntArray) -> IntArray:
    """Return the pairs that ceased to touch (k, 2); they become read-only."""
    return read_only(bodies, "pairs that ended", _REMEDY)


def _nothing() -> Contacts:
    none = np.empty(0)
    pairs = np.empty((0, 2), dtype=np.int64)
    return contacts_of((pairs, np.empty((0, 2)), np.empty((0, 2)), none, none))


_NOTHING = Touching(
    contacts=_nothing(), began=_nothing(), ended=pairs_of(np.empty((0, 2), dtype=np.int64))
)
"""Made once, because most steps of a scene without piles have it."""
