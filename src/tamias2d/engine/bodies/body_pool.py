"""The body pool: which rows hold which bodies, and their canonical order.

The row of a body is its index, and stays it. Bodies are ordered by when they first take part in a
step, and those that do so together as `canonical_order` says; bodies and shapes lie in that order
where the engine works. Cost: few calls of numpy to add or remove one body, and to settle what came
and went, arrays as long as the scene.
"""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.engine.arrays.row_index import index_of
from tamias2d.engine.arrays.store import Store
from tamias2d.engine.bodies.batch import Batch
from tamias2d.engine.bodies.canonical_order import in_order
from tamias2d.engine.bodies.carried_touch import CarriedTouch
from tamias2d.engine.bodies.listed_contacts import ListedContacts
from tamias2d.engine.motion.propagators import Propagators
from tamias2d.engine.shapes.shape_form import Form, form_of
from tamias2d.engine.shapes.shape_pool import ShapePool, by_shapes
from tamias2d.engine.shapes.stated_surfaces import UNSTATED, state_surfaces
from tamias2d.scene.compound import Shape
from tamias2d.state import Array, IntArray

_EXTENTS = slice(tb.BOUNDING_RADIUS, tb.CORE_RADIUS + 1)  # of the properties


class _New(NamedTuple):
    """A body without a rank."""

    form: Form
    shapes: list[int]
    """in the order of its parts"""


