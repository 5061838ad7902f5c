"""How fast motors of joints drive, and what they put in (GD22)."""

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.scene.joints import Joint
from tamias2d.simulator.joint_rows import joint_rows, laws_of
from tamias2d.spec.constraint import ENDS
from tamias2d.state import Array


def drives_of(
    joints: Sequence[Joint], impulses: Array, pose: Array, velocity: Array, time_step: float
) -> tuple[Array, Array]:
    """Return the speeds (j,) of motors now, rad/s or m/s, and their powers (j,), W.

    A power is what a motor gave on average in the last step, of so many s, times its speed now. The
    impulses (r, 3, 3) are those of all rows on A, B and C, N s, N s and N m s; bodies have poses
    and velocities (n, 3).
    """
    speed, power = np.zeros(len(joints)), np.zeros(len(joints))
    for r, k, driven in _motors(joints):
        slopes = _slopes(driven, pose)
        speed[k] = np.sum(slopes * _of_ends(driven, velocity))
        size = float(np.sum(slopes * slopes))
        if size > 0.0:
            power[k] += np.sum(slopes * impulses[r]) / size / time_step * speed[k]
    return speed, power


def _motors(joints: Sequence[Joint]) -> Iterator[tuple[int, int, Joint]]:
    """Yield for each motor its row, the number of its joint, and the joint of what it drives."""
    r = 0
    for k, joint in enumerate(joints):
        governed = () if joint.equations else joint.freedoms
        laws = [(freedom, *law) for freedom in governed for law in laws_of(freedom)]
        r += len(joint_rows(joint)) - len(laws)
        for freedom, law, value, _ in laws:
            if law == tb.MOTOR:
                yield r, k, joint.measured(freedom, value)
            r += 1


def _slopes(joint: Joint, pose: Array) -> Array:
    """Return the slopes (3, 3) of the value of a joint by the coordinates of A, B and C."""
    values: dict[str, Any] = dict(joint.given)
    for end, (x, y, turn) in zip(ENDS, _of_ends(joint, pose).tolist(), strict=True):
        values[f"position_{end}"], values[f"orientation_{end}"] = (x, y), turn
    slopes = joint.functions.slopes
    return np.array([slopes[end](values) if end in slopes else (0.0,) * 3 for end in ENDS])


def _of_ends(joint: Joint, of_bodies: Array) -> Array:
    """Return the rows (3, 3) of the bodies A, B and C; of what is no body they are 0."""
    nothing = np.zeros(3)
    return np.array([nothing if body is None else of_bodies[body] for body in joint.ends])
