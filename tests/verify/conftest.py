"""What the tests of verification share."""

from collections.abc import Callable
from copy import deepcopy
from pathlib import Path
from typing import Any

import pytest

from tamias2d.verify.case import Case
from tamias2d.verify.items import items
from tamias2d.verify.outcome import Outcome
from tamias2d.verify.suite import COMPARISONS

Judged = Callable[..., list[Outcome]]


@pytest.fixture(autouse=True)
def own_results(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """No test reads or writes the results of the user."""
    monkeypatch.setenv("TAMIAS2D_HOME", str(tmp_path))


@pytest.fixture
def judged() -> Judged:
    """One comparison of a case, whose data a test may change first."""

    def judged(label: str, comparison: str, change: Callable[[Any], object] = id) -> list[Outcome]:
        item = deepcopy(dict(items()[label]))
        change(item["data"])
        given = item["data"][comparison]
        return list(COMPARISONS[comparison](Case(item), given))

    return judged
