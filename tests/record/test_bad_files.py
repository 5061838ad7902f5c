"""Whatever a file holds, the answer is a recording or one message; never a crash from inside."""

import contextlib
import random
import subprocess
import sys
import textwrap
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d import record, replay

SUFFIXES = [".rrd", ".npz"]


@pytest.fixture(scope="module")
def saved(run: t2.Run, tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    folder = tmp_path_factory.mktemp("saved")
    for suffix in SUFFIXES:
        run.save(folder / f"run{suffix}")
    return {suffix: (folder / f"run{suffix}").read_bytes() for suffix in SUFFIXES}


def python(code: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", textwrap.dedent(code)],
        capture_output=True,
        text=True,
        check=False,
    )


def refusal(path: Path) -> str:
    """The message with which a check refuses a file: one line that begins with its name."""
    with pytest.raises(t2.RecordingError) as caught:
        replay.check(path)
    assert str(caught.value).startswith(f"{path}: ")
    assert "\n" not in str(caught.value)
    return str(caught.value)


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_cut_file_is_one_message(saved: dict[str, bytes], tmp_path: Path, suffix: str) -> None:
    whole = saved[suffix]
    path = tmp_path / f"cut{suffix}"
    for length in (0, 1, 10, 100, *np.linspace(200, 0.95 * len(whole), 12).astype(int)):
        path.write_bytes(whole[:length])
        assert "cut, damaged or of another kind" in refusal(path)


@pytest.mark.parametrize("end", ["os.abort()", "1 / 0", "os._exit(3.5)", "os.kill(os.getpid(), 9)"])
def test_a_reader_that_ends_its_process_does_not_end_ours(
    saved: dict[str, bytes], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, end: str
) -> None:
    """Rerun's aborts at some damages."""
    from tamias2d.record.rerun import reading

    (tmp_path / "fatal.py").write_text(f"import os\n{end}\n")
    monkeypatch.setenv("PYTHONPATH", str(tmp_path))
    monkeypatch.setattr(reading, "UNPACKING", "fatal")
    path = tmp_path / "whole.rrd"
    path.write_bytes(saved[".rrd"])
    assert "cut, damaged or of another kind" in refusal(path)


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_flipped_bits_are_an_answer_or_a_message(
    saved: dict[str, bytes], tmp_path: Path, suffix: str
) -> None:
    chance = random.Random(20261121)
    path = tmp_path / f"flipped{suffix}"
    for _ in range(60):
        damaged = bytearray(saved[suffix])
        for _ in range(chance.choice([1, 5, 50])):
            damaged[chance.randrange(len(damaged))] ^= 1 << chance.randrange(8)
        path.write_bytes(damaged)
        with contextlib.suppress(t2.RecordingError):
            replay.check(path)


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_missing_file_and_a_directory(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"run{suffix}"
    assert "there is no such file" in refusal(path)
    path.mkdir()
    assert "is a directory. Give the name of a file in it" in refusal(path)


@pytest.mark.parametrize("name", ["run.txt", "run", "run.RRD", ".npz"])
def test_an_unknown_suffix_names_the_two(run: t2.Run, tmp_path: Path, name: str) -> None:
    for attempt in (lambda p: record.save(run, p), record.load, replay.check, replay.replay):
        with pytest.raises(t2.InputError, match=r"\.rrd .*\.npz"):
            attempt(tmp_path / name)


def test_arrays_of_another_program(tmp_path: Path) -> None:
    path = tmp_path / "foreign.npz"
    np.savez(path, position=np.zeros(3))
    assert "header cannot be read" in refusal(path)
    np.savez(path, header=np.array("{}"))
    assert "header cannot be read" in refusal(path)
    np.save(path.with_suffix(".npy"), np.zeros(3))
    path.with_suffix(".npy").rename(path)
    assert "cut, damaged or of another kind" in refusal(path)


class Trap:
    """Touches a file when it is unpickled."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def __reduce__(self) -> tuple[Any, ...]:
        return Path.touch, (self.path,)


def test_a_run_and_a_simulator_are_told_apart(run: t2.Run, tmp_path: Path) -> None:
    one, other = tmp_path / "run.npz", tmp_path / "game.npz"
    run.save(one)
    t2.Simulator(t2.Scene(gravity=(0.0, 0.0)), compiled=False).save(other)
    with pytest.raises(t2.RecordingError, match=r"a recording of a run.*Run\.load\(path\)"):
        t2.Simulator.restore(one)
    with pytest.raises(t2.RecordingError, match=r"a saved simulator.*Simulator\.restore\(path\)"):
        t2.Run.load(other)
    with pytest.raises(t2.SceneError, match=r"Run\.load\(path\).*Simulator\.restore\(path\)"):
        t2.load(other)


def test_a_pickle_is_not_opened(tmp_path: Path) -> None:
    path = tmp_path / "trap.npz"
    np.savez(path, header=np.array([Trap(tmp_path / "sprung")], dtype=object))
    refusal(path)
    assert not (tmp_path / "sprung").exists()


def test_a_recording_of_another_program(tmp_path: Path) -> None:
    rr = pytest.importorskip("rerun")
    path = tmp_path / "foreign.rrd"
    with rr.RecordingStream("another program") as stream:
        stream.save(path)
        stream.log("world", rr.Points2D([[0, 0]]))
    assert "of another program" in refusal(path)


def rewritten(path: Path, **changes: Any) -> Path:
    """An `.npz` with arrays changed, or left out where the change is None."""
    stored = {**dict(np.load(path)), **changes}
    np.savez(path, **{name: array for name, array in stored.items() if array is not None})
    return path


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"velocity": None}, "velocity: found nothing: must be float64 (31, 6, 2)"),
        ({"velocity": np.zeros((31, 6))}, "velocity: found float64 (31, 6)"),
        ({"velocity": np.zeros((31, 6, 2), np.float32)}, "velocity: found float32"),
        ({"times": np.zeros((31,)) - 1}, "its inputs are refused"),
        ({"impacts.time": np.zeros((1,))}, "impacts.time: found float64 (1,)"),
    ],
)
def test_arrays_that_do_not_fit(
    run: t2.Run, tmp_path: Path, changes: dict[str, Any], says: str
) -> None:
    run.save(tmp_path / "run.npz")
    assert says in refusal(rewritten(tmp_path / "run.npz", **changes))


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ('"format": 3', '"format": 2', "format 2: this version reads format 3"),
        ('"name": "ClosedForm"', '"name": "system"', "method 'system' is none of"),
        (
            '"name": "ClosedForm"',
            '"name": "ClosedForm", "x": 1',
            "options of the method ClosedForm",
        ),
        ('"samples": 31', '"samples": 32', "times: found float64 (31,): must be float64 (32,)"),
        ('"samples": 31', '"samples": "31"', "header cannot be read"),
        ('"duration": 0.5', '"duration": "0.5"', "header cannot be read"),
        ('"notes": ["', '"notes": [1, "', "header cannot be read"),
        ("shape: disc", "shape: disk", "the scene in it: "),
        ('"speck", "lamp"', '"fleck", "lamp"', "the scene in it has bodies"),
        ('"duration": 0.5', '"duration": -0.5', "its inputs are refused"),
        ('"notes"', '"remarks"', "header cannot be read"),
    ],
)
def test_headers_that_do_not_fit(
    run: t2.Run, tmp_path: Path, old: str, new: str, says: str
) -> None:
    path = tmp_path / "run.npz"
    run.save(path)
    header = str(np.load(path)["header"])
    assert old in header
    assert says in refusal(rewritten(path, header=np.array(header.replace(old, new, 1))))


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_where_nothing_can_be_written(run: t2.Run, tmp_path: Path, suffix: str) -> None:
    with pytest.raises(t2.RecordingError, match="there is no directory"):
        run.save(tmp_path / "missing" / f"run{suffix}")
    (tmp_path / f"run{suffix}").mkdir()
    with pytest.raises(t2.RecordingError, match="is a directory"):
        run.save(tmp_path / f"run{suffix}")
    assert len(list(tmp_path.iterdir())) == 1


@pytest.mark.skipif(sys.platform == "win32", reason="limits of a process are those of POSIX")
@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_full_disk_keeps_the_old_recording(tmp_path: Path, suffix: str) -> None:
    """A limit on the size of files stands for the full disk."""
    path = tmp_path / f"run{suffix}"
    path.write_bytes(b"the old one")
    code = f"""
        import resource, signal
        import tamias2d as t2
        scene = t2.Scene(gravity=(0.0, 0.0))
        for k in range(20):
            scene.add_body(None, mass=1.0, position=(float(k), 0.0), velocity=(0.1, 0.3))
        run = t2.simulate(scene, duration=60.0)
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (50_000, 50_000))
        try:
            run.save({str(path)!r})
        except t2.RecordingError as fault:
            print(fault)
    """
    done = python(code)
    assert done.returncode == 0, done.stderr
    assert f"{path}: cannot be written: " in done.stdout
    assert done.stdout.count("\n") == 1
    assert path.read_bytes() == b"the old one"
    assert list(tmp_path.iterdir()) == [path]


def test_rerun_switched_off(run: t2.Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RERUN", "off")
    with pytest.raises(t2.RecordingError, match="the environment says RERUN=off"):
        run.save(tmp_path / "run.rrd")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("missing", ["rerun", "pyarrow"])
def test_without_rerun(run: t2.Run, tmp_path: Path, missing: str) -> None:
    run.save(tmp_path / "run.npz")
    code = f"""
        import sys
        from pathlib import Path
        sys.modules[{missing!r}] = None
        import tamias2d as t2
        from tamias2d import replay
        from tamias2d.run import Run
        folder = Path({str(tmp_path)!r})
        run = Run.load(folder / "run.npz")
        for attempt, name in ((run.save, "run.rrd"), (replay.replay, "run.npz")):
            try:
                attempt(folder / name)
            except t2.RecordingError as fault:
                print(fault)
    """
    done = python(code)
    lines = done.stdout.splitlines()
    assert len(lines) == 2, done.stderr
    assert all('`pip install "tamias2d[record]"`' in line for line in lines)
    assert lines[1].startswith(f"{tmp_path / 'run.npz'}: the viewer needs rerun")
    assert "replay --check" in lines[1]
