"""Joints come and go between steps (TM7), and tell what they exerted."""

from functools import partial

import numpy as np

from tamias2d.engine.state import LARGEST
from tamias2d.scene.freedoms import JointSpring, Limits, Motor
from tamias2d.scene.joint_anchors import anchors_of
from tamias2d.scene.joint_kinds import Equation, JointKind
from tamias2d.scene.joints import End, Joint
from tamias2d.scene.rules import RuleError, Vector, VectorLike, vector
from tamias2d.simulator.exclusive import exclusive
from tamias2d.simulator.joint_reactions import Reactions
from tamias2d.simulator.joint_set import LIMITS, MOTOR, SPRING
from tamias2d.simulator.moved_limits import passed_limits
from tamias2d.simulator.standing_bodies import StandingBodies
from tamias2d.simulator.step_warnings import jumped_past, too_stiff_for_steps
from tamias2d.simulator.stepping import Change, Stepping
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
        kind: JointKind,
        first: int | str | VectorLike,
        second: int | str | VectorLike | None = None,
        *,
        at: VectorLike | None = None,
        anchor: VectorLike | None = None,
        other_anchor: VectorLike | None = None,
        third: int | str | None = None,
        third_anchor: VectorLike | None = None,
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
            InputError: a body is not there, a value breaks a rule (R4), or the joint moves nothing
                or does not hold where the bodies are.
        """
        ends = (
            self._end(first),
            (0.0, 0.0) if second is None and isinstance(kind, Equation) else self._end(second),
            (0.0, 0.0) if third is None else self._end(third),
        )
        standing = StandingBodies(self._engine, self._names.of_row)
        anchors = anchors_of(kind, ends, (anchor, other_anchor, third_anchor), at, standing)
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
        self._to_set_target(name, point)()

    def _to_set_target(self, name: str, point: VectorLike) -> Change:
        joint, end = self._joints.target_of(name)
        return partial(self._set_target, joint, end, _checked_target(point))

    def _set_target(self, joint: Joint, end: int, point: Vector) -> None:
        self._joints.set_target(joint, end, point)
        self._wake_for(joint)

    @exclusive
    def set_motor(self, name: str, motor: Motor | None) -> None:
        """Give a joint's motor another speed and maximum, as a throttle does; None turns it off.

        It takes some 50 microseconds, and may be done before each step. A motor that stays as it is
        wakes nothing.

        Raises:
            InputError: there is no joint of that name, it has no motor, or a value breaks a rule
                (R4).
        """
        self._to_set_motor(name, motor)()

    def _to_set_motor(self, name: str, motor: Motor | None) -> Change:
        return partial(self._govern_as, self._joints.governed(name, MOTOR, motor))

    @exclusive
    def set_limits(self, name: str, limits: Limits | None) -> None:
        """Give a joint other limits, m or rad; None, or an end that is left out, limits nothing.

        Ends are those that it was added with. It takes some 100 microseconds, and may be done
        before each step. A limit that is moved past where the joint is, by up to 1/16 rad or of the
        joint's size, takes it along as a winch does; past one that jumps farther it comes back
        within some steps, and gets no speed of that.

        Raises:
            InputError: there is no joint of that name, it has no such limits, or a value breaks a
                rule (R4).

        Warns:
            StepWarning: a limit jumps so far past where the joint is.
        """
        self._to_set_limits(name, limits)()

    def _to_set_limits(self, name: str, limits: Limits | None) -> Change:
        if self._joints.new:
            self._settle_between()
        return partial(self._limit_as, self._joints.governed(name, LIMITS, limits))

    @exclusive
    def set_spring(self, name: str, spring: JointSpring | None) -> None:
        """Give a joint's spring other numbers; None turns it off (DD64, DD103).

        The rest that is left out is the one before; without a maximum there is none. It takes some
        50 microseconds, and may be done before each step; what the spring holds more then, the
        mechanism is given. Where it gets a maximum, or loses it, joints are set up anew.

        Raises:
            InputError: there is no joint of that name, it has no spring, or a value breaks a rule
                (R4).

        Warns:
            StepWarning: it is too stiff for the time step.
        """
        self._to_set_spring(name, spring)()

    def _to_set_spring(self, name: str, spring: JointSpring | None) -> Change:
        return partial(self._spring_as, self._joints.governed(name, SPRING, spring))

    def _limit_as(self, joint: Joint) -> None:
        """Let a joint be limited as one that `JointSet.governed` returned."""
        before = self._joints.named(joint.name)
        if self._govern_as(joint) and (passed := passed_limits(joint, before, self._engine)):
            self._joints.pull(joint, passed)
            self._warned.tell(jumped_past(joint, passed, self.time))

    def _spring_as(self, joint: Joint) -> None:
        """Let a joint be held by a spring as one that `JointSet.governed` returned."""
        if self._govern_as(joint):
            self._warned.tell(too_stiff_for_steps([joint], self._engine, self._time_step))

    def _govern_as(self, joint: Joint) -> bool:
        """Let a joint be governed as one that `JointSet.governed` returned."""
        changed = self._joints.govern(joint)
        if changed:
            self._wake_for(joint)
        return changed

    def _wake_for(self, joint: Joint) -> None:
        """Wake what a joint holds that got other numbers, which may have to be told anew."""
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


def _checked_target(point: object) -> Vector:
    """Return a point to which a target is moved, m, or raise `RuleError`."""
    at = vector(point, "position", "a target", "Give a point (x, y) in m.", at=("point",))
    if max(abs(at[0]), abs(at[1])) > LARGEST:
        raise RuleError(
            f"point {at} of a target: must be within {LARGEST:.2g} m, or float64 cannot hold "
            "what follows (R4). Bring it nearer.",
            "point",
        )
    return at
