"""The form of what the measurement of contacts finds; no time is looked at."""

import json
from pathlib import Path

import pytest

from tools.measure import table
from tools.measurements import contacts
from tools.measurements.arena.race import Times

KEYS = {"ratio_to_pymunk", "ratio_to_pyb2d3", "sag", "penetration", "speed_at_end"}


@pytest.fixture(scope="module")
def measured(tmp_path_factory):
    folder = tmp_path_factory.mktemp("docs")
    return contacts.measure(["two-discs", "disc-pile"], repeats=1, store=folder), folder


def test_every_scene_has_the_five_numbers(measured):
    found, _ = measured
    again = json.loads(json.dumps(found, allow_nan=False))
    assert list(again["scenes"]) == ["two-discs", "disc-pile"]
    for scene in again["scenes"].values():
        assert set(scene) == KEYS
        assert scene["ratio_to_pymunk"] > 0
        assert scene["ratio_to_pyb2d3"] > 0
    assert again["scenes"]["disc-pile"]["sag"] is None  # it has no place where it belongs
    assert abs(again["scenes"]["two-discs"]["sag"]) < 1e-3


def test_the_table_has_every_engine_on_every_scene(measured):
    found, folder = measured
    heads, rows = table(contacts, found)
    assert [row[1] for row in rows] == ["Tamias2D", "Pymunk", "pyb2d3"] * 2
    assert {len(row) for row in rows} == {len(heads)}
    page = (folder / "contacts.txt").read_text()
    assert all(cell in page for row in rows for cell in row)
    assert json.loads((folder / "contacts.json").read_text()) == found
    assert (folder / "contacts.png").stat().st_size > 10_000


def test_a_body_that_went_through_another_has_no_depth_in_it():
    row = {"seconds": 1e-3, "sag": 0.1, "penetration": 230.0, "speed_at_end": 67.0}
    engines = {"Tamias2D": row | {"relative_penetration": 2.3e5}}
    heads, (cells,) = table(
        contacts, {"engines": {"cards": engines}, "scenes": {"cards": {}}, "peers": {}}
    )
    told = dict(zip(heads, cells, strict=True))
    assert (told["overlap, m"], told["of radius"]) == ("through", "through")


def test_the_table_of_the_docs_is_that_of_its_numbers():
    folder = Path(__file__).parents[2] / "docs/measured"
    _, rows = table(contacts, json.loads((folder / "contacts.json").read_text()))
    page = (folder / "contacts.txt").read_text()
    assert all(f"| {' | '.join(cells)} |" in page for cells in rows)


def test_a_burst_in_one_turn_of_one_repetition_does_not_count():
    quiet = [[1.0, 2.0], [1.0, 2.0], [1.0, 2.0]]
    burst = [[2.0, 4.0], [99.0, 4.0], [2.0, 99.0]]
    times = Times({"one": quiet, "other": burst}, steps=20)
    assert times.of_a_step("one") == pytest.approx(0.15)
    assert times.ratio("other", "one") == pytest.approx(2.0)


def test_what_is_stopped_tells_what_it_has(monkeypatch, capsys):
    def stop(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(contacts, "_scene", stop)
    found = contacts.measure(["two-discs"], repeats=1)
    assert found["scenes"] == {}
    assert "Stopped" in capsys.readouterr().err
    assert table(contacts, found)[1] == []
    assert contacts.notes(found) == []
