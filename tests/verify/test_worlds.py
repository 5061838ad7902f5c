"""Many worlds are judged: means that are off, and worlds that are not those of their scenes."""

from typing import Any

import pytest

import tamias2d as t2
from tamias2d.verify import FAIL, PASS, worlds
from tests.verify.conftest import Judged


def test_worlds_with_other_bits_than_alone_fail(
    judged: Judged, monkeypatch: pytest.MonkeyPatch
) -> None:
    def later(scene: t2.Scene, **given: Any) -> t2.Run:
        return t2.simulate(scene, **{**given, "time_step": given["time_step"] / 2})

    monkeypatch.setattr(worlds, "simulate", later)
    *means, bits = judged("OJ24", "worlds")
    assert [outcome.verdict for outcome in means] == [PASS, PASS]
    assert bits.verdict == FAIL
    assert bits.note == "8 worlds have other bits"
