"""Joints come and go between steps (TM7), and tell what they exerted."""

from typing import Any

import numpy as np

from tamias2d.engine.state import LARGEST
from tamias2d.scene.freedoms import Motor
from tamias2d.scene.joint_kinds import Equation, Kind
from tamias2d.scene.joints import End
from tamias2d.scene.rules import RuleError, VectorLike, vector
from tamias2d.simulator.exclusive import exclusive
from tamias2d.simulator.joint_reactions import Reactions
from tamias2d.simulator.standing_bodies import StandingBodies
from tamias2d.simulator.stepping import Stepping
from tamias2d.simulator.told_only import refuses_assignment
from tamias2d.suggestions import suggests


@suggests
@refuses_assignment
class Jointing(Stepping):
    """Joints are added, moved and removed."""

    __slots__ = ()

    @exclusive
    def add_joint(
        self,
        kind: Kind,
        first: int | str | VectorLike,
        second: int | str | VectorLike | None = None,
        *,
        anchor: VectorLike = (0.0, 0.0),
        other_anchor: VectorLike = (0.0, 0.0),
        third: int | str | None = None,
        third_anchor: VectorLike = (0.0, 0.0),
        name: str | None = None,
        collide: bool = False,
        break_force: float | None = None,
        break_torque: float | None = None,
    ) -> str:
        """Tie two bodies, or a body and the plane, and return the joint's name (TM7).

        The words are those of `Scene.add_joint`. The places of the bodies have to fit the joint;
        their velocities do after the next step. The joint breaks as a step ends over which the mean
        of its reaction, impulses included, was beyond `break_force`, N, or `break_torque`, N m.

        Raises:
            InputError: a body is not there, a value breaks a rule (R4), the joint moves nothing or
                does not hold where the bodies are, or steps do not know it.
        """
        ends = (
            self._end(first),
            (0.0, 0.0) if second is None and isinstance(kind, Equation) else self._end(second),
            (0.0, 0.0) if third is None else self._end(third),
        )
        anchors = (anchor, other_anchor, third_anchor)
        standing: Any = StandingBodies(self._engine, self._staying)
        joint = self._joints.add(
            *(kind, ends, anchors, name, collide, standing),
            bears=(break_force, break_torque),
            time=self.time,
        )
        self._engine.wake(np.array(joint.bodies, dtype=np.int64))
        self._unsettled = True
        return joint.name

    @exclusive
    def remove_joint(self, name: str) -> None:
        """Take a joint out; raise `InputError` if there is none of that name."""
        joint = self._joints.remove(name)
        self._engine.wake(np.array(joint.bodies, dtype=np.int64))
        self._unsettled = True

    @exclusive
    def set_target(self, name: str, point: VectorLike) -> None:
        """Move the point of the plane, m, that a joint holds; what it ties follows.

        It costs some 12 microseconds, and may be done before each step, as with a mouse.

        Raises:
            InputError: there is no joint of that name, it holds no single point of the plane, or
                float64 cannot hold what a point so far away does.
        """
        at = vector(point, "position", "a target", "Give a point (x, y) in m.", at=("point",))
        if max(abs(at[0]), abs(at[1])) > LARGEST:
            raise RuleError(
                f"point {at} of a target: must be within {LARGEST:.2g} m, or float64 cannot hold "
                "what follows (R4). Bring it nearer.",
                "point",
            )
        joint = self._joints.set_target(name, at)
        if self._sleeps:
            self._engine.wake(np.array(joint.bodies, dtype=np.int64))
        self._unsettled |= self._joints.new

    @exclusive
    def set_motor(self, name: str, motor: Motor | None) -> None:
        """Give a joint's motor another speed and maximum, as a throttle does; None turns it off.

        It takes some 50 microseconds, and may be done before each step. A motor that stays as it is
        wakes nothing.

        Raises:
            InputError: there is no joint of that name, it has no motor, or a value breaks a rule
                (R4).
        """
        joint = self._joints.set_motor(name, motor)
        if joint is None:
            return
        if self._sleeps:
            self._engine.wake(np.array(joint.bodies, dtype=np.int64))
        self._unsettled |= self._joints.new

    @property
    def joints(self) -> tuple[str, ...]:
        """The names of the joints, as they were added."""
        return self._joints.names

    @property
    @exclusive
    def reactions(self) -> Reactions:
        """What joints exerted in the last step, and how well they hold."""
        return self._joints.reactions(self._engine, self._time_step)

    def _end(self, end: object) -> End:
        """Return a body by its row, or a point of the plane."""
        if isinstance(end, str | int | np.integer) and not isinstance(end, bool):
            return int(self._rows(end)[0])  # type: ignore[arg-type]
        return vector(
            end, "position", "a joint", "Give a body, or a point (x, y) in m.", at=("end",)
        )
