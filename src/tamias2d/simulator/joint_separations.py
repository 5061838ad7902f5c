"""How far apart joints are, beside how large they are."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.engine.engine import Engine
from tamias2d.generated.constraints import CONSTRAINTS
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


def separations(joints: Sequence[Joint], pose: Array) -> tuple[Array, Array]:
    """Return by how much joints (j,) are apart, m, and turned, rad, at poses (n, 3)."""
    lengths, angles = np.zeros(len(joints)), np.zeros(len(joints))
    of_model: dict[str, list[int]] = {}
    for k, joint in enumerate(joints):
        if joint.rigid:
            of_model.setdefault(joint.model, []).append(k)
    poses = np.vstack((pose, np.zeros((1, 3))))  # the last one is the plane's
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
