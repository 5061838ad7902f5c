"""The faults that a chapter or an expression can have, each with a stable code.

Serves: one message form for every fault. Hides: how a message is laid out.
"""

from dataclasses import dataclass
from enum import Enum

from tamias2d.errors import printable


class Code(Enum):
    """Stable code of a fault, and what it means."""

    UNREADABLE = "unreadable", "the file is missing, not UTF-8, or too large"
    BAD_NAME = "bad-name", "the name of a chapter's file has other signs than a-z, 0-9 and _"
    YAML = "yaml", "the text is not valid YAML"
    YAML_FEATURE = "yaml-feature", "anchors, aliases and tags are refused"
    DUPLICATE_KEY = "duplicate-key", "a key stands twice in one mapping"
    UNKNOWN_KIND = "unknown-kind", "no kind of item has this name"
    BAD_HEADING = "bad-heading", "an item needs an id of its kind and a title, a chapter a title"
    BAD_KEY = "bad-key", "a key is missing or is not one of the kind's keys"
    BAD_VALUE = "bad-value", "a value has not the form that its key asks for"
    DUPLICATE_ID = "duplicate-id", "an id or a symbol is declared twice"
    UNKNOWN_ID = "unknown-id", "a link leads to no item"
    WRONG_LINK = "wrong-link", "a link leads to an item of a kind that the key cannot name"
    UNKNOWN_NAME = "unknown-name", "a name is neither a symbol nor a symbol with indices"
    SYNTAX = "syntax", "the expression cannot be read"
    NOT_ALLOWED = "not-allowed", "the language has no such construct"
    TOO_LARGE = "too-large", "the expression or a number in it exceeds the limits"
    UNKNOWN_UNIT = "unknown-unit", "no unit has this name"
    UNIT_MISMATCH = "unit-mismatch", "the two sides have different units"
    SHAPE_MISMATCH = "shape-mismatch", "a vector stands where a scalar must, or the reverse"
    SAME_LETTER = "same-letter", "two quantities of a chapter have the same letter"
    BAD_RANGE = "bad-range", "a range of a symbol cannot be read"
    DERIVATION_GAP = "derivation-gap", "a step does not follow from the one before"
    UNCHECKED = "unchecked", "nothing would notice if a statement were wrong"
    CLOSED_FORM = "closed-form", "the closed form does not solve the model's equations"
    CIRCLE = "circle", "what is said of something leads back to the same thing"
    SCHEME_ORDER = "scheme-order", "the coefficients do not have the order that is claimed"
    SCHEME_STABILITY = "scheme-stability", "the coefficients do not have the limits claimed"

    def __init__(self, code: str, meaning: str) -> None:
        self.code = code
        self.meaning = meaning


_LONGEST = 40  # characters of a text that a message repeats whole


def excerpt(text: str) -> str:
    """Return a text as a message repeats it: whole, or how it begins and how long it is."""
    return text if len(text) <= _LONGEST else f"{text[:20]}... ({len(text)} characters)"


class SpecFault(Exception):  # noqa: N818 - it becomes a Diagnostic, the error that users see
    """A fault in one text, before its place in a file is known; `offset` counts characters."""

    def __init__(self, code: Code, message: str, offset: int = 0) -> None:
        super().__init__(message)
        self.code = code
        self.message = message
        self.offset = offset


@dataclass(frozen=True, order=True)
class Diagnostic:
    """One fault with its place: `file:line:column: code: what was found, the rule, what to do`."""

    file: str
    line: int
    column: int
    code: str
    message: str

    def __str__(self) -> str:
        where = f"{self.file}:{self.line}:{self.column}"
        return f"{where}: {self.code}: {printable(self.message)}"
