"""A simulator that starts again and again, by one copy of memory.

Serves: ensembles, which step one scene with other values many times. Hides: that the arrays of the
engine lie in one piece of memory then, and what becomes of those that had to grow.
"""

from tamias2d.engine.world import gathered
from tamias2d.simulator.simulator import Simulator


class Restart:
    """Puts a simulator back to where it is now; bodies and joints must stay what they are.

    Cost: a copy of the arrays, some microseconds for a few bodies.
    """

    def __init__(self, sim: Simulator) -> None:
        """Note where a simulator is, which has taken no step."""
        sim._settle_between()
        self._sim = sim
        self._gather()

    def __call__(self) -> None:
        """Put the simulator back."""
        engine = self._sim._engine
        if engine.capacities != self._capacities:
            self._grow()
        self._memory[:] = self._start
        engine.forget_steps()
        self._sim._forget()

    def _gather(self) -> None:
        engine = self._sim._engine
        _ = engine.argument  # which may make arrays longer
        engine.world, self._memory = gathered(engine.world)
        engine.forget_addresses()
        self._start, self._world = self._memory.copy(), engine.world
        self._capacities = engine.capacities
        self._sim._look()

    def _grow(self) -> None:
        """Let the start have the capacities that steps needed, so that the next ones have them."""
        engine = self._sim._engine
        needed, self._memory[:] = engine.capacities, self._start
        engine.world, engine.capacities = self._world, self._capacities
        engine.resize(**vars(needed))
        self._gather()
