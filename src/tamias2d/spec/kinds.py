"""The kinds of item in srs/ and the keys that each takes.

Serves: the reader. Hides: the JSON schema of each kind.
"""

import re
from dataclasses import dataclass
from typing import Any

from tamias2d.spec.comparisons import COMPARISONS
from tamias2d.spec.schema import COUNT, NAME, TEXT, WHOLE, each, listed, mapping, set_of


def _table(schema: dict[str, Any]) -> dict[str, Any]:
    """The schema of a mapping from names to values of one kind."""
    return {"type": "object", "patternProperties": {NAME: schema}, "additionalProperties": False}


_ID = {"type": "string", "pattern": r"^[A-Z]{1,3}[0-9]+[a-z]?(-[a-z]+)?\Z|" + NAME}
_IDS = set_of(_ID)
_NAMES = set_of({"type": "string", "pattern": NAME})
_SOURCES = {**set_of(TEXT), "minItems": 0}
_EXPRESSIONS = _table(TEXT)
_REPLACED = {"type": "object", "additionalProperties": TEXT}  # a key may be an expression
_NUMBERS = listed(TEXT)
_ROWS = {
    "type": "array",
    "items": {"type": "array", "items": TEXT},
}  # that of the first stage is empty
_LIMIT = {"type": "string", "pattern": r"^[0-9]+(\.[0-9]+)?\Z"}


_DERIVATION = listed(mapping(("equation", "by"), equation=TEXT, by=TEXT, where=_REPLACED))
_STATEMENT = {
    "says": TEXT,
    "label_2018": TEXT,
    "uses": _IDS,
    "source": _SOURCES,
    "equation": TEXT,
    "unchecked": TEXT,
    "condition": TEXT,
    "equations": _EXPRESSIONS,
    "arguments": _table(_NAMES),
    "module": {"type": "string", "pattern": NAME},
    "derivation": _DERIVATION,
}
_SYMBOL = mapping(
    ("tex", "unit", "says"),
    tex=TEXT,
    unit=TEXT,
    says=TEXT,
    shape={"enum": ["scalar", "vector"]},
    range=TEXT,
    typical={"anyOf": [TEXT, listed(TEXT)]},
    uncertainty=TEXT,
)
_INDEX = mapping(("tex", "says"), tex=TEXT, says=TEXT, place={"enum": ["sub", "super"]})
_WEIGHTS = each(TEXT)


@dataclass(frozen=True)
class Kind:
    """A kind of item: the form of its ids (None: it has none) and the schema of its keys."""

    name: str
    ids: str | None
    schema: dict[str, Any]

    def takes_id(self, text: str) -> bool:
        """Whether a text has the form of this kind's ids."""
        return self.ids is not None and re.fullmatch(self.ids, text) is not None


KINDS = {
    kind.name: kind
    for kind in (
        Kind("symbols", None, _table(_SYMBOL)),
        Kind("indices", None, _table(_INDEX)),
        Kind("goal", r"GS[0-9]+", mapping(("says", "uses"), says=TEXT, uses=_IDS, label_2018=TEXT)),
        Kind(
            "assumption",
            r"A[0-9]+",
            mapping(("says",), says=TEXT, because=TEXT, uses=_IDS, label_2018=TEXT),
        ),
        Kind("theory", r"TM[0-9]+", mapping(("says",), **_STATEMENT)),
        Kind("definition", r"(GD|DD)[0-9]+", mapping(("says",), **_STATEMENT)),
        Kind(
            "model",
            r"IM[0-9]+",
            mapping(
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
            mapping(
                ("says", "family", "order", "source"),
                says=TEXT,
                family={"enum": ["runge_kutta", "splitting", "exponential", "two_level"]},
                order=WHOLE,
                source=_SOURCES,
                uses=_IDS,
                error_constant=TEXT,
                stability=mapping(("oscillation", "decay"), oscillation=_LIMIT, decay=_LIMIT),
                a=_ROWS,
                b=_NUMBERS,
                error=listed(_NUMBERS),
                error_orders=listed(COUNT),
                dense=listed(_NUMBERS),
                dense_order=WHOLE,
                c=_NUMBERS,
                kick=_NUMBERS,
                drift=_NUMBERS,
                position=_WEIGHTS,
                velocity=_WEIGHTS,
            ),
        ),
        Kind(
            "constraint",
            r"[a-z][a-z0-9_]*",
            mapping(
                ("says", "parameters", "constraint"),
                says=TEXT,
                uses=_IDS,
                source=_SOURCES,
                condition=TEXT,
                parameters={**_NAMES, "minItems": 0},
                equations=_EXPRESSIONS,
                constraint=set_of(TEXT),
            ),
        ),
        Kind(
            "requirement",
            r"(R|NFR)[0-9]+",
            mapping(
                ("says",),
                says=TEXT,
                uses=_IDS,
                fit=TEXT,
                label_2018=TEXT,
                judged={"enum": ["by people"]},
            ),
        ),
        Kind(
            "change",
            r"(LC|UC)[0-9]+",
            mapping(("says",), says=TEXT, affects=_IDS, uses=_IDS, label_2018=TEXT),
        ),
        Kind(
            "property",
            r"P[0-9]+",
            mapping(
                ("says",),
                says=TEXT,
                uses=_IDS,
                equation=TEXT,
                unchecked=TEXT,
                derivation=_DERIVATION,
                condition=TEXT,
                label_2018=TEXT,
                crowd=mapping(
                    ("within",),
                    within={"type": "string", "pattern": r"^[1-9](\.[0-9]+)?e-[0-9]+\Z"},
                    bodies={"enum": ["steady"]},
                    relation={"enum": ["at most"]},
                ),
            ),
        ),
        Kind(
            "erratum",
            r"E[0-9]+",
            mapping(
                ("document", "found", "now", "corrects"),
                document={"enum": ["SRS", "plan", "Drasil", "code", "report"]},
                found=TEXT,
                now=TEXT,
                corrects=_IDS,
            ),
        ),
        Kind(
            "case",
            r"(TC|O[A-Z])[0-9]+[a-z]?",
            mapping(
                ("verifies", "uses"),
                verifies=_IDS,
                uses={**_IDS, "minItems": 0},
                says=TEXT,
                scene={"type": ["string", "object"]},
                duration=TEXT,
                **COMPARISONS,
            ),
        ),
    )
}
LINKS = ("uses", "verifies", "corrects", "affects")
