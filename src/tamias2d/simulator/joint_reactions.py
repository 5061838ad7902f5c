"""What joints exerted in the last step, and how well they hold."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.read_only import read_only
from tamias2d.scene.joints import Joint
from tamias2d.scene.springs import arm
from tamias2d.simulator.joint_drives import drives_of, limits_reached
from tamias2d.simulator.joint_rows import row_count
from tamias2d.simulator.joint_separations import separations
from tamias2d.simulator.told_only import REMEDIES
from tamias2d.spec.constraint import ENDS
from tamias2d.state import Array, IntArray


@dataclass(frozen=True, kw_only=True)
class Reactions:
    """What the j joints of a simulator exerted in its last step, and how well they hold.

    Impulses and forces are told as they act on each of the bodies A, B and C; where there is no
    such body, on the plane. Where joints depend on each other, their shares of the load are those
    of equally firm ones.
    """

    names: tuple[str, ...]
    """Of the joints, as they were added."""
    impulse: Array
    """(j, 3, 2), over the step, N s"""
    force: Array
    """(j, 3, 2), the mean over the step, N"""
    torque: Array
    """(j, 3), likewise, about the anchor, N m"""
    separation: Array
    """(j,), by how much the joint is apart now, m"""
    angular_separation: Array
    """(j,), by how much it is turned against what it keeps, rad"""
    speed: Array
    """(j,), of what a motor drives, now, rad/s or m/s; zero for joints without one"""
    power: Array
    """(j,), what a motor gave on average over the step, times its speed now, W"""
    limit: IntArray
    """(j,), -1 where the lower limit pushed in the step, 1 where the upper one did, or 0 (GD21)"""

    def index(self, name: str) -> int:
        """Return the place of a joint; raise `ValueError` if there is none of that name."""
        return self.names.index(name)


class Held(NamedTuple):
    """What joints hold, and where: the plane is the body after the last one."""

    bodies: NDArray[np.intp]
    """(j, 3)"""
    anchors: Array
    """(j, 3, 2), m"""

    @classmethod
    def by(cls, joints: Sequence[Joint]) -> "Held":
        """Return what is held by joints (j,)."""
        bodies = [[-1 if body is None else body for body in joint.ends] for joint in joints]
        anchors = np.array([joint.anchors for joint in joints], dtype=np.float64)
        shape = (len(joints), len(ENDS))
        return cls(np.array(bodies, dtype=np.intp).reshape(shape), anchors.reshape(*shape, 2))


def forces_and_torques(
    held: Held, impulses: Array, pose: Array, time_step: float
) -> tuple[Array, Array]:
    """Return the mean forces (j, 3, 2), N, and torques about anchors (j, 3), N m, of a step, s.

    The impulses (j, 3, 3), N s, N s and N m s, are about the centres of bodies at poses (n, 3).
    """
    force = impulses[:, :, :2] / time_step
    turns = np.append(pose[:, 2], 0.0)[held.bodies.ravel()]
    anchor_x, anchor_y = held.anchors.reshape(-1, 2).T
    x, y = np.reshape(arm((anchor_x, anchor_y), turns), (2, *held.bodies.shape))
    return force, impulses[:, :, 2] / time_step - (x * force[..., 1] - y * force[..., 0])


def reactions_of(
    joints: Sequence[Joint],
    totals: Array,
    pose: Array,
    velocity: Array,
    *,
    time: float,
    time_step: float,
) -> Reactions:
    """Return what joints (j,) exerted, from what a step of so many s left of each of their rows.

    It ended at a time, s, with bodies at poses and velocities (n, 3).
    """
    owner = np.repeat(np.arange(len(joints)), [row_count(joint) for joint in joints])
    impulses = np.zeros((len(joints), len(ENDS), 3))
    of_rows = totals[:, : 3 * len(ENDS)].reshape(-1, len(ENDS), 3)
    np.add.at(impulses, owner, of_rows)
    force, torque = forces_and_torques(Held.by(joints), impulses, pose, time_step)
    lengths, angles = separations(joints, pose, time)
    speed, power = drives_of(joints, of_rows, pose, velocity, time_step)
    told = {
        "impulse": impulses[:, :, :2].copy(),
        "force": force,
        "torque": torque,
        "separation": lengths,
        "angular_separation": angles,
        "speed": speed,
        "power": power,
        "limit": limits_reached(joints, totals[:, tb.J_PUSHED - tb.J_STEP_TOTAL]),
    }
    return Reactions(
        names=tuple(joint.name for joint in joints),
        **{
            name: read_only(values, f"{name} of the reactions", REMEDIES["reactions"])
            for name, values in told.items()
        },
    )
