"""Studies of stepped contacts: what is compared, how it is judged, drawn and written."""

import json
import math
from dataclasses import replace
from pathlib import Path

import jsonschema
import numpy as np
import pytest
from typer.testing import CliRunner

from tamias2d import cli
from tamias2d.commands import tradeoff as command
from tamias2d.scene import Box, Compound, Disc, HalfPlane, Part, Scene
from tamias2d.state import History
from tamias2d.study import contact_candidates, contact_study as module
from tamias2d.study.contact_errors import (
    Answer,
    ContactErrors,
    Followed,
    contact_errors,
    hanging,
    statistics,
)
from tamias2d.study.contact_study import ContactPoint, ContactStudy, contact_study
from tamias2d.study.engines.refusal import PeerError
from tamias2d.study.plot import plot
from tamias2d.study.refined import refined
from tamias2d.study.report import contacts_as_json, schema

TIMES = np.linspace(0.0, 0.4, 25)


def brick() -> Scene:
    """Two boxes as one body, which slides on a floor."""
    scene = Scene(gravity=(0.0, -9.81), name="brick", duration=0.4)
    floor = HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, friction=0.5, restitution=0.0, name="floor")
    half = Box(width=0.5, height=0.5)
    both = Compound(parts=[Part(shape=half, position=(x, 0.0)) for x in (-0.25, 0.25)])
    scene.add_body(
        both, mass=1.0, position=(0.0, 0.25), velocity=(2.0, 0.0), friction=0.5, restitution=0.0,
        name="brick",
    )  # fmt: skip
    return scene


@pytest.fixture(scope="module")
def studied() -> ContactStudy:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(module, "_WORK", 1e6)
        patch.setattr(module, "_HEARD", 200)
        return contact_study(
            brick(),
            duration=0.4,
            reason="two parts",
            phases_asked=2,
            rates=(30, 480),
            timed=False,
        )


def test_shorter_steps_are_nearer_for_every_engine(studied: ContactStudy) -> None:
    for method in ("Stepped", "Pymunk", "pyb2d3"):
        points = [p for p in studied.points if p.method == method and p.error is not None]
        errors = {p.steps: p.error.position for p in points if p.error}
        assert errors[max(errors)] < errors[min(errors)], method


def timed(studied: ContactStudy) -> ContactStudy:
    """Each pass takes 0.1 ms."""
    points = []
    for point in studied.points:
        seconds = 1e-4 * point.sweeps
        taken = module.Seconds(seconds, seconds, 1) if point.error else None
        points.append(replace(point, seconds=taken))
    return replace(studied, points=tuple(points))


def test_what_was_not_timed_is_on_no_front_of_seconds(studied: ContactStudy) -> None:
    assert studied.fastest == studied.soundest == []
    assert timed(studied).fastest == studied.leanest


def test_fronts_are_of_this_library_and_fall(studied: ContactStudy) -> None:
    for places in (studied.leanest, timed(studied).soundest):
        assert places
        assert not any(studied.points[k].peer for k in places)
    errors = [studied.points[k].error for k in studied.leanest]
    sizes = [max(e.size, studied.floor) for e in errors if e is not None]
    assert sizes == sorted(sizes, reverse=True)


def test_the_located_way_is_a_point_with_its_reason(studied: ContactStudy) -> None:
    assert studied.points[0].method == "Located"
    assert studied.points[0].failure == "two parts"


def test_a_slide_is_known_to_its_end(studied: ContactStudy) -> None:
    assert studied.horizon == pytest.approx(0.4)
    assert studied.floor < 1e-3
    assert studied.phases == 2
    assert set(studied.statistics) == {"height", "extent", "kinetic"}


def test_the_answer_is_that_of_the_shortest_steps(monkeypatch: pytest.MonkeyPatch) -> None:
    """Longer ones, which agree for longer, are contradicted by them."""
    agree = refined(brick(), duration=0.4, times=TIMES, time_step=1 / 60, grid=1 / 60)
    agree = replace(agree, doubt=np.full(len(TIMES), 1e-9))
    part = replace(agree, time_step=agree.time_step / 2, doubt=np.linspace(0.0, 1.0, len(TIMES)))
    monkeypatch.setattr(module, "refinements", lambda *_, **__: iter((agree, part)))
    monkeypatch.setattr(module, "_HEARD", 100)
    found = contact_study(
        brick(), duration=0.4, reason="two parts", phases_asked=1, rates=(30,), timed=False
    )
    assert found.horizon == pytest.approx(TIMES[1])
    assert found.truth == f"steps of {part.time_step:.2g} s"


