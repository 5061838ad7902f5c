"""Studies read back from their JSON, so that they can be drawn where they were not measured.

An error without limit, which JSON has no number for, is read as one.
"""

import math
from typing import Any

from tamias2d.cost import Cost
from tamias2d.study.contact_errors import ContactErrors
from tamias2d.study.contact_study import ContactPoint, ContactStudy
from tamias2d.study.event_errors import Errors
from tamias2d.study.work_precision import Point, Seconds, Study

_ALWAYS = ("position", "centre", "overlap", "hang")  # errors that are never left out


def study_from_json(data: dict[str, Any]) -> Study | ContactStudy:
    """Return the study that `as_json` or `contacts_as_json` has written."""
    return _contact_study(data) if data.get("contacts") == "stepped" else _study(data)


def _study(data: dict[str, Any]) -> Study:
    return Study(
        **{key: data[key] for key in ("scene", "duration", "truth", "floor", "phases", "impacts")},
        points=tuple(_point(point) for point in data["points"]),
        complete=data["complete"],
    )


def _point(data: dict[str, Any]) -> Point:
    return Point(
        **{key: data[key] for key in ("method", "setting", "peer", "failure")},
        error=_errors(data["error"]),
        worst=_errors(data["worst"]),
        cost=None if data["cost"] is None else Cost(**data["cost"]),
        seconds=_seconds(data["seconds"]),
    )


def _errors(data: dict[str, Any] | None) -> Errors | None:
    return None if data is None else Errors(**_without_limit(data, "size"))


def _contact_study(data: dict[str, Any]) -> ContactStudy:
    names = ("scene", "duration", "reason", "truth", "floor", "horizon", "phases", "complete")
    return ContactStudy(
        **{key: data[key] for key in names},
        statistics=_statistics(data["statistics"]) or {},
        points=tuple(_contact_point(point) for point in data["points"]),
    )


def _contact_point(data: dict[str, Any]) -> ContactPoint:
    return ContactPoint(
        **{key: data[key] for key in ("method", "setting", "peer", "steps", "passes", "failure")},
        error=_contact_errors(data["error"]),
        worst=_contact_errors(data["worst"]),
        statistics=_statistics(data["statistics"]),
        seconds=_seconds(data["seconds"]),
    )


def _contact_errors(data: dict[str, Any] | None) -> ContactErrors | None:
    return None if data is None else ContactErrors(**_without_limit(data, "quality"))


def _without_limit(data: dict[str, Any], derived: str) -> dict[str, Any]:
    """Return errors, without the one that follows from others."""
    lost = {key: math.inf for key in _ALWAYS if key in data and data[key] is None}
    return {key: value for key, value in (data | lost).items() if key != derived}


def _statistics(data: dict[str, Any] | None) -> dict[str, tuple[float, float]] | None:
    if data is None:
        return None
    return {name: (_known(one["mean"]), _known(one["half_width"])) for name, one in data.items()}


def _known(value: float | None) -> float:
    return math.nan if value is None else value


def _seconds(data: dict[str, Any] | None) -> Seconds | None:
    return None if data is None else Seconds(**data)
