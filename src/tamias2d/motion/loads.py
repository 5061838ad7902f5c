"""What accelerates the bodies of a scene: gravity, applied forces and torques (IM1, IM2).

Serves: every integrator. Hides: how forces become accelerations of coordinates.
"""

from collections.abc import Callable, Sequence
from typing import TypeAlias

import numpy as np

from tamias2d.generated import rotation, translation
from tamias2d.scene import Body, Scene
from tamias2d.state import Acceleration, Array, Hold, State

Field: TypeAlias = Callable[[float, Array, Array], Array]
"""Accelerations (n, 3) from a time, the coordinates (n, 3) and their rates (n, 3)."""

_STILL: Acceleration = (0.0, 0.0, 0.0)


class Loads:
    """The accelerations of a scene's bodies, free or held by lasting contacts."""

    def __init__(self, scene: Scene) -> None:
        self.bodies = scene.bodies
        self._gravity = scene.gravity
        self._constant = [self._at(body, 0.0) if body.constant else None for body in scene.bodies]

    def acceleration(self, body: int, time: float) -> Acceleration:
        """Return the acceleration of one body that nothing holds, at a time in s."""
        free = self._constant[body]
        if free is None:
            free = self._at(self.bodies[body], time)
        return free

    def field(self, bodies: Sequence[int], holds: Sequence[Hold | None]) -> Field:
        """Return the accelerations of some bodies as a function, for the schemes."""
        held = [(k, hold) for k, hold in enumerate(holds) if hold]

        def accelerations(time: float, position: Array, velocity: Array) -> Array:
            rows = [self.acceleration(i, time) for i in bodies]
            for k, hold in held:
                rows[k] = hold(rows[k], state_of(position[k], velocity[k]))
            return np.array(rows).reshape(-1, 3)

        if held or any(self._constant[i] is None for i in bodies):
            return accelerations
        fixed = np.array([self.acceleration(i, 0.0) for i in bodies]).reshape(-1, 3)
        return lambda time, position, velocity: fixed  # noqa: ARG005

    def _at(self, body: Body, time: float) -> Acceleration:
        if not body.dynamic:
            return _STILL
        x, y = translation.acceleration(self._gravity, body.force_at(time), body.mass)
        turn = rotation.angular_acceleration(body.torque_at(time), body.inertia)
        return float(x), float(y), float(turn)


def start_states(scene: Scene) -> list[State]:
    """Return the states in which the bodies of a scene start."""
    return [State(b.position, b.orientation, b.velocity, b.angular_velocity) for b in scene.bodies]


def coordinates(states: Sequence[State]) -> tuple[Array, Array]:
    """Return states as coordinates (n, 3), x y orientation, and their rates (n, 3)."""
    position = [(*state.position, state.orientation) for state in states]
    velocity = [(*state.velocity, state.angular_velocity) for state in states]
    return np.array(position).reshape(-1, 3), np.array(velocity).reshape(-1, 3)


def state_of(position: Array, velocity: Array) -> State:
    """Return coordinates (3,) and their rates (3,) as a state."""
    x, y, orientation = position.tolist()
    u, v, angular_velocity = velocity.tolist()
    return State((x, y), orientation, (u, v), angular_velocity)
