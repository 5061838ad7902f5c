"""What acts on many worlds between steps, world by world: on their joints, or by a push."""

from collections.abc import Callable, Sequence
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from tamias2d.ensemble.world_reports import in_world, warn_of
from tamias2d.errors import InputError, SceneError
from tamias2d.scene.freedoms import JointSpring, Limits, Motor
from tamias2d.scene.rules import RuleError, label
from tamias2d.simulator import Simulator
from tamias2d.simulator.columns import as_array, judged, spread
from tamias2d.simulator.exclusive import exclusive
from tamias2d.simulator.selection import Bodies
from tamias2d.simulator.stepping import Change
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
        speeds, most = self._per_world(speed, "speed"), self._per_world(maximum, "maximum")
        motors = [
            None if v is None else Motor(speed=v, maximum=m)
            for v, m in zip(speeds, most, strict=True)
        ]
        self._in_all(lambda w, sim: sim._to_set_motor(name, motors[w]))

    @exclusive
    def set_limits(
        self, name: str, *, restitution: object, lower: object = None, upper: object = None
    ) -> None:
        """Give a joint other limits in all worlds; an end that is left out limits nothing (GD21).

        `lower` and `upper`, m or rad, and `restitution` are one for all worlds, or arrays
        (worlds,). It takes some 100 microseconds a world; what is moved past where a joint is
        takes it along, as `Simulator.set_limits` says.

        Raises:
            InputError: a world has no such joint, it has no such limits, or a value breaks a rule
                (R4); nothing is set then.

        Warns:
            StepWarning: a limit is moved too far past where the joint is.
        """
        values = [self._per_world(*each) for each in (
            (restitution, "restitution"), (lower, "lower"), (upper, "upper"),
        )]  # fmt: skip
        limits = [
            None if low is None and high is None else Limits(restitution=e, lower=low, upper=high)
            for e, low, high in zip(*values, strict=True)
        ]
        self._in_all(lambda w, sim: sim._to_set_limits(name, limits[w]))

    @exclusive
    def set_spring(
        self,
        name: str,
        stiffness: object,
        *,
        damping: object = 0.0,
        rest: object = None,
        maximum: object = None,
    ) -> None:
        """Give a joint's spring other numbers in all worlds; None turns it off (DD64, DD103).

        `stiffness`, N m/rad or N/m, `damping`, N m s/rad or kg/s, `rest`, rad or m, and `maximum`,
        N m or N, are one for all worlds, or arrays (worlds,); a rest that is left out is the one
        before, and without a maximum there is none. It takes some 50 microseconds a world.

        Raises:
            InputError: a world has no such joint, it has no spring, or a value breaks a rule (R4);
                nothing is set then.

        Warns:
            StepWarning: it is too stiff for the time step.
        """
        values = [self._per_world(*each) for each in (
            (stiffness, "stiffness"), (damping, "damping"), (rest, "rest"), (maximum, "maximum"),
        )]  # fmt: skip
        springs = [
            None if k is None else JointSpring(stiffness=k, damping=c, rest=at, maximum=most)
            for k, c, at, most in zip(*values, strict=True)
        ]
        self._in_all(lambda w, sim: sim._to_set_spring(name, springs[w]))

    @exclusive
    def set_target(self, name: str, point: object) -> None:
        """Move the point of the plane, m, that a joint holds, (2,) or (worlds, 2).

        It takes some 15 microseconds a world.

        Raises:
            InputError: a world has no such joint, it holds no single point of the plane, or a value
                breaks a rule (R4); nothing is moved then.
        """
        points = spread(point, "point", _OF, "Give (x, y) in m.", (len(self._sims), 2), "world")
        self._in_all(lambda w, sim: sim._to_set_target(name, points[w].tolist()))

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

    def _per_world(self, value: object, key: str) -> Sequence[float | None]:
        """Return a number of each world; None of all, if there is none."""
        count = len(self._sims)
        if value is None:
            return [None] * count
        remedy = "Give numbers, one or one for each world."
        found: list[float] = spread(value, key, _OF, remedy, (count,), "world").tolist()
        return found

    def _pushes(
        self, bodies: Bodies, at: object | None, value: object, key: str, symbol: str, remedy: str
    ) -> tuple[Array, Array | list[None]]:
        """Return of each world what pushes k bodies (k, 2), and where, m (k, 2), or None."""
        pushes = self._of_bodies(bodies, value, key, remedy, symbol)
        if at is None:
            return pushes, [None] * len(self._sims)
        return pushes, self._of_bodies(bodies, at, "at", _PLACE, "position")

    def _of_bodies(
        self, bodies: Bodies, value: object, key: str, remedy: str, vectors: str | None = None
    ) -> NDArray[Any]:
        """Return what is given of k bodies in all worlds (worlds, k), or raise `RuleError`.

        These are numbers, which each world judges, or `vectors` (worlds, k, 2) of a symbol.
        """
        each = () if vectors is None else (2,)
        given: NDArray[Any] = as_array(value, key, _OF, remedy)
        worlds, count = len(self._sims), len(self._sims[0]._rows(bodies))
        one, whole = np.ndim(bodies) == 0, (worlds, count, *each)
        shapes = [each, (worlds, *each)] if one else [each, whole[1:], whole]
        if given.dtype.kind not in "fiu" or given.shape not in shapes:
            raise RuleError(
                f"{label((key,))} of {_OF}: found {given.dtype} of shape {given.shape}: must be "
                f"numbers of shape {' or '.join(map(str, shapes))} (R4). {remedy}",
                key,
            )
        if vectors is not None:
            given = judged(given.astype(np.float64), key, _OF, remedy, vectors)
        by_world = one and given.ndim > len(each)
        return np.broadcast_to(given[:, None] if by_world else given, whole)

    def _in_all(self, judge: Callable[[int, Simulator], Change]) -> None:
        """Make a change in all worlds, each of which is judged before any is changed."""
        for change in self._each_world(judge):
            change()
        warn_of(self._sims)

    def _each_world(self, act: Callable[[int, Simulator], _T]) -> list[_T]:
        """Do something in all worlds; an error says in which."""
        found = []
        for world, sim in enumerate(self._sims):
            try:
                found.append(act(world, sim))
            except (InputError, SceneError) as fault:
                raise type(fault)(in_world(world, fault)) from fault
        return found
