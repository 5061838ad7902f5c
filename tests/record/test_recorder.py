"""The recorder of frame loops: what the file shows, and that none is lost (R5)."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.errors import FrameLoopError
from tamias2d.replay import check

pytest.importorskip("rerun")

DISC = t2.Disc(radius=0.5)


def loop() -> t2.Simulator:
    """A disc that flies over ground which it does not reach."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_static(t2.Box(width=20.0, height=1.0), position=(0.0, -50.0), restitution=0.0)
    scene.add_body(DISC, mass=1.0, position=(0.0, 0.0), velocity=(1.0, 0.0), name="first")
    return t2.Simulator(scene)


def rows(path: Path, entity: str, component: str) -> Iterator[tuple[int, Any]]:
    """Number of the frame, and what an entity has there."""
    from rerun.chunk import RrdReader

    for chunk in RrdReader(path).stream():
        if chunk.entity_path != entity or chunk.is_static:
            continue
        batch = chunk.to_record_batch()
        if component in batch.schema.names:
            yield from zip(
                batch.column("step").to_pylist(), batch.column(component).to_pylist(), strict=True
            )


def centres(path: Path) -> dict[int, Any]:
    """Of each frame the centres of all discs that are drawn, m."""
    return dict(rows(path, "/world/bodies/moving/rims1", "Points2D:positions"))


def test_all_bodies_of_each_frame_are_where_they_were(tmp_path: Path) -> None:
    path, sim, expected = tmp_path / "loop.rrd", loop(), []
    with t2.Recorder(sim, path) as recorder:
        for k in range(30):
            if k == 10:
                sim.add(DISC, mass=1.0, position=(3.0, 0.0), restitution=0.0)
            if k == 20:
                sim.remove("first")
            sim.step()
            recorder.frame()
            expected.append(sim.position[sim.dynamic & sim.present].astype(np.float32))
    assert len(recorder) == 30
    found = centres(path)
    assert sorted(found) == list(range(30))
    for k, places in enumerate(expected):
        np.testing.assert_array_equal(np.array(found[k], dtype=np.float32), places)


def test_what_is_gone_vanishes(tmp_path: Path) -> None:
    path, sim = tmp_path / "loop.rrd", loop()
    with t2.Recorder(sim, path) as recorder:
        recorder.frame()
        sim.remove("first")
        sim.step()
        recorder.frame()
    assert list(centres(path)) == [0]
    cleared = dict(rows(path, "/world/bodies/moving/rims1", "Clear:is_recursive"))
    assert cleared == {1: [False]}


def test_bodies_are_drawn_in_the_shapes_that_they_have(tmp_path: Path) -> None:
    path, sim = tmp_path / "loop.rrd", loop()
    sim.add(DISC, mass=1.0, position=(9.0, 0.0), restitution=0.0)
    with t2.Recorder(sim, path) as recorder:
        for change in (DISC, t2.Disc(radius=2.0), t2.Box(width=1.0, height=1.0)):
            sim.set_shape("first", change)
            recorder.frame()
            sim.set_mass("first", mass=2.0)
            sim.step()
            recorder.frame()
    assert [len(places) for places in centres(path).values()] == [2, 2, 2, 2, 1, 1]
    radii = dict(rows(path, "/world/bodies/moving/rims1", "Points2D:radii"))
    assert radii == {0: [0.5, 0.5], 2: [2.0, 0.5], 4: [0.5]}


def test_bodies_are_drawn_in_their_shapes_after_going_back(tmp_path: Path) -> None:
    path, sim = tmp_path / "loop.rrd", loop()
    state = sim.copy_state()
    with t2.Recorder(sim, path) as recorder:
        for change in (t2.Disc(radius=2.0), t2.Disc(radius=3.0)):
            sim.set_shape("first", change)
            recorder.frame()
            sim.restore_state(state)
    radii = dict(rows(path, "/world/bodies/moving/rims1", "Points2D:radii"))
    assert radii == {0: [2.0], 1: [3.0]}


def test_joints_are_drawn_while_they_are_there(tmp_path: Path) -> None:
    path, sim = tmp_path / "loop.rrd", loop()
    with t2.Recorder(sim, path) as recorder:
        recorder.frame()
        sim.add_joint(t2.Distance(), "first", (0.0, 5.0), name="rod")
        for k in range(3):
            sim.set_target("rod", (0.1 * k, 5.0))
            sim.step()
            recorder.frame()
        sim.remove_joint("rod")
        recorder.frame()
    drawn = dict(rows(path, "/world/joints/joint2", "LineStrips2D:strips"))
    assert [drawn[k][0][1] for k in (1, 2, 3)] == [
        pytest.approx([0.1 * k, 5.0], abs=1e-6) for k in range(3)
    ]
    assert list(dict(rows(path, "/world/joints/joint2", "Clear:is_recursive"))) == [4]


