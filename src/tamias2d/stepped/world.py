"""The arrays of the engine, and the step that is taken on them.

Serves: the simulator. Hides: how much room the arrays have, and the kernel.
"""

from collections.abc import Callable
from functools import partial
from inspect import signature
from typing import Any

import numpy as np

from tamias2d.generated import drag
from tamias2d.state import Array
from tamias2d.stepped.alignment import aligned_copy, aligned_zeros
from tamias2d.stepped.coast import COURSE, CREW, LANES_OF, STREAM
from tamias2d.stepped.elimination import WEAVE
from tamias2d.stepped.layout import (
    ANGULAR,
    DECAY,
    ENERGIES,
    FULL,
    GAIN,
    HORIZON,
    LIFT,
    NEEDED,
    NIGHT,
    PHASE,
    QUIET,
    SOUND,
    STILL,
    SUB,
    SUBSTEPS,
    TIME_STEP,
    TOUCH,
    WANTED,
    Whole,
)
from tamias2d.stepped.menu import CONTACT
from tamias2d.stepped.rows import POINTS, WIDTH
from tamias2d.stepped.slabs import MOST_SLABS
from tamias2d.stepped.solver import BENCH
from tamias2d.stepped.step import step
from tamias2d.stepped.surroundings import CLEAR, DONE, MORE_BLOCKS, MORE_FOUND, MORE_PAIRS, MORE_WEB
from tamias2d.stepped.thin import ISLE, WEB
from tamias2d.stepped.tree import lowest

_ORDER = tuple(signature(step).parameters)
_BODY = ("pose", "velocity", "load", "body", "kind")
_SEAT = (
    *("seated_pose", "seated_load", "seated_body", "seated_kind", "motion", "home", "carried"),
    *("used", "island", "rest", "energy", "isle"),
)
SHAPE_ROWS = (
    *("shape_body", "shape_kind", "shape_first", "shape_count", "shape_radius"),
    *("surface", "filters"),
)
_SHAPE = ("shape_seat", "box", "middle", *SHAPE_ROWS)


