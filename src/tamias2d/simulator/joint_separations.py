"""How far apart joints are, beside how large they are."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.engine.engine import Engine
from tamias2d.generated.constraints import CONSTRAINTS
from tamias2d.generated.definitions import gyration_radius
from tamias2d.scene.joint_start import numbers_of, steepness
from tamias2d.scene.joints import Joint
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


def separations(joints: Sequence[Joint], pose: Array, time: float) -> tuple[Array, Array]:
    """Return by how much joints (j,) are apart, m, and turned, rad, at poses (n, 3) and a time, s.

    An equation of its own is apart by the way, or the turn, on which its value would change by
    what it is; nan where it has none.
    """
    lengths, angles = np.zeros(len(joints)), np.zeros(len(joints))
    of_model: dict[str, list[int]] = {}
    poses = np.vstack((pose, np.zeros((1, 3))))  # the last one is the plane's
    for k, joint in enumerate(joints):
        if joint.equations:
            lengths[k], angles[k] = _way_and_turn(joint, poses, time)
        elif joint.rigid:
            of_model.setdefault(joint.model, []).append(k)
    for model, own in of_model.items():
        values: dict[str, Any] = {}
        for name in CONSTRAINTS[model].parameters:
            given = np.array([joints[k].given[name] for k in own])
            values[name] = tuple(given.T) if given.ndim == 2 else given
        for i, end in enumerate(ENDS):
            bodies = [joints[k].ends[i] for k in own]
            x, y, turn = poses[[-1 if body is None else body for body in bodies]].T
            values[f"position_{end}"], values[f"orientation_{end}"] = (x, y), turn
        with np.errstate(all="ignore"):
            rows = np.array(CONSTRAINTS[model].constraint(values))
        kinds = np.array(CONSTRAINTS[model].units)
        lengths[own] = np.hypot.reduce(rows[kinds == "m"], axis=0)
        angles[own] = np.hypot.reduce(rows[kinds == "1"], axis=0)
    return lengths, angles


def _way_and_turn(joint: Joint, poses: Array, time: float) -> tuple[float, float]:
    """Return by how much a joint with equations of its own is apart, m, and turned, rad."""
    functions = joint.functions
    values: dict[str, Any] = {"time": time, **joint.given}
    for end, body in zip(ENDS, joint.ends, strict=True):
        x, y, turn = poses[-1 if body is None else body].tolist()
        values[f"position_{end}"], values[f"orientation_{end}"] = (x, y), turn
    held = [end for end, body in zip(ENDS, joint.ends, strict=True) if body is not None]
    count = len(functions.units)
    rows = numbers_of(functions.constraint, values, count)
    slopes = [
        numbers_of(functions.slopes[end], values, 3 * count).reshape(-1, 3)
        for end in held
        if end in functions.bodies
    ]
    with np.errstate(all="ignore"):
        moved, turned = steepness(slopes)
        ways, turns = rows / np.where(moved == 0, np.inf, moved), rows / turned
    return math.hypot(*ways), math.hypot(*turns[moved == 0])
