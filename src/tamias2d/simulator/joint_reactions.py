"""What joints exerted in the last step, and how well they hold."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tamias2d.read_only import read_only
from tamias2d.scene.joints import Joint
from tamias2d.scene.springs import arm
from tamias2d.simulator.joint_rows import joint_rows
from tamias2d.simulator.joint_separations import separations
from tamias2d.simulator.told_only import REMEDIES
from tamias2d.spec.constraint import ENDS
from tamias2d.state import Array


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

    def index(self, name: str) -> int:
        """Return the place of a joint; raise `ValueError` if there is none of that name."""
        return self.names.index(name)


def reactions_of(
    joints: Sequence[Joint], totals: Array, pose: Array, time_step: float
) -> Reactions:
    """Return what joints (j,) exerted, from what a step of so many s left of each of their rows."""
    owner = [k for k, joint in enumerate(joints) for _ in joint_rows(joint)]
    impulses = np.zeros((len(joints), len(ENDS), 3))
    np.add.at(impulses, owner, totals[:, : 3 * len(ENDS)].reshape(-1, len(ENDS), 3))
    torque = impulses[:, :, 2] / time_step
    force = impulses[:, :, :2] / time_step
    for k, joint in enumerate(joints):
        for i, (body, anchor) in enumerate(zip(joint.ends, joint.anchors, strict=True)):
            x, y = arm(anchor, 0.0 if body is None else float(pose[body, 2]))
            torque[k, i] -= x * force[k, i, 1] - y * force[k, i, 0]
    lengths, angles = separations(joints, pose)
    told = {
        "impulse": impulses[:, :, :2].copy(),
        "force": force,
        "torque": torque,
        "separation": lengths,
        "angular_separation": angles,
    }
    return Reactions(
        names=tuple(joint.name for joint in joints),
        **{
            name: read_only(values, f"{name} of the reactions", REMEDIES["reactions"])
            for name, values in told.items()
        },
    )
