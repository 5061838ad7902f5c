"""Which rows of an engine's arrays hold which bodies and shapes, and their canonical order.

Serves: adding and removing while a simulator runs. Hides: how freed rows are used again, and how
arrays grow.

The row of a body is its index, and stays it. Bodies are ordered by when they first take part in a
step, and those that do so together by where and what they are, number by number: so the order of
adding changes nothing. The order goes along the x axis in stretches, and in each of them upwards;
bodies and shapes sit in it where the engine works. Bodies that are equal in all of it can be
swapped without a difference.
"""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine.engine import Engine
from tamias2d.engine.tables import (
    ABSENT,
    BOUNDING_RADIUS,
    BUFFER,
    CONTACTS,
    CORE_RADIUS,
    FIRST_RUN,
    INVERSE_INERTIA,
    INVERSE_MASS,
    MIN_EXTENT,
    POINT_COUNT,
    PROPAGATOR,
    SLOT_A,
    SLOT_B,
    X,
    Y,
)
from tamias2d.simulator.batch import Batch
from tamias2d.simulator.drag import Drag
from tamias2d.simulator.pieces import Piece, pieces
from tamias2d.state import Array

Whole = NDArray[np.int64]
STRETCH = 4.0  # reaches of a body, by which the canonical order goes along


