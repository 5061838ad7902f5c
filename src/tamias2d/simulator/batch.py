"""A scene's bodies as rows for the engine, and the rates at which drag slows bodies."""

import numpy as np

from tamias2d.engine.batch import UNSTATED, Batch
from tamias2d.engine.tables import DYNAMIC, KINEMATIC, STATIC
from tamias2d.generated import drag
from tamias2d.scene import Body, Scene
from tamias2d.scene.acting import steady_load
from tamias2d.scene.rules import RuleError
from tamias2d.state import Array


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
        drag_rates=drag_rates(
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


def drag_rates(linear_drag: Array, mass: Array, angular_drag: Array, inertia: Array) -> Array:
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
