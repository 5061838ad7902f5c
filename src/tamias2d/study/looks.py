"""When a run is looked at, whatever samples were asked for: so that its scale is its own."""

import math

import numpy as np
from numpy.typing import NDArray

from tamias2d.motion.fixed_steps import grid
from tamias2d.run import Run
from tamias2d.simulator.stepper import SAME_STEP
from tamias2d.solve import FRAMES
from tamias2d.state import Array

_FEWEST, _MOST = 120, 1024
LOOKS_AT_STEPS = 120  # at most, of runs by steps through contacts
_ROUNDED = 1e-9  # of the time between two looks


def looks(duration: float) -> Array:
    """Return times (k,), s: 60 a second, or by a power of two more or fewer, some 120 to 1024."""
    return grid(duration, _between(duration))


def with_looks(times: Array, duration: float) -> Array:
    """Return sorted times (k,), s, with those of all looks at a run of a duration, s."""
    more = looks(duration)
    return np.union1d(times, more[_nearest(times, more, duration)[1] > 0.0])


def looked_at(run: Run) -> NDArray[np.int64] | None:
    """Return the samples of a run at which it is looked at; None if some are missing."""
    rows, off = _nearest(run.times, looks(run.duration), run.duration)
    return None if off.any() else rows


def ends_of_steps(duration: float, step: float) -> Array:
    """Return the times (k,), s, of some 60 to 120 ends of steps, or of all if these are fewer."""
    steps = math.ceil(duration / step * (1 - SAME_STEP))
    every = max(math.ceil(steps / LOOKS_AT_STEPS), 1)
    found: Array = np.minimum(np.arange(0, steps + every, every) * step, duration)
    return found


def with_ends_of_steps(times: Array, duration: float, step: float) -> Array:
    """Return sorted times (k,), s, with what it takes to see how far runs by steps go, and part."""
    more = ends_of_steps(duration, step)
    place = np.searchsorted(times, more - SAME_STEP * step)
    known = np.append(times, math.inf)[place] <= more + SAME_STEP * step
    return np.unique(np.concatenate((times, more[~known])))


def _nearest(
    times: Array, wanted: Array, duration: float
) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Return which of sorted times are nearest to others (k,), and how far off but by rounding."""
    after = np.minimum(np.searchsorted(times, wanted), len(times) - 1)
    before = np.maximum(after - 1, 0)
    nearer = np.abs(times[before] - wanted) < np.abs(times[after] - wanted)
    rows = np.where(nearer, before, after)
    off = np.abs(times[rows] - wanted)
    return rows, np.where(off > _ROUNDED * _between(duration), off, 0.0)


def _between(duration: float) -> float:
    """Return the time between two looks, s: a power of two, so that their times are samples."""
    step = 1 / FRAMES
    while duration < _FEWEST * step and step / 2 > 0.0:
        step /= 2
    while duration > _MOST * step:
        step *= 2
    return step
