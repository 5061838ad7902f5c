"""What the command does where its output cannot go: it says so in one line, and loses no file."""

import os
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.skipif(os.name != "posix", reason="redirections of a POSIX shell")


def shell(command: str, folder: Path) -> subprocess.CompletedProcess[bytes]:
    tamias2d = f"{shlex.quote(sys.executable)} -m tamias2d"
    environment = {**os.environ, "TAMIAS2D_HOME": str(folder / "home")}
    environment.pop("PYTHONUNBUFFERED", None)
    return subprocess.run(
        ["sh", "-c", command.replace("tamias2d", tamias2d)],
        cwd=folder,
        env=environment | {"PYTHONPATH": ":".join(path or os.getcwd() for path in sys.path)},
        capture_output=True,
        check=False,
    )


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="a device that is full")
@pytest.mark.parametrize("before", ["", "PYTHONUNBUFFERED=1 "])
@pytest.mark.parametrize("option", ["", " --json"])
def test_a_full_output_is_one_line_and_loses_no_recording(
    tmp_path: Path, before: str, option: str
) -> None:
    done = shell(f"{before}tamias2d run tc1 --record run.npz{option} > /dev/full", tmp_path)
    assert done.returncode == 2
    assert done.stderr.startswith(b"standard output: No space left on device.")
    assert done.stderr.count(b"\n") == 1
    assert (tmp_path / "run.npz").exists()


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="a device that is full")
@pytest.mark.parametrize("words", ["scenes", "scenes --json", "explain tc1 --source"])
def test_each_command_says_that_its_output_is_lost(tmp_path: Path, words: str) -> None:
    done = shell(f"tamias2d {words} > /dev/full", tmp_path)
    assert (done.returncode, done.stderr.count(b"\n")) == (2, 1)


@pytest.mark.parametrize("closed", [">&-", "2>&-", ">&- 2>&-"])
def test_closed_streams_do_not_disturb_a_run(tmp_path: Path, closed: str) -> None:
    done = shell(f"tamias2d run tc1 --record run.npz {closed}", tmp_path)
    assert done.returncode == 0
    assert done.stderr == b""
    assert shell("tamias2d replay --check run.npz", tmp_path).returncode == 0


def test_a_reader_that_has_enough_is_no_fault(tmp_path: Path) -> None:
    done = shell("tamias2d explain dominoes | head -n 1", tmp_path)
    assert done.stdout.count(b"\n") == 1
    assert b"Traceback" not in done.stderr


@pytest.mark.parametrize("words", ["run tc1", "run tc1 --json", "scenes", "explain dominoes"])
def test_what_nobody_reads_is_no_failed_check(tmp_path: Path, words: str) -> None:
    """A shell reports 141 of what ends since its reader has gone; 1 is that of a failed check."""
    done = shell(f"(sleep 1; tamias2d {words}; echo $? >code) | true", tmp_path)
    assert (tmp_path / "code").read_text().strip() == "141"
    assert done.stderr == b""


def test_letters_that_the_output_lacks_are_escaped(tmp_path: Path) -> None:
    body = "ü: {shape: none, mass: 1 kg, position: [0 m, 0 m]}"
    scene = f"gravity: [0 m/s^2, 0 m/s^2]\nbodies:\n  {body}\n"
    (tmp_path / "scene.yaml").write_text(scene, encoding="utf-8")
    done = shell("PYTHONIOENCODING=ascii tamias2d run scene.yaml --duration 1", tmp_path)
    assert done.returncode == 0, done.stderr
    assert rb"\xfc" in done.stdout
