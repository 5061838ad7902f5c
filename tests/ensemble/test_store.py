"""Ensembles on disk: the same numbers, and nothing that was finished is lost."""

import os
import re
import signal
import subprocess
import sys
import textwrap
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr

import tamias2d as t2
from tamias2d.ensemble import dataset
from tests.ensemble.scenes import bouncing

ARGUMENTS: dict[str, Any] = {
    "duration": 0.5,
    "vary": {"bodies.ball.position.y": np.linspace(0.5, 1.5, 20)},
    "keep": ("position", "energy"),
    "times": (0.1, 0.5),
}


def in_memory() -> xr.Dataset:
    return t2.ensemble(bouncing(), workers=1, **ARGUMENTS)


@pytest.mark.parametrize(("chunk", "workers"), [(20, 1), (3, 1), (7, 2)])
def test_a_store_holds_what_memory_would(tmp_path: Path, chunk: int, workers: int) -> None:
    out = tmp_path / "e.zarr"
    stored = t2.ensemble(bouncing(), out=out, chunk=chunk, workers=workers, **ARGUMENTS)
    wanted = in_memory()
    assert stored.load().identical(wanted)
    assert xr.open_zarr(out, consolidated=False).load().identical(wanted)
    assert t2.world_scene(stored, 5) == t2.world_scene(wanted, 5)


@pytest.mark.parametrize("stored", [False, True])
@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("v/c", "must not be empty, begin with a dot, or have a slash"),
        ("v\\c", "have a slash, a backslash"),
        ("..", "begin with a dot"),
        ("", "must not be empty"),
        ("v\0", "what cannot be printed"),
        ("world", "has this name for something else"),
        ("time", "has this name for something else"),
        ("bodies.ball.position.y", "has this name for something else"),
    ],
)
def test_a_quantity_whose_name_the_dataset_cannot_hold_is_refused(
    tmp_path: Path, name: str, message: str, *, stored: bool
) -> None:
    """In memory as on disk, where one with a slash was lost; and before a world is computed."""

    def uncalled(_: t2.Run) -> float:
        raise AssertionError

    out = tmp_path / "e.zarr" if stored else None
    with pytest.raises(t2.InputError, match=rf"quantity .*{message}.*\(R5\)"):
        t2.ensemble(bouncing(), workers=1, out=out, quantities={name: uncalled}, **ARGUMENTS)


def test_what_varies_in_a_body_whose_name_a_store_cannot_hold_is_refused(tmp_path: Path) -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(0.0, 0.0), name="l/b")
    for out in (None, tmp_path / "e.zarr"):
        with pytest.raises(t2.InputError, match=r"vary 'bodies.l/b.mass': .*a slash.*\(R2\)"):
            t2.ensemble(scene, duration=0.5, vary={"bodies.l/b.mass": [1.0, 2.0]}, out=out)


def test_what_was_finished_is_kept_when_it_is_interrupted(tmp_path: Path) -> None:
    out = tmp_path / "e.zarr"
    heard: list[int] = []

    def stop(finished: int, _: int) -> None:
        heard.append(finished)
        if finished == 12:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        t2.ensemble(bouncing(), out=out, chunk=4, workers=1, progress=stop, **ARGUMENTS)
    assert heard == [0, 4, 8, 12]
    heard.clear()
    stored = t2.ensemble(
        bouncing(), out=out, chunk=9, workers=1, progress=lambda n, _: heard.append(n), **ARGUMENTS
    )
    assert heard == [12, 16, 20]  # in the chunks of the store
    assert stored.load().identical(in_memory())


def test_a_worker_that_is_killed_loses_nothing(tmp_path: Path) -> None:
    trap, parent = tmp_path / "trap", os.getpid()

    def deadly(run: t2.Run) -> float:
        if run.position[0, 1, 1] > 1.0 and not trap.exists():
            trap.touch()
            assert os.getpid() != parent
            os.kill(os.getpid(), signal.SIGKILL)
        return float(run.energy[-1])

    arguments = ARGUMENTS | {"quantities": {"deadly": deadly}}
    out = tmp_path / "e.zarr"
    stored = t2.ensemble(bouncing(), out=out, chunk=2, workers=2, **arguments)
    assert trap.exists()
    assert (stored.outcome == 1).all()
    assert stored.load().drop_vars("deadly").drop_attrs().identical(in_memory().drop_attrs())
    np.testing.assert_array_equal(stored.deadly, stored.energy[:, -1])


