"""Histories by kernel, of scenes in which nothing meets.

Serves: `simulate`, for stepped methods. Hides: when a kernel pays, and how a scene becomes the
arrays of one.
"""

from collections.abc import Iterator

import numpy as np

from tamias2d.kernels.compiled import Kernel, compiled
from tamias2d.kernels.demand import Demand, demand_of
from tamias2d.kernels.source import arguments, axes
from tamias2d.motion import Method
from tamias2d.motion.loads import Loads, coordinates, start_states
from tamias2d.scene import Scene
from tamias2d.scene.acting import steady_load
from tamias2d.state import Array, History

_WORTH = 20_000  # steps of any number of bodies: below, compiling takes longer than it saves
_PLURALS = {
    "masses": "mass",
    "inertias": "inertia",
    "linear_drags": "linear_drag",
    "quadratic_drags": "quadratic_drag",
}


def flight(scene: Scene, method: Method, steps: Array, times: Array) -> History | None:
    """Return the history at some times, s, of a scene that takes the steps between `steps`, s.

    None where no kernel can be made, where none pays, or where a time lies between two steps.
    """
    if len(steps) < _WORTH or not np.isin(times, steps).all():
        return None
    demand = demand_of(scene, method)
    return None if demand is None else flown(scene, demand, compiled(demand), steps, times)


def flown(scene: Scene, demand: Demand, kernel: Kernel, steps: Array, times: Array) -> History:
    """Return the history at some of the times of the steps, s, by a kernel for the demand."""
    bodies = [k for k, body in enumerate(scene.bodies) if body.dynamic]
    given = dict(inputs(scene, demand, bodies))
    names = arguments(demand)[1:]
    rows = np.repeat(np.stack(coordinates(start_states(scene)))[None], len(times), axis=0)
    done = 0
    for k, until in enumerate(np.searchsorted(steps, times)):
        kernel(steps[done : until + 1], *(given[name] for name in names))
        done = until
        for column, axis in enumerate(axes(demand)):
            rows[k, 0, bodies, column] = given[f"positions_{axis}"]
            rows[k, 1, bodies, column] = given[f"velocities_{axis}"]
    return History(
        rows[:, 0, :, :2].copy(),
        rows[:, 0, :, 2].copy(),
        rows[:, 1, :, :2].copy(),
        rows[:, 1, :, 2].copy(),
    )


def inputs(scene: Scene, demand: Demand, bodies: list[int]) -> Iterator[tuple[str, Array | float]]:
    """Yield what the arguments of a kernel can be, by name: all but `times`."""
    position, velocity = (part[bodies] for part in coordinates(start_states(scene)))
    loads = Loads(scene)
    steady = np.array([loads.steady(k) for k in bodies])
    load = np.array([steady_load(scene, k) for k in bodies])
    for column, axis in enumerate(axes(demand)):
        yield f"positions_{axis}", position[:, column].copy()
        yield f"velocities_{axis}", velocity[:, column].copy()
        yield f"accelerations_{axis}", steady[:, column].copy()
        yield f"acceleration_{axis}", float(steady[0, column])
        yield f"loads_{axis}", load[:, column].copy()
    yield "gravity_x", float(scene.gravity[0])
    yield "gravity_y", float(scene.gravity[1])
    for plural, name in _PLURALS.items():
        yield plural, np.array([float(getattr(scene.bodies[k], name)) for k in bodies])
