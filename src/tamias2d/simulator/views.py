"""Positions, velocities and loads of all bodies, as views of the arrays that the engine uses."""

from collections.abc import Mapping
from threading import Lock
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tamias2d.engine.engine import Engine
from tamias2d.engine.tables import ABSENT, DYNAMIC
from tamias2d.read_only import read_only
from tamias2d.scene.rules import RuleError, refuse_masked
from tamias2d.simulator.earlier_views import EarlierViews
from tamias2d.simulator.exclusive import between_calls, exclusive
from tamias2d.simulator.lent import is_held, lent
from tamias2d.simulator.told_only import REMEDIES, refuses_assignment
from tamias2d.state import Array, IntArray

_POSITION, _ORIENTATION, _VELOCITY, _ANGULAR_VELOCITY, _FORCE, _TORQUE, _GRAVITY = range(7)
_NAMES = ("position", "orientation", "velocity", "angular_velocity", "force", "torque", "gravity")


@refuses_assignment
class Views:
    """What can be read and written between steps; assigning to a view writes into it."""

    __slots__ = ("_earlier", "_engine", "_lock", "_seen", "_views")
    _earlier: EarlierViews
    _engine: Engine
    _lock: Lock
    _seen: bool  # whether anybody has looked in between since the last step
    # made as they are asked for, and kept: a step of few bodies takes little longer than a view
    _views: tuple[Array, ...]
    _remedies: ClassVar[Mapping[str, str]] = REMEDIES

    def _look(self) -> None:
        """Look at the arrays of the engine for the first time, or where nobody has a view."""
        self._seen, self._earlier, self._views = True, EarlierViews(_NAMES), ()

    def _look_anew(self) -> None:
        """Look at the arrays of the engine anew, which adding may put elsewhere."""
        self._seen, before, pose = True, self._views, self._engine.pose
        if before and len(before[0]) == len(pose) and np.may_share_memory(before[0], pose):
            return  # a row is used again
        self._views = ()
        if self._earlier or (before and is_held(before)):
            later = self._current()
            self._earlier.add(before or later, later)

    def _current(self) -> tuple[Array, ...]:
        """Return views of the arrays of the engine, the same ones until these go elsewhere."""
        if not self._views:
            engine = self._engine
            pose, velocity, load = engine.pose, engine.velocity, engine.load
            rows = (pose, velocity, load)
            parts = (part for values in rows for part in (values[..., :2], values[..., 2]))
            self._views = tuple(map(lent, (*parts, engine.gravity)))
        return self._views

    @property
    def _untouched(self) -> bool:
        """Whether nobody can have written into what is seen since the last step."""
        return not (self._seen or self._earlier or is_held(self._views))

    @property
    @between_calls
    def gravity(self) -> Array:
        """The same for all bodies, m/s^2: a view (2,)."""
        return self._current()[_GRAVITY]

    @gravity.setter
    @exclusive
    def gravity(self, value: ArrayLike) -> None:
        _write(self._current()[_GRAVITY], value, "gravity")

    @property
    @between_calls
    def position(self) -> Array:
        """Of the centres of mass, m: a view (n, 2), the same one until bodies are added."""
        return self._current()[_POSITION]

    @position.setter
    @exclusive
    def position(self, value: ArrayLike) -> None:
        _write(self._current()[_POSITION], value, "position")

    @property
    @between_calls
    def orientation(self) -> Array:
        """Counter-clockwise, unbounded, rad: a view (n,)."""
        return self._current()[_ORIENTATION]

    @orientation.setter
    @exclusive
    def orientation(self, value: ArrayLike) -> None:
        _write(self._current()[_ORIENTATION], value, "orientation")

    @property
    @between_calls
    def velocity(self) -> Array:
        """m/s: a view (n, 2)."""
        return self._current()[_VELOCITY]

    @velocity.setter
    @exclusive
    def velocity(self, value: ArrayLike) -> None:
        _write(self._current()[_VELOCITY], value, "velocity")

    @property
    @between_calls
    def angular_velocity(self) -> Array:
        """rad/s: a view (n,)."""
        return self._current()[_ANGULAR_VELOCITY]

    @angular_velocity.setter
    @exclusive
    def angular_velocity(self, value: ArrayLike) -> None:
        _write(self._current()[_ANGULAR_VELOCITY], value, "angular_velocity")

    @property
    @between_calls
    def force(self) -> Array:
        """Applied besides gravity until it is changed, N: a view (n, 2)."""
        return self._current()[_FORCE]

    @force.setter
    @exclusive
    def force(self, value: ArrayLike) -> None:
        _write(self._current()[_FORCE], value, "force")

    @property
    @between_calls
    def torque(self) -> Array:
        """Applied until it is changed, N m: a view (n,)."""
        return self._current()[_TORQUE]

    @torque.setter
    @exclusive
    def torque(self, value: ArrayLike) -> None:
        _write(self._current()[_TORQUE], value, "torque")

    @property
    @between_calls
    def mass(self) -> Array:
        """kg, infinite for what nothing can push: a read-only copy (n,)."""
        with np.errstate(divide="ignore"):
            return self._told(1 / self._engine.inverse_mass, "mass")

    @property
    @between_calls
    def present(self) -> NDArray[np.bool_]:
        """Which rows hold a body: a read-only copy (n,)."""
        return self._told(np.not_equal(self._engine.kind, ABSENT), "present")

    @property
    @between_calls
    def dynamic(self) -> NDArray[np.bool_]:
        """Which rows hold a body that can be pushed: a read-only copy (n,)."""
        return self._told(np.equal(self._engine.kind, DYNAMIC), "dynamic")

    @property
    @between_calls
    def generation(self) -> IntArray:
        """How many bodies each row has held so far, one that is there included: a copy (n,).

        An index with its generation is a handle that knows when it is stale: the body is still
        there as long as the row is present and of that generation.
        """
        return self._told(self._engine.generation.copy(), "generation")

    @property
    @between_calls
    def asleep(self) -> NDArray[np.bool_]:
        """Which bodies sleep: a read-only copy (n,)."""
        return self._told(self._engine.asleep, "asleep")

    def _told(self, values: NDArray[Any], name: str) -> NDArray[Any]:
        """Return an array, a copy, so that writing into it is refused and not lost."""
        return read_only(values, f"{name} of the simulator", self._remedies[name])

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
