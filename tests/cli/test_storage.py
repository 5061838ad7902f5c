"""Results and caches have a home, and files are replaced whole."""

import os
import stat
import subprocess
import sys
import tempfile
import threading
from pathlib import Path

import pytest

from tamias2d import storage
from tamias2d.errors import InputError


def test_the_user_chooses_the_home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TAMIAS2D_HOME", str(tmp_path / "new" / "place"))
    assert storage.home() == tmp_path / "new" / "place"
    assert storage.results_path().parent.is_dir()


def test_a_home_that_cannot_be_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("in the way")
    monkeypatch.setenv("TAMIAS2D_HOME", str(tmp_path / "file"))
    with pytest.raises(InputError, match=r"TAMIAS2D_HOME: .*file: must be a directory"):
        storage.home()


def test_without_a_cache_directory_a_temporary_one_serves(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    (tmp_path / "file").write_text("in the way")
    monkeypatch.delenv("TAMIAS2D_HOME", raising=False)
    monkeypatch.setattr(storage.platformdirs, "user_cache_path", lambda *_, **__: tmp_path / "file")
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    place = storage.home()
    assert place.parent == tmp_path
    assert place.is_dir()
    assert storage.home() == place
    (said,) = caplog.messages
    assert said.startswith(f"{tmp_path / 'file'} cannot be written: results are kept only until")
    storage._temporary.cache_clear()
    assert not place.exists()  # nor does it outlive the process


def test_a_file_is_replaced_whole(tmp_path: Path) -> None:
    path = tmp_path / "results.json"
    storage.write_aside(path, b"old")
    storage.write_aside(path, b"new")
    assert path.read_bytes() == b"new"
    assert list(tmp_path.iterdir()) == [path]


def test_a_failed_write_leaves_the_old_file(tmp_path: Path) -> None:
    path = tmp_path / "results.json"
    storage.write_aside(path, b"old")

    def fill_the_disk() -> None:
        with storage.aside(path) as draft:
            draft.write_bytes(b"ne")
            raise OSError("the disk is full")

    with pytest.raises(OSError, match="full"):
        fill_the_disk()
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]


def test_a_home_of_no_user_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TAMIAS2D_HOME", "~nosuchuser/place")
    with pytest.raises(InputError, match=r"TAMIAS2D_HOME: ~nosuchuser.place: must be a directory"):
        storage.home()


@pytest.mark.skipif(os.name != "posix", reason="a directory that is used stays")
def test_a_home_in_a_directory_that_is_gone_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "gone").mkdir()
    monkeypatch.chdir(tmp_path / "gone")
    (tmp_path / "gone").rmdir()
    monkeypatch.setenv("TAMIAS2D_HOME", "place")
    with pytest.raises(InputError, match="TAMIAS2D_HOME: place: must be a directory"):
        storage.home_path()


@pytest.mark.skipif(os.name != "posix", reason="modes")
@pytest.mark.parametrize(("is_root", "mode"), [(False, 0o700), (True, 0o755)])
def test_nobody_else_can_write_what_is_made(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, is_root: bool, mode: int
) -> None:
    monkeypatch.setattr(storage, "_is_root", lambda: is_root)
    monkeypatch.setenv("TAMIAS2D_HOME", str(tmp_path / "new" / "place"))
    before = os.umask(0)
    try:
        place = storage.home()
    finally:
        os.umask(before)
    assert [stat.S_IMODE(path.stat().st_mode) for path in (place, place.parent)] == [mode, mode]


@pytest.mark.skipif(os.name != "posix", reason="modes")
@pytest.mark.parametrize("mode", [0o600, 0o640, 0o444])
def test_a_replaced_file_keeps_its_mode(tmp_path: Path, mode: int) -> None:
    path = tmp_path / "results.json"
    path.write_bytes(b"old")
    path.chmod(mode)
    storage.write_aside(path, b"new")
    assert path.read_bytes() == b"new"
    assert stat.S_IMODE(path.stat().st_mode) == mode


@pytest.mark.skipif(os.name != "posix", reason="links")
@pytest.mark.parametrize("old", [b"old", None], ids=["file", "nothing"])
def test_a_link_stays_a_link(tmp_path: Path, old: bytes | None) -> None:
    (tmp_path / "folder").mkdir()
    target = tmp_path / "folder" / "target"
    if old:
        target.write_bytes(old)
    (tmp_path / "link").symlink_to(target)
    storage.write_aside(tmp_path / "link", b"new")
    assert (tmp_path / "link").is_symlink()
    assert target.read_bytes() == b"new"


def test_the_longest_name_that_there_is_can_be_written(tmp_path: Path) -> None:
    path = tmp_path / ("x" * 255)
    storage.write_aside(path, b"content")
    assert path.read_bytes() == b"content"


@pytest.mark.parametrize("name", ["a\0b", "\ud800", "y" * 256, "no/where"])
def test_a_name_of_no_file_is_an_os_error(tmp_path: Path, name: str) -> None:
    with pytest.raises(OSError):
        storage.write_aside(tmp_path / name, b"content")


@pytest.mark.skipif(os.name != "posix", reason="pipes")
def test_a_pipe_is_not_replaced(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    with pytest.raises(OSError, match="no regular file"):
        storage.write_aside(tmp_path / "pipe", b"content")
    assert stat.S_ISFIFO((tmp_path / "pipe").stat().st_mode)


KILLED = """
import os, sys
from pathlib import Path
from tamias2d import storage
with storage.aside(Path(sys.argv[1])) as draft:
    draft.write_bytes(b"half")
    os.kill(os.getpid(), 9)
"""


@pytest.mark.skipif(os.name != "posix", reason="signals and locks")
def test_the_draft_of_a_killed_writer_is_removed_by_the_next(tmp_path: Path) -> None:
    path = tmp_path / "results.json"
    environment = {"PYTHONPATH": ":".join(sys.path)}
    subprocess.run([sys.executable, "-c", KILLED, str(path)], env=environment, check=False)
    (left,) = tmp_path.iterdir()
    assert left.read_bytes() == b"half"
    (tmp_path / ".somebody-elses.tmp").write_bytes(b"")
    with storage.aside(path) as draft:
        draft.write_bytes(b"one")
        storage.write_aside(path, b"other")  # while a draft is being written, it stays
        assert draft.read_bytes() == b"one"
    assert path.read_bytes() == b"one"
    assert {file.name for file in tmp_path.iterdir()} == {"results.json", ".somebody-elses.tmp"}


def test_writers_at_once_do_not_disturb_each_other(tmp_path: Path) -> None:
    path, faults = tmp_path / "results.json", []

    def write(mark: int) -> None:
        for _ in range(100):
            try:
                storage.write_aside(path, bytes([mark]) * 1000)
            except OSError as fault:
                faults.append(fault)

    writers = [threading.Thread(target=write, args=(k,)) for k in range(4)]
    for writer in writers:
        writer.start()
    for writer in writers:
        writer.join()
    assert not faults
    assert len(set(path.read_bytes())) == 1
    assert list(tmp_path.iterdir()) == [path]
