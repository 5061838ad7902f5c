"""Steps of kicks and drifts between which joints hold (GD24).

Kicks are by loads alone. Each drift ends where the joints hold, by impulses along their rows at its
begin, and a step ends with velocities that they allow: it is as symmetric in time and as symplectic
as the scheme is without joints.
Source: Andersen (1983); Hairer, Lubich and Wanner (2006), section VII.1.4.
"""

from collections.abc import Callable, Sequence

from tamias2d.generated.schemes import SPLITTING
from tamias2d.motion.fixed_steps import FixedSteps
from tamias2d.motion.marching import HeldMarching, Kick, Start, name_of
from tamias2d.motion.mechanisms import Placed, drifted, fitted
from tamias2d.motion.memoised_field import MemoisedField
from tamias2d.motion.step_batch import StepBatch
from tamias2d.state import Array


class HeldSplitting(FixedSteps):
    """Steps of a splitting scheme for bodies that joints hold."""

    def __init__(
        self, steps: FixedSteps, mechanisms: Sequence[Placed], kicks: MemoisedField
    ) -> None:
        """Take the steps of bodies without joints, these, and what loads give the bodies."""
        self.scheme, self.times = steps.scheme, steps.times
        self._mechanisms = mechanisms
        self.kicks = kicks
        """The accelerations of a kick."""

    def marched(
        self,
        field: MemoisedField,
        marching: HeldMarching,
        start: float,
        limit: float,
        position: Array,
        velocity: Array,
        *,
        most: int,
    ) -> StepBatch | None:
        """Take several steps at once, fewer where it is open how one ends, or None."""
        times, ahead = self.ends(start, limit, most)
        now = Start(position, velocity, field.known(start, position, velocity))
        known = self.kicks.known(start, position, velocity)
        kick = None if known is None else Kick(start, position, velocity, known)
        found = marching.kicked(name_of(self.scheme), times, now, kick, ahead)
        if found is None or not field.took(found[0]):
            return None
        steps, kick = found
        self.kicks.forget()
        if kick is not None:
            self.kicks.remember(*kick)
        return StepBatch(steps.times, steps.knots)

    def undone(
        self, field: MemoisedField, start: float, limit: float, position: Array, velocity: Array
    ) -> Callable[[], None]:
        """Return what takes back all steps that are taken from a state on."""
        steps = super().undone(field, start, limit, position, velocity)
        kicks = self.kicks.undone(start, position, velocity)

        def undo() -> None:
            kicks()
            steps()

        return undo

    def advance(
        self,
        field: MemoisedField,  # noqa: ARG002
        start: float,
        time_step: float,
        position: Array,
        velocity: Array,
    ) -> tuple[Array, Array]:
        """Return coordinates and rates (n, 3) after one step from `start`, s.

        Raises:
            JointError: it is too long for joints to hold.
        """
        for part in SPLITTING[name_of(self.scheme)].parts:
            is_kick, share, divisor, passed, passed_divisor = part
            length = share * time_step / divisor
            time = start + passed * time_step / passed_divisor
            if is_kick:
                velocity = velocity + length * self.kicks(time, position, velocity)
            else:
                position, velocity = drifted(self._mechanisms, time, length, position, velocity)
        return fitted(self._mechanisms, start + time_step, position, velocity)
