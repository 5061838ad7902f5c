"""What happens to joints as a step ends: some break (GD23), and ratchets click (GD21).

The reaction of a step is its mean, and impulses count in it: they have a length here. Those of
rigid bodies, which have none, break nothing.
"""

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.generated.constraints import CONSTRAINTS
from tamias2d.motion.joint_events import BREAKS, CLICKS, WORDS
from tamias2d.scene.freedoms import last_tooth
from tamias2d.scene.joints import Joint
from tamias2d.simulator.joint_layout import JointLayout
from tamias2d.simulator.joint_reactions import Held, forces_and_torques
from tamias2d.spec.constraint import ENDS
from tamias2d.state import Array

_IMPULSES = slice(tb.J_STEP_TOTAL, tb.J_STEP_TOTAL + 3 * len(ENDS))


class JointEvent(NamedTuple):
    """One event in the frame loop."""

    time: float
    """The end of the step, s"""
    joint: str
    """Its name"""
    what: int
    """The number of its word."""
    value: float = 0.0
    """The angle of a tooth, rad"""

    @property
    def words(self) -> str:
        """What it says of the joint: 'breaks' or 'clicks'."""
        return WORDS[self.what]


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
        self._held = Held.by(self._breaking)
        self._force_most = _most([joint.break_force for joint in self._breaking])
        self._torque_most = _most([joint.break_torque for joint in self._breaking])
        self._ratchets = [joint for joint in layout.joints if joint.pitch]
        self._teeth = {joint.name: tooth_of(joint) for joint in self._ratchets}

    def events(self, pose: Array, time: float, time_step: float) -> Iterator[JointEvent]:
        """Yield what the step, s, did that ended at a time, s, with bodies at poses (n, 3)."""
        for joint in self._overloaded(pose, time_step):
            yield JointEvent(time, joint.name, BREAKS)
        for joint in self._ratchets:
            tooth = tooth_reached(joint, pose)
            if tooth > self._teeth[joint.name]:
                self._teeth[joint.name] = tooth
                yield JointEvent(time, joint.name, CLICKS, tooth)

    def _overloaded(self, pose: Array, time_step: float) -> list[Joint]:
        """Return the joints that bore more in a step of so many s than they can."""
        if not self._breaking:
            return []
        impulses = np.zeros((len(self._breaking), len(ENDS), 3))
        rows = self._layout.numbers[self._places, _IMPULSES]
        np.add.at(impulses, self._owner, rows.reshape(-1, len(ENDS), 3))
        force, torque = forces_and_torques(self._held, impulses, pose, time_step)
        over = np.hypot(*force[:, 0].T) > self._force_most
        over |= np.abs(torque[:, 0]) > self._torque_most
        return [joint for joint, too_much in zip(self._breaking, over, strict=True) if too_much]


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
