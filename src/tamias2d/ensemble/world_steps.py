"""A step of many worlds, in as few calls of compiled code as can be.

Serves: `Simulators`. Hides: which worlds can take it in one call, and which take it by themselves:
those that are new, near nothing or changed by hand, and those with loads that vary. After a call
Python looks at those worlds only in which there is something to tell.
"""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager

import numpy as np

from tamias2d.engine.interruption import end_if_asked
from tamias2d.engine.steps_per_call import StepsPerCall
from tamias2d.engine.tables import DONE, LIMIT_CHANGES, LIMITS, STEPS_LEFT
from tamias2d.ensemble.shared_arrays import SharedArrays
from tamias2d.errors import InputError, SimulationError, TamiasError
from tamias2d.simulator import Simulator
from tamias2d.state import IntArray

_MOST_STEPS = 32  # of one call of `step`: of more, what Python does besides is little
_FEWEST_WORLDS = 4  # of fewer, it is as much


class WorldSteps:
    """The steps of some simulators, of which some arrays lie one after the other."""

    def __init__(self, sims: Sequence[Simulator], shared: SharedArrays) -> None:
        """Let the engines keep their tables of addresses one after the other."""
        self._sims, self._pose = sims, shared.pose
        self._left = np.zeros_like(shared.pose)  # where the last step left bodies
        self._counts = (
            shared.counts[:, LIMITS],
            shared.counts[:, STEPS_LEFT],
            shared.joint_counts[:, LIMIT_CHANGES],
        )
        self._known = np.zeros((len(self._counts), len(sims)), dtype=np.int64)
        self._tables = np.zeros((len(sims), *sims[0]._engine.table_shape), dtype=np.int64)
        for sim, table in zip(sims, self._tables, strict=True):
            sim._engine.keep_table_in(table)
        self._worlds_per_call: dict[tuple[int, int], StepsPerCall] = {}

    def take(self, steps: int, part: range, faults: dict[int, TamiasError]) -> None:
        """Let some worlds take some steps; note the faults of those that cannot."""
        alone = set(part)
        if steps <= _MOST_STEPS and len(part) >= _FEWEST_WORLDS:
            together = np.array(list(self._ready(part)), dtype=np.int64)
            alone.difference_update(together.tolist())
            self._take_together(steps, together, part.start, faults)
        for world in sorted(alone):
            end_if_asked()
            sim = self._sims[world]
            sim._seen = True  # its arrays are shared
            with _noted(world, faults):
                sim.step(steps)

    def _ready(self, part: range) -> Iterator[int]:
        """Yield those worlds whose steps the engine can take by itself."""
        library = self._sims[part.start]._engine.step_function
        rows = slice(part.start, part.stop)
        moved = (self._pose[rows] != self._left[rows]).any(axis=(1, 2)).tolist()
        for world, changed in zip(part, moved, strict=True):
            sim = self._sims[world]
            if not sim._steps_simply or sim._engine.step_function is not library:
                continue
            if sim._left.base is not self._left:
                self._left[world], sim._left = sim._left, self._left[world]
                changed = bool((self._pose[world] != self._left[world]).any())
            if not (changed and sim._jointed):
                yield world

    def _take_together(
        self, steps: int, worlds: IntArray, part: int, faults: dict[int, TamiasError]
    ) -> None:
        """Take steps in some worlds, so many a call that Python sees signals in between."""
        calls = self._worlds_per_call.setdefault((part, steps), StepsPerCall())
        first = 0
        while first < len(worlds):
            end_if_asked()
            some = worlds[first : first + calls.most]
            ends = np.zeros(len(some), dtype=np.int64)
            for world in some.tolist():
                self._sims[world]._begin_steps(steps)
            calls.begin()
            self._sims[some[0]]._engine.step_function(self._tables[some], ends, steps)
            calls.end(len(some))
            self._end(steps, some, ends, faults)
            first += len(some)

    def _end(
        self, steps: int, worlds: IntArray, ends: IntArray, faults: dict[int, TamiasError]
    ) -> None:
        """End the steps of those worlds in which there is something to do or to tell."""
        self._left[worlds] = self._pose[worlds]
        counts = np.stack([each[worlds] for each in self._counts])
        other = (ends != DONE) | (counts != self._known[:, worlds]).any(axis=0)
        other |= steps > 1  # whose events are taken
        self._known[:, worlds] = counts
        for world, status in zip(worlds[other].tolist(), ends[other].tolist(), strict=True):
            with _noted(world, faults):
                self._sims[world]._end_steps(steps, status)


@contextmanager
def _noted(world: int, faults: dict[int, TamiasError]) -> Iterator[None]:
    """Note the fault of a step of a world."""
    try:
        yield
    except (InputError, SimulationError) as fault:
        faults[world] = fault
