"""Every measurement runs to its end, small; no time and no figure is looked at."""

import contextlib
import json
import signal
import subprocess
import sys
import time
from argparse import ArgumentParser
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from tamias2d.motion import ClosedForm, RungeKutta4
from tamias2d.scene import catalogue
from tamias2d.study import candidates, work_precision
from tamias2d.study.report import as_json, contacts_as_json
from tamias2d.study.stored import study_from_json
from tools.measure import table
from tools.measurements import (
    asked,
    calls,
    certificates,
    control,
    crowds,
    drift,
    energies,
    fronts,
    held_out,
    impacts,
    jointed,
    kinds,
    located_drops,
    peers,
    specialisation,
)
from tools.measurements.progress import each, until_stopped


def lines_of(module: Any) -> tuple[dict[str, Any], list[tuple[str, ...]]]:
    """What is found, as JSON and as a table."""
    found = module.measure()
    assert json.loads(json.dumps(found)) == found
    heads, rows = table(module, found)
    assert {len(row) for row in rows} == {len(heads)}
    return found, rows


def test_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(catalogue, "names", lambda: ["projectiles", "tc1"])
    monkeypatch.setattr(
        asked, "measure", partial(asked.measure, questions=["quality", "tolerance"])
    )
    found, rows = lines_of(asked)
    outcomes = {"quality: met": 1, "quality: refused": 1, "tolerance: met": 2}
    assert found["outcomes"] == outcomes
    assert len(rows) == 2
    (note,) = asked.notes(found)
    assert "nothing in the scene can touch" in note