def test_workers_that_always_die_are_told_of(tmp_path: Path) -> None:
    def deadly(run: t2.Run) -> float:
        if run.position[0, 1, 1] > 1.0:
            os.kill(os.getpid(), signal.SIGKILL)
        return 0.0

    out = tmp_path / "e.zarr"
    arguments = ARGUMENTS | {"quantities": {"deadly": deadly}}
    with pytest.raises(t2.SimulationError, match=r"3 workers died.*what was finished is kept"):
        t2.ensemble(bouncing(), out=out, chunk=2, workers=2, **arguments)
    left = xr.open_zarr(out, consolidated=False).outcome.values
    assert (left[:4] == 1).all()


SCRIPT = """
    import sys, time
    import tamias2d as t2
    from tests.ensemble.scenes import bouncing
    from tests.ensemble.test_store import ARGUMENTS

    def slow(run):
        time.sleep(0.05)
        return 0.0

    t2.ensemble(
        bouncing(), out=sys.argv[1], chunk=2, workers=1, quantities={"slow": slow}, **ARGUMENTS
    )
"""


def test_a_program_that_is_killed_goes_on_where_it_was(tmp_path: Path) -> None:
    out, script = tmp_path / "e.zarr", tmp_path / "script.py"
    script.write_text(textwrap.dedent(SCRIPT))
    command = [sys.executable, str(script), str(out)]
    path = {"PYTHONPATH": os.pathsep.join((os.getcwd(), *sys.path))}
    first = subprocess.Popen(command, env={**os.environ, **path})
    try:
        while not list(out.glob("outcome/.ledger/[1-9]*")):
            assert first.poll() is None
            time.sleep(0.01)
    finally:
        first.send_signal(signal.SIGKILL)
        first.wait()
    finished = [out / "outcome" / entry.name for entry in out.glob("outcome/.ledger/[0-9]*")]
    assert 2 <= len(finished) < 10
    before = {chunk: chunk.stat().st_mtime_ns for chunk in finished}
    subprocess.run(command, env={**os.environ, **path}, check=True)
    assert {chunk: chunk.stat().st_mtime_ns for chunk in finished} == before
    stored = xr.open_zarr(out, consolidated=False).load().drop_vars("slow")
    assert stored.drop_attrs().identical(in_memory().drop_attrs())


def lose(file: Path) -> None:
    file.unlink()


