"""Steps that solve linear drag and constant loads exactly, and are kicked by all else."""

from typing import NamedTuple

import numpy as np

from tamias2d.generated import drag, rotation, schemes, translation
from tamias2d.motion.loads import Loads
from tamias2d.motion.stepped import Grid
from tamias2d.motion.watched import Watched
from tamias2d.scene import Scene
from tamias2d.state import Array, State

_ANY = State((0.0, 0.0), 0.0, (0.0, 0.0), 0.0)
"""Holds that do not bend a path do not ask for the state."""


class _Exact(NamedTuple):
    """What is solved exactly, for n bodies."""

    mass: Array
    linear_drag: Array
    steady: Array
    """(n, 3), of all constant loads"""

    def acceleration(self, velocity: Array) -> Array:
        """Return the accelerations (n, 3) at rates (n, 3)."""
        force = drag.linear_drag_force(self.linear_drag, (velocity[:, 0], velocity[:, 1]))
        steady = (self.steady[:, 0], self.steady[:, 1])
        x, y = translation.acceleration(steady, force, self.mass)
        return np.stack((x, y, self.steady[:, 2]), axis=-1)

    def moved(self, elapsed: float, q: Array, rate: Array) -> tuple[Array, Array]:
        """Return coordinates and rates (n, 3) after a time in s."""
        steady, spin = (self.steady[:, 0], self.steady[:, 1]), self.steady[:, 2]
        decay = drag.drag_rate(self.linear_drag, self.mass)
        velocity = (rate[:, 0], rate[:, 1])
        place = drag.position((q[:, 0], q[:, 1]), velocity, steady, decay, elapsed)
        later = drag.velocity(velocity, steady, decay, elapsed)
        turned = rotation.orientation(q[:, 2], rate[:, 2], spin, elapsed)
        turning = rotation.angular_velocity(rate[:, 2], spin, elapsed)
        return np.stack((*place, turned), axis=-1), np.stack((*later, turning), axis=-1)


class ExponentialGrid(Grid):
    """Exponential steps on a grid."""

    def __init__(self, scene: Scene, duration: float, time_step: float) -> None:
        super().__init__(schemes.velocity_verlet, duration, time_step)
        self._scene = scene
        self._loads = Loads(scene)
        self._last: tuple[Watched, _Exact] | None = None

    def advance(
        self, field: Watched, start: float, time_step: float, position: Array, velocity: Array
    ) -> tuple[Array, Array]:
        """Return coordinates and rates (n, 3) after one step from `start`, s."""
        if self._last is None or self._last[0] is not field:
            self._last = (field, self._exact(field))
        exact = self._last[1]
        return schemes.exponential_verlet(
            start,
            time_step,
            position,
            velocity,
            lambda time, q, rate: field(time, q, rate) - exact.acceleration(rate),
            lambda _, elapsed, q, rate: exact.moved(elapsed, q, rate),
        )

    def _exact(self, field: Watched) -> _Exact:
        bodies = [self._scene.bodies[i] for i in field.bodies]
        steady = [
            hold(self._loads.steady(i), _ANY) if hold else self._loads.steady(i)
            for i, hold in zip(field.bodies, field.holds, strict=True)
        ]
        return _Exact(
            np.array([body.mass for body in bodies]),
            np.array([body.linear_drag for body in bodies]),
            np.array(steady).reshape(-1, 3),
        )
