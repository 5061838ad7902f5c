"""A fault of form in words: what was found, and which rule of the schema it breaks.

Serves: the reader. Hides: the errors of the JSON schema validator.
"""

import re
from collections.abc import Iterator
from typing import Any

import jsonschema

from tamias2d.spec.chapter import Item
from tamias2d.spec.messages import Code, Diagnostic

_TYPES = {"string": "text", "array": "list", "object": "mapping"}


def schema_fault(item: Item, error: jsonschema.ValidationError) -> Diagnostic:
    """The fault of an item that breaks a rule of its schema, at its place."""
    path: tuple[str | int, ...] = tuple(error.absolute_path)
    schema: dict[str, Any] = error.schema  # type: ignore[assignment] # ours are mappings
    if error.validator in ("required", "additionalProperties"):
        named = next(_unknown_keys(error, schema), None)
        where = (*path, named, "key") if named else path
        reason = f"'{named}' is no key here" if named else error.message
        allowed = ", ".join(schema.get("properties", {})) or "a lower-case word"
        return item.diagnostic(Code.BAD_KEY, f"{reason}: must be of {allowed}. Correct it", *where)
    found = f"'{error.instance}'" if isinstance(error.instance, str) else _form(error.instance)
    key = next((str(part) for part in reversed(path) if isinstance(part, str)), "")
    text = f"{found} is not what '{key}' takes: must {_rule(error)}. Correct it"
    return item.diagnostic(Code.BAD_VALUE, text, *path)


def _form(value: Any) -> str:
    return f"{'a list' if isinstance(value, list) else 'a mapping'} of {len(value)}"


def _rule(error: jsonschema.ValidationError) -> str:
    """What a value must do, in words, by the rule of its schema that it breaks."""
    value: Any = error.validator_value
    match error.validator:
        case "minLength":
            return "not be empty"
        case "minItems" | "maxItems" | "minProperties":
            bound = "at most" if error.validator == "maxItems" else "at least"
            return f"have {bound} {value} {'entries' if value != 1 else 'entry'}"
        case "uniqueItems":
            return "have no entry twice"
        case "enum":
            return f"be one of {', '.join(value)}"
        case "pattern":
            return f"match {value}"
        case "type":
            return f"be a {_TYPES[value] if isinstance(value, str) else 'text or a mapping'}"
    return "be a text, a pair or a list of such, as its key asks"


def _unknown_keys(error: jsonschema.ValidationError, schema: dict[str, Any]) -> Iterator[str]:
    if error.validator != "additionalProperties":
        return
    patterns = schema.get("patternProperties", {})
    for key in dict(error.instance):  # type: ignore[arg-type] # only mappings have keys
        if key not in schema.get("properties", {}) and not any(re.search(p, key) for p in patterns):
            yield key
