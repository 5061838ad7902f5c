"""Contact events: which pairs of bodies began or ceased to touch in the steps of a call.

Serves: the simulator, which takes many steps in a call. Hides: that the engine knows of the last
step alone, and logs those of the steps before; and that a log is read once somebody asks.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.engine.arrays.store import Store
from tamias2d.engine.reports.contact_report import (
    NO_CONTACTS,
    REMEDY,
    Contacts,
    Pairs,
    Points,
    bodies_of,
    contacts_of,
    logged_at,
    told_pairs,
    touches_of,
)
from tamias2d.read_only import read_only
from tamias2d.state import Array, IntArray

_MOST_KEPT = 2**12  # rows of the log, which are four times as long as what is told of them


def pairs_of(bodies: IntArray) -> IntArray:
    """Return the pairs that ceased to touch (k, 2); they become read-only."""
    return read_only(bodies, "pairs that ended", REMEDY)


NO_PAIRS = pairs_of(np.empty((0, 2), dtype=np.int64))
_NOTHING: tuple[tuple[Contacts, ...], tuple[IntArray, ...]] = (), ()


@dataclass(frozen=True, kw_only=True)
class TouchReport:
    """What touched in the last step, and which pairs began and ceased to in a call of steps."""

    contacts: Contacts
    began: Contacts = NO_CONTACTS
    ended: IntArray = field(default_factory=lambda: NO_PAIRS)


class ContactEvents:
    """What began and what ended, step after step; a pair does either once a step."""

    def __init__(self) -> None:
        """Begin with none."""
        self._steps = 0
        self._forget()

    def begin(self, steps: int) -> None:
        """Forget all events; those of the steps after so many are wanted."""
        self._steps = steps
        if self._base:
            self._forget()

    def _forget(self) -> None:
        self._began, self._ended = _NOTHING
        self._logged: list[IntArray] = []
        self._manifolds: list[Array] = []
        self._base = self._rows = 0

    def ask(self, store: Store) -> None:
        """Let the steps that follow log their events, until these are taken."""
        store.world.control.counts[tb.EVENTS_TOLD] = 1
        store.world.log.counts[:] = 0

    def take(self, store: Store, steps: int) -> None:
        """Take what was logged of steps that led to so many; the log is empty then."""
        self._steps = steps
        log, counts = store.world.log, store.world.log.counts
        if size := int(counts[tb.LOGGED]):
            self._keep(log.rows[:size].copy(), log.manifolds[:size].copy())
        if counts[tb.LOG_FULL]:
            self._look(store)
        counts[tb.LOGGED] = counts[tb.LOG_FULL] = store.world.control.counts[tb.EVENTS_TOLD] = 0

    def tell_parted(self, pairs: Sequence[tuple[int, int]]) -> None:
        """Tell pairs that touched and may no longer as ended in the step that follows."""
        self._tell()
        self._ended = (*self._ended, np.array(pairs, dtype=np.int64).reshape(-1, 2))
        self._base += 1

    def note(self, store: Store, steps: int) -> None:
        """Note the events of the last of so many steps, unless they are known."""
        if steps != self._steps:
            self._steps = steps
            self._look(store)

    def _look(self, store: Store) -> None:
        """Find the events of the last step where contacts are."""
        touches = touches_of(store)
        changed = np.flatnonzero((touches ^ (touches >> 1)) & tb.IS_TOUCHING)
        if len(changed):
            rows = np.flatnonzero(touches)
            code = _codes(bodies_of(store, rows), store.size)
            wanted = np.unique(code[np.searchsorted(rows, changed)])
            self._keep(*logged_at(store, rows[_is_in(code, wanted)]))

    def _keep(self, logged: IntArray, manifolds: Array) -> None:
        """Keep rows of the log, whose steps come after all that are kept."""
        logged[:, tb.LOG_STEP] += self._base - logged[0, tb.LOG_STEP]
        self._base = int(logged[-1, tb.LOG_STEP]) + 1
        self._logged.append(logged)
        self._manifolds.append(manifolds)
        self._rows += len(logged)
        if self._rows > _MOST_KEPT:
            self._tell()

    def _tell(self) -> None:
        """Add what is kept to what is told."""
        if not self._logged:
            return
        began, ended = _events(np.concatenate(self._logged), np.concatenate(self._manifolds))
        self._began, self._ended = (*self._began, began), (*self._ended, ended)
        self._logged, self._manifolds, self._rows = [], [], 0

    @property
    def began(self) -> Contacts:
        """One point for each pair: that with the largest impulse, with the impulses of all."""
        self._tell()
        if not any(map(len, self._began)):
            return NO_CONTACTS
        columns = zip(*(vars(each).values() for each in self._began), strict=True)
        return contacts_of(map(np.concatenate, columns))

    @property
    def ended(self) -> IntArray:
        """(k, 2), indices of bodies"""
        self._tell()
        return pairs_of(np.concatenate(self._ended)) if any(map(len, self._ended)) else NO_PAIRS


def _events(logged: IntArray, manifolds: Array) -> tuple[Contacts, IntArray]:
    """Return what began and ended by rows of the log, step after step."""
    order = np.lexsort((logged[:, tb.LOG_PLACE], logged[:, tb.LOG_STEP]))
    logged = logged[order]
    pairs = told_pairs(logged, manifolds[order])
    step, size = logged[:, tb.LOG_STEP], int(pairs.bodies.max()) + 1
    code = step * size**2 + _codes(pairs.bodies, size)
    now, before = (pairs.touches & bit != 0 for bit in (tb.IS_TOUCHING, tb.WAS_TOUCHING))
    began = pairs.contacts(
        _strongest(_with_unpushed(pairs, now), code, _only_in(code, now, before))
    )
    ended = np.flatnonzero(_is_in(code, _only_in(code, before, now)))
    ended = np.sort(ended[np.unique(code[ended], return_index=True)[1]])
    return began, pairs.bodies[ended]


def _codes(bodies: IntArray, size: int) -> IntArray:
    """Return a number for each pair of bodies (k, 2) of so many, whichever comes first."""
    codes: IntArray = np.minimum(*bodies.T) * size + np.maximum(*bodies.T)
    return codes


def _with_unpushed(pairs: Pairs, now: NDArray[np.bool_]) -> Points:
    """Return the points of pairs, of one that touched without a push, as a sensor does, the first.

    Where that is and along which normal, is written to the pairs; of one without points, which met
    in flight, it stands there.
    """
    pushed = pairs.pushed()
    unpushed = now.copy()
    unpushed[pushed.pair] = False
    sensed = np.flatnonzero(unpushed)
    found = pairs.manifold
    met = sensed[pairs.points[sensed] == 0]
    pairs.normal[met] = found[met, tb.IMPACT_NORMAL : tb.IMPACT_NORMAL + 2]
    overlapped = sensed[pairs.points[sensed] > 0]
    pairs.normal[overlapped] = found[overlapped, tb.NX : tb.NY + 1]
    found[overlapped, tb.WORLD_POINT : tb.WORLD_POINT + 2] = (
        found[overlapped, tb.LOG_PLACE_A : tb.LOG_PLACE_A + 2]
        + found[overlapped, tb.PX : tb.PY + 1]
    )
    return Points(
        np.concatenate((pushed.pair, sensed)),
        np.concatenate((pushed.number, np.zeros_like(sensed))),
        np.concatenate((pushed.impulse, np.zeros(len(sensed)))),
        np.concatenate((pushed.friction, np.zeros((len(sensed), 2)))),
    )


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


def _strongest(found: Points, code: IntArray, wanted: IntArray) -> Points:
    """Return one point for each wanted pair of bodies, sorted, with the sums of its impulses."""
    of = code[found.pair]
    row = np.flatnonzero(_is_in(of, wanted))
    total, friction = np.zeros(len(wanted)), np.zeros((len(wanted), 2))
    place = np.searchsorted(wanted, of[row])
    np.add.at(total, place, found.impulse[row])
    np.add.at(friction, place, found.friction[row])
    row = row[np.lexsort((row, -found.impulse[row], of[row]))]
    row = row[np.unique(of[row], return_index=True)[1]]
    order = np.argsort(found.pair[row])
    row, total, friction = row[order], total[order], friction[order]
    return Points(found.pair[row], found.number[row], total, friction)
