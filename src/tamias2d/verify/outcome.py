"""The outcome of a comparison: one quantity of one case, its error and the verdict."""

import math
from dataclasses import asdict, dataclass
from typing import Any

PASS = "pass"
FAIL = "fail"
MANUAL = "manual"
"""A person has to judge, and nobody has."""
NOT_RUN = "not run"
"""A case has no result: nobody ran it, or an extra that it needs is not installed."""


@dataclass(frozen=True)
class Outcome:
    """One row of a verification report."""

    id: str
    """Of the case."""
    quantity: str
    """What was compared."""
    error: float
    """Infinite where nothing could be compared."""
    tolerance: float
    verdict: str
    hash: str = ""
    """Of all that the verdict rests on (`fingerprint`), when it was judged."""
    note: str = ""
    """Why it failed or was not run, where there is more to say than the error."""

    def as_json(self) -> dict[str, Any]:
        """Return the fields as JSON holds them: an error that is not finite is null."""
        return asdict(self) | {"error": self.error if math.isfinite(self.error) else None}


def read_outcome(row: dict[str, Any]) -> Outcome:
    """Return the outcome that `as_json` wrote."""
    return Outcome(**row | {"error": math.inf if row["error"] is None else row["error"]})
