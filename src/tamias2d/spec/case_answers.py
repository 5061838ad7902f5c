"""Answers that one comparison of a case takes from another: they are there, for the same bodies.

Serves: the check of a case. Hides: which comparison takes its answers from which.
"""

from collections.abc import Iterator, Mapping
from typing import Any

from tamias2d.spec.chapter import Item
from tamias2d.spec.equations import Report
from tamias2d.spec.messages import Code

_TAKES_FROM = {
    "schemes": ("exact", "final"),
    "certified": ("exact",),
    "published": ("exact",),
}
Path = tuple[str | int, ...]


def check_shared_answers(item: Item, report: Report) -> None:
    """Report a comparison without its answers, and bodies and quantities that have none there."""
    data = item.data
    for key, others in _TAKES_FROM.items():
        if key not in data:
            continue
        given = [data[other]["bodies"] for other in others if other in data]
        if not given:
            text = f"'{key}' takes its answers from {' or '.join(others)}, which is missing"
            report(item.diagnostic(Code.BAD_KEY, f"{text}. State it", key))
            continue
        for path, body, quantity in _wanted(data, key):
            if quantity not in given[0].get(body, ()):
                text = f"'{others[0]}' has no answer for '{quantity}' of '{body}'. Correct one"
                report(item.diagnostic(Code.UNKNOWN_NAME, text, *path))
    if "published" in data:
        _check_tables(item, data["published"], report)


def _wanted(data: Mapping[str, Any], key: str) -> Iterator[tuple[Path, str, str]]:
    """The answers that a comparison takes: where it asks, body and quantity."""
    given = data[key]
    if key == "certified":
        yield from (((key,), body, "position") for body in data["exact"]["bodies"])
    for body, names in given.get("of", {}).items():
        yield from ((("schemes", "of", body, n), body, name) for n, name in enumerate(names))
    for scheme, bodies in given.get("constants", {}).items():
        for body, names in bodies.items():
            path = ("schemes", "constants", scheme, body)
            yield from (((*path, name, "key"), body, name) for name in names)
    for body, tables in given.get("tables", {}).items():
        for name in tables:
            yield ("published", "tables", body, name, "key"), body, name


def _check_tables(item: Item, given: Mapping[str, Any], report: Report) -> None:
    """Report tables that have not a row for each step, and misprints of no printed number."""
    rows = len(given["steps"])
    for body, tables in given["tables"].items():
        for name, table in tables.items():
            if len(table) != rows:
                text = f"{len(table)} rows for {rows} steps. Give one for each"
                report(
                    item.diagnostic(Code.BAD_VALUE, text, "published", "tables", body, name, "key")
                )
    for number, entry in enumerate(given.get("misprints", ())):
        table = given["tables"].get(entry["body"], {}).get(entry["quantity"], [])
        sample = int(entry["sample"])
        if sample > len(table) or isinstance(table[sample - 1], list) != ("component" in entry):
            text = "the misprint is of no number that stands in 'tables'. Correct its place"
            report(item.diagnostic(Code.UNKNOWN_NAME, text, "published", "misprints", number))