def test_a_report_keeps_its_schema(studied: ContactStudy) -> None:
    report = contacts_as_json(studied, tolerance=1e-2)
    jsonschema.validate(report, schema("contact_tradeoff"))
    assert json.loads(json.dumps(report, allow_nan=False)) == report


def test_a_study_is_drawn(studied: ContactStudy, tmp_path: Path) -> None:
    path = tmp_path / "study.svg"
    plot(timed(studied), path, tolerance=1e-2)
    text = path.read_text()
    assert "<!-- cost: seconds" in text
    for words in ("Stepped x 4", "Pymunk x 10", "pyb2d3 x 16", "brick, 0.4 s"):
        assert f"<!-- {words}" in text


def test_a_study_that_was_stopped_before_its_timing_is_drawn(
    studied: ContactStudy, tmp_path: Path
) -> None:
    """By how often contacts are gone through; there may be failures only, too."""
    path = tmp_path / "study.svg"
    plot(replace(studied, complete=False), path, tolerance=1e-2)
    assert "<!-- cost: passes through the contacts" in path.read_text()
    plot(replace(studied, points=studied.points[:1]), path, tolerance=1e-2)
    assert "<!-- brick, 0.4 s" in path.read_text()


def test_a_study_without_any_error_is_drawn(studied: ContactStudy, tmp_path: Path) -> None:
    """As of bodies that nothing pushes into each other: an axis of powers of ten has no zero."""
    none = ContactErrors(
        position=0.0, centre=0.0, event_time=None, missed=None, extra=None, overlap=0.0,
        energy=None, momentum=None, hang=0.0, rest=None,
    )  # fmt: skip
    points = tuple(replace(p, error=none, worst=none) for p in timed(studied).points)
    path = tmp_path / "study.svg"
    plot(replace(studied, points=points, floor=0.0), path, tolerance=None)
    assert "<!-- brick, 0.4 s" in path.read_text()


