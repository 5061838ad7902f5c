"""Companion runs: made beside a run to judge it; a refusal of one is an answer, too."""

from typing import Any

from tamias2d.errors import SceneError, SimulationError
from tamias2d.run import Run
from tamias2d.scene import Scene
from tamias2d.solve import solve
from tamias2d.work_limit import WORK_LIMIT


class RefusedError(Exception):
    """A companion run was refused; what the user stops is not among these."""


_MORE = 4  # times the work of a run may a more accurate one take


def limit_beside(run: Run) -> int:
    """Return the work limit of companion runs: that of a run which has had a higher one grows."""
    steps = run.cost.steps if run.cost else 0
    return max(WORK_LIMIT, _MORE * (steps + len(run.impacts.time)))


def error_left(loose: Run, tight: Run) -> float:
    """Return how much of the error of a run is left in a tighter one, by order and steps."""
    steps = [one.cost.steps if one.cost else 1 for one in (loose, tight)]
    order = float(loose.method.facts.order) if loose.method.facts else 1.0
    return float((steps[0] / steps[1]) ** order)


def companion(scene: Scene, **inputs: Any) -> Run:
    """Return a run as `simulate` does; raise `RefusedError` where that refuses one."""
    try:
        return solve(scene, **inputs)
    except (SimulationError, SceneError) as fault:
        raise RefusedError(str(fault)) from fault
