"""A study as JSON, for machines, in the form that `tradeoff.schema.json` says."""

import json
import math
from dataclasses import asdict
from importlib import resources
from typing import Any

from tamias2d.study.event_errors import Errors
from tamias2d.study.work_precision import Point, Study

_VERSION = 1


def as_json(study: Study, *, tolerance: float | None) -> dict[str, Any]:
    """Return a study as JSON holds it: an error that is not finite is null."""
    return {
        "version": _VERSION,
        "scene": study.scene,
        "duration": study.duration,
        "tolerance": tolerance,
        "truth": study.truth,
        "floor": study.floor,
        "phases": study.phases,
        "impacts": study.impacts,
        "complete": study.complete,
        "points": [_point(point) for point in study.points],
        "front": {"seconds": study.fastest, "force_evaluations": study.leanest},
    }


def schema() -> dict[str, Any]:
    """Return the JSON schema of `as_json`."""
    text = resources.files("tamias2d.study").joinpath("tradeoff.schema.json").read_text("utf-8")
    found: dict[str, Any] = json.loads(text)
    return found


def _point(point: Point) -> dict[str, Any]:
    return {
        "method": point.method,
        "setting": point.setting,
        "peer": point.peer,
        "error": _errors(point.error),
        "worst": _errors(point.worst),
        "cost": None if point.cost is None else asdict(point.cost),
        "seconds": None if point.seconds is None else asdict(point.seconds),
        "failure": point.failure,
    }


def _errors(errors: Errors | None) -> dict[str, Any] | None:
    if errors is None:
        return None
    values = asdict(errors) | {"size": errors.size}
    return {
        name: value if value is None or math.isfinite(value) else None
        for name, value in values.items()
    }
