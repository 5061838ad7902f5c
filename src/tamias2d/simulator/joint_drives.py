"""How fast motors drive and what they put in (GD22), and which limits joints reach (GD21)."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.scene.joints import Joint
from tamias2d.simulator.joint_rows import rows_by_law
from tamias2d.spec.constraint import ENDS
from tamias2d.state import Array, IntArray

_SIDES = {tb.LOWER_LIMIT: -1, tb.UPPER_LIMIT: 1}


def drives_of(
    joints: Sequence[Joint], impulses: Array, pose: Array, velocity: Array, time_step: float
) -> tuple[Array, Array]:
    """Return the speeds (j,) of motors now, rad/s or m/s, and their powers (j,), W.

    A power is what a motor gave on average in the last step, of so many s, times its speed now. The
    impulses (r, 3, 3) are those of all rows on A, B and C, N s, N s and N m s; bodies have poses
    and velocities (n, 3).
    """
    speed, power = np.zeros(len(joints)), np.zeros(len(joints))
    for r, k, law, freedom, value in rows_by_law(joints):
        if law != tb.MOTOR:
            continue
        driven = joints[k].measured(freedom, value)
        values = _values(driven, pose, velocity)
        (speed[k],) = driven.functions.rate(values)
        slopes = _slopes(driven, values)
        size = float(np.sum(slopes * slopes))
        if size > 0.0:
            power[k] += np.sum(slopes * impulses[r]) / size / time_step * speed[k]
    return speed, power


def limits_reached(joints: Sequence[Joint], pushed: Array) -> IntArray:
    """Return which limits (j,) pushed in a step: -1 for the lower, 1 for the upper one, else 0.

    What each row gave as a limit is known (r,), N s or N m s.
    """
    reached = np.zeros(len(joints), dtype=np.int64)
    for r, k, law, _, _ in rows_by_law(joints):
        if law in _SIDES and pushed[r] > 0.0:
            reached[k] = _SIDES[law]
    return reached


def _values(joint: Joint, pose: Array, velocity: Array) -> dict[str, Any]:
    """Return what the constraint of a joint takes; what is no body is at rest in the origin."""
    values: dict[str, Any] = dict(joint.given)
    for end, body in zip(ENDS, joint.ends, strict=True):
        x, y, turn = (0.0,) * 3 if body is None else pose[body].tolist()
        u, v, spin = (0.0,) * 3 if body is None else velocity[body].tolist()
        values[f"position_{end}"], values[f"orientation_{end}"] = (x, y), turn
        values[f"velocity_{end}"], values[f"angular_velocity_{end}"] = (u, v), spin
    return values


def _slopes(joint: Joint, values: dict[str, Any]) -> Array:
    """Return the slopes (3, 3) of the value of a joint by the coordinates of A, B and C."""
    slopes = joint.functions.slopes
    return np.array([slopes[end](values) if end in slopes else (0.0,) * 3 for end in ENDS])
