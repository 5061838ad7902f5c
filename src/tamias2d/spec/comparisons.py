"""What a verification case can compare, and the keys of each comparison.

Serves: the kinds of item. Hides: the JSON schema of a comparison. Each carries a tolerance, the
reason for it, and where the exact answer comes from.
"""

from typing import Any

from tamias2d.spec.schema import COUNT, TEXT, WHOLE, each, listed, mapping, set_of

_NUMBER = {"type": "string", "pattern": r"^[0-9]+(\.[0-9]+)?([eE][+-]?[0-9]{1,2})?\Z"}
_SIGNED = {"type": "string", "pattern": r"^-?[0-9]+(\.[0-9]+)?([eE][+-]?[0-9]{1,2})?\Z"}
_TREND = {"enum": ["constant", "falls"]}
_BODIES = each(each(TEXT))  # body, quantity, expression
_PAIR = {**listed(TEXT), "minItems": 2, "maxItems": 2}
_VALUE = {"anyOf": [TEXT, listed(TEXT), listed(_PAIR)]}
_SCENE = {"type": ["string", "object"], "minLength": 1, "minProperties": 1}
_RUNS = each(mapping(("scene", "says"), scene=_SCENE, says=TEXT, scheme=TEXT, time_step=TEXT))
_MISPRINT = mapping(
    ("body", "quantity", "sample", "reads"),
    body=TEXT,
    quantity=TEXT,
    sample=COUNT,
    component={"enum": ["x", "y"]},
    reads=_SIGNED,
    says=TEXT,
)
_PRINTED = {"anyOf": [_SIGNED, {**listed(_SIGNED), "minItems": 2, "maxItems": 2}]}
_GROUNDS = {"tolerance": _NUMBER, "because": TEXT, "source": TEXT}


def _comparison(*required: str, **keys: Any) -> dict[str, Any]:
    return mapping((*required, *_GROUNDS), **keys, **_GROUNDS)


COMPARISONS = {
    "exact": _comparison("bodies", bodies=_BODIES, reference=_NUMBER),
    "final": _comparison("bodies", bodies=_BODIES),
    "impacts": _comparison(count=WHOLE, times=listed(TEXT), impulses=listed(TEXT)),
    "moments": _comparison(
        "states", states=listed(mapping(("at", "bodies"), at=TEXT, bodies=_BODIES))
    ),
    "schemes": _comparison(
        "steps",
        steps={"anyOf": [COUNT, each(COUNT)]},
        durations=each(TEXT),
        of=each(set_of(TEXT)),
        orders=set_of(TEXT),
        shows=each(COUNT),
        constants=each(_BODIES),
    ),
    "certified": _comparison("tolerances", tolerances=listed(_NUMBER)),
    "published": _comparison(
        "time_step",
        "steps",
        "tables",
        time_step=TEXT,
        steps=set_of(WHOLE),
        tables=each(each(listed(_PRINTED))),
        misprints=set_of(_MISPRINT),
    ),
    "conserves": _comparison(
        momentum=_TREND, angular_momentum=_TREND, energy=_TREND, schemes=each(COUNT)
    ),
    "stepped": _comparison(
        "time_step",
        time_step=TEXT,
        bodies=_BODIES,
        momentum=_TREND,
        angular_momentum=_TREND,
        energy=_TREND,
        centre_of_mass={"enum": ["uniform"]},
    ),
    "reference": _comparison("scenes", scenes=each(TEXT)),
    "worlds": _comparison(
        "vary",
        "worlds",
        "within",
        "bodies",
        vary=each(_PAIR),
        worlds=COUNT,
        within=_NUMBER,
        bodies=_BODIES,
        scheme=TEXT,
        time_step=TEXT,
    ),
    "values": _comparison(
        "module",
        "calls",
        module=TEXT,
        calls=listed(
            mapping(
                ("given", "expect"),
                given={"type": "object", "additionalProperties": _VALUE},
                expect=each(_VALUE),
            )
        ),
    ),
    "refuses": _comparison("scenes", scenes=_RUNS),
    "notes": _comparison("scenes", scenes=_RUNS),
    "pace": _comparison(),
    "survey": mapping(
        ("questions", "answers"), task=TEXT, questions=listed(TEXT), answers=WHOLE, limit=TEXT
    ),
}
WITHOUT_RUN = ("reference", "values", "refuses", "notes", "survey")
"""Comparisons that ask for no run of the case's scene; all others do, and for how long."""
