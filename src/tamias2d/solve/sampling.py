"""The states of a run at any times, not only at its samples."""

from collections.abc import Callable, Sequence
from contextlib import suppress

import numpy as np

from tamias2d.contact import Located, Refusal
from tamias2d.kernels import march_by_kernels
from tamias2d.motion import PathMethod
from tamias2d.motion.reference import NoStepError
from tamias2d.motion.track import sample
from tamias2d.run import Run
from tamias2d.scene import in_pieces
from tamias2d.solve.assembly import work_limit_of
from tamias2d.solve.located import follower_of
from tamias2d.solve.solution import solve
from tamias2d.state import Array, History, place_between
from tamias2d.work_limit import Work, WorkLimitError


def sampler(run: Run) -> Callable[[Array, Sequence[int]], History]:
    """Return a function from sorted times (k,), s, and bodies to their states.

    The run is simulated once more. Where it is stepped, states between the ends of steps are those
    of `place_between`.
    """
    scene, method, step = run.scene, run.method, run.time_step
    if not isinstance(method, PathMethod):
        steps = solve(scene, duration=run.duration, method=method, time_step=step)
        return lambda times, bodies: _interpolated(steps, times, bodies)
    scene = in_pieces(scene)
    motion = method.motion(scene, run.duration, step or run.duration)
    motion.work = Work(0.0, work_limit_of(run))
    march_by_kernels(motion, scene)
    located = Located(scene, motion, motion.work, follower_of(scene, method, None))
    refusals = (Refusal, NoStepError, WorkLimitError)
    with np.errstate(all="ignore"), suppress(*refusals):  # as far as the run went
        located.go(run.duration)
    return lambda times, bodies: sample([located.tracks[k] for k in bodies], times)


def _interpolated(run: Run, times: Array, bodies: Sequence[int]) -> History:
    """Return states between the samples of a run, which are the ends of its steps."""
    after = np.clip(np.searchsorted(run.times, times, side="right"), 1, len(run.times) - 1)
    before = after - 1
    step = run.times[after] - run.times[before]
    share = (times - run.times[before]) / step
    places, rates = [], []
    for place, rate in (
        (run.position, run.velocity),
        (run.orientation, run.angular_velocity),
    ):
        near = [part[rows][:, list(bodies)] for part in (place, rate) for rows in (before, after)]
        wide = [part.reshape(-1, *[1] * (place.ndim - 1)) for part in (step, share)]
        places.append(place_between(*near, *wide))
        rates.append(near[2] + wide[1] * (near[3] - near[2]))
    return History(places[0], places[1], rates[0], rates[1])
