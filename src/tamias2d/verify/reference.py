"""Compare runs with an independent search for events."""

import math
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from tamias2d.run import Run
from tamias2d.simulate import simulate
from tamias2d.state import Array
from tamias2d.verify.case import Case, scene_of
from tamias2d.verify.events import Events, separations, simulate_by_events
from tamias2d.verify.formula import measure
from tamias2d.verify.outcome import Outcome


def compare(case: Case, given: Mapping[str, Any]) -> Iterator[Outcome]:
    """For each scene: instants of impacts in s, the state at the end, overlaps on the way in m."""
    for name, text in given["scenes"].items():
        scene, duration = scene_of(name), float(measure(text, "duration"))
        run = simulate(scene, duration=duration)
        events = simulate_by_events(scene, duration=duration)
        note = f"compared {len(events.time)}"
        yield case.outcome(given, f"{name}: times of impacts", _times(run, events), note)
        yield case.outcome(given, f"{name}: state at the end", _off(run, events))
        yield case.outcome(given, f"{name}: overlap", _overlap(run))


def _times(run: Run, events: Events) -> float:
    if len(run.impacts) != len(events.time):
        return math.inf
    return float(np.abs(run.impacts.time - np.array(events.time)).max(initial=0.0))


def _off(run: Run, events: Events) -> float:
    return float(np.abs(_states(run)[-1] - events.state).max())


def _overlap(run: Run) -> float:
    gaps = separations(run.scene).values()
    return max(0.0, *(-float(gap(state)[0]) for state in _states(run) for gap in gaps))


def _states(run: Run) -> Array:
    """Return the history as events know it: (k, n, 6)."""
    turning = (run.orientation, run.angular_velocity)
    orientation, angular_velocity = (values[..., np.newaxis] for values in turning)
    parts = (run.position, orientation, run.velocity, angular_velocity)
    return np.concatenate(parts, axis=-1)
