"""Results and caches have a home, and files are replaced whole."""

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
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "file").write_text("in the way")
    monkeypatch.delenv("TAMIAS2D_HOME", raising=False)
    monkeypatch.setattr(storage.platformdirs, "user_cache_path", lambda *_, **__: tmp_path / "file")
    monkeypatch.setattr(storage.tempfile, "tempdir", str(tmp_path))
    storage.temporary.cache_clear()
    place = storage.home()
    assert place.parent == tmp_path
    assert place.is_dir()
    assert storage.home() == place


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
