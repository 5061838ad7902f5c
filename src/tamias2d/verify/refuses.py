"""Check that inputs which break a rule are refused, by name.

Serves: cases of bad input. Hides: how a message is matched.
"""

import math
from collections.abc import Iterator, Mapping
from typing import Any

from tamias2d.errors import TamiasError
from tamias2d.simulate import simulate
from tamias2d.verify.case import Case, scene_of
from tamias2d.verify.outcome import Outcome


def compare(case: Case, given: Mapping[str, Any]) -> Iterator[Outcome]:
    """Each scene must raise an error of this library that says what it is about."""
    for label, entry in given["scenes"].items():
        message = _refusal(entry["scene"])
        good = message is not None and entry["says"] in message
        note = "" if good else message or "was accepted"
        yield case.outcome(given, f"refused: {label}", 0.0 if good else math.inf, note)


def _refusal(data: Mapping[str, Any]) -> str | None:
    try:
        scene = scene_of(data)
        if scene.duration is not None:
            simulate(scene, duration=scene.duration)
    except TamiasError as error:
        return str(error)
    return None
