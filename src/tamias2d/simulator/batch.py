"""Bodies on their way into the engine: checked columns, a row for each body.

Serves: the start of a simulator, and adding while it runs. Hides: how scenes and arrays of
arguments become the same columns.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine.tables import DYNAMIC, KINEMATIC, STATIC
from tamias2d.generated import drag
from tamias2d.scene import Body, Scene
from tamias2d.scene.acting import steady_load
from tamias2d.scene.compound import Shape
from tamias2d.scene.rules import RuleError
from tamias2d.state import Array

Whole = NDArray[np.int64]
UNSTATED = -1.0
"""Friction or restitution where a body states none."""


@dataclass(frozen=True, kw_only=True)
class Batch:
    """What k bodies are, and where and how they start; SI units."""

    kind: Whole
    """(k,), of `stepped.layout`"""
    pose: Array
    """(k, 3), position and orientation"""
    motion: Array
    """(k, 3), velocity and angular velocity"""
    load: Array
    """(k, 3), applied force and torque"""
    mass: Array
    """(k,); infinite unless dynamic"""
    inertia: Array
    """(k,); infinite for what nothing turns"""
    slowing: Array
    """(k, 2), rates at which drag slows velocity and angular velocity down, 1/s"""
    friction: Array
    """(k,), -1 where not stated"""
    restitution: Array
    """(k,), -1 where not stated"""
    filters: Whole
    """(k, 4): category, mask, group, sensor"""
    shapes: tuple[Shape | None, ...]
    """k shapes; None for a particle"""

    def __len__(self) -> int:
        return len(self.kind)


def scene_batch(scene: Scene) -> Batch:
    """Return the bodies of a scene, in its order; loads are those that stay as they are."""
    bodies = scene.bodies
    mass = np.array([body.mass for body in bodies])
    inertia = np.array([body.inertia for body in bodies])
    return Batch(
        kind=np.array([_kind(body) for body in bodies], dtype=np.int64),
        pose=_rows([(*body.position, body.orientation) for body in bodies], 3),
        motion=_rows([(*body.velocity, body.angular_velocity) for body in bodies], 3),
        load=_rows([steady_load(scene, k) for k in range(len(bodies))], 3),
        mass=mass,
        inertia=inertia,
        slowing=slowing(
            np.array([body.linear_drag for body in bodies]),
            mass,
            np.array([body.angular_drag for body in bodies]),
            inertia,
        ),
        friction=np.array([_stated(body.friction) for body in bodies]),
        restitution=np.array([_stated(body.restitution) for body in bodies]),
        filters=np.array(
            [(body.category, body.mask, body.group, body.sensor) for body in bodies], dtype=np.int64
        ).reshape(-1, 4),
        shapes=tuple(body.shape for body in bodies),
    )


def slowing(linear_drag: Array, mass: Array, angular_drag: Array, inertia: Array) -> Array:
    """Return the rates (k, 2) at which drag slows bodies down, 1/s.

    Raises:
        InputError: float64 cannot hold one.
    """
    with np.errstate(all="ignore"):
        rates = np.column_stack(
            (drag.drag_rate(linear_drag, mass), drag.angular_drag_rate(angular_drag, inertia))
        )
    bad = np.argwhere(~np.isfinite(rates))
    if len(bad):
        k, column = bad[0].tolist()
        key = ("linear_drag", "angular_drag")[column]
        raise RuleError(
            f"{key.replace('_', ' ')}[{k}] of the bodies: what it does is beyond float64 "
            "(R4). Give a smaller one.",
            key,
            k,
        )
    return rates


def _kind(body: Body) -> int:
    return DYNAMIC if body.dynamic else KINEMATIC if body.kinematic else STATIC


def _stated(value: float | None) -> float:
    return UNSTATED if value is None else value


def _rows(values: list[tuple[float, ...]], width: int) -> Array:
    return np.array(values, dtype=np.float64).reshape(-1, width)
