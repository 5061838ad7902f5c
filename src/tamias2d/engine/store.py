"""The arrays of a world, which grow: room for bodies and shapes, and what is known of each."""

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine.tables import CHUNK, LIST_HOLDS, Integers
from tamias2d.engine.world import Rooms, allocated, arrays_by_slot, resized, with_arrays
from tamias2d.kernels.groups import addresses
from tamias2d.state import Array


class Store:
    """n bodies and m shapes in the arrays that `tables` declares.

    What users see is in the order of adding (`world.state`), what steps work on is by slots.
    """

    def __init__(self, rooms: Rooms, *, compiled: bool) -> None:
        self.size = 0  # rows of bodies in use, absent ones too
        self.revision = 0  # changes whenever bodies or shapes come, go or change
        self.rooms = rooms
        self.compiled = compiled
        self.world = allocated(rooms)
        self._argument: Any = None
        state = self.world.state
        state.slot_of_body[:] = state.body_of_slot[:] = np.arange(rooms.slots, dtype=np.uint32)

    @property
    def argument(self) -> Any:
        """The world as compiled code takes it, a table of addresses, or as plain code does."""
        if self._argument is None:
            self._make_clip_room()
            self._argument = addresses(self.world) if self.compiled else self.world
        return self._argument

    def replace(self, **arrays: NDArray[Any]) -> None:
        """Put arrays, by `group__field`, in the place of others of the same rooms."""
        named = {name.replace("__", "."): values for name, values in arrays.items()}
        self.world = with_arrays(self.world, named)
        self.forget_addresses()

    def resize(self, **rooms: int) -> None:
        """Change how many of what there is room for; arrays keep what they hold."""
        if all(getattr(self.rooms, name) == count for name, count in rooms.items()):
            return
        self.rooms = replace(self.rooms, **rooms)
        self.world = resized(self.world, self.rooms)
        self.forget_addresses()

    def forget_addresses(self) -> None:
        """Find the addresses of the arrays anew before they are next used."""
        self._argument = None

    def make_room(self, count: int) -> None:
        """Make room for so many bodies more, in whole chunks.

        Shapes without a body are those of the idle one.
        """
        if self.size + count < self.rooms.slots:
            return
        idle = self.rooms.slots - 1
        slots = max(self.size + count, self.rooms.slots * 3 // 2) // CHUNK * CHUNK + CHUNK
        self.resize(slots=slots)
        state = self.world.state
        state.slot_of_body[idle:] = state.body_of_slot[idle:] = np.arange(idle, slots)
        state.body_of_shape[state.body_of_shape == idle] = slots - 1

    def make_shape_room(self, shapes: int, vertices: int) -> None:
        """Make room for so many shapes and vertices in all."""
        rooms, taken = self.rooms, self.rooms.shapes
        if shapes > rooms.shapes:
            self.resize(shapes=max(shapes, rooms.shapes * 3 // 2))
            self.world.state.body_of_shape[taken:] = rooms.slots - 1
        if vertices > rooms.vertices:
            self.resize(vertices=max(vertices, rooms.vertices * 3 // 2))

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
        self.world.shapes.slot[:] = state.slot_of_body[state.body_of_shape]

    def clear(self, rows: Integers) -> None:
        """Forget all that is known of some bodies."""
        slots = self.world.state.slot_of_body[rows]
        state = self.world.state
        for values in (state.pose, state.velocity, state.load, state.properties, state.kind):
            values[rows] = 0
        for values in arrays_by_slot(self.world):
            values[slots] = 0

    def forget_pairs(self) -> None:
        """Look for pairs anew at the next step."""
        self.world.broad_phase.counts[LIST_HOLDS] = 0
        self.revision += 1
        self.forget_addresses()

    def _make_clip_room(self) -> None:
        """Make room to clip the two shapes with most vertices."""
        vertices = 2 * int(self.world.shapes.vertex_count.max(initial=0))
        if vertices >= self.rooms.clip:
            self.resize(clip=vertices + 1)
