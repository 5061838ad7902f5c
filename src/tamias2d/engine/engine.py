"""The engine: bodies that can be added, changed and asked for, and the steps that are taken."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from types import SimpleNamespace
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.engine.batch import Batch
from tamias2d.engine.body_pool import BodyPool
from tamias2d.engine.contact_events import ContactEvents
from tamias2d.engine.contact_report import Contacts, contact_report
from tamias2d.engine.interruption import end_if_asked
from tamias2d.engine.joints.joint_row import JointRow
from tamias2d.engine.joints.rows import kept_apart, set_joints
from tamias2d.engine.menu import JOINTED, chosen, functions
from tamias2d.engine.open_corners import OpenCorners
from tamias2d.engine.query_tree import QueryTree
from tamias2d.engine.springs.rows import SpringRow, set_springs
from tamias2d.engine.steps_per_call import StepsPerCall
from tamias2d.engine.store import Store
from tamias2d.engine.tables import World
from tamias2d.engine.validity import Invalid, first_invalid, overflowed
from tamias2d.engine.world import Capacities
from tamias2d.scene.compound import Shape
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


class Engine(Store):
    """n bodies, present or absent, each by its row; SI units."""

    def __init__(
        self,
        *,
        gravity: tuple[float, float],
        time_step: float,
        substeps: int,
        compiled: bool = True,
    ) -> None:
        """Start without bodies; steps of `time_step`, s, are plain Python unless compiled."""
        super().__init__(Capacities(), compiled=compiled)
        self.expects_joints = False  # whether there were any, or may be
        control = self.world.control
        control.settings[tb.GRAVITY_X : tb.GRAVITY_Y + 1] = gravity
        control.settings[tb.TIME_STEP], control.counts[tb.SUBSTEPS] = time_step, substeps
        self.world.broad_phase.counts[tb.HORIZON] = 4
        self.begin(np.zeros(0, dtype=np.int64), np.zeros(0, dtype=np.int64))

    def begin(self, rank: NDArray[np.int64], generation: NDArray[np.int64]) -> None:
        """Find out what the arrays hold; bodies have ranks and generations (n,), as told below."""
        self._library: SimpleNamespace | None = None  # what steps are taken with, once they are
        self._take: _Take | None = None  # takes steps with the arrays as they are
        self._alone = True  # whether it is worth while to try ballistic motion
        self._course_known = False  # whether chunks know where bodies may be
        self._steps_per_call, self._ballistic_steps_per_call = StepsPerCall(), StepsPerCall()
        self._pool = BodyPool(self, rank, generation)
        self._pool.publish_order()
        self._corners = OpenCorners()
        self.forms = 0  # how often bodies got other shapes
        self.queries = QueryTree(self)

    # -- what users see and set

    @property
    def gravity(self) -> Array:
        """The acceleration of all bodies, m/s^2: a view (2,)."""
        return self.world.control.settings[tb.GRAVITY_X : tb.GRAVITY_Y + 1]

    @property
    def pose(self) -> Array:
        """Positions of the centres of mass, m, and orientations, rad: a view (n, 3)."""
        return self.world.state.pose[: self.size]

    @property
    def velocity(self) -> Array:
        """Velocities, m/s, and angular velocities, rad/s: a view (n, 3)."""
        return self.world.state.velocity[: self.size]

    @property
    def load(self) -> Array:
        """Applied forces, N, and torques, N m: a view (n, 3)."""
        return self.world.state.load[: self.size]

    @property
    def kind(self) -> NDArray[np.int8]:
        """ABSENT, STATIC, KINEMATIC or DYNAMIC, of `tables`: a view (n,)."""
        return self.world.state.kind[: self.size]

    @property
    def inverse_mass(self) -> Array:
        """1/kg, 0 for a body that nothing pushes: a view (n,)."""
        return self.world.state.properties[: self.size, tb.INVERSE_MASS]

    @property
    def inverse_inertia(self) -> Array:
        """1/(kg m^2), 0 for a body that nothing turns: a view (n,)."""
        return self.world.state.properties[: self.size, tb.INVERSE_INERTIA]

    @property
    def all_asleep(self) -> bool:
        """Whether all bodies slept through the last step."""
        return bool(self.world.control.counts[tb.ALL_ASLEEP])

    @property
    def asleep(self) -> NDArray[np.bool_]:
        """Which bodies sleep: a new array (n,)."""
        slots = self.world.state.slot_of_body[: self.size]
        return np.greater(self.world.islands.links[slots, tb.SLEEP_ID], 0)

    @property
    def early(self) -> Array:
        """By which share of half a step loads acted before its middle, if they vary: (n,) new."""
        return self.world.bodies.early[self.world.state.slot_of_body[: self.size], tb.SHARE_OF_STEP]

    def put_loads_right(self, vary: bool) -> None:
        """Let contacts turn with loads that vary, and are put right as a step ends (DD53, DD84)."""
        self.world.control.counts[tb.LOADS_VARY] = 1 if vary else 0

    @property
    def rank(self) -> NDArray[np.int64]:
        """Place of each body in the canonical order, -1 for one that is absent or new: (n,)."""
        return self._pool.rank

    @property
    def generation(self) -> NDArray[np.int64]:
        """How many bodies each row has held so far, one that is there included: (n,)."""
        return self._pool.generation

    @property
    def steps(self) -> int:
        """How many steps were taken since the start."""
        return self.world.control.counts.item(tb.STEPS_TAKEN)  # asked for in each call

    @property
    def time(self) -> float:
        """How long that was, s."""
        return self.steps * float(self.world.control.settings[tb.TIME_STEP])

    @property
    def parts(self) -> int:
        """In how many parts the last step was taken where it was finest."""
        return 1 << int(self.world.control.counts[tb.FINEST])

    @property
    def largest_radius(self) -> float:
        """How far the largest body that moves freely reaches from its centre, m; 0 for none."""
        free = self.kind == tb.DYNAMIC
        reach = self.world.state.properties[: self.size, tb.BOUNDING_RADIUS][free]
        return float(reach.max(initial=0.0))

    @property
    def lossy_springs(self) -> int:
        """The row of a body whose springs could not be solved in some step, or -1."""
        springs = self.world.springs
        for n in range(int(springs.counts[tb.NETWORKS])):
            if springs.networks[n, tb.N_LOSES] > 0:
                return int(springs.body[springs.networks[n, tb.N_MEMBER]])
        return -1

    @property
    def joints_fail(self) -> bool:
        """Whether a joint was apart, turned too far, or made energy, since it was asked."""
        counts = self.world.joints.counts
        return bool(counts[tb.JOINTS_APART] or counts[tb.JOINTS_TURNED] or counts[tb.JOINTS_GAINED])

    @property
    def limit_changes(self) -> int:
        """How often limits of joints were struck or left."""
        return self.world.joints.counts.item(tb.LIMIT_CHANGES)  # asked for in each step

    @property
    def limits(self) -> int:
        """How often something was found to tell, of the next two or of joints."""
        return self.world.control.counts.item(tb.LIMITS)  # asked for in each step

    @property
    def sunk(self) -> tuple[int, int] | None:
        """The rows of the first two bodies that sank into each other, or None."""
        counts, row = self.world.control.counts, self.world.state.body_of_slot
        first, second = int(counts[tb.SUNK_A]), int(counts[tb.SUNK_B])
        return (int(row[first - 1]), int(row[second - 1])) if first else None

    @property
    def outweighed(self) -> int:
        """The row of a body among masses too different to be solved, or -1."""
        slot = int(self.world.control.counts[tb.OUTWEIGHED])
        return int(self.world.state.body_of_slot[slot - 1]) if slot else -1

    def open_corner(self) -> tuple[int, int, int] | None:
        """The rows of two thin walls that only just meet, and of a thin body; or None."""
        return self._corners.find(self.world.state, self.world.shapes)

    # -- changes

    def add(self, batch: Batch) -> NDArray[np.int64]:
        """Add bodies, and return their rows (k,); views may have to be taken anew."""
        return self._pool.add(batch)

    def remove(self, rows: NDArray[np.int64]) -> None:
        """Take bodies out; their rows are free once the engine has settled."""
        self._pool.remove(rows)

    def override_pairs(
        self,
        friction: Mapping[tuple[int, int], float],
        restitution: Mapping[tuple[int, int], float],
    ) -> None:
        """Set the friction and restitution of pairs of bodies, given by rows."""
        self._pool.override_pairs(friction, restitution)

    def set_filters(
        self, rows: NDArray[np.int64], columns: Mapping[int, NDArray[np.int64]]
    ) -> bool:
        """Set columns of the filters of bodies, each (k,); return whether any changed."""
        return self._pool.set_filters(rows, columns)

    def set_surfaces(self, rows: NDArray[np.int64], columns: Mapping[int, Array]) -> bool:
        """Set columns of the material of bodies, each (k,); return whether any changed."""
        return self._pool.set_surfaces(rows, columns)

    def set_masses(
        self, rows: NDArray[np.int64], columns: Mapping[int, Array], rates: Array
    ) -> None:
        """Set inverse masses and inertias by columns, each (k,), and rates of drag (k, 2), 1/s."""
        self._pool.set_masses(rows, columns, rates)
        self._course_known = False

    def set_shapes(self, rows: NDArray[np.int64], shapes: Sequence[Shape]) -> None:
        """Give bodies (k,) that have shapes others, each once; the engine has settled."""
        self._pool.set_shapes(rows, shapes)
        self._corners = OpenCorners()
        self.forms += 1

    def stated_restitutions(self) -> set[tuple[int, int]]:
        """The pairs of bodies, the lower row first, for which a restitution is stated."""
        stated = self.world.shapes.pair_overrides
        shapes = stated[stated[:, 3] >= 0.0, :2].astype(np.int64)
        owner = np.sort(self.world.state.body_of_shape[shapes].astype(np.int64), axis=1)
        return set(map(tuple, owner.tolist()))

    def set_springs(self, rows: Sequence[SpringRow]) -> None:
        """Let springs act between bodies, given by rows, in this order, and no others."""
        set_springs(self, rows)

    def set_joints(self, rows: Sequence[JointRow], *, restored: bool) -> list[int]:
        """Let joints hold bodies, given by rows, in this order, and no others.

        Returns the place of each among the joints of the arrays. If the engine was restored with
        them, what it knows of contacts fits them already.
        """
        places = set_joints(self, rows)
        self.expects_joints |= len(rows) > 0
        self._library = self._take = None
        if not restored:
            self._pool.drop_pairs(kept_apart(self))
            self.forget_pairs()
        return places

    def expect_joints(self) -> None:
        """Load the code for joints, which takes a while, before there are any."""
        self.expects_joints = True
        functions(JOINTED, compiled=self.compiled)

    def settle(self) -> None:
        """Give what was added its place, and free what was removed; before a step or query."""
        self._pool.settle()

    def wake(self, rows: NDArray[np.int64]) -> None:
        """Wake bodies that sleep, with their islands."""
        self._pool.wake(rows)

    def sleep_after(self, steps: int) -> None:
        """Let islands fall asleep that have been slow for so many steps; 0 for never."""
        self.world.islands.counts[tb.SLEEP_STEPS] = steps

    @property
    def sleeps(self) -> bool:
        """Whether islands fall asleep."""
        return bool(self.world.islands.counts[tb.SLEEP_STEPS])

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

    # -- answers

    def contact_report(self) -> Contacts:
        """Return what touched in the last step."""
        return contact_report(self)

    def surfaces(self) -> tuple[NDArray[np.int64], Array, NDArray[np.int64]]:
        """Return of the shapes of all bodies (m): body, friction and restitution, and filters.

        Shapes are (m,), (m, 2), -1 where not stated, and (m, 4): category, mask, group, sensor.
        """
        owner = self.world.state.body_of_shape.astype(np.int64)
        there = np.flatnonzero(self.world.state.kind[owner] != tb.ABSENT)
        shapes = self.world.shapes
        stated = shapes.material[there, tb.FRICTION : tb.RESTITUTION + 1]
        return owner[there], stated, shapes.filters[there]

    # -- steps

    def forget_addresses(self) -> None:
        """Find the addresses of the arrays, and where bodies may be, anew before they are used."""
        super().forget_addresses()
        self._course_known, self._take = False, None

    def forget_pairs(self) -> None:
        """Look for pairs, and for where bodies may be, anew at the next step."""
        super().forget_pairs()
        self._course_known = False

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
        step = self._entries.step if self.compiled else _overflowing(self._entries.step)
        self._take = partial(step, self.argument)
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
