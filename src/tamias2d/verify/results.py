"""The verdicts of the last verification, kept between commands."""

import json
from collections.abc import Iterable

from tamias2d import storage
from tamias2d.verify.outcome import Outcome, read_outcome

_FORMAT = 2


def read() -> dict[str, list[Outcome]]:
    """Return the last outcomes by case; none if there is no file, or one of another version."""
    found: dict[str, list[Outcome]] = {}
    try:
        content = json.loads(storage.results_path().read_text(encoding="utf-8"))
        rows = content["cases"] if content["format"] == _FORMAT else []
        for outcome in map(read_outcome, rows):
            found.setdefault(outcome.id, []).append(outcome)
    except (OSError, ValueError, KeyError, TypeError):
        return {}
    return found


def add(outcomes: Iterable[Outcome]) -> None:
    """Replace the outcomes of the cases that were judged now; keep those of the others."""
    new: dict[str, list[Outcome]] = {}
    for outcome in outcomes:
        new.setdefault(outcome.id, []).append(outcome)
    kept = read() | new
    rows = [outcome.as_json() for id in sorted(kept) for outcome in kept[id]]
    text = json.dumps({"format": _FORMAT, "cases": rows}, indent=1, allow_nan=False)
    storage.write_aside(storage.results_path(), text.encode())
