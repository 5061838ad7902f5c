"""A study as JSON, for machines, in the form that `tradeoff.schema.json` says."""

import json
import math
from dataclasses import asdict
from importlib import resources
from typing import Any

from tamias2d.study.contact_errors import ContactErrors
from tamias2d.study.contact_study import ContactPoint, ContactStudy
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


def schema(name: str = "tradeoff") -> dict[str, Any]:
    """Return the JSON schema of `as_json`, or "contact_tradeoff", that of `contacts_as_json`."""
    place = resources.files("tamias2d.study").joinpath(f"{name}.schema.json")
    found: dict[str, Any] = json.loads(place.read_text("utf-8"))
    return found


def contacts_as_json(study: ContactStudy, *, tolerance: float | None) -> dict[str, Any]:
    """Return a study of stepped contacts as JSON holds it, in the form of its own schema."""
    return {
        "version": _VERSION,
        "scene": study.scene,
        "duration": study.duration,
        "tolerance": tolerance,
        "contacts": "stepped",
        "reason": study.reason,
        "truth": study.truth,
        "floor": study.floor,
        "horizon": study.horizon,
        "phases": study.phases,
        "statistics": _statistics(study.statistics),
        "complete": study.complete,
        "points": [_contact_point(point) for point in study.points],
        "front": {
            "seconds": study.fastest,
            "sweeps": study.leanest,
            "quality": study.soundest,
        },
    }


def _contact_point(point: ContactPoint) -> dict[str, Any]:
    return {
        "method": point.method,
        "setting": point.setting,
        "peer": point.peer,
        "steps": point.steps,
        "passes": point.passes,
        "error": _errors(point.error),
        "worst": _errors(point.worst),
        "statistics": _statistics(point.statistics),
        "seconds": None if point.seconds is None else asdict(point.seconds),
        "failure": point.failure,
    }


def _statistics(found: dict[str, tuple[float, float]] | None) -> dict[str, Any] | None:
    if found is None:
        return None
    return {
        name: {"mean": _number(mean), "half_width": _number(half)}
        for name, (mean, half) in found.items()
    }


def _number(value: float | None) -> float | None:
    return value if value is None or math.isfinite(value) else None


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


def _errors(errors: Errors | ContactErrors | None) -> dict[str, Any] | None:
    if errors is None:
        return None
    own = {"size": errors.size} if isinstance(errors, Errors) else {"quality": errors.quality}
    values = asdict(errors) | own
    return {name: _number(value) for name, value in values.items()}
