"""What happens to joints in a step: some break (GD23), limits are struck, ratchets click (GD21).

The reaction of a step is its mean, and impulses count in it: they have a length here. Those of
rigid bodies, which have none, break nothing. A limit is struck where it pushes after a part of a
step in which it did not, and left where it does not after one in which it did.
"""

import math
from collections.abc import Iterator
from dataclasses import replace
from operator import itemgetter
from typing import Any

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.generated.constraints import CONSTRAINTS
from tamias2d.motion.joint_events import BREAKS, CLICKS, LEAVES, STRIKES, JointEvent
from tamias2d.scene.freedoms import last_tooth
from tamias2d.scene.joints import Joint
from tamias2d.simulator.joint_layout import JointLayout
from tamias2d.simulator.joint_reactions import Held, forces_and_torques
from tamias2d.simulator.joint_rows import rows_by_law
from tamias2d.spec.constraint import ENDS
from tamias2d.state import Array

_IMPULSES = slice(tb.J_STEP_TOTAL, tb.J_STEP_TOTAL + 3)  # on A


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
        held = Held.by(self._breaking)  # its torque is that on A
        self._held = Held(held.bodies[self._twisted, :1], held.anchors[self._twisted, :1])
        self._ratchets = [joint for joint in layout.joints if joint.pitch]
        self._teeth = {joint.name: tooth_of(joint) for joint in self._ratchets}

    def events(self, pose: Array, time: float, time_step: float) -> Iterator[JointEvent[str]]:
        """Yield what the step, s, did that ended at a time, s, with bodies at poses (n, 3)."""
        for joint in self._overloaded(pose, time_step):
            yield JointEvent(time, joint.name, 0, BREAKS)
        for joint in self._ratchets:
            tooth = tooth_reached(joint, pose)
            if tooth > self._teeth[joint.name]:
                self._teeth[joint.name] = tooth
                yield JointEvent(time, joint.name, 0, CLICKS, tooth)

    def _overloaded(self, pose: Array, time_step: float) -> list[Joint]:
        """Return the joints that bore more in a step of so many s than they can."""
        if not self._breaking:
            return []
        impulses = np.zeros((len(self._breaking), 1, 3))
        np.add.at(impulses[:, 0], self._owner, self._layout.numbers[self._places, _IMPULSES])
        over = np.hypot(*(impulses[:, 0, :2] / time_step).T) > self._force_most
        if len(self._twisted):
            twisting = impulses[self._twisted]
            _, torque = forces_and_torques(self._held, twisting, pose, time_step)
            over[self._twisted] |= np.abs(torque[:, 0]) > self._torque_most[self._twisted]
        return [joint for joint, too_much in zip(self._breaking, over, strict=True) if too_much]


class LimitEvents:
    """Tells which limits were struck and left, each the last time that it was."""

    def __init__(self, layout: JointLayout) -> None:
        """Take joints where the engine has them now."""
        self._layout = layout
        self._limits = [
            (r, layout.joints[k], law == tb.UPPER_LIMIT, freedom)
            for r, k, law, freedom, _ in rows_by_law(layout.joints)
            if law in (tb.LOWER_LIMIT, tb.UPPER_LIMIT)
        ]

    def after(self, steps: int, time_step: float) -> list[JointEvent[str]]:
        """Return the events after so many steps of so many s, in the order of their times."""
        found: list[tuple[float, bool, JointEvent[str]]] = []
        for r, joint, upper, freedom in self._limits:
            numbers = self._layout.numbers[self._layout.places[r]]
            struck, left = float(numbers[tb.J_STRUCK_AT]), float(numbers[tb.J_LEFT_AT])
            pushes, of = bool(numbers[tb.J_PUSHED] > 0.0), joint.freedoms.index(freedom)
            if struck > steps:
                what, size = STRIKES + upper, float(numbers[tb.J_STRIKE])
                event = JointEvent(struck * time_step, joint.name, of, what, size)
                found.append((struck, pushes, event))
            if left > steps:
                event = JointEvent(left * time_step, joint.name, of, LEAVES + upper)
                found.append((left, not pushes, event))
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
