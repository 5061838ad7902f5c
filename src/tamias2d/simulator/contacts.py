"""What touched in the last step: contacts, and pairs that began or ceased to touch.

Serves: games that play sounds or count hits. Hides: where the engine keeps impulses.
"""

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tamias2d.state import Array
from tamias2d.stepped.layout import BLOCKS, DX, DY, GAP, NX, NY, PAIRS, POINT, PX, PY, SIDE, TOUCHED
from tamias2d.stepped.rows import FILLED, LANES, P_TOTAL, POINTS, SHARED, SIZE, SLOT
from tamias2d.stepped.world import World

Whole = NDArray[np.int64]


@dataclass(frozen=True, kw_only=True)
class Contacts:
    """The m points at which bodies pushed each other in the last step, in canonical order."""

    bodies: Whole
    """(m, 2), indices of bodies A and B"""
    point: Array
    """(m, 2), where they touched as the step began, m"""
    normal: Array
    """(m, 2), unit, from A to B"""
    impulse: Array
    """(m,), along the normal, on B, over the whole step, N s"""
    separation: Array
    """(m,), as the step began, m; negative where they overlapped"""

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


def touching(world: World) -> Touching:
    """Return what touched in the last step of a world."""
    side, size = int(world.counts[SIDE]), int(world.counts[PAIRS])
    bodies = world.shape_body[world.pairs[side, :size]].astype(np.int64).reshape(-1, 2)
    code = bodies.min(axis=1) * len(world.pose) + bodies.max(axis=1)
    noted = world.traces[side, :size, TOUCHED]
    if not noted.any():
        bodies, code, noted = bodies[:0], code[:0], noted[:0]
    now, before = (np.unique(code[noted & bit != 0]) for bit in (1, 2))
    pushed = _pushed(world)
    sensed = np.setdiff1d(np.flatnonzero(noted & 1), pushed.pair)
    found = _Points(
        np.concatenate((pushed.pair, sensed)),
        np.concatenate((pushed.number, np.zeros_like(sensed))),
        np.concatenate((pushed.impulse, np.zeros(len(sensed)))),
    )
    ended = np.flatnonzero(np.isin(code, np.setdiff1d(before, now)))
    return Touching(
        contacts=_contacts(world, side, bodies, pushed),
        began=_contacts(world, side, bodies, _strongest(found, code, np.setdiff1d(now, before))),
        ended=bodies[np.sort(ended[np.unique(code[ended], return_index=True)[1]])],
    )


def _pushed(world: World) -> _Points:
    """Return all points that were pushed, in the order of the pairs."""
    blocks = int(world.counts[BLOCKS])
    lanes, rows = world.lanes[:blocks].astype(np.int64), world.rows[:blocks]
    lane, point = np.arange(LANES), np.arange(2)[:, None]
    impulse = rows[:, SHARED + P_TOTAL + SIZE * point + lane]
    used = (lane < lanes[:, FILLED, None, None]) & (point < lanes[:, POINTS, None, None])
    block, number, at = np.nonzero(used & (impulse > 0.0))
    pair = lanes[block, SLOT + at]
    order = np.lexsort((number, pair))
    return _Points(pair[order], number[order], impulse[block, number, at][order])


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


def _contacts(world: World, side: int, bodies: Whole, points: _Points) -> Contacts:
    """Return where points are and what they did."""
    pair, number, impulse = points
    touch = world.touches[side, pair]
    row, column = np.arange(len(pair)), POINT * number
    first = bodies[pair, 0]
    begin = world.pose[first, :2] - world.motion[first, DX : DY + 1]
    return Contacts(
        bodies=bodies[pair],
        point=begin + np.column_stack((touch[row, PX + column], touch[row, PY + column])),
        normal=touch[:, [NX, NY]],
        impulse=impulse,
        separation=touch[row, GAP + column],
    )
