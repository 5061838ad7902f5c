"""A simulator that starts again and again, by one copy of memory.

Serves: ensembles, which step one scene with other values many times. Hides: that the arrays of the
engine lie in one piece of memory then, and what becomes of those that had to grow.
"""

import numpy as np

from tamias2d.engine.arrays.world import gathered
from tamias2d.engine.steps_per_call import StepsPerCall
from tamias2d.simulator.simulator import Simulator
from tamias2d.state import Array, IntArray


class Restart:
    """Puts a simulator back to where it is now; bodies and joints must stay what they are.

    Cost: a copy of the arrays, some microseconds for a few bodies.
    """

    def __init__(self, sim: Simulator) -> None:
        """Note where a simulator is, which has taken no step."""
        sim._settle_between()
        self._sim = sim
        self._worlds_per_call = StepsPerCall()
        self._gather()

    def __call__(self) -> None:
        """Put the simulator back."""
        engine = self._sim._engine
        if engine.capacities != self._capacities:
            self._grow()
        self._memory[: len(self._start)] = self._start
        engine.forget_steps()
        self._sim._forget()

    def step_worlds(
        self, rows: IntArray, given: Array, stands_for: IntArray, stops: IntArray, states: Array
    ) -> int:
        """Step the worlds of some rows to all `stops`, as `engine.world_batch` says.

        Returns how many are done: up to one that is refused, needs longer arrays, or has something
        to tell. The simulator is to be put back before it is used.
        """
        engine = self._sim._engine
        memory, start = self._memory.view(np.int64), self._start.view(np.int64)
        done, taken = 0, self._worlds_per_call.most
        while done < len(rows) and taken == self._worlds_per_call.most:
            asked = rows[done : done + taken]
            self._worlds_per_call.begin()
            taken = engine.step_worlds(memory, start, asked, given, stands_for, stops, states)
            self._worlds_per_call.end(taken)
            done += taken
        return done

    def _gather(self) -> None:
        engine = self._sim._engine
        _ = engine.argument  # which may make arrays longer
        engine.world, self._memory, needed = gathered(engine.world)
        engine.forget_addresses()
        self._start, self._world = self._memory[:needed].copy(), engine.world
        self._capacities = engine.capacities
        self._sim._look()

    def _grow(self) -> None:
        """Let the start have the capacities that steps needed, so that the next ones have them."""
        engine = self._sim._engine
        needed = engine.capacities
        self._memory[: len(self._start)] = self._start
        engine.world, engine.capacities = self._world, self._capacities
        engine.resize(**vars(needed))
        self._gather()
