"""An engine on a crowd, and whether its bodies go where their velocities say.

Serves: the measurement of crowds. Hides: what is looked at in each step, and how it is summed up.
"""

from time import process_time
from typing import Any

import numpy as np

from tamias2d.scene import Scene
from tamias2d.state import Array
from tamias2d.study.engines.engine import Engine, Maker
from tamias2d.study.engines.overlap import worst
from tools.measurements.arena.race import TIME_STEP

_SLOW = 0.3  # m/s, up to which a body counts as resting
_HANGS = 0.2  # of its way


class Followed:
    """An engine on a crowd, and what was seen of it so far."""

    def __init__(self, make: Maker, scene: Scene) -> None:
        self.engine: Engine = make(scene, TIME_STEP)
        self.seconds: list[float] = []
        self.gain, self._moving = 0.0, 0
        self.hanging: list[tuple[int, Array, Array]] = []
        """Steps with bodies that hung, these, and the way of each below which it hangs, m."""
        self._scene = scene
        self._free = np.array([body.dynamic for body in scene.bodies])
        self._undriven = not any(body.kinematic for body in scene.bodies)
        self._mass = np.array([body.mass for body in scene.bodies if body.dynamic])
        self._inertia = np.array([body.inertia for body in scene.bodies if body.dynamic])
        self._start = self._state()
        self._energy = self._first = self._energy_of(self._start)

    def step(self) -> None:
        """Take a step, and see who went where."""
        before = self._state()
        start = process_time()
        self.engine.step()
        self.seconds.append(process_time() - start)
        after = self._state()
        way = np.hypot(*(after[:, :2] - before[:, :2]).T)
        speed = np.minimum(np.hypot(*before[:, 3:5].T), np.hypot(*after[:, 3:5].T))
        goes = (speed > _SLOW) & ((before[:, 3:5] * after[:, 3:5]).sum(axis=1) > 0.0)
        self._moving += int(goes.sum())
        least = _HANGS * speed * TIME_STEP
        hangs = goes & (way < least)
        if hangs.any():
            bodies = np.flatnonzero(self._free)[hangs]
            self.hanging.append((len(self.seconds) - 1, bodies, least[hangs]))
        if self._undriven:
            energy = self._energy_of(after)
            self.gain = max(self.gain, (energy - self._energy) / self._first)
            self._energy = energy

    def share(self, hanging: int) -> float:
        """Return which share of moving body-steps so many are."""
        return hanging / max(self._moving, 1)

    def row(self) -> dict[str, Any]:
        """Return what was seen."""
        hanging = sum(len(bodies) for _, bodies, _ in self.hanging)
        return {
            "engine": self.engine.name,
            "seconds": float(np.median(self.seconds)),
            "worst": max(self.seconds[1:], default=0.0),  # in the first one code is loaded
            "hang": self.share(hanging),
            "centre": self._centre(),
            "overlap": worst(self._scene, self.engine.state()).share,
            "gain": self.gain if self._undriven else None,
        }

    def _state(self) -> Array:
        state: Array = self.engine.state()[self._free]
        return state

    def _energy_of(self, state: Array) -> float:
        """Kinetic energy, and that of gravity above the lowest place at the start, J."""
        speed = (state[:, 3:5] ** 2).sum(axis=1)
        pull = -self._scene.gravity[1]
        height = state[:, 1] - self._start[:, 1].min()
        return float(
            (0.5 * (self._mass * speed + self._inertia * state[:, 5] ** 2)).sum()
            + pull * (self._mass * height).sum()
        )

    def _centre(self) -> float | None:
        """Return the error of the centre of mass, or nothing where something outside pushes."""
        if self._scene.gravity != (0.0, 0.0) or not self._free.all():
            return None
        share, time = self._mass / self._mass.sum(), len(self.seconds) * TIME_STEP
        went = share @ (self._state()[:, :2] - self._start[:, :2])
        mean = time * share @ np.hypot(*self._start[:, 3:5].T)
        return float(np.abs(went - time * share @ self._start[:, 3:5]).max() / mean)
