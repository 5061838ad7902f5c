"""The engine: bodies that can be added, changed and asked for, between calls that take steps."""

from collections.abc import Mapping, Sequence
from weakref import proxy

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.engine.arrays.world import Capacities
from tamias2d.engine.bodies.batch import Batch
from tamias2d.engine.bodies.body_pool import BodyPool
from tamias2d.engine.joints.joint_row import JointRow
from tamias2d.engine.joints.rows import kept_apart, set_joints
from tamias2d.engine.query_tree import QueryTree
from tamias2d.engine.reports.contact_report import Contacts, contact_report
from tamias2d.engine.reports.open_corners import OpenCorners
from tamias2d.engine.springs.rows import SpringRow, set_springs
from tamias2d.engine.step_calls import StepCalls
from tamias2d.scene.compound import Shape
from tamias2d.state import Array


class Engine(StepCalls):
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
        control = self.world.control
        control.settings[tb.GRAVITY_X : tb.GRAVITY_Y + 1] = gravity
        control.settings[tb.TIME_STEP], control.counts[tb.SUBSTEPS] = time_step, substeps
        self.world.broad_phase.counts[tb.HORIZON] = 4
        self.forms = 0  # changes whenever bodies get other shapes
        self.begin(np.zeros(0, dtype=np.int64), np.zeros(0, dtype=np.int64))

    def begin(self, rank: NDArray[np.int64], generation: NDArray[np.int64]) -> None:
        """Find out what the arrays hold; bodies have ranks and generations (n,), as told below."""
        self.begin_calls()
        store = proxy(self)  # what an engine holds does not hold it: it is freed with its last user
        self._pool = BodyPool(store, rank, generation)
        self._pool.publish_order()
        self._corners = OpenCorners()
        self.queries = QueryTree(store)

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
        """How often something was found to tell, of the next three or of joints."""
        return self.world.control.counts.item(tb.LIMITS)  # asked for in each step

    @property
    def sunk(self) -> tuple[int, int] | None:
        """The rows of the first two bodies that sank into each other, or None."""
        return self._noted(tb.SUNK_A, tb.SUNK_B)

    @property
    def pressed(self) -> tuple[int, int] | None:
        """The rows of the first two bodies that loads pressed together too hard, or None."""
        return self._noted(tb.PRESSED_A, tb.PRESSED_B)

    def _noted(self, a: int, b: int) -> tuple[int, int] | None:
        """Return the rows of two bodies whose slots were noted in two columns, or None."""
        counts, row = self.world.control.counts, self.world.state.body_of_slot
        first, second = int(counts[a]), int(counts[b])
        return (int(row[first - 1]), int(row[second - 1])) if first else None

    @property
    def outweighed(self) -> int:
        """The row of a body among masses too different to be solved, or -1."""
        slot = int(self.world.control.counts[tb.OUTWEIGHED])
        return int(self.world.state.body_of_slot[slot - 1]) if slot else -1

    def open_corner(self) -> tuple[int, int, int] | None:
        """The rows of two thin walls that only just meet, and of a thin body; or None."""
        return self._corners.find(self.world.state, self.world.shapes)

    def know_corners(self) -> None:
        """Take it that walls were asked about before, and that what they were was told."""
        self._corners.know(self.world.state, self.world.shapes)

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
        """State columns of the material of bodies, each (k,); return whether any changed."""
        return self._pool.set_surfaces(rows, columns)

    def set_part_surfaces(
        self, rows: NDArray[np.int64], parts: NDArray[np.int64], columns: Mapping[int, Array]
    ) -> bool:
        """State columns of the material of a part of each body (k,); return whether any changed.

        The engine has settled.
        """
        return self._pool.set_part_surfaces(rows, parts, columns)

    def count_parts(self, rows: NDArray[np.int64]) -> NDArray[np.int64]:
        """Return how many parts bodies have (k,), 0 for those that are of one piece, or chains."""
        return self._pool.count_parts(rows)

    def set_masses(
        self, rows: NDArray[np.int64], columns: Mapping[int, Array], rates: Array
    ) -> None:
        """Set inverse masses and inertias by columns, each (k,), and rates of drag (k, 2), 1/s."""
        self._pool.set_masses(rows, columns, rates)
        self.forget_course()

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
        self.forget_library()
        if not restored:
            self._pool.drop_pairs(kept_apart(self))
            self.forget_pairs()
        return places

    def settle(self) -> None:
        """Give what was added its place, and free what was removed; before a step or query."""
        self._pool.settle()

    def take_parted(self) -> list[tuple[int, int]]:
        """Return the pairs of bodies that touched and may no longer, since this was asked last."""
        return self._pool.take_parted()

    def sleep_after(self, steps: int) -> None:
        """Let islands fall asleep that have been slow for so many steps; 0 for never."""
        self.world.islands.counts[tb.SLEEP_STEPS] = steps

    @property
    def sleeps(self) -> bool:
        """Whether islands fall asleep."""
        return bool(self.world.islands.counts[tb.SLEEP_STEPS])

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
