"""What stands in an `.rrd`: few entities for many bodies, each where the run says; own names."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tamias2d as t2

pytest.importorskip("rerun")

from rerun.chunk import RrdReader

from tamias2d.record import drawing, header as headers
from tamias2d.record.rerun import bodies, exact, impacts, layout

from .conftest import with_impacts


def crowd(count: int, name: str = "crowd") -> t2.Run:
    scene = t2.Scene(gravity=(0.0, -9.81), name=name)
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=-9.0), name="floor", mask=0)
    shapes = (
        t2.Disc(radius=0.3),
        t2.Box(width=0.5, height=0.3),
        t2.Capsule(length=0.4, radius=0.1),
        t2.Polygon(vertices=[(0.0, 0.0), (0.5, 0.0), (0.0, 0.5)]),
        None,
    )
    for k in range(count):
        turning = {"angular_velocity": 1.0 + k} if shapes[k % 5] else {}
        place = (float(k % 20), float(k // 20))
        scene.add_body(shapes[k % 5], mass=1.0, position=place, mask=0, restitution=0.0, **turning)
    return t2.simulate(scene, duration=0.5, times=np.linspace(0.0, 0.5, 11))


def columns(path: Path) -> dict[tuple[str, str], list[Any]]:
    """All columns of a recording with their values, by entity and component."""
    found: dict[tuple[str, str], list[Any]] = {}
    for chunk in RrdReader(path).stream():
        batch = chunk.to_record_batch()
        for name in batch.schema.names:
            found.setdefault((chunk.entity_path, name), []).extend(batch.column(name).to_pylist())
    return found


def test_a_crowd_has_as_many_entities_as_a_few(tmp_path: Path) -> None:
    counts = []
    for count in (bodies.CROWD + 10, bodies.CROWD + 100):
        crowd(count).save(tmp_path / "run.rrd")
        counts.append(len({entity for entity, _ in columns(tmp_path / "run.rrd")}))
    assert counts[0] == counts[1] < 30


@pytest.mark.parametrize("count", [5, bodies.CROWD + 5])
@pytest.mark.parametrize("block", [1, 2**25])
def test_lines_are_drawn_where_the_bodies_are(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, count: int, block: int
) -> None:
    """Of each box: its corners, turned and moved by complex numbers."""
    monkeypatch.setattr(exact, "BLOCK", block)
    run = crowd(count)
    run.save(tmp_path / "run.rrd")
    found = columns(tmp_path / "run.rrd")
    name = f"{layout.BODIES}/moving/lines5"
    strips = np.array(found[name, "LineStrips2D:strips"])
    boxes = [k for k, body in enumerate(run.scene.bodies) if isinstance(body.shape, t2.Box)]
    assert strips.shape == (11, len(boxes), 5, 2)
    corners = np.array([-0.25 - 0.15j, 0.25 - 0.15j, 0.25 + 0.15j, -0.25 + 0.15j])
    for row, k in enumerate(boxes):
        turn = np.exp(1j * run.orientation[:, k])[:, None]
        wanted = corners * turn + (run.position[:, k] @ [1, 1j])[:, None]
        drawn = strips[:, row] @ [1, 1j]
        assert np.abs(drawn[:, :, None] - wanted[:, None, :]).min(axis=2).max() < 1e-5
        assert np.abs(drawn[:, :, None] - wanted[:, None, :]).min(axis=1).max() < 1e-5


def test_discs_of_a_crowd_are_points(tmp_path: Path) -> None:
    run = crowd(bodies.CROWD + 5)
    run.save(tmp_path / "run.rrd")
    found = columns(tmp_path / "run.rrd")
    points = np.array(found[f"{layout.BODIES}/moving/rims1", "Points2D:positions"])
    (radii,) = found[f"{layout.BODIES}/moving/rims1", "Points2D:radii"]
    discs = [k for k, body in enumerate(run.scene.bodies) if isinstance(body.shape, t2.Disc)]
    drawn = points[:, np.array(radii) > 0.2]  # those of capsules are smaller
    assert drawn == pytest.approx(run.position[:, discs], abs=1e-5)


def identity(path: Path) -> tuple[str, str]:
    (entry,) = RrdReader(path).recordings()
    return entry.application_id, entry.recording_id


@pytest.mark.parametrize(
    "change",
    [
        lambda _: crowd(5, "another name"),  # of the same numbers
        lambda run: replace(run, notes=("another way",)),
        lambda _: crowd(6),
    ],
)
def test_each_recording_has_its_own_layout(
    tmp_path: Path, change: Callable[[t2.Run], t2.Run]
) -> None:
    """The viewer keeps one for all recordings of an application, and merges those of one id."""
    run = crowd(5)
    for path, saved in ((tmp_path / "a.rrd", run), (tmp_path / "b.rrd", change(run))):
        saved.save(path)
    first, second = (identity(tmp_path / name) for name in ("a.rrd", "b.rrd"))
    assert first[0] != second[0]
    assert first[1] != second[1]
    run.save(tmp_path / "b.rrd")
    assert identity(tmp_path / "b.rrd") == first


def test_arrows_do_not_hide_small_bodies(run: t2.Run) -> None:
    """Nor do they grow with the view."""
    impacted = with_impacts(run)
    view = drawing.View(center=(0.0, 0.0), half=(1000.0, 1000.0))
    lengths = np.hypot(*impacts._vectors(impacted, view).T)
    radii = [body.shape.bounding_radius for body in run.scene.bodies if body.dynamic and body.shape]
    assert lengths.max() <= 2 * max(radii)
    assert lengths / lengths.max() == pytest.approx([0.5, 1.0, 0.0])
    near = drawing.View(center=(0.0, 0.0), half=(0.3, 0.4))
    assert np.hypot(*impacts._vectors(impacted, near).T).max() == pytest.approx(0.125)


def test_of_many_impacts_few_are_shown_at_a_time(run: t2.Run) -> None:
    assert layout._memory(with_impacts(run)) == pytest.approx(run.duration / 20)
    many = {
        name: np.repeat(value, 1000, 0) for name, value in vars(with_impacts(run).impacts).items()
    }
    moving = sum(body.dynamic for body in run.scene.bodies)
    crowded = replace(run, impacts=t2.Impacts(**many))
    assert layout._memory(crowded) == pytest.approx(run.duration * moving / 3000)


def test_a_recording_of_another_format_is_refused_by_name(
    run: t2.Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    made = headers.header_of
    monkeypatch.setattr(headers, "header_of", lambda run: replace(made(run), format=4))
    run.save(tmp_path / "run.rrd")
    with pytest.raises(t2.RecordingError, match=r"format 4: this version reads format 3"):
        t2.record.load(tmp_path / "run.rrd")
