"""How far apart joints are, beside how large they are."""

import math
from typing import Any

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.engine.engine import Engine
from tamias2d.generated.definitions import gyration_radius
from tamias2d.scene.joint_start import apart, numbers_of
from tamias2d.scene.joints import Joint
from tamias2d.simulator.joint_columns import JointColumns
from tamias2d.spec.constraint import ENDS
from tamias2d.state import Array


def size_of_joint(joint: Joint, engine: Engine) -> float:
    """Return how large a joint and the bodies that it holds are, m; infinite if they are points."""
    held = zip(joint.anchors, joint.ends, strict=True)
    lengths = [math.hypot(*anchor) for anchor, body in held if body is not None]
    lengths += [float(engine.world.state.properties[k, tb.BOUNDING_RADIUS]) for k in joint.bodies]
    lengths += [value for value in (joint.given.get("joint_length"),) if isinstance(value, float)]
    return max(lengths) or math.inf


def arm_of_joint(joint: Joint, engine: Engine) -> float:
    """Return at which arm, m, a turn of a joint counts as a way: its size.

    Of points it is how far from their centres the mass of its bodies is; 1 if none turns.
    """
    size = size_of_joint(joint, engine)
    if math.isfinite(size):
        return size
    inverse_mass, inverse_inertia = engine.inverse_mass, engine.inverse_inertia
    turning = [k for k in joint.bodies if inverse_inertia[k] > 0.0]
    radii = (gyration_radius(float(inverse_mass[k]), float(inverse_inertia[k])) for k in turning)
    return max(radii, default=1.0)


def separations(joints: JointColumns, pose: Array, time: Array) -> tuple[Array, Array]:
    """Return by how much joints (j,) are apart, m, and turned, rad, at times (j,), s.

    Poses are (n + 1, 3), the last one that of the plane. An equation of its own is apart by the
    way, or the turn, on which its value would change by what it is; nan where it has none.
    """
    lengths, angles = np.zeros(len(joints.names)), np.zeros(len(joints.names))
    for k in joints.own:
        lengths[k], angles[k] = _way_and_turn(
            joints.joints[k], pose[joints.held.bodies[k]], float(time[k])
        )
    for kept in joints.kept:
        with np.errstate(all="ignore"):
            rows = np.array(kept.functions.constraint(kept.values(pose)))
        kinds = np.array(kept.functions.units)
        lengths[kept.number] = np.hypot.reduce(rows[kinds == "m"], axis=0)
        angles[kept.number] = np.hypot.reduce(rows[kinds == "1"], axis=0)
    return lengths, angles


def _way_and_turn(joint: Joint, poses: Array, time: float) -> tuple[float, float]:
    """Return by how much a joint with equations of its own is apart, m, and turned, rad.

    The poses are those of its three ends.
    """
    functions = joint.functions
    values: dict[str, Any] = {"time": time, **joint.given}
    for end, (x, y, turn) in zip(ENDS, poses.tolist(), strict=True):
        values[f"position_{end}"], values[f"orientation_{end}"] = (x, y), turn
    held = [end for end, body in zip(ENDS, joint.ends, strict=True) if body is not None]
    count = len(functions.units)
    rows = numbers_of(functions.constraint, values, count)
    slopes = [
        numbers_of(functions.slopes[end], values, 3 * count).reshape(-1, 3)
        for end in held
        if end in functions.bodies
    ]
    return apart(rows, slopes)
