"""The frame loop for games: bodies in arrays that can be read and written between steps."""

import hashlib
from collections.abc import Iterable, Mapping
from copy import deepcopy
from dataclasses import asdict
from pathlib import Path
from threading import Lock
from typing import Any
from warnings import warn

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine.batch import Batch
from tamias2d.engine.contact_report import Contacts, Touching
from tamias2d.engine.engine import Engine
from tamias2d.engine.saved_checks import UnfitError
from tamias2d.engine.saved_state import restored_engine, rewind, saved_arrays
from tamias2d.engine.tables import DYNAMIC, KINEMATIC, STATIC
from tamias2d.errors import RecordingError, StepWarning
from tamias2d.scene import Scene, scene_text
from tamias2d.scene.joint_kinds import Equation, Kind
from tamias2d.scene.joints import End, kept_apart
from tamias2d.scene.rules import RuleError, VectorLike, shown, vector
from tamias2d.scene.scene_data import checked_scene
from tamias2d.simulator import saving
from tamias2d.simulator.acting_scene import acting_scene, acts_on_all, with_steady_loads
from tamias2d.simulator.adding import Shapes, added_batch
from tamias2d.simulator.applied import add_rows, applied_loads, velocity_changes
from tamias2d.simulator.batch import scene_batch
from tamias2d.simulator.exclusive import busy, exclusive
from tamias2d.simulator.invalid_state import invalid_state
from tamias2d.simulator.joint_reactions import Reactions
from tamias2d.simulator.joint_set import JointSet
from tamias2d.simulator.missing_restitution import refuse_missing_restitution
from tamias2d.simulator.queries import Hits, bodies_at_point, bodies_in_box, cast_rays
from tamias2d.simulator.saved_joints import restored_joints
from tamias2d.simulator.selection import Bodies, selected
from tamias2d.simulator.settings import (
    checked_count,
    checked_flag,
    checked_substeps,
    checked_time_step,
)
from tamias2d.simulator.spring_rows import spring_rows
from tamias2d.simulator.standing_bodies import StandingBodies
from tamias2d.simulator.step_warnings import (
    SPRINGS,
    Told,
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
from tamias2d.state import Array, IntArray
from tamias2d.suggestions import suggests

_SLOW_TIME = 0.5  # s, until an island that is slow falls asleep
_LONGEST_WAIT, _ENDLESS = 2**31 - 1, 2**63  # steps


@suggests
@refuses_assignment
class Simulator(Views):
    """A scene that is stepped through its contacts, and can be changed between the steps.

    `position` (n, 2), `orientation` (n,), `velocity` (n, 2), `angular_velocity` (n,), `force`
    (n, 2) and `torque` (n,) are views of what the engine works on, in SI units: reading them copies
    nothing, and what is written counts from the next step on. Rows are the bodies in the order of
    the scene and then of adding; the row of a removed body is one of zeros after the next step, and
    then free for one that is added. Adding may put the arrays elsewhere: take a view anew after it.

    Gravity, constant forces and linear and angular drag are solved with the step. Springs and their
    dampers are stable at any stiffness (IM14, DD52); laws, attraction and fields are kicks at both
    ends of the step (DD53), quadratic drag acts in halves around it (DD55). All are of second order
    in the time step where nothing touches; contacts turn with what presses on them (DD84).
    """

    __slots__ = (
        "_jointed",
        "_joints",
        "_limits",
        "_names",
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

    def __init__(
        self,
        scene: Scene,
        *,
        time_step: float = 1 / 60,
        substeps: int = 4,
        sleeping: bool = False,
        compiled: bool = True,
    ) -> None:
        """Start where a scene does; steps are of `time_step` in s, contacts solved in substeps.

        With `sleeping`, bodies that touch each other and have been slow for half a second stop and
        cost next to nothing until something happens to them. Slow is what is slower than
        2 % of sqrt(g r), or of r a second without gravity, where r is how far a body reaches from
        its centre: a fall through 1/5000 of that makes it faster. A body that falls asleep loses
        what was left of its motion, so that a run with sleeping is another one than without.

        Without `compiled`, steps and queries are plain Python: the same bits, some thousand times
        slower, for debuggers, and where nothing can be compiled.

        Raises:
            InputError: a value breaks a rule (R4).
        """
        checked_scene(scene)
        self._time_step, self._substeps = checked_time_step(time_step), checked_substeps(substeps)
        moving = {k: k for k, body in enumerate(scene.bodies) if body.dynamic}
        acts = scene.springs or acts_on_all(scene)
        acts = acts or not VaryingLoads(scene, moving, self._name_of, {}).empty
        self._scene = deepcopy(scene) if acts else None  # what acts is all that is asked of it
        self._names = {body.name: k for k, body in enumerate(scene.bodies)}
        self._joints = JointSet(scene.joints)
        self._staying = list(range(len(scene)))
        engine = Engine(
            gravity=scene.gravity,
            time_step=self._time_step,
            substeps=self._substeps,
            compiled=checked_flag(compiled, "compiled"),
        )
        if checked_flag(sleeping, "sleeping"):
            steps = round(min(_SLOW_TIME / self._time_step, _LONGEST_WAIT))
            engine.sleep_after(max(steps, 1))
        batch = scene_batch(scene)
        names = [f"'{body.name}'" for body in scene.bodies]
        known = scene.restitution_of_pairs
        apart = dict.fromkeys(kept_apart(scene.joints), 0.0)
        stated = {**apart, **known}
        refuse_missing_restitution(engine, batch, names.__getitem__, stated, scene.place_of)
        engine.add(batch)
        engine.override_pairs(scene.friction_of_pairs, known)
        self._begin(engine)

    def _begin(self, engine: Engine) -> None:
        self._lock = Lock()
        self._engine, self._sleeps = engine, engine.sleeps
        self._look()
        self._forget()

    def _forget(self) -> None:
        """Forget what was asked for and told so far."""
        self._varying: VaryingLoads | None = None
        self._warned: dict[str, str] = {}
        self._limits = 0  # of which was told
        self._pushed: Array | None = None  # loads for the next step only
        self._touching: Touching | None = None
        self._unsettled = True

    # -- stepping

    def step(self, count: int = 1) -> None:
        """Take so many steps.

        Raises:
            InputError: a value that was set is not finite; the state is as it was before the step.
            SimulationError: a force that varies has no finite value.

        Warns:
            StepWarning: the time step is too long for a force that varies or for a joint, once for
                each; for springs, gravity, overlaps that grow, or masses, once. Thin walls only
                just meet, where something thin moves, once.
        """
        if count.__class__ is not int or not 0 <= count < _ENDLESS:
            count = checked_count(count, "count", 0)
        if not self._lock.acquire(False):
            raise busy("step")
        try:
            while count:
                if self._unsettled:
                    self._settle()
                self._touching = None
                if self._jointed:
                    self._joints.forget_report()
                if self._varying is None and self._pushed is None:
                    self._advance(count)
                    return
                self._step_loaded()
                count -= 1
        finally:
            self._lock.release()

    def _advance(self, count: int) -> None:
        """Take some steps, or raise `RuleError`."""
        engine, step = self._engine, self._time_step
        untouched = self._sleeps and self._untouched
        if (invalid := engine.step(count, untouched=untouched)) is not None:
            raise invalid_state(invalid, engine.kind, self._name_of)
        self._seen = False
        if (limits := engine.limits) > self._limits:
            self._limits = limits
            self._tell(
                too_long_for_contacts(engine, self._name_of, self.time, step, self._substeps)
            )
            if engine.joints_fail:
                self._tell(too_long_for_joints(self._joints.layout, self.time, step))
        if self._scene is None or SPRINGS in self._warned:
            return
        if (row := engine.lossy_springs) >= 0:
            self._tell([too_long_for_springs(self._name_of(row), self.time, step)])

    def _tell(self, found: Iterable[Told]) -> None:
        """Warn of what the step is too long for, each once."""
        for name, text in found:
            if name not in self._warned:
                self._warned[name] = text
                warn(text, StepWarning, stacklevel=4)

    def _settle(self) -> None:
        """Give what was added its place, and see which loads vary on what is left."""
        self._engine.settle()
        self._unsettled = False
        self._jointed = len(self._joints) > 0
        if self._joints.new:
            self._joints.settle(self._engine)
            self._tell(too_stiff_for_steps(self._joints, self._engine, self._time_step))
        self._varying = None
        if self._scene is not None:
            staying = sorted(self._staying, key=self._engine.rank.__getitem__)
            self._engine.set_springs(spring_rows(self._scene, staying))
            scene, bodies = acting_scene(self._scene, staying, self._engine)
            varying = VaryingLoads(scene, bodies, self._name_of, self._warned)
            self._varying = None if varying.empty else varying
            self._engine.put_loads_right(varying.put_right)
        self._tell(too_long_for_gravity(self._engine, self._time_step))
        self._tell(too_thin_for_corners(self._engine, self._name_of))

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

    # -- state

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
    def warnings(self) -> tuple[str, ...]:
        """What was warned of so far: all for which the step is too long, each once."""
        return tuple(self._warned.values())

    # -- pushing

    @exclusive
    def apply_impulse(self, bodies: Bodies, impulse: object, *, at: object | None = None) -> None:
        """Change velocities by an impulse in N s, (2,) or (k, 2), for each of k bodies.

        It acts at the centres of mass, or `at` points of the world, (2,) or (k, 2), m. A body that
        is given twice gets it twice; what nothing can push, such as a static body, stays as it is.

        Raises:
            InputError: a body is not there, or a value breaks a rule (R4).
        """
        rows = self._rows(bodies)
        changes = velocity_changes(self._engine, rows, impulse, at)
        add_rows(self._engine.velocity, rows, changes, "impulse")

    @exclusive
    def apply_force(self, bodies: Bodies, force: object, *, at: object | None = None) -> None:
        """Push bodies through the next step with a force in N, (2,) or (k, 2), besides `force`.

        It acts at the centres of mass, or `at` points of the world, (2,) or (k, 2), m. What nothing
        can push stays as it is.

        Raises:
            InputError: a body is not there, or a value breaks a rule (R4).
        """
        rows = self._rows(bodies)
        changes = applied_loads(self._engine, rows, force, at)
        pushed = np.zeros((self._engine.size, 3))
        if self._pushed is not None:
            pushed[: len(self._pushed)] = self._pushed
        add_rows(pushed, rows, changes, "force")
        self._pushed = pushed

    @exclusive
    def wake(self, bodies: Bodies) -> None:
        """Wake bodies that sleep, and what they touch; `asleep` tells which do.

        What is moved, pushed or met by something that moves wakes by itself, and so does what
        touched a body that is moved or removed.

        Raises:
            InputError: a body is not there.
        """
        self._engine.wake(self._rows(bodies))

    # -- adding and removing

    @exclusive
    def add(
        self,
        shape: Shapes,
        *,
        mass: object,
        position: object,
        velocity: object = (0.0, 0.0),
        orientation: object = 0.0,
        angular_velocity: object = 0.0,
        force: object = (0.0, 0.0),
        torque: object = 0.0,
        linear_drag: object = 0.0,
        angular_drag: object = 0.0,
        inertia: object = None,
        restitution: object = None,
        friction: object = None,
        category: object = 1,
        mask: object = None,
        group: object = 0,
        sensor: bool = False,
    ) -> Any:
        """Add bodies that move, and return their indices (R2).

        One body where `position` is (2,), with its index; k bodies where it is (k, 2), with an
        array of indices. Of all else, one value serves all, or there is an array with a row for
        each. `shape` is one, or a list of k; the words are those of `Scene.add_body`. Attraction
        and fields of the scene that are for all bodies that move act on them, too.

        Raises:
            InputError: a value breaks a rule (R4), or a field has no finite value where a body is;
                the message names it and its place.
        """
        given = {key: value for key, value in locals().items() if key not in ("self", "shape")}
        batch = added_batch(DYNAMIC, shape, **given)
        if self._scene is not None:
            batch = with_steady_loads(self._scene, batch, self.time)
        return self._add(batch, position)

    @exclusive
    def add_static(
        self,
        shape: Shapes,
        *,
        position: object = (0.0, 0.0),
        orientation: object = 0.0,
        restitution: object = None,
        friction: object = None,
        category: object = 1,
        mask: object = None,
        group: object = 0,
        sensor: bool = False,
    ) -> Any:
        """Add bodies that nothing moves, and return their indices, as `add` does."""
        given = {key: value for key, value in locals().items() if key not in ("self", "shape")}
        return self._add(added_batch(STATIC, shape, **given), position)

    @exclusive
    def add_kinematic(
        self,
        shape: Shapes,
        *,
        position: object,
        velocity: object = (0.0, 0.0),
        orientation: object = 0.0,
        angular_velocity: object = 0.0,
        restitution: object = None,
        friction: object = None,
        category: object = 1,
        mask: object = None,
        group: object = 0,
        sensor: bool = False,
    ) -> Any:
        """Add bodies that move as they are told, and return their indices, as `add` does."""
        given = {key: value for key, value in locals().items() if key not in ("self", "shape")}
        return self._add(added_batch(KINEMATIC, shape, **given), position)

    def _add(self, batch: Batch, position: object) -> Any:
        refuse_missing_restitution(self._engine, batch, self._name_of)
        rows = self._engine.add(batch)
        self._look()
        self._unsettled = True
        one = len(rows) == 1 and np.ndim(position) == 1  # type: ignore[arg-type]
        return int(rows[0]) if one else rows

    @exclusive
    def remove(self, bodies: Bodies) -> None:
        """Take bodies out; the indices of all others stay; springs and joints that held them go.

        Raises:
            InputError: a body is not there.
        """
        rows = np.unique(self._rows(bodies))
        self._engine.wake(np.array(self._joints.drop_bodies(set(rows.tolist())), dtype=np.int64))
        self._engine.remove(rows)
        if self._pushed is not None:
            self._pushed[rows[rows < len(self._pushed)]] = 0.0
        gone = set(rows.tolist())
        self._names = {name: k for name, k in self._names.items() if k not in gone}
        self._staying = [k for k in self._staying if k not in gone]
        self._unsettled = True

    @exclusive
    def add_joint(
        self,
        kind: Kind,
        first: int | str | VectorLike,
        second: int | str | VectorLike | None = None,
        *,
        anchor: VectorLike = (0.0, 0.0),
        other_anchor: VectorLike = (0.0, 0.0),
        third: int | str | None = None,
        third_anchor: VectorLike = (0.0, 0.0),
        name: str | None = None,
        collide: bool = False,
    ) -> str:
        """Tie two bodies, or a body and the plane, and return the joint's name (TM7).

        The words are those of `Scene.add_joint`. The places of the bodies have to fit the joint;
        their velocities do after the next step.

        Raises:
            InputError: a body is not there, a value breaks a rule (R4), the joint moves nothing or
                does not hold where the bodies are, or it is one of its own equation.
        """
        ends = (
            self._end(first),
            (0.0, 0.0) if second is None and isinstance(kind, Equation) else self._end(second),
            (0.0, 0.0) if third is None else self._end(third),
        )
        anchors = (anchor, other_anchor, third_anchor)
        standing: Any = StandingBodies(self._engine, self._names)
        joint = self._joints.add(kind, ends, anchors, name, collide, standing)
        self._engine.wake(np.array(joint.bodies, dtype=np.int64))
        self._unsettled = True
        return joint.name

    @exclusive
    def remove_joint(self, name: str) -> None:
        """Take a joint out; raise `InputError` if there is none of that name."""
        joint = self._joints.remove(name)
        self._engine.wake(np.array(joint.bodies, dtype=np.int64))
        self._unsettled = True

    @exclusive
    def set_target(self, name: str, point: VectorLike) -> None:
        """Move the point of the plane, m, that a joint holds; what it ties follows.

        It costs some 12 microseconds, and may be done before each step, as with a mouse.

        Raises:
            InputError: there is no joint of that name, or it holds no single point of the plane.
        """
        at = vector(point, "position", "a target", "Give a point (x, y) in m.", at=("point",))
        joint = self._joints.set_target(name, at)
        if self._sleeps:
            self._engine.wake(np.array(joint.bodies, dtype=np.int64))
        self._unsettled |= self._joints.new

    @property
    def joints(self) -> tuple[str, ...]:
        """The names of the joints, as they were added."""
        return self._joints.names

    @property
    @exclusive
    def reactions(self) -> Reactions:
        """What joints exerted in the last step, and how well they hold."""
        return self._joints.reactions(self._engine, self._time_step)

    def _end(self, end: object) -> End:
        """Return a body by its row, or a point of the plane."""
        if isinstance(end, str | int | np.integer) and not isinstance(end, bool):
            return int(self._rows(end)[0])  # type: ignore[arg-type]
        return vector(
            end, "position", "a joint", "Give a body, or a point (x, y) in m.", at=("end",)
        )

    def index(self, name: str) -> int:
        """Return the index of a body of the scene by its name; raise `InputError` if none."""
        if not isinstance(name, str):
            raise RuleError(f"name: found {shown(name)}: must be a name (R1). Give a text.", "name")
        return int(self._rows(name)[0])

    # -- what happened

    @property
    @exclusive
    def contacts(self) -> Contacts:
        """All points at which bodies pushed each other in the last step."""
        return self._report().contacts

    @property
    @exclusive
    def began(self) -> Contacts:
        """The pairs that touched in the last step and not before, each with its strongest point.

        Its impulse is that of all points of the pair over the step; that of a sensor is 0.
        """
        return self._report().began

    @property
    @exclusive
    def ended(self) -> IntArray:
        """The pairs (k, 2) that touched before the last step, and not in it.

        What was removed is in none of them.
        """
        return self._report().ended

    # -- queries

    @exclusive
    def ray_cast(self, start: object, end: object, *, mask: int | None = None) -> Hits:
        """Return what rays meet first, from points to points, (2,) or (k, 2) each, m.

        It meets no body in or on which it starts, no sensor, and, if a `mask` is given, none whose
        category shares no bit with it. A line that it runs along is not met.

        Raises:
            InputError: a ray has no length, or a value breaks a rule (R4).
        """
        self._settle_between()
        return cast_rays(self._engine, start, end, mask)

    @exclusive
    def at_point(self, point: object, *, mask: int | None = None) -> IntArray:
        """Return the bodies (k,) at a point (2,), m, but for sensors; `mask` as in `ray_cast`."""
        self._settle_between()
        return bodies_at_point(self._engine, point, mask)

    @exclusive
    def in_box(self, low: object, high: object, *, mask: int | None = None) -> IntArray:
        """Return the bodies (k,) that reach into a box between two corners (2,), m.

        Sensors are not among them; `mask` is as in `ray_cast`.

        Raises:
            InputError: `low` is beyond `high`, or a value breaks a rule (R4).
        """
        self._settle_between()
        return bodies_in_box(self._engine, low, high, mask)

    def _report(self) -> Touching:
        if self._touching is None:
            self._touching = self._engine.contact_report()
        return self._touching

    # -- keeping

    @exclusive
    def save(self, path: str | Path) -> None:
        """Write all of it to a file (.npz), from which `restore` goes on with the same bits.

        Raises:
            RecordingError: the name does not end in .npz, or the file cannot be written.
        """
        saving.write(Path(path), self._arrays())

    @classmethod
    def restore(cls, path: str | Path, *, compiled: bool = True) -> "Simulator":
        """Return the simulator that was saved in a file; it continues with the same bits.

        Without `compiled`, it steps in plain Python.

        Raises:
            RecordingError: there is no file, or it is damaged, of another kind or version.
        """
        checked_flag(compiled, "compiled")
        return _restored(saving.read(Path(path)), str(path), compiled)

    @exclusive
    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self._arrays(), "pickle", self._engine.compiled)

    def _arrays(self) -> dict[str, NDArray[Any]]:
        self._settle_between()
        about = saving.About(
            time_step=self._time_step,
            substeps=self._substeps,
            steps=self._engine.steps,
            names=self._names,
            staying=self._staying,
            scene=None if self._scene is None else scene_text(self._scene),
            joints=[asdict(joint) for joint in self._joints],
        )
        parts = {
            "engine": saved_arrays(self._engine),
            "touching": saving.touching_arrays(self._report()),
        }
        found = {f"{part}.{key}": a for part, arrays in parts.items() for key, a in arrays.items()}
        pushed = {} if self._pushed is None else {"pushed": self._pushed}
        tied = {"joints": self._joints.kept(self._engine)} if len(self._joints) else {}
        return saving.sealed(about, {**found, **pushed, **tied})

    def _take_over(self, content: Mapping[str, NDArray[Any]], where: str, compiled: bool) -> None:
        about, arrays = saving.opened(content, where)
        self._time_step, self._substeps = about.time_step, about.substeps
        self._names, self._staying = dict(about.names), about.staying
        engine = restored_engine(
            saving.part(arrays, "engine"),
            time_step=about.time_step,
            substeps=about.substeps,
            steps=about.steps,
            compiled=compiled,
        )
        self._scene = saving.scene_of(about, engine.kind, dynamic=DYNAMIC, where=where)
        self._begin(engine)
        self._joints = JointSet(*restored_joints(about.joints, arrays.get("joints"), engine.kind))
        self._touching = saving.touching_of(saving.part(arrays, "touching"), engine.size)
        self._pushed = saving.pushed_of(arrays, engine.size)

    def _start(self) -> dict[str, NDArray[Any]]:
        """Return the state before the first step, to which `_rewind` leads back."""
        self._settle_between()
        return saved_arrays(self._engine)

    def _rewind(self, start: Mapping[str, NDArray[Any]]) -> None:
        rewind(self._engine, start)
        self._forget()

    @exclusive
    def digest(self) -> str:
        """Return the SHA-256 of the time and of the state of all bodies, in canonical order.

        Equal simulators have equal digests, in whatever order they were built.
        """
        self._settle_between()
        engine = self._engine
        there = np.flatnonzero(engine.rank >= 0)
        order = there[np.argsort(engine.rank[there])]
        total = hashlib.sha256(f"{self._engine.steps} {self._time_step!r}".encode())
        for values in (engine.pose, engine.velocity, engine.load):
            total.update(np.ascontiguousarray(values[order] + 0.0).tobytes())
        return total.hexdigest()

    def __repr__(self) -> str:
        return f"<Simulator of {len(self)} bodies at {self.time:.6g} s>"

    def _rows(self, bodies: Bodies) -> IntArray:
        return selected(bodies, self._engine.kind, self._names)

    def _name_of(self, row: int) -> str:
        names: Mapping[int, str] = {k: name for name, k in self._names.items()}
        if row >= self._engine.size:
            return f"body {row - self._engine.size} of those added"
        return f"body '{names[row]}'" if row in names else f"body {row}"


def _restored(content: Mapping[str, NDArray[Any]], where: str, compiled: bool = True) -> Simulator:
    """Return the simulator that was saved as arrays."""
    sim = Simulator.__new__(Simulator)
    try:
        sim._take_over(content, where, compiled)
    except UnfitError as error:
        raise RecordingError(
            f"{where}: {error}. It is damaged, or nobody's saved simulator. Save it again."
        ) from error
    return sim
