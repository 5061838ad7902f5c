"""What is of a wrong kind is refused in one line that says what to do, wherever it is given."""

from pathlib import Path
from typing import Any

import pytest

import tamias2d as t2


def run() -> t2.Run:
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=(0.0, 0.0))
    return t2.simulate(scene, duration=0.1)


def simulator() -> t2.Simulator:
    return t2.Simulator(t2.Scene(gravity=(0.0, 0.0)), compiled=False)


@pytest.mark.parametrize("path", [None, 5, [], b"run.npz"], ids=str)
@pytest.mark.parametrize(
    "use",
    [
        lambda path: run().save(path),
        lambda path: run().plot(path),
        lambda path: t2.Run.load(path),
        lambda path: simulator().save(path),
        lambda path: t2.Simulator.restore(path),
    ],
    ids=["save", "plot", "load", "sim.save", "restore"],
)
def test_what_is_no_path(use: Any, path: Any) -> None:
    with pytest.raises(t2.InputError, match=r"^path: found .*: must be a text or a Path \(R5\)\."):
        use(path)


@pytest.mark.parametrize("value", ["1e-6", None, True, 1j, float("nan")], ids=str)
def test_what_is_no_tolerance_of_a_method(value: Any) -> None:
    for method in (t2.Dop853, t2.DormandPrince5):
        with pytest.raises(t2.InputError, match=r"^rtol .* of .*: must lie from 1e-14"):
            method(rtol=value)
        if value is not None:
            with pytest.raises(t2.InputError, match=r"^atol .* m of .*: must be > 0"):
                method(atol=value)
    with pytest.raises(t2.InputError, match=r"^rtol .* of Reference: must lie from 1e-13"):
        t2.Reference(rtol=value)


def test_a_recording_is_no_scene(tmp_path: Path) -> None:
    run().save(tmp_path / "run.npz")
    with pytest.raises(t2.SceneError, match=r"run.npz: suffix '.npz': a scene .*Run\.load\(path\)"):
        t2.load(tmp_path / "run.npz")


def test_what_is_no_ensemble() -> None:
    wrong: Any = 5
    with pytest.raises(t2.RecordingError, match=r"^dataset: its attributes are not those"):
        t2.world_scene(wrong, 0)


def test_one_component_is_no_vector() -> None:
    wrong: Any = (1.0,)
    with pytest.raises(t2.InputError, match=r"found 1 component in \(1\.0,\)"):
        t2.Scene(gravity=wrong)
