"""What touched in the last step: contacts, and pairs that began or ceased to touch.

Serves: games that play sounds or count hits. Hides: where the engine keeps impulses. What goes so
far in a step that it is stopped where it meets something met it *in flight*.
"""

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine.engine import Engine
from tamias2d.engine.tables import (
    BUFFER,
    CONTACTS,
    GAP,
    IMPACT_NORMAL,
    NX,
    NY,
    POINT,
    POINT_COUNT,
    PX,
    PY,
    SLOT_A,
    SLOT_B,
    TOTAL_IMPULSE,
    TOUCHES,
    WORLD_POINT,
)
from tamias2d.state import Array

Whole = NDArray[np.int64]


@dataclass(frozen=True, kw_only=True)
class Contacts:
    """The m points at which bodies pushed each other in the last step, in canonical order."""

    bodies: Whole
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


class _Points(NamedTuple):
    """Points of contact, each by its pair and its number there, with its impulse."""

    pair: Whole
    number: Whole
    impulse: Array


@dataclass(frozen=True, kw_only=True)
class Touching:
    """What touched in a step, and what did not before."""

    contacts: Contacts
    began: Contacts
    """One point for each pair: that with the largest impulse, with the impulse of all of them."""
    ended: Whole
    """(k, 2), indices of bodies"""


def arrays_of(told: Touching) -> dict[str, NDArray[Any]]:
    """Return all of it as arrays by name."""
    points = {"contacts": told.contacts, "began": told.began}
    return {"ended": told.ended} | {
        f"{which}.{field.name}": getattr(found, field.name)
        for which, found in points.items()
        for field in fields(Contacts)
    }


def touching_of(arrays: Mapping[str, NDArray[Any]]) -> Touching:
    """Return what `arrays_of` was given."""
    contacts, began = (
        Contacts(**{field.name: arrays[f"{which}.{field.name}"] for field in fields(Contacts)})
        for which in ("contacts", "began")
    )
    return Touching(contacts=contacts, began=began, ended=arrays["ended"])


def touching(engine: Engine) -> Touching:
    """Return what touched in the last step of a engine."""
    side, size = (
        int(engine.world.broad_phase.counts[BUFFER]),
        int(engine.world.broad_phase.counts[CONTACTS]),
    )
    noted = engine.world.buffers.flags[side, :size, TOUCHES]
    rows = np.flatnonzero(noted)
    bodies = engine.world.state.body_of_slot[
        engine.world.buffers.pairs[side, rows, SLOT_A : SLOT_B + 1]
    ].astype(np.int64)
    code = bodies.min(axis=1) * len(engine.world.state.pose) + bodies.max(axis=1)
    now, before = (np.unique(code[noted[rows] & bit != 0]) for bit in (1, 2))
    touch = engine.world.buffers.manifolds[side, rows]
    count = engine.world.buffers.flags[side, rows, POINT_COUNT].astype(np.int64)
    pushed = _pushed(touch, count, noted[rows].astype(np.int64))
    sensed = np.setdiff1d(np.flatnonzero(noted[rows] & 1), pushed.pair)
    found = _Points(
        np.concatenate((pushed.pair, sensed)),
        np.concatenate((pushed.number, np.zeros_like(sensed))),
        np.concatenate((pushed.impulse, np.zeros(len(sensed)))),
    )
    touch[sensed, WORLD_POINT : WORLD_POINT + 2] = (
        engine.world.state.pose[bodies[sensed, 0], :2] + touch[sensed, PX : PY + 1]
    )
    begun = _strongest(found, code, np.setdiff1d(now, before))
    ended = np.flatnonzero(np.isin(code, np.setdiff1d(before, now)))
    return Touching(
        contacts=_contacts(bodies, touch, count, pushed),
        began=_contacts(bodies, touch, count, begun),
        ended=bodies[np.sort(ended[np.unique(code[ended], return_index=True)[1]])],
    )


def _pushed(touch: Array, count: Whole, noted: Whole) -> _Points:
    """Return all points that were pushed, in the order of the pairs; in flight a pair has one."""
    total = touch[:, [TOTAL_IMPULSE, TOTAL_IMPULSE + POINT]]
    there = np.arange(2) < np.maximum(count, 1)[:, None]
    pair, number = np.nonzero(there & (total > 0.0) & (noted & 1 != 0)[:, None])
    return _Points(pair, number, total[pair, number])


def _strongest(found: _Points, code: Whole, wanted: Whole) -> _Points:
    """Return one point for each wanted pair of bodies, with the sum of their impulses."""
    of = code[found.pair]
    row = np.flatnonzero(np.isin(of, wanted))
    total = np.zeros(len(wanted))
    np.add.at(total, np.searchsorted(wanted, of[row]), found.impulse[row])
    row = row[np.lexsort((row, -found.impulse[row], of[row]))]
    row = row[np.unique(of[row], return_index=True)[1]]
    order = np.argsort(found.pair[row])
    row, total = row[order], total[order]
    return _Points(found.pair[row], found.number[row], total)


def _contacts(bodies: Whole, touch: Array, count: Whole, points: _Points) -> Contacts:
    """Return where points are and what they did."""
    pair, number, impulse = points
    flown = count[pair] == 0
    row = touch[pair]
    at = np.arange(len(pair))
    place = WORLD_POINT + POINT * number
    normal = np.where(
        flown[:, None], row[:, IMPACT_NORMAL : IMPACT_NORMAL + 2], row[:, NX : NY + 1]
    )
    return Contacts(
        bodies=bodies[pair],
        point=np.column_stack((row[at, place], row[at, place + 1])),
        normal=normal,
        impulse=impulse,
        separation=np.where(flown, 0.0, row[at, GAP + POINT * number]),
    )
