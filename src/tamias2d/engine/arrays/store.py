"""The arrays of a world, which grow: capacity for bodies and shapes, and what is known of each."""

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.engine.arrays.row_index import index_of
from tamias2d.engine.arrays.world import (
    Capacities,
    allocated,
    arrays_by_slot,
    in_use,
    resized,
    shortened_rows,
    with_arrays,
)
from tamias2d.engine.tables import Integers
from tamias2d.kernels.groups import Addresses, table_shape
from tamias2d.state import Array, IntArray

CONTACTS_OF_SHAPE = 5
CONTACTS_OF_BLOCK = 8  # half of the lanes
MOST_FORESEEN = 256  # contacts, before any is found


class Store:
    """n bodies and m shapes in the arrays that `tables` declares.

    What users see is in the order of adding (`world.state`), what steps work on is by slots.
    """

    def __init__(self, capacities: Capacities, *, compiled: bool) -> None:
        self.size = 0  # rows of bodies in use, absent ones too
        self.revision = 0  # changes whenever bodies or shapes come, go or change
        self.capacities = capacities
        self.compiled = compiled
        self.world = allocated(capacities)
        self._addresses = Addresses()
        self._argument: Any = None
        self._kept_table: NDArray[np.int64] | None = None
        self._slots = 0  # that it tells of
        self._by_slot: tuple[NDArray[Any], ...] | None = None  # arrays with a row for each slot
        state = self.world.state
        state.slot_of_body[:] = state.body_of_slot[:] = np.arange(capacities.slots, dtype=np.uint32)

    @property
    def argument(self) -> Any:
        """The world as compiled code takes it, a table of addresses, or as plain code does."""
        if self._argument is None:
            self._reserve_clip(int(self.world.shapes.vertex_count.max(initial=0)))
            self._slots = slots = self.size + 1  # an idle slot follows those of the bodies
            self._argument = self._table(slots) if self.compiled else in_use(self.world, slots)
        return self._argument

    def _table(self, slots: int) -> NDArray[np.int64]:
        """Return the addresses of `in_use`."""
        table = self._addresses.of(self.world)
        table[shortened_rows(), 1] = slots
        if self._kept_table is None:
            return table
        self._kept_table[...] = table
        return self._kept_table

    @property
    def table_shape(self) -> tuple[int, int]:
        """The shape of the table of addresses."""
        return table_shape(self.world)

    def keep_table_in(self, table: NDArray[np.int64]) -> None:
        """Keep the table of addresses in an array from now on."""
        self._kept_table = table
        self.forget_addresses()

    def replace(self, **arrays: NDArray[Any]) -> None:
        """Put arrays, by `group__field`, in the place of others of the same shape."""
        named = {name.replace("__", "."): values for name, values in arrays.items()}
        self.world = with_arrays(self.world, named)
        self.forget_addresses()

    def resize(self, **capacities: int) -> None:
        """Change capacities; arrays keep what they hold."""
        if all(getattr(self.capacities, name) == count for name, count in capacities.items()):
            return
        before, self.capacities = self.capacities, replace(self.capacities, **capacities)
        self.world = resized(self.world, before, self.capacities)
        self.forget_addresses()

    def forget_addresses(self) -> None:
        """Find the addresses of the arrays anew before they are next used."""
        self._argument = self._by_slot = None

    def reserve(self, count: int) -> None:
        """Reserve rows for so many bodies more, in whole chunks.

        Shapes without a body are those of the idle one.
        """
        if self.size + count < self.capacities.slots:
            return
        idle = self.capacities.slots - 1
        slots = (
            max(self.size + count, self.capacities.slots * 3 // 2) // tb.CHUNK * tb.CHUNK + tb.CHUNK
        )
        self.resize(slots=slots)
        self.idle_from(idle)

    def idle_from(self, idle: int) -> None:
        """Let all slots from one on be idle, which was the last one; shapes without a body know."""
        state, slots = self.world.state, self.capacities.slots
        state.slot_of_body[idle:] = state.body_of_slot[idle:] = np.arange(idle, slots)
        state.body_of_shape[state.body_of_shape == idle] = slots - 1

    def reserve_shapes(self, shapes: int, vertices: int, most: int) -> None:
        """Reserve rows for so many shapes and vertices in all, of one shape at most so many.

        Small scenes get rows for the contacts of a pile: to make arrays longer takes many steps.
        """
        self._reserve_clip(most)
        capacities, taken = self.capacities, self.capacities.shapes
        if shapes <= taken and vertices <= capacities.vertices:
            return
        longer = {}
        if shapes > capacities.shapes:
            longer["shapes"] = max(shapes, capacities.shapes * 3 // 2)
            contacts = min(CONTACTS_OF_SHAPE * shapes, MOST_FORESEEN)
            longer["contacts"] = max(contacts, capacities.contacts)
            longer["candidates"] = max(contacts, capacities.candidates)
            longer["blocks"] = max(contacts // CONTACTS_OF_BLOCK, capacities.blocks)
        if vertices > capacities.vertices:
            longer["vertices"] = max(vertices, capacities.vertices * 3 // 2)
        self.resize(**longer)
        self.world.state.body_of_shape[taken:] = capacities.slots - 1

    def set_pair_overrides(self, rows: Array) -> None:
        """Set what two shapes have together: rows (k, 4), sorted by shapes."""
        self.resize(overrides=len(rows))
        self.world.shapes.pair_overrides[:] = rows

    def assign_slots(self, rows: Integers, slots: Integers) -> None:
        """Give some bodies other slots, which together were theirs."""
        state = self.world.state
        state.slot_of_body[rows], state.body_of_slot[slots] = slots, rows

    def copy_to_slots(self, rows: Integers) -> None:
        """Bring what some bodies are, which are new or gone, to their slots."""
        state, bodies = self.world.state, self.world.bodies
        slots = state.slot_of_body[rows]
        bodies.properties[slots], bodies.kind[slots] = state.properties[rows], state.kind[rows]
        self.world.shapes.slot[:] = np.minimum(state.slot_of_body[state.body_of_shape], self.size)

    def clear(self, rows: IntArray) -> None:
        """Forget all that is known of some bodies, which were taken out."""
        state = self.world.state
        at, slots = index_of(rows.tolist()), index_of(state.slot_of_body[rows].tolist())
        for values in (state.pose, state.properties, state.kind):
            values[at] = 0
        if self._by_slot is None:
            self._by_slot = tuple(arrays_by_slot(self.world))
        for values in self._by_slot:
            values[slots] = 0

    def wake(self, rows: NDArray[np.integer]) -> None:
        """Wake bodies that sleep, with their islands."""
        self.world.control.counts[tb.ALL_ASLEEP] = 0
        if not len(rows):
            return
        links = self.world.islands.links
        asleep = links[self.world.state.slot_of_body[rows], tb.SLEEP_ID]
        if asleep.any():
            woken = np.isin(links[:, tb.SLEEP_ID], asleep[asleep > 0])
            links[woken, tb.SLEEP_ID] = links[woken, tb.SLOW_STEPS] = 0

    def forget_pairs(self) -> None:
        """Look for pairs anew at the next step."""
        self.world.broad_phase.counts[tb.LIST_HOLDS] = 0
        self.revision += 1
        if self._slots != self.size + 1:
            self._tell_size()

    def _tell_size(self) -> None:
        """Let the argument tell of the slots that are in use now."""
        if self._argument is None or not self.compiled:
            self.forget_addresses()
            return
        self._slots = self.size + 1
        self._argument[shortened_rows(), 1] = self._slots

    def _reserve_clip(self, most: int) -> None:
        """Reserve rows to clip two shapes with so many vertices."""
        if 2 * most >= self.capacities.clip:
            self.resize(clip=2 * most + 1)
