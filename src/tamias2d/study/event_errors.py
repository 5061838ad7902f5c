"""Event-aware errors: measures of a run with impacts that fall as the run gets better.

Two runs put one impact at slightly different instants, between which their velocities differ by a
whole jump, however good they are. So impacts are compared one by one, in the order of each pair,
and histories as graphs over time, in which jumps are lines.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from tamias2d.run import Run
from tamias2d.study.error import history_error
from tamias2d.study.graph import fastest, graph_distance
from tamias2d.study.invariants import energy_drift
from tamias2d.study.sampled import Sampled
from tamias2d.study.scale import radii, scale


@dataclass(frozen=True, kw_only=True)
class Errors:
    """How far a run is from the truth; None where a measure does not apply."""

    position: float
    """Of the whole history, relative to the scale of the true one (`study.error`)."""
    event_time: float | None = None
    """Of impacts that both have, by pair and order; relative to the duration."""
    event_state: float | None = None
    """Just after these impacts, each run at its own: places relative to the scale of the true
    history, velocities to its largest speed."""
    missed: int | None = None
    """Impacts that the run does not have."""
    extra: int | None = None
    """Impacts that only the run has."""
    graph: float | None = None
    """Hausdorff distance of the graphs of states over time, jumps filled, by the same scales."""
    drift: float | None = None
    """Of the energy, less what impacts took by its own account; relative to the largest kinetic
    energy. None where loads do work that no potential holds."""

    @property
    def size(self) -> float:
        """The largest of those of positions, of times and of states of impacts."""
        return max(self.position, self.event_time or 0.0, self.event_state or 0.0)


def errors(found: Sampled, truth: Sampled) -> Errors:
    """Return how far what was found is from the truth; both have one scene and duration."""
    run, exact = found.run, truth.run
    position = history_error(found.common, truth.common)
    drift = energy_drift(run)
    if not len(exact.impacts) and not len(run.impacts):
        return Errors(position=position, drift=drift)
    matched = list(_matched(found.events, truth.events))
    times = [abs(run.times[k] - exact.times[j]) / exact.duration for k, j in _rows(matched)]
    states = [_state_apart(run, k, exact, j) for k, j in _rows(matched)]
    return Errors(
        position=position,
        event_time=float(max(times, default=0.0)),
        event_state=float(max(states, default=0.0)),
        missed=sum(j is not None and k is None for k, j in matched),
        extra=sum(k is not None and j is None for k, j in matched),
        graph=graph_distance(run, exact),
        drift=drift,
    )


Events = dict[tuple[int, int], list[int]]
"""For each pair, the samples just after its impacts."""


def _matched(found: Events, true: Events) -> Iterator[tuple[int | None, int | None]]:
    """Yield the samples of one impact in both, or None where one has no more of its pair."""
    for pair in sorted({*found, *true}):
        ours, theirs = found.get(pair, []), true.get(pair, [])
        for k in range(max(len(ours), len(theirs))):
            yield (
                (ours[k] if k < len(ours) else None),
                (theirs[k] if k < len(theirs) else None),
            )


def _rows(matched: list[tuple[int | None, int | None]]) -> list[tuple[int, int]]:
    return [(k, j) for k, j in matched if k is not None and j is not None]


def _state_apart(run: Run, k: int, exact: Run, j: int) -> float:
    """Return how far the states of all bodies are apart, at sample k of one and j of the other."""
    length, speed, reach = scale(exact), fastest(exact), radii(run.scene)
    place = np.linalg.norm(run.position[k] - exact.position[j], axis=-1)
    place = place + np.abs(run.orientation[k] - exact.orientation[j]) * reach
    rate = np.linalg.norm(run.velocity[k] - exact.velocity[j], axis=-1)
    rate = rate + np.abs(run.angular_velocity[k] - exact.angular_velocity[j]) * reach
    worst = max(float(place.max()) / length, float(rate.max()) / speed)
    return worst if math.isfinite(worst) else math.inf
