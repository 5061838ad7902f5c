"""The loads of a scene as Pymunk takes them: a force and a torque for each body and step."""

from collections.abc import Callable
from typing import TypeAlias

import numpy as np

from tamias2d.motion.loads import Loads
from tamias2d.scene import Scene
from tamias2d.scene.acting import Load, steady_load, varying_loads
from tamias2d.state import Array

Loading: TypeAlias = Callable[[float, int], Load]
"""From a time in s and a body to its force and torque besides weight."""


def loading(scene: Scene, state: Callable[[], Array]) -> Loading | None:
    """Return how bodies are loaded, or None if weight is all there is."""
    moving = [k for k, body in enumerate(scene.bodies) if body.dynamic]
    if not varying_loads(scene):
        steady = {k: steady_load(scene, k) for k in moving}
        return (lambda time, k: steady[k]) if any(map(any, steady.values())) else None  # noqa: ARG005
    field = Loads(scene).field(moving, [None] * len(moving))
    mass = np.array([(b.mass, b.mass, b.inertia) for b in (scene.bodies[k] for k in moving)])
    mass[~np.isfinite(mass)] = 0.0
    weight = np.array([*scene.gravity, 0.0])
    place = {k: row for row, k in enumerate(moving)}

    def loads(time: float, k: int) -> Load:
        rows = state()[moving]
        x, y, turn = ((field(time, rows[:, :3], rows[:, 3:]) - weight) * mass)[place[k]].tolist()
        return x, y, turn

    return loads
