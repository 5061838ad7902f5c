"""Joints and their events as plain data, as they are saved with a simulator."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.engine.saving.saved_checks import require
from tamias2d.generated.joint_rows import KINDS
from tamias2d.motion.joint_events import WORDS, JointEvent
from tamias2d.scene.freedoms import Freedom, JointSpring, Limits, Motor
from tamias2d.scene.joints import Joint
from tamias2d.scene.rules import RuleError
from tamias2d.simulator.joint_layout import KEPT_COUNT
from tamias2d.simulator.joint_rows import joint_rows
from tamias2d.spec.constraint import ENDS
from tamias2d.state import Array

_NAME = "joints"


def restored_joints(
    data: Sequence[Mapping[str, Any]], kept: NDArray[Any] | None, kind: NDArray[np.int8]
) -> tuple[list[Joint], Array | None]:
    """Return the joints of plain data, and what the last step left of their rows, if any.

    Raises:
        UnfitError: they are no joints of bodies of these kinds (n,).
    """
    try:
        joints = [_joint_of(one) for one in data]
        rows = [row for joint in joints for row in joint_rows(joint)]
    except (TypeError, ValueError, KeyError, AttributeError, RuleError):
        require(False, _NAME, "are no joints")
    require(len({joint.name for joint in joints}) == len(joints), _NAME, "have one name")
    for row in rows:
        held = [body for body in row.ends if body is not None]
        fits = len(set(held)) == len(held) and all(0 <= body < len(kind) for body in held)
        require(fits and np.isfinite(row.given).all(), _NAME, "must be of bodies, and numbers")
        kinds = kind[held]
        fits = bool((kinds == tb.DYNAMIC).any()) and tb.ABSENT not in kinds
        require(fits, _NAME, "must hold a body that moves")
    return joints, _checked(kept, len(rows)) if joints else None


def restored_events(data: Sequence[Any]) -> list[JointEvent[str]]:
    """Return the events of plain data.

    Raises:
        UnfitError: they are none.
    """
    try:
        events = [JointEvent(*each) for each in data]
        fits = all(map(_is_event, events))
    except (TypeError, ValueError):
        fits = False
    require(fits, "joint_events", "must be times, names, freedoms, words and values")
    return events


def _is_event(event: JointEvent[str]) -> bool:
    numbers = [each for each in event if isinstance(each, int | float)]
    return (
        len(numbers) == len(event) - 1
        and all(map(math.isfinite, numbers))
        and isinstance(event.joint, str)
        and event.what in range(len(WORDS))
    )


def _checked(kept: NDArray[Any] | None, count: int) -> Array:
    fits = kept is not None and kept.dtype == np.float64
    require(fits and kept.shape == (count, KEPT_COUNT), _NAME, "have no impulses")  # type: ignore[union-attr]
    require(np.isfinite(cast(Array, kept)), _NAME, "must be numbers")
    return cast(Array, kept).copy()


def _joint_of(data: Mapping[str, Any]) -> Joint:
    """Return a joint of plain data, in which tuples are lists."""
    parameters = tuple(
        (str(name), (float(value[0]), float(value[1])) if isinstance(value, list) else float(value))
        for name, value in data["parameters"]
    )
    freedoms = tuple(_freedom_of(each) for each in data["freedoms"])
    equations = tuple(map(str, data["equations"]))
    steepness = tuple((float(moved), float(turned)) for moved, turned in data["steepness"])
    read: dict[str, Any] = {"parameters": parameters, "freedoms": freedoms}
    joint = Joint(**{**data, **read, "equations": equations, "steepness": steepness})
    anchors = tuple((float(x), float(y)) for x, y in joint.anchors)
    ends = tuple(None if body is None else int(body) for body in joint.ends)
    if (
        len(anchors) != len(ENDS)
        or len(ends) != len(ENDS)
        or joint.model not in (*KINDS, "equation")
    ):
        raise ValueError(joint.model)
    if (joint.model == "equation") != bool(equations):
        raise ValueError(equations)
    if not isinstance(joint.name, str) or not isinstance(joint.collide, bool):
        raise TypeError(joint.name)
    ratchets = [each.pitch for each in freedoms]
    for most in (joint.break_force, joint.break_torque, *ratchets):
        if most is not None and not 0.0 < float(most) < math.inf:
            raise ValueError(most)
    return replace(
        joint,
        ends=(ends[0], ends[1], ends[2]),
        anchors=(anchors[0], anchors[1], anchors[2]),
    )


def _freedom_of(data: Mapping[str, Any]) -> Freedom:
    """Return what a joint leaves free, of plain data."""
    kinds: dict[str, Any] = {"limits": Limits, "motor": Motor, "spring": JointSpring}
    parts = {key: None if data[key] is None else kind(**data[key]) for key, kind in kinds.items()}
    return Freedom(**{**data, **parts})
