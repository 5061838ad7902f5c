"""`tamias2d.simulate`: a scene solved as asked, or as a tolerance demands (R5, R6, R8)."""

from collections.abc import Iterable

from tamias2d.errors import InputError
from tamias2d.motion import Method
from tamias2d.run import Run
from tamias2d.scene import Scene
from tamias2d.solve import interruptible, planned, solve
from tamias2d.study.quality import checked_quality, of_quality
from tamias2d.study.recommend import checked_tolerance
from tamias2d.study.tolerance import within
from tamias2d.suggestions import suggests
from tamias2d.work_limit import WORK_LIMIT


@suggests
def simulate(
    scene: Scene,
    *,
    duration: float,
    method: Method | None = None,
    time_step: float | None = None,
    times: Iterable[float] | None = None,
    tolerance: float | None = None,
    quality: float | None = None,
    progress: bool = False,
    work_limit: int = WORK_LIMIT,
) -> Run:
    """Simulate a scene for a duration in s, and return its history.

    Impacts are located: the path of the method is followed to the instant at which a pair meets,
    and IM3 says how it parts. Without a `method` it is the closed form if all bodies have one, and
    the reference otherwise; but contacts are stepped (`Stepped`, R12) where a body is kinematic, a
    sensor or a compound, where bodies are so near at the start that they are meant to touch, and
    from the start where impacts, located, came to what rigid bodies leave open. More than a hundred
    moving bodies that can meet are stepped, too, unless they are convex, under constant loads, and
    do not settle. The first of the run's `notes` names the method and the reason.

    `times` are those of the samples, s, sorted and within the run; without them it is 60 a second,
    or every step (`time_step`, s) of a stepped method. Steps through contacts are of 1/60 s where
    none is asked for, and a 240th of a run that is shorter than half a second. States between two
    are interpolated; the last one may end beyond the run, but none is longer than it. `progress`
    shows a bar on standard error. A run takes at most `work_limit` steps of a method that chooses
    them itself, and impacts; it ends early if it can be seen to take more.

    With a `tolerance` method and step are those that meet it at the least cost, found by pilot
    runs, and the run has a certificate (`recommend` says what is bounded).

    With a `quality`, such as 0.01, overlaps are no deeper than this share of the smaller body's
    radius, and the energy changes by no more than this share of itself beyond what impacts and
    friction may take; again at the least cost and with a certificate. It can be asked for where no
    tolerance can be met: in piles, past the time up to which runs of short steps agree.

    Raises:
        InputError: an argument breaks a rule, or the history would take more than 1 GiB.
        SceneError: bodies overlap at the start, or a pair that meets has no restitution.
        SimulationError: by the method that was asked for the answer is not unique, or not within
            the models; the message says when, and the error's `run` is the history up to there.
        ToleranceError: nothing meets the tolerance or the quality; it says what can be met.
        RangeError: a number of the run, or its energy or momentum, is beyond float64.
        StabilityError: the method is unstable at the time step; told before it runs.
        WorkLimitError: the run takes more steps and impacts than `work_limit`; likewise.
        StepSizeError: no step that float64 can take meets an adaptive method's tolerance.
        Interrupted: the user stopped it; likewise with its `run`. Within a tolerance or a quality
            that is a try for it, not known to be within, or the start alone between tries.
    """
    if tolerance is None and quality is None:
        return solve(
            scene,
            duration=duration,
            method=method,
            time_step=time_step,
            times=times,
            progress=progress,
            work_limit=work_limit,
        )
    plan = planned(scene, duration, method, time_step, times, work_limit)
    _refuse_both(tolerance, quality, method)
    with interruptible(plan):
        if quality is not None:
            return of_quality(
                scene,
                duration=plan.duration,
                quality=checked_quality(quality),
                times=plan.times,
                progress=progress,
                work_limit=work_limit,
            )
        return within(
            scene,
            duration=plan.duration,
            tolerance=checked_tolerance(tolerance),
            times=plan.times,
            progress=progress,
            work_limit=work_limit,
        )


def _refuse_both(tolerance: object, quality: object, method: Method | None) -> None:
    """Raise `InputError` if more than one of three that exclude each other is asked for."""
    if tolerance is not None and quality is not None:
        raise InputError(
            f"quality {quality!r}: found tolerance {tolerance!r} beside it: the cheapest run for "
            "one is not that for the other (R5). Give one of the two."
        )
    if method is not None:
        what = f"quality {quality!r}" if tolerance is None else f"tolerance {tolerance!r}"
        raise InputError(
            f"{what}: found method {method} beside it: the method follows from it (R5). Give one "
            "of the two."
        )
