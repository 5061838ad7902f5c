"""What it costs to know where everything is after each step.

Serves: the measurement of contacts. Hides: how short times are taken.
"""

from statistics import median
from time import perf_counter

from tamias2d.scene import Scene
from tamias2d.study.engines.engine import Maker
from tools.measurements.arena.race import TIME_STEP, undisturbed

_STEPS = 200
_READS = 20  # after each step, since looking at the clock takes as long as a short one


def share_of_a_step(make: Maker, scene: Scene) -> float:
    """Return the time of reading all positions over that of a step."""
    engine = make(scene, TIME_STEP)
    engine.step()
    engine.read()
    steps, reads = [], []
    with undisturbed():
        for _ in range(_STEPS):
            start = perf_counter()
            engine.step()
            middle = perf_counter()
            for _ in range(_READS):
                engine.read()
            end = perf_counter()
            steps.append(middle - start)
            reads.append((end - middle) / _READS)
    return median(reads) / median(steps)
