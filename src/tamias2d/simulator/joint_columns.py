"""Joints side by side: their constraints, motors and limits, each kind in columns.

Serves: what is told of joints after a step, which is found for all of a kind at once. Hides: that
joints are values with a name each.
"""

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.scene.joints import Joint
from tamias2d.simulator.joint_rows import row_count, rows_by_law
from tamias2d.spec.constraint import ENDS
from tamias2d.state import Array, IntArray

_SIDES = {tb.LOWER_LIMIT: -1, tb.UPPER_LIMIT: 1}


class Held(NamedTuple):
    """What joints hold, and where: the plane is the body after the last one."""

    bodies: NDArray[np.intp]
    """(j, 3)"""
    anchors: Array
    """(j, 3, 2), m"""

    @classmethod
    def by(cls, joints: Sequence[Joint], first: IntArray | None = None) -> "Held":
        """Return what is held by joints (j,), whose bodies are counted from the first (j,)."""
        bodies = np.array([[-1 if b is None else b for b in joint.ends] for joint in joints])
        bodies = bodies.astype(np.intp).reshape(len(joints), len(ENDS))
        if first is not None:
            bodies = np.where(bodies < 0, -1, bodies + first[:, None])
        anchors = np.array([joint.anchors for joint in joints], dtype=np.float64)
        return cls(bodies, anchors.reshape(*bodies.shape, 2))


class SameConstraint:
    """Joints (k,) of one constraint, or what they measure by one."""

    def __init__(self, joints: Sequence[Joint], number: Iterable[int], held: Held) -> None:
        """Take joints and their numbers among all of which it is known what they hold."""
        self.number = np.array(list(number), dtype=np.intp)
        self.functions = joints[0].functions
        self._bodies = held.bodies[self.number].T
        self._given: dict[str, Any] = {}
        for name in self.functions.parameters:
            given = np.array([joint.given[name] for joint in joints])
            self._given[name] = tuple(given.T) if given.ndim == 2 else given

    def values(self, pose: Array, velocity: Array | None = None) -> dict[str, Any]:
        """Return what the constraint takes, for poses and velocities (n, 3), the plane's last."""
        values = dict(self._given)
        for end, bodies in zip(ENDS, self._bodies, strict=True):
            x, y, turn = pose[bodies].T
            values[f"position_{end}"], values[f"orientation_{end}"] = (x, y), turn
            if velocity is not None:
                u, v, spin = velocity[bodies].T
                values[f"velocity_{end}"], values[f"angular_velocity_{end}"] = (u, v), spin
        return values


class Driven(NamedTuple):
    """Freedoms (k,) of one measure that motors drive."""

    measure: SameConstraint
    rows: IntArray
    """(k,), among those of all joints"""


class JointColumns:
    """Joints (j,) in columns."""

    def __init__(self, joints: Sequence[Joint], first: IntArray | None = None) -> None:
        """Take joints, whose bodies are counted from the first (j,) of each, or from 0."""
        self.joints = tuple(joints)
        self.names = tuple(joint.name for joint in joints)
        counts = [row_count(joint) for joint in joints]
        self.owner = np.repeat(np.arange(len(joints)), counts)
        """(r,), of each row its joint"""
        self.held = Held.by(joints, first)
        self.own = [k for k, joint in enumerate(joints) if joint.equations]
        """Which have equations of their own."""
        rigid = [k for k, joint in enumerate(joints) if joint.rigid and not joint.equations]
        self.kept = [
            SameConstraint([joints[k] for k in own], own, self.held)
            for own in _by(rigid, [joints[k].model for k in rigid])
        ]
        """The constraints that the others keep."""
        laws = list(rows_by_law(joints))
        limits = [(r, k, _SIDES[law]) for r, k, law, _, _ in laws if law in _SIDES]
        self.limits = np.array(limits, dtype=np.int64).reshape(-1, 3).T
        """(3, l), of each limit its row, its joint and its side."""
        motors = [(r, k, joints[k].measured(f, at)) for r, k, law, f, at in laws if law == tb.MOTOR]
        self.driven = [
            Driven(
                SameConstraint([motors[m][2] for m in own], [motors[m][1] for m in own], self.held),
                np.array([motors[m][0] for m in own], dtype=np.int64),
            )
            for own in _by(range(len(motors)), [motor[2].model for motor in motors])
        ]

    def are(self, joints: Sequence[Joint]) -> bool:
        """Return whether these are the columns of some joints."""
        return len(joints) == len(self.joints) and all(
            one is other for one, other in zip(joints, self.joints, strict=True)
        )


def _by(numbers: Iterable[int], keys: Iterable[str]) -> list[list[int]]:
    """Return numbers with the same key together."""
    found: dict[str, list[int]] = {}
    for number, key in zip(numbers, keys, strict=True):
        found.setdefault(key, []).append(number)
    return list(found.values())


def with_plane(rows: Array) -> Array:
    """Return rows (n, 3) of bodies, and zeros for the plane after them."""
    whole = np.zeros((len(rows) + 1, rows.shape[1]))
    whole[:-1] = rows
    return whole
