"""Positions, velocities and loads of all bodies, as views of the arrays that the engine uses."""

from threading import Lock
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tamias2d.engine.engine import Engine
from tamias2d.engine.tables import ABSENT, DYNAMIC
from tamias2d.read_only import read_only
from tamias2d.scene.rules import RuleError, refuse_masked
from tamias2d.simulator.exclusive import between_calls, exclusive
from tamias2d.simulator.told_only import REMEDIES, refuses_assignment
from tamias2d.state import Array


@refuses_assignment
class Views:
    """What can be read and written between steps; assigning to a view writes into it."""

    __slots__ = ("_engine", "_lock", "_position")
    _engine: Engine
    _lock: Lock
    _position: Array  # kept, since a step of few bodies takes little longer than making a view

    def _look(self) -> None:
        """Look at the arrays of the engine anew, which adding may put elsewhere."""
        self._position = self._engine.pose[..., :2]

    @property
    @between_calls
    def gravity(self) -> Array:
        """The same for all bodies, m/s^2: a view (2,)."""
        return self._engine.gravity

    @gravity.setter
    @exclusive
    def gravity(self, value: ArrayLike) -> None:
        _write(self._engine.gravity, value, "gravity")

    @property
    @between_calls
    def position(self) -> Array:
        """Of the centres of mass, m: a view (n, 2), the same one until bodies are added."""
        return self._position

    @position.setter
    @exclusive
    def position(self, value: ArrayLike) -> None:
        _write(self._position, value, "position")

    @property
    @between_calls
    def orientation(self) -> Array:
        """Counter-clockwise, unbounded, rad: a view (n,)."""
        return self._engine.pose[..., 2]

    @orientation.setter
    @exclusive
    def orientation(self, value: ArrayLike) -> None:
        _write(self._engine.pose[..., 2], value, "orientation")

    @property
    @between_calls
    def velocity(self) -> Array:
        """m/s: a view (n, 2)."""
        return self._engine.velocity[..., :2]

    @velocity.setter
    @exclusive
    def velocity(self, value: ArrayLike) -> None:
        _write(self._engine.velocity[..., :2], value, "velocity")

    @property
    @between_calls
    def angular_velocity(self) -> Array:
        """rad/s: a view (n,)."""
        return self._engine.velocity[..., 2]

    @angular_velocity.setter
    @exclusive
    def angular_velocity(self, value: ArrayLike) -> None:
        _write(self._engine.velocity[..., 2], value, "angular_velocity")

    @property
    @between_calls
    def force(self) -> Array:
        """Applied besides gravity until it is changed, N: a view (n, 2)."""
        return self._engine.load[..., :2]

    @force.setter
    @exclusive
    def force(self, value: ArrayLike) -> None:
        _write(self._engine.load[..., :2], value, "force")

    @property
    @between_calls
    def torque(self) -> Array:
        """Applied until it is changed, N m: a view (n,)."""
        return self._engine.load[..., 2]

    @torque.setter
    @exclusive
    def torque(self, value: ArrayLike) -> None:
        _write(self._engine.load[..., 2], value, "torque")

    @property
    @between_calls
    def mass(self) -> Array:
        """kg, infinite for what nothing can push: a read-only copy (n,)."""
        with np.errstate(divide="ignore"):
            return _told(1 / self._engine.inverse_mass, "mass")

    @property
    @between_calls
    def present(self) -> NDArray[np.bool_]:
        """Which rows hold a body: a read-only copy (n,)."""
        return _told(np.not_equal(self._engine.kind, ABSENT), "present")

    @property
    @between_calls
    def dynamic(self) -> NDArray[np.bool_]:
        """Which rows hold a body that can be pushed: a read-only copy (n,)."""
        return _told(np.equal(self._engine.kind, DYNAMIC), "dynamic")

    @property
    @between_calls
    def asleep(self) -> NDArray[np.bool_]:
        """Which bodies sleep: a read-only copy (n,)."""
        return _told(self._engine.asleep, "asleep")

    def __len__(self) -> int:
        """How many bodies there are."""
        return int(np.count_nonzero(self._engine.kind))


def _write(view: Array, value: ArrayLike, key: str) -> None:
    """Write into a view, or raise `RuleError`; the next step finds what is not finite."""
    refuse_masked(value, "the simulator", "Fill it.", at=(key,))
    try:
        view[...] = value
    except (TypeError, ValueError, OverflowError):
        found = getattr(value, "shape", type(value).__name__)
        raise RuleError(
            f"{key.replace('_', ' ')} of the simulator: found {found}: must be numbers of shape "
            f"{view.shape} (R4). Give them all, or write into a part of the view.",
            key,
        ) from None


def _told(values: NDArray[Any], name: str) -> NDArray[Any]:
    """Return an array, a copy, so that writing into it is refused and not lost."""
    return read_only(values, f"{name} of the simulator", REMEDIES[name])
