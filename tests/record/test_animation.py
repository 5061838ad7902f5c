"""The animation shows where the bodies are, at the pace of the run."""

from pathlib import Path

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.record.drawing import PALETTE, titled

pytest.importorskip("matplotlib")


def frames(path: Path) -> list[np.ndarray]:
    from PIL import Image, ImageSequence

    with Image.open(path) as image:
        return [np.asarray(f.convert("RGB")).astype(int) for f in ImageSequence.Iterator(image)]


def row_of(picture: np.ndarray, index: int) -> float:
    """Return the mean row of the pixels that have the colour of a moving body."""
    alike = np.abs(picture - PALETTE[index]).max(axis=-1) < 40
    assert alike.sum() > 20
    return float(alike.nonzero()[0].mean())


def test_a_stone_falls_from_picture_to_picture(tmp_path: Path) -> None:
    """Rows go with the square of the time: a quarter of the way at half of it."""
    scene = t2.Scene(gravity=(0.0, -2.0))
    scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=(0.0, 0.0))
    path = tmp_path / "fall.gif"
    t2.simulate(scene, duration=1.0).plot(path)
    shown = frames(path)
    assert len(shown) == 26  # one each 0.04 s, both ends included
    first, half, last = (row_of(shown[k], 0) for k in (0, 12, 25))
    assert (half - first) / (last - first) == pytest.approx(0.48**2, abs=0.02)  # 2 of 300 pixels
    assert list(tmp_path.iterdir()) == [path]


def test_it_goes_at_the_pace_of_the_run_and_for_ever(tmp_path: Path) -> None:
    from PIL import Image

    t2.simulate(t2.catalogue.load("pendulum"), duration=0.5).plot(tmp_path / "swing.gif")
    with Image.open(tmp_path / "swing.gif") as image:
        assert (image.info["duration"], image.info["loop"]) == (40, 0)


@pytest.mark.parametrize("scene", ["hill", "slider-crank", "oscillator"])
def test_ground_joints_springs_and_particles(tmp_path: Path, scene: str) -> None:
    t2.simulate(t2.catalogue.load(scene), duration=0.1).plot(tmp_path / "scene.gif")
    assert frames(tmp_path / "scene.gif")[-1].std() > 5


def test_one_sample_is_one_picture(tmp_path: Path) -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(5.0, 5.0))
    t2.simulate(scene, duration=1.0, times=[0.0]).plot(tmp_path / "one.gif")
    assert len(frames(tmp_path / "one.gif")) == 1


def test_a_run_that_was_saved_is_read_back(tmp_path: Path) -> None:
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=(0.0, 0.0))
    run = t2.simulate(scene, duration=1.0)
    run.save(tmp_path / "fall.npz")
    again = t2.Run.load(tmp_path / "fall.npz")
    assert isinstance(again, t2.Run)
    assert again.digest() == run.digest()


def test_a_scene_without_a_name_has_pictures_without_one() -> None:
    scene = t2.Scene(gravity=(0.0, -2.0))
    scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=(0.0, 0.0))
    assert titled(t2.simulate(scene, duration=1.0), "1 s") == "1 s"
    assert (
        titled(t2.simulate(t2.catalogue.load("pendulum"), duration=0.1), "1 s") == "pendulum: 1 s"
    )
