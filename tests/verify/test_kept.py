"""What is kept of a run in steps has its bits; what loses some is found (R16)."""

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tamias2d import replay
from tamias2d.simulator import Simulator
from tamias2d.verify import kept
from tamias2d.verify.case import Case
from tamias2d.verify.items import items
from tests.verify.conftest import Judged

CASE = "OG24"
HOME = os.environ.get("TAMIAS2D_HOME")  # where compiled steps are; nothing is written to it here


def begun_again(_path: Path) -> Simulator:
    """A simulator that forgot what it did."""
    return Simulator(Case(items()[CASE]).scene, time_step=0.015625)


FAULTS: list[tuple[Any, str, Callable[..., Any], str]] = [
    (kept, "_changed", lambda data: data, "a recording that is changed is refused"),
    (Simulator, "restore", begun_again, "bits of a simulator that was restored"),
    (replay, "check", lambda _path: replay.Check(False, "", None), "bits of a replay"),
]


@pytest.fixture(autouse=True)
def compiled_steps(own_results: None, monkeypatch: pytest.MonkeyPatch) -> None:  # noqa: ARG001
    """Take the steps that are compiled, where there are some."""
    if HOME:
        monkeypatch.setenv("TAMIAS2D_HOME", HOME)
    else:
        monkeypatch.delenv("TAMIAS2D_HOME")


@pytest.mark.parametrize(("owner", "name", "wrong", "what"), FAULTS, ids=[f[1] for f in FAULTS])
def test_a_loss_is_found(
    owner: Any,
    name: str,
    wrong: Callable[..., Any],
    what: str,
    judged: Judged,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(owner, name, wrong)
    verdicts = {outcome.quantity: outcome.verdict for outcome in judged(CASE, "stepped")}
    assert verdicts.pop(what) == "fail"
    assert set(verdicts.values()) == {"pass"}
