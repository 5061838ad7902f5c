"""The bound of runs in closed form: what rounding does (R5)."""

import math

from tamias2d.run import Run
from tamias2d.state import Array
from tamias2d.study.bound import Bound, NoBoundError, rounding
from tamias2d.study.perturbed import rounding_spread

_ROUNDINGS = 2.0  # of the largest terms of a closed form, in each of its values
_FORCES, _EVALUATIONS = 2.0, 22  # roundings of a force that holds; forces that a step asks for
_SPREADS = 3.0  # times as far as runs perturbed by one rounding the exact answer may be


def exact(run: Run, grown: Array | None) -> Bound:
    """Bound what rounding does, from the sizes of the terms and, with impacts, from perturbed runs.

    An impact is located within the rounding of its gap, which moves its instant by that over the
    normal velocity, and all that follows. Runs perturbed by one rounding show that.
    """
    value = _ROUNDINGS * rounding(run) * _held(run)
    if not len(run.impacts):
        return Bound("exact", value, "closed form, bounded from the rounding of its terms")
    strayed = rounding_spread(run)
    if strayed is None or grown is None:
        raise NoBoundError("a scene that differs by rounding ends in a refusal")
    how = (
        f"closed form and {len(run.impacts)} located impacts, bounded from runs perturbed "
        f"by one rounding; a small change grows to {float(grown.max()):.3g} times its size"
    )
    return Bound("exact", value + _SPREADS * strayed, how)


def _held(run: Run) -> float:
    """Return how much more rounds where contacts hold bodies, whose paths are integrated then.

    Each step rounds, at random, and so does the force that holds them.
    """
    evaluations = run.cost.force_evaluations if run.cost else 0
    return max(1.0, _FORCES * math.sqrt(evaluations / _EVALUATIONS))
