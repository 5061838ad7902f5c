"""What acts on many worlds between steps: motors, targets, forces and impulses, world by world."""

from collections.abc import Callable
from typing import TypeVar

import numpy as np

from tamias2d.errors import InputError
from tamias2d.scene.freedoms import Motor
from tamias2d.scene.rules import RuleError, label
from tamias2d.simulator import Simulator
from tamias2d.simulator.columns import as_array, judged, spread
from tamias2d.simulator.exclusive import exclusive
from tamias2d.simulator.joint_set import MOTOR
from tamias2d.simulator.jointing import checked_target
from tamias2d.simulator.selection import Bodies
from tamias2d.simulator.views import Views
from tamias2d.state import Array
from tamias2d.suggestions import suggests

_T = TypeVar("_T")
_OF = "the worlds"
_PLACE = "Give points of the worlds (x, y) in m."


@suggests
class Controls(Views):
    """Worlds that are driven between steps."""

    __slots__ = ("_sims",)
    _sims: tuple[Simulator, ...]

    @exclusive
    def set_motor(self, name: str, speed: object, *, maximum: object = None) -> None:
        """Give a joint's motor another speed and maximum in all worlds; None turns it off (GD22).

        `speed`, rad/s or m/s, and `maximum`, N m or N, are one for all worlds, or arrays
        (worlds,); no maximum is what it takes. It takes some 50 microseconds a world.

        Raises:
            InputError: a world has no such joint, it has no motor, or a value breaks a rule (R4);
                nothing is set then.
        """
        motors = self._motors(speed, maximum)
        joints = self._each_world(lambda w, sim: sim._joints.governed(name, MOTOR, motors[w]))
        self._each_world(lambda w, sim: sim._govern_as(joints[w]))

    @exclusive
    def set_target(self, name: str, point: object) -> None:
        """Move the point of the plane, m, that a joint holds, (2,) or (worlds, 2).

        It takes some 15 microseconds a world.

        Raises:
            InputError: a world has no such joint, it holds no single point of the plane, or a value
                breaks a rule (R4); nothing is moved then.
        """
        points = spread(point, "point", _OF, "Give (x, y) in m.", (len(self._sims), 2), "world")
        held = self._each_world(
            lambda w, sim: (*sim._joints.target_of(name), checked_target(points[w].tolist()))
        )
        self._each_world(lambda w, sim: sim._set_target(*held[w]))

    @exclusive
    def apply_force(self, bodies: Bodies, force: object, *, at: object | None = None) -> None:
        """Push bodies through the next step with a force in N, besides `force`, in all worlds.

        It is (2,), or (worlds, 2) for one body; (2,), (k, 2) or (worlds, k, 2) for k bodies. It
        acts at the centres of mass, or `at` points of the worlds, m, of such shapes. It takes some
        30 microseconds a world.

        Raises:
            InputError: a body is not there, or a value breaks a rule (R4).
        """
        remedy = "Give (x, y) in N."
        pushes, places = self._pushes(bodies, at, force, "force", "force", remedy)
        self._each_world(lambda w, sim: sim.apply_force(bodies, pushes[w], at=places[w]))

    @exclusive
    def apply_impulse(self, bodies: Bodies, impulse: object, *, at: object | None = None) -> None:
        """Change velocities by an impulse in N s, in all worlds; shapes are as for `apply_force`.

        Raises:
            InputError: a body is not there, or a value breaks a rule (R4).
        """
        remedy = "Give (x, y) in N s."
        pushes, places = self._pushes(bodies, at, impulse, "impulse", "impulse_vector", remedy)
        self._each_world(lambda w, sim: sim.apply_impulse(bodies, pushes[w], at=places[w]))

    def _motors(self, speed: object, maximum: object) -> list[Motor | None]:
        """Return the motor of each world."""
        count = len(self._sims)
        if speed is None:
            return [None] * count
        remedy = "Give numbers, one or one for each world."
        speeds = spread(speed, "speed", _OF, remedy, (count,), "world").tolist()
        if maximum is None:
            return [Motor(speed=each) for each in speeds]
        most = spread(maximum, "maximum", _OF, remedy, (count,), "world").tolist()
        return [Motor(speed=v, maximum=m) for v, m in zip(speeds, most, strict=True)]

    def _pushes(
        self, bodies: Bodies, at: object | None, value: object, key: str, symbol: str, remedy: str
    ) -> tuple[Array, Array | list[None]]:
        """Return of each world what pushes k bodies (k, 2), and where, m (k, 2), or None."""
        rows = self._sims[0]._rows(bodies)
        whole, one = (len(self._sims), len(rows), 2), np.ndim(bodies) == 0
        pushes = _vectors(value, key, symbol, remedy, whole, one=one)
        if at is None:
            return pushes, [None] * len(self._sims)
        return pushes, _vectors(at, "at", "position", _PLACE, whole, one=one)

    def _each_world(self, act: Callable[[int, Simulator], _T]) -> list[_T]:
        """Do something in all worlds; an error says in which."""
        found = []
        for world, sim in enumerate(self._sims):
            try:
                found.append(act(world, sim))
            except InputError as fault:
                raise type(fault)(f"world {world}: {fault}") from fault
        return found


def _vectors(
    value: object, key: str, symbol: str, remedy: str, whole: tuple[int, int, int], *, one: bool
) -> Array:
    """Return vectors of so many worlds and bodies (worlds, k, 2), or raise `RuleError`."""
    given = as_array(value, key, _OF, remedy)
    shapes = [(2,), (whole[0], 2)] if one else [(2,), whole[1:], whole]
    if given.dtype.kind not in "fiu" or given.shape not in shapes:
        raise RuleError(
            f"{label((key,))} of {_OF}: found {given.dtype} of shape {given.shape}: must be "
            f"numbers of shape {' or '.join(map(str, shapes))} (R4). {remedy}",
            key,
        )
    good = judged(given.astype(np.float64), key, _OF, remedy, symbol)
    return np.broadcast_to(good[:, None] if one and good.ndim == 2 else good, whole)
