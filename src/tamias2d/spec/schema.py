"""Pieces of JSON schema that several kinds of item share.

Serves: the kinds of item and of comparison. Hides: the dialect of JSON schema.
"""

from typing import Any

TEXT: dict[str, Any] = {"type": "string", "minLength": 1}
WHOLE: dict[str, Any] = {"type": "string", "pattern": r"^[0-9]+\Z"}
COUNT: dict[str, Any] = {"type": "string", "pattern": r"^[1-9][0-9]*\Z"}
NAME = r"^[a-z][a-z0-9_]*\Z"  # not `$`, which allows a line after the name


def mapping(required: tuple[str, ...] = (), **properties: Any) -> dict[str, Any]:
    """The schema of a mapping with these keys and no others."""
    return {
        "type": "object",
        "properties": properties,
        "required": list(required),
        "additionalProperties": False,
    }


def each(value: Any) -> dict[str, Any]:
    """The schema of a mapping from any keys, of which there is one, to values of one kind."""
    return {"type": "object", "additionalProperties": value, "minProperties": 1}


def listed(entry: Any) -> dict[str, Any]:
    """The schema of a list of entries of one kind, of which there is one."""
    return {"type": "array", "items": entry, "minItems": 1}


def set_of(entry: Any) -> dict[str, Any]:
    """The schema of a list of entries of one kind, of which there is one, and none twice."""
    return listed(entry) | {"uniqueItems": True}
