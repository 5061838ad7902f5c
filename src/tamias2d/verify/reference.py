"""Compare runs with an independent search for events."""

import math
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from tamias2d.run import Run
from tamias2d.simulate import simulate
from tamias2d.verify.case import Case, scene_of
from tamias2d.verify.events import Events, simulate_by_events
from tamias2d.verify.formula import measure
from tamias2d.verify.outcome import Outcome


def compare(case: Case, given: Mapping[str, Any]) -> Iterator[Outcome]:
    """For each scene: the instants of all impacts in s, and the state at the end."""
    for name, text in given["scenes"].items():
        scene, duration = scene_of(name), float(measure(text, "duration"))
        run = simulate(scene, duration=duration)
        events = simulate_by_events(scene, duration=duration)
        note = f"{len(events.time)} impacts"
        yield case.outcome(given, f"{name}: times of impacts", _times(run, events), note)
        yield case.outcome(given, f"{name}: state at the end", _state(run, events))


def _times(run: Run, events: Events) -> float:
    if len(run.impacts) != len(events.time):
        return math.inf
    return float(np.abs(run.impacts.time - np.array(events.time)).max(initial=0.0))


def _state(run: Run, events: Events) -> float:
    ours = np.column_stack(
        (run.position[-1], run.orientation[-1], run.velocity[-1], run.angular_velocity[-1])
    )
    return float(np.abs(ours - events.state).max())
