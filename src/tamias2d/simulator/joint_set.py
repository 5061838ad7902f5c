"""The joints of a simulator: which there are, by their names."""

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from copy import copy
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from tamias2d.engine.engine import Engine
from tamias2d.motion.joint_events import BREAKS, CLICKS, JointEvent
from tamias2d.scene.freedoms import (
    Freedom,
    JointSpring,
    refuse_rest,
    with_limits,
    with_motor,
    with_spring,
)
from tamias2d.scene.joint_checks import checked_joint
from tamias2d.scene.joints import End, Joint
from tamias2d.scene.placed_bodies import PlacedBodies
from tamias2d.scene.rules import RuleError, Vector, shown
from tamias2d.simulator.joint_columns import JointColumns
from tamias2d.simulator.joint_events import (
    JointWatch,
    LimitEvents,
    on_tooth,
    tooth_of,
    tooth_reached,
)
from tamias2d.simulator.joint_layout import TOTAL_COUNT, JointLayout, by_joint, kept_of_new
from tamias2d.simulator.joint_reactions import Reactions, reactions_of, told
from tamias2d.simulator.moved_limits import Passed
from tamias2d.spec.constraint import ENDS
from tamias2d.state import Array


class GovernedBy(NamedTuple):
    """What governs a freedom of a joint, and is set between steps."""

    part: str
    """its name in `Freedom`"""
    change: Callable[[Freedom, object, str], Freedom]
    """returns a freedom with another one"""
    rule: str
    example: str


LIMITS = GovernedBy("limits", with_limits, "GD21", "some, Limits(lower=, upper=, restitution=)")
MOTOR = GovernedBy("motor", with_motor, "GD22", "one, Motor(speed=, maximum=)")
SPRING = GovernedBy("spring", with_spring, "DD64", "one, JointSpring(stiffness=, damping=)")


def _bounded(joint: Joint) -> bool:
    """Return whether a spring of a joint has a maximum; those are solved otherwise."""
    springs = [each.spring for each in joint.freedoms if each.spring]
    return any(spring.maximum is not None for spring in springs)