def test_calls(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(calls, "measure", partial(calls.measure, boxes=[10], repeats=1))
    found, rows = lines_of(calls)
    assert len(rows) == 20
    assert sum(row["pymunk"] is None for row in found["rows"]) == 7
    assert calls.notes(found)


def test_control(monkeypatch: pytest.MonkeyPatch) -> None:
    small = partial(control.measure, worlds=[4], steps=2, turns=1)
    monkeypatch.setattr(control, "measure", small)
    found, rows = lines_of(control)
    assert [row[0] for row in rows] == ["cart and pole", "boxes"]
    assert control.notes(found)


def test_asked_tells_what_takes_long_or_breaks(monkeypatch: pytest.MonkeyPatch) -> None:
    def endless(*_: Any) -> str:
        while True:
            pass

    def broken(*_: Any) -> str:
        raise IndexError("beyond")

    monkeypatch.setattr(asked, "_QUESTIONS", {"endless": endless, "broken": broken})
    found = asked.measure(scenes=["tc1"], limit=1)
    outcomes = {row["asked"]: row["outcome"] for row in found["rows"]}
    assert outcomes == {"endless": "late", "broken": "traceback"}
    assert "IndexError: beyond" in asked.notes(found)[0]


def test_located_drops(tmp_path: Path) -> None:
    store = tmp_path / "drops.jsonl"
    found = located_drops.measure(count=2, first=9000000, store=store)
    assert [row["outcome"] for row in found["rows"]] == ["located", "located"]
    assert located_drops.measure(count=2, first=9000000, store=store) == found
    heads, rows = located_drops.table(found)
    assert {len(row) for row in rows} == {len(heads)}
    assert located_drops.notes(found) == []


def test_a_measurement_that_is_ended_tells_what_it_has_found(tmp_path: Path) -> None:
    store = tmp_path / "drops.jsonl"
    command = [sys.executable, "-m", "tools.measure", "located_drops", "--json"]
    running = subprocess.Popen(
        [*command, "--first", "9000000", "--store", f"{store}"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    while running.poll() is None and not (store.exists() and store.read_text().endswith("\n")):
        time.sleep(0.05)
    running.terminate()
    found, told = running.communicate()
    assert running.returncode == 0, told
    assert json.loads(found)["rows"] == [json.loads(line) for line in store.open()]
    assert "Stopped" in told


def test_a_measurement_ends_though_the_interruption_is_lost() -> None:
    """As Python loses it while a process forks."""
    done = []
    with until_stopped():
        for item in each(range(3)):
            done.append(item)
            with contextlib.suppress(KeyboardInterrupt):
                signal.raise_signal(signal.SIGTERM)
    assert done == [0]
    assert list(each(range(3))) == [0, 1, 2]


def test_energies(tmp_path: Path) -> None:
    kept = tmp_path / "energies.jsonl"
    found = energies.measure(count=2, steps=20, kept=kept)
    assert all(row["above"] < 1e-9 for row in found["rows"])
    assert energies.measure(count=2, steps=20, kept=kept) == found
    limited = energies.measure(count=2, steps=20, more="limits", kept=kept)
    assert limited != found
    assert energies.measure(count=2, steps=20, more="limits", kept=kept) == limited
    assert energies.measure(count=2, steps=20, more="equations")["rows"]
    heads, rows = table(energies, found)
    assert {len(row) for row in rows} == {len(heads)}
    assert len(energies.notes(found)) == 2


def of_certificates(**asked: Any) -> dict[str, Any]:
    """What is found as JSON; a table and notes can be made of it."""
    found = certificates.measure(**asked)
    assert json.loads(json.dumps(found)) == found
    heads, rows = table(certificates, found)
    assert {len(row) for row in rows} == {len(heads)}
    assert len(certificates.notes(found)) >= 2
    return found


def test_certificates(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(catalogue, "names", lambda _=None: ["driven", "cradle-touching"])
    scenes = ["driven", "cradle-touching", "throw 0", "platform 0"]
    found = of_certificates(scenes=scenes, tolerances=[1e-2])
    assert {row["scene"] for row in found["stepped_rows"]} == {"cradle-touching", "platform 0"}
    for row in found["stepped_rows"]:
        assert row["covered"] is not False
    assert any(row["covered"] for row in found["stepped_rows"])
    assert "Stepped, held out" in certificates.notes(found)[-1]
    assert [row["scene"] for row in found["rows"]] == ["driven", "cradle-touching", "throw 0"]
    assert {row["tolerance"] for row in found["rows"]} == {1e-2}
    assert found["left_out"] == []


def test_certificates_of_scenes_that_are_asked_for() -> None:
    parser = ArgumentParser()
    certificates.options(parser)
    given = parser.parse_args(["--scenes", "tc1", "throw 0", "--tolerances", "1e-2", "1e-4"])
    found = of_certificates(**vars(given))
    pairs = [(row["scene"], row["tolerance"]) for row in found["rows"]]
    assert pairs == [(name, each) for name in ("tc1", "throw 0") for each in (1e-2, 1e-4)]
    assert found["stepped_rows"] == []
    with pytest.raises(SystemExit):
        parser.parse_args(["--scenes", "of nobody"])


def test_certificates_that_are_stopped_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    """Also those of the scene in which it was stopped; nothing is said of what was not asked."""
    one = certificates._pair

    def stopped(name: str, scene: Any, tolerance: float, *others: Any) -> Any:
        if (name, tolerance) == ("tc2", 1e-4):
            raise KeyboardInterrupt
        return one(name, scene, tolerance, *others)

    monkeypatch.setattr(certificates, "_pair", stopped)
    found = of_certificates(scenes=["tc1", "tc2", "tc3", "throw 0"], tolerances=[1e-2, 1e-4])
    pairs = [(row["scene"], row["tolerance"]) for row in found["rows"]]
    assert pairs == [("tc1", 1e-2), ("tc1", 1e-4), ("tc2", 1e-2)]
    assert found["held_out"]["coverage"] is None
    assert found["left_out"] == []


def test_crowds() -> None:
    found = crowds.measure(bodies=9, steps=3, by_way=True)
    assert json.loads(json.dumps(found)) == found
    heads, rows = table(crowds, found)
    assert {len(row) for row in rows} == {len(heads)}
    assert len(rows) == 3 * len(crowds.CROWDS)
    assert crowds.notes(found)


def test_drift(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(drift, "_STEPS", 20_000)
    monkeypatch.setattr(drift, "ORBITERS", (RungeKutta4(),))
    _, rows = lines_of(drift)
    assert len(rows) == 3


def test_fronts(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """What is stored can be drawn: the same study comes back."""
    monkeypatch.setattr(work_precision, "_RUNGS", 1)
    monkeypatch.setattr(candidates, "TOLERANCES", (1e-4,))
    small = {"scenes": ["projectiles", "incline"], "rates": (30,), "store": tmp_path}
    monkeypatch.setattr(fronts, "measure", partial(fronts.measure, **small))
    found, rows = lines_of(fronts)
    assert [row[2] for row in rows] == ["located", "stepped"]
    for name, study in found.items():
        stored = json.loads((tmp_path / f"{name}.json").read_text())
        assert stored == study
        back: Any = study_from_json(stored)
        report = contacts_as_json if "contacts" in study else as_json
        assert report(back, tolerance=study["tolerance"]) == study


def test_impacts(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(impacts, "_PILOT", 0.005)
    small = {"counts": [30, 110], "polygons": [10], "impacts": 100, "steps": 3}
    monkeypatch.setattr(impacts, "measure", partial(impacts.measure, **small))
    found, _ = lines_of(impacts)
    assert [row["bodies"] for row in found["rows"]] == [30, 110, 10]


def test_kinds(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(kinds, "_EACH", 1)
    monkeypatch.setattr(kinds, "_TIGHT", (RungeKutta4(),))
    monkeypatch.setattr(catalogue, "names", lambda *_: ["tc1"])
    monkeypatch.setattr(held_out, "scenes", lambda: iter(()))
    lines_of(kinds)


def test_peers(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(peers, "_RATES", (60,))
    monkeypatch.setattr(peers, "_OWN", {ClosedForm.__name__: ("",)})
    small = [one for one in peers._scenes() if one[0] in ("free fall", "projectile")]
    monkeypatch.setattr(peers, "_scenes", lambda: small)
    _, rows = lines_of(peers)
    assert len(rows) == 2


def test_specialisation(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(specialisation, "BODIES", (10,))
    monkeypatch.setattr(specialisation, "_WORK", 100)
    monkeypatch.setattr(specialisation, "_REPEATS", 1)
    _, rows = lines_of(specialisation)
    assert len(rows) == len(specialisation.DEMANDS)


def test_jointed() -> None:
    found = jointed.measure(seconds=1, side=3, ragdolls=1, heap=1, random=2, limited=2)
    assert len(found["rows"]) == 4 * 8  # ours twice, Box2D, Pymunk
    heads, rows = table(jointed, found)
    assert {len(row) for row in rows} == {len(heads)}
    assert jointed.notes(found)
    assert all(row["last"] < 1e-3 for row in found["rows"] if row["program"] == "Tamias2D")
