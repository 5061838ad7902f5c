"""Steps of the frame loop, and what they warn of."""

from collections.abc import Callable, Collection
from threading import Lock
from typing import TypeAlias, TypeGuard

import numpy as np

from tamias2d.engine.engine import Engine
from tamias2d.engine.interruption import end_if_asked
from tamias2d.engine.reports.contact_events import ContactEvents, TouchReport
from tamias2d.engine.tables import ABSENT
from tamias2d.engine.validity import Invalid
from tamias2d.motion.joint_events import JointEvent
from tamias2d.scene import Scene
from tamias2d.scene.rules import RuleError, shown
from tamias2d.simulator.acting_scene import acting_scene
from tamias2d.simulator.body_names import BodyNames
from tamias2d.simulator.exclusive import busy
from tamias2d.simulator.hand_placed import put_elsewhere
from tamias2d.simulator.invalid_state import invalid_state
from tamias2d.simulator.joint_set import JointSet
from tamias2d.simulator.selection import Bodies, selected
from tamias2d.simulator.settings import checked_steps
from tamias2d.simulator.spring_rows import spring_rows
from tamias2d.simulator.step_warnings import (
    SPRINGS,
    held_beyond_limits,
    too_long_for_contacts,
    too_long_for_gravity,
    too_long_for_joints,
    too_long_for_springs,
    too_stiff_for_steps,
    too_thin_for_corners,
)
from tamias2d.simulator.told_only import refuses_assignment
from tamias2d.simulator.varying_loads import VaryingLoads
from tamias2d.simulator.views import Views
from tamias2d.simulator.warned import Warned
from tamias2d.state import Array, IntArray

Change: TypeAlias = Callable[[], object]
"""Makes a change that was judged, and cannot be refused any more.

A method `_to_set_mass` returns what `set_mass` does, or raises its errors: so whoever has many
simulators can judge what is set in all of them before anything is set in one.
"""

_ENDLESS = 2**63  # steps


