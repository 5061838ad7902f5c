"""What joints exerted in the last step, and how well they hold."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.generated import definitions
from tamias2d.read_only import read_only
from tamias2d.scene.springs import arm
from tamias2d.simulator.joint_columns import Held, JointColumns, with_plane
from tamias2d.simulator.joint_drives import drives_of, limits_reached
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


def forces_and_torques(
    held: Held, impulses: Array, pose: Array, time_step: float
) -> tuple[Array, Array]:
    """Return the mean forces (j, 3, 2), N, and torques about anchors (j, 3), N m, of a step, s.

    They are told as DD112 says. The impulses (j, 3, 3), N s, N s and N m s, are about the centres
    of bodies at poses (n + 1, 3), the last one that of the plane.
    """
    force_x, force_y = definitions.mean_force((impulses[..., 0], impulses[..., 1]), time_step)
    torque = definitions.mean_torque(impulses[..., 2], time_step)
    turns = pose[held.bodies.ravel(), 2]
    anchor_x, anchor_y = held.anchors.reshape(-1, 2).T
    x, y = np.reshape(arm((anchor_x, anchor_y), turns), (2, *held.bodies.shape))
    beside = definitions.anchor_torque(torque, (x, y), (force_x, force_y))
    return np.stack((force_x, force_y), axis=-1), beside


def reactions_of(
    joints: JointColumns,
    totals: Array,
    pose: Array,
    velocity: Array,
    *,
    time: float | Array,
    time_step: float,
) -> dict[str, NDArray[Any]]:
    """Return what joints (j,) exerted, from what a step of so many s left of each of their rows.

    It ended at a time, s, for all or for each, with bodies at poses and velocities (n, 3). The keys
    are the names in `Reactions`.
    """
    count = len(joints.names)
    impulses = np.zeros((count, len(ENDS), 3))
    of_rows = totals[:, : 3 * len(ENDS)].reshape(-1, len(ENDS), 3)
    np.add.at(impulses, joints.owner, of_rows)
    pose, velocity = with_plane(pose), with_plane(velocity)
    force, torque = forces_and_torques(joints.held, impulses, pose, time_step)
    lengths, angles = separations(joints, pose, np.broadcast_to(time, (count,)))
    speed, power = drives_of(joints, of_rows, pose, velocity, time_step)
    return {
        "impulse": impulses[:, :, :2].copy(),
        "force": force,
        "torque": torque,
        "separation": lengths,
        "angular_separation": angles,
        "speed": speed,
        "power": power,
        "limit": limits_reached(joints, totals[:, tb.J_PUSHED - tb.J_STEP_TOTAL]),
    }


def told(names: tuple[str, ...], values: Mapping[str, NDArray[Any]]) -> dict[str, Any]:
    """Return names of joints and what is told of them, which cannot be written to."""
    protected = {
        key: read_only(array, f"{key} of the reactions", REMEDIES["reactions"])
        for key, array in values.items()
    }
    return {"names": names, **protected}
