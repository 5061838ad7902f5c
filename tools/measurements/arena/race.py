"""Engines on one scene in turns, so that what disturbs one disturbs all of them.

Serves: the measurement of contacts. Hides: how turns are taken and times are kept.

Time is that of the processor: what else the machine does is not counted, and a second thread is.
"""

import gc
import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from statistics import median
from time import process_time

from tamias2d.scene import Scene
from tamias2d.study.engines.engine import Engine, Maker

TIME_STEP = 1 / 60
"""s"""
_TURN = 10  # steps of one engine before it is another's turn


@dataclass(frozen=True)
class Times:
    """Seconds of each engine by name: rows are repetitions, columns are turns."""

    turns: dict[str, list[list[float]]]
    steps: int
    """Of all turns together."""

    def of_a_step(self, name: str) -> float:
        """Return seconds: of each turn the median over repetitions, which no burst moves."""
        medians = [float(median(turn)) for turn in zip(*self.turns[name], strict=True)]
        return sum(medians) / self.steps

    def ratio(self, name: str, to: str) -> float:
        """Return an engine's time over another's."""
        return self.of_a_step(name) / self.of_a_step(to)


def race(
    makers: Sequence[Maker], scene: Scene, *, steps: int, repeats: int, call: int = 1
) -> Times:
    """Let engines take steps in turns, each repetition from the start of the scene.

    They are asked for `call` steps at once. A first repetition of one turn is not counted, and
    neither is the first call of any, in which an engine gets to know the scene.
    """
    _run(makers, scene, max(_TURN, call), call)
    turns: dict[str, list[list[float]]] = {}
    for _ in range(repeats):
        for name, times in _run(makers, scene, steps, call).items():
            turns.setdefault(name, []).append(times)
    return Times(turns, steps)


def _run(makers: Sequence[Maker], scene: Scene, steps: int, call: int) -> dict[str, list[float]]:
    engines = [make(scene, TIME_STEP) for make in makers]
    times: dict[str, list[float]] = {engine.name: [] for engine in engines}
    with undisturbed():
        turn = max(_TURN, call)
        for engine in engines:
            engine.step(call)
        for start in range(0, steps, turn):
            engines.append(engines.pop(0))  # nobody is always the first
            for engine in engines:
                times[engine.name].append(_advance(engine, min(turn, steps - start), call))
    return times


def _advance(engine: Engine, steps: int, call: int) -> float:
    start = process_time()
    for _ in range(0, steps, call):
        engine.step(call)
    return process_time() - start


@contextmanager
def undisturbed() -> Iterator[None]:
    """Collect no garbage and stay on one core, where the system lets one choose."""
    cores = os.sched_getaffinity(0) if hasattr(os, "sched_getaffinity") else set()
    gc.collect()
    gc.disable()
    try:
        if cores:
            os.sched_setaffinity(0, {max(cores)})
        yield
    finally:
        if cores:
            os.sched_setaffinity(0, cores)
        gc.enable()
