"""Places, velocities and loads of all bodies, as views of the arrays that the engine works on.

Serves: the frame loop. Hides: the columns of the engine.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tamias2d.engine.engine import Engine
from tamias2d.engine.tables import ABSENT, DYNAMIC, INVERSE_MASS, SLEEP_ID
from tamias2d.scene.rules import RuleError, refuse_masked
from tamias2d.state import Array


class Views:
    """What can be read and written between steps; assigning to a view writes into it."""

    __slots__ = ("_engine", "_position")
    _engine: Engine
    _position: Array  # kept, since a step of few bodies takes little longer than making a view

    def _look(self) -> None:
        """Look at the arrays of the engine anew, which adding may put elsewhere."""
        self._position = self._engine.world.state.pose[: self._engine.size, :2]

    @property
    def gravity(self) -> Array:
        """The same for all bodies, m/s^2: a view (2,)."""
        return self._engine.world.control.settings[:2]

    @gravity.setter
    def gravity(self, value: ArrayLike) -> None:
        _write(self.gravity, value, "gravity")

    @property
    def position(self) -> Array:
        """Of the centres of mass, m: a view (n, 2), the same one until bodies are added."""
        return self._position

    @position.setter
    def position(self, value: ArrayLike) -> None:
        _write(self.position, value, "position")

    @property
    def orientation(self) -> Array:
        """Counter-clockwise, unbounded, rad: a view (n,)."""
        return self._engine.world.state.pose[: self._engine.size, 2]

    @orientation.setter
    def orientation(self, value: ArrayLike) -> None:
        _write(self.orientation, value, "orientation")

    @property
    def velocity(self) -> Array:
        """m/s: a view (n, 2)."""
        return self._engine.world.state.velocity[: self._engine.size, :2]

    @velocity.setter
    def velocity(self, value: ArrayLike) -> None:
        _write(self.velocity, value, "velocity")

    @property
    def angular_velocity(self) -> Array:
        """rad/s: a view (n,)."""
        return self._engine.world.state.velocity[: self._engine.size, 2]

    @angular_velocity.setter
    def angular_velocity(self, value: ArrayLike) -> None:
        _write(self.angular_velocity, value, "angular_velocity")

    @property
    def force(self) -> Array:
        """Applied besides gravity until it is changed, N: a view (n, 2)."""
        return self._engine.world.state.load[: self._engine.size, :2]

    @force.setter
    def force(self, value: ArrayLike) -> None:
        _write(self.force, value, "force")

    @property
    def torque(self) -> Array:
        """Applied until it is changed, N m: a view (n,)."""
        return self._engine.world.state.load[: self._engine.size, 2]

    @torque.setter
    def torque(self, value: ArrayLike) -> None:
        _write(self.torque, value, "torque")

    @property
    def mass(self) -> Array:
        """kg, infinite for what nothing can push: a new array (n,)."""
        with np.errstate(divide="ignore"):
            return 1 / self._engine.world.state.properties[: self._engine.size, INVERSE_MASS]

    @property
    def present(self) -> NDArray[np.bool_]:
        """Which rows hold a body: a new array (n,)."""
        return np.not_equal(self._kind, ABSENT)

    @property
    def dynamic(self) -> NDArray[np.bool_]:
        """Which rows hold a body that can be pushed: a new array (n,)."""
        return np.equal(self._kind, DYNAMIC)

    @property
    def asleep(self) -> NDArray[np.bool_]:
        """Which bodies sleep: a new array (n,)."""
        night: NDArray[np.int64] = self._engine.world.islands.links[
            self._engine.world.state.slot_of_body[: self._engine.size], SLEEP_ID
        ]
        return np.greater(night, 0)

    @property
    def _kind(self) -> NDArray[np.int8]:
        return self._engine.world.state.kind[: self._engine.size]

    def __len__(self) -> int:
        """How many bodies there are."""
        return int(np.count_nonzero(self._kind))


def _write(view: Array, value: ArrayLike, key: str) -> None:
    """Write into a view, or raise `RuleError`; what is not finite the next step finds."""
    refuse_masked(value, "the simulator", "Fill it.", at=(key,))
    try:
        view[...] = value
    except (TypeError, ValueError):
        found = getattr(value, "shape", type(value).__name__)
        raise RuleError(
            f"{key.replace('_', ' ')} of the simulator: found {found}: must be numbers of shape "
            f"{view.shape} (R4). Give them all, or write into a part of the view.",
            key,
        ) from None
