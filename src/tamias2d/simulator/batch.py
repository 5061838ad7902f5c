"""A scene's bodies as rows for the engine, and the rates at which drag slows bodies."""

from collections.abc import Sequence

import numpy as np

from tamias2d.engine.bodies.batch import Batch
from tamias2d.engine.shapes.stated_surfaces import as_stated
from tamias2d.engine.tables import DYNAMIC, KINEMATIC, STATIC
from tamias2d.generated import drag
from tamias2d.scene import Body, Scene
from tamias2d.scene.acting import steady_load
from tamias2d.scene.rules import RuleError
from tamias2d.simulator.columns import Column, is_finite
from tamias2d.state import Array


def scene_batch(scene: Scene) -> Batch:
    """Return the bodies of a scene, in its order; loads are those that stay as they are."""
    bodies = scene.bodies
    mass = np.array([body.mass for body in bodies])
    inertia = np.array([body.inertia for body in bodies])
    rates = drag_rates(
        np.array([body.linear_drag for body in bodies]),
        mass,
        np.array([body.angular_drag for body in bodies]),
        inertia,
    )
    starts = [(*b.position, b.orientation, *b.velocity, b.angular_velocity) for b in bodies]
    loads = [steady_load(scene, k) for k in range(len(bodies))]
    surfaces = [
        (as_stated(body.friction), as_stated(body.restitution), body.surface_speed)
        for body in bodies
    ]
    return Batch(
        np.hstack(
            (
                *(_rows(starts, 6), _rows(loads, 3), np.column_stack((mass, inertia, *rates))),
                _rows(surfaces, 3),
            )
        ),
        np.array(
            [(_kind(b), b.category, b.mask, b.group, b.sensor) for b in bodies], dtype=np.int64
        ).reshape(-1, 5),
        tuple(body.shape for body in bodies),
    )


def drag_rates(
    linear_drag: Column, mass: Column, angular_drag: Column, inertia: Column
) -> tuple[Column, Column]:
    """Return the rates at which drag slows bodies and their spins, 1/s.

    Raises:
        InputError: float64 cannot hold one.
    """
    if _are_zero(linear_drag, angular_drag):
        return 0.0, 0.0
    with np.errstate(all="ignore"):
        rates: tuple[Column, Column] = (
            drag.drag_rate(linear_drag, mass),
            drag.angular_drag_rate(angular_drag, inertia),
        )
    if not all(map(is_finite, rates)):
        rows = np.stack(np.broadcast_arrays(*map(np.atleast_1d, rates)), axis=-1)
        k, column = np.argwhere(~np.isfinite(rows))[0].tolist()
        key = ("linear_drag", "angular_drag")[column]
        raise RuleError(
            f"{key.replace('_', ' ')}[{k}] of the bodies: what it does is beyond float64 "
            "(R4). Give a smaller one.",
            key,
            k,
        )
    return rates


def _are_zero(*drags: Column) -> bool:
    return all(isinstance(values, float) and values == 0.0 for values in drags)


def _kind(body: Body) -> int:
    return DYNAMIC if body.dynamic else KINEMATIC if body.kinematic else STATIC


def _rows(values: Sequence[tuple[float, ...]], width: int) -> Array:
    return np.array(values, dtype=np.float64).reshape(-1, width)
