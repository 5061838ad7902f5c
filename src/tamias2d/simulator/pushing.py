"""Bodies are pushed between steps, and woken."""

import numpy as np

from tamias2d.simulator.applied import add_rows, applied_loads, velocity_changes
from tamias2d.simulator.exclusive import exclusive
from tamias2d.simulator.selection import Bodies
from tamias2d.simulator.stepping import Stepping
from tamias2d.suggestions import suggests


@suggests
class Pushing(Stepping):
    """Impulses that change velocities at once, and forces through the next step."""

    __slots__ = ()

    @exclusive
    def apply_impulse(self, bodies: Bodies, impulse: object, *, at: object | None = None) -> None:
        """Change velocities by an impulse in N s, (2,) or (k, 2), for each of k bodies.

        It acts at the centres of mass, or `at` points of the world, (2,) or (k, 2), m. A body that
        is given twice gets it twice; what nothing can push, such as a static body, stays as it is.

        Raises:
            InputError: a body is not there, or a value breaks a rule (R4).
        """
        rows = self._rows(bodies)
        changes = velocity_changes(self._engine, rows, impulse, at)
        add_rows(self._engine.velocity, rows, changes, "impulse")

    @exclusive
    def apply_force(self, bodies: Bodies, force: object, *, at: object | None = None) -> None:
        """Push bodies through the next step with a force in N, (2,) or (k, 2), besides `force`.

        It acts at the centres of mass, or `at` points of the world, (2,) or (k, 2), m. What nothing
        can push stays as it is.

        Raises:
            InputError: a body is not there, or a value breaks a rule (R4).
        """
        rows = self._rows(bodies)
        changes = applied_loads(self._engine, rows, force, at)
        pushed = self._pushed
        if pushed is None or len(pushed) < self._engine.size:  # bodies were added
            pushed = np.zeros((self._engine.size, 3))
            if self._pushed is not None:
                pushed[: len(self._pushed)] = self._pushed
        add_rows(pushed, rows, changes, "force")
        self._pushed = pushed

    @exclusive
    def wake(self, bodies: Bodies) -> None:
        """Wake bodies that sleep, and what they touch; `asleep` tells which do.

        What is moved, pushed or met by something that moves wakes by itself, and so does what
        touched a body that is moved or removed.

        Raises:
            InputError: a body is not there.
        """
        self._engine.wake(self._rows(bodies))
