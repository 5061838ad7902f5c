"""The frame loop for games: bodies in arrays that can be read and written between steps."""

import hashlib
from collections.abc import Mapping
from copy import deepcopy
from dataclasses import asdict, fields
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tamias2d.attribute_suggestions import names_elsewhere
from tamias2d.engine.engine import Engine
from tamias2d.engine.saving.saved_checks import UnfitError
from tamias2d.engine.saving.saved_state import restored_engine, rewind, saved_arrays
from tamias2d.engine.saving.state_copy import copy_state, restore_state
from tamias2d.engine.tables import ABSENT, DYNAMIC, STATIC
from tamias2d.errors import RecordingError
from tamias2d.recording_file import checked_path
from tamias2d.scene import Body, Scene, scene_text
from tamias2d.scene.acting import feels_mass
from tamias2d.scene.joints import Joint, kept_apart
from tamias2d.scene.rules import checked_flag
from tamias2d.scene.scene_data import checked_scene
from tamias2d.simulator import saving
from tamias2d.simulator.acting_scene import acts_on_all
from tamias2d.simulator.altering import Altering
from tamias2d.simulator.asking import Asking
from tamias2d.simulator.batch import scene_batch
from tamias2d.simulator.body_names import BodyNames
from tamias2d.simulator.changing import Changing
from tamias2d.simulator.exclusive import exclusive
from tamias2d.simulator.joint_set import JointSet
from tamias2d.simulator.jointing import Jointing
from tamias2d.simulator.kept_state import KeptState, checked_state, copies
from tamias2d.simulator.missing_restitution import refuse_missing_restitution
from tamias2d.simulator.pushing import Pushing
from tamias2d.simulator.saved_joints import restored_events, restored_joints
from tamias2d.simulator.settings import checked_substeps, checked_time_step
from tamias2d.simulator.snapshot import Snapshot
from tamias2d.simulator.told_only import refuses_assignment
from tamias2d.simulator.touching_rules import TouchingRules
from tamias2d.simulator.varying_loads import VaryingLoads
from tamias2d.simulator.warned import Warned
from tamias2d.suggestions import suggests


class Start(NamedTuple):
    """A simulator before its first step."""

    arrays: Mapping[str, NDArray[Any]]
    """Of the engine."""
    joints: tuple[Joint, ...]
    scene: Scene | None
    """What acts on its bodies."""


_SLOW_TIME = 0.5  # s, until an island that is slow falls asleep
_LONGEST_WAIT = 2**31 - 1  # steps


