"""The errors of a run against the exact answers that the specification knows for its scene."""

import math
from dataclasses import dataclass
from typing import Any

from tamias2d.run import Run
from tamias2d.verify.exact import answers
from tamias2d.verify.formula import distance, measure
from tamias2d.verify.items import Item, items


@dataclass(frozen=True)
class KnownError:
    """The error of one quantity: relative, or absolute where the exact answer is 0."""

    case: str
    quantity: str
    error: float

    def as_json(self) -> dict[str, Any]:
        """The fields as JSON holds them: an error that is not finite is null."""
        return vars(self) | {"error": self.error if math.isfinite(self.error) else None}


def known_errors(run: Run, name: str) -> list[KnownError]:
    """Compare a run of the catalogue's scene `name` with each case about that scene.

    A case that knows the whole history is compared where the run stays within the case's time,
    one that knows the end if the run ends there.
    """
    found = []
    for item in items().values():
        if item["kind"] == "case" and item["data"].get("scene") == name:
            found += _compare(run, item)
    return found


def _compare(run: Run, item: Item) -> list[KnownError]:
    data = item["data"]
    if "duration" not in data:
        return []
    span = float(measure(data["duration"], "duration"))
    asked = []
    if "exact" in data and run.duration <= span:
        asked.append((data["exact"]["bodies"], slice(None), "over the whole history"))
    if "final" in data and run.duration == span:
        asked.append((data["final"]["bodies"], slice(-1, None), "at the end"))
    return [
        KnownError(item["id"], f"{one.label} {when}", distance(one.found, one.exact))
        for bodies, samples, when in asked
        for one in answers(run, bodies, samples)
    ]
