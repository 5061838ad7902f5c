"""What is read back from a recording is the run that was saved, to the last bit."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import tamias2d as t2
from tamias2d import record
from tamias2d.record.history import OF_BODIES, arrays_of


@pytest.mark.parametrize("suffix", [".rrd", ".npz"])
def test_every_bit_comes_back(any_run: t2.Run, tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"run{suffix}"
    any_run.save(path)
    back = record.load(path)
    assert back.digest() == any_run.digest()
    assert back.scene == any_run.scene
    assert back.method == any_run.method
    assert (back.duration, back.time_step) == (any_run.duration, any_run.time_step)
    assert back.notes == any_run.notes
    for name, array in arrays_of(any_run).items():
        assert arrays_of(back)[name].dtype == array.dtype, name
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.filterwarnings("ignore::RuntimeWarning")  # what is drawn of them overflows
@pytest.mark.parametrize("suffix", [".rrd", ".npz"])
def test_numbers_that_are_hard_to_keep(run: t2.Run, tmp_path: Path, suffix: str) -> None:
    hard = [-0.0, 5e-324, 1.7976931348623157e308, np.inf, -np.inf, np.nan, 1 / 3, 2.0**53 + 1]
    changed = {name: getattr(run, name).copy() for name in OF_BODIES}
    changed["orientation"][: len(hard), 0] = hard
    changed["velocity"][: len(hard), 2, 1] = hard
    strange = replace(run, **changed)
    path = tmp_path / f"run{suffix}"
    strange.save(path)
    assert record.load(path).digest() == strange.digest()


@pytest.mark.parametrize("block", [1, 7, 31, 1000])
def test_blocks_do_not_show(
    run: t2.Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, block: int
) -> None:
    from tamias2d.record.rerun import exact

    monkeypatch.setattr(exact, "BLOCK", block * 200)  # some 200 bytes a sample
    run.save(tmp_path / "run.rrd")
    assert record.load(tmp_path / "run.rrd").digest() == run.digest()


def test_samples_closer_than_the_clock_of_the_viewer(tmp_path: Path) -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(t2.Disc(radius=1e-9), mass=1.0, position=(0.0, 0.0), velocity=(1.0, 0.0))
    run = t2.simulate(scene, duration=1e-8, times=np.linspace(0.0, 1e-8, 101))
    run.save(tmp_path / "run.rrd")
    assert record.load(tmp_path / "run.rrd").digest() == run.digest()


def test_a_run_beyond_the_clock_of_the_viewer_is_refused(tmp_path: Path) -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(0.0, 0.0))
    run = t2.simulate(scene, duration=1e10, times=[0.0, 1e10])
    with pytest.raises(t2.RecordingError, match=r"beyond the viewer's clock.*\.npz"):
        run.save(tmp_path / "run.rrd")
    run.save(tmp_path / "run.npz")


def test_equal_runs_make_equal_files(run: t2.Run, tmp_path: Path) -> None:
    paths = [tmp_path / name for name in ("a.npz", "b.npz")]
    for path in paths:
        run.save(path)
    assert paths[0].read_bytes() == paths[1].read_bytes()
