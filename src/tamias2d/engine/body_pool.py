"""The body pool: which rows hold which bodies and shapes, and their canonical order.

The row of a body is its index, and stays it. Bodies are ordered by when they first take part in a
step, and those that do so together by where and what they are, number by number: the order of
adding changes nothing. The order goes along the x axis in strips, and in each of them upwards;
bodies and shapes lie in it where the engine works. Bodies that are equal in all of it can be
swapped without a difference.
"""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.engine.batch import UNSTATED, Batch
from tamias2d.engine.carried_touch import CarriedTouch
from tamias2d.engine.propagators import Propagators
from tamias2d.engine.shape_rows import ShapeRow, numbers_of, shape_rows
from tamias2d.engine.store import Store
from tamias2d.scene.compound import Shape
from tamias2d.state import Array, IntArray

STRIP = 4.0  # median bounding radii of bodies: the width of a strip of the canonical order


class BodyPool:
    """The taken and the free rows of an engine."""

    def __init__(self, store: Store, rank: IntArray, generation: IntArray) -> None:
        """Find what a store holds; its bodies have these ranks and generations (n,)."""
        self.store = store
        self.rank = rank
        """(n,), place of each body in the canonical order; -1 for one that is absent or new"""
        self.generation = generation
        """(n,), how many bodies each row has held so far, one that is there included"""
        state, shapes = store.world.state, store.world.shapes
        self._shapes = int(np.count_nonzero(shapes.vertex_count))  # rows ever taken
        self._vertices = int(shapes.vertex_count.sum())
        absent = np.flatnonzero(state.kind[: store.size] == tb.ABSENT)
        self._free: list[int] = absent[::-1].tolist()
        self._free_shapes: dict[int, list[int]] = {}  # by their number of vertices
        self._free_rows(np.flatnonzero(state.body_of_shape[: self._shapes] == self._idle))
        self._order = self._ranked_shapes()
        self._new: dict[int, int] = {}  # bodies without a rank, and the numbers of their forms
        self._placed: list[int] = []  # shapes of such bodies, of each in their order
        self._form_number: dict[tuple[float, ...], int] = {}  # as they came, since all had ranks
        self._leaving = np.zeros(0, dtype=np.int64)  # removed since the pool was settled
        self._refiltered = False  # whether filters were changed since then
        self._propagators = Propagators(store)

    def add(self, batch: Batch) -> IntArray:
        """Add the bodies of a batch, and return their rows (k,)."""
        rows = self._take(len(batch))
        state = self.store.world.state
        state.pose[rows], state.velocity[rows], state.load[rows] = (
            batch.pose,
            batch.motion,
            batch.load,
        )
        state.properties[rows, tb.INVERSE_MASS] = 1 / batch.mass
        state.properties[rows, tb.INVERSE_INERTIA] = 1 / batch.inertia
        state.kind[rows] = batch.kind
        self.generation[rows] += 1
        self._propagators.assign(rows, batch.drag_rates)
        self._number_forms(rows, batch.shapes)
        surfaces = np.column_stack((batch.friction, batch.restitution))
        self._placed += self._add_shapes(rows, batch.shapes, surfaces, batch.filters).tolist()
        self.store.forget_pairs()
        return rows

    def remove(self, rows: IntArray) -> None:
        """Take bodies out; their rows are free once the pool is settled, all others stay.

        They move no more, and are pushed by nothing: what is set of that from now on is told.
        """
        state = self.store.world.state
        state.kind[rows], state.velocity[rows], state.load[rows] = tb.ABSENT, 0.0, 0.0
        self._leaving = np.concatenate((self._leaving, rows))
        for row in rows.tolist():
            self._new.pop(row, None)

    def set_filters(self, rows: IntArray, columns: Mapping[int, IntArray]) -> bool:
        """Set columns of the filters of bodies, each (k,); return whether any changed.

        Pairs that may touch no longer leave the list of contacts once the pool is settled.
        """
        changed = self._set(self.store.world.shapes.filters, rows, columns)
        self._refiltered |= changed
        return changed

    def set_surfaces(self, rows: IntArray, columns: Mapping[int, Array]) -> bool:
        """Set columns of the material of bodies, each (k,); return whether any changed."""
        return self._set(self.store.world.shapes.material, rows, columns)

    def set_masses(self, rows: IntArray, columns: Mapping[int, Array], rates: Array) -> None:
        """Set inverse masses and inertias by columns, each (k,), and rates of drag (k, 2), 1/s."""
        for column, values in columns.items():
            self.store.world.state.properties[rows, column] = values
        self._propagators.assign(rows, rates)
        self._propagators.forget_unused()
        self.store.copy_to_slots(rows)
        self.store.world.touching.counts[[tb.ARRANGED, tb.ISLANDS_KNOWN]] = 0  # knows masses
        self.wake(rows)
        self.store.revision += 1

    def set_shapes(self, rows: IntArray, shapes: Sequence[Shape]) -> None:
        """Give bodies (k,) that have shapes others, each once; all else of them stays.

        The pool has settled. What touched them does not begin to anew.
        """
        touch, stated = CarriedTouch(self.store, self._owners(), rows), self._stated_pairs()
        self.wake(touch.beside)
        self.store.set_pair_overrides(np.zeros((0, 4)))
        state, table = self.store.world.state, self.store.world.shapes
        old = np.flatnonzero(self._place_of(rows)[state.body_of_shape] >= 0)
        of, at = np.unique(state.body_of_shape[old], return_index=True)
        first = old[at][np.searchsorted(of, rows)]
        surfaces = table.material[first, tb.FRICTION : tb.RESTITUTION + 1]
        filters = table.filters[first]
        self._free_rows(old)
        state.body_of_shape[old] = self._idle
        state.properties[rows, tb.BOUNDING_RADIUS] = state.properties[rows, tb.CORE_RADIUS] = 0.0
        self._arrange_shapes(self._add_shapes(rows, shapes, surfaces, filters))
        self._order = self._ranked_shapes()
        self.publish_order()
        self.store.copy_to_slots(rows)
        self._state_pairs(stated)
        touch.carry()
        self._begin_anew(rows)

    def _set(
        self, table: NDArray[Any], rows: IntArray, columns: Mapping[int, NDArray[Any]]
    ) -> bool:
        """Set columns of what shapes have by their bodies; wake what that concerns."""
        given, owner = self._place_of(rows), self.store.world.state.body_of_shape
        shapes = np.flatnonzero(given[owner] >= 0)
        before = table[shapes]
        for column, values in columns.items():
            table[shapes, column] = values[given[owner[shapes]]]
        changed = shapes[(table[shapes] != before).any(axis=1)]
        if len(changed):
            self._begin_anew(np.unique(owner[changed]).astype(np.int64))
        return len(changed) > 0

    def _place_of(self, rows: IntArray) -> IntArray:
        """Return of all bodies the last place among some, or -1."""
        place = np.full(len(self.store.world.state.kind), -1)
        place[rows] = np.arange(len(rows))
        return place

    def _begin_anew(self, rows: IntArray) -> None:
        """Let bodies touch others as if they were new: they wake, and wake what they touch."""
        state, links = self.store.world.state, self.store.world.islands.links
        self.wake(rows)
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
        self.store.set_pair_overrides(_by_shapes(np.array(rows, dtype=np.float64).reshape(-1, 4)))

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
            self._drop(~self._may_touch())
            self._refiltered = False
        if not (len(self._leaving) or self._new):
            return
        new, gone = np.array(list(self._new), dtype=np.int64), self._leaving
        if len(gone):
            self._let_go(gone)
            self._leaving = gone[:0]
            self._propagators.forget_unused()
        if len(new):
            self._assign_ranks(new)
        self._new.clear()
        self._placed.clear()  # what was removed before it was settled is here, too
        self._form_number.clear()
        self.store.copy_to_slots(np.concatenate((gone, new)))
        self.publish_order()
        self.store.forget_pairs()

    def publish_order(self) -> None:
        """Tell the engine the order of its shapes; those without a body come last."""
        canonical = self.store.world.broad_phase.canonical
        rest = np.ones(canonical.shape[1], dtype=bool)
        rest[self._order] = False
        canonical[tb.SHAPE_OF_RANK] = np.concatenate((self._order, np.flatnonzero(rest)))
        canonical[tb.RANK, canonical[tb.SHAPE_OF_RANK]] = np.arange(len(rest))

    def wake(self, rows: NDArray[np.integer]) -> None:
        """Wake bodies that sleep, with their islands."""
        links = self.store.world.islands.links
        asleep = links[self.store.world.state.slot_of_body[rows], tb.SLEEP_ID]
        woken = np.isin(links[:, tb.SLEEP_ID], asleep[asleep > 0])
        links[woken, tb.SLEEP_ID] = links[woken, tb.SLOW_STEPS] = 0
        self.store.world.control.counts[tb.ALL_ASLEEP] = 0

    # -- rows

    @property
    def _idle(self) -> int:
        return self.store.capacities.slots - 1

    def _take(self, count: int) -> IntArray:
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
        return np.array(used, dtype=np.int64)

    def _take_shapes(self, parts: Sequence[ShapeRow]) -> list[int]:
        """Return rows for the shapes of a body; pieces of a chain lie side by side."""
        if parts and parts[0].kind >= tb.PIECE:
            return self._take_chain(len(parts))
        return [self._take_shape(len(part.vertices)) for part in parts]

    def _take_shape(self, vertices: int) -> int:
        """Return a row for a shape with so many vertices."""
        if self._free_shapes.get(vertices):
            return self._free_shapes[vertices].pop()
        row, shapes = self._shapes, self.store.world.shapes
        shapes.first[row], shapes.vertex_count[row] = self._vertices, vertices
        self._shapes += 1
        self._vertices += vertices
        return row

    def _take_chain(self, pieces: int) -> list[int]:
        """Return rows that lie side by side for so many pieces."""
        free = np.array(self._free_shapes.get(2, [])[::-1], dtype=np.int64)
        last = free[pieces - 1 :]
        (starts,) = np.nonzero(last - free[: len(last)] == pieces - 1)
        if not len(starts):
            kept, self._free_shapes[2] = self._free_shapes.get(2, []), []
            new = [self._take_shape(2) for _ in range(pieces)]
            self._free_shapes[2] = kept
            return new
        taken: list[int] = free[starts[0] : starts[0] + pieces].tolist()
        self._free_shapes[2] = np.setdiff1d(free, taken)[::-1].tolist()
        return taken

    def _number_forms(self, rows: IntArray, shapes: Sequence[Shape | None]) -> None:
        """Note that bodies are new, and number their forms."""
        known = self._form_number
        form = {s: known.setdefault(numbers_of(s), len(known)) for s in dict.fromkeys(shapes)}
        self._new.update((row, form[s]) for row, s in zip(rows.tolist(), shapes, strict=True))

    def _add_shapes(
        self,
        rows: IntArray,
        shapes: Sequence[Shape | None],
        surfaces: Array,
        filters: NDArray[np.int64],
    ) -> IntArray:
        """Give bodies (k,) shapes; return the rows of these, body by body in the order of parts.

        All shapes of a body have its friction and restitution (k, 2), and its filters (k, 4).
        """
        made = {shape: shape_rows(shape) for shape in dict.fromkeys(shapes)}
        owner = [k for k, shape in enumerate(shapes) for _ in made[shape]]
        found = [part for shape in shapes for part in made[shape]]
        if not found:
            return np.zeros(0, dtype=np.int64)
        vertices = sum(len(part.vertices) for part in found)
        self.store.reserve_shapes(self._shapes + len(found), self._vertices + vertices)
        places = np.array([place for shape in shapes for place in self._take_shapes(made[shape])])
        self.store.world.state.body_of_shape[places] = rows[owner]
        self._write_shapes(places, found)
        table = self.store.world.shapes
        radii = [(part.bounding_radius, part.inradius, *part.corners) for part in found]
        table.material[places] = np.hstack((surfaces[owner], radii))
        table.filters[places] = filters[owner]
        self._note_extents(rows, rows[owner], found)
        return places

    def _write_shapes(self, places: IntArray, found: Sequence[ShapeRow]) -> None:
        shapes = self.store.world.shapes
        shapes.kind[places] = [part.kind for part in found]
        shapes.radius[places] = [part.radius for part in found]
        vertices = self._vertices_of(places)
        shapes.local_vertices[vertices] = np.concatenate([part.vertices for part in found])
        shapes.world_vertices[vertices] = shapes.local_vertices[vertices]

    def _vertices_of(self, places: IntArray) -> IntArray:
        """Return the rows of the vertices of shapes, shape by shape."""
        shapes = self.store.world.shapes
        count = shapes.vertex_count[places].astype(np.int64)
        within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
        rows: IntArray = np.repeat(shapes.first[places], count) + within
        return rows

    def _note_extents(self, rows: IntArray, owner: IntArray, found: Sequence[ShapeRow]) -> None:
        """Note how large bodies are; `owner` has the row of the body of each shape."""
        properties = self.store.world.state.properties
        reach = np.array([part.bounding_radius for part in found])
        bounded = np.isfinite(reach)
        np.maximum.at(properties[:, tb.BOUNDING_RADIUS], owner[bounded], reach[bounded])
        properties[rows, tb.MIN_EXTENT] = np.inf
        np.minimum.at(properties[:, tb.MIN_EXTENT], owner, [part.min_extent for part in found])
        np.maximum.at(properties[:, tb.CORE_RADIUS], owner, [part.core_radius for part in found])

    def _shapes_of(self, row: int) -> list[int]:
        found: list[int] = np.flatnonzero(self.store.world.state.body_of_shape == row).tolist()
        return found

    # -- removing

    def _let_go(self, rows: IntArray) -> None:
        state = self.store.world.state
        leaves = np.zeros(len(state.kind), dtype=bool)
        leaves[rows] = True
        self._drop_pairs(leaves)
        gone = leaves[state.body_of_shape]
        self._free_rows(np.flatnonzero(gone))
        state.body_of_shape[gone] = self._idle
        self._order = self._order[~gone[self._order]]
        self.store.clear(rows)
        self.rank[rows] = -1
        self._free = sorted({*self._free, *rows.tolist()}, reverse=True)

    def _free_rows(self, rows: IntArray) -> None:
        """Free rows of shapes: the lowest is taken first, whatever the order of freeing."""
        count = self.store.world.shapes.vertex_count
        for row in rows.tolist():
            self._free_shapes.setdefault(int(count[row]), []).append(row)
        for free in self._free_shapes.values():
            free.sort(reverse=True)

    def drop_pairs(self, pairs: set[tuple[int, int]]) -> None:
        """Take pairs of bodies, the lower row first, out of the list of contacts; wake them."""
        if pairs:
            owner = np.sort(self._owners(), axis=1)
            self._drop(np.array([tuple(pair) in pairs for pair in owner.tolist()], dtype=bool))

    def _owners(self) -> IntArray:
        """Return the bodies (k, 2) of all contacts on the list."""
        world = self.store.world
        side, size = world.broad_phase.counts[[tb.BUFFER, tb.CONTACTS]]
        slots = world.buffers.pairs[side, :size, tb.SLOT_A : tb.SLOT_B + 1]
        return world.state.body_of_slot[slots].astype(np.int64)

    def _may_touch(self) -> NDArray[np.bool_]:
        """Return which contacts (k,) on the list are of shapes that filters let touch (R3)."""
        world = self.store.world
        side, size = world.broad_phase.counts[[tb.BUFFER, tb.CONTACTS]]
        a, b = world.shapes.filters[world.buffers.pairs[side, :size, :2].T.astype(np.int64)]
        group = a[:, tb.GROUP]
        meet = (a[:, tb.CATEGORY] & b[:, tb.MASK] != 0) & (b[:, tb.CATEGORY] & a[:, tb.MASK] != 0)
        found: NDArray[np.bool_] = np.where(
            (group == b[:, tb.GROUP]) & (group != 0), group > 0, meet
        )
        return found

    def _drop(self, left: NDArray[np.bool_]) -> None:
        """Take contacts (k,) out of the list, and wake their bodies."""
        if not left.any():
            return
        counts, buffers = self.store.world.broad_phase.counts, self.store.world.buffers
        side, size = counts[tb.BUFFER], counts[tb.CONTACTS]
        points = buffers.flags[side, :size, tb.POINT_COUNT] > 0
        self.wake(self._owners()[left & points].ravel())
        first = int(np.argmax(left))  # those before it stay where they are
        kept = first + np.flatnonzero(~left[first:])
        for values in (buffers.pairs, buffers.manifolds, buffers.axes, buffers.flags):
            values[side, first : first + len(kept)] = values[side, kept]
        counts[tb.FIRST_RUN] -= np.count_nonzero(left[: counts[tb.FIRST_RUN]])
        counts[tb.CONTACTS] = first + len(kept)

    def _drop_pairs(self, leaves: NDArray[np.bool_]) -> None:
        """Take the pairs of bodies that leave out of the list, and their overrides; wake others."""
        world = self.store.world
        owners = leaves[self._owners()]
        self._drop(owners[:, 0] | owners[:, 1])
        overrides = world.shapes.pair_overrides
        if len(overrides):
            owner = world.state.body_of_shape[overrides[:, :2].astype(np.int64)]
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
        new = np.zeros(len(state.pose), dtype=bool)
        new[rows] = True
        owned = np.array(self._placed, dtype=np.int64)
        owned = owned[new[state.body_of_shape[owned]]]
        sequence = rows[np.lexsort(self._keys(rows, owned)[::-1])]
        first = int(self.rank.max(initial=-1)) + 1
        self.rank[sequence] = np.arange(first, first + len(rows))
        store.assign_slots(sequence, np.sort(state.slot_of_body[rows]))
        places = self._arrange_shapes(
            owned[np.argsort(self.rank[state.body_of_shape[owned]], kind="stable")]
        )
        self._order = np.concatenate((self._order, places))

    def _keys(self, rows: IntArray, owned: IntArray) -> list[Array]:
        """Return by what bodies are ordered, the first first; `owned` are their shapes."""
        world = self.store.world
        state, shapes = world.state, world.shapes
        first = np.full(len(state.pose), -1)
        first[state.body_of_shape[owned][::-1]] = owned[::-1]
        properties = state.properties[rows]
        tables = (
            state.pose[rows],
            state.velocity[rows],
            state.load[rows],
            properties[:, : tb.PROPAGATOR],
            world.bodies.propagators[properties[:, tb.PROPAGATOR].astype(np.int64)],
            np.concatenate((shapes.material, np.zeros((1, shapes.material.shape[1]))))[first[rows]],
            np.concatenate((shapes.filters, np.zeros((1, 4), dtype=np.int64)))[first[rows]],
        )
        columns = [column for table in tables for column in table.T]
        return [
            state.kind[rows],
            self._strips(rows),
            state.pose[rows, tb.Y],
            *columns,
            self._forms(),
        ]

    def _strips(self, rows: IntArray) -> Array:
        """Return in which strip of the x axis each body is, all some bodies wide.

        Bodies that are near each other are so in the order, too, and thus in memory.
        """
        state = self.store.world.state
        return strips(state.pose[rows, tb.X], state.properties[rows, tb.BOUNDING_RADIUS])

    def _forms(self) -> IntArray:
        """Return a number for the form of each new body, in the order of the forms themselves."""
        number = self._form_number
        place = np.empty(len(number), dtype=np.int64)
        place[[number[form] for form in sorted(number)]] = np.arange(len(number))
        return place[list(self._new.values())]

    def _arrange_shapes(self, sequence: IntArray) -> IntArray:
        """Put new shapes, and their vertices if these lie together, in an order; return their rows.

        Shapes that have no rows side by side, as some were free, are put in order in each body.
        """
        store, places = self.store, np.sort(sequence)
        state, shapes = store.world.state, store.world.shapes
        if len(places) and places[-1] - places[0] + 1 > len(places):
            _, body = np.unique(state.body_of_shape[sequence], return_inverse=True)
            came = np.unique(body, return_index=True)[1]
            places = sequence[np.lexsort((sequence, came[body]))]
        for values in (
            *(state.body_of_shape, shapes.kind, shapes.first, shapes.vertex_count),
            *(shapes.radius, shapes.material, shapes.filters),
        ):
            values[places] = values[sequence]
        moved = np.arange(len(state.body_of_shape))
        moved[sequence] = places
        overrides = shapes.pair_overrides
        overrides[:, :2] = np.sort(moved[overrides[:, :2].astype(np.int64)], axis=1)
        store.set_pair_overrides(_by_shapes(overrides))
        old = self._vertices_of(places)
        if len(old) and old.max() - old.min() + 1 == len(old):
            start = int(old.min())
            together = slice(start, start + len(old))
            shapes.local_vertices[together] = shapes.local_vertices[old]
            shapes.world_vertices[together] = shapes.local_vertices[together]
            count = shapes.vertex_count[places].astype(np.int64)
            shapes.first[places] = start + np.cumsum(count) - count
        return places


def strips(x: Array, reach: Array) -> Array:
    """Return in which strip bodies (..., n) are, from how far each reaches from its centre (n,)."""
    width = STRIP * np.median(reach[reach > 0.0]) if (reach > 0.0).any() else np.inf
    with np.errstate(all="ignore"):
        found: Array = np.floor(x / width)
    return found


def _by_shapes(overrides: Array) -> Array:
    """Return what was set for pairs of shapes, in the order of the shapes."""
    return overrides[np.lexsort((overrides[:, 1], overrides[:, 0]))]
