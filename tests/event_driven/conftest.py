"""Ways through the impacts of discs."""

from collections.abc import Callable
from typing import TypeAlias

import pytest

import tamias2d as t2
from tamias2d.errors import SimulationError
from tamias2d.event_driven import follower
from tamias2d.event_driven.follow import follow
from tamias2d.run import Run
from tamias2d.solve import solve

Solving: TypeAlias = Callable[..., tuple[Run, str]]


@pytest.fixture
def solving(monkeypatch: pytest.MonkeyPatch) -> Solving:
    """Return a function that solves a scene in a way, up to its end or to the error it returns.

    The ways: "general", without compiled code; "compiled", with it from the start; "plain", with
    the same code, not compiled; "alternating", with it now and then.
    """

    def solved(scene: t2.Scene, way: str, duration: float, **given: object) -> tuple[Run, str]:
        asked = iter(range(10**9))

        def pays(self: follower.EventDriven, time: float, until: float) -> bool:  # noqa: ARG001
            self.code = self.code or (follow if way == "plain" else follower.compiled_code())
            return way != "general" and (way != "alternating" or next(asked) % 7 == 6)

        monkeypatch.setattr(follower.EventDriven, "pays", pays)
        limit = {"method": t2.ClosedForm(), "work_limit": 10**7}
        try:
            return solve(scene, duration=duration, **(limit | given)), ""  # type: ignore[arg-type]
        except SimulationError as refusal:
            assert isinstance(refusal.run, Run)
            return refusal.run, str(refusal)

    return solved
