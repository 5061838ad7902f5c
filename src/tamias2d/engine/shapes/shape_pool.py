"""The shape pool: which rows hold the shapes of which bodies."""

from collections.abc import Sequence
from itertools import chain

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.engine.arrays.row_index import index_of
from tamias2d.engine.arrays.store import Store
from tamias2d.engine.shapes.shape_form import Form, Pieces, joined
from tamias2d.engine.shapes.stated_surfaces import effective_surfaces
from tamias2d.state import Array, IntArray


class ShapePool:
    """The taken and the free rows of the shapes of an engine."""

    def __init__(self, store: Store) -> None:
        """Find what a store holds."""
        self._store = store
        state, shapes = store.world.state, store.world.shapes
        self._taken = int(np.count_nonzero(shapes.vertex_count))  # rows ever taken
        self._vertices = int(shapes.vertex_count.sum())
        self._free: dict[int, list[int]] = {}  # by their number of vertices
        self._free_rows(np.flatnonzero(state.body_of_shape[: self._taken] == self._idle))

    def add(
        self,
        rows: Sequence[int],
        forms: Sequence[Form],
        surfaces: Array,
        filters: NDArray[np.int64],
    ) -> list[list[int]]:
        """Give bodies (k,) shapes; return the rows of those of each, in the order of parts.

        All shapes of a body have its filters (k, 4), and its surface (k, 3), as in a `Batch`, but
        for what a part states itself.
        """
        pieces = joined(forms)
        if not pieces.counts:
            return [[] for _ in forms]
        self._store.reserve_shapes(
            self._taken + len(pieces.counts),
            self._vertices + len(pieces.vertices),
            max(pieces.counts),
        )
        found = [self._take(form.pieces) for form in forms]
        places, owner = [*chain.from_iterable(found)], np.array(rows, dtype=np.int64)
        if len(forms) > 1:
            each = np.repeat(np.arange(len(forms)), [*map(len, found)])
            owner, surfaces, filters = owner[each], surfaces[each], filters[each]
        state, shapes, at = self._store.world.state, self._store.world.shapes, index_of(places)
        state.body_of_shape[at] = owner
        shapes.kind[at], shapes.radius[at] = pieces.kinds, pieces.radii
        shapes.material[at, : tb.SHAPE_RADIUS] = surfaces
        shapes.stated[at, tb.BY_PART : tb.BY_BODY] = pieces.surfaces
        shapes.stated[at, tb.BY_BODY :] = surfaces[:, : tb.SURFACE_SPEED]
        if pieces.stating:
            shapes.material[at, : tb.SURFACE_SPEED] = effective_surfaces(shapes.stated[at])
        shapes.material[at, tb.SHAPE_RADIUS :] = pieces.bounds
        shapes.filters[at] = filters
        corners = self._corners_of(places)
        shapes.local_vertices[corners] = shapes.world_vertices[corners] = pieces.vertices
        return found

    def free(self, bodies: NDArray[np.bool_]) -> IntArray:
        """Free the rows of the shapes of marked bodies (slots,), and return them."""
        owner = self._store.world.state.body_of_shape
        rows = np.flatnonzero(bodies[owner])
        self._free_rows(rows)
        owner[rows] = self._idle
        return rows

    def _corners_of(self, places: Sequence[int]) -> slice | IntArray:
        """Return an index of the vertices of shapes, shape by shape."""
        if len(places) > 1:
            return self._vertices_of(np.array(places, dtype=np.int64))
        shapes, place = self._store.world.shapes, places[0]
        start = shapes.first.item(place)
        return slice(start, start + shapes.vertex_count.item(place))

    def _vertices_of(self, places: IntArray) -> IntArray:
        """Return the rows of the vertices of shapes, shape by shape."""
        shapes = self._store.world.shapes
        count = shapes.vertex_count[places].astype(np.int64)
        within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
        rows: IntArray = np.repeat(shapes.first[places], count) + within
        return rows

    def arrange(self, sequence: IntArray) -> IntArray:
        """Put new shapes, and their vertices if these lie together, in an order; return their rows.

        Shapes that have no rows side by side, as some were free, are put in order in each body.
        """
        if len(sequence) < 2:
            return sequence
        store, places = self._store, np.sort(sequence)
        state, shapes = store.world.state, store.world.shapes
        if places[-1] - places[0] + 1 > len(places):
            _, body = np.unique(state.body_of_shape[sequence], return_inverse=True)
            came = np.unique(body, return_index=True)[1]
            places = sequence[np.lexsort((sequence, came[body]))]
        if not np.array_equal(places, sequence):
            self._move(sequence, places)
        old = self._vertices_of(places)
        if len(old) and old.max() - old.min() + 1 == len(old):
            start = int(old.min())
            together = slice(start, start + len(old))
            shapes.local_vertices[together] = shapes.local_vertices[old]
            shapes.world_vertices[together] = shapes.local_vertices[together]
            count = shapes.vertex_count[places].astype(np.int64)
            shapes.first[places] = start + np.cumsum(count) - count
        return places

    def _move(self, sequence: IntArray, places: IntArray) -> None:
        """Move shapes to other places, which together were theirs."""
        state, shapes = self._store.world.state, self._store.world.shapes
        for values in (
            *(state.body_of_shape, shapes.kind, shapes.first, shapes.vertex_count),
            *(shapes.radius, shapes.material, shapes.stated, shapes.filters),
        ):
            values[places] = values[sequence]
        moved = np.arange(len(state.body_of_shape))
        moved[sequence] = places
        overrides = shapes.pair_overrides
        overrides[:, :2] = np.sort(moved[overrides[:, :2].astype(np.int64)], axis=1)
        self._store.set_pair_overrides(by_shapes(overrides))

    @property
    def _idle(self) -> int:
        return self._store.capacities.slots - 1

    def _take(self, pieces: Pieces) -> list[int]:
        """Return rows for the shapes of a body; pieces of a chain lie side by side."""
        if pieces.counts and pieces.kinds.item(0) >= tb.PIECE:
            return self._take_chain(len(pieces.counts))
        return [*map(self._take_shape, pieces.counts)]

    def _take_shape(self, vertices: int) -> int:
        """Return a row for a shape with so many vertices."""
        if self._free.get(vertices):
            return self._free[vertices].pop()
        row, shapes = self._taken, self._store.world.shapes
        shapes.first[row], shapes.vertex_count[row] = self._vertices, vertices
        self._taken += 1
        self._vertices += vertices
        return row

    def _take_chain(self, pieces: int) -> list[int]:
        """Return rows that lie side by side for so many pieces."""
        free = np.array(self._free.get(2, [])[::-1], dtype=np.int64)
        last = free[pieces - 1 :]
        (starts,) = np.nonzero(last - free[: len(last)] == pieces - 1)
        if not len(starts):
            kept, self._free[2] = self._free.get(2, []), []
            new = [self._take_shape(2) for _ in range(pieces)]
            self._free[2] = kept
            return new
        taken: list[int] = free[starts[0] : starts[0] + pieces].tolist()
        self._free[2] = np.setdiff1d(free, taken)[::-1].tolist()
        return taken

    def _free_rows(self, rows: IntArray) -> None:
        """Free rows of shapes: the lowest is taken first, whatever the order of freeing."""
        count = self._store.world.shapes.vertex_count
        for row in rows.tolist():
            self._free.setdefault(int(count[row]), []).append(row)
        for free in self._free.values():
            free.sort(reverse=True)


def by_shapes(overrides: Array) -> Array:
    """Return what was set for pairs of shapes, in the order of the shapes."""
    return overrides[np.lexsort((overrides[:, 1], overrides[:, 0]))]