def test_links_without_shapes_are_drawn(tmp_path: Path) -> None:
    path, scene = tmp_path / "links.rrd", t2.Scene(gravity=(0.0, -10.0))
    for x in (0.5, 1.5):
        scene.add_body(None, mass=1.0, inertia=0.1, position=(x, 0.0))
    scene.add_joint(t2.Revolute(), (0.0, 0.0), 0, at=(0.0, 0.0))
    scene.add_joint(t2.Revolute(), 0, 1, at=(1.0, 0.0))
    with t2.Recorder(t2.Simulator(scene, compiled=False), path) as recorder:
        recorder.frame()
    ((_, links),) = rows(path, "/world/joints/joint2", "LineStrips2D:strips")
    wanted = [[(0.5, 0.0), (0.0, 0.0)], [(0.5, 0.0), (1.0, 0.0)], [(1.5, 0.0), (1.0, 0.0)]]
    assert np.array(links) == pytest.approx(np.array(wanted), abs=1e-6)  # float32


def test_an_error_in_the_loop_loses_no_frame(tmp_path: Path) -> None:
    path, sim = tmp_path / "loop.rrd", loop()

    def play() -> None:
        with t2.Recorder(sim, path) as recorder:
            for _ in range(271):
                sim.step()
                recorder.frame()
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        play()
    assert len(centres(path)) == 271


def test_a_loop_cannot_be_computed_again(tmp_path: Path) -> None:
    path = tmp_path / "loop.rrd"
    with t2.Recorder(loop(), path) as recorder:
        recorder.frame()
    for reader in (check, t2.Run.load):
        with pytest.raises(FrameLoopError, match=r"records a frame loop: .*`tamias2d replay"):
            reader(path)  # type: ignore[operator]


def test_the_viewer_opens_a_loop(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from tamias2d import record
    from tamias2d.replay import replay

    path, opened = tmp_path / "loop.rrd", []
    with t2.Recorder(loop(), path) as recorder:
        recorder.frame()
    monkeypatch.setattr(record.rerun, "view", lambda path, named: opened.append((path, named)))  # type: ignore[attr-defined]
    replay(path)
    assert opened == [(path, path)]


def test_a_disk_that_is_full_is_told_and_leaves_no_draft(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path, sim = tmp_path / "loop.rrd", loop()
    recorder = t2.Recorder(sim, path)
    recorder.frame()

    def full(*_: object, **__: object) -> None:
        raise RuntimeError("No space left on device")

    monkeypatch.setattr("rerun.RecordingStream.flush", full)
    with pytest.raises(t2.RecordingError, match=r"loop\.rrd: cannot be written: No space"):
        recorder.close()
    monkeypatch.undo()
    recorder.close()
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("given", "says"),
    [
        (lambda path: (3, path), r"sim: found 3: must be a Simulator \(R5\)"),
        (lambda path: (loop(), path.with_suffix(".npz")), r"ending '\.npz': a frame loop is .*R5"),
        (lambda path: (loop(), path / "none" / "a.rrd"), "there is no directory"),
        (lambda _: (loop(), 5), r"path: found 5: must be a text or a Path \(R5\)"),
    ],
)
def test_what_cannot_be_recorded_is_refused(tmp_path: Path, given: Any, says: str) -> None:
    with pytest.raises(t2.TamiasError, match=says):
        t2.Recorder(*given(tmp_path / "loop.rrd"))


def test_a_closed_recorder_takes_no_frame(tmp_path: Path) -> None:
    recorder = t2.Recorder(loop(), tmp_path / "loop.rrd")
    recorder.close()
    recorder.close()
    with pytest.raises(t2.RecordingError, match="its recorder is closed"):
        recorder.frame()


def test_bodies_that_fall_out_of_the_world_do_not_shrink_it() -> None:
    from tamias2d.record.drawing import View, grown, within

    world = View((0.0, 0.0), (10.0, 5.0))
    lost = View((0.0, -500.0), (10.0, 505.0))
    seen = grown(world, within(lost, world, 2.0))
    assert seen.center[1] - seen.half[1] >= -20.0
    assert grown(world, View((1.0, 1.0), (2.0, 2.0))) == world
