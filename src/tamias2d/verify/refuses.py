"""Check that inputs which break a rule are refused, by name, and that runs note what they say."""

import math
from collections.abc import Iterator, Mapping
from typing import Any

from tamias2d.errors import TamiasError
from tamias2d.run import Run
from tamias2d.simulate import simulate
from tamias2d.verify.case import Case, scene_of
from tamias2d.verify.formula import measure
from tamias2d.verify.outcome import Outcome
from tamias2d.verify.schemes import METHODS


def compare(case: Case, given: Mapping[str, Any]) -> Iterator[Outcome]:
    """Each scene must raise an error of this library that says what it is about."""
    for label, entry in given["scenes"].items():
        message = _refusal(entry)
        good = message is not None and entry["says"] in message
        note = "" if good else message or "was accepted"
        yield case.outcome(given, f"refused: {label}", 0.0 if good else math.inf, note)


def compare_notes(case: Case, given: Mapping[str, Any]) -> Iterator[Outcome]:
    """Each scene must run, and a note of its run must say what it is about."""
    for label, entry in given["scenes"].items():
        run = _run(entry)
        notes = run.notes if run else ()
        good = any(entry["says"] in note for note in notes)
        note = "" if good else "; ".join(notes)
        yield case.outcome(given, f"noted: {label}", 0.0 if good else math.inf, note)


def _refusal(entry: Mapping[str, Any]) -> str | None:
    """Return what a scene is refused with, or None."""
    try:
        _run(entry)
    except TamiasError as error:
        return str(error)
    return None


def _run(entry: Mapping[str, Any]) -> Run | None:
    """Run a scene, with the scheme that is asked for; one without a duration is only read."""
    method = METHODS[entry["scheme"]] if "scheme" in entry else None
    step = measure(entry["time_step"], "time_step") if method else None
    scene = scene_of(entry["scene"])
    if scene.duration is None:
        return None
    return simulate(scene, duration=scene.duration, method=method, time_step=step)
