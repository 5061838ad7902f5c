"""What joints exert on their bodies: rows times multipliers (GD17), as DD112 tells it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from tamias2d.generated import definitions
from tamias2d.scene.springs import arm
from tamias2d.spec.constraint import ENDS

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from tamias2d.motion.constraint_rows import ConstraintRows
    from tamias2d.scene.joints import Joint
    from tamias2d.state import Array

Exerted = dict[int, tuple["Array", "Array"]]
"""By a joint's number: forces (3, 2), N, on A, B and C, and torques (3,) about the anchors, N m."""


def add_exerted(
    found: Exerted,
    rows: ConstraintRows,
    numbers: Sequence[int],
    joints: Mapping[int, Joint],
    multipliers: Array,
    time: float,
    position: Array,
    turns: Mapping[int, float],
) -> None:
    """Add what rows exert to each of their joints, which have these numbers.

    `position` are the coordinates (n, 3) of the bodies that move, `turns` the orientation of each
    body of the scene that a joint may hold, rad.
    """
    slopes = rows.end_slopes(time, position)
    for joint, own, _ in rows.of_joints():
        number = numbers[joint]
        forces, torques = found.setdefault(number, (np.zeros((3, 2)), np.zeros(3)))
        for i, end in enumerate(ENDS):
            x, y, turn = multipliers[own] @ slopes[end][own]
            body = joints[number].ends[i]
            rx, ry = arm(joints[number].anchors[i], 0.0 if body is None else turns[body])
            forces[i] += x, y
            torques[i] += definitions.anchor_torque(turn, (rx, ry), (x, y))
