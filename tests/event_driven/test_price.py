"""Located impacts are compiled where that costs less: the time that people are told it takes."""

from typing import Any

import pytest

from tamias2d.event_driven import follower
from tamias2d.kernels import Library
from tamias2d.kernels.progress import _Shown


def test_what_compiling_costs_is_what_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    told = _Shown("located impacts", follower.LIBRARY.source(), None).seconds
    monkeypatch.setattr(Library, "is_loaded", lambda _: False)
    monkeypatch.setattr(Library, "is_kept", lambda _: False)
    for share, worth in ((0.99, False), (1.01, True)):
        one: Any = follower.EventDriven.__new__(follower.EventDriven)
        one._started, one._price = 0.0, 0.0
        monkeypatch.setattr(follower, "perf_counter", lambda: 1.0)
        assert one._is_worth(1.0, 1.0 + share * told) == worth
