"""Contacts on the list between two steps: those of pairs that go, or may not touch, leave it."""

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.engine.arrays.store import Store
from tamias2d.state import IntArray


class ListedContacts:
    """The contacts that the next step finds on the list."""

    def __init__(self, store: Store) -> None:
        self._store = store
        self._parted: list[tuple[int, int]] = []

    def take_parted(self) -> list[tuple[int, int]]:
        """Return the pairs that left the list since this was asked last, though they touched.

        Those of bodies that left are not among them.
        """
        parted, self._parted = self._parted, []
        return parted

    def drop_pairs(self, pairs: set[tuple[int, int]]) -> None:
        """Take pairs of bodies, the lower row first, out of the list; wake them."""
        if pairs:
            owner = np.sort(self.owners(), axis=1)
            self._part(np.array([tuple(pair) in pairs for pair in owner.tolist()], dtype=bool))

    def drop_filtered(self) -> None:
        """Take pairs out of the list that filters let touch no longer; wake them."""
        self._part(~self._may_touch())

    def drop_bodies(self, leaves: NDArray[np.bool_]) -> None:
        """Take the pairs of bodies that leave (slots,) out of the list; wake others."""
        self._parted = [pair for pair in self._parted if not leaves[[*pair]].any()]
        slots = self._slots()
        leave = leaves[self._store.world.state.body_of_slot]
        self._drop(leave[slots[:, 0]] | leave[slots[:, 1]])

    def owners(self) -> IntArray:
        """Return the bodies (k, 2) of all contacts on the list."""
        return self._store.world.state.body_of_slot[self._slots()].astype(np.int64)

    def _slots(self) -> NDArray[np.uint32]:
        world = self._store.world
        counts = world.broad_phase.counts
        side, size = counts.item(tb.BUFFER), counts.item(tb.CONTACTS)
        return world.buffers.pairs[side, :size, tb.SLOT_A : tb.SLOT_B + 1]

    def _may_touch(self) -> NDArray[np.bool_]:
        """Return which contacts (k,) on the list are of shapes that filters let touch (R3)."""
        world = self._store.world
        side, size = world.broad_phase.counts[[tb.BUFFER, tb.CONTACTS]]
        a, b = world.shapes.filters[world.buffers.pairs[side, :size, :2].T.astype(np.int64)]
        group = a[:, tb.GROUP]
        meet = (a[:, tb.CATEGORY] & b[:, tb.MASK] != 0) & (b[:, tb.CATEGORY] & a[:, tb.MASK] != 0)
        found: NDArray[np.bool_] = np.where(
            (group == b[:, tb.GROUP]) & (group != 0), group > 0, meet
        )
        return found

    def _part(self, left: NDArray[np.bool_]) -> None:
        """Take contacts (k,) out of the list whose bodies stay; note the pairs that touched."""
        if not left.any():
            return
        world = self._store.world
        side, size = world.broad_phase.counts[[tb.BUFFER, tb.CONTACTS]]
        touched = world.buffers.flags[side, :size, tb.TOUCHES] & tb.IS_TOUCHING != 0
        found = self.owners()[left & touched]
        first = np.unique(np.sort(found, axis=1), axis=0, return_index=True)[1]
        self._parted += map(tuple, found[np.sort(first)].tolist())
        self._drop(left)

    def _drop(self, left: NDArray[np.bool_]) -> None:
        """Take contacts (k,) out of the list, and wake their bodies."""
        if not left.any():
            return
        counts, buffers = self._store.world.broad_phase.counts, self._store.world.buffers
        side, size = counts[tb.BUFFER], counts[tb.CONTACTS]
        points = buffers.flags[side, :size, tb.POINT_COUNT] > 0
        self._store.wake(self.owners()[left & points].ravel())
        first = int(np.argmax(left))  # those before it stay where they are
        kept = first + np.flatnonzero(~left[first:])
        for values in (buffers.pairs, buffers.manifolds, buffers.axes, buffers.flags):
            values[side, first : first + len(kept)] = values[side, kept]
        counts[tb.FIRST_RUN] -= np.count_nonzero(left[: counts[tb.FIRST_RUN]])
        counts[tb.CONTACTS] = first + len(kept)