class World:
    """n bodies and m shapes in arrays whose columns `layout` names.

    Rows of bodies are in the order of adding, as users see them. What the engine works on, which is
    all that is not named in `_BODY`, is by seats: `seat` tells that of a row, `owner` is its
    inverse.
    """

    def __init__(
        self, *, gravity: tuple[float, float], time_step: float, substeps: int, plain: bool = False
    ) -> None:
        """Start an empty world; `plain` takes its steps by the functions as they are."""
        self.size = 0  # rows of bodies in use, absent ones too
        self.pose = aligned_zeros((CREW, 3))
        self.velocity = aligned_zeros((CREW, 3))
        self.load = aligned_zeros((CREW, 3))
        self.body = aligned_zeros((CREW, 8))
        self.kind = aligned_zeros(CREW, dtype=np.int8)
        self.seat = aligned_copy(np.arange(CREW, dtype=np.uint32))
        self.owner = aligned_copy(self.seat)
        self.seated_pose = aligned_zeros((CREW, 3))
        self.seated_load = aligned_zeros((CREW, 3))
        self.seated_body = aligned_zeros((CREW, 8))
        self.seated_kind = aligned_zeros(CREW, dtype=np.int8)
        self.motion = aligned_zeros((CREW, 8))
        self.home = aligned_zeros((CREW, 6))
        self.carried = aligned_zeros((CREW, 16))
        self.used = aligned_zeros(CREW, dtype=np.int64)
        self.island = aligned_zeros((CREW, 7), dtype=np.int32)
        self.rest = aligned_zeros((CREW, 8))
        self.energy = aligned_zeros((CREW, ENERGIES))
        self.isle = aligned_zeros((CREW, ISLE), dtype=np.int32)
        self.web = aligned_zeros((2, WEB), dtype=np.int64)
        self.weave = aligned_zeros((2, WEAVE))
        self.ranked = aligned_zeros((2, 0), dtype=np.uint32)
        self.shape_body = aligned_zeros(0, dtype=np.uint32)
        self.shape_seat = aligned_zeros(0, dtype=np.uint32)
        self.shape_kind = aligned_zeros(0, dtype=np.int32)
        self.shape_first = aligned_zeros(0, dtype=np.int32)
        self.shape_count = aligned_zeros(0, dtype=np.int32)
        self.shape_radius = aligned_zeros(0)
        self.surface = aligned_zeros((0, 4))
        self.filters = aligned_zeros((0, 4), dtype=np.int64)
        self.mixed = aligned_zeros((0, 4))
        self.corner = aligned_zeros((0, 4))
        self.turned = aligned_zeros((0, 4))
        self.box = aligned_zeros((0, 8))
        self.curve = aligned_zeros((5, 256), dtype=np.uint32)
        self.node = aligned_zeros((2, 4))
        self.middle = aligned_zeros((0, 8))
        self.found = aligned_zeros((16, 4), dtype=np.uint32)
        self.pairs = aligned_zeros((2, 16, 4), dtype=np.uint32)
        self.touches = aligned_zeros((2, 16, TOUCH))
        self.traces = aligned_zeros((2, 16, 6), dtype=np.int32)
        self.hits = aligned_zeros((10, 32), dtype=np.uint32)
        self.fill = aligned_zeros((2, 128), dtype=np.int64)
        self.slabs = aligned_zeros((MOST_SLABS + 2, 4), dtype=np.int64)
        self.rows = aligned_zeros((4, WIDTH))
        self.lanes = aligned_zeros((4, POINTS + 1), dtype=np.uint32)
        self.bench = aligned_zeros(BENCH)
        self.times = aligned_zeros(0)
        self.agenda = aligned_zeros((3, 0), dtype=np.int32)
        self.scratch = aligned_zeros((8, TOUCH))
        self.settings = np.array([*gravity, time_step, *np.zeros(10)])
        self.counts = aligned_zeros(25, dtype=np.int64)
        self.counts[SUBSTEPS], self.counts[HORIZON] = substeps, 4
        self.rates = np.zeros((1, 2))  # of drag, 1/s; what follows from each row are the flows
        self.flows = self.flow(self.rates)
        self._engine = CONTACT.plain() if plain else CONTACT.compiled()
        self._arguments: tuple[Any, ...] = ()
        self._coast: Callable[[int], int] = lambda _steps: 0
        self._know_course: Callable[[], None] = lambda: None
        self._alone = True  # whether it is worth while to try to coast
        self._known = False  # whether where bodies coast is known, since homes are as they were

    def flow(self, rates: Array) -> Array:
        """Return (k, 12), how velocity and place flow in a step and in a substep (IM1, IM6).

        The rates (k, 2) are those at which drag slows down, 1/s: of the velocity, and of the spin.
        """
        flows = np.zeros((len(rates), 12))
        whole = self.settings[TIME_STEP]
        one, none = (1.0, 0.0), (0.0, 0.0)
        for start, time in ((FULL, whole), (SUB, whole / self.counts[SUBSTEPS])):
            for at, rate in ((start, rates[:, 0]), (start + ANGULAR, rates[:, 1])):
                flows[:, at + DECAY] = drag.velocity(one, none, rate, time)[0]
                flows[:, at + GAIN] = drag.position(none, one, none, rate, time)[0]
                flows[:, at + LIFT] = drag.position(none, none, one, rate, time)[0]
        return flows

    def sit(self, rows: Whole, seats: Whole) -> None:
        """Give some bodies other seats, which together were theirs."""
        self.seat[rows], self.owner[seats] = seats, rows

    def settle(self, rows: Whole) -> None:
        """Tell the engine of some bodies, which are new or gone, and whose shape is whose."""
        seats = self.seat[rows]
        self.seated_body[seats], self.seated_kind[seats] = self.body[rows], self.kind[rows]
        self.shape_seat[:] = self.seat[self.shape_body]

    def wake(self, rows: Whole) -> None:
        """Wake bodies that sleep, with their islands."""
        nights = self.island[self.seat[rows], NIGHT]
        woken = np.isin(self.island[:, NIGHT], nights[nights > 0])
        self.island[woken, NIGHT] = self.island[woken, QUIET] = 0

    def forget(self) -> None:
        """Look for pairs anew at the next step."""
        self.counts[STILL] = 0
        self._arguments = ()

    def make_room(self, count: int) -> None:
        """Make room for so many bodies more, in whole crews.

        Shapes without a body are those of the idle one.
        """
        if self.size + count < len(self.pose):
            return
        idle = len(self.pose) - 1
        room = max(self.size + count, len(self.pose) * 3 // 2) // CREW * CREW + CREW
        for name in (*_BODY, *_SEAT, "seat", "owner"):
            setattr(self, name, _longer(getattr(self, name), room))
        self.seat[idle:] = self.owner[idle:] = np.arange(idle, room)
        self.shape_body[self.shape_body == idle] = room - 1

    def clear(self, rows: Whole) -> None:
        """Forget all that is known of some bodies."""
        for name in _BODY:
            getattr(self, name)[rows] = 0
        for name in _SEAT:
            getattr(self, name)[self.seat[rows]] = 0

    def make_shape_room(self, shapes: int, corners: int) -> None:
        """Make room for so many shapes and corners in all."""
        if shapes > len(self.shape_body):
            room = max(shapes, len(self.shape_body) * 3 // 2)
            taken = len(self.shape_body)
            for name in _SHAPE:
                setattr(self, name, _longer(getattr(self, name), room))
            self.shape_body[taken:] = len(self.pose) - 1
            self.node = aligned_zeros((2 * lowest(room), 4))
            self.curve = aligned_zeros((5, room + 256), dtype=np.uint32)
        if corners > len(self.corner):
            room = max(corners, len(self.corner) * 3 // 2)
            self.corner, self.turned = _longer(self.corner, room), _longer(self.turned, room)

    def step(self, count: int = 1) -> int:
        """Take some steps; return how they ended: done, or that what was set is not sound."""
        if not self._arguments:
            self._gather_arguments()
        sound = 0
        while True:
            if self._alone:
                if not self._known:
                    self._know_course()
                    self._known = True
                count -= self._coast(count)
                if count == 0:
                    return DONE
            self.counts[WANTED], self.counts[SOUND] = count, sound
            self._alone = self._known = False
            while (status := self._engine.step(*self._arguments)) != DONE:
                if status == CLEAR:
                    break
                if not self._has_more_room(status):
                    self.counts[PHASE] = 0
                    return int(status)
            if status == DONE:
                return DONE
            self._alone = True
            count, sound = int(self.counts[WANTED]), 1
            if count == 0:
                return DONE

    def _has_more_room(self, status: int) -> bool:
        """Make the room that the engine asked for; return whether it was that."""
        room = int(self.counts[NEEDED] * 5 // 4 + 16)
        if status == MORE_FOUND:
            self.found = aligned_zeros((room, 4), dtype=np.uint32)
        elif status == MORE_PAIRS:
            self._more_pairs(room)
        elif status == MORE_BLOCKS:
            self.rows = aligned_zeros((room, WIDTH))
            self.lanes = aligned_zeros((room, POINTS + 1), dtype=np.uint32)
        elif status == MORE_WEB:
            self.web = aligned_zeros((room, WEB), dtype=np.int64)
            self.weave = aligned_zeros((room, WEAVE))
        else:
            return False
        self._list_arguments()
        return True

    def _gather_arguments(self) -> None:
        """Keep what the engine is called with, until an array is another one."""
        corners = 2 * int(self.shape_count.max(initial=0))
        if corners >= len(self.scratch):
            self.scratch = aligned_zeros((corners + 1, TOUCH))
        self._list_arguments()
        self._gather_course()

    def _gather_course(self) -> None:
        """Keep what coasting is called with: a row for each crew."""
        crews = len(self.kind) // CREW
        bodies = (self.pose, self.velocity, self.load)
        poses, velocities, loads = (array.reshape(crews, LANES_OF) for array in bodies)
        course = aligned_zeros((crews, COURSE))
        manner = (self.body, self.flows)
        ahead = (course, aligned_zeros((crews + 1, STREAM)))
        engine = self._engine
        self._know_course = partial(
            engine.know_course, self.kind, *manner, self.home, self.seat, *ahead
        )
        self._coast = partial(
            engine.coast,
            *(self.settings, self.counts, self.kind, poses, velocities, loads),
            *(loads.view(np.int64), *manner, *ahead),
        )
        self._known = False

    def _list_arguments(self) -> None:
        events = len(self.pose) + self.pairs.shape[1]
        if events != len(self.times):
            self.times = aligned_zeros(events)
            self.agenda = aligned_zeros((3, 4 * events), dtype=np.int32)
        self._arguments = tuple(getattr(self, name) for name in _ORDER)

    def _more_pairs(self, room: int) -> None:
        self.hits = aligned_zeros((10, 2 * room), dtype=np.uint32)  # a pair has two bodies
        for name in ("pairs", "touches", "traces"):
            old = getattr(self, name)
            new = aligned_zeros((2, room, old.shape[2]), dtype=old.dtype)
            new[:, : old.shape[1]] = old
            setattr(self, name, new)


def _longer(values: Any, rows: int) -> Any:
    """Return a longer array that begins like this one."""
    new = aligned_zeros((rows, *values.shape[1:]), dtype=values.dtype)
    new[: len(values)] = values
    return new