@names_elsewhere({field.name: f"body(k).{field.name}" for field in fields(Body)})
@suggests
@refuses_assignment
class Simulator(Pushing, Changing, TouchingRules, Altering, Jointing, Asking):
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

    __slots__ = ("__weakref__",)

    def __init__(
        self,
        scene: Scene,
        *,
        time_step: float = 1 / 60,
        substeps: int = 4,
        sleeping: bool = False,
        joints: bool = False,
        compiled: bool = True,
    ) -> None:
        """Start where a scene does; steps are of `time_step` in s, contacts solved in substeps.

        With `sleeping`, bodies that touch each other and have been slow for half a second stop and
        cost next to nothing until something happens to them. Slow is what is slower than
        2 % of sqrt(g r), or of r a second without gravity, where r is how far a body reaches from
        its centre: a fall through 1/5000 of that makes it faster. A body that falls asleep loses
        what was left of its motion, so that a run with sleeping is another one than without.

        With `joints`, some are expected to be added: the code for them is loaded now, which takes
        about a second, and not at the first step after `add_joint`. The bits are the same.

        Without `compiled`, steps and queries are plain Python: the same bits, some thousand times
        slower, for debuggers, and where nothing can be compiled.

        Raises:
            InputError: a value breaks a rule (R4).
        """
        checked_scene(scene)
        self._time_step, self._substeps = checked_time_step(time_step), checked_substeps(substeps)
        self._names = BodyNames({body.name: k for k, body in enumerate(scene.bodies)})
        moving = {k: k for k, body in enumerate(scene.bodies) if body.dynamic}
        acts = scene.springs or acts_on_all(scene) or feels_mass(scene)
        acts = acts or not VaryingLoads(scene, moving, self._names.described, Warned()).empty
        self._scene = deepcopy(scene) if acts else None  # what acts is all that is asked of it
        self._joints = JointSet(scene.joints)
        self._staying = set(range(len(scene)))
        engine = Engine(
            gravity=scene.gravity,
            time_step=self._time_step,
            substeps=self._substeps,
            compiled=checked_flag(compiled, "compiled"),
        )
        if checked_flag(sleeping, "sleeping"):
            steps = round(min(_SLOW_TIME / self._time_step, _LONGEST_WAIT))
            engine.sleep_after(max(steps, 1))
        if checked_flag(joints, "joints"):
            engine.expect_joints()
        batch = scene_batch(scene)
        names = [f"'{body.name}'" for body in scene.bodies]
        known = scene.restitution_of_pairs
        apart = dict.fromkeys(kept_apart(scene.joints), 0.0)
        stated = {**apart, **known}
        refuse_missing_restitution(engine, batch, names.__getitem__, stated, scene.place_of)
        engine.add(batch)
        engine.override_pairs(scene.friction_of_pairs, known)
        self._begin(engine)

    # -- keeping

    @exclusive
    def save(self, path: str | Path) -> None:
        """Write all of it to a file (.npz), from which `restore` goes on with the same bits.

        Raises:
            RecordingError: the name does not end in .npz, or the file cannot be written.
        """
        saving.write(checked_path(path), self._arrays())

    @classmethod
    def restore(cls, path: str | Path, *, compiled: bool = True) -> "Simulator":
        """Return the simulator that was saved in a file; it continues with the same bits.

        Without `compiled`, it steps in plain Python.

        Raises:
            RecordingError: there is no file, or it is damaged, of another kind or version.
        """
        checked_flag(compiled, "compiled")
        return _restored(saving.read(checked_path(path)), str(path), compiled)

    @exclusive
    def copy_state(self) -> KeptState:
        """Return the simulator as it is now, in memory, for `restore_state`, any number of times.

        It takes some 10 kB and 2 microseconds for each body of a pile, and 0.2 ms besides.
        """
        self._settle_between()
        self._report()
        return KeptState(
            engine=self._engine,
            bodies=copy_state(self._engine),
            parts=copies(partial(getattr, self)),
            warnings=dict(self._warned.texts),
        )

    @exclusive
    def restore_state(self, state: KeptState) -> None:
        """Let the simulator be what it was as `copy_state` returned a state of it.

        All is as it was then, bodies, joints, names, time, events and what was warned of, and goes
        on with the same bits. Views stay valid, unless bodies came since: then take them anew.

        Raises:
            InputError: it is no state of this simulator (R4).
        """
        state = checked_state(state, self._engine)
        size = self._engine.size
        restore_state(self._engine, state.bodies)
        self._forget()
        for name, part in copies(state.parts.__getitem__).items():
            setattr(self, name, part)
        self._warned.texts = dict(state.warnings)
        if self._engine.size != size:
            self._look()

    @exclusive
    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self._arrays(), "pickle", self._engine.compiled)

    def _arrays(self) -> dict[str, NDArray[Any]]:
        self._settle_between()
        about = saving.About(
            time_step=self._time_step,
            substeps=self._substeps,
            steps=self._engine.steps,
            parts=self._engine.parts,
            names=self._names.rows,
            staying=sorted(self._staying),
            scene=None if self._scene is None else scene_text(self._scene),
            joints=[asdict(joint) for joint in self._joints],
            joint_events=list(self._happened),
            expects_joints=self._engine.expects_joints,
            warnings=self._warned.texts,
        )
        parts = {
            "engine": saved_arrays(self._engine),
            "touching": saving.touching_arrays(self._report()),
        }
        found = {f"{part}.{key}": a for part, arrays in parts.items() for key, a in arrays.items()}
        if self._pushed is not None:
            found["pushed"] = self._pushed
        if self._parted:
            found["parted"] = np.array(self._parted, dtype=np.int64)
        if len(self._joints):
            found["joints"] = self._joints.kept(self._engine, self._left)
            found["left"] = self._left
        return saving.sealed(about, found)

    def _take_over(self, content: Mapping[str, NDArray[Any]], where: str, compiled: bool) -> None:
        about, arrays = saving.opened(content, where)
        self._time_step, self._substeps = about.time_step, about.substeps
        self._names, self._staying = BodyNames(about.names), set(about.staying)
        engine = restored_engine(
            saving.part(arrays, "engine"),
            time_step=about.time_step,
            substeps=about.substeps,
            steps=about.steps,
            parts=about.parts,
            compiled=compiled,
        )
        self._scene = saving.scene_of(about, engine.kind, dynamic=DYNAMIC, where=where)
        self._begin(engine)
        self._warned.texts = about.warnings
        self._joints = JointSet(*restored_joints(about.joints, arrays.get("joints"), engine.kind))
        self._touching = saving.touching_of(saving.part(arrays, "touching"), engine.size)
        self._parted = saving.parted_of(arrays, engine.size)
        self._happened = restored_events(about.joint_events)
        self._pushed = saving.rows_of(arrays, "pushed", engine.size)
        left = saving.rows_of(arrays, "left", engine.size)
        self._left = self._left if left is None else left
        if about.expects_joints:
            engine.expect_joints()

    def _start(self) -> Start:
        """Return the state before the first step, to which `_rewind` leads back."""
        self._settle_between()
        return Start(saved_arrays(self._engine), tuple(self._joints), self._scene)

    def _rewind(self, start: Start) -> None:
        self._joints, self._scene = JointSet(start.joints), start.scene
        rewind(self._engine, start.arrays)
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

    @exclusive
    def _snapshot(self) -> Snapshot:
        """Return what there is to see now."""
        self._settle_between()
        engine = self._engine
        rows = np.flatnonzero(engine.kind != ABSENT)
        springs = () if self._scene is None else tuple(self._scene.springs)
        return Snapshot(
            time=self.time,
            revision=engine.revision,
            forms=engine.forms,
            rows=rows,
            generation=engine.generation[rows],
            static=np.equal(engine.kind[rows], STATIC).astype(np.int64),
            pose=engine.pose[rows],
            velocity=engine.velocity[rows],
            inverse_mass=engine.inverse_mass[rows],
            inverse_inertia=engine.inverse_inertia[rows],
            joints=tuple(self._joints),
            springs=tuple(s for s in springs if self._staying.issuperset(s.bodies)),
            contact_points=self._report().contacts.point.copy(),
        )

    def __repr__(self) -> str:
        return f"<Simulator of {len(self)} bodies at {self.time:.6g} s>"


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
