"""Steps in which surely nothing happens in joints, many at once (GD21, GD22).

Serves: the steps of jointed bodies. Hides: what is watched. It says what the search for events
(`joint_search`) would say, from the same looks at measures alone and with something to spare for
rounding; where it does not say so, the search decides.
"""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tamias2d.motion.joint_events import Mode, Of
from tamias2d.motion.joint_search import LOOKS
from tamias2d.motion.limited_mechanism import LimitedMechanism
from tamias2d.motion.step_batch import StepBatch
from tamias2d.state import Array

_SPARE = 1e-9  # of a radian, of the mechanism's size, or of speeds: a thousand times what is slight


class _Watched(NamedTuple):
    """A measure, or its rate, of which a sense away from a bound is to stay positive."""

    row: int
    sense: float
    bound: float
    least: float
    """More than what counts as none, and than rounding."""
    of_rate: bool = False
    turns: bool = False
    """Whether it may be none between two looks."""


def quiet(mechanism: LimitedMechanism, own: Sequence[int], steps: StepBatch) -> int:
    """Return how many of the first steps are such, for a mechanism whose bodies are at `own`.

    Its mode must be one of which measures tell the end (`LimitedMechanism.is_measured`).
    """
    mode = mechanism.mode(steps.times[0])
    count = len(steps.times) - 1
    watched = list(_watched(mechanism, mode, steps.knots[0, 0, own]))
    if not watched:
        return count
    times = np.linspace(steps.times[:-1], steps.times[1:], LOOKS + 1, axis=1)
    states = steps.at(times.ravel())[:, :, own]
    values, rates = (
        part.reshape(*times.shape, -1)
        for part in mechanism.measures.along(times.ravel(), states[:, 0], states[:, 1])
    )
    spans = np.diff(times, axis=1)
    found = [_stays(each, spans, values[..., each.row], rates[..., each.row]) for each in watched]
    good = np.logical_and.reduce(found)
    return count if good.all() else int(np.argmin(good))


def _stays(watched: _Watched, spans: Array, value: Array, rate: Array) -> NDArray[np.bool_]:
    """Return in which of k steps (k,) it stays positive, by its looks (k, l)."""
    left = watched.sense * ((rate if watched.of_rate else value) - watched.bound)
    good = (left > watched.least).all(axis=1)
    if watched.turns:  # no line along which it falls, or rose, gets to its bound
        slope = watched.sense * rate
        falls = left[:, :-1] + np.minimum(slope[:, :-1], 0.0) * spans
        rose = left[:, 1:] - np.maximum(slope[:, 1:], 0.0) * spans
        good = good & (np.minimum(falls, rose) > watched.least).all(axis=1)
    return np.asarray(good)


def _watched(mechanism: LimitedMechanism, mode: Mode, position: Array) -> Iterator[_Watched]:
    length = mechanism.length(position)
    for of, side in mechanism.sides(mode):
        least = mechanism.slight(of, position) + _spare(mechanism, of, length)
        end = mechanism.end(of, side, mode)
        yield _Watched(mechanism.row[of], -side, end, least, turns=True)
    for of, each in mechanism.freedoms.items():
        if each.pitch is not None and of[0] not in mode.broken:
            tooth = mechanism.end(of, -1, mode) + each.pitch
            yield _Watched(mechanism.row[of], -1.0, tooth, _spare(mechanism, of, length))
    for of, sense in mode.driven:
        if sense and np.isfinite(mechanism.most(of)) and of[0] not in mode.broken:
            row, speed = mechanism.row[of], mechanism.motor_speed(of)
            least = float(mechanism.noise[row]) + _SPARE * (
                abs(speed) + float(mechanism.fastest[row])
            )
            yield _Watched(row, -sense, speed, least, of_rate=True)


def _spare(mechanism: LimitedMechanism, of: Of, length: float) -> float:
    return _SPARE * (1.0 if mechanism.freedoms[of].measure == "angle" else length)
