"""Bodies that joints hold together: their reactions, and the way back to their constraints.

By the equations of motion in index one (GD17), the return to the constraints after each step (GD18)
and the rule for constraints that depend on each other (GD19).
"""

import math
from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType

import numpy as np

from tamias2d.errors import SceneError, SimulationError
from tamias2d.motion.constraint_rows import ConstraintRows
from tamias2d.motion.joint_code import JointCode, JointCodes, JointRows, Pushes
from tamias2d.motion.least import LeastSolution
from tamias2d.scene import Scene
from tamias2d.scene.joints import Joint
from tamias2d.state import Array, Vector

Field = Callable[[float, Array, Array, Array], Array]
"""Accelerations (n, 3) from a time, coordinates, rates and the accelerations by the loads."""

_LARGEST = 2**22  # numbers in all rows: one solution of so many takes seconds
MOST = 20  # returns; each squares what is left, so that more than a few do not get there
NEAR = 1e-7  # of the mechanism's size: after a shorter way back what is left is rounding
ROUNDING = 1e-8  # of how far off the origin: a smaller mechanism is as good as a point there
APART = 1e-6  # of the mechanism's size: joints that depend on others may not be further apart
_CONTRADICTION = 0.01  # of the accelerations: so much is no remnant of a joint near its instant


class JointError(SimulationError):
    """Joints that contradict each other, or that a step has torn; `run` is the history so far."""

    code = "joint"


