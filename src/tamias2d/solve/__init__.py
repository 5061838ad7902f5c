"""From a scene to its run, by the method that suits it or that was asked for (R5, R6, R8).

Serves: `simulate` and the studies. Hides: how a method is chosen, and how each kind of method makes
a run.
"""

from tamias2d.solve.assembly import sampled_at, with_reason, work_limit_of
from tamias2d.solve.following import Interrupted, interruptible
from tamias2d.solve.plan import FRAMES, planned
from tamias2d.solve.sampling import sampler
from tamias2d.solve.solution import StoppedError, solve, solve_halved, solve_with_error

__all__ = [
    "FRAMES",
    "Interrupted",
    "StoppedError",
    "interruptible",
    "planned",
    "sampled_at",
    "sampler",
    "solve",
    "solve_halved",
    "solve_with_error",
    "with_reason",
    "work_limit_of",
]
