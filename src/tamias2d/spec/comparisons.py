"""What a verification case can compare, and the keys of each comparison.

Serves: the kinds of item. Hides: the JSON schema of a comparison. Each carries a tolerance, the
reason for it, and where the exact answer comes from.
"""

from typing import Any

from tamias2d.spec.schema import TEXT, WHOLE, mapping

_LIST: dict[str, Any] = {"type": "array"}
_MAPPING: dict[str, Any] = {"type": "object"}
_NUMBER = {"type": "string", "pattern": r"^[0-9]+(\.[0-9]+)?([eE][+-]?[0-9]+)?$"}
_TREND = {"enum": ["constant", "falls"]}
_GROUNDS = {"tolerance": _NUMBER, "because": TEXT, "source": TEXT}


def _comparison(*required: str, **keys: Any) -> dict[str, Any]:
    return mapping((*required, *_GROUNDS), **keys, **_GROUNDS)


COMPARISONS = {
    "exact": _comparison("bodies", bodies=_MAPPING, reference=_NUMBER),
    "final": _comparison("bodies", bodies=_MAPPING),
    "impacts": _comparison(count=WHOLE, times=_LIST, impulses=_LIST),
    "moments": _comparison("states", states=_LIST),
    "schemes": _comparison(
        "steps",
        steps={"anyOf": [WHOLE, _MAPPING]},
        durations=_MAPPING,
        of=_MAPPING,
        orders=_LIST,
        shows=_MAPPING,
        constants=_MAPPING,
    ),
    "certified": _comparison("tolerances", tolerances=_LIST),
    "published": _comparison(
        "time_step",
        "steps",
        "tables",
        time_step=TEXT,
        steps=_LIST,
        tables=_MAPPING,
        misprints=_LIST,
    ),
    "conserves": _comparison(
        momentum=_TREND, angular_momentum=_TREND, energy=_TREND, schemes=_MAPPING
    ),
    "stepped": _comparison(
        "time_step",
        time_step=TEXT,
        bodies=_MAPPING,
        momentum=_TREND,
        angular_momentum=_TREND,
        energy=_TREND,
        centre_of_mass={"enum": ["uniform"]},
    ),
    "reference": _comparison("scenes", scenes=_MAPPING),
    "worlds": _comparison(
        "vary",
        "worlds",
        "within",
        "bodies",
        vary=_MAPPING,
        worlds=WHOLE,
        within=_NUMBER,
        bodies=_MAPPING,
        scheme=TEXT,
        time_step=TEXT,
    ),
    "values": _comparison("module", "calls", module=TEXT, calls=_LIST),
    "refuses": _comparison("scenes", scenes=_MAPPING),
    "notes": _comparison("scenes", scenes=_MAPPING),
    "pace": _comparison(),
    "survey": mapping(
        ("questions", "answers"), task=TEXT, questions=_LIST, answers=WHOLE, limit=TEXT
    ),
}
WITHOUT_RUN = ("reference", "values", "refuses", "notes", "survey")
"""Comparisons that ask for no run of the case's scene; all others do, and for how long."""
