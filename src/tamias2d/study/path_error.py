"""Bounds of runs that choose their steps, from the equation of their error (R5)."""

import math
from collections.abc import Sequence

import numpy as np

from tamias2d.certificate import Basis
from tamias2d.motion import Dop853, DormandPrince5, Method
from tamias2d.motion.error_equation import Watch
from tamias2d.run import Run
from tamias2d.scene import Scene
from tamias2d.scene.acting import felt_velocity, kinked, only_slowed
from tamias2d.scene.reach import pairs_that_can_meet
from tamias2d.solve import StoppedError, solve_with_error
from tamias2d.state import Array
from tamias2d.study.bound import Bound, Bounder, NoBoundError, rounding
from tamias2d.study.companion import limit_beside
from tamias2d.study.scale import farthest, reach_of, scale, scale_of

_TIGHTEST, _JOINTED = 3e-12, 1e-10
"""Of the tolerances of a method whose steps err by more than the equation is rounded; the same with
joints, where chaotic motion lets the rounding of their rows grow."""
_SURE, _TRUSTED = 1.5, 2.3  # times the error that was integrated: a small one, and a larger one
_SMALL = 1e-4  # of the scale: up to there more than the small one is believed
_SLOWED, _TINY = (1.75, 3.0), 1e-6
"""The same where bodies are only slowed: of an error that is larger than this share of the scale,
and of the smallest. Rates within a step are known badly, and steps of high order feel that most."""
_FEW, _LUCKY = 24, 10.0
"""So few steps may err by chance by so many times less than they would by their tolerance."""
_EARLY = 0.05  # of the run: before, its length says little
_GROWTH = 1.5  # power of the time with which errors grow, from 1 to 2, if nothing else is known
_MOST = 30.0  # times more is an error guessed to grow: it may have jumped
_FAR = 0.01  # of the scale: as that is exceeded, steps are too few to say much of their error


def has_error_equation(scene: Scene, method: Method, duration: float) -> bool:
    """Whether the error of a run solves an equation that is smooth but at impacts.

    Joints are known as long as they do nothing at instants, and nothing meets.
    """
    if not isinstance(method, Dop853 | DormandPrince5) or method.halved:
        return False
    if method.rtol < tightest(scene) or kinked(scene):
        return False
    if not scene.joints:
        return True
    return not (
        any(joint.switches for joint in scene.joints) or pairs_that_can_meet(scene, duration)
    )


def tightest(scene: Scene) -> float:
    """Return the smallest tolerance of a method at which the equation still tells its error."""
    return _JOINTED if scene.joints else _TIGHTEST


def error_beside(run: Run) -> Array | None:
    """Return the largest error (n, 3) beside a run, m and rad; the run is made again for that."""
    assert isinstance(run.method, Dop853 | DormandPrince5)
    limit = limit_beside(run)
    return solve_with_error(
        run.scene, duration=run.duration, method=run.method, times=run.times, work_limit=limit
    )[1]


def of_error(error: Array | None) -> Bounder:
    """Return what bounds the error of a run by the largest (n, 3) that was integrated."""

    def bounder(run: Run, _: Array | None) -> Bound:
        if error is None:
            raise NoBoundError("the equation of its error has no solution beside the run")
        value = _trusted(run.scene, error, scale(run))
        flights = 1 + len(run.impacts)
        if run.cost and run.cost.steps < _FEW * flights and not only_slowed(run.scene):
            usual = run.method.rtol * scale(run)  # type: ignore[attr-defined]
            value = max(value, min(usual, _LUCKY * _farthest(error, run.scene)))
        how = f"{run.method} and the equation of its error"
        return Bound("embedded", value + rounding(run), how, basis=Basis("error equation"))

    return bounder


class HopelessError(StoppedError):
    """A run is farther off than was asked for, and has not ended."""

    def __init__(self, share: float, time: float) -> None:
        super().__init__()
        self.share = share
        """What its bound would be at the end, of the scale."""
        self.time = time
        """Up to here it was within what was asked for, s."""


def hopeless(scene: Scene, duration: float, tolerance: float) -> Watch:
    """Return what stops a run, by `HopelessError`, that will not be within a tolerance.

    Errors grow at least with the time, where nothing that feels a velocity damps them. How far off
    the run would be at its end is told by the power of the time with which they have grown.
    """
    grows = not felt_velocity(scene)
    places = [max(map(abs, body.position)) for body in scene.bodies if body.dynamic]
    place = max(places, default=0.0)
    known: list[tuple[float, float]] = []

    def watch(time: float, error: Array, extent: Array) -> None:
        far = scale_of(scene, float(farthest(scene, extent)), place)
        share = _trusted(scene, error, far) / far
        known.append((time, share))
        if not _EARLY * duration <= time < duration:
            return
        left = duration / time
        if share * (left if grows else 1.0) > tolerance:
            least = left**_GROWTH if grows else 1.0
            raise HopelessError(share * max(min(left ** _power(known), _MOST), least), time)

    return watch


def _power(known: Sequence[tuple[float, float]]) -> float:
    """Return the power of the time with which an error has grown since half of it; 0 if none is."""
    time, share = known[-1]
    before = [each for each in known if each[0] <= time / 2]
    if not before or not before[-1][1] > 0.0:
        return 0.0
    earlier, then = before[-1]
    return math.log(share / then) / math.log(time / earlier)


def _trusted(scene: Scene, error: Array, length: float) -> float:
    """Return how large an error may be that was integrated, m, beside a motion of a length, m."""
    farthest = _farthest(error, scene)
    share = farthest / length
    if only_slowed(scene):
        large, tiny = _SLOWED
        times = tiny + (large - tiny) * min(1.0, share / _TINY)
    else:
        times = _SURE + (_TRUSTED - _SURE) * min(1.0, math.sqrt(share / _SMALL))
    return times * farthest * (1 + share / _FAR)


def _farthest(error: Array, scene: Scene) -> float:
    """Return how far the worst point of the bodies that move is off, m, by errors (n, 3)."""
    x, y, turn = error.T
    return float((np.hypot(x, y) + turn * reach_of(scene, len(error))).max(initial=0.0))