class BodyPool:
    """The taken and the free rows of an engine."""

    def __init__(self, store: Store, rank: IntArray, generation: IntArray) -> None:
        """Find what a store holds; its bodies have these ranks and generations (n,)."""
        self.store = store
        self.rank = rank
        """(n,), place of each body in the canonical order; -1 for one that is absent or new"""
        self.generation = generation
        """(n,), how many bodies each row has held so far, one that is there included"""
        absent = np.flatnonzero(store.world.state.kind[: store.size] == tb.ABSENT)
        self._free: list[int] = absent[::-1].tolist()
        self._shapes = ShapePool(store)
        self._contacts = ListedContacts(store)
        self._order = self._ranked_shapes()
        self._new: dict[int, _New] = {}  # bodies without a rank
        self._leaving: list[int] = []  # removed since the pool was settled
        self._refiltered = False  # whether filters were changed since then
        self._propagators = Propagators(store)

    def add(self, batch: Batch) -> IntArray:
        """Add the bodies of a batch, and return their rows (k,)."""
        rows, forms = self._take(len(batch)), [*map(form_of, batch.shapes)]
        state, at = self.store.world.state, index_of(rows)
        state.pose[at], state.velocity[at], state.load[at] = batch.pose, batch.motion, batch.load
        state.properties[at, : tb.JOINED] = self._properties(batch, forms)
        state.kind[at] = batch.kind
        self.generation[at] += 1
        places = self._shapes.add(rows, forms, batch.surfaces, batch.filters)
        self._new.update(zip(rows, map(_New, forms, places), strict=True))
        self.store.forget_pairs()
        return np.array(rows, dtype=np.int64)

    def _properties(self, batch: Batch, forms: Sequence[Form]) -> Array:
        """Return the columns of properties of new bodies, but for the last one."""
        masses = batch.masses.tolist()
        propagators = self._propagators.rows_of([(rate, spin) for _, _, rate, spin in masses])
        rows = [
            (1.0 / mass, 1.0 / inertia, *form.extents, row)
            for (mass, inertia, *_), form, row in zip(masses, forms, propagators, strict=True)
        ]
        return np.array(rows).reshape(-1, tb.JOINED)

    def remove(self, rows: IntArray) -> None:
        """Take bodies out; their rows are free once the pool is settled, all others stay.

        They move no more, and are pushed by nothing: what is set of that from now on is told.
        """
        state, gone = self.store.world.state, rows.tolist()
        at = index_of(gone)
        state.kind[at], state.velocity[at], state.load[at] = tb.ABSENT, 0.0, 0.0
        self._leaving += gone
        for row in gone:
            self._new.pop(row, None)

    def set_filters(self, rows: IntArray, columns: Mapping[int, IntArray]) -> bool:
        """Set columns of the filters of bodies, each (k,); return whether any changed.

        Pairs that may touch no longer leave the list of contacts once the pool is settled.
        """
        table, (shapes, each) = self.store.world.shapes.filters, self._shapes_among(rows)
        before = table[shapes]
        for column, values in columns.items():
            table[shapes, column] = values[each]
        changed = self._begin_anew_by(shapes[(table[shapes] != before).any(axis=1)])
        self._refiltered |= changed
        return changed

    def set_surfaces(self, rows: IntArray, columns: Mapping[int, Array]) -> bool:
        """State columns of the material of bodies, each (k,); return whether any changed.

        What parts state themselves stays.
        """
        shapes, each = self._shapes_among(rows)
        own = {column: values[each] for column, values in columns.items()}
        return self._state_surfaces(shapes, own, tb.BY_BODY)

    def set_part_surfaces(
        self, rows: IntArray, parts: IntArray, columns: Mapping[int, Array]
    ) -> bool:
        """State columns of the material of a part of each body (k,); return whether any changed.

        The pool has settled.
        """
        order, first, _ = self._parts_of(rows)
        return self._state_surfaces(order[first + parts], columns, tb.BY_PART)

    def count_parts(self, rows: IntArray) -> IntArray:
        """Return how many parts bodies have (k,), 0 for those that are of one piece, or chains."""
        order, first, count = self._parts_of(rows)
        shapes = self.store.world.shapes
        found = order[np.where(count > 0, first, 0)]
        single = (count == 1) & (shapes.stated[found, tb.BY_PART : tb.BY_BODY] < 0.0).all(axis=1)
        return np.where(single | (shapes.kind[found] >= tb.PIECE), 0, count)

    def _parts_of(self, rows: IntArray) -> tuple[IntArray, IntArray, IntArray]:
        """Return shapes in the order of bodies, and where those of some begin, and how many."""
        owner = self.store.world.state.body_of_shape
        order = np.argsort(owner, kind="stable")
        first, last = (np.searchsorted(owner[order], rows, side) for side in ("left", "right"))
        return order, first, last - first

    def _state_surfaces(self, shapes: IntArray, columns: Mapping[int, Array], by: int) -> bool:
        changed = shapes[state_surfaces(self.store.world.shapes, shapes, columns, by)]
        return self._begin_anew_by(changed)

    def set_masses(self, rows: IntArray, columns: Mapping[int, Array], rates: Array) -> None:
        """Set inverse masses and inertias by columns, each (k,), and rates of drag (k, 2), 1/s."""
        for column, values in columns.items():
            self.store.world.state.properties[rows, column] = values
        self._propagators.assign(rows, rates)
        self._propagators.forget_unused()
        self.store.copy_to_slots(rows)
        self.store.world.touching.counts[[tb.ARRANGED, tb.ISLANDS_KNOWN]] = 0  # knows masses
        self.store.wake(rows)
        self.store.revision += 1

    def set_shapes(self, rows: IntArray, shapes: Sequence[Shape]) -> None:
        """Give bodies (k,) that have shapes others, each once; all else of them stays.

        The pool has settled. What touched them does not begin to anew.
        """
        touch, stated = (
            CarriedTouch(self.store, self._contacts.owners(), rows),
            self._stated_pairs(),
        )
        self.store.wake(touch.beside)
        self.store.set_pair_overrides(np.zeros((0, 4)))
        state, table = self.store.world.state, self.store.world.shapes
        changed = self._marked(rows)
        old = np.flatnonzero(changed[state.body_of_shape])
        of, at = np.unique(state.body_of_shape[old], return_index=True)
        first = old[at][np.searchsorted(of, rows)]
        speeds, filters = table.material[first, tb.SURFACE_SPEED], table.filters[first]
        surfaces = np.column_stack((table.stated[first, tb.BY_BODY :], speeds))
        self._shapes.free(changed)
        forms = [*map(form_of, shapes)]
        extents = np.array([form.extents for form in forms]).reshape(-1, 3)
        state.properties[rows, _EXTENTS] = extents
        added = self._shapes.add(rows.tolist(), forms, surfaces, filters)
        self._shapes.arrange(np.array([place for each in added for place in each], dtype=np.int64))
        self._order = self._ranked_shapes()
        self.publish_order()
        self.store.copy_to_slots(rows)
        self._state_pairs(stated)
        touch.carry()
        self._begin_anew(rows)

    def _begin_anew_by(self, shapes: IntArray) -> bool:
        """Let the bodies of shapes that changed begin to touch anew; return whether there are."""
        if len(shapes):
            owner = self.store.world.state.body_of_shape
            self._begin_anew(np.unique(owner[shapes]).astype(np.int64))
        return len(shapes) > 0

    def _shapes_among(self, rows: IntArray) -> tuple[IntArray, IntArray]:
        """Return the shapes of bodies (k,), and of each the last place of its body among them."""
        state = self.store.world.state
        owner, place = state.body_of_shape, np.full(len(state.kind), -1)
        place[rows] = np.arange(len(rows))
        shapes = np.flatnonzero(place[owner] >= 0)
        return shapes, place[owner[shapes]]

    def _begin_anew(self, rows: IntArray) -> None:
        """Let bodies touch others as if they were new: they wake, and wake what they touch."""
        state, links = self.store.world.state, self.store.world.islands.links
        self.store.wake(rows)
        still = rows[state.kind[rows] != tb.DYNAMIC]
        links[state.slot_of_body[still], tb.SLOW_STEPS] = 0
        self.store.forget_pairs()

    def override_pairs(
        self,
        friction: Mapping[tuple[int, int], float],
        restitution: Mapping[tuple[int, int], float],
    ) -> None:
        """Set the friction and restitution of pairs of bodies, given by rows."""
        self._state_pairs(
            {
                pair: (friction.get(pair, UNSTATED), restitution.get(pair, UNSTATED))
                for pair in sorted({*friction, *restitution})
            }
        )
        self.store.forget_pairs()

    def _state_pairs(self, stated: Mapping[tuple[int, int], tuple[float, float]]) -> None:
        """Set the friction and restitution of pairs of bodies for all pairs of their shapes."""
        rows = [
            (*sorted((s, t)), *values)
            for pair, values in stated.items()
            for s in self._shapes_of(pair[0])
            for t in self._shapes_of(pair[1])
        ]
        self.store.set_pair_overrides(by_shapes(np.array(rows, dtype=np.float64).reshape(-1, 4)))

    def _stated_pairs(self) -> dict[tuple[int, int], tuple[float, float]]:
        """Return the friction and restitution that are set for pairs of bodies."""
        rows = self.store.world.shapes.pair_overrides
        owners = self.store.world.state.body_of_shape[rows[:, :2].astype(np.int64)]
        return {
            (a, b): (friction, restitution)
            for (a, b), (friction, restitution) in zip(
                owners.tolist(), rows[:, 2:].tolist(), strict=True
            )
        }

    def settle(self) -> None:
        """Let go of what was removed or may touch no longer, and give all that is new its rank."""
        if self._refiltered:
            self._contacts.drop_filtered()
            self._refiltered = False
        if not (self._leaving or self._new):
            return
        gone, new = np.array(self._leaving, dtype=np.int64), np.array([*self._new], dtype=np.int64)
        if len(gone):
            self._let_go(gone)
            self._leaving.clear()
            self._propagators.forget_unused()
        if len(new):
            self._assign_ranks(new)
            self._new.clear()
        self.store.copy_to_slots(np.concatenate((gone, new)))
        self.publish_order()
        self.store.forget_pairs()

    def publish_order(self) -> None:
        """Tell the engine the order of its shapes; those without a body come last."""
        canonical = self.store.world.broad_phase.canonical
        size, ranked = canonical.shape[1], len(self._order)
        rest = np.ones(size, dtype=bool)
        rest[self._order] = False
        canonical[tb.SHAPE_OF_RANK, :ranked] = self._order
        canonical[tb.SHAPE_OF_RANK, ranked:] = np.flatnonzero(rest)
        canonical[tb.RANK, canonical[tb.SHAPE_OF_RANK]] = np.arange(size)

    def drop_pairs(self, pairs: set[tuple[int, int]]) -> None:
        """Take pairs of bodies, the lower row first, out of the list of contacts; wake them."""
        self._contacts.drop_pairs(pairs)

    def take_parted(self) -> list[tuple[int, int]]:
        """Return the pairs of bodies that touched and may no longer, since this was asked last."""
        return self._contacts.take_parted()

    # -- rows

    def _take(self, count: int) -> list[int]:
        """Return rows for so many bodies, freed ones first."""
        store = self.store
        used = [self._free.pop() for _ in range(min(count, len(self._free)))]
        more = count - len(used)
        if more:
            store.reserve(more)
            used += range(store.size, store.size + more)
            store.size += more
            self.rank = np.concatenate((self.rank, np.full(more, -1)))
            self.generation = np.concatenate((self.generation, np.zeros(more, dtype=np.int64)))
        return used

    def _shapes_of(self, row: int) -> list[int]:
        found: list[int] = np.flatnonzero(self.store.world.state.body_of_shape == row).tolist()
        return found

    def _marked(self, rows: IntArray) -> NDArray[np.bool_]:
        """Return of all slots whether they are those of some bodies."""
        marked = np.zeros(len(self.store.world.state.kind), dtype=bool)
        marked[rows] = True
        return marked

    # -- removing

    def _let_go(self, rows: IntArray) -> None:
        leaves = self._marked(rows)
        self._contacts.drop_bodies(leaves)
        self._drop_overrides(leaves)
        freed = self._shapes.free(leaves)
        stay = np.ones(len(self.store.world.state.body_of_shape), dtype=bool)
        stay[freed] = False
        self._order = self._order[stay[self._order]]
        self.store.clear(rows)
        self.rank[rows] = -1
        self._free = sorted({*self._free, *rows.tolist()}, reverse=True)

    def _drop_overrides(self, leaves: NDArray[np.bool_]) -> None:
        """Forget what was set for pairs of bodies of which one leaves."""
        overrides = self.store.world.shapes.pair_overrides
        if len(overrides):
            owner = self.store.world.state.body_of_shape[overrides[:, :2].astype(np.int64)]
            self.store.set_pair_overrides(overrides[~leaves[owner].any(axis=1)])

    # -- canonical order

    def _ranked_shapes(self) -> IntArray:
        """Return the shapes of bodies that have a rank, in canonical order."""
        owner = self.store.world.state.body_of_shape
        rank = np.concatenate((self.rank, np.full(len(self.store.world.state.kind), -1)))[owner]
        found = np.flatnonzero(rank >= 0)
        return found[np.argsort(rank[found], kind="stable")]

    def _assign_ranks(self, rows: IntArray) -> None:
        """Order new bodies by what and where they are, and give them and their shapes places."""
        store, state = self.store, self.store.world.state
        shapes = [place for new in self._new.values() for place in new.shapes]
        owned = np.array(shapes, dtype=np.int64)
        forms = [new.form.numbers for new in self._new.values()]
        sequence = in_order(store.world, rows, owned, forms)
        first = int(self.rank.max(initial=-1)) + 1
        self.rank[sequence] = np.arange(first, first + len(rows))
        if len(rows) > 1:
            store.assign_slots(sequence, np.sort(state.slot_of_body[rows]))
            owned = owned[np.argsort(self.rank[state.body_of_shape[owned]], kind="stable")]
        self._order = np.concatenate((self._order, self._shapes.arrange(owned)))
