"""Calls of compiled code that take steps: how many each, through contacts or ballistic ones.

Serves: the engine. Hides: which compiled code that is, that arrays get longer while a step is taken
and it then goes on, and what becomes of a step that cannot be taken or is interrupted.
"""

from collections.abc import Callable
from functools import partial
from types import SimpleNamespace
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.engine.arrays.store import Store
from tamias2d.engine.arrays.world import Capacities
from tamias2d.engine.interruption import end_if_asked
from tamias2d.engine.menu import JOINTED, chosen, functions
from tamias2d.engine.reports.contact_events import ContactEvents
from tamias2d.engine.steps_per_call import StepsPerCall
from tamias2d.engine.tables import World
from tamias2d.engine.validity import Invalid, first_invalid, overflowed
from tamias2d.state import Array

# what gets longer, and how many rows more than half as many again as are needed
_TOO_SHORT = {
    tb.MORE_CANDIDATES: (("candidates", "contacts"), 32),
    tb.MORE_CONTACTS: (("contacts",), 32),
    tb.MORE_BLOCKS: (("blocks",), 8),
    tb.MORE_SPARSE: (("sparse",), 32),
}


_Take: TypeAlias = Callable[[int], int]
"""Takes some steps; returns how that ended."""


class StepCalls(Store):
    """The arrays of a world, with which steps are taken."""

    def __init__(self, capacities: Capacities, *, compiled: bool) -> None:
        super().__init__(capacities, compiled=compiled)
        self.expects_joints = False  # whether there were any, or may be
        self.begin_calls()

    def begin_calls(self) -> None:
        """Know nothing of calls before the next one."""
        self._library: SimpleNamespace | None = None  # what steps are taken with, once they are
        self._take: _Take | None = None  # takes steps with the arrays as they are
        self._alone = True  # whether it is worth while to try ballistic motion
        self._course_known = False  # whether chunks know where bodies may be
        self._steps_per_call, self._ballistic_steps_per_call = StepsPerCall(), StepsPerCall()

    @property
    def steps(self) -> int:
        """How many steps were taken since the start."""
        return self.world.control.counts.item(tb.STEPS_TAKEN)  # asked for in each call

    @property
    def time(self) -> float:
        """How long that was, s."""
        return self.steps * float(self.world.control.settings[tb.TIME_STEP])

    def expect_joints(self) -> None:
        """Load the code for joints, which takes a while, before there are any."""
        self.expects_joints = True
        functions(JOINTED, compiled=self.compiled)

    def start_over(self) -> None:
        """Forget all steps, where the arrays hold what they did before the first one."""
        control, bodies = self.world.control, self.world.bodies
        substeps = control.counts[tb.SUBSTEPS]
        control.counts[:], control.progress[:] = 0, 0.0
        control.counts[tb.SUBSTEPS] = substeps
        self.world.direct.counts[tb.UNSOLVED] = 0
        bodies.propagators[:] = bodies.propagators_of_level[0]
        self.forget_steps()

    def forget_steps(self) -> None:
        """Begin anew with arrays that hold what they did before the first step."""
        self._alone, self._course_known = True, False
        self.revision += 1

    def forget_addresses(self) -> None:
        """Find the addresses of the arrays, and where bodies may be, anew before they are used."""
        super().forget_addresses()
        self._course_known, self._take = False, None

    def forget_pairs(self) -> None:
        """Look for pairs, and for where bodies may be, anew at the next step."""
        super().forget_pairs()
        self.forget_course()

    def forget_course(self) -> None:
        """Find out where bodies may be anew before they go ballistically."""
        self._course_known = False

    def forget_library(self) -> None:
        """Choose the compiled code anew: joints came or went."""
        self._library = self._take = None

    def step(
        self, count: int = 1, *, untouched: bool = False, events: ContactEvents | None = None
    ) -> Invalid | None:
        """Take some steps; return the value that keeps one from being taken, or None.

        Then the state is as it was before that step. If what a step makes of a body is not finite,
        the body stays as it was before, all others take the step, and contacts are forgotten. What
        users see may be known to be `untouched` since the last step. Of several steps the `events`
        are taken; of one they are left to be noted.
        """
        if untouched and self._skipped(count):
            return None
        timed = count > 1
        told = events if timed else None
        try:
            if count == 1 and not self._alone:  # what is called most takes the shortest way
                status = (self._take or self._prepared())(1)
                if status == tb.DONE:
                    return None
                status = self._continued(status)
                return None if status in (tb.DONE, tb.CLEAR) else self._refused(status)
            while count > 0:
                if timed:
                    end_if_asked()
                if self._alone:
                    asked = min(count, self._ballistic_steps_per_call.most)
                    taken = self._ballistic_steps(asked, timed)
                    count -= taken
                    if taken == asked:
                        continue
                asked = min(count, self._steps_per_call.most)
                if timed:
                    self._steps_per_call.begin()
                if told is not None:
                    told.ask(self)
                status = self._solved_steps(asked)
                taken = asked - int(self.world.control.counts[tb.STEPS_LEFT])
                if told is not None:
                    told.take(self, self.steps)
                if timed:
                    self._steps_per_call.end(taken)
                if status not in (tb.DONE, tb.CLEAR):
                    return self._refused(status)
                count -= taken
        except BaseException:  # Ctrl-C, or no memory
            if told is not None:
                told.take(self, self.steps)
            if self.world.control.counts[tb.STAGE] != tb.AT_START:
                self._forget_contacts()
            raise
        return None

    @property
    def step_function(self) -> Callable[..., int]:
        """What takes steps in many worlds, by their tables of addresses."""
        step: Callable[..., int] = self._entries.step
        return step

    @property
    def alone(self) -> bool:
        """Whether bodies may be near nothing: the next step is ballistic if they are."""
        return self._alone

    def begin_together(self, events: ContactEvents | None) -> None:
        """Begin steps that a call takes together with those of other worlds.

        Of several steps the `events` are taken as they end.
        """
        _ = self.argument
        self._course_known = False
        self.world.control.counts[tb.EVENTS_TOLD] = 0  # as Ctrl-C may have left it
        if events is not None:
            events.ask(self)

    def end_together(self, status: int, events: ContactEvents | None) -> Invalid | None:
        """Go on with steps that such a call began, and which ended somehow, as `step` does."""
        try:
            status = self._continued(status)
        except BaseException:  # no memory, or Ctrl-C
            if self.world.control.counts[tb.STAGE] != tb.AT_START:
                self._forget_contacts()
            raise
        finally:
            if events is not None:
                events.take(self, self.steps)
        if status not in (tb.DONE, tb.CLEAR):
            return self._refused(status)
        return self.step(self.steps_left, events=events) if self.steps_left else None

    @property
    def steps_left(self) -> int:
        """How many of the steps that were asked for have not been taken."""
        return self.world.control.counts.item(tb.STEPS_LEFT)

    def step_worlds(
        self,
        memory: NDArray[np.int64],
        start: NDArray[np.int64],
        rows: NDArray[np.int64],
        given: Array,
        stands_for: NDArray[np.int64],
        stops: NDArray[np.int64],
        states: Array,
    ) -> int:
        """Step many worlds in the memory of this engine, as `world_batch` says; none has joints."""
        done: int = self._entries.step_worlds(
            self.argument, memory, start, rows, given, stands_for, stops, states
        )
        return done

    def _skipped(self, count: int) -> bool:
        """Count some steps as taken if all bodies sleep through them."""
        control, broad_phase = self.world.control.counts, self.world.broad_phase.counts
        asleep = bool(control[tb.ALL_ASLEEP] and broad_phase[tb.LIST_HOLDS])
        if asleep:
            control[tb.STEPS_TAKEN] += count
            broad_phase[tb.STEPS_SINCE] += count
        return asleep

    @property
    def _entries(self) -> SimpleNamespace:
        """The compiled functions, found when a step is taken: joints have to be known by then."""
        if self._library is None:
            joints = bool(self.world.joints.counts[tb.JOINTS])
            library = chosen(joints=joints, had_joints=self.expects_joints)
            self._library = functions(library, compiled=self.compiled)
        return self._library

    def _ballistic_steps(self, count: int, timed: bool) -> int:
        """Take up to some steps while all bodies are alone; return how many."""
        if not self._course_known:
            self._entries.note_course(self.argument)
            self._course_known = True
        if timed:
            self._ballistic_steps_per_call.begin()
        taken: int = self._entries.integrate_ballistic(self.argument, count)
        if timed:
            self._ballistic_steps_per_call.end(taken)
        return taken

    def _solved_steps(self, count: int) -> int:
        """Take up to some steps through contacts; return how that ended."""
        self._alone = self._course_known = False
        return self._continued((self._take or self._prepared())(count))

    def _continued(self, status: int) -> int:
        """Go on with steps that ended somehow, as long as an array is too short for them."""
        while status in _TOO_SHORT:
            counts, (names, more) = self.world.control.counts, _TOO_SHORT[status]
            rows = int(counts[tb.ROWS_NEEDED]) * 3 // 2 + more
            self.resize(**{name: max(rows, getattr(self.capacities, name)) for name in names})
            status = self._prepared()(int(counts[tb.STEPS_LEFT]))
        self._alone = status == tb.CLEAR
        return status

    def _prepared(self) -> _Take:
        """Return what takes steps, bound to the arrays until these are replaced."""
        step = self._entries.step
        if self.compiled:
            self._take = partial(step, self.argument[None], np.zeros(1, dtype=np.int64))
        else:
            self._take = partial(_overflowing(step), self.argument)
        return self._take

    def _refused(self, status: int) -> Invalid:
        """Return why a step was not taken, or not by all bodies."""
        if status != tb.OVERFLOWED:
            return first_invalid(self)
        invalid = overflowed(self)
        self._forget_contacts()
        return invalid

    def _forget_contacts(self) -> None:
        """Give up a step, and forget all that is known of contacts."""
        world = self.world
        counts = world.control.counts
        counts[tb.STAGE] = tb.AT_START
        counts[tb.TICK] = counts[tb.RETAKEN] = counts[tb.LEAST_LEVEL] = 0
        broad_phase = world.broad_phase.counts
        broad_phase[tb.NEXT_LEVEL] = broad_phase[tb.CONTACTS] = broad_phase[tb.FIRST_RUN] = 0
        for values in (
            *(world.bodies.motion, world.bodies.moved, world.broad_phase.left),
            *(world.buffers.flags, world.buffers.manifolds, world.buffers.axes),
            world.touching.counts,
            *(world.broad_phase.frame, world.broad_phase.fat_bounds),
            *(world.tree.boxes, world.tree.nodes, world.tree.centres),
        ):
            values[...] = 0
        world.shapes.world_vertices[...] = world.shapes.local_vertices
        self.forget_pairs()


def _overflowing(step: Callable[..., int]) -> Callable[..., int]:
    """Return plain Python steps that end where a number is not whole, as compiled ones do."""

    def take(world: World, count: int) -> int:
        try:
            return step(world, count)
        except (ValueError, OverflowError, ZeroDivisionError):
            return tb.OVERFLOWED  # Python makes no whole number of NaN; compiled code goes on

    return take