class Mechanism:
    """The joints of some bodies that they connect, directly or not."""

    def __init__(
        self,
        scene: Scene,
        joints: Sequence[Joint],
        bodies: Sequence[int],
        *,
        speeds: Mapping[int, float] = MappingProxyType({}),
        like: Sequence[Joint] | None = None,
        pulled: Field | None = None,
    ) -> None:
        """Take the joints, and the moving bodies in the order of their coordinates.

        Those whose numbers are in `speeds` keep no place but their rate, in rad/s or m/s. How far
        the mechanism reaches follows from joints that it is `like`, or from its own. What springs
        and motors give its bodies is added to the loads by `pulled`.
        """
        self.joints = tuple(joints)
        self.bodies = tuple(bodies)
        self.code: JointCode | None = None
        """What finds reactions and places faster, where it can."""
        self._pulled = pulled
        self.rows = ConstraintRows(scene, joints, {body: k for k, body in enumerate(bodies)})
        if self.rows.count * 3 * len(bodies) > _LARGEST:
            raise SceneError(
                f"joint '{joints[0].name}' and {len(joints) - 1} more: together they are "
                f"{self.rows.count} equations for {len(bodies)} bodies, and the exact way solves "
                "them all at once, up to 4 million numbers (R13). Take fewer bodies."
            )
        weights = [
            (body.inverse_mass, body.inverse_mass, body.inverse_inertia)
            for body in (scene.bodies[k] for k in bodies)
        ]
        self._weights = np.sqrt(np.array(weights).reshape(-1, 3))
        self.speeds = np.zeros(self.rows.count)
        self.placed = np.ones(self.rows.count)
        """1 for each row that keeps a place."""
        for joint, own, _ in self.rows.of_joints():
            if joint in speeds:
                self.speeds[own], self.placed[own] = speeds[joint], 0.0
        joints = joints if like is None else like
        self._fixed = np.array(_fixed_places(scene, joints)).reshape(-1, 2)
        self._reach_length = max(
            math.hypot(*at)
            for joint in joints
            for k, at in zip(joint.ends, joint.anchors, strict=True)
            if k is not None
        )
        self._reach = np.array([(1.0, 1.0, _lever(joints, k)) for k in bodies]).ravel()

    def take_code(
        self,
        codes: JointCodes,
        pushes: Pushes | None = None,
        kinds: frozenset[str] = frozenset(),
        pushed: frozenset[str] = frozenset(),
    ) -> None:
        """Let code find reactions and places; it also serves for mechanisms of other kinds.

        What kinematic bodies hold is left to the general factors: only steps move it.
        """
        if self.rows.told.any():
            return
        self.code = codes(
            JointRows(
                rows=self.rows,
                weights=self._weights,
                speeds=self.speeds,
                placed=self.placed,
                fixed=self._fixed,
                length=self._reach_length,
                reach=self._reach.reshape(-1, 3),
                pushes=pushes,
                kinds=kinds,
                pushed=pushed,
            )
        )

    def code_at(self, time: float) -> JointCode | None:  # noqa: ARG002
        """Return what finds reactions and places faster from a time in s on, if anything does."""
        return self.code

    def accelerations(self, time: float, position: Array, velocity: Array, free: Array) -> Array:
        """Return the accelerations (n, 3) for those by the loads alone.

        Raises:
            JointError: no reactions keep the joints.
        """
        if self.code and (found := self.code.react(time, position, velocity, free)):
            return found[0]
        pulled = self.pull(time, position, velocity, free)
        x, _ = self._reactions(time, position, velocity, pulled)
        accelerations: Array = pulled + self._weights * x.reshape(free.shape)
        return accelerations

    def multipliers(self, time: float, position: Array, velocity: Array, free: Array) -> Array:
        """Return the multipliers (m,), likewise."""
        found = self.code and self.code.react(time, position, velocity, free)
        if found and found[1] is not None:
            return found[1]
        pulled = self.pull(time, position, velocity, free)
        x, least = self._reactions(time, position, velocity, pulled)
        return least.shares(x)

    def pull(self, time: float, position: Array, velocity: Array, free: Array) -> Array:
        """Return the accelerations (n, 3) by the loads and by what springs and motors exert."""
        return free if self._pulled is None else self._pulled(time, position, velocity, free)

    def _reactions(
        self, time: float, position: Array, velocity: Array, free: Array
    ) -> tuple[Array, LeastSolution]:
        """Return what the reactions do to the weighed accelerations, and how it was found."""
        with np.errstate(all="ignore"):  # what is not finite is refused
            slopes, least = self._factors(time, position)
            convective = self.rows.convective(time, position, velocity)
        pull = np.einsum("ijk,jk->i", slopes, free)
        wanted = -(pull + convective)
        if not np.isfinite(wanted).all():
            raise self._torn(time, "has no finite value", wanted)
        x = least(wanted)
        if least.rank < self.rows.count:
            size = least.size(pull) + least.size(convective)
            if least.missed(wanted) > _CONTRADICTION * size:
                raise self._contradiction(time, least)
        return x, least

    def struck(self, time: float, position: Array, impulses: Array) -> Array:
        """Return the changes of the velocities (n, 3) by impulses (n, 3), N s and N m s.

        The joints answer with impulses of their own that keep their rates (GD20).
        """
        (change,) = self.moved(time, position, impulses[None])
        return np.asarray(change, float)

    def moved(
        self,
        time: float,
        position: Array,
        impulses: Array,
        *,
        in_turns: bool = False,  # noqa: ARG002
    ) -> Array:
        """Return the changes (m, n, 3) of the velocities by each of m impulses (m, n, 3)."""
        slopes, least = self._factors(time, position)
        changes = np.empty_like(impulses)
        for change, free in zip(changes, self._weights * impulses, strict=True):
            x = least(np.einsum("ijk,jk->i", slopes, self._weights * free))
            change[:] = self._weights * (free - x.reshape(free.shape))
        return changes

    def pushed(self, time: float, position: Array, forces: Array) -> Array:
        """Return the accelerations (m, n, 3) by each of m forces (m, n, 3), N and N m."""
        return self.moved(time, position, forces)

    def fitted(self, time: float, position: Array, velocity: Array) -> tuple[Array, Array]:
        """Return places and velocities (n, 3), moved by the least way to where the joints hold.

        Raises:
            JointError: no place near by fits.
        """
        if self.code and (found := self.code.fit(time, position, velocity)):
            return found
        position, least = self._placed(time, position)
        return position, self._paced(time, position, velocity, least)

    def drifted(
        self, time: float, duration: float, position: Array, velocity: Array
    ) -> tuple[Array, Array]:
        """Return places after a drift from a time on, s, and the velocities (n, 3) along it.

        Impulses along the slopes at its begin lead to where the joints hold (GD24). Those that keep
        the rates there come first: large loads that joints bear would lead far astray.

        Raises:
            JointError: no place near by fits.
        """
        if self.code and (found := self.code.drift(time, duration, position, velocity)):
            return found
        _, least = self._factors(time, position)
        paced = 1 - self.placed
        wanted = paced * (self.rows.values(time, position) + duration * self.speeds)
        along, before = self._paced(time, position, velocity, least), np.inf
        after = position + duration * along
        for _ in range(MOST):
            with np.errstate(all="ignore"):
                slopes = self.rows.slopes(time + duration, after)
                values = self.rows.values(time + duration, after) - wanted
            if not (np.isfinite(values).all() and np.isfinite(slopes).all()):
                break
            rows = slopes.reshape(len(slopes), self._weights.size) * self._weights.ravel()
            x = least.within(rows, values)
            back = self._weights * x.reshape(position.shape)
            after, along = after - back, along - back / duration
            way = float(np.abs(x).max(initial=0.0))
            if way <= NEAR * self._size(position):
                return after, along
            if way > 2 * before:
                break
            before = way
        raise self._torn(time, "is torn by a step", values)

    def paced(self, time: float, position: Array, velocity: Array) -> Array:
        """Return velocities (n, 3), moved by the least change to the rates that the joints keep."""
        return self._paced(time, position, velocity, self._factors(time, position)[1])

    def _paced(self, time: float, position: Array, velocity: Array, least: LeastSolution) -> Array:
        rates = self.rows.rates(time, position, velocity) - self.speeds
        paced: Array = velocity - self._weights * least(rates).reshape(position.shape)
        return paced

    def _placed(self, time: float, position: Array) -> tuple[Array, LeastSolution]:
        size = self._size(position)
        before = np.inf
        for _ in range(MOST):
            with np.errstate(all="ignore"):
                _, least = self._factors(time, position)
                values = self.rows.values(time, position) * self.placed
            if not np.isfinite(values).all():
                break
            x = least(values)
            position = position - self._weights * x.reshape(position.shape)
            way = float(np.abs(x).max(initial=0.0))
            if way <= NEAR * size:
                if least.missed(values) > APART * self.length(position):
                    raise self._contradiction(time, least)
                return position, least
            if way > 2 * before:
                break
            before = way
        raise self._torn(time, "is torn by the step before", values)

    def _factors(self, time: float, position: Array) -> tuple[Array, LeastSolution]:
        slopes = self.rows.slopes(time, position)
        if not np.isfinite(slopes).all():
            raise self._torn(time, "has no finite slope", slopes.sum(axis=(1, 2)))
        rows = slopes.reshape(len(slopes), self._weights.size)
        try:
            return slopes, LeastSolution(rows, self._weights.ravel(), self._reach)
        except np.linalg.LinAlgError:
            raise self._unsolved(time, slopes) from None

    def extent(self, position: Array) -> float:
        """Return how large the mechanism is, m; it is a point if all its places are the origin."""
        places = np.vstack((position[:, :2], self._fixed))
        spread = float(np.ptp(places, axis=0).max())
        return max(spread, self._reach_length, ROUNDING * float(np.abs(places).max()))

    def length(self, position: Array) -> float:
        """Return a length that is not small, m."""
        return self.extent(position) or 1.0

    def _size(self, position: Array) -> float:
        """Return a length that is not small, weighed as the coordinates are."""
        return self.length(position) / float(self._weights[:, :2].max(initial=0.0))

    def _torn(self, time: float, what: str, rows: Array) -> JointError:
        worst = int(np.argmax(np.where(np.isfinite(rows), np.abs(rows), np.inf)))
        (name,) = self.named([worst])
        return JointError(
            f"joint '{name}' at {time!r} s: {what} (GD18). Take a smaller step or a smaller "
            "tolerance, or end the run before."
        )

    def _unsolved(self, time: float, slopes: Array) -> JointError:
        """Return that inverse masses times slopes are numbers which float64 cannot hold."""
        (name,) = self.named([int(np.argmin(np.abs(slopes).max(axis=(1, 2))))])
        return JointError(
            f"joint '{name}' at {time!r} s: float64 cannot solve it and those it is connected with "
            "(GD18). Give their bodies masses and sizes that are less different."
        )

    def _contradiction(self, time: float, least: LeastSolution) -> JointError:
        names = ", ".join(f"'{name}'" for name in self.named(least.dependent_rows))
        return JointError(
            f"joints {names} at {time!r} s: no finite reactions keep them all (GD19): they are "
            "pulled taut, contradict each other, or stand where they could go on in several ways. "
            "Leave one out, give the mechanism slack, or begin elsewhere."
        )

    def examined(self, time: float, position: Array, velocity: Array, free: Array) -> str | None:
        """Return which joints depend on each other at the start, or None.

        Raises:
            JointError: they do not let the mechanism go where the loads accelerate it.
        """
        _, least = self._factors(time, position)
        if least.rank == self.rows.count:
            return None
        bent = velocity + self.accelerations(time, position, velocity, free)  # after a second of it
        convective = self.rows.convective(time, position, bent)
        if least.missed(convective) > _CONTRADICTION * least.size(convective):
            raise self._contradiction(time, least)
        names = ", ".join(f"'{name}'" for name in self.named(least.dependent_rows))
        return (
            f"joints: {self.rows.count - least.rank} of {self.rows.count} equations depend on "
            f"others, among {names}: how they share the load is open, the least is told (GD19)"
        )

    def named(self, rows: Sequence[int]) -> list[str]:
        """Return the names of the joints to which some rows belong."""
        chosen = set(rows)
        owners = {joint for joint, own, _ in self.rows.of_joints() if chosen & set(own)}
        return [self.joints[k].name for k in sorted(owners)]


def _fixed_places(scene: Scene, joints: Sequence[Joint]) -> list[Vector]:
    """Return where joints hold what stands still, m."""
    found: list[Vector] = []
    for joint in joints:
        for k, at in zip(joint.ends, joint.anchors, strict=True):
            if k is None:
                found.append(at)
            elif not scene.bodies[k].dynamic:
                found.append(scene.bodies[k].position)
    return found


def _lever(joints: Sequence[Joint], body: int) -> float:
    """Return one over how far from its centre joints hold a body, 1/m; 1 where at its centre."""
    anchors = [
        math.hypot(*at)
        for joint in joints
        for k, at in zip(joint.ends, joint.anchors, strict=True)
        if k == body
    ]
    return 1 / (max(anchors, default=0.0) or 1.0)
