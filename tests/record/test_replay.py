"""Replaying starts the viewer safely, and says in one line why it could not."""

import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import tamias2d as t2
from tamias2d import replay

pytest.importorskip("rerun")


@pytest.fixture
def started(monkeypatch: pytest.MonkeyPatch) -> list[tuple[list[str], dict[str, str]]]:
    """What would have been started, in the place of the viewer; checks of files still run."""
    from tamias2d.record.rerun import program

    real, calls = subprocess.run, []

    def run(command: list[str], **options: Any) -> subprocess.CompletedProcess[str]:
        if "--bind" not in command:
            return real(command, **options)
        assert Path(command[1]).is_file()
        calls.append((command, options["env"]))
        return subprocess.CompletedProcess(command, 0, "", "")

    monkeypatch.setattr(program.subprocess, "run", run)
    return calls


@pytest.mark.parametrize("suffix", [".rrd", ".npz"])
def test_the_viewer_is_closed_to_the_network(
    run: t2.Run, tmp_path: Path, started: list[Any], suffix: str
) -> None:
    path = tmp_path / f"run{suffix}"
    run.save(path)
    replay.replay(path)
    ((command, environment),) = started
    assert Path(command[0]).name.startswith("rerun")
    assert Path(command[0]).parent.name == "rerun_cli"
    assert command[2:] == ["--bind", "127.0.0.1"]
    assert environment["CI"] == "true"
    assert list(tmp_path.iterdir()) == [path]


def test_a_cut_recording_is_not_opened(run: t2.Run, tmp_path: Path, started: list[Any]) -> None:
    path = tmp_path / "run.rrd"
    run.save(path)
    path.write_bytes(path.read_bytes()[:9000])
    with pytest.raises(t2.RecordingError, match="cut, damaged"):
        replay.replay(path)
    assert not started


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere a window would open")
def test_without_a_screen_it_says_so(
    run: t2.Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"):
        monkeypatch.delenv(name, raising=False)
    run.save(tmp_path / "run.rrd")
    with pytest.raises(t2.RecordingError, match=r"the viewer ended with code .*a screen and a"):
        replay.replay(tmp_path / "run.rrd")
