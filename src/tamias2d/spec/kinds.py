"""The kinds of item in srs/ and the keys that each takes.

Serves: the reader. Hides: the JSON schema of each kind.
"""

import re
from dataclasses import dataclass
from typing import Any

_TEXT = {"type": "string", "minLength": 1}
_ID = {"type": "string", "pattern": r"^[A-Z]{1,3}[0-9]+[a-z]?(-[a-z]+)?$|^[a-z][a-z0-9_]*$"}
_IDS = {"type": "array", "items": _ID}
_NAMES = {"type": "array", "items": {"type": "string", "pattern": "^[a-z][a-z0-9_]*$"}}
_TEXTS = {"type": "array", "items": _TEXT}
_EXPRESSIONS = {"type": "object", "additionalProperties": _TEXT}
_WHOLE = {"type": "string", "pattern": "^[0-9]+$"}
_NUMBERS = {"type": "array", "items": {"type": "string"}}


def _mapping(required: tuple[str, ...] = (), **properties: Any) -> dict[str, Any]:
    return {
        "type": "object",
        "properties": properties,
        "required": list(required),
        "additionalProperties": False,
    }


_DERIVATION = {
    "type": "array",
    "items": _mapping(("equation", "by"), equation=_TEXT, by=_TEXT, where=_EXPRESSIONS),
}
_STATEMENT = {
    "says": _TEXT,
    "label_2018": _TEXT,
    "uses": _IDS,
    "source": _TEXTS,
    "equation": _TEXT,
    "condition": _TEXT,
    "equations": _EXPRESSIONS,
    "arguments": {"type": "object", "additionalProperties": _NAMES},
    "module": {"type": "string", "pattern": "^[a-z_]+$"},
    "derivation": _DERIVATION,
}
_SYMBOL = _mapping(
    ("tex", "unit", "says"),
    tex=_TEXT,
    unit=_TEXT,
    says=_TEXT,
    shape={"enum": ["scalar", "vector"]},
    range=_TEXT,
    typical={},
    uncertainty=_TEXT,
)
_INDEX = _mapping(("tex", "says"), tex=_TEXT, says=_TEXT, place={"enum": ["sub", "super"]})
_WEIGHTS = {"type": "object", "additionalProperties": _TEXT}


@dataclass(frozen=True)
class Kind:
    """A kind of item: the form of its ids (None: it has none) and the schema of its keys."""

    name: str
    ids: str | None
    schema: dict[str, Any]

    def takes_id(self, text: str) -> bool:
        """Whether a text has the form of this kind's ids."""
        return self.ids is not None and re.fullmatch(self.ids, text) is not None


def _table(schema: dict[str, Any]) -> dict[str, Any]:
    names = {"^[a-z][a-z0-9_]*$": schema}
    return {"type": "object", "patternProperties": names, "additionalProperties": False}


KINDS = {
    kind.name: kind
    for kind in (
        Kind("symbols", None, _table(_SYMBOL)),
        Kind("indices", None, _table(_INDEX)),
        Kind("goal", r"GS\d+", _mapping(("says", "uses"), says=_TEXT, uses=_IDS, label_2018=_TEXT)),
        Kind(
            "assumption",
            r"A\d+",
            _mapping(("says",), says=_TEXT, because=_TEXT, uses=_IDS, label_2018=_TEXT),
        ),
        Kind("theory", r"TM\d+", _mapping(("says",), **_STATEMENT)),
        Kind("definition", r"(GD|DD)\d+", _mapping(("says",), **_STATEMENT)),
        Kind(
            "model",
            r"IM\d+",
            _mapping(
                ("says", "input", "output", "equations"),
                **_STATEMENT,
                input=_NAMES,
                output=_NAMES,
                states=_EXPRESSIONS,
                closed_form=_EXPRESSIONS,
            ),
        ),
        Kind(
            "scheme",
            r"[a-z][a-z0-9_]*",
            _mapping(
                ("says", "family", "order", "source"),
                says=_TEXT,
                family={"enum": ["runge_kutta", "splitting", "two_level"]},
                order=_WHOLE,
                source=_TEXTS,
                uses=_IDS,
                error_constant=_TEXT,
                a={"type": "array", "items": _NUMBERS},
                b=_NUMBERS,
                c=_NUMBERS,
                kick=_NUMBERS,
                drift=_NUMBERS,
                position=_WEIGHTS,
                velocity=_WEIGHTS,
            ),
        ),
        Kind(
            "requirement",
            r"(R|NFR)\d+",
            _mapping(
                ("says",),
                says=_TEXT,
                uses=_IDS,
                fit=_TEXT,
                label_2018=_TEXT,
                judged={"enum": ["by people"]},
            ),
        ),
        Kind(
            "change",
            r"(LC|UC)\d+",
            _mapping(("says",), says=_TEXT, affects=_IDS, uses=_IDS, label_2018=_TEXT),
        ),
        Kind(
            "property",
            r"P\d+",
            _mapping(
                ("says",), says=_TEXT, uses=_IDS, equation=_TEXT, condition=_TEXT, label_2018=_TEXT
            ),
        ),
        Kind(
            "erratum",
            r"E\d+",
            _mapping(
                ("document", "found", "now", "corrects"),
                document={"enum": ["SRS", "plan", "Drasil", "code", "report"]},
                found=_TEXT,
                now=_TEXT,
                corrects=_IDS,
            ),
        ),
        Kind("case", r"(TC|O[A-Z])\d+[a-z]?", {"type": "object", "required": ["verifies"]}),
    )
}
LINKS = ("uses", "verifies", "corrects", "affects")