class Roster:
    """The taken and the free rows of an engine."""

    def __init__(self, engine: Engine) -> None:
        self.engine = engine
        self.rank = np.zeros(0, dtype=np.int64)
        """(n,), place of each body in the canonical order; what is absent or new has none, -1"""
        self._order = np.zeros(0, dtype=np.int64)  # shapes that have a rank, by it
        self._free: list[int] = []
        self._free_shapes: dict[int, list[int]] = {}  # by their number of corners
        self._shapes = self._corners = 0  # rows ever taken
        self._next = 0
        self._new: dict[int, int] = {}  # bodies without a rank, and the numbers of their forms
        self._placed: list[int] = []  # shapes of such bodies, of each in their order
        self._form_number: dict[tuple[float, ...], int] = {}  # as they came, since all had ranks
        self._leaving = np.zeros(0, dtype=np.int64)  # removed since it was settled
        self._drag = Drag(engine)

    def place(self, batch: Batch) -> Whole:
        """Add the bodies of a batch, and return their rows."""
        engine = self.engine
        rows = self._take(len(batch))
        engine.world.state.pose[rows] = batch.pose
        engine.world.state.velocity[rows] = batch.motion
        engine.world.state.load[rows] = batch.load
        engine.world.state.properties[rows, INVERSE_MASS] = 1 / batch.mass
        engine.world.state.properties[rows, INVERSE_INERTIA] = 1 / batch.inertia
        self._drag.slow(rows, batch.slowing)
        engine.world.state.kind[rows] = batch.kind
        self._place_shapes(batch, rows)
        engine.forget_pairs()
        return rows

    def remove(self, rows: Whole) -> None:
        """Take bodies out; the rows of all others stay, and theirs are free once it is settled."""
        self.engine.world.state.kind[rows] = ABSENT
        self._leaving = np.concatenate((self._leaving, rows))
        for row in rows.tolist():
            self._new.pop(row, None)

    def mix(
        self,
        friction: Mapping[tuple[int, int], float],
        restitution: Mapping[tuple[int, int], float],
    ) -> None:
        """Set the surfaces of pairs of bodies, given by rows."""
        rows = [
            (min(s, t), max(s, t), friction.get((i, j), -1.0), restitution.get((i, j), -1.0))
            for i, j in sorted({*friction, *restitution})
            for s in self._shapes_of(i)
            for t in self._shapes_of(j)
        ]
        self.engine.set_pair_overrides(_by_shapes(np.array(rows, dtype=np.float64).reshape(-1, 4)))
        self.engine.forget_pairs()

    def arrays(self) -> dict[str, NDArray[Any]]:
        """Return all that it knows; everything must have its rank."""
        slots = [(count, slot) for count, free in self._free_shapes.items() for slot in free]
        return {
            "rank": self.rank,
            "order": self._order,
            "free": np.array(self._free, dtype=np.int64),
            "free_shapes": np.array(slots, dtype=np.int64).reshape(-1, 2),
            "sizes": np.array([self._shapes, self._corners, self._next]),
        }

    def take_over(self, arrays: Mapping[str, NDArray[Any]]) -> None:
        """Know what another one knew."""
        self.rank, self._order = arrays["rank"].copy(), arrays["order"].copy()
        self._free = arrays["free"].tolist()
        self._free_shapes = {}
        for count, slot in arrays["free_shapes"].tolist():
            self._free_shapes.setdefault(count, []).append(slot)
        self._shapes, self._corners, self._next = arrays["sizes"].tolist()
        self._new, self._placed, self._form_number = {}, [], {}

    def settle(self) -> None:
        """Let go of what was removed, and give all that is new its rank."""
        if not (len(self._leaving) or self._new):
            return
        new, gone = np.array(list(self._new), dtype=np.int64), self._leaving
        if len(gone):
            self._let_go(gone)
            self._leaving = gone[:0]
            self._drag.forget_unused()
        if len(new):
            self._rank(new)
        self._new.clear()
        self._placed.clear()  # what was removed before it was settled is here, too
        self._form_number.clear()
        self.engine.settle(np.concatenate((gone, new)))
        self._publish()

    def _let_go(self, rows: Whole) -> None:
        engine = self.engine
        self._drop_pairs(rows)
        gone = np.isin(engine.world.state.body_of_shape, rows)
        for slot in np.flatnonzero(gone).tolist():
            self._free_shapes.setdefault(int(engine.world.shapes.vertex_count[slot]), []).append(
                slot
            )
        engine.world.state.body_of_shape[gone] = self._idle
        self._order = self._order[~gone[self._order]]
        engine.clear(rows)
        self.rank[rows] = -1
        self._free = sorted({*self._free, *rows.tolist()}, reverse=True)

    def _rank(self, rows: Whole) -> None:
        """Order new bodies by what and where they are, and seat them and their shapes so."""
        engine = self.engine
        new = np.zeros(len(engine.world.state.pose), dtype=bool)
        new[rows] = True
        owned = np.array(self._placed, dtype=np.int64)
        owned = owned[new[engine.world.state.body_of_shape[owned]]]
        first = np.full(len(engine.world.state.pose), -1)
        first[engine.world.state.body_of_shape[owned][::-1]] = owned[::-1]
        body = engine.world.state.properties[rows]
        flows = engine.world.bodies.propagators[body[:, PROPAGATOR].astype(np.int64)]
        tables = (
            engine.world.state.pose[rows],
            engine.world.state.velocity[rows],
            engine.world.state.load[rows],
            body[:, :PROPAGATOR],
            flows,
        )
        touching = np.concatenate((engine.world.shapes.material, np.zeros((1, 4))))[first[rows]]
        meeting = np.concatenate((engine.world.shapes.filters, np.zeros((1, 4), dtype=np.int64)))[
            first[rows]
        ]
        columns = [column for table in (*tables, touching, meeting) for column in table.T]
        stretch, y = self._stretches(rows), engine.world.state.pose[rows, Y]
        keys = [engine.world.state.kind[rows], stretch, y, *columns, self._forms()]
        sequence = rows[np.lexsort(keys[::-1])]
        self.rank[sequence] = np.arange(self._next, self._next + len(rows))
        self._next += len(rows)
        engine.assign_slots(sequence, np.sort(engine.world.state.slot_of_body[rows]))
        self._arrange_shapes(
            owned[np.argsort(self.rank[engine.world.state.body_of_shape[owned]], kind="stable")]
        )
        self._order = np.concatenate((self._order, np.sort(owned)))

    def _stretches(self, rows: Whole) -> Array:
        """Return in which stretch of the x axis each body is, all some bodies wide.

        Those that are near each other are so in the order, too, and thus in memory.
        """
        reach = self.engine.world.state.properties[rows, BOUNDING_RADIUS]
        width = STRETCH * np.median(reach[reach > 0.0]) if (reach > 0.0).any() else np.inf
        with np.errstate(all="ignore"):
            stretch: Array = np.floor(self.engine.world.state.pose[rows, X] / width)
        return stretch

    def _arrange_shapes(self, sequence: Whole) -> None:
        """Put new shapes, and their corners where these lie together, in an order."""
        engine, slots = self.engine, np.sort(sequence)
        shapes = engine.world.shapes
        for values in (
            *(engine.world.state.body_of_shape, shapes.kind, shapes.first, shapes.vertex_count),
            *(shapes.radius, shapes.material, shapes.filters),
        ):
            values[slots] = values[sequence]
        moved = np.arange(len(engine.world.state.body_of_shape))
        moved[sequence] = slots
        engine.world.shapes.pair_overrides[:, :2] = np.sort(
            moved[engine.world.shapes.pair_overrides[:, :2].astype(np.int64)], axis=1
        )
        engine.set_pair_overrides(_by_shapes(engine.world.shapes.pair_overrides))
        count = engine.world.shapes.vertex_count[slots].astype(np.int64)
        start, total = np.cumsum(count) - count, int(count.sum())
        old = np.repeat(engine.world.shapes.first[slots] - start, count) + np.arange(total)
        if total and old.max() - old.min() + 1 == total:
            place = slice(old.min(), old.min() + total)
            engine.world.shapes.local_vertices[place] = engine.world.shapes.world_vertices[
                place
            ] = engine.world.shapes.local_vertices[old]
            engine.world.shapes.first[slots] = place.start + start

    def _forms(self) -> Whole:
        """Return a number for the form of each new body, in the order of the forms themselves."""
        number = self._form_number
        place = np.empty(len(number), dtype=np.int64)
        place[[number[form] for form in sorted(number)]] = np.arange(len(number))
        return place[list(self._new.values())]

    def _publish(self) -> None:
        """Tell the engine the order of its shapes; those without a body come last."""
        engine = self.engine
        rest = np.ones(len(engine.world.state.body_of_shape), dtype=bool)
        rest[self._order] = False
        engine.world.broad_phase.canonical[0] = np.concatenate((self._order, np.flatnonzero(rest)))
        engine.world.broad_phase.canonical[1, engine.world.broad_phase.canonical[0]] = np.arange(
            len(rest)
        )
        engine.forget_pairs()

    @property
    def _idle(self) -> int:
        return len(self.engine.world.state.pose) - 1

    def _take(self, count: int) -> Whole:
        """Return rows for so many bodies, freed ones first."""
        engine = self.engine
        used = [self._free.pop() for _ in range(min(count, len(self._free)))]
        more = count - len(used)
        engine.make_room(more)
        rows = np.array([*used, *range(engine.size, engine.size + more)], dtype=np.int64)
        engine.size += more
        self.rank = np.concatenate((self.rank, np.full(more, -1)))
        return rows

    def _place_shapes(self, batch: Batch, rows: Whole) -> None:
        made = {shape: pieces(shape) for shape in dict.fromkeys(batch.shapes)}
        known = self._form_number
        form = {s: known.setdefault(_form(found), len(known)) for s, found in made.items()}
        self._new.update((row, form[s]) for row, s in zip(rows.tolist(), batch.shapes, strict=True))
        owner = [k for k, shape in enumerate(batch.shapes) for _ in made[shape]]
        found = [piece for shape in batch.shapes for piece in made[shape]]
        if not found:
            return
        engine, corners = self.engine, sum(len(piece.corner) for piece in found)
        engine.make_shape_room(self._shapes + len(found), self._corners + corners)
        slots = np.array([self._slot(len(piece.corner)) for piece in found])
        self._placed += slots.tolist()
        engine.world.state.body_of_shape[slots] = rows[owner]
        engine.world.shapes.kind[slots] = [piece.kind for piece in found]
        engine.world.shapes.radius[slots] = [piece.radius for piece in found]
        count = engine.world.shapes.vertex_count[slots].astype(np.int64)
        within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
        places = np.repeat(engine.world.shapes.first[slots], count) + within
        engine.world.shapes.local_vertices[places] = np.concatenate(
            [piece.corner for piece in found]
        )
        engine.world.shapes.world_vertices[places] = engine.world.shapes.local_vertices[places]
        reach = np.array([piece.reach for piece in found])
        inner = np.array([piece.inner for piece in found])
        surfaces = (batch.friction[owner], batch.restitution[owner], reach, inner)
        engine.world.shapes.material[slots] = np.stack(surfaces, axis=1)
        engine.world.shapes.filters[slots] = batch.filters[owner]
        bounded = np.isfinite(reach)
        np.maximum.at(
            engine.world.state.properties[:, BOUNDING_RADIUS], rows[owner][bounded], reach[bounded]
        )
        engine.world.state.properties[rows, MIN_EXTENT] = np.inf
        np.minimum.at(
            engine.world.state.properties[:, MIN_EXTENT],
            rows[owner],
            [piece.half for piece in found],
        )
        np.maximum.at(
            engine.world.state.properties[:, CORE_RADIUS],
            rows[owner],
            [piece.arm for piece in found],
        )

    def _slot(self, corners: int) -> int:
        """Return a row for a shape with so many corners."""
        if self._free_shapes.get(corners):
            return self._free_shapes[corners].pop()
        slot = self._shapes
        self.engine.world.shapes.first[slot], self.engine.world.shapes.vertex_count[slot] = (
            self._corners,
            corners,
        )
        self._shapes += 1
        self._corners += corners
        return slot

    def _shapes_of(self, row: int) -> Sequence[int]:
        return list(np.flatnonzero(self.engine.world.state.body_of_shape == row).tolist())

    def _drop_pairs(self, rows: Whole) -> None:
        """Take the pairs of bodies out of the list, and what was set for them; wake the others."""
        engine = self.engine
        side, size = (
            engine.world.broad_phase.counts[BUFFER],
            engine.world.broad_phase.counts[CONTACTS],
        )
        owner = engine.world.state.body_of_slot[
            engine.world.buffers.pairs[side, :size, SLOT_A : SLOT_B + 1]
        ]
        left = np.isin(owner, rows).any(axis=1)
        engine.wake(
            owner[left & (engine.world.buffers.flags[side, :size, POINT_COUNT] > 0)].ravel()
        )
        kept = np.flatnonzero(~left)
        for values in (
            engine.world.buffers.pairs,
            engine.world.buffers.manifolds,
            engine.world.buffers.flags,
        ):
            values[side, : len(kept)] = values[side, kept]
        engine.world.broad_phase.counts[FIRST_RUN] = np.count_nonzero(
            kept < engine.world.broad_phase.counts[FIRST_RUN]
        )
        engine.world.broad_phase.counts[CONTACTS] = len(kept)
        owner = engine.world.state.body_of_shape[
            engine.world.shapes.pair_overrides[:, :2].astype(np.int64)
        ]
        engine.set_pair_overrides(
            engine.world.shapes.pair_overrides[~np.isin(owner, rows).any(axis=1)]
        )


def _by_shapes(mixed: Array) -> Array:
    """Return what was set for pairs of shapes, in their order."""
    return mixed[np.lexsort((mixed[:, 1], mixed[:, 0]))]


def _form(found: Sequence[Piece]) -> tuple[float, ...]:
    """Return all numbers of a body's shapes."""
    parts = [(p.kind, p.radius, len(p.corner), *p.corner.ravel().tolist()) for p in found]
    return tuple(value for part in parts for value in part)