def cut(file: Path) -> None:
    file.write_bytes(file.read_bytes()[: file.stat().st_size // 2])


def empty(file: Path) -> None:
    file.write_bytes(b"")


def alter(file: Path) -> None:
    content = bytearray(file.read_bytes())
    content[-1] ^= 1
    file.write_bytes(content)


DAMAGES = pytest.mark.parametrize("damage", [lose, cut, empty, alter])


@DAMAGES
@pytest.mark.parametrize(
    "file", ["position/2.0.0.0", "energy/2.0", "outcome/2", "outcome/.ledger/2"]
)
def test_a_damaged_chunk_is_computed_again(
    tmp_path: Path, file: str, damage: Callable[[Path], None]
) -> None:
    out = tmp_path / "e.zarr"
    whole = t2.ensemble(bouncing(), out=out, chunk=8, workers=1, **ARGUMENTS).load()
    damage(out / file)
    heard: list[int] = []
    mended = t2.ensemble(
        bouncing(), out=out, workers=1, progress=lambda n, _: heard.append(n), **ARGUMENTS
    )
    assert heard == [16, 20]
    assert mended.load().identical(whole)


@DAMAGES
@pytest.mark.parametrize(
    "file",
    [
        ".zgroup", ".zattrs", "position/.zarray", "position/.zattrs", "outcome/.zarray",
        "bodies.ball.position.y/0", "time/0",
    ],
)  # fmt: skip
def test_a_store_whose_description_is_damaged_is_refused(
    tmp_path: Path, file: str, damage: Callable[[Path], None]
) -> None:
    out = tmp_path / "e.zarr"
    t2.ensemble(bouncing(), out=out, chunk=8, workers=1, **ARGUMENTS)
    damage(out / file)
    told = rf"e\.zarr: its file {re.escape(file)} is missing, or not as it was written \(R8\)"
    with pytest.raises(t2.RecordingError, match=told):
        t2.ensemble(bouncing(), out=out, workers=1, **ARGUMENTS)


@pytest.mark.parametrize(
    "other",
    [
        {"duration": 0.6},
        {"keep": ("position",)},
        {"vary": {"gravity.y": [1.0] * 20}},
        {"tolerance": 1e-3},
    ],
)
def test_another_ensemble_is_not_mixed_in(tmp_path: Path, other: dict[str, Any]) -> None:
    out = tmp_path / "e.zarr"
    t2.ensemble(bouncing(), out=out, workers=1, **ARGUMENTS)
    with pytest.raises(t2.RecordingError, match=r"e\.zarr: holds another ensemble.*\(R8\)"):
        t2.ensemble(bouncing(), out=out, workers=1, **(ARGUMENTS | other))


def test_a_store_of_another_version_of_the_program_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / "e.zarr"
    t2.ensemble(bouncing(), out=out, workers=1, **ARGUMENTS)
    monkeypatch.setattr(dataset, "source_digest", lambda: "another")
    with pytest.raises(t2.RecordingError, match="or one of another version of the program"):
        t2.ensemble(bouncing(), out=out, workers=1, **ARGUMENTS)


def test_what_is_no_store_is_left_alone(tmp_path: Path) -> None:
    out = tmp_path / "e.zarr"
    out.write_text("mine")
    with pytest.raises(t2.RecordingError, match="is no Zarr store of an ensemble"):
        t2.ensemble(bouncing(), out=out, workers=1, **ARGUMENTS)
    assert out.read_text() == "mine"
    with pytest.raises(t2.RecordingError, match=r"there is no directory .*no"):
        t2.ensemble(bouncing(), out=tmp_path / "no" / "e.zarr", workers=1, **ARGUMENTS)
    with pytest.raises(t2.RecordingError, match="there is no directory"):
        t2.ensemble(bouncing(), out=tmp_path / ("x" * 300) / "e.zarr", workers=1, **ARGUMENTS)
    with pytest.raises(t2.RecordingError, match=r"a\\x00b': is no name of a file \(R8\)"):
        t2.ensemble(bouncing(), out=tmp_path / "a\0b", workers=1, **ARGUMENTS)


FULL = """
    import resource, sys
    import tamias2d as t2
    from tests.ensemble.scenes import bouncing
    from tests.ensemble.test_store import ARGUMENTS

    def limit(finished, _):
        if finished == 16:  # then no file may grow beyond 10 bytes, as on a full disk
            resource.setrlimit(resource.RLIMIT_FSIZE, (10, 10))

    try:
        t2.ensemble(bouncing(), out=sys.argv[1], chunk=8, workers=1, progress=limit, **ARGUMENTS)
    except t2.RecordingError as fault:
        sys.exit(f"told: {fault}")
"""


@pytest.mark.skipif(sys.platform == "win32", reason="there is no such limit")
def test_a_full_disk_is_told_and_what_was_finished_is_kept(tmp_path: Path) -> None:
    out = tmp_path / "e.zarr"
    path = {"PYTHONPATH": os.pathsep.join((os.getcwd(), *sys.path))}
    told = subprocess.run(
        [sys.executable, "-c", textwrap.dedent(FULL), str(out)],
        env={**os.environ, **path}, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert told.stderr.startswith(f"told: {out}: cannot be written: File too large")
    assert told.stderr.count("\n") == 1
    assert xr.open_zarr(out, consolidated=False).outcome.values.tolist() == [1] * 16 + [0] * 4
    stored = t2.ensemble(bouncing(), out=out, workers=1, **ARGUMENTS)
    assert stored.load().identical(in_memory())