@refuses_assignment
class Stepping(Views):
    """What is stepped: an engine, and what acts on its bodies besides."""

    __slots__ = (
        "_events",
        "_happened",
        "_heard",
        "_jointed",
        "_joints",
        "_left",
        "_limit_changes",
        "_limits",
        "_names",
        "_parted",
        "_pushed",
        "_scene",
        "_sleeps",
        "_staying",
        "_substeps",
        "_time_step",
        "_touching",
        "_unsettled",
        "_varying",
        "_warned",
    )  # fmt: skip
    _heard: tuple[list[JointEvent[str]], ...]  # of recorders, which empty them
    _joints: JointSet
    _names: BodyNames
    _staying: set[int]  # rows of the scene's bodies that are there
    _scene: Scene | None  # whose loads vary
    _substeps: int
    _time_step: float
    _warned: Warned

    def _begin(self, engine: Engine) -> None:
        self._lock = Lock()
        self._events = ContactEvents()
        self._engine, self._sleeps = engine, engine.sleeps
        self._heard = ()
        self._warned = Warned()
        self._look()
        self._forget()

    def _forget(self) -> None:
        """Forget what was asked for and told so far."""
        self._varying: VaryingLoads | None = None
        self._warned.texts = {}
        self._limit_changes = 0  # of joints, of which was told
        self._limits = 0  # of which was told
        self._left = self._engine.pose.copy()  # where the last step left bodies
        self._pushed: Array | None = None  # loads for the next step only
        self._touching: TouchReport | None = None
        self._parted: list[tuple[int, int]] = []  # pairs that touched and may no longer
        self._begin_call()
        self._unsettled = True

    def step(self, count: int = 1) -> None:
        """Take so many steps.

        Raises:
            InputError: a value that was set is not finite, or was written into a view that was
                taken before bodies were added, and is lost; the state is as it was before the step.
            SimulationError: a force that varies has no finite value.

        Warns:
            StepWarning: the time step is too long for a force that varies or for a joint, or a body
                was put beyond a joint's limit by hand, once for each; the step is too long for
                springs, gravity, overlaps that grow, or masses, once. Thin walls only just meet,
                where something thin moves, once.
        """
        if count.__class__ is not int or not 0 <= count < _ENDLESS:
            count = checked_steps(count)
        if not self._lock.acquire(False):
            raise busy("step")
        try:
            if self._earlier:
                self._earlier.look()
            self._begin_call()
            nothing_happens = False  # to joints, in the rest of this call
            while count:
                if self._unsettled:
                    self._settle()
                self._touching = None
                self._tell_parted()
                loaded = self._varying is not None or self._pushed is not None
                watched = self._jointed and self._joints.watched
                if not loaded and (nothing_happens or not watched):
                    self._advance(count)
                    return
                if loaded:
                    self._step_loaded()
                else:
                    self._advance(1)
                if watched:
                    self._look_at_joints()
                    nothing_happens = self._engine.all_asleep and not self._unsettled
                count -= 1
                if count:
                    self._events.note(self._engine, self._engine.steps)
                    end_if_asked()
        finally:
            self._lock.release()

    step.__qualname__ = "Simulator.step"  # as Python calls it where its arguments are wrong

    def _begin_call(self) -> None:
        """Forget what happened in the last call of `step`, to joints and between bodies."""
        self._happened: list[JointEvent[str]] = []
        self._events.begin(self._engine.steps)
        if self._touching is not None:
            self._touching = TouchReport(contacts=self._touching.contacts)

    def _tell(self, events: Collection[JointEvent[str]]) -> None:
        """Tell what happened to joints: until the next call of `step`, and to who records."""
        for told in (self._happened, *self._heard):
            told += events

    def _tell_parted(self) -> None:
        """Tell that what touched and may no longer has ended, in the step that follows."""
        if self._parted:
            self._events.tell_parted(self._parted)
            self._parted = []

    def _advance(self, count: int) -> None:
        """Take some steps, or raise `RuleError`."""
        before = 0  # which only joints ask for, as for what was placed
        placed: Collection[str] = ()
        if self._jointed:
            before, placed = self._engine.steps, self._placed_by_hand()
        untouched = self._sleeps and self._untouched
        invalid = self._engine.step(count, untouched=untouched, events=self._events)
        self._take_note(invalid, before, placed)

    def _take_note(self, invalid: Invalid | None, before: int, placed: Collection[str]) -> None:
        """Take note of what the steps after so many did; raise `RuleError` if one cannot be."""
        engine, step = self._engine, self._time_step
        if invalid is not None:
            if self._jointed and self._joints.begin_anew_if_infinite():
                self._unsettled = True
            joints = self._joints.equation_of(invalid.row), self._joints.holding(invalid.row)
            raise invalid_state(invalid, engine.kind, self._name_of, *joints)
        self._seen = False
        if (limits := engine.limits) > self._limits:
            self._limits = limits
            self._warned.tell(
                too_long_for_contacts(engine, self._name_of, self.time, step, self._substeps)
            )
            if engine.joints_fail:
                self._warned.tell(too_long_for_joints(self._joints.layout, placed, self.time, step))
        if self._jointed:
            self._left = engine.pose.copy()
            if (changes := engine.limit_changes) != self._limit_changes:
                self._limit_changes = changes
                self._tell(self._joints.limit_events(before, step))
        if self._scene is None or SPRINGS in self._warned:
            return
        if (row := engine.lossy_springs) >= 0:
            self._warned.tell([too_long_for_springs(self._name_of(row), self.time, step)])

    @property
    def _steps_simply(self) -> bool:
        """Whether the next step is one of the engine, and nothing else has to be done for it."""
        return not (
            self._unsettled
            or self._earlier
            or self._scene is not None
            or not self._engine.compiled
            or self._engine.alone
            or self._pushed is not None
            or (self._jointed and self._joints.watched)
        )

    def _begin_steps(self, count: int) -> None:
        """Begin steps that the engine takes together with those of other worlds."""
        self._begin_call()
        self._touching = None
        self._tell_parted()
        self._engine.begin_together(self._events if count > 1 else None)

    def _end_steps(self, count: int, status: int) -> None:
        """Go on with so many steps that the engine began, and ended somehow; raise `RuleError`."""
        before = self._engine.steps - count + self._engine.steps_left
        events = self._events if count > 1 else None
        self._take_note(self._engine.end_together(status, events), before, ())

    def _placed_by_hand(self) -> tuple[str, ...]:
        """Return the names of joints whose bodies were put elsewhere; tell those beyond limits."""
        placed = put_elsewhere(self._joints, self._left, self._engine)
        if placed:
            still = [joint for joint in placed if not self._joints.layout.is_pulled(joint)]
            self._warned.tell(held_beyond_limits(still, self._engine, self.time))
        return tuple(joint.name for joint in placed)

    def _settle(self) -> None:
        """Give what was added its place, and see which loads vary on what is left."""
        self._engine.settle()
        self._unsettled = False
        self._jointed = len(self._joints) > 0
        if self._joints.new:
            self._joints.settle(self._engine, self._left)
            self._limit_changes = self._engine.limit_changes
            self._warned.tell(too_stiff_for_steps(self._joints, self._engine, self._time_step))
        self._varying = None
        if self._scene is not None:
            staying = sorted(self._staying, key=self._engine.rank.__getitem__)
            self._engine.set_springs(spring_rows(self._scene, staying))
            scene, bodies = acting_scene(self._scene, staying, self._engine)
            varying = VaryingLoads(scene, bodies, self._names.described, self._warned)
            self._varying = None if varying.empty else varying
            self._engine.put_loads_right(varying.put_right)
        self._parted += self._engine.take_parted()
        self._warned.tell(too_long_for_gravity(self._engine, self._time_step))
        self._warned.tell(too_thin_for_corners(self._engine, self._name_of))

    def _settle_between(self) -> None:
        """Settle between steps: contacts are reported before removed bodies are forgotten."""
        if self._unsettled:
            self._report()
            self._settle()

    def _step_loaded(self) -> None:
        """Take a step with loads that count for this one only."""
        engine, varying = self._engine, self._varying
        load, velocity, steps = engine.load.copy(), engine.velocity.copy(), engine.steps
        try:
            if varying is not None:
                varying.begin(engine, self.time, self._time_step)
            if self._pushed is not None:
                engine.load[: len(self._pushed)] += self._pushed
            self._seen = True
            self._advance(1)
        finally:  # a push that cannot be is forgotten, too
            engine.load[:] = load
            self._seen, self._pushed = True, None
            if engine.steps == steps:
                engine.velocity[:] = velocity
        if varying is not None:
            varying.end(engine, self.time, self._time_step)

    def _look_at_joints(self) -> None:
        """Take over what the step did to joints; what was held by one that broke wakes."""
        engine = self._engine
        found, freed = self._joints.look(engine.pose, self.time, self._time_step)
        self._tell(found)
        if freed:
            engine.wake(np.array(sorted(freed), dtype=np.int64))
        self._unsettled |= self._joints.new

    def _report(self) -> TouchReport:
        if self._touching is None:
            engine, events = self._engine, self._events
            events.note(engine, engine.steps)
            self._touching = TouchReport(
                contacts=engine.contact_report(), began=events.began, ended=events.ended
            )
        return self._touching

    @property
    def time(self) -> float:
        """Since the start, s."""
        return self._engine.steps * self._time_step

    @property
    def time_step(self) -> float:
        """s"""
        return self._time_step

    @property
    def substeps(self) -> int:
        """In how many parts a step solves contacts."""
        return self._substeps

    @property
    def parts(self) -> int:
        """In how many parts the last step was taken where it was finest: 1 unless crowds go far.

        A step in which many bodies go farther than they are thick towards others is taken in parts,
        so that none passes another or stands still; each costs about as much as a step (IM12).
        """
        return self._engine.parts

    @property
    def joint_events(self) -> tuple[JointEvent[str], ...]:
        """What happened to joints in the last call of `step`.

        Some broke (GD23), and are gone; ratchets clicked; limits were struck, with an impulse, and
        left, of which each is told as it was the last time in that call (GD21).
        """
        return tuple(self._happened)

    @property
    def warnings(self) -> tuple[str, ...]:
        """What was warned of so far: all for which the step is too long, each once."""
        return tuple(self._warned.texts.values())

    def index(self, name: str) -> int:
        """Return the index of a body by its name; raise `InputError` if there is none."""
        if not isinstance(name, str):
            raise RuleError(f"name: found {shown(name)}: must be a name (R1). Give a text.", "name")
        return int(self._rows(name)[0])

    def name(self, body: int) -> str | None:
        """Return the name of a body by its index, None if it has none.

        Raises:
            InputError: the body is not there.
        """
        return self._names.of_row.get(self._row(body))

    def _rows(self, bodies: Bodies) -> IntArray:
        if self._is_index(bodies):  # what games ask for takes the shortest way
            return np.array((bodies,))
        return selected(bodies, self._engine.kind, self._names.rows)

    def _row(self, body: int | str) -> int:
        """Return the row of one body, or raise `RuleError`."""
        if self._is_index(body):
            return body
        rows = self._rows(body)
        if len(rows) != 1:
            raise RuleError(
                f"body: found {len(rows)} of them: must be one (R1). Ask for one after another.",
                "body",
            )
        return int(rows[0])

    def _is_index(self, body: object) -> TypeGuard[int]:
        """Return whether a plain number is the index of a body."""
        engine = self._engine
        return (
            type(body) is int
            and 0 <= body < engine.size
            and engine.world.state.kind.item(body) != ABSENT
        )

    def _name_of(self, row: int) -> str:
        if row >= self._engine.size:
            return f"body {row - self._engine.size} of those added"
        return self._names.described(row)
