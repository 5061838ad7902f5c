"""Touch that is carried over as a body gets other shapes, so that it does not begin anew.

Contacts are those of shapes. Of all that a body has with another one, the one that stays is between
their first shapes; it knows that they touched, and neither where nor how hard. The next step tells
that they ceased to, if they did.
"""

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.engine.arrays.store import Store
from tamias2d.state import IntArray


class CarriedTouch:
    """What some bodies touched in the last step, before they get other shapes."""

    def __init__(self, store: Store, owners: IntArray, rows: IntArray) -> None:
        """Look at the contacts on the list, of bodies `owners` (c, 2), for those of rows (k,)."""
        counts = store.world.broad_phase.counts
        flags = store.world.buffers.flags[counts[tb.BUFFER], : counts[tb.CONTACTS]]
        self._store, self._owners = store, owners
        self._changed = np.isin(owners, rows)
        of_them = self._changed.any(axis=1)
        touched = flags[:, tb.TOUCHES] & tb.IS_TOUCHING != 0
        self._carried = of_them & touched
        self._kept = ~of_them | touched
        self.beside = np.unique(owners[of_them & (flags[:, tb.POINT_COUNT] > 0)])
        """The bodies that have points of contact with them, and they themselves."""

    def carry(self) -> None:
        """Put the contacts between the shapes that there are now on the list, in their order."""
        world = self._store.world
        counts, buffers = world.broad_phase.counts, world.buffers
        if self._kept.all() and not self._carried.any():
            return
        side, size = counts[tb.BUFFER], int(counts[tb.CONTACTS])
        pairs, flags = buffers.pairs[side, :size], buffers.flags[side, :size]
        rank = world.broad_phase.canonical[tb.RANK].astype(np.int64)
        ends = np.where(self._changed, self._first_shapes(rank)[self._owners], pairs[:, :2])
        pairs[self._carried, :2] = ends[self._carried]
        senses = flags[self._carried, tb.SENSES]
        flags[self._carried] = 0
        flags[self._carried, tb.SENSES] = senses
        flags[self._carried, tb.TOUCHES] = tb.IS_TOUCHING
        buffers.axes[side, :size][self._carried] = 0.0
        buffers.manifolds[side, :size][self._carried] = 0.0
        kept = np.flatnonzero(self._kept)
        low, high = rank[pairs[kept, :2].T.astype(np.int64)]
        order = kept[np.unique(low * len(rank) + high, return_index=True)[1]]
        for values in (buffers.pairs, buffers.manifolds, buffers.axes, buffers.flags):
            values[side, : len(order)] = values[side, order]
        counts[tb.CONTACTS] = counts[tb.FIRST_RUN] = len(order)

    def _first_shapes(self, rank: IntArray) -> IntArray:
        """Return the first shape of each body, 0 of one without any."""
        owner = self._store.world.state.body_of_shape
        first = np.zeros(len(self._store.world.state.kind), dtype=np.int64)
        last_first = np.argsort(-rank)
        first[owner[last_first]] = last_first
        return first
