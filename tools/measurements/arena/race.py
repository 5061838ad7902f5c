"""Engines on one scene in turns, so that what disturbs one disturbs all of them.

Serves: the measurement of contacts. Hides: how turns are taken and times are kept.

Time is that of the processor: what else the machine does is not counted, and a second thread is.
"""

import gc
import os
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from statistics import median
from time import process_time

from tamias2d.scene import Scene
from tools.measurements.arena.engine import Engine, Maker

TIME_STEP = 1 / 60
"""s"""
_TURN = 10  # steps of one engine before it is another's turn


@dataclass(frozen=True)
class Times:
    """Seconds of a step of each engine by name: one number for each repetition."""

    seconds: dict[str, list[float]]

    def median(self, name: str) -> float:
        """Return seconds."""
        return median(self.seconds[name])

    def ratio(self, name: str, to: str) -> float:
        """Return the median of an engine's time over another's in the same repetition."""
        both = zip(self.seconds[name], self.seconds[to], strict=True)
        return median(one / other for one, other in both)


def race(
    makers: Sequence[Maker],
    scene: Scene,
    *,
    steps: int,
    repeats: int,
    warm_up: int = 0,
    done: Callable[[], object] = lambda: None,
) -> Times:
    """Let engines take steps in turns, each repetition from the start of the scene.

    A first repetition of a few steps, and `warm_up` steps of each, are not counted; `done` is
    called after each repetition.
    """
    _run(makers, scene, _TURN, 0)
    seconds: dict[str, list[float]] = {}
    for _ in range(repeats):
        for name, total in _run(makers, scene, steps, warm_up).items():
            seconds.setdefault(name, []).append(total / steps)
        done()
    return Times(seconds)


def _run(makers: Sequence[Maker], scene: Scene, steps: int, warm_up: int) -> dict[str, float]:
    engines = [make(scene, TIME_STEP) for make in makers]
    for engine in engines:
        _advance(engine, warm_up)
    total = {engine.name: 0.0 for engine in engines}
    with undisturbed():
        for start in range(0, steps, _TURN):
            engines.append(engines.pop(0))  # nobody is always the first
            for engine in engines:
                total[engine.name] += _advance(engine, min(_TURN, steps - start))
    return total


def _advance(engine: Engine, steps: int) -> float:
    start = process_time()
    for _ in range(steps):
        engine.step()
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
