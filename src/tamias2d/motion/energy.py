"""Energy in the springs of a scene (IM7) and in the attraction between its bodies (IM5)."""

import numpy as np

from tamias2d.generated import gravitation, spring as model
from tamias2d.scene import Scene, Spring
from tamias2d.scene.springs import arm
from tamias2d.state import Array, History


def energy_between(scene: Scene, history: History) -> Array:
    """Return (k,), J; fields and laws of a user's own have no potential and are not in it."""
    total = np.zeros(len(history.position))
    for spring in scene.springs:
        total += _of_spring(spring, history)
    return total if scene.attraction is None else total + _of_attraction(scene, history)


def _of_spring(spring: Spring, history: History) -> Array:
    ends = []
    for body, anchor in spring.ends:
        x, y = arm(anchor, history.orientation[:, body]) if any(anchor) else (0.0, 0.0)
        ends.append((history.position[:, body, 0] + x, history.position[:, body, 1] + y))
    first, second = (*ends, spring.point)[:2]
    energy: Array = model.spring_energy(spring.stiffness, spring.rest_length, first, second)
    return energy


def _of_attraction(scene: Scene, history: History) -> Array:
    """Sum over all pairs, one body at a time against all after it."""
    moving = [k for k, body in enumerate(scene.bodies) if body.dynamic]
    mass = np.array([scene.bodies[k].mass for k in moving])
    place = history.position[:, moving]
    total = np.zeros(len(place))
    for i in range(len(moving) - 1):
        one, others = place[:, i, None], place[:, i + 1 :]
        total += gravitation.gravitational_energy(
            scene.attraction,
            mass[i],
            mass[i + 1 :],
            (one[..., 0], one[..., 1]),
            (others[..., 0], others[..., 1]),
        ).sum(axis=-1)
    return total
