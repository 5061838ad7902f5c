"""The recorder of frame loops: what the file shows, and that none is lost (R5)."""

import errno
import subprocess
import sys
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


def test_what_happens_to_joints_between_frames_is_told_at_its_time(tmp_path: Path) -> None:
    """Two threads of which the weaker one breaks first, and a frame after every 50 steps."""
    path, scene = tmp_path / "loop.rrd", t2.Scene(gravity=(0.0, -9.81))
    for k in range(2):
        scene.add_body(None, mass=1.0, position=(1.0 + 4 * k, 0.0))
        joint = {"name": f"thread{k}", "break_force": 15.0 + 10 * k}
        scene.add_joint(t2.Distance(), (4.0 * k, 0.0), k, **joint)
    sim, events = t2.Simulator(scene, compiled=False), []
    with t2.Recorder(sim, path) as recorder:
        for k in range(60):
            sim.step()
            events += sim.joint_events
            if k % 50 == 0:
                recorder.frame()
    told = [f"{e.time:.6g} s: joint {e.joint} breaks" for e in events]
    assert len(told) == 2
    texts = list(rows(path, "/impacts/joints", "TextLog:text"))
    assert texts == [(1, [told[0]]), (1, [told[1]])]
    clock = [at for _, at in rows(path, "/impacts/joints", "sim_time")]
    assert [at.total_seconds() for at in clock] == pytest.approx([e.time for e in events], abs=1e-6)
    sim.step()
    assert not sim._heard  # by a recorder that is closed


def test_a_disk_that_is_full_is_told_and_what_was_written_is_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path, sim = tmp_path / "loop.rrd", loop()
    recorder = t2.Recorder(sim, path)
    for k in range(2):
        recorder.frame()
        sim.add(DISC, mass=1.0, position=(3.0 + 3 * k, 0.0), restitution=0.0)
    recorder.frame()

    def full(*_: object, **__: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr("rerun.BinaryStream.read", full)
    told = (
        r"loop\.rrd: cannot be written: No space.* is in .*loop\.part\.rrd, for `tamias2d replay`"
    )
    with pytest.raises(t2.RecordingError, match=told):
        recorder.close()
    monkeypatch.undo()
    recorder.close()
    (kept,) = tmp_path.iterdir()
    assert sorted(centres(kept)) == [0, 1]


LIMITED = """
import resource, sys
import tamias2d as t2

scene = t2.Scene(gravity=(0.0, 0.0))
for x in range(9):
    velocity = (0.0, 1.0 + x)
    disc = t2.Disc(radius=0.1)
    scene.add_body(disc, mass=1.0, position=(x, 0.0), velocity=velocity, restitution=0.0)
sim = t2.Simulator(scene, compiled=False)
resource.setrlimit(resource.RLIMIT_FSIZE, (150_000, 150_000))
with t2.Recorder(sim, sys.argv[1]) as recorder:
    while True:
        recorder.frame()
        sim.velocity[0] += 1.0
        sim.set_mass(1, mass=1.0 + len(recorder))
"""


@pytest.mark.skipif(sys.platform != "linux", reason="limits of a process")
def test_a_loop_whose_file_may_not_grow_ends_with_one_error(tmp_path: Path) -> None:
    path = tmp_path / "loop.rrd"
    done = subprocess.run(
        [sys.executable, "-c", LIMITED, str(path)],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    kept = tmp_path / "loop.part.rrd"
    assert done.returncode == 1
    assert f"What could be written is in {kept}" in done.stderr.splitlines()[-1]
    assert list(tmp_path.iterdir()) == [kept]
    assert len(centres(kept)) >= 5


def test_what_a_killed_loop_leaves_is_found_and_not_overwritten(tmp_path: Path) -> None:
    path = tmp_path / "loop.rrd"
    killed = t2.Recorder(loop(), path)
    killed.frame()
    assert [file.name for file in tmp_path.iterdir()] == ["loop.part.rrd"]
    with t2.Recorder(loop(), path) as recorder:
        recorder.frame()
        names = {file.name for file in tmp_path.iterdir()}
        assert names == {"loop.part.rrd", "loop.part2.rrd"}
    assert {file.name for file in tmp_path.iterdir()} == {"loop.part.rrd", "loop.rrd"}
    killed.close()
    assert [file.name for file in tmp_path.iterdir()] == ["loop.rrd"]


@pytest.mark.parametrize("torn", [False, True])
def test_the_viewer_opens_what_a_killed_loop_has_left(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, torn: bool
) -> None:
    from tamias2d import record
    from tamias2d.replay import replay

    path, left, opened = tmp_path / "loop.rrd", tmp_path / "left.rrd", []
    with t2.Recorder(loop(), path) as recorder:
        recorder.frame()
        recorder._write()
        content = (tmp_path / "loop.part.rrd").read_bytes()
    left.write_bytes(content[:-9] if torn else content)

    def view(path: Path, named: Path) -> None:
        opened.append((path, named, len(path.read_bytes())))

    monkeypatch.setattr(record.rerun, "view", view)  # type: ignore[attr-defined]
    replay(left)
    ((shown, named, size),) = opened
    assert named == left
    assert (shown == left) is not torn
    assert size < len(content) - 9 if torn else size == len(content)


def test_only_the_beginning_of_a_loop_is_read_before_it_is_shown(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from tamias2d.record.rerun import reading

    path = tmp_path / "loop.rrd"
    with t2.Recorder(loop(), path) as recorder:
        recorder.frame()
    monkeypatch.setattr(reading, "verify", lambda _: pytest.fail("all of it is read"))
    with pytest.raises(FrameLoopError):
        reading.read(path)


def test_a_closed_recorder_takes_no_frame(tmp_path: Path) -> None:
    recorder = t2.Recorder(loop(), tmp_path / "loop.rrd")
    recorder.close()
    recorder.close()
    with pytest.raises(t2.RecordingError, match="its recorder is closed"):
        recorder.frame()


@pytest.mark.parametrize("when", [5, 300])
def test_one_body_that_flies_off_does_not_shrink_the_rest(tmp_path: Path, when: int) -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    for k in range(3):
        scene.add_body(DISC, mass=1.0, position=(2.0 * k, 0.0), restitution=0.0)
    sim = t2.Simulator(scene, compiled=False)
    with t2.Recorder(sim, tmp_path / "loop.rrd") as recorder:
        for k in range(310):
            if k == when:
                sim.velocity[2] = (5000.0, 0.0)
            sim.step()
            recorder.frame()
    assert recorder._view is not None
    assert recorder._view.half[0] < 15.0


def test_what_all_bodies_do_is_in_the_view(tmp_path: Path) -> None:
    """Two discs side by side fall a hundred times as far as they are apart."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    for k in range(2):
        scene.add_body(DISC, mass=1.0, position=(1.5 * k, 0.0), restitution=0.0)
    sim = t2.Simulator(scene, compiled=False)
    with t2.Recorder(sim, tmp_path / "loop.rrd") as recorder:
        for _ in range(250):
            sim.step()
            recorder.frame()
    view = recorder._view
    assert view is not None
    assert view.center[1] - view.half[1] < float(sim.position[0, 1]) < -80.0


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


def test_bodies_that_fall_out_of_the_world_do_not_shrink_it() -> None:
    from tamias2d.record.drawing import View, grown, within

    world = View((0.0, 0.0), (10.0, 5.0))
    lost = View((0.0, -500.0), (10.0, 505.0))
    seen = grown(world, within(lost, world, 2.0))
    assert seen.center[1] - seen.half[1] >= -20.0
    assert grown(world, View((1.0, 1.0), (2.0, 2.0))) == world