def test_the_command_prints_tables(studied: ContactStudy, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(command, "contact_study", lambda scene, **asked: studied)  # noqa: ARG005
    monkeypatch.setattr(command, "stepped_because", lambda *_: "two parts")
    result = CliRunner().invoke(cli.app, ["tradeoff", "tc3", "--tolerance", "1e-2"])
    assert result.exit_code == 0, result.stderr
    for words in ("Contacts are stepped: two parts", "overlap", "95 % intervals", "within 0.01"):
        assert words in result.stdout
    result = CliRunner().invoke(cli.app, ["tradeoff", "tc3", "--json"])
    jsonschema.validate(json.loads(result.stdout), schema("contact_tradeoff"))


def test_an_engine_that_is_not_there_is_a_point_with_a_reason(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def absent(*_: object, **__: object) -> None:
        raise PeerError("Pymunk: is not installed. Leave it out.")

    engines = tuple(
        (name, absent if name == "Pymunk" else make, *rest)
        for name, make, *rest in contact_candidates._ENGINES
    )
    monkeypatch.setattr(contact_candidates, "_ENGINES", engines)
    monkeypatch.setattr(module, "_WORK", 1e5)
    monkeypatch.setattr(module, "_HEARD", 100)
    found = contact_study(
        brick(), duration=0.2, reason="two parts", phases_asked=1, rates=(30,), timed=False
    )
    failed = {p.method for p in found.points if p.failure}
    assert failed == {"Located", "Pymunk"}


def test_a_stopped_study_keeps_what_it_has(monkeypatch: pytest.MonkeyPatch) -> None:
    def stop(of: int, done: int, what: str) -> None:  # noqa: ARG001
        if done == 2:
            raise KeyboardInterrupt

    monkeypatch.setattr(module, "_WORK", 1e5)
    monkeypatch.setattr(module, "_HEARD", 100)
    found = contact_study(
        brick(), duration=0.2, reason="two parts", phases_asked=1, rates=(30,), told=stop
    )
    assert not found.complete
    assert len(found.points) == 3


def two_discs() -> Scene:
    scene = Scene(gravity=(0.0, 0.0), name="two")
    for x, speed in ((0.0, 1.0), (3.0, -1.0)):
        scene.add_body(
            Disc(radius=0.5), mass=1.0, position=(x, 0.0), velocity=(speed, 0.0), restitution=1.0
        )
    return scene


def history(times: list[float], places: list[list[float]], speeds: list[list[float]]) -> History:
    zeros = np.zeros((len(times), 2))
    flat = [np.stack((np.array(rows), zeros), axis=-1) for rows in (places, speeds)]
    return History(flat[0], zeros, flat[1], zeros)


def judged(found: History, true: History, met: dict[tuple[int, int], float]) -> ContactErrors:
    times = np.array([0.0, 0.5])
    answer = Answer(true, times, 0.5, 0.5, {(0, 1): 0.4})
    return contact_errors(two_discs(), Followed(found, 0.0, met, 0.0), answer)


def test_errors_by_hand() -> None:
    """Disc 1 is 0.1 m late and 20 % too slow: of 1 J a share is lost, of 2 kg m/s a tenth."""
    true = history([0.0, 0.5], [[0.0, 3.0], [0.5, 2.5]], [[1.0, -1.0], [1.0, -1.0]])
    late = history([0.0, 0.5], [[0.0, 3.0], [0.5, 2.6]], [[1.0, -1.0], [1.0, -0.8]])
    found = judged(late, true, {(0, 1): 0.45})
    assert found.position == pytest.approx(0.1 / 0.5)
    assert found.centre == pytest.approx(0.05 / 0.5)
    assert found.event_time == pytest.approx(0.05 / 0.5)
    assert (found.missed, found.extra) == (0, 0)
    assert found.momentum == pytest.approx(0.2 / 2.0)
    assert found.energy == pytest.approx(0.5 * (1 - 0.8**2) / 1.0)  # nothing may take any
    assert judged(true, true, {}).missed == 1
    assert judged(true, true, {(0, 1): 0.4}).size == 0.0


def test_energy_may_fall_where_impacts_take_it() -> None:
    scene = two_discs()
    soft = Scene(gravity=(0.0, 0.0), name="soft")
    for body in scene.bodies:
        soft.add_body(
            body.shape, mass=1.0, position=body.position, velocity=body.velocity, restitution=0.5
        )
    slow = history([0.0, 0.5], [[0.0, 3.0], [0.5, 2.6]], [[1.0, -1.0], [0.5, -0.5]])
    answer = Answer(slow, np.array([0.0, 0.5]), 0.5, 0.5, {})
    assert contact_errors(soft, Followed(slow, 0.0, {}, 0.0), answer).energy == 0.0


def test_what_stays_where_it_is_though_it_is_fast_hangs() -> None:
    scene = two_discs()
    before = np.array([[0.0, 0, 0, 1.0, 0, 0], [3.0, 0, 0, -1.0, 0, 0]])
    after = before.copy()
    after[0, 0] = 0.1  # as its velocity says, in 0.1 s
    assert hanging(scene, before, after, 0.1) == (1, 2)


def test_means_have_an_interval_that_holds_the_spread() -> None:
    true = history([0.0, 0.5], [[0.0, 3.0], [0.5, 2.5]], [[1.0, -1.0], [1.0, -1.0]])
    wide = history([0.0, 0.5], [[0.0, 3.0], [0.3, 2.7]], [[1.0, -1.0], [1.0, -1.0]])
    mean, half = statistics(two_discs(), [true, wide])["extent"]
    assert mean == pytest.approx(2.2)
    assert half == pytest.approx(12.706 * 0.2, rel=1e-3)  # t of one degree of freedom
    assert math.isinf(statistics(two_discs(), [true])["extent"][1])


def test_a_point_without_an_error_is_not_valid() -> None:
    bare = ContactPoint(method="m", setting="", peer=False, steps=3, passes=4)
    assert not bare.valid
    assert bare.sweeps == 12
