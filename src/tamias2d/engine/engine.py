"""The engine: the arrays of a world, and the steps that are taken on them."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine.memory import aligned_copy
from tamias2d.engine.menu import CONTACT
from tamias2d.engine.tables import (
    ANGULAR,
    CHECKED,
    CHUNK,
    CLEAR,
    DECAY,
    DONE,
    GAIN,
    GRAVITY_X,
    HORIZON,
    LIFT,
    LIST_HOLDS,
    MORE_BLOCKS,
    MORE_CANDIDATES,
    MORE_CONTACTS,
    MORE_SPARSE,
    ONE_SUBSTEP,
    ROWS_NEEDED,
    SLEEP_ID,
    SLOW_STEPS,
    STAGE,
    STEPS_LEFT,
    SUBSTEPS,
    TIME_STEP,
    WHOLE_STEP,
    Integers,
)
from tamias2d.engine.world import Rooms, allocated, named_arrays, resized, with_arrays
from tamias2d.generated import drag
from tamias2d.kernels.groups import addresses
from tamias2d.state import Array

_ROOMS = {
    MORE_CANDIDATES: "candidates",
    MORE_CONTACTS: "contacts",
    MORE_BLOCKS: "blocks",
    MORE_SPARSE: "sparse",
}


class Engine:
    """n bodies and m shapes in the arrays that `tables` declares.

    What users see is in the order of adding (`state`), what steps work on is by slots.
    """

    def __init__(
        self,
        *,
        gravity: tuple[float, float],
        time_step: float,
        substeps: int,
        compiled: bool = True,
    ) -> None:
        """Start an empty world; steps are those of plain Python unless they are compiled."""
        self.size = 0  # rows of bodies in use, absent ones too
        self.revision = 0  # changes whenever bodies or shapes come, go or change
        self.rooms = Rooms()
        self.world = allocated(self.rooms)
        self._library = CONTACT.compiled() if compiled else CONTACT.plain()
        self._argument: Any = None  # what compiled or plain code takes as the world
        self._compiled = compiled
        self._alone = True  # whether it is worth while to try ballistic motion
        self._course_known = False  # whether chunks know where bodies may be
        slots = np.arange(self.rooms.slots, dtype=np.uint32)
        self.world.state.slot_of_body[:] = self.world.state.body_of_slot[:] = slots
        control, settings = self.world.control, self.world.control.settings
        settings[GRAVITY_X : GRAVITY_X + 2], settings[TIME_STEP] = gravity, time_step
        control.counts[SUBSTEPS], self.world.broad_phase.counts[HORIZON] = substeps, 4
        self.set_drag_rates(np.zeros((1, 2)))

    # -- arrays

    def arrays(self) -> dict[str, NDArray[Any]]:
        """Return all arrays by their names, and the size as one."""
        return {**named_arrays(self.world), "size": np.array(self.size)}

    def take_over(self, arrays: Mapping[str, NDArray[Any]]) -> None:
        """Continue from the arrays of another engine."""
        self.size = int(arrays["size"])
        found = {name: aligned_copy(a) for name, a in arrays.items() if name != "size"}
        self.world = with_arrays(self.world, found)
        lengths = {
            "slots": len(found["bodies.pose"]),
            "shapes": len(found["shapes.kind"]),
            "vertices": len(found["shapes.local_vertices"]),
            "propagators": len(found["bodies.propagators"]),
            "overrides": len(found["shapes.pair_overrides"]),
            "candidates": len(found["broad_phase.candidates"]),
            "contacts": found["buffers.pairs"].shape[1],
            "blocks": len(found["constraints.blocks"]),
            "sparse": len(found["direct.sparse"]),
            "clip": len(found["events.scratch"]),
        }
        self.rooms = Rooms(**lengths)
        self._forget_addresses()

    def replace(self, **arrays: NDArray[Any]) -> None:
        """Put arrays, by `group__field`, in the place of others of the same rooms."""
        named = {name.replace("__", "."): values for name, values in arrays.items()}
        self.world = with_arrays(self.world, named)
        self._forget_addresses()

    def resize(self, **rooms: int) -> None:
        """Change how many of what there is room for; arrays keep what they hold."""
        if all(getattr(self.rooms, name) == count for name, count in rooms.items()):
            return
        self.rooms = replace(self.rooms, **rooms)
        self.world = resized(self.world, self.rooms)
        self._forget_addresses()

    def set_drag_rates(self, rates: Array) -> None:
        """Let row k of the propagators be that of rates (k, 2), 1/s, of velocity and spin."""
        self.resize(propagators=len(rates))
        self.world.state.drag_rates[:] = rates
        self.world.bodies.propagators[:] = self.propagators(rates)

    def propagators(self, rates: Array) -> Array:
        """Return (k, 12), how bodies move in a step and in a substep (DD41).

        The rates (k, 2) are those at which drag slows down, 1/s: of the velocity, and of the spin.
        """
        found = np.zeros((len(rates), 12))
        control = self.world.control
        whole = control.settings[TIME_STEP]
        one, none = (1.0, 0.0), (0.0, 0.0)
        for start, time in ((WHOLE_STEP, whole), (ONE_SUBSTEP, whole / control.counts[SUBSTEPS])):
            for at, rate in ((start, rates[:, 0]), (start + ANGULAR, rates[:, 1])):
                found[:, at + DECAY] = drag.velocity(one, none, rate, time)[0]
                found[:, at + GAIN] = drag.position(none, one, none, rate, time)[0]
                found[:, at + LIFT] = drag.position(none, none, one, rate, time)[0]
        return found

    def set_pair_overrides(self, rows: Array) -> None:
        """Set what two shapes have together: rows (k, 4), sorted by shapes."""
        self.resize(overrides=len(rows))
        self.world.shapes.pair_overrides[:] = rows

    # -- bodies

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

    def assign_slots(self, rows: Integers, slots: Integers) -> None:
        """Give some bodies other slots, which together were theirs."""
        state = self.world.state
        state.slot_of_body[rows], state.body_of_slot[slots] = slots, rows

    def settle(self, rows: Integers) -> None:
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
        for group in (self.world.bodies, self.world.broad_phase, self.world.islands):
            for name, values in group._asdict().items():
                if name not in ("propagators", "counts", "frame") and len(values) == len(
                    state.pose
                ):
                    values[slots] = 0
        self.world.direct.trees[slots] = 0

    def wake(self, rows: Integers) -> None:
        """Wake bodies that sleep, with their islands."""
        links = self.world.islands.links
        asleep = links[self.world.state.slot_of_body[rows], SLEEP_ID]
        woken = np.isin(links[:, SLEEP_ID], asleep[asleep > 0])
        links[woken, SLEEP_ID] = links[woken, SLOW_STEPS] = 0

    def forget_pairs(self) -> None:
        """Look for pairs anew at the next step."""
        self.world.broad_phase.counts[LIST_HOLDS] = 0
        self.revision += 1
        self._forget_addresses()

    # -- steps

    def step(self, count: int = 1) -> bool:
        """Take some steps; return False, with the state as it was, if a value is not valid."""
        if self._argument is None:
            self._find_addresses()
        counts, checked = self.world.control.counts, 0
        while True:
            if self._alone:
                count -= self._ballistic_steps(count)
                if count == 0:
                    return True
            counts[STEPS_LEFT], counts[CHECKED] = count, checked
            self._alone = self._course_known = False
            while (status := self._library.step(self._argument)) not in (DONE, CLEAR):
                if status not in _ROOMS:
                    counts[STAGE] = 0
                    return False
                self.resize(**{_ROOMS[status]: int(counts[ROWS_NEEDED] * 5 // 4 + 16)})
                self._find_addresses()
                counts = self.world.control.counts
            if status == DONE:
                return True
            self._alone = True
            count, checked = int(counts[STEPS_LEFT]), 1
            if count == 0:
                return True

    def _ballistic_steps(self, count: int) -> int:
        """Take up to some steps while all bodies are alone; return how many."""
        if not self._course_known:
            self._library.note_course(self._argument)
            self._course_known = True
        taken: int = self._library.integrate_ballistic(self._argument, count)
        return taken

    def _forget_addresses(self) -> None:
        self._argument = None
        self._course_known = False

    def _find_addresses(self) -> None:
        vertices = 2 * int(self.world.shapes.vertex_count.max(initial=0))
        if vertices >= self.rooms.clip:
            self.resize(clip=vertices + 1)
        self._argument = addresses(self.world) if self._compiled else self.world