class JointSet:
    """Joints by their names."""

    def __init__(self, joints: Iterable[Joint] = (), kept: Array | None = None) -> None:
        """Hold the joints of a scene, or those that were saved, with what a step left of them."""
        self._joints = {joint.name: joint for joint in joints}
        self._layout: JointLayout | None = None
        self._watch: JointWatch | None = None  # where something may happen to them
        self._limits: LimitEvents | None = None
        self._saved = {} if kept is None else by_joint(list(self), kept)  # of rows, until settled
        self._fresh: set[str] = set()  # joints of which the engine has not been told
        self._moved: set[str] = set()  # joints whose point was moved since the engine was told
        self._restored = kept is not None
        self._columns: JointColumns | None = None  # once reactions were asked for
        self.new = bool(self._joints)
        """Whether the engine has to be told of them."""

    def copied(self) -> "JointSet":
        """Return the joints as they are now, for the same engine: they do not change with these."""
        other = copy(self)
        other._joints, other._fresh = dict(self._joints), set(self._fresh)
        other._moved = set(self._moved)
        other._limits = copy(self._limits)
        other._watch = self._watch and self._watch.copied()
        return other

    def __len__(self) -> int:
        return len(self._joints)

    def __iter__(self) -> Iterator[Joint]:
        """Go through the joints as they were added."""
        return iter(self._joints.values())

    @property
    def names(self) -> tuple[str, ...]:
        """Of all joints, as they were added."""
        return tuple(self._joints)

    def add(
        self,
        kind: object,
        ends: tuple[End, End, End],
        anchors: tuple[object, object, object],
        name: str | None,
        collide: object,
        bodies: PlacedBodies,
        bears: tuple[object, object],
        time: float,
    ) -> Joint:
        """Add a joint that fits the places of its bodies; what moves is made to fit by a step.

        It `bears` a force, N, and a torque, N m, or None for any, and is added at a time, s.

        Raises:
            RuleError: it breaks a rule, or its name is taken.
        """
        name = self._free_name(name)
        joint = checked_joint(
            kind, name, ends, anchors, collide, bodies, bears, at_rest=True, time=time
        )
        self._joints[name] = joint
        self._fresh.add(name)
        if self._limits:
            self._limits.forget(name)
        self._change()
        return joint

    def remove(self, name: object) -> Joint:
        """Take a joint out, and return it; raise `RuleError` if there is none of that name."""
        joint = self.named(name)
        self._change()
        return self._joints.pop(joint.name)

    def named(self, name: object) -> Joint:
        """Return the joint of a name; raise `RuleError` if there is none."""
        if not isinstance(name, str) or name not in self._joints:
            raise RuleError(
                f"joint {shown(name)}: the simulator has none such (R13). Name one of "
                f"{shown(list(self._joints))}.",
                "name",
            )
        return self._joints[name]

    def target_of(self, name: object) -> tuple[Joint, int]:
        """Return the joint that holds a point of the plane, and which end of it does.

        Raises:
            RuleError: there is none of that name, or it holds no point of the plane, or two.
        """
        joint = self.named(name)
        held = [
            k
            for k, end in enumerate(ENDS)
            if joint.ends[k] is None and f"anchor_{end}" in joint.functions.parameters
        ]
        if len(held) != 1:
            raise RuleError(
                f"joint '{joint.name}' ({joint.kind}): it holds no point of the plane that could "
                "be moved (TM7). Name one that does, such as a Target().",
                "name",
            )
        return joint, held[0]

    def set_target(self, joint: Joint, end: int, point: Vector) -> None:
        """Move the point of the plane, m, that an end of a joint holds."""
        anchors = list(joint.anchors)
        anchors[end] = point
        self._joints[joint.name] = replace(joint, anchors=(anchors[0], anchors[1], anchors[2]))
        if self._layout is not None and joint.name in self._layout.alike:
            self._change()
        if self.new:
            self._moved.add(joint.name)
        else:
            self.layout.move_anchor(joint.name, ENDS[end], point)

    def governed(self, name: object, by: GovernedBy, given: object) -> Joint:
        """Return a joint with other limits, another motor or spring, for `govern`.

        Raises:
            RuleError: there is none of that name, it has nothing such, or a value breaks a rule.
        """
        joint = self.named(name)
        if not any(getattr(each, by.part) for each in joint.freedoms):
            raise RuleError(
                f"joint '{joint.name}' ({joint.kind}): it has no {by.part} that could be set "
                f"({by.rule}). Give it {by.example}, as you add it.",
                "name",
            )
        of = f"joint '{joint.name}'"
        if joint.kind == "target" and isinstance(given, JointSpring):
            refuse_rest(given, of)
        freedoms = tuple(
            by.change(each, given, of) if getattr(each, by.part) else each
            for each in joint.freedoms
        )
        return joint if freedoms == joint.freedoms else replace(joint, freedoms=freedoms)

    def govern(self, joint: Joint) -> bool:
        """Let a joint be governed as one that `governed` returned; return whether that is new."""
        before = self._joints[joint.name]
        if joint is before:
            return False
        self._joints[joint.name] = joint
        if self._layout is not None and not self.new:
            self._layout.govern(joint, before)
            if joint.name in self._layout.alike or _bounded(joint) != _bounded(before):
                self._change()
        return True

    def pull(self, joint: Joint, passed: Sequence[Passed]) -> None:
        """Let limits that were moved past a joint take it along, or bring it back.

        The engine knows of the joint.
        """
        self.layout.pull(joint.name, passed)

    def drop_bodies(self, gone: set[int]) -> list[int]:
        """Take out the joints of bodies that leave; return the other bodies that these held."""
        left = [joint for joint in self._joints.values() if gone & set(joint.bodies)]
        for joint in left:
            del self._joints[joint.name]
        if left:
            self._change()
        return [body for joint in left for body in joint.bodies if body not in gone]

    def renew(self, bodies: set[int]) -> None:
        """Let the engine be told anew of the joints of bodies that got another size."""
        if any(bodies & set(joint.bodies) for joint in self):
            self._change()

    def note_masses(self) -> None:
        """Hear that bodies weigh other numbers than when the engine was told of the joints."""
        if self._layout is not None and not self.new:
            self._layout.note_masses()

    def settle(self, engine: Engine, left: Array) -> None:
        """Tell the engine which joints there are; the last step left bodies at poses (n, 3)."""
        for joint in self:
            if joint.pitch and not math.isfinite(tooth_of(joint)):
                self._joints[joint.name] = on_tooth(joint, tooth_reached(joint, engine.pose))
        joints = list(self)
        pushed = self._limits.pushed if self._limits else {}
        self._layout = JointLayout(engine, joints, self.kept(engine, left), restored=self._restored)
        for name in self._moved.intersection(self._joints):
            self._layout.follow(name)
        self._saved, self._fresh, self._moved = {}, set(), set()
        watched = any(joint.breaks or joint.pitch for joint in joints)
        self._watch = JointWatch(self._layout) if watched else None
        self._limits = LimitEvents(self._layout, pushed)
        self.new = self._restored = False

    @property
    def layout(self) -> JointLayout:
        """Where the engine has them, since it was told of them last."""
        assert self._layout is not None
        return self._layout

    def limit_events(self, steps: int, time_step: float) -> list[JointEvent[str]]:
        """Return which limits were struck and left after so many steps of so many s."""
        return self._limits.after(steps, time_step) if self._limits else []

    @property
    def watched(self) -> bool:
        """Whether steps may break one, or let one click."""
        return self._watch is not None

    def look(
        self, pose: Array, time: float, time_step: float
    ) -> tuple[list[JointEvent[str]], set[int]]:
        """Take over what a step did to joints; return that, and the bodies that are free of one.

        It was one of so many s, which ended at a time, s, with bodies at poses (n, 3).
        """
        if self._watch is None:
            return [], set()
        events = list(self._watch.events(pose, time, time_step))
        for event in events:
            if event.what == CLICKS:
                self._click(event)
        broken = [event.joint for event in events if event.what == BREAKS]
        return events, self._break(broken) if broken else set()

    def _click(self, event: JointEvent[str]) -> None:
        before = self._joints[event.joint]
        self._joints[event.joint] = on_tooth(before, event.value)
        if event.joint in self.layout.alike:
            self._change()
        else:
            self.layout.govern(self._joints[event.joint], before)

    def _break(self, names: Sequence[str]) -> set[int]:
        """Take joints out."""
        self._change()
        return {body for name in names for body in self._joints.pop(name).bodies}

    def begin_anew_if_infinite(self) -> bool:
        """Forget what a step left of joints if float64 could not hold it; return whether so."""
        infinite = not bool(np.isfinite(self.layout.kept()).all())
        if infinite:
            self._fresh.update(self._joints)
            self._change()
        return infinite

    def equation_of(self, body: int) -> str | None:
        """Return the name of a joint that holds a body by an equation of its own, or None."""
        held = (joint.name for joint in self if joint.equations and body in joint.bodies)
        return next(held, None)

    def holding(self, body: int) -> str | None:
        """Return the name of a joint that holds a body, or None."""
        return next((joint.name for joint in self if body in joint.bodies), None)

    def kept(self, engine: Engine, left: Array) -> Array:
        """Return what the last step left of each row, as `JointLayout.kept` does.

        Joints go on with it where others come or go. The step left bodies at poses (n, 3).
        """
        if self._layout is not None and not self.new:
            return self._layout.kept()
        known = self._saved
        if self._layout is not None:
            known = by_joint(self._layout.joints, self._layout.kept())
        rows = [
            known[joint.name]
            if joint.name in known and joint.name not in self._fresh
            else kept_of_new([joint], engine, left)
            for joint in self
        ]
        return np.concatenate(rows) if rows else kept_of_new([], engine, left)

    def reactions(self, engine: Engine, time_step: float) -> Reactions:
        """Return what joints exerted in the last step, and how well they hold now."""
        if self._columns is None or not self._columns.are(list(self)):
            self._columns = JointColumns(list(self))
        values = reactions_of(
            self._columns,
            self.totals(engine),
            engine.pose,
            engine.velocity,
            time=engine.time,
            time_step=time_step,
        )
        return Reactions(**told(self.names, values))

    def totals(self, engine: Engine) -> Array:
        """Return what the last step gave in each row, as `JointLayout.totals` does."""
        if self._layout is not None and not self.new:
            return self._layout.totals()
        return self.kept(engine, engine.pose)[:, :TOTAL_COUNT]

    def _change(self) -> None:
        """Note that the engine has to be told of joints."""
        self.new, self._restored = True, False

    def _free_name(self, name: object) -> str:
        if name is None:
            k = len(self._joints)
            while f"joint{k}" in self._joints:
                k += 1
            return f"joint{k}"
        if not isinstance(name, str) or not name or name in self._joints:
            raise RuleError(
                f"name {shown(name)} of a joint: must be a text of its own (R1). Give another, or "
                "none.",
                "name",
            )
        return name
