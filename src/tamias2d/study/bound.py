"""What bounds the error of a run, and what all bounds are made of."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from tamias2d.certificate import USUAL, Basis, BoundKind
from tamias2d.float64 import EPSILON
from tamias2d.motion import Method
from tamias2d.run import Run
from tamias2d.state import Array
from tamias2d.study.companion import RefusedError, companion, limit_beside
from tamias2d.study.error import apart
from tamias2d.study.scale import radii


@dataclass(frozen=True)
class Bound:
    """How far a run is from its exact places at most, and from what that is known."""

    kind: BoundKind
    value: float
    """m"""
    how: str
    order: float | None = None
    basis: Basis = USUAL


Bounder: TypeAlias = Callable[[Run, Array | None], Bound]
"""From a run, and how small changes grow in it where that is known, to a bound."""


class NoBoundError(Exception):
    """Why there is none; `lost_at` is the horizon, s, if that is why."""

    def __init__(self, why: str, lost_at: float | None = None) -> None:
        super().__init__(why)
        self.lost_at = lost_at


def rounding(run: Run) -> float:
    """Return the rounding of the largest terms in any place of the run, m."""
    reach = radii(run.scene)
    speed = np.hypot(*np.moveaxis(run.velocity, -1, 0)) + np.abs(run.angular_velocity) * reach
    far = np.hypot(*np.moveaxis(run.position, -1, 0)) + np.abs(run.orientation) * reach
    worst = far.max(axis=0) + run.times[-1] * speed.max(axis=0)
    moving = np.array([body.dynamic for body in run.scene.bodies], dtype=bool)
    return EPSILON * float(worst[moving].max(initial=0.0))


def difference(one: Run, other: Run) -> float:
    """Return how far two runs are apart at most, m; infinity where one has no place."""
    worst = float(apart(one, other).max())
    return worst if math.isfinite(worst) else math.inf


def companion_of(run: Run, *, method: Method | None = None, time_step: float | None = None) -> Run:
    """Return a run of the same scene at the same times, by another method or step."""
    try:
        return companion(
            run.scene,
            duration=run.duration,
            times=run.times,
            method=method or run.method,
            time_step=time_step,
            work_limit=limit_beside(run),
        )
    except RefusedError as fault:
        raise NoBoundError(f"a companion run was refused: {fault}") from fault
