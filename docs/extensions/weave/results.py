"""The last results of the verification cases, if there are any on this machine.

Serves: the pages of cases. Hides: the form of the results file.
"""

import json
from collections import defaultdict
from dataclasses import dataclass

from tamias2d.spec.specification import Specification
from tamias2d.storage import results_path


@dataclass(frozen=True)
class Result:
    """One comparison of a case."""

    quantity: str
    error: float
    tolerance: float
    verdict: str


def last_results(spec: Specification) -> dict[str, list[Result]]:
    """Results by case; those of an older form of the specification are marked stale."""
    path = results_path()
    if not path.is_file():
        return {}
    found: dict[str, list[Result]] = defaultdict(list)
    for row in json.loads(path.read_text("utf-8"))["cases"]:
        item = spec.items.get(row["id"])
        if item is not None:
            fresh = spec.hash(item) == row["hash"]
            verdict = row["verdict"] if fresh else "stale"
            found[item.id].append(Result(row["quantity"], row["error"], row["tolerance"], verdict))
    return found
