"""The verdicts of the last verification, kept between commands.

Service: outcomes of each case, read and written. Secret: the file and its form.
"""

import json
from collections.abc import Iterable

from tamias2d import storage
from tamias2d.verify.outcome import Outcome, read_outcome

_FORMAT = 1


def read() -> dict[str, tuple[Outcome, ...]]:
    """Return the last outcomes by case; none if there is no file, or one of another version."""
    try:
        content = json.loads(storage.results_path().read_text(encoding="utf-8"))
        if content["format"] != _FORMAT:
            return {}
        rows = content["cases"].items()
        return {id: tuple(read_outcome(row) for row in found) for id, found in rows}
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return {}


def add(outcomes: Iterable[Outcome]) -> None:
    """Replace the outcomes of the cases that were judged now; keep those of the others."""
    found: dict[str, list[Outcome]] = {}
    for outcome in outcomes:
        found.setdefault(outcome.id, []).append(outcome)
    kept = {id: list(outcomes) for id, outcomes in read().items()} | found
    cases = {id: [outcome.as_json() for outcome in kept[id]] for id in sorted(kept)}
    text = json.dumps({"format": _FORMAT, "cases": cases}, indent=1, allow_nan=False)
    storage.write_aside(storage.results_path(), text.encode())
