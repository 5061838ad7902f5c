"""What bodies answer when they are pushed: their masses, and the joints that hold them.

Serves: motions, of which contacts ask this. Hides: that loads know of masses and joints.
"""

from collections.abc import Sequence

from tamias2d.motion.joint_events import Mode
from tamias2d.motion.loads import Loads, StateOf
from tamias2d.state import Acceleration, Array


class Answers:
    """Answers of the bodies of a scene at a time in s, in states that are given."""

    _loads: Loads

    def moved(
        self,
        time: float,
        bodies: Sequence[int],
        impulses: Array,
        state: StateOf,
        *,
        in_turns: bool = False,
    ) -> Array:
        """Return what impulses (m, n, 3) on n bodies change, with what joints answer."""
        return self._loads.moved(time, bodies, impulses, state, in_turns=in_turns)

    def pushed(self, time: float, bodies: Sequence[int], forces: Array, state: StateOf) -> Array:
        """Return the accelerations by forces on bodies, with what joints answer as they do now."""
        return self._loads.pushed(time, bodies, forces, state)

    def joint_changes(self, bodies: Sequence[int], time: float) -> list[tuple[Mode, int]]:
        """Return what joints of some bodies do at a time, s, and how many limits were struck."""
        return self._loads.joint_changes(bodies, time)

    def free(self, body: int, time: float, state: StateOf) -> Acceleration:
        """Return the acceleration of an unconstrained body, at a time in s."""
        return self._loads.acceleration(body, time, state)
