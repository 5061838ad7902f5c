"""Where a recording cannot be, it is refused before the run; where it can, the place stays."""

import os
import stat
from pathlib import Path
from typing import Any

import pytest

import tamias2d as t2
from tamias2d.commands import run as run_command
from tamias2d.recording_file import refuse_place

SUFFIXES = [".rrd", ".npz"]


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("stem", ["a\0b", "\ud800", "x" * 252])
def test_what_is_no_name_is_refused(run: t2.Run, tmp_path: Path, stem: str, suffix: str) -> None:
    with pytest.raises(t2.RecordingError, match=r"cannot be written: .* Rename it") as caught:
        run.save(tmp_path / f"{stem}{suffix}")
    assert "\0" not in str(caught.value)
    with pytest.raises(t2.RecordingError, match="there is no such file"):
        t2.record.load(tmp_path / f"{stem}{suffix}")


@pytest.mark.skipif(os.name != "posix", reason="links")
def test_what_leads_to_no_name_is_refused(run: t2.Run, tmp_path: Path) -> None:
    (tmp_path / "run.npz").symlink_to(tmp_path / ("x" * 300) / "run.npz")
    with pytest.raises(t2.RecordingError, match="there is no directory"):
        run.save(tmp_path / "run.npz")
    with pytest.raises(t2.InputError, match="a run is saved as"):
        run.save(tmp_path / ("x" * 300))


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_the_longest_names_are_written(run: t2.Run, tmp_path: Path, suffix: str) -> None:
    path = tmp_path / ("x" * 251 + suffix)
    run.save(path)
    assert t2.record.load(path).digest() == run.digest()


@pytest.mark.skipif(os.name != "posix", reason="pipes")
@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_pipe_is_refused(run: t2.Run, tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"pipe{suffix}"
    os.mkfifo(path)
    with pytest.raises(t2.RecordingError, match="is a pipe or a device"):
        run.save(path)
    with pytest.raises(t2.RecordingError, match="there is no such file"):
        t2.record.load(path)
    assert stat.S_ISFIFO(path.stat().st_mode)


@pytest.mark.skipif(os.name != "posix", reason="modes and links")
@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_link_and_a_mode_stay(run: t2.Run, tmp_path: Path, suffix: str) -> None:
    target, link = tmp_path / f"target{suffix}", tmp_path / f"link{suffix}"
    target.write_bytes(b"old")
    target.chmod(0o600)
    link.symlink_to(target)
    run.save(link)
    assert link.is_symlink()
    assert stat.S_IMODE(target.stat().st_mode) == 0o600
    assert t2.record.load(target).digest() == run.digest()


def test_a_directory_that_cannot_be_written_is_refused_before_the_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(os, "access", lambda *_: False)  # modes do not stop a superuser
    with pytest.raises(t2.RecordingError, match=r"cannot be written\. Choose another place"):
        refuse_place(tmp_path / "run.npz")

    def never(*_: Any, **__: Any) -> None:
        raise AssertionError("it was simulated")

    monkeypatch.setattr(run_command, "simulate", never)
    options: dict[str, Any] = dict.fromkeys(
        ["duration", "method", "time_step", "tolerance", "quality", "plot"]
    )
    with pytest.raises(t2.RecordingError, match="cannot be written"):
        run_command.run_scene(
            "tc1", **options, certified=False, record=tmp_path / "run.npz", as_json=False
        )
