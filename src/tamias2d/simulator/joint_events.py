"""What happens to joints in a step: some break (GD23), limits are struck, ratchets click (GD21).

The reaction of a step is its mean, and impulses count in it: they have a length here. Those of
rigid bodies, which have none, break nothing. A limit is struck in a step in which it pushes after
one in which it did not, and left in one in which it does not after one in which it did.
"""

import math
from collections.abc import Iterator, Mapping
from copy import copy
from dataclasses import replace
from operator import itemgetter
from typing import Any, TypeAlias

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.generated.constraints import CONSTRAINTS
from tamias2d.generated.definitions import force_load, mean_force, torque_load
from tamias2d.motion.joint_events import BREAKS, CLICKS, LEAVES, STRIKES, JointEvent
from tamias2d.scene.freedoms import last_tooth
from tamias2d.scene.joints import Joint
from tamias2d.simulator.joint_columns import Held, with_plane
from tamias2d.simulator.joint_layout import JointLayout
from tamias2d.simulator.joint_reactions import forces_and_torques
from tamias2d.simulator.joint_rows import rows_by_law
from tamias2d.spec.constraint import ENDS
from tamias2d.state import Array

_End: TypeAlias = tuple[str, int, bool]
"""A joint, which of its freedoms, and whether the end is the upper one."""

_IMPULSES = slice(tb.J_STEP_TOTAL, tb.J_STEP_TOTAL + 6)  # on A and B


class JointWatch:
    """Looks after each step at the joints that may break, and at ratchets."""

    def __init__(self, layout: JointLayout) -> None:
        """Watch joints where the engine has them now."""
        self._layout = layout
        self._breaking = [joint for joint in layout.joints if joint.breaks]
        number = {joint.name: k for k, joint in enumerate(self._breaking)}
        owners = [number.get(layout.joints[k].name, -1) for k in layout.owner.tolist()]
        self._owner = np.array(owners, dtype=np.int64)
        self._places = layout.places[self._owner >= 0]
        self._owner = self._owner[self._owner >= 0]
        self._force_most = _most([joint.break_force for joint in self._breaking])
        self._torque_most = _most([joint.break_torque for joint in self._breaking])
        self._twisted = np.flatnonzero(np.isfinite(self._torque_most))
        held = Held.by(self._breaking)
        self._held = Held(held.bodies[self._twisted, :2], held.anchors[self._twisted, :2])
        self._ratchets = [joint for joint in layout.joints if joint.pitch]
        self._teeth = {joint.name: tooth_of(joint) for joint in self._ratchets}

    def copied(self) -> "JointWatch":
        """Return one that looks on from here, whatever this one sees."""
        other = copy(self)
        other._teeth = dict(self._teeth)
        return other

    def events(self, pose: Array, time: float, time_step: float) -> Iterator[JointEvent[str]]:
        """Yield what the step, s, did that ended at a time, s, with bodies at poses (n, 3)."""
        for joint, share in self._overloaded(pose, time_step):
            yield JointEvent(time, joint.name, 0, BREAKS, share)
        for joint in self._ratchets:
            tooth = tooth_reached(joint, pose)
            if tooth > self._teeth[joint.name]:
                self._teeth[joint.name] = tooth
                yield JointEvent(time, joint.name, 0, CLICKS, tooth)

    def _overloaded(self, pose: Array, time_step: float) -> list[tuple[Joint, float]]:
        """Return the joints that bore more in a step of so many s than they can, and the share."""
        if not self._breaking:
            return []
        impulses = np.zeros((len(self._breaking), 2, 3))
        of_rows = self._layout.numbers[self._places, _IMPULSES].reshape(-1, 2, 3)
        np.add.at(impulses, self._owner, of_rows)
        force = mean_force((impulses[..., 0], impulses[..., 1]), time_step)
        share = force_load(force, self._force_most[:, None]).max(axis=1)
        if len(self._twisted):
            twisting = impulses[self._twisted]
            _, torque = forces_and_torques(self._held, twisting, with_plane(pose), time_step)
            twisted = torque_load(torque, self._torque_most[self._twisted, None]).max(axis=1)
            share[self._twisted] = np.maximum(share[self._twisted], twisted)
        return [each for each in zip(self._breaking, share.tolist(), strict=True) if each[1] > 1.0]


class LimitEvents:
    """Tells which limits were struck and left, each the last time that it was."""

    def __init__(self, layout: JointLayout, pushed: Mapping[_End, float]) -> None:
        """Take joints where the engine has them now; some of their limits have pushed so far."""
        self._layout = layout
        self._ends: dict[_End, int] = {}
        for r, k, law, freedom, _ in rows_by_law(layout.joints):
            if law in (tb.LOWER_LIMIT, tb.UPPER_LIMIT):
                joint = layout.joints[k]
                end = joint.name, joint.freedoms.index(freedom), law == tb.UPPER_LIMIT
                self._ends[end] = int(layout.places[r])
        for end, impulse in pushed.items():
            if end in self._ends:
                layout.numbers[self._ends[end], tb.J_PUSHED] = impulse

    def forget(self, name: str) -> None:
        """Forget the limits of a joint: another one has its name."""
        self._ends = {end: place for end, place in self._ends.items() if end[0] != name}

    @property
    def pushed(self) -> dict[_End, float]:
        """What limits have given in the last step, N s or N m s."""
        numbers = self._layout.numbers
        return {end: float(numbers[place, tb.J_PUSHED]) for end, place in self._ends.items()}

    def after(self, steps: int, time_step: float) -> list[JointEvent[str]]:
        """Return the events after so many steps of so many s, in the order of their times.

        Where a step leaves one end and strikes the other, it leaves first.
        """
        found: list[tuple[float, int, JointEvent[str]]] = []
        for (name, freedom, upper), place in self._ends.items():
            columns = (tb.J_STRUCK_AT, tb.J_LEFT_AT, tb.J_STRIKE)
            struck, left, impulse = self._layout.numbers[place, columns].tolist()
            if struck > steps:
                what = STRIKES + upper
                event = JointEvent(struck * time_step, name, freedom, what, impulse)
                found.append((struck, 1, event))
            if left > steps:
                event = JointEvent(left * time_step, name, freedom, LEAVES + upper)
                found.append((left, 0, event))
        return [event for *_, event in sorted(found, key=itemgetter(0, 1))]


def _most(borne: list[float | None]) -> Array:
    return np.array([np.inf if value is None else value for value in borne])


def tooth_reached(joint: Joint, pose: Array) -> float:
    """Return the tooth behind which a ratchet does not go back at poses (n, 3), rad."""
    values: dict[str, Any] = {"joint_angle": 0.0}
    for end, body in zip(ENDS, joint.ends, strict=True):
        values[f"orientation_{end}"] = 0.0 if body is None else float(pose[body, 2])
    (angle,) = CONSTRAINTS[joint.model].constraint(values)
    return last_tooth(float(angle), joint.pitch)


def tooth_of(joint: Joint) -> float:
    """Return the tooth that holds a ratchet, rad; minus infinity as long as there is none."""
    limits = joint.freedoms[0].limits
    return -math.inf if limits is None or limits.lower is None else limits.lower


def on_tooth(joint: Joint, tooth: float) -> Joint:
    """Return a ratchet that a tooth holds, rad."""
    freedom = joint.freedoms[0]
    assert freedom.limits is not None
    limits = replace(freedom.limits, lower=tooth)
    return replace(joint, freedoms=(replace(freedom, limits=limits),))
