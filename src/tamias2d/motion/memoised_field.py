"""Accelerations that are counted, and computed only once for one time and state."""

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from tamias2d.motion.loads import Field
from tamias2d.motion.marching import Marching, Steps
from tamias2d.motion.motion import Tally
from tamias2d.state import Array, Constraint

_REMEMBERED = 32  # times; more than any step asks for


class MemoisedField:
    """The accelerations of some bodies, each time and state of which is computed once.

    The end of a step is the start of the next, and the path between them asks for both again.
    Where no force depends on a velocity, a splitting scheme saves one evaluation a step.
    """

    def __init__(
        self,
        field: Field,
        bodies: Sequence[int],
        constraints: Sequence[Constraint | None],
        tally: Tally,
        *,
        felt_velocity: bool = True,
        marching: Marching | None = None,
    ) -> None:
        self.marching = marching
        """What takes many steps at once under these accelerations, if anything does."""
        self.bodies = tuple(bodies)
        self.constraints = tuple(constraints)
        self._field = field
        self._felt_velocity = felt_velocity
        self.tally = tally
        self._known: dict[float, tuple[Array, Array, Array]] = {}

    def __call__(self, time: float, position: Array, velocity: Array) -> Array:
        """Return the accelerations (n, 3) at a time in s, for coordinates and rates (n, 3)."""
        known = self.known(time, position, velocity)
        if known is not None:
            return known
        self.tally.force_evaluations += 1
        result = self._field(time, position, velocity)
        self.remember(time, position, velocity, result)
        return result

    def beside(self) -> "MemoisedField":
        """Return a field of the same accelerations that remembers none yet."""
        return MemoisedField(
            self._field,
            self.bodies,
            self.constraints,
            self.tally,
            felt_velocity=self._felt_velocity,
            marching=self.marching,
        )

    def known(self, time: float, position: Array, velocity: Array) -> Array | None:
        """Return the accelerations if they were computed before."""
        known = self._known.get(time)
        if (
            known is None
            or not _same(known[0], position)
            or (self._felt_velocity and not _same(known[1], velocity))
        ):
            return None
        self._known[time] = self._known.pop(time)  # what is asked for stays longest
        return known[2]

    def recall(self, time: float, position: Array, velocity: Array) -> None:
        """Remember accelerations that were computed before, and counted, and then forgotten."""
        if self.known(time, position, velocity) is None:
            self.remember(time, position, velocity, self._field(time, position, velocity))

    def forget(self) -> None:
        """Forget all: from here on the accelerations are others."""
        self._known.clear()

    def settle(self, time: float, position: Array, velocity: Array) -> None:
        """Forget all but one state, so that costs do not depend on who took the steps before."""
        known = self.known(time, position, velocity)
        self._known.clear()
        if known is not None:
            self._known[time] = (position, velocity, known)

    def undone(self, time: float, position: Array, velocity: Array) -> Callable[[], None]:
        """Return what takes back all that is done from a state on, s: its cost, and what is known.

        Of what was known before, that of this state stays.
        """
        known, cost = self.known(time, position, velocity), replace(self.tally)

        def undo() -> None:
            vars(self.tally).update(vars(cost))
            self._known.clear()
            if known is not None:
                self.remember(time, position, velocity, known)

        return undo

    def took(self, steps: Steps) -> bool:
        """Count what steps have cost that were taken at once, and remember how they ended.

        Returns whether there are any.
        """
        self.tally.force_evaluations += steps.evaluations
        self.tally.rejected += steps.rejected
        self._known.clear()
        if steps.last_known:
            self.remember(steps.times[-1], *steps.knots[-1])
        return len(steps.times) > 1

    def remember(self, time: float, position: Array, velocity: Array, result: Array) -> None:
        """Keep accelerations that are known for a time and a state."""
        self._known.pop(time, None)
        if len(self._known) >= _REMEMBERED:
            del self._known[next(iter(self._known))]
        self._known[time] = (position, velocity, result)


def _same(one: Array, other: Array) -> bool:
    return one is other or np.array_equal(one, other)
